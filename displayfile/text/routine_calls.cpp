#include "displayfile/text/routine_calls.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/words.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/colour_words.h"

namespace displayfile::routine_calls {

namespace {

constexpr std::size_t kNumbers = 3;  // of a colour

/// The number of words of the colour that begins with the argument: one, or three numbers.
std::size_t words_of_colour(ProgramLine& line, std::size_t argument) {
  line.expect_colour();
  if (argument >= line.arguments()) return kNumbers;
  const std::string_view word = line.argument(argument);
  const bool is_name = (word[0] >= 'a' && word[0] <= 'z') || (word[0] >= 'A' && word[0] <= 'Z');
  const bool has_three = line.arguments() - argument >= kNumbers;
  return colour_of_word(word) || (is_name && !has_three) ? 1 : kNumbers;
}

/// `besides`: other expected words, for the message about an unknown name.
Colour take_colour(ProgramLine& line, std::size_t words, std::string_view besides = "") {
  if (words == kNumbers) return line.take<Point3>();
  const std::string_view word = line.take_word();
  if (const auto colour = colour_of_word(word)) return *colour;
  throw ErrorAt(
      word.data(),
      fmt::format("unknown colour {}:{} expected r g b, each 0 to 1, #rrggbb, a CSS name{}",
                  quoted(word), nearest_colour_name(word), besides));
}

}  // namespace

void fill_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() == 0) wrong_count(line, routine);
  const auto kind = line.take<FillStyle::Kind>();
  if (kind != FillStyle::Kind::solid) {
    if (line.arguments() != 1) wrong_count(line, routine);
    return system.set_fill_style({kind});
  }
  const std::size_t of_colour = words_of_colour(line, 1);
  if (line.arguments() != 1 + of_colour) wrong_count(line, routine);
  system.set_fill_style({kind, take_colour(line, of_colour)});
}

namespace {

LineStyle take_line_style(ProgramLine& line, const Routine& routine) {
  if (line.arguments() == 0) wrong_count(line, routine);
  const auto kind = line.take<LineStyle::Kind>();
  if (kind == LineStyle::Kind::none) {
    if (line.arguments() != 1) wrong_count(line, routine);
    return {kind};
  }
  const bool dashed = kind == LineStyle::Kind::dashed;
  const std::size_t of_colour = words_of_colour(line, 1);
  const std::size_t before = 1 + of_colour;
  const std::size_t behind = line.arguments() < before ? 0 : line.arguments() - before;
  const bool fits = behind <= 1 || (dashed && behind == 3);
  if (line.arguments() < before || !fits) wrong_count(line, routine);
  LineStyle style{kind, take_colour(line, of_colour)};
  if (behind >= 1) style.width = line.take<double>();
  if (behind == 3) {
    style.dash = line.take<double>();
    style.gap = line.take<double>();
  }
  return style;
}

}  // namespace

void line_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  system.set_line_style(take_line_style(line, routine));
}

/// KIND width|same [solid | dashed [dash gap]] [r g b]
void line_kind_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  if (count < 2) wrong_count(line, routine);
  const StyledLines lines = understood(line.take_word(), styled_lines);
  LineKindStyle style;
  std::size_t used = 2;
  if (line.argument(1) == "same") {
    line.take_word();
  } else {
    style.width = line.take<double>();
  }
  const auto is = [&](std::string_view word) {
    return used < count && line.argument(used) == word;
  };
  if (is("solid") || is("dashed")) {
    style.kind = line.take<LineStyle::Kind>();
    ++used;
  }
  const std::size_t numbers = count - used;
  const bool has_dashes = numbers == 2 || numbers == 5;
  if ((numbers != 0 && numbers != 3 && !has_dashes) ||
      (has_dashes && style.kind != LineStyle::Kind::dashed)) {
    wrong_count(line, routine);
  }
  if (has_dashes) {
    style.dash = line.take<double>();
    style.gap = line.take<double>();
  }
  if (numbers >= 3) style.colour = line.take<Point3>();
  system.set_line_kind_style(lines, style);
}

void lower_line_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() == 1 && line.argument(0) == "same") {
    line.take_word();
    return system.set_lower_line_style(std::nullopt);
  }
  system.set_lower_line_style(take_line_style(line, routine));
}

void background(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  const std::size_t of_colour = words_of_colour(line, 0);
  if (line.arguments() != of_colour) wrong_count(line, routine);
  if (line.argument(0) == "none" || line.argument(0) == "transparent") {
    return system.set_background({Background::Kind::none});
  }
  system.set_background({Background::Kind::solid, take_colour(line, of_colour, " or none")});
}

/// [r g b]... or words
void vertex_colours(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  std::vector<Colour> colours;
  line.expect_colour();
  for (std::size_t used = 0; used < line.arguments();) {
    const std::size_t words = words_of_colour(line, used);
    used += words;
    if (used > line.arguments()) wrong_count(line, routine);
    colours.push_back(take_colour(line, words));
    line.expect_colour();
  }
  system.set_vertex_colours(colours);
}

