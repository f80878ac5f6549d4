#include "interp/truth/line_hiders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "clip/base/parallel.h"
#include "hidden/lines/end_on_plane.h"
#include "hidden/lines/near_line.h"
#include "interp/truth/true_picture.h"

namespace displayfile {

// ---- Parts hidden by polygons --------------------------------------------------------------

namespace {

/// The polygon's depth less the line's at the line's start and at its end, both times the same
/// positive number.
std::array<Integer, 2> gaps(const EndDepths& polygon, const EndDepths& line) {
  return {polygon.from * line.under - line.from * polygon.under,
          polygon.to * line.under - line.to * polygon.under};
}

/// The same of a polygon and a line at one of its depths: 0 at an end that is within reach of the
/// plane, and of the other sign where viewing has rounded the end across it.
std::array<Integer, 2> gaps(const Hider& hider, const ExactLine& line, std::size_t depth_number) {
  std::array<Integer, 2> both = gaps(hider.depth, line.depths[depth_number]);
  for (std::size_t k = 0; k < 2 && !hider.as_entered.empty(); ++k) {
    const std::optional<int> sign = hider.as_entered[depth_number][k];
    if (sign && *sign != sgn(both[k])) both[k] = *sign * abs(both[k]);
  }
  return both;
}

/// True if the polygon is strictly nearer just after t: at t itself or, if the depths are equal
/// there, beyond it.
bool is_nearer_after(const Hider& hider, const ExactLine& line, std::size_t depth_number,
                     const Fraction& t) {
  const auto [at_start, at_end] = gaps(hider, line, depth_number);
  const Integer change = at_end - at_start;
  const Integer at_t = at_start * t.under + change * t.over;
  return at_t > 0 || (at_t == 0 && change > 0);
}

/// True if a point that runs along the line crosses an odd number of sides after t.
bool is_covered_after(const std::vector<Fraction>& crossings, const Fraction& t) {
  return std::ranges::count_if(crossings, [&](const Fraction& c) { return t < c; }) % 2 == 1;
}

/// Adds the parts inside, within that part: those after an odd number of crossings.
void add_covered(std::vector<Fraction> crossings, const ExactPart& within,
                 std::vector<ExactPart>& to) {
  std::ranges::sort(crossings, [](const Fraction& a, const Fraction& b) { return a < b; });
  for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
    add_common({crossings[k], crossings[k + 1]}, within, to);
  }
}

}  // namespace

std::optional<ExactPart> nearer_part(const Hider& hider, const ExactLine& line,
                                     std::size_t depth_number) {
  const auto [at_start, at_end] = gaps(hider, line, depth_number);
  if (at_start <= 0 && at_end <= 0) return std::nullopt;
  ExactPart part = whole_line();
  if (at_start < 0) part.from = quotient(at_start, at_start - at_end);
  if (at_end < 0) part.to = quotient(at_start, at_start - at_end);
  return part;
}

ExactParts hidden_parts(const ExactLine& line, std::size_t depth_number,
                        std::span<const Hider> hiders) {
  std::array<std::vector<ExactPart>, 2> covered;
  for (const Hider& hider : hiders) {
    const auto nearer = nearer_part(hider, line, depth_number);
    if (!nearer) continue;
    for (std::size_t side = 0; side < covered.size(); ++side) {
      add_covered(hider.crossings[side], *nearer, covered[side]);
    }
  }
  return common(united(std::move(covered[0])), united(std::move(covered[1])));
}

ExactParts visible_parts(const ExactLine& line, std::span<const Hider> hiders) {
  ExactParts hidden{whole_line()};
  for (std::size_t k = 0; k < line.depths.size(); ++k) {
    hidden = common(hidden, hidden_parts(line, k, hiders));
  }
  return rest(hidden);
}

bool is_hidden_after(const ExactLine& line, std::span<const Hider> hiders, const Fraction& t) {
  const auto is_hidden_on = [&](std::size_t k, std::size_t side) {
    return std::ranges::any_of(hiders, [&](const Hider& hider) {
      return is_covered_after(hider.crossings[side], t) && is_nearer_after(hider, line, k, t);
    });
  };
  for (std::size_t k = 0; k < line.depths.size(); ++k) {
    if (!is_hidden_on(k, 0) || !is_hidden_on(k, 1)) return false;
  }
  return true;
}

// ---- Whole numbers -------------------------------------------------------------------------

