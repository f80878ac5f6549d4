#include "displayfile/solids/cut_faces.h"

#include "clip/words.h"

namespace displayfile {

namespace {

constexpr Word<CutFaces::Kind> kKinds[] = {{CutFaces::Kind::open, "open"},
                                           {CutFaces::Kind::closed, "closed"},
                                           {CutFaces::Kind::hatched, "hatched"}};

}  // namespace

CutFaces::Kind cut_faces_kind(std::string_view text) {
  return value_of(kKinds, text, "cut faces are");
}
std::string_view name_of(CutFaces::Kind kind) { return word_of(kKinds, kind); }

}  // namespace displayfile
