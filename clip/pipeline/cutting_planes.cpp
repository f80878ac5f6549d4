#include "clip/pipeline/cutting_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>

#include "clip/base/error.h"
#include "clip/geometry/unit.h"
#include "clip/pipeline/clip_stage.h"

namespace displayfile {

namespace {

void require_plane_number(int n) {
  if (n >= 1 && n <= CuttingPlanes::kMost) return;
  throw Error(fmt::format("cutting plane {}: expected 1 to {}", n, CuttingPlanes::kMost));
}

bool is_within_limit(double value) { return std::abs(value) <= kCoordinateLimit; }

Point3 unit_normal(const Point3& n) { return n == Point3(0.0) ? n : unit(n); }

}  // namespace

void CuttingPlanes::set(int n, double a, double b, double c, double d) {
  require_plane_number(n);
  const auto plane_in_words = [&] { return fmt::format("cutting plane {} {} {} {}", a, b, c, d); };
  if (!is_within_limit(a) || !is_within_limit(b) || !is_within_limit(c) || !is_within_limit(d)) {
    throw Error(plane_in_words() + ": expected finite numbers of magnitude at most 1e100");
  }
  const double largest = std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (largest == 0.0) {
    throw Error(plane_in_words() + ": its normal is zero: expected a, b or c other than 0");
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const auto scaled = [&](double value) { return std::ldexp(value, -exponent); };
  if (!is_within_limit(scaled(d))) {
    throw Error(plane_in_words() + " is too far from the origin: expected at most 1e100");
  }
  const auto k = static_cast<std::size_t>(n - 1);
  const Point3 normal(scaled(a), scaled(b), scaled(c));
  planes_[k] = {normal, scaled(d) - glm::dot(normal, place_), glm::length(normal), scaled(d)};
  on_ |= 1u << k;
}

void CuttingPlanes::place(const Point3& move) {
  place_ = move;
  for (Plane& plane : planes_) plane.d = plane.as_set - glm::dot(plane.normal, place_);
}

void CuttingPlanes::set_off(int n) {
  require_plane_number(n);
  on_ &= ~(1u << (n - 1));
}

unsigned CuttingPlanes::outcode(const Point3& world) const { return sides(world).outside; }

CuttingPlanes::Sides CuttingPlanes::sides(const Point3& world) const {
  Sides of_point;
  for (unsigned k = 0; k < kMost; ++k) {
    if ((on_ >> k & 1u) == 0) continue;
    const double from_plane = distance(planes_[k], world);
    if (from_plane > 0.0) of_point.inside |= 1u << k;
    if (!(from_plane >= 0.0)) of_point.outside |= 1u << k;
  }
  return of_point;
}

/// Moves a point that is on the plane except for rounding exactly onto it, if the plane is
/// perpendicular to an axis.
void CuttingPlanes::Plane::snap(Point3& p) const {
  for (int i = 0; i < 3; ++i) {
    if (normal[(i + 1) % 3] == 0.0 && normal[(i + 2) % 3] == 0.0) p[i] = -d / normal[i];
  }
}

CuttingPlanes::UnitPlane CuttingPlanes::unit_plane(int n) const {
  const Plane& by = plane(n);
  return {by.normal / by.length, by.d / by.length};
}

CuttingPlanes::Place CuttingPlanes::crossing(int n, const Place& inside,
                                             const Place& outside) const {
  const Plane& by = plane(n);
  const double d_in = std::max(distance(by, inside.position), 0.0);
  const double d_out = distance(by, outside.position);
  if (d_out == 0.0) return outside;
  assert(d_out < 0.0);
  const double t = d_in / (d_in - d_out);
  Place v;
  v.position = inside.position + (outside.position - inside.position) * t;
  by.snap(v.position);
  v.entered = inside.entered + (outside.entered - inside.entered) * t;
  v.normal = inside.normal;
  if (inside.normal != outside.normal) {
    v.normal += (outside.normal - inside.normal) * t;
    if (v.normal == Point3(0.0)) v.normal = inside.normal;
  }
  return v;
}

/// The point where an edge crosses the plane. It is inside of each plane that has both ends inside,
/// despite rounding: a neighbour that shares the edge may run no stage for that plane.
CuttingPlanes::Vertex CuttingPlanes::cut_edge(const Vertex& inside, const Vertex& outside,
                                              int plane) const {
  Vertex v{};
  v.place = crossing(plane + 1, inside.place, outside.place);
  v.outcode = outcode(v.place.position) & (inside.outcode | outside.outcode) & ~(1u << plane);
  return v;
}

CutPolygon CuttingPlanes::cut(std::span<const Point3> world,
                              std::span<const std::uint8_t> edge_visible,
                              std::span<const Point3> normals, std::span<const Point3> entered) {
  assert(edge_visible.empty() || edge_visible.size() == world.size());
  assert(normals.empty() || normals.size() == world.size());
  assert(entered.empty() || entered.size() == world.size());
  Sides of_all;
  in_.clear();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Sides of_point = sides(world[i]);
    of_all.include(of_point);
    in_.push_back({{world[i], normals.empty() ? Point3(0.0) : unit_normal(normals[i]),
                    entered.empty() ? Point3(0.0) : entered[i]},
                   of_point.outside,
                   edge_visible.empty() ? std::uint8_t{1} : edge_visible[i]});
  }
  unsigned any = of_all.outside;
  if (any == 0) return {world, edge_visible, normals, entered};
  if (of_all.leave_nothing()) return {};
  for (int k = 0; k < kMost; ++k) {
    if ((any >> k & 1u) == 0) continue;
    const Plane& by = planes_[static_cast<std::size_t>(k)];
    clip_stage(
        1u << k, in_, out_, [&](const Vertex& v) { return distance(by, v.place.position) <= 0.0; },
        [&](const Vertex& inside, const Vertex& outside) { return cut_edge(inside, outside, k); });
    any = 0;
    for (const Vertex& v : in_) any |= v.outcode;
  }
  if (in_.size() < 3) return {};
  vertices_.clear();
  visible_.clear();
  normals_.clear();
  entered_.clear();
  for (const Vertex& v : in_) {
    vertices_.push_back(v.place.position);
    visible_.push_back(v.edge_visible);
    if (!normals.empty()) normals_.push_back(v.place.normal);
    if (!entered.empty()) entered_.push_back(v.place.entered);
  }
  return {vertices_, visible_, normals_, entered_};
}

bool CuttingPlanes::cut_line(Point3& a, Point3& b) const {
  Sides of_both = sides(a);
  Vertex from{{a, Point3(0.0), {}}, of_both.outside, 1}, to{{b, Point3(0.0), {}}, outcode(b), 1};
  if ((from.outcode | to.outcode) == 0) return true;
  of_both.include(sides(b));
  if (of_both.leave_nothing()) return false;
  for (int k = 0; k < kMost; ++k) {
    if ((from.outcode & to.outcode) != 0) return false;
    if ((from.outcode >> k & 1u) != 0) {
      from = cut_edge(to, from, k);
    } else if ((to.outcode >> k & 1u) != 0) {
      to = cut_edge(from, to, k);
    }
  }
  a = from.place.position;
  b = to.place.position;
  return true;
}

}  // namespace displayfile
