#include "displayfile/text/argument_words.h"

#include <cstddef>
#include <string_view>

#include "clip/base/words.h"

namespace displayfile {

namespace {

constexpr Word<bool> kSwitches[] = {{true, "on"}, {false, "off"}};
constexpr Word<FillStyle::Kind> kFillKinds[] = {{FillStyle::Kind::solid, "solid"},
                                                {FillStyle::Kind::hollow, "hollow"}};
constexpr Word<LineStyle::Kind> kLineKinds[] = {{LineStyle::Kind::solid, "solid"},
                                                {LineStyle::Kind::dashed, "dashed"},
                                                {LineStyle::Kind::none, "none"}};

template <class Value, std::size_t N>
Value one_of(const Word<Value> (&known)[N], std::string_view word) {
  return understood(word, [&](std::string_view w) { return value_of(known, w, "expected"); });
}

}  // namespace

template <>
bool ProgramLine::take<bool>() {
  return one_of(kSwitches, take_word());
}

template <>
FillStyle::Kind ProgramLine::take<FillStyle::Kind>() {
  return one_of(kFillKinds, take_word());
}

template <>
LineStyle::Kind ProgramLine::take<LineStyle::Kind>() {
  return one_of(kLineKinds, take_word());
}

template <>
HiddenMethod ProgramLine::take<HiddenMethod>() {
  return understood(take_word(), hidden_method);
}

template <>
HiddenScope ProgramLine::take<HiddenScope>() {
  return understood(take_word(), hidden_scope);
}

template <>
HiddenLines ProgramLine::take<HiddenLines>() {
  return understood(take_word(), hidden_lines);
}

template <>
LineOrder ProgramLine::take<LineOrder>() {
  return understood(take_word(), line_order);
}

template <>
Shading ProgramLine::take<Shading>() {
  return understood(take_word(), shading);
}

template <>
SurfaceCurves ProgramLine::take<SurfaceCurves>() {
  return understood(take_word(), surface_curves);
}

template <>
SurfaceSides ProgramLine::take<SurfaceSides>() {
  return understood(take_word(), surface_sides);
}

template <>
SolidOperation ProgramLine::take<SolidOperation>() {
  return understood(take_word(), solid_operation);
}

template <>
WindowFit ProgramLine::take<WindowFit>() {
  return understood(take_word(), window_fit);
}

template <>
Precision ProgramLine::take<Precision>() {
  return understood(take_word(), precision);
}

template <>
Touching ProgramLine::take<Touching>() {
  return understood(take_word(), touching);
}

template <>
TextStyle::Alignment ProgramLine::take<TextStyle::Alignment>() {
  return understood(take_word(), alignment);
}

template <>
AnnotationStyle::Unit ProgramLine::take<AnnotationStyle::Unit>() {
  return understood(take_word(), annotation_unit);
}

template <>
AnnotationStyle::Ends ProgramLine::take<AnnotationStyle::Ends>() {
  return understood(take_word(), annotation_ends);
}

template <>
AnnotationStyle::Placement ProgramLine::take<AnnotationStyle::Placement>() {
  return understood(take_word(), annotation_placement);
}

}  // namespace displayfile
