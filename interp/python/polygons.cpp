#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "clip/base/error.h"
#include "clip/surfaces.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/user_routines/system_inside.h"
#include "hidden/lines/strokes_by_depth.h"
#include "hidden/lines/strokes_once.h"
#include "interp/device/output_device.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"
#include "interp/python/interrupts.h"
#include "interp/python/join_pieces.h"
#include "interp/python/pieces.h"

namespace displayfile::python {

namespace py = pybind11;

py::tuple arrays_of(DrawnPieces&& pieces) {
  const auto n = static_cast<py::ssize_t>(pieces.size());
  return py::make_tuple(owned<std::uint8_t>(std::move(pieces.kinds), {n}),
                        owned(std::move(pieces.first)), owned(std::move(pieces.points)),
                        owned(std::move(pieces.sides)), owned(std::move(pieces.fills)),
                        owned<std::uint8_t>(std::move(pieces.line_kinds), {n}),
                        owned(std::move(pieces.line_colours)), owned(std::move(pieces.line_widths)),
                        owned(std::move(pieces.picks)), owned(std::move(pieces.segments)),
                        owned(std::move(pieces.cuts)));
}

namespace {

/// One axis of the polygons' box: moved and scaled by a power of two, so that it lies in [0,1].
struct Axis {
  double low = 0.0, scale = 1.0;
  double to_unit(double value) const { return (value - low) * scale; }
  double from_unit(double value) const { return value / scale + low; }
};

Axis axis_of(std::span<const Point3> points, int a) {
  const auto [low, high] = std::ranges::minmax(points, {}, [a](const Point3& p) { return p[a]; });
  const double range = high[a] - low[a];
  if (range == 0.0) return {low[a], 1.0};
  int exponent = 0;
  std::frexp(range, &exponent);  // range < 2^exponent
  // Ranges below 2^-1000 are not scaled whole: they would have no power of two to be scaled by.
  return {low[a], std::ldexp(1.0, -std::max(exponent, -1000))};
}

/// Polygons in a view in which world coordinates are device coordinates.
struct DevicePolygons {
  std::array<Axis, 3> axes;
  std::vector<Point3> points;      // in [0,1]
  std::vector<std::size_t> first;  // of each polygon; one more at the end
  GraphicsSystem system;
};

/// The tolerance for touching, along the given axes, in device coordinates: along each axis that of
/// the given numbers; the largest counts.
Touching in_device(const Touching& touching, double unit, std::span<const Point3> given,
                   const std::array<Axis, 3>& axes) {
  if (touching.kind == Touching::Kind::off) return touching;
  double reach = 0.0;
  for (int a = 0; a < 3; ++a) {
    const auto [low, high] = std::ranges::minmax(given, {}, [a](const Point3& p) { return p[a]; });
    if (low[a] == high[a]) continue;  // nothing was rounded
    const double largest = std::max(std::abs(low[a]), std::abs(high[a]));
    reach = std::max(
        reach, entered_reach(touching, largest, unit) * axes[static_cast<std::size_t>(a)].scale);
  }
  reach = std::max(reach, entered_reach({Touching::Kind::automatic}, 1.0));
  return {Touching::Kind::length, std::min(reach, kCoordinateLimit)};
}

void require_coordinates(std::span<const Point3> points) {
  if (std::ranges::all_of(points, in_range)) return;
  throw Error("polygons: expected finite coordinates up to 1e100 in magnitude");
}

/// Enters the polygons' points in `given`, and the segments' points after them, two each, whose
/// pick identifiers follow those of the polygons.
void enter(const Polygons& polygons, const std::vector<Point3>& given, bool sides_drawn,
           const std::optional<LineSelection>& lines, const Touching& touching, double unit,
           DevicePolygons& device) {
  const std::size_t corner_count = polygons.points.size();
  const std::size_t segment_count = (given.size() - corner_count) / 2;
  if (polygons.sides.size() + segment_count > std::numeric_limits<std::int32_t>::max()) {
    throw Error("polygons: too many");
  }
  for (int a = 0; a < 3; ++a) device.axes[static_cast<std::size_t>(a)] = axis_of(given, a);
  device.points = given;
  for (Point3& p : device.points) {
    p = {device.axes[0].to_unit(p.x), device.axes[1].to_unit(p.y), device.axes[2].to_unit(p.z)};
  }
  device.first = {0};
  std::vector<std::uint32_t> corners(corner_count);
  std::vector<std::int32_t> picks(polygons.sides.size());
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i);
  for (std::size_t k = 0; k < picks.size(); ++k) {
    picks[k] = static_cast<std::int32_t>(k);
    device.first.push_back(device.first.back() + polygons.sides[k]);
  }
  GraphicsSystem& system = device.system;
  system.set_hidden_surfaces({.touching = in_device(touching, unit, given, device.axes)});
  if (lines) SystemInside::replace_lines(system, *lines);
  SystemInside::cut_bent_polygons_as_seen_along_z(system);  // so that their pieces can be joined
  system.set_window(0, 1, 0, 1);
  system.set_view_depth(-1, 0);
  system.set_line_style({sides_drawn ? LineStyle::Kind::solid : LineStyle::Kind::none});
  system.open_segment(1);
  ManyPolygons all;
  all.vertices = std::span(device.points).first(corner_count);
  all.corners = corners;
  all.sides = polygons.sides;
  all.picks = picks;
  system.polygons_abs_3(all);
  system.set_line_style({LineStyle::Kind::solid});
  for (std::size_t k = 0; k < segment_count; ++k) {
    const Point3& from = device.points[corner_count + 2 * k];
    const Point3& to = device.points[corner_count + 2 * k + 1];
    system.set_pick_id(static_cast<std::int32_t>(polygons.sides.size() + k));
    system.move_abs_3(from.x, from.y, from.z);
    system.line_abs_3(to.x, to.y, to.z);
    device.first.push_back(device.first.back() + 2);
  }
  system.close_segment();
}

bool precedes(const Point3& p, const Point3& q) {
  return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z};
}