LineHiders::LineHiders(const LineItems& items, int threads) : items_(items) {
  for (std::uint32_t item = 0; item < items.size(); ++item) {
    const Point3 rest = items.plane_rest(item);
    depth_places_ = std::max(depth_places_, common_places(std::array{rest.x, rest.y, rest.z}));
    for (const Point3& p : items.points(item)) {
      places_ = std::max({places_, binary_places(p.x), binary_places(p.y)});
      depth_places_ = std::max(depth_places_, binary_places(p.z));
    }
  }
  enter_solids(threads);
  enter_cells();
}

std::optional<std::array<Point3, 3>> LineHiders::plane_points(std::uint32_t item) const {
  const auto vertices = items_.points(item);
  const auto support = support_of(vertices);
  if (!support) return std::nullopt;
  if (const auto* const shared = items_.shared_plane(item)) return *shared;
  const auto [i, j, k] = *support;
  return std::array<Point3, 3>{vertices[i], vertices[j], vertices[k]};
}

/// The plane through p, q and r, with their rests: three points of the plane that the polygon
/// shares, or its support vertices; none if it is edge-on. With (a, b, c) the cross product of q -
/// p and r - p, a (x - px) + b (y - py) + c (z - pz) = 0.
std::optional<LineHiders::DepthPlane> LineHiders::plane(std::uint32_t item) const {
  const auto points = plane_points(item);
  if (!points) return std::nullopt;
  Point p = point((*points)[0]), q = point((*points)[1]), r = point((*points)[2]);
  if (const Point3 rest = items_.plane_rest(item); rest != Point3(0.0)) {
    p.z += scaled(rest.x, depth_places_);
    q.z += scaled(rest.y, depth_places_);
    r.z += scaled(rest.z, depth_places_);
  }
  const Integer ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const Integer vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  DepthPlane plane{uy * vz - uz * vy, uz * vx - ux * vz, 0, ux * vy - uy * vx};
  if (plane.under == 0) return std::nullopt;
  if (plane.under < 0) {
    for (Integer* n : {&plane.slope_x, &plane.slope_y, &plane.under}) *n = -*n;
  }
  plane.origin = plane.slope_x * p.x + plane.slope_y * p.y + plane.under * p.z;
  return plane;
}

/// The double nearest to over / under.
double LineHiders::depth(const Integer& over, const Integer& under) const {
  return Division().nearest_double(over, Integer(under << static_cast<std::size_t>(depth_places_)));
}

/// The least (farthest) and the greatest (nearest) depth of a polygon's support plane at its
/// vertices. For a triangle, those of the vertices themselves, if they lie on its plane; the
/// vertices of other polygons are projected on to it. Without a plane the least is infinite and the
/// greatest -infinite.
std::array<double, 2> LineHiders::depth_range(std::uint32_t item) const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::array<double, 2> range{kInfinite, -kInfinite};
  const auto include = [&](double z) { range = {std::min(range[0], z), std::max(range[1], z)}; };
  const bool has_vertices_on_plane = items_.points(item).size() == 3 &&
                                     items_.shared_plane(item) == nullptr &&
                                     items_.plane_rest(item) == Point3(0.0);
  if (has_vertices_on_plane) {
    for (const Point3& p : items_.points(item)) include(p.z);
    return range;
  }
  const auto plane = this->plane(item);
  if (!plane) return range;
  for (const Point3& p : items_.points(item)) {
    const Point at = point(p);
    include(depth(plane->over(at.x, at.y), plane->under));
  }
  return {std::nextafter(range[0], -kInfinite), std::nextafter(range[1], kInfinite)};
}

EndDepths LineHiders::depths(const ExactLine& line, const DepthPlane& plane) const {
  return {plane.over(line.x0, line.y0, line.scale), plane.over(line.x1, line.y1, line.scale),
          plane.under * line.scale};
}

/// True if the depths of the sharer's own ends are used: where a plane is steep, its depth there is
/// dominated by rounding. A triangle's ends lie on its plane, and most others up to the rounding of
/// viewing.
bool LineHiders::has_own_depth(LineId sharer) const {
  const bool is_moved = items_.points(sharer.item).size() > 3 ||
                        items_.shared_plane(sharer.item) != nullptr ||
                        items_.plane_rest(sharer.item) != Point3(0.0);
  if (items_.kind(sharer.item) == LineItems::Kind::line || !is_moved) return true;
  const auto plane = plane_points(sharer.item);
  if (!plane || items_.rounding() == 0.0) return !plane;
  const auto& [p, q, r] = *plane;
  const Plane own(p, q, r, items_.plane_rest(sharer.item));
  const auto is_on = [&](const Point3& end) {
    return displayfile::has_own_depth(end, own, items_.touching(), items_.rounding());
  };
  return is_on(items_.from(sharer)) && is_on(items_.to(sharer));
}

