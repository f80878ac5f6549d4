#include "displayfile/looks/text_style.h"

#include "clip/words.h"

namespace displayfile {

namespace {

using Alignment = TextStyle::Alignment;
constexpr Word<Alignment> kAlignments[] = {
    {Alignment::left, "left"}, {Alignment::centre, "centre"}, {Alignment::right, "right"}};

}  // namespace

TextStyle::Alignment alignment(std::string_view text) {
  return value_of(kAlignments, text, "expected");
}
std::string_view name_of(TextStyle::Alignment alignment) { return word_of(kAlignments, alignment); }

}  // namespace displayfile