/// Finds the corners of polygons by their coordinates.
class Corners {
 public:
  explicit Corners(const DevicePolygons& device) : device_(device), sorted_(device.first.back()) {
    std::iota(sorted_.begin(), sorted_.end(), std::size_t{0});
    for (std::size_t k = 0; k + 1 < device.first.size(); ++k) {
      std::ranges::sort(of(k), precedes, [&](std::size_t i) { return device.points[i]; });
    }
  }
  /// The index, among all points, of the polygon's corner at `p`; none if it has no such corner.
  std::optional<std::size_t> find(std::size_t polygon, const Point3& p) {
    const auto own = of(polygon);
    const auto at = std::ranges::lower_bound(own, p, precedes,
                                             [&](std::size_t i) { return device_.points[i]; });
    if (at == own.end() || device_.points[*at] != p) return std::nullopt;
    return *at;
  }

 private:
  std::span<std::size_t> of(std::size_t polygon) {
    const std::size_t begin = device_.first[polygon];
    return std::span(sorted_).subspan(begin, device_.first[polygon + 1] - begin);
  }
  const DevicePolygons& device_;
  std::vector<std::size_t> sorted_;
};

/// Converts back from device coordinates. A corner of the polygon from which a piece was cut gets
/// exactly the coordinates given.
void place_back(const std::vector<Point3>& given, const DevicePolygons& device,
                DrawnPieces& pieces) {
  Corners corners(device);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    for (std::size_t i = pieces.first[k]; i < pieces.first[k + 1]; ++i) {
      Point3& p = pieces.points[i];
      std::optional<std::size_t> corner;
      if (pieces.picks[k] >= 0) corner = corners.find(static_cast<std::size_t>(pieces.picks[k]), p);
      p = corner ? given[*corner]
                 : Point3(device.axes[0].from_unit(p.x), device.axes[1].from_unit(p.y),
                          device.axes[2].from_unit(p.z));
    }
  }
}

