#pragma once

#include "displayfile/graphics_system.h"
#include "displayfile/text/program_line.h"

namespace displayfile {

// One-word arguments other than the numbers, points and texts of program_line.h.

template <>
bool ProgramLine::take<bool>();
template <>
FillStyle::Kind ProgramLine::take<FillStyle::Kind>();
template <>
LineStyle::Kind ProgramLine::take<LineStyle::Kind>();
template <>
HiddenMethod ProgramLine::take<HiddenMethod>();
template <>
HiddenScope ProgramLine::take<HiddenScope>();
template <>
HiddenLines ProgramLine::take<HiddenLines>();
template <>
LineOrder ProgramLine::take<LineOrder>();
template <>
Shading ProgramLine::take<Shading>();
template <>
SurfaceCurves ProgramLine::take<SurfaceCurves>();
template <>
SurfaceSides ProgramLine::take<SurfaceSides>();
template <>
SolidOperation ProgramLine::take<SolidOperation>();
template <>
WindowFit ProgramLine::take<WindowFit>();
template <>
Precision ProgramLine::take<Precision>();
template <>
Touching ProgramLine::take<Touching>();
template <>
TextStyle::Alignment ProgramLine::take<TextStyle::Alignment>();
template <>
AnnotationStyle::Unit ProgramLine::take<AnnotationStyle::Unit>();
template <>
AnnotationStyle::Ends ProgramLine::take<AnnotationStyle::Ends>();
template <>
AnnotationStyle::Placement ProgramLine::take<AnnotationStyle::Placement>();

}  // namespace displayfile
