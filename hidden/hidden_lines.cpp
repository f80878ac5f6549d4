#include "hidden/hidden_lines.h"

#include "clip/words.h"

namespace displayfile {

namespace {

constexpr Word<HiddenLines> kHiddenLines[] = {{HiddenLines::none, "none"},
                                              {HiddenLines::dashed, "dashed"}};

}  // namespace

HiddenLines hidden_lines(std::string_view text) {
  return value_of(kHiddenLines, text, "hidden lines are");
}
std::string_view name_of(HiddenLines lines) { return word_of(kHiddenLines, lines); }

}  // namespace displayfile