/// The checked arguments of a call: the ends of segments follow the polygons' points.
struct PiecesRequest {
  Polygons polygons;
  std::vector<Point3> points;
  HiddenSurfaceOptions surfaces;
  bool lines_alone;  ///< no fills: the lines that are seen
  Touching touching;
  double unit;  ///< of the numbers given, clip/surfaces.h
  bool whole = false;
  std::optional<LineSelection> lines{};

  bool has_segments() const { return points.size() > polygons.points.size(); }
};

HiddenMethod method_in(py::handle value, bool lines_alone) {
  const HiddenMethod method = hidden_method(word_in(value, "method"));
  const bool finds_pieces = method == HiddenMethod::bsp || method == HiddenMethod::depth_sort ||
                            method == HiddenMethod::plain_bsp || method == HiddenMethod::map;
  if (lines_alone ? finds_lines(method) && !needs_surface(method) : finds_pieces) return method;
  throw Error(fmt::format(
      "method '{}': expected {}", name_of(method),
      lines_alone ? "franklin, appel, roberts or plain-appel" : "depth-sort, bsp or plain-bsp"));
}

/// A length in the coordinates given, "auto" or "off".
Touching touching_in(py::handle value) {
  if (PyUnicode_Check(value.ptr()) != 0) return touching(word_in(value, "touching"));
  const Touching length{Touching::Kind::length, number_in(value, "touching")};
  require_touching(length);
  return length;
}

/// An array of single precision, or a sequence that begins with one.
bool is_of_singles(py::handle value) {
  if (py::isinstance<py::array>(value)) {
    const py::dtype type = py::reinterpret_borrow<py::array>(value).dtype();
    return type.kind() == 'f' && type.itemsize() <= 4;
  }
  if (!PyList_Check(value.ptr()) && !PyTuple_Check(value.ptr())) return false;
  const auto items = py::reinterpret_borrow<py::sequence>(value);
  return !items.empty() && py::isinstance<py::array>(items[0]) && is_of_singles(items[0]);
}

PiecesRequest request_of(py::handle polygons, py::handle sides, py::handle segments,
                         py::handle method, py::handle threads, py::handle touching,
                         bool lines_alone) {
  Polygons given = polygons_in(polygons, sides, "polygons");
  std::vector<Point3> points = given.points;
  if (!segments.is_none()) {
    const std::vector<Point3> ends = segments_in(segments, "segments");
    points.insert(points.end(), ends.begin(), ends.end());
  }
  require_coordinates(points);
  return {std::move(given),
          std::move(points),
          {.method = method_in(method, lines_alone), .threads = threads_in(threads)},
          lines_alone,
          touching_in(touching),
          is_of_singles(polygons) ? kUnitOfSingles : kUnitOfDoubles};
}

DrawnPieces found(const PiecesRequest& request) {
  if (request.points.empty()) return {};
  const bool segments_alone = request.lines_alone && request.has_segments();
  const HiddenMethod method = *request.surfaces.method;
  DevicePolygons device;
  enter(request.polygons, request.points, method != HiddenMethod::map && !segments_alone,
        request.lines, request.touching, request.unit, device);
  SortedDisplayFile sorted;
  DrawnPieces pieces = drawn_pieces(sorted.update(device.system, method, request.surfaces));
  if (request.whole) join_pieces(request.polygons.sides, device.points, pieces);
  place_back(request.points, device, pieces);
  if (segments_alone) {  // they are counted by themselves
    const auto before = static_cast<std::int32_t>(request.polygons.sides.size());
    for (std::int32_t& pick : pieces.picks) pick -= before;
  }
  return pieces;
}