/// The depths of the sharer's support plane; for a line or an edge-on polygon, those of its own
/// ends.
EndDepths LineHiders::depths(const ExactLine& line, LineId sharer) const {
  if (!has_own_depth(sharer)) {
    if (const auto plane = this->plane(sharer.item)) return depths(line, *plane);
  }
  return {scaled(line.start.z, depth_places_), scaled(line.end.z, depth_places_), 1};
}

ExactLine LineHiders::line(const LineItems::Sharers& sharers) const {
  ExactLine line;
  line.start = items_.from(sharers.front());
  line.end = items_.to(sharers.front());
  line.x0 = scaled(line.start.x, places_);
  line.y0 = scaled(line.start.y, places_);
  line.x1 = scaled(line.end.x, places_);
  line.y1 = scaled(line.end.y, places_);
  const auto equal = [](const EndDepths& a, const EndDepths& b) {
    const auto [at_start, at_end] = gaps(a, b);
    return at_start == 0 && at_end == 0;
  };
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  line.farthest = kInfinite;
  for (const LineId sharer : sharers) {
    EndDepths depth = depths(line, sharer);
    if (std::ranges::any_of(line.depths, [&](const auto& d) { return equal(d, depth); })) continue;
    const double from = this->depth(depth.from, depth.under);
    const double to = this->depth(depth.to, depth.under);
    line.farthest = std::min({line.farthest, from, to});
    line.sharers.push_back(sharer);
    line.depths.push_back(std::move(depth));
  }
  line.farthest = std::nextafter(line.farthest, -kInfinite);
  return line;
}

/// None if the polygon covers no point close to the line, or has no plane.
namespace {

Fraction exactly(double value) {
  constexpr int kPlaces = 1074;  // of every double
  return quotient(scaled(value, kPlaces), Integer(1) << kPlaces);
}

}  // namespace

std::optional<Hider> LineHiders::hider(const ExactLine& line, std::uint32_t item) const {
  const Integer along_x = line.x1 - line.x0, along_y = line.y1 - line.y0;
  struct Vertex {
    Integer x, y;
    int side;                       // 1 left of the line, -1 right of it, 0 on it
    std::optional<Fraction> place;  // of one that is not quite on the line
  };
  const bool is_intersection = line.sharers.empty();
  const NearLine near_line(
      line.start, line.end,
      is_intersection ? OffLines() : off_lines(items_.touching(), items_.rounding()));
  std::vector<Vertex> vertices;
  for (const Point3& p : items_.points(item)) {
    Vertex v{scaled(p.x, places_) * line.scale, scaled(p.y, places_) * line.scale, 0, {}};
    const Integer aside = along_x * (v.y - line.y0) - along_y * (v.x - line.x0);
    v.side = sgn(aside);
    if (v.side != 0 && near_line.has(p)) {
      v.side = 0;
      v.place = exactly(near_line.place(Point2(p)));
    }
    vertices.push_back(std::move(v));
  }
  Hider hider;
  const Vertex* a = &vertices.back();
  for (const Vertex& b : vertices) {
    const bool crosses_left = (a->side > 0) != (b.side > 0);
    const bool crosses_right = (a->side < 0) != (b.side < 0);
    if (crosses_left || crosses_right) {
      const Integer x = b.x - a->x, y = b.y - a->y;
      const Integer start = x * (line.y0 - a->y) - y * (line.x0 - a->x);
      const Integer end = x * (line.y1 - a->y) - y * (line.x1 - a->x);
      const Fraction at = a->place ? *a->place : b.place ? *b.place : quotient(start, start - end);
      if (crosses_left) hider.crossings[0].push_back(at);
      if (crosses_right) hider.crossings[1].push_back(at);
    }
    a = &b;
  }
  const Fraction first{0, 1}, last{1, 1};
  const auto reaches_line = [&](const std::vector<Fraction>& crossings) {
    return std::ranges::any_of(crossings, [&](const Fraction& c) { return first < c; }) &&
           std::ranges::any_of(crossings, [&](const Fraction& c) { return c < last; });
  };
  if (!reaches_line(hider.crossings[0]) && !reaches_line(hider.crossings[1])) return std::nullopt;
  const auto plane = this->plane(item);
  if (!plane) return std::nullopt;
  hider.depth = depths(line, *plane);
  hider.as_entered = as_entered(line, item);
  return hider;
}