void light(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() != 3 && line.arguments() != 4) wrong_count(line, routine);
  const auto toward = line.take<Point3>();
  if (line.arguments() == 3) return system.set_light(toward);
  system.set_light(toward, line.take<double>());
}

void text_style(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  if (count < 1 || count > 3) wrong_count(line, routine);
  TextStyle style;
  style.size = line.take<double>();
  style.always = count > 1 && line.argument(count - 1) == "always";
  const std::size_t others = count - (style.always ? 2 : 1);
  if (others > 0) style.alignment = line.take<TextStyle::Alignment>();
  if (others > 1) {
    const std::string_view word = line.argument(2);
    throw ErrorAt(word.data(), "expected always, or nothing, not " + quoted(word));
  }
  system.set_text_style(style);
}

void lines(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() == 0) wrong_count(line, routine);
  LineSelection selection{.kinds = 0};
  for (std::size_t i = 0; i < line.arguments(); ++i) {
    understood(line.argument(i), [&](std::string_view word) { add_line_kind(word, selection); });
  }
  system.set_hidden_surfaces({.lines = selection});
}

void axes(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  const std::size_t count = line.arguments();
  if (count != 6 && count != 9) wrong_count(line, routine);
  Point3 low, high;
  for (int a = 0; a < 3; ++a) {
    low[a] = line.take<double>();
    high[a] = line.take<double>();
  }
  std::array<std::string, 3> names{"x", "y", "z"};
  if (count == 9) {
    for (std::string& name : names) name = line.take<std::string_view>();
  }
  axes_3(system, low, high, {names[0], names[1], names[2]});
}

/// An unknown height is written nan.
void surface(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  constexpr std::size_t kBefore = 6;  // arguments before the heights
  if (line.arguments() < kBefore) wrong_count(line, routine);
  SurfaceGrid grid{};
  const auto take_range = [&](double& low, double& high, int& points) {
    low = line.take<double>();
    high = line.take<double>();
    points = line.take<int>();
  };
  take_range(grid.x_min, grid.x_max, grid.x_points);
  take_range(grid.y_min, grid.y_max, grid.y_points);
  std::vector<double> heights(line.arguments() - kBefore);
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (line.argument(kBefore + k) == "nan") {
      line.take_word();
      heights[k] = std::numeric_limits<double>::quiet_NaN();
    } else {
      heights[k] = line.take<double>();
    }
  }
  grid.heights = heights;
  system.surface_3(grid);
}

void cone(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() != 6 && line.arguments() != 7) wrong_count(line, routine);
  const auto base = line.take<Point3>();
  const auto radius = line.take<double>(), height = line.take<double>();
  const int facets = line.take<int>();
  const double top_radius = line.arguments() == 7 ? line.take<double>() : 0.0;
  cone_3(system, base, radius, height, facets, top_radius);
}

void sphere(GraphicsSystem& system, ProgramLine& line, const Routine&) {
  const auto centre = line.take<Point3>();
  const auto radius = line.take<double>();
  sphere_3(system, centre, radius, line.take<int>());
}

namespace {

std::vector<Point2> take_profile(ProgramLine& line, std::size_t before) {
  std::vector<Point2> profile;
  for (std::size_t k = before; k < line.arguments(); k += 2) {
    const auto x = line.take<double>();
    profile.emplace_back(x, line.take<double>());
  }
  return profile;
}

}  // namespace

void extrude(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() < 2 || line.arguments() % 2 != 0) wrong_count(line, routine);
  const auto z_min = line.take<double>(), z_max = line.take<double>();
  extrude_3(system, z_min, z_max, take_profile(line, 2));
}

void turn(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() % 2 != 1) wrong_count(line, routine);
  const int facets = line.take<int>();
  turn_3(system, facets, take_profile(line, 1));
}

void cutting_plane(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() != 2 && line.arguments() != 5) wrong_count(line, routine);
  const int n = line.take<int>();
  if (line.arguments() == 2) {
    if (const std::string_view word = line.take_word(); word != "off") {
      throw ErrorAt(word.data(), "expected off, or four numbers: a b c d, not " + quoted(word));
    }
    return system.set_cutting_plane_off(n);
  }
  const auto normal = line.take<Point3>();
  system.set_cutting_plane(n, normal.x, normal.y, normal.z, line.take<double>());
}

void cut_faces(GraphicsSystem& system, ProgramLine& line, const Routine& routine) {
  if (line.arguments() == 0) wrong_count(line, routine);
  CutFaces faces;
  faces.kind = understood(line.take_word(), cut_faces_kind);
  const std::size_t most = faces.kind == CutFaces::Kind::hatched ? 3 : 1;
  if (line.arguments() > most) wrong_count(line, routine);
  if (line.arguments() > 1 && line.argument(1) == kUsualSpacing) {
    line.take_word();
  } else if (line.arguments() > 1) {
    faces.spacing = line.take<double>();
  }
  if (line.arguments() > 2) faces.angle = line.take<double>();
  system.set_cut_faces(faces);
}

}  // namespace displayfile::routine_calls
