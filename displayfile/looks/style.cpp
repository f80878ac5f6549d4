#include "displayfile/looks/style.h"

#include "clip/base/error.h"
#include "clip/base/words.h"

namespace displayfile {

namespace {

using Alignment = TextStyle::Alignment;
constexpr Word<Alignment> kAlignments[] = {
    {Alignment::left, "left"}, {Alignment::centre, "centre"}, {Alignment::right, "right"}};

constexpr Word<Shading> kShadings[] = {
    {Shading::flat, "flat"}, {Shading::gouraud, "gouraud"}, {Shading::phong, "phong"}};

constexpr Word<AnnotationStyle::Unit> kUnits[] = {{AnnotationStyle::Unit::millimetres, "mm"},
                                                  {AnnotationStyle::Unit::pixels, "px"}};
constexpr Word<AnnotationStyle::Ends> kEnds[] = {{AnnotationStyle::Ends::arrow, "arrow"},
                                                 {AnnotationStyle::Ends::dot, "dot"}};
constexpr Word<AnnotationStyle::Placement> kPlacements[] = {
    {AnnotationStyle::Placement::entered, "entered"},
    {AnnotationStyle::Placement::automatic, "auto"}};
constexpr Word<LinearDimension::Axis> kAxes[] = {{LinearDimension::Axis::x, "x"},
                                                 {LinearDimension::Axis::y, "y"},
                                                 {LinearDimension::Axis::z, "z"}};
constexpr Word<PartsList::Corner> kCorners[] = {{PartsList::Corner::top_left, "top-left"},
                                                {PartsList::Corner::top_right, "top-right"},
                                                {PartsList::Corner::bottom_left, "bottom-left"},
                                                {PartsList::Corner::bottom_right, "bottom-right"}};

}  // namespace

TextStyle::Alignment alignment(std::string_view text) {
  return value_of(kAlignments, text, "expected");
}
std::string_view name_of(TextStyle::Alignment alignment) { return word_of(kAlignments, alignment); }

Shading shading(std::string_view text) { return value_of(kShadings, text, "shading is"); }
std::string_view name_of(Shading shading) { return word_of(kShadings, shading); }

AnnotationStyle::Unit annotation_unit(std::string_view text) {
  return value_of(kUnits, text, "expected");
}
AnnotationStyle::Ends annotation_ends(std::string_view text) {
  return value_of(kEnds, text, "expected");
}
AnnotationStyle::Placement annotation_placement(std::string_view text) {
  return value_of(kPlacements, text, "expected");
}
LinearDimension::Axis dimension_axis(std::string_view text) {
  return value_of(kAxes, text, "expected");
}
PartsList::Corner list_corner(std::string_view text) {
  return value_of(kCorners, text, "expected");
}
std::string_view name_of(AnnotationStyle::Unit unit) { return word_of(kUnits, unit); }
std::string_view name_of(AnnotationStyle::Ends ends) { return word_of(kEnds, ends); }
std::string_view name_of(AnnotationStyle::Placement placement) {
  return word_of(kPlacements, placement);
}
std::string_view name_of(LinearDimension::Axis axis) { return word_of(kAxes, axis); }
std::string_view name_of(PartsList::Corner corner) { return word_of(kCorners, corner); }

void require_colour_of_fills(HiddenMethod method, const Background& background) {
  if (!is_colour_rule(method) || background.kind != Background::Kind::none) return;
  throw Error(
      "the colour rule fills with the background's colour, and there is no background: expected "
      "one, or a picture of pixels, which can omit hidden parts");
}

}  // namespace displayfile