/// Where that is unknown, an end counts as on a plane if only viewing may have moved it off.
std::vector<std::array<std::optional<int>, 2>> LineHiders::as_entered(const ExactLine& line,
                                                                      std::uint32_t item) const {
  std::vector<std::array<std::optional<int>, 2>> all;
  if (!items_.some_touch()) return all;
  const auto [p, q, r] = *plane_points(item);
  const Plane plane(p, q, r);
  const double touching = items_.touching();
  const auto sign = [&](EndsAsEntered::Place place, const Point3& end) {
    return sign_as_entered(place, on_plane(end, plane, touching));
  };
  const double beyond_reach = depth_range(item)[0] - reach_in_depth(touching, plane);
  const Point3 none(0.0);
  const auto by_planes = [&](EndsAsEntered::Place place) -> std::optional<int> {
    return place == EndsAsEntered::Place::on_plane ? std::optional(0) : std::nullopt;
  };
  for (std::size_t k = 0; k < line.sharers.size(); ++k) {
    const LineId sharer = line.sharers[k];
    if (items_.share_plane(sharer.item, item)) {
      all.push_back({0, 0});
      continue;
    }
    const EndDepths& ends = line.depths[k];
    if (std::max(depth(ends.from, ends.under), depth(ends.to, ends.under)) < beyond_reach) {
      all.emplace_back();
      continue;
    }
    const auto [from, to] = items_.places(sharer, item);
    const bool planes_tell = items_.plane_rest(item) != none &&
                             items_.kind(sharer.item) != LineItems::Kind::line &&
                             items_.plane_rest(sharer.item) != none;
    std::array signs{planes_tell ? by_planes(from) : sign(from, items_.from(sharer)),
                     planes_tell ? by_planes(to) : sign(to, items_.to(sharer))};
    if (items_.from(sharer) != line.start) std::swap(signs[0], signs[1]);  // it runs the other way
    all.push_back(signs);
  }
  return all;
}

std::vector<Hider> LineHiders::hiders(const ExactLine& line) const {
  const auto is_nearer_somewhere = [&](const Hider& hider) {
    for (std::size_t k = 0; k < line.depths.size(); ++k) {
      if (nearer_part(hider, line, k)) return true;
    }
    return false;
  };
  std::vector<Hider> found;
  for (const std::uint32_t item : near(line)) {
    auto hider = this->hider(line, item);
    if (hider && is_nearer_somewhere(*hider)) found.push_back(std::move(*hider));
  }
  return found;
}

// ---- Intersections of polygons ---------------------------------------------------------------

namespace {

/// True if some two points are consecutive in both sequences, in either order.
template <class Points>
bool share_a_side(const Points& of_a, const Points& of_b) {
  const Point3* from = &of_a.back();
  for (const Point3& to : of_a) {
    const Point3* p = &of_b.back();
    for (const Point3& q : of_b) {
      if ((*from == *p && to == q) || (*from == q && to == *p)) return true;
      p = &q;
    }
    from = &to;
  }
  return false;
}

}  // namespace

std::vector<ExactLine> LineHiders::intersections(std::uint32_t item_a, std::uint32_t item_b) const {
  std::vector<ExactLine> lines;
  for (const std::uint32_t item : {item_a, item_b}) {
    if (items_.kind(item) != LineItems::Kind::solid) return lines;
  }
  const auto p = plane(item_a), q = plane(item_b);
  if (!p || !q) return lines;
  FlatLine line{p->slope_x * q->under - q->slope_x * p->under,
                p->slope_y * q->under - q->slope_y * p->under,
                p->origin * q->under - q->origin * p->under, 0, 0};
  if (line.a == 0 && line.b == 0) return lines;
  const int way = line.b > 0 || (line.b == 0 && line.a < 0) ? 1 : -1;
  line.ahead_x = way * line.b;
  line.ahead_y = -way * line.a;
  const ExactParts parts = common(inside(item_a, item_b, line), inside(item_b, item_a, line));
  if (parts.empty() || share_a_side(items_.points(item_a), items_.points(item_b))) return lines;
  if (touches(item_a, item_b, line) || touches(item_b, item_a, line)) return lines;
  for (const ExactPart& part : parts) lines.push_back(between(line, part, *p));
  return lines;
}

