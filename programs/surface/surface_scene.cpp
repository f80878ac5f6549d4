#include "programs/surface/surface_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/height_colours.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/user_routines/axes.h"
#include "programs/surface/contours.h"

namespace displayfile {

namespace {

constexpr double kLetterHeight = 0.026;  // of the picture's height, where that is not narrow
const LineStyle kAxisStyle{LineStyle::Kind::solid, {0.15, 0.15, 0.15}, 1.0};
const LineStyle kBoxStyle{LineStyle::Kind::solid, {0.6, 0.6, 0.6}, 0.75};
const LineStyle kContourStyle{LineStyle::Kind::solid, {0.35, 0.35, 0.45}, 0.75};

/// A style with the width that all lines have, if one is set.
LineStyle with_width(LineStyle style, const SurfaceLook& look) {
  if (look.line_width > 0.0) style.width = look.line_width;
  return style;
}

/// The bounds of the surfaces.
struct SurfaceBox {
  Point3 low{std::numeric_limits<double>::infinity()};
  Point3 high{-std::numeric_limits<double>::infinity()};
};

SurfaceBox box_of_surfaces(std::span<const SurfaceData> surfaces, const SurfaceLook& look) {
  SurfaceBox box;
  for (const SurfaceData& surface : surfaces) {
    const GridRange& range = surface.range;
    box.low.x = std::min(box.low.x, range.x_min);
    box.high.x = std::max(box.high.x, range.x_max);
    box.low.y = std::min(box.low.y, range.y_min);
    box.high.y = std::max(box.high.y, range.y_max);
    for (const double z : surface.heights) {
      if (std::isnan(z)) continue;
      box.low.z = std::min(box.low.z, z);
      box.high.z = std::max(box.high.z, z);
    }
  }
  if (look.contours > 0 && !look.heights) box.low.z -= 0.6 * (box.high.z - box.low.z);
  if (look.heights) {
    box.low.z = std::min(box.low.z, (*look.heights)[0]);
    box.high.z = std::max(box.high.z, (*look.heights)[1]);
  }
  if (box.low.z == box.high.z) {  // a flat surface has room above and below it
    const double room = std::max(0.5, 0.5 * std::abs(box.low.z));
    box.low.z -= room;
    box.high.z += room;
  }
  return box;
}

/// Scales the box for display: two wide, and about as high as wide over the golden section.
void set_box_proportions(GraphicsSystem& system, const SurfaceBox& box, bool true_scale) {
  const Point3 middle = 0.5 * box.low + 0.5 * box.high, size = box.high - box.low;
  system.translate_3(-middle.x, -middle.y, -middle.z);
  if (true_scale) {
    const double scale = 2.0 / std::max(size.x, size.y);
    return system.scale_3(scale, scale, scale);
  }
  constexpr double kHeight = 1.24;
  system.scale_3(2.0 / size.x, 2.0 / size.y, kHeight / size.z);
}

Point3 corner_of_box(const SurfaceBox& box, unsigned number) {
  return {(number & 1u) != 0 ? box.high.x : box.low.x, (number & 2u) != 0 ? box.high.y : box.low.y,
          (number & 4u) != 0 ? box.high.z : box.low.z};
}

/// The colours of heights, and the texts beside them.
struct Legend {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::string name;

