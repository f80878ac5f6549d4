#pragma once

#include <cstddef>
#include <type_traits>

#include "displayfile/graphics_system.h"
#include "displayfile/text/routine.h"

/// Calls of user routines that do not simply pass their arguments to the application API. Each
/// throws ErrorAt for invalid arguments, and what the API throws.
namespace displayfile::routine_calls {

void fill_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void line_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void line_kind_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void lower_line_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void vertex_colours(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void background(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void light(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void text_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void lines(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void axes(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void surface(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void cone(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void sphere(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void extrude(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void turn(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void cutting_plane(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void cut_faces(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void leader(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void balloon(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void linear_dimension(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void aligned_dimension(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void angle_dimension(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void title(GraphicsSystem& system, ProgramLine& line, const Routine& routine);
void parts_list(GraphicsSystem& system, ProgramLine& line, const Routine& routine);

/// A hidden-surface setting.
template <auto member>
void setting(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  HiddenSurfaceOptions options;
  auto& value = options.*member;
  value = line.take<typename std::decay_t<decltype(value)>::value_type>();
  system.set_hidden_surfaces(options);
}

/// Parts of the style of annotation.
template <auto... members>
void annotation_style(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  AnnotationStyle style = system.looks().annotation;
  ((style.*members = line.take<std::decay_t<decltype(style.*members)>>()), ...);
  system.set_annotation_style(style);
}

/// Any number of points.
template <class Point, void (GraphicsSystem::*routine)(PointList<Point>)>
void points(GraphicsSystem& system, ProgramLine& line, const Routine& entry) {
  if (line.arguments() % static_cast<std::size_t>(Point::length()) != 0) wrong_count(line, entry);
  (system.*routine)(line.take_points<Point>());
}

// The three below, the setting, the style of annotation, and sphere read the number of words in the
// table, in its order.

/// The least and the greatest coordinate of each axis.
template <auto shape>
void of_corners(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  Point3 low, high;
  for (int a = 0; a < 3; ++a) {
    low[a] = line.take<double>();
    high[a] = line.take<double>();
  }
  shape(system, low, high);
}

/// Two points of a circle.
template <class Dimension>
void of_circle(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  const auto first = line.take<Point3>();
  system.annotate(Dimension{first, line.take<Point3>()});
}

/// A position, two lengths and a number of facets.
template <auto shape>
void of_lengths(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  const auto place = line.take<Point3>();
  const auto first = line.take<double>(), second = line.take<double>();
  shape(system, place, first, second, line.take<int>());
}

}  // namespace displayfile::routine_calls