/// Marks the corners within reach of the other's plane as entered.
std::vector<bool> LineHiders::corners_on_plane(std::uint32_t item, std::uint32_t other) const {
  using Place = EndsAsEntered::Place;
  const auto corners = static_cast<std::uint32_t>(items_.points(item).size());
  std::vector<bool> are_on(corners, false);
  for (std::uint32_t k = 0; items_.some_touch() && k < corners; ++k) {
    const std::uint32_t next = (k + 1) % corners;
    are_on[k] = items_.places({item, k}, other)[1] == Place::on_plane &&
                items_.places({item, next}, other)[0] == Place::on_plane;
  }
  return are_on;
}

/// True if all corners on one side of the line are within reach of the other's plane as entered.
bool LineHiders::touches(std::uint32_t item, std::uint32_t other, const FlatLine& line) const {
  if (!items_.some_touch()) return false;
  const std::span<const Point3> points = items_.points(item);
  const std::vector<bool> are_on = corners_on_plane(item, other);
  bool left = false, right = false;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    const int side =
        sgn(line.c - line.a * scaled(points[k].x, places_) - line.b * scaled(points[k].y, places_));
    left |= side > 0 && !are_on[k];
    right |= side < 0 && !are_on[k];
  }
  return !(left && right);
}

/// The parts where points close to the line, on its left or right, are inside by even-odd; united,
/// so that a place where the boundary only touches the line is no end. The ends of a side that lies
/// in the other's plane as entered count as on the line.
ExactParts LineHiders::inside(std::uint32_t item, std::uint32_t other, const FlatLine& line) const {
  struct Vertex {
    Integer aside, place;
  };
  std::vector<Vertex> vertices;
  for (const Point3& at : items_.points(item)) {
    const Integer x = scaled(at.x, places_), y = scaled(at.y, places_);
    vertices.push_back({line.c - line.a * x - line.b * y, line.ahead_x * x + line.ahead_y * y});
  }
  const std::vector<bool> are_on = corners_on_plane(item, other);
  for (std::size_t k = 0, before = vertices.size() - 1; k < vertices.size(); before = k++) {
    if (are_on[k] && are_on[before]) vertices[k].aside = vertices[before].aside = 0;
  }
  std::array<ExactParts, 2> of_sides;
  for (const int side : {1, -1}) {
    std::vector<Fraction> crossings;
    const Vertex* v = &vertices.back();
    for (const Vertex& w : vertices) {
      if ((sgn(v->aside) == side) != (sgn(w.aside) == side)) {
        crossings.push_back(quotient(v->place * w.aside - w.place * v->aside, w.aside - v->aside));
      }
      v = &w;
    }
    std::ranges::sort(crossings, [](const Fraction& f, const Fraction& g) { return f < g; });
    std::vector<ExactPart> parts;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      if (crossings[k] < crossings[k + 1]) parts.push_back({crossings[k], crossings[k + 1]});
    }
    of_sides[side > 0 ? 0 : 1] = united(std::move(parts));
  }
  return common(of_sides[0], of_sides[1]);
}

ExactLine LineHiders::between(const FlatLine& line, const ExactPart& part,
                              const DepthPlane& plane) const {
  const Integer square = line.a * line.a + line.b * line.b;
  const auto along = [&](const Integer& across, const Integer& ahead, const Fraction& place) {
    return Integer(line.c * across * place.under + ahead * place.over);
  };
  const auto& [from, to] = part;
  ExactLine found;
  found.scale = square * from.under * to.under;
  found.x0 = along(line.a, line.ahead_x, from) * to.under;
  found.y0 = along(line.b, line.ahead_y, from) * to.under;
  found.x1 = along(line.a, line.ahead_x, to) * from.under;
  found.y1 = along(line.b, line.ahead_y, to) * from.under;
  const EndDepths depth = depths(found, plane);
  const auto place = [&](const Integer& at) {
    const Integer unit = found.scale << static_cast<std::size_t>(places_);
    return Division().nearest_double(at, unit);
  };
  found.start = {place(found.x0), place(found.y0), this->depth(depth.from, depth.under)};
  found.end = {place(found.x1), place(found.y1), this->depth(depth.to, depth.under)};
  found.farthest = std::nextafter(std::min(found.start.z, found.end.z),
                                  -std::numeric_limits<double>::infinity());
  found.depths.push_back(depth);
  return found;
}

// ---- Candidate hiders of a line --------------------------------------------------------------

