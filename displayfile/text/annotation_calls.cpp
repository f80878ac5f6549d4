// Calls of the routines that enter annotation.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "clip/base/words.h"
#include "displayfile/graphics_system.h"
#include "displayfile/text/routine_calls.h"

namespace displayfile::routine_calls {

namespace {

/// Takes the two optional numbers at the end.
std::optional<Point2> take_offset(ProgramLine& line, bool has_offset) {
  if (!has_offset) return std::nullopt;
  return line.take<Point2>();
}

}  // namespace

/// x y z "text" [right up]
void leader(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() != 4 && line.arguments() != 6) wrong_count(line, routine);
  Leader leader{line.take<Point3>(), std::string(line.take<std::string_view>())};
  leader.offset = take_offset(line, line.arguments() == 6);
  system.annotate(leader);
}

/// x y z number ["name" [right up]]
void balloon(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  if (count != 4 && count != 5 && count != 7) wrong_count(line, routine);
  const auto at = line.take<Point3>();
  Balloon balloon{at, line.take<int>()};
  if (count > 4) balloon.name = line.take<std::string_view>();
  balloon.offset = take_offset(line, count == 7);
  system.annotate(balloon);
}

void linear_dimension(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  const auto axis = understood(line.take_word(), dimension_axis);
  const auto from = line.take<Point3>(), to = line.take<Point3>();
  system.annotate(LinearDimension{axis, from, to, line.take<Point3>()});
}

void aligned_dimension(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  const auto from = line.take<Point3>(), to = line.take<Point3>();
  system.annotate(AlignedDimension{from, to, line.take<Point3>()});
}

void angle_dimension(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  const auto vertex = line.take<Point3>(), from = line.take<Point3>(), to = line.take<Point3>();
  system.annotate(AngleDimension{vertex, from, to, line.take<double>()});
}

void title(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  system.annotate(Title{std::string(line.take<std::string_view>())});
}

void parts_list(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() > 1) wrong_count(line, routine);
  PartsList list;
  if (line.arguments() == 1) list.corner = understood(line.take_word(), list_corner);
  system.annotate(list);
}

}  // namespace displayfile::routine_calls
