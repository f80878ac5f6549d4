#include "displayfile/looks/style.h"

#include "clip/base/words.h"

namespace displayfile {

namespace {

using Alignment = TextStyle::Alignment;
constexpr Word<Alignment> kAlignments[] = {
    {Alignment::left, "left"}, {Alignment::centre, "centre"}, {Alignment::right, "right"}};

constexpr Word<Shading> kShadings[] = {
    {Shading::flat, "flat"}, {Shading::gouraud, "gouraud"}, {Shading::phong, "phong"}};

}  // namespace

TextStyle::Alignment alignment(std::string_view text) {
  return value_of(kAlignments, text, "expected");
}
std::string_view name_of(TextStyle::Alignment alignment) { return word_of(kAlignments, alignment); }

Shading shading(std::string_view text) { return value_of(kShadings, text, "shading is"); }
std::string_view name_of(Shading shading) { return word_of(kShadings, shading); }

}  // namespace displayfile