void LineHiders::enter_solids(int threads) {
  for (std::uint32_t item = 0; item < items_.size(); ++item) {
    if (items_.kind(item) != LineItems::Kind::solid) continue;
    solids_.push_back({item, bounding_rectangle(items_.points(item)), 0.0});
  }
  in_parallel(threads, solids_.size(),
              [&](std::size_t k) { solids_[k].nearest = depth_range(solids_[k].item)[1]; });
}

/// Monotonic in the coordinate, so that all coordinates between two are in the cells between
/// theirs.
std::size_t LineHiders::cell(double coordinate) const {
  const auto cells = static_cast<double>(cells_);
  return static_cast<std::size_t>(std::clamp(coordinate * cells, 0.0, cells - 1.0));
}

LineHiders::Cells LineHiders::cells(const Rectangle& around) const {
  return {cell(around.x_min), cell(around.x_max), cell(around.y_min), cell(around.y_max)};
}

/// No more cells than polygons, so that the number of entries stays of the order of the polygons.
void LineHiders::enter_cells() {
  constexpr std::size_t kMostCells = 1024, kEntriesOfSolid = 8;
  const auto entries = [&] {
    std::size_t sum = 0;
    for (const Solid& solid : solids_) {
      const auto [left, right, bottom, top] = cells(solid.around);
      sum += (right - left + 1) * (top - bottom + 1);
    }
    return sum;
  };
  cells_ = std::clamp(static_cast<std::size_t>(std::sqrt(static_cast<double>(solids_.size()))),
                      std::size_t{1}, kMostCells);
  while (cells_ > 1 && entries() > kEntriesOfSolid * solids_.size()) cells_ /= 2;

  starts_.assign(cells_ * cells_ + 1, 0);
  const auto for_each_cell = [&](const Solid& solid, auto&& use) {
    const auto [left, right, bottom, top] = cells(solid.around);
    for (std::size_t row = bottom; row <= top; ++row) {
      for (std::size_t column = left; column <= right; ++column) use(row * cells_ + column);
    }
  };
  for (const Solid& solid : solids_) {
    for_each_cell(solid, [&](std::size_t cell) { ++starts_[cell]; });
  }
  std::size_t end = 0;
  for (std::size_t& start : starts_) start = end += start;  // ends, until they are entered
  entries_.resize(end);
  for (std::size_t k = solids_.size(); k-- > 0;) {
    for_each_cell(solids_[k], [&](std::size_t cell) {
      entries_[--starts_[cell]] = static_cast<std::uint32_t>(k);
    });
  }
}

/// The items of all solid polygons whose rectangle overlaps the line's, that may be nearer, and
/// that share a cell with the line. The line is processed in stretches about as long as a cell:
/// their ends, in doubles, are off by less than eight roundings of the coordinates' sum.
std::vector<std::uint32_t> LineHiders::near(const ExactLine& line) const {
  const Point2 from(line.start), to(line.end);
  const std::array<Point3, 2> ends{line.start, line.end};
  const Rectangle around = bounding_rectangle(ends);
  const Cells reached = cells(around);
  const bool is_ordinary = in_range(line.start) && in_range(line.end);
  const std::size_t stretches =
      is_ordinary ? 1 + std::max(reached.right - reached.left, reached.top - reached.bottom) : 1;
  const Point2 off = 0x1p-50 * (glm::abs(from) + glm::abs(to));
  const auto place = [&](std::size_t stretch) {
    return from + static_cast<double>(stretch) / static_cast<double>(stretches) * (to - from);
  };
  std::vector<std::uint32_t> found;
  for (std::size_t k = 0; k < stretches; ++k) {
    Cells box = reached;
    if (stretches > 1) {
      const Point2 a = place(k), b = place(k + 1);
      const Point2 low = glm::min(a, b) - off, high = glm::max(a, b) + off;
      box = cells({low.x, high.x, low.y, high.y});
    }
    for (std::size_t row = box.bottom; row <= box.top; ++row) {
      const std::size_t first = row * cells_;
      found.insert(found.end(),
                   entries_.begin() + static_cast<std::ptrdiff_t>(starts_[first + box.left]),
                   entries_.begin() + static_cast<std::ptrdiff_t>(starts_[first + box.right + 1]));
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::erase_if(found, [&](std::uint32_t k) {
    const auto& [item, box, nearest] = solids_[k];
    return nearest <= line.farthest || box.x_max < around.x_min || box.x_min > around.x_max ||
           box.y_max < around.y_min || box.y_min > around.y_max;
  });
  for (std::uint32_t& k : found) k = solids_[k].item;
  return found;
}

}  // namespace displayfile