  Legend(std::span<const SurfaceData> surfaces, std::string of_heights)
      : name(std::move(of_heights)) {
    for (const SurfaceData& surface : surfaces) {
      for (const double z : surface.heights) {
        if (std::isnan(z)) continue;
        low = std::min(low, z);
        high = std::max(high, z);
      }
    }
  }
  bool is_flat() const { return !(low < high); }
  double part(double height) const { return is_flat() ? 0.5 : (height - low) / (high - low); }
  std::vector<double> heights() const {
    constexpr int kMostSteps = 8;
    return is_flat() ? std::vector{low} : axis_ticks(low, high, kMostSteps);
  }
};

// Where it stands, in parts of the picture's height: between the picture's right side and the bar
// there is room for numbers of six letters.
constexpr double kLegendRoom = 0.24, kBarLeft = 0.14, kBarRight = 0.115, kNumbers = 0.014;
constexpr double kLetterWidth = 0.64 * kLetterHeight;  // about: fonts differ
constexpr double kMostForTexts = 0.4;

/// The room that the texts need beyond that; it may be negative where letters have a set height,
/// which leave no room to spare.
double room_for_texts(const Legend& legend, const SurfaceLook& look) {
  const auto width = [](std::string_view text) {
    const auto letters = std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    return kLetterWidth * static_cast<double>(letters);
  };
  constexpr double kEdge = 0.01;
  double room = width(legend.name) + kEdge - kBarLeft;
  for (const double height : legend.heights()) {
    room = std::max(room, width(axis_number(height)) + kEdge - (kBarRight - kNumbers));
  }
  return std::clamp(room, look.letter_height ? kNumbers - kBarRight : 0.0, kMostForTexts);
}

/// Margins around the box, in parts of the picture's height: for numbers and names where there are
/// axes, and at the right for the legend.
struct Margins {
  double left, right, bottom, top;
  double scale;  ///< of these, of letters and of the legend: less than 1 in a narrow picture
};

/// The scale that gives letters their height; throws Error if the margins that they need leave less
/// than a fifth of the picture.
double scale_of_letters(const Margins& margins, double letter_height, double aspect) {
  constexpr double kMost = 0.8;
  const double scale = letter_height / kLetterHeight;
  const double most = kMost * std::min(aspect / (margins.left + margins.right),
                                       1.0 / (margins.bottom + margins.top));
  if (scale <= most) return scale;
  throw Error(fmt::format(
      "--text-size: letters of {:.3g} of the picture's height leave no room for the surface: "
      "expected at most {:.3g}",
      letter_height, std::floor(1000.0 * most * kLetterHeight) / 1000.0));
}

Margins margins_of(const SurfaceLook& look, const Legend& legend, double aspect) {
  constexpr double kBare = 0.03, kMostOfWidth = 2.0 / 3.0;
  Margins margins{kBare, kBare, kBare, kBare, 1.0};
  if (look.axes) margins = {0.14, 0.12, 0.09, kBare, 1.0};
  if (look.coloured) {
    constexpr double kGap = 0.03;  // the smallest, between the surface's margin and the bar
    margins.right += look.letter_height ? kBarLeft + kGap : kLegendRoom;
    margins.right += room_for_texts(legend, look);
  }
  const bool has_letters = look.axes || look.coloured;
  const double usual = std::min(1.0, kMostOfWidth * aspect / (margins.left + margins.right));
  const bool is_set = look.letter_height && has_letters;
  const double s = is_set ? scale_of_letters(margins, *look.letter_height, aspect) : usual;
  return {s * margins.left, s * margins.right, s * margins.bottom, s * margins.top, s};
}

/// The box as large as the picture has room for it between its margins, in their middle.
void set_view_of_box(GraphicsSystem& system, const SurfaceBox& box, const Margins& margins,
                     const SurfaceLook& look) {
  std::array<Point3, 8> corners;
  for (unsigned k = 0; k < 8; ++k) {
    corners[k] = system.modelling_transformation().apply(corner_of_box(box, k));
  }
  fit_view(corners, system, look.camera);
  system.set_window_fit(WindowFit::stretch);
  const Rectangle window = system.view().window;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point2 low(kInfinity), high(-kInfinity);  // of the box, in the view plane
  for (unsigned k = 0; k < 8; ++k) {
    const auto at = system.to_device(corner_of_box(box, k));
    if (!at) continue;
    const Point2 p(window.x_min + at->x * (window.x_max - window.x_min),
                   window.y_min + at->y * (window.y_max - window.y_min));
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  system.set_window_fit(WindowFit::widen);
  if (!(low.x < high.x && low.y < high.y)) return;  // the eye is within it
  const double aspect = system.aspect_ratio();
  const double high_part = 1.0 - margins.bottom - margins.top;
  const double wide_part = aspect - margins.left - margins.right;
  const double height = std::max((high.y - low.y) / high_part, (high.x - low.x) / wide_part);
  const double left = low.x - margins.left * height - 0.5 * (wide_part * height - (high.x - low.x));
  const double bottom =
      low.y - margins.bottom * height - 0.5 * (high_part * height - (high.y - low.y));
  system.set_window(left, left + aspect * height, bottom, bottom + height);
}

/// The edges that end at the corner farthest from the viewer.
void draw_box(GraphicsSystem& system, const SurfaceBox& box, const LineStyle& style) {
  unsigned farthest = 0;
  double depth = std::numeric_limits<double>::infinity();
  for (unsigned k = 0; k < 8; ++k) {
    const auto at = system.to_device(corner_of_box(box, k));
    if (!at || at->z >= depth) continue;
    depth = at->z;
    farthest = k;
  }
  system.set_line_style(style);
  const auto draw = [&](unsigned from, unsigned to) {
    const Point3 a = corner_of_box(box, from), b = corner_of_box(box, to);
    system.move_abs_3(a.x, a.y, a.z);
    system.line_abs_3(b.x, b.y, b.z);
  };
  // The frame of each of the three faces behind; an edge of two of them is drawn once.
  for (unsigned axis = 1; axis <= 4; axis *= 2) draw(farthest, farthest ^ axis);
  for (unsigned axis = 1; axis <= 4; axis *= 2) {
    for (unsigned other = 1; other <= 4; other *= 2) {
      if (other != axis) draw(farthest ^ axis, farthest ^ axis ^ other);
    }
  }
}

/// Fills of surfaces that are drawn together, light enough for curves over them.
FillStyle fill_of_surface(std::size_t surface, std::size_t surfaces) {
  static const std::array<Colour, 6> kFills{Colour{0.62, 0.76, 0.90}, Colour{0.97, 0.78, 0.55},
                                            Colour{0.68, 0.86, 0.64}, Colour{0.90, 0.68, 0.75},
                                            Colour{0.80, 0.74, 0.90}, Colour{0.93, 0.90, 0.60}};
  if (surfaces == 1) return {FillStyle::Kind::solid, {1.0, 1.0, 1.0}};
  return {FillStyle::Kind::solid, kFills[surface % kFills.size()]};
}

/// Thinner, the closer the curves are.
LineStyle curve_style(const SurfaceData& surface, const SurfaceLook& look) {
  const int most = std::max(surface.range.x_points, surface.range.y_points);
  const double width = std::clamp(40.0 / most, 0.15, 0.8);
  return with_width({LineStyle::Kind::solid, {0.1, 0.1, 0.15}, width}, look);
}

/// Each cell in the colour of its mean height.
void draw_coloured(GraphicsSystem& system, const SurfaceData& surface, double low, double high) {
  const SurfaceGrid grid = surface.grid();
  int last = -1;
  for (int j = 0; j + 1 < grid.y_points; ++j) {
    for (int i = 0; i + 1 < grid.x_points; ++i) {
      const auto at = [&](int x, int y) {
        return grid.heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.x_points) +
                            static_cast<std::size_t>(x)];
      };
      const std::array corners{at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)};
      const double mean = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
      if (std::isnan(mean)) continue;
      const double part = high > low ? (mean - low) / (high - low) : 0.5;
      const int step = std::clamp(static_cast<int>(part * kHeightColours), 0, kHeightColours - 1);
      if (step != last) {
        system.set_fill_style({FillStyle::Kind::solid, height_colour_of_step(step)});
      }
      last = step;
      system.surface_3({grid.x(i), grid.x(i + 1), 2, grid.y(j), grid.y(j + 1), 2, corners});
    }
  }
}

