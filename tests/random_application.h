#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "displayfile/graphics_system.h"

namespace displayfile::test {

/// An application that calls whatever routine comes to its mind, most calls sensible, some not.
class RandomApplication {
 public:
  /// Numbers by which it decides: any 64 bits each, random ones or a fuzzer's.
  RandomApplication(std::function<std::uint64_t()> numbers, GraphicsSystem& system)
      : random_(std::move(numbers)), system_(system) {}

  /// Makes one call; one that the system refuses does nothing.
  void call() {
    try {
      if (system_.open_segment_name() && chance(80)) {
        call_primitive();
      } else {
        call_any();
      }
    } catch (const Error&) {
      ++refused_;
    }
  }

  int refused() const { return refused_; }

 private:
  std::uint64_t below(std::uint64_t n) { return random_() % n; }
  bool chance(std::uint64_t percent) { return below(100) < percent; }
  // The numbers are the same in every rounding mode. Volatile values are computed while the mode is
  // set: no compiler moves them.
  double uniform(double low, double high) {
    const RoundToNearest nearest;
    const volatile double part = static_cast<double>(random_() >> 11) * 0x1p-53;
    const volatile double result = low + (high - low) * part;
    return result;
  }
  double coordinate() {
    constexpr std::array kOdd{0.0,       -0.0,   1.0,     -1.0,
                              1.0 / 3.0, 0.1,    5e-324,  1e-17,
                              1e100,     -1e100, 12345.0, 0x1p-30,
                              1e22,      -1e16,  2e100,   std::numeric_limits<double>::quiet_NaN()};
    return chance(4) ? kOdd[below(kOdd.size())] : uniform(-1.5, 1.5);
  }
  static double sum(double a, double b) {
    const RoundToNearest nearest;
    const volatile double first = a;
    const volatile double result = first + b;
    return result;
  }
  static double tenth_of(double value) {
    const RoundToNearest nearest;
    const volatile double tenth = 0.1;
    const volatile double result = tenth * value;
    return result;
  }
  static Point3 tenth_of(const Point3& p) { return {tenth_of(p.x), tenth_of(p.y), tenth_of(p.z)}; }
  Point2 point_2() { return {coordinate(), coordinate()}; }
  Point3 point_3() { return {coordinate(), coordinate(), coordinate()}; }
  template <class Point>
  std::vector<Point> points() {
    std::vector<Point> result(chance(5) ? below(3) : 3 + below(6));
    const double z = uniform(-1, 1);
    const bool flat = chance(60);
    for (Point& p : result) {
      if constexpr (Point::length() == 2) {
        p = point_2();
      } else {
        p = flat ? Point3(point_2(), z) : point_3();
      }
    }
    return result;
  }
  int name() { return static_cast<int>(below(6)); }
  double angle() {
    return chance(30) ? 90.0 * (static_cast<int>(below(9)) - 4) : uniform(-400, 400);
  }
  Colour colour() {
    // Where rounding is downward, a converted unsigned 0 may become -0.
    return {uniform(0, 1), chance(2) ? 1.5 : uniform(0, 1), below(2) == 0 ? 0.0 : 1.0};
  }
  FillStyle fill_style() {
    return {chance(70) ? FillStyle::Kind::solid : FillStyle::Kind::hollow, colour()};
  }
  LineStyle line_style() {
    constexpr std::array kKinds{LineStyle::Kind::solid, LineStyle::Kind::dashed,
                                LineStyle::Kind::none};
    return {kKinds[below(3)], colour(), uniform(-0.1, 9), uniform(0.1, 9), uniform(0.1, 9)};
  }

  LineSelection lines() {
    LineKinds kinds = 0;
    for (const LineKindEntry& entry : line_kinds()) {
      if (chance(30)) kinds = static_cast<LineKinds>(kinds | kinds_of(entry.kind));
    }
    return {kinds, uniform(-5.0, 190.0)};
  }
  TextStyle text_style() {
    using enum TextStyle::Alignment;
    constexpr std::array kAlignments{left, centre, right};
    return {uniform(-0.05, 1.05), kAlignments[below(3)], chance(30)};
  }
  std::string characters() {
    constexpr std::array kParts{"a",      " ",      "\"",         "\\", "#",
                                "\u00e9", "\u2212", "\U0001F4D0", "<",  "'"};
    std::string text;
    for (std::uint64_t n = below(6); n > 0; --n) text += kParts[below(kParts.size())];
    return chance(4) ? text + "\t" : text;
  }