/// Points, the first point of each piece, the source of each piece, its sides, which lines are
/// hidden, and which points are cuts. Kinds of sides are without kHiddenLine.
py::tuple arrays_found(const PiecesRequest& request) {
  DrawnPieces pieces = without_interpreter([&] { return found(request); });
  std::vector<std::uint8_t> is_hidden(pieces.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces.kinds[k] != DrawnPieces::Kind::line) continue;
    LineKinds& kinds = pieces.sides[pieces.first[k] + 1];
    is_hidden[k] = is_hidden_line(kinds) ? 1 : 0;
    kinds = static_cast<LineKinds>(kinds & ~kHiddenLine);
  }
  return py::make_tuple(owned(std::move(pieces.points)), owned(std::move(pieces.first)),
                        owned(std::move(pieces.picks)), owned(std::move(pieces.sides)),
                        owned(std::move(is_hidden)), owned(std::move(pieces.cuts)));
}

/// Segments in order of depth: the segment of each part, its points, and which of its ends another
/// segment cuts. x and y times `pixels` are pixels; segments with equal `looks` continue each
/// other.
py::tuple segments_by_depth(py::handle segments, py::handle widths, py::handle looks,
                            py::handle pixels, py::handle halo, py::handle apart) {
  const std::vector<Point3> ends = segments_in(segments, "segments");
  const std::vector<double> width = numbers_in(widths, "widths");
  const std::vector<std::int32_t> look = whole_numbers_in(looks, "looks");
  const std::vector<double> size = numbers_in(pixels, "pixels");
  require_coordinates(ends);
  if (2 * width.size() != ends.size() || look.size() != width.size() || size.size() != 2) {
    throw Error("segments: expected a width and a look of each, and two numbers of pixels");
  }
  const double gap = number_in(halo, "halo");
  require_line_halo(gap);
  const StrokePicture picture{{size[0], size[1]}, number_in(apart, "apart")};
  std::vector<DeepStroke> strokes;
  for (std::size_t k = 0; k < width.size(); ++k) {
    strokes.push_back({ends[2 * k], ends[2 * k + 1], width[k], static_cast<std::uint32_t>(look[k]),
                       static_cast<std::uint32_t>(k)});
  }
  const std::vector<PartByDepth> parts =
      without_interpreter([&] { return strokes_by_depth(strokes, picture, gap, 1); });
  std::vector<std::int32_t> of;
  std::vector<Point3> points;
  std::vector<std::uint8_t> cuts;
  for (const PartByDepth& part : parts) {
    const DeepStroke& s = strokes[part.stroke];
    of.push_back(static_cast<std::int32_t>(part.stroke));
    points.push_back(StrokePart::at(s.from, s.to, part.from));
    points.push_back(StrokePart::at(s.from, s.to, part.to));
    cuts.push_back(part.cuts.at_start ? 1 : 0);
    cuts.push_back(part.cuts.at_end ? 1 : 0);
  }
  return py::make_tuple(owned(std::move(of)), owned(std::move(points)), owned(std::move(cuts)));
}

}  // namespace

void add_polygons(py::module_& module) {
  module.def("_segments_by_depth", segments_by_depth);
  module.def("_pieces_of", [](py::handle polygons, py::handle sides, py::handle method,
                              py::handle threads, py::handle segments, py::handle whole,
                              py::handle touching) {
    PiecesRequest request = request_of(polygons, sides, segments, method, threads, touching, false);
    request.whole = switch_in(whole, "whole");
    return arrays_found(request);
  });
  module.def("_lines_of", [](py::handle polygons, py::handle sides, py::handle method,
                             py::handle lines, py::handle hidden, py::handle threads,
                             py::handle segments, py::handle touching) {
    PiecesRequest request = request_of(polygons, sides, segments, method, threads, touching, true);
    if (switch_in(hidden, "hidden")) request.surfaces.hidden_lines = HiddenLines::dashed;
    request.lines = if_given(lines, "lines", [](py::handle value, std::string_view what) {
      return line_selection(word_in(value, what));
    });
    return arrays_found(request);
  });
}

}  // namespace displayfile::python