/// A bar of all colours at the right, with the heights beside it.
void draw_legend(GraphicsSystem& system, const Legend& legend, const SurfaceLook& look,
                 double scale) {
  system.create_transformation_3();
  system.set_view_reference_point({0, 0, 0});
  system.set_view_plane_normal({0, 0, -1});
  system.set_view_distance(0);
  system.set_view_up({0, 1, 0});
  system.set_parallel({0, 0, -1});
  system.set_front_plane_clipping(false);
  system.set_back_plane_clipping(false);
  const double aspect = system.aspect_ratio();
  system.set_window(0, aspect, 0, 1);
  system.open_segment(2);
  const double texts = room_for_texts(legend, look);
  const double left = aspect - (kBarLeft + texts) * scale;
  const double right = aspect - (kBarRight + texts) * scale;
  const double bottom = 0.25, top = 0.75, letter_height = kLetterHeight * scale;
  const auto at = [&](double part) { return bottom + part * (top - bottom); };
  system.set_line_style({LineStyle::Kind::none});
  for (int step = 0; step < kHeightColours; ++step) {
    const double from = at(static_cast<double>(step) / kHeightColours);
    const double to = at(static_cast<double>(step + 1) / kHeightColours);
    system.set_fill_style({FillStyle::Kind::solid, height_colour_of_step(step)});
    system.polygon_abs_3({{left, from, 0}, {right, from, 0}, {right, to, 0}, {left, to, 0}});
  }
  system.set_line_style(with_width(kAxisStyle, look));
  system.move_abs_3(left, bottom, 0);
  for (const Point2& p :
       {Point2{right, bottom}, Point2{right, top}, Point2{left, top}, Point2{left, bottom}}) {
    system.line_abs_3(p.x, p.y, 0);
  }
  system.set_text_style(
      {.size = letter_height, .alignment = TextStyle::Alignment::left, .always = true});
  for (const double height : legend.heights()) {
    const double part = legend.part(height);
    system.move_abs_3(right, at(part), 0);
    system.line_abs_3(right + 0.008 * scale, at(part), 0);
    system.move_abs_3(right + kNumbers * scale, at(part) - 0.35 * letter_height, 0);
    system.text(axis_number(height));
  }
  system.move_abs_3(left, top + letter_height, 0);
  system.text(legend.name);
  system.close_segment();
}

}  // namespace