  void surface() {
    const int nx = static_cast<int>(below(5)), ny = 2 + static_cast<int>(below(3));
    std::vector<double> heights(static_cast<std::size_t>(nx * ny));
    for (double& z : heights) {
      z = chance(90) ? uniform(-1, 1) : std::numeric_limits<double>::quiet_NaN();
    }
    const double x = uniform(-1, 1), y = uniform(-1, 1);
    system_.surface_3({x, sum(x, uniform(-0.1, 1)), nx, y, sum(y, uniform(0, 1)), ny, heights});
  }
  void line_kind_style() {
    using enum LineStyle::Kind;
    LineKindStyle style;
    if (chance(60)) style.width = uniform(-0.1, 3);
    if (chance(50)) style.kind = chance(50) ? dashed : solid;
    if (chance(20)) style.dash = style.gap = uniform(-0.1, 5);
    if (chance(30)) style.colour = Colour(uniform(0, 1), uniform(0, 1), uniform(-0.05, 1));
    system_.set_line_kind_style(static_cast<StyledLines>(below(8)), style);
  }
  void lower_line_style() {
    if (chance(40)) return system_.set_lower_line_style(std::nullopt);
    system_.set_lower_line_style(line_style());
  }
  void vertex_colours() {
    const auto vertices = points<Point3>();
    const Colour first = colour();  // near to each other: few pieces
    std::vector<Colour> colours;
    while (colours.size() < vertices.size()) {
      colours.push_back(first);
      colours.back().r = tenth_of(uniform(0, 1));
    }
    if (chance(10)) colours.push_back(first);
    system_.set_vertex_colours(colours);
    if (chance(80)) system_.polygon_abs_3(vertices);
  }
  void cutting_plane() {
    const int n = static_cast<int>(below(8));  // 1 to 6 are right
    if (chance(70)) return system_.set_cutting_plane_off(n);
    system_.set_cutting_plane(n, coordinate(), coordinate(), coordinate(), uniform(-0.2, 4));
  }

  void cut_faces() {
    using enum CutFaces::Kind;
    constexpr std::array kKinds{open, closed, hatched};
    CutFaces faces{kKinds[below(kKinds.size())]};
    if (chance(50)) faces.spacing = uniform(-0.05, 0.5);
    if (chance(50)) faces.angle = angle();
    system_.set_cut_faces(faces);
  }

  std::optional<Point2> offset() {
    if (chance(50)) return std::nullopt;
    return Point2(coordinate(), coordinate());
  }
  void annotation() {
    switch (below(9)) {
      case 0: return system_.annotate(Leader{point_3(), characters(), offset()});
      case 1:
        return system_.annotate(
            Balloon{point_3(), static_cast<int>(below(9)), characters(), offset()});
      case 2:
        return system_.annotate(LinearDimension{static_cast<LinearDimension::Axis>(below(3)),
                                                point_3(), point_3(), point_3()});
      case 3: return system_.annotate(AlignedDimension{point_3(), point_3(), point_3()});
      case 4: return system_.annotate(DiameterDimension{point_3(), point_3()});
      case 5: return system_.annotate(RadiusDimension{point_3(), point_3()});
      case 6:
        return system_.annotate(AngleDimension{point_3(), point_3(), point_3(), uniform(-0.1, 1)});
      case 7: return system_.annotate(Title{characters()});
      default: return system_.annotate(PartsList{static_cast<PartsList::Corner>(below(4))});
    }
  }
  void annotation_setting() {
    AnnotationStyle style = system_.looks().annotation;
    switch (below(5)) {
      case 0:
        style.size = uniform(-1, 20);
        style.unit =
            chance(50) ? AnnotationStyle::Unit::millimetres : AnnotationStyle::Unit::pixels;
        break;
      case 1:
        style.ends = chance(50) ? AnnotationStyle::Ends::arrow : AnnotationStyle::Ends::dot;
        break;
      case 2: style.decimals = static_cast<int>(below(12)) - 1; break;
      case 3:
        style.dimension_text = chance(50) ? "4\u00d7 <> \"H7\"" : chance(50) ? "" : "H7";
        break;
      default:
        style.placement = chance(50) ? AnnotationStyle::Placement::entered
                                     : AnnotationStyle::Placement::automatic;
    }
    system_.set_annotation_style(style);
  }

