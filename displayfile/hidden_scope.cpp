#include "displayfile/hidden_scope.h"

#include "clip/words.h"

namespace displayfile {

namespace {

constexpr Word<HiddenScope> kScopes[] = {{HiddenScope::segment, "segment"},
                                         {HiddenScope::all, "all"}};

}  // namespace

HiddenScope hidden_scope(std::string_view text) {
  return value_of(kScopes, text, "the scope of hidden surfaces is");
}
std::string_view name_of(HiddenScope scope) { return word_of(kScopes, scope); }

}  // namespace displayfile