void enter_surfaces(GraphicsSystem& system, std::span<const SurfaceData> surfaces,
                    const SurfaceLook& look) {
  SurfaceBox box = box_of_surfaces(surfaces, look);
  set_box_proportions(system, box, look.true_scale);
  const Legend legend(surfaces, look.names[2]);
  const double low = legend.low, high = legend.high;
  const Margins margins = margins_of(look, legend, system.aspect_ratio());
  set_view_of_box(system, box, margins, look);
  system.set_surface_curves(look.curves);
  system.set_surface_sides(look.sides);
  system.open_segment(1);
  if (look.box) draw_box(system, box, with_width(kBoxStyle, look));
  if (look.axes) {
    system.set_line_style(with_width(kAxisStyle, look));
    system.set_text_style({.size = kLetterHeight * margins.scale});
    axes_3(system, box.low, box.high, {look.names[0], look.names[1], look.names[2]});
  }
  if (look.contours > 0) {
    system.set_line_style(with_width(kContourStyle, look));
    for (const SurfaceData& surface : surfaces) {
      for (const auto& [from, to] :
           contour_lines(surface.grid(), low, high, look.contours, box.low.z)) {
        system.move_abs_3(from.x, from.y, from.z);
        system.line_abs_3(to.x, to.y, to.z);
      }
    }
  }
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    system.set_line_style(curve_style(surfaces[k], look));
    system.set_fill_style(fill_of_surface(k, surfaces.size()));
    if (look.coloured) {
      draw_coloured(system, surfaces[k], low, high);
    } else {
      system.surface_3(surfaces[k].grid());
    }
  }
  system.close_segment();
  if (look.coloured) draw_legend(system, legend, look, margins.scale);
}

}  // namespace displayfile