  void call_primitive() {
    using enum SurfaceCurves;
    constexpr std::array kCurves{x, y, both};
    constexpr std::array kSides{SurfaceSides::upper, SurfaceSides::lower, SurfaceSides::both};
    switch (below(33)) {
      case 0: return system_.move_abs_3(coordinate(), coordinate(), coordinate());
      case 1: return system_.line_abs_3(coordinate(), coordinate(), coordinate());
      case 2: return system_.move_rel_3(coordinate(), coordinate(), coordinate());
      case 3: return system_.line_rel_3(coordinate(), coordinate(), coordinate());
      case 4: return system_.move_abs_2(coordinate(), coordinate());
      case 5: return system_.line_abs_2(coordinate(), coordinate());
      case 6: return system_.move_rel_2(coordinate(), coordinate());
      case 7: return system_.line_rel_2(coordinate(), coordinate());
      case 8: return system_.polygon_rel_3(points<Point3>());
      case 9: return system_.polygon_abs_2(points<Point2>());
      case 10: return system_.polygon_rel_2(points<Point2>());
      case 11: return system_.set_fill_style(fill_style());
      case 12: return system_.set_line_style(line_style());
      case 13: return system_.set_light(point_3(), uniform(-0.05, 1));
      case 14: return system_.set_pick_id(static_cast<int>(below(1000)) - 10);
      case 15:
        return system_.set_shading(chance(30)   ? Shading::flat
                                   : chance(50) ? Shading::gouraud
                                                : Shading::phong);
      case 16: return system_.set_vertex_normals(points<Point3>());
      case 17: {
        const auto vertices = points<Point3>();
        system_.set_vertex_normals(std::vector<Point3>(vertices.size(), point_3()));
        return system_.polygon_abs_3(vertices);
      }
      case 18: return system_.set_shadows(chance(70));
      case 19: return system_.text(characters());
      case 20: return system_.set_text_style(text_style());
      case 21: return surface();
      case 22: return system_.set_surface_curves(kCurves[below(kCurves.size())]);
      case 23: return system_.set_surface_sides(kSides[below(kSides.size())]);
      case 24: return lower_line_style();
      case 25: return cutting_plane();
      case 26: return cut_faces();
      case 27: return line_kind_style();
      case 28: return system_.set_crease_angle(uniform(-10, 190));
      case 29: return annotation();
      case 30: return annotation_setting();
      case 31: return vertex_colours();
      default: return system_.polygon_abs_3(points<Point3>());
    }
  }

  void call_any() {
    switch (below(40)) {
      case 0: return system_.set_view_reference_point(tenth_of(point_3()));
      case 1: return system_.set_view_plane_normal(point_3());
      case 2: return system_.set_view_distance(tenth_of(coordinate()));
      case 3: return system_.set_view_up(point_3());
      case 4: return system_.set_parallel({tenth_of(coordinate()), tenth_of(coordinate()), 1});
      case 5: return system_.set_perspective({coordinate(), coordinate(), uniform(1, 9)});
      case 6: return system_.set_view_depth(uniform(-2, 0), uniform(-0.1, 2));
      case 7: return system_.set_front_plane_clipping(chance(50));
      case 8: return system_.set_back_plane_clipping(chance(50));
      case 9:
        return system_.set_window(uniform(-2, 0), uniform(0, 2), uniform(-2, 0), uniform(0, 2));
      case 10:
        return system_.set_viewport(uniform(0, 0.5), uniform(0.5, 1), uniform(0, 0.5),
                                    uniform(0.5, 1.1));
      case 11: return system_.create_transformation_3();
      case 12:
        return system_.translate_3(tenth_of(coordinate()), tenth_of(coordinate()), coordinate());
      case 13: return system_.scale_3(uniform(0.5, 1.5), uniform(0.5, 1.5), uniform(-1.5, 1.5));
      case 14: return system_.rotate_x_3(angle());
      case 15: return system_.rotate_y_3(angle());
      case 16: return system_.rotate_z_3(angle());
      case 17: return system_.delete_segment(name());
      case 18:
        if (chance(90)) return;  // now and then
        return system_.delete_all_segments();
      case 19: return system_.rename_segment(name(), name());
      case 20: return system_.set_visibility(name(), chance(50));
      case 21: return system_.set_image_translation(name(), coordinate(), coordinate());
      case 22: return system_.set_image_scale(name(), coordinate(), coordinate());
      case 23: return system_.set_image_rotation(name(), angle());
      case 24: return system_.set_hidden_surfaces({.removal = chance(50)});
      case 25: return system_.set_back_face_removal(chance(30));
      case 26: {
        const auto methods = hidden_methods();
        const HiddenMethod method = methods[below(methods.size())].method;
        return system_.set_hidden_surfaces(
            {.method = needs_surface(method) ? HiddenMethod::franklin : method});
      }
      case 27:
        if (chance(20)) {
          return system_.set_hidden_surfaces(
              {.line_order = chance(50) ? LineOrder::entry : LineOrder::depth});
        }
        if (chance(10)) return system_.set_hidden_surfaces({.line_halo = uniform(-1.0, 4.0)});
        if (chance(50)) {
          return system_.set_hidden_surfaces(
              {.hidden_lines = chance(50) ? HiddenLines::none : HiddenLines::dashed});
        }
        return system_.set_hidden_surfaces({.z_buffer = chance(50)});
      case 28: return system_.close_segment();
      case 29: return system_.save_transformation_3();
      case 30: return system_.restore_transformation_3();
      case 31: return system_.set_image_centre(name(), coordinate(), coordinate());
      case 32: return system_.set_hidden_surfaces({.lines = lines()});
      case 33: return cutting_plane();
      case 34: return system_.set_segment_title(name(), chance(50) ? "a \"title\"" : "");
      case 38: return system_.set_window_fit(chance(50) ? WindowFit::widen : WindowFit::stretch);
      case 39:
        return system_.set_background(
            {chance(50) ? Background::Kind::none : Background::Kind::solid, colour()});
      default: return system_.open_segment(name());
    }
  }

  std::function<std::uint64_t()> random_;
  GraphicsSystem& system_;
  int refused_ = 0;
};

}  // namespace displayfile::test
