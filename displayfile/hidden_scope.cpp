#include "displayfile/hidden_scope.h"

#include <string>

#include "clip/error.h"

namespace displayfile {

HiddenScope hidden_scope(std::string_view text) {
  if (text == "segment") return HiddenScope::segment;
  if (text == "all") return HiddenScope::all;
  throw Error("the scope of hidden surfaces is segment or all, not '" + std::string(text) + "'");
}

std::string_view name_of(HiddenScope scope) {
  return scope == HiddenScope::all ? "all" : "segment";
}

}  // namespace displayfile
