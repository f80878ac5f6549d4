#include "displayfile/solids/solid_operation.h"

#include "clip/words.h"

namespace displayfile {

namespace {

constexpr Word<SolidOperation> kOperations[] = {{SolidOperation::unite, "union"},
                                                {SolidOperation::intersect, "intersection"},
                                                {SolidOperation::difference, "difference"}};

}  // namespace

SolidOperation solid_operation(std::string_view text) {
  return value_of(kOperations, text, "what is made of solids is");
}
std::string_view name_of(SolidOperation operation) { return word_of(kOperations, operation); }

}  // namespace displayfile
