#include "interp/truth/true_planes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "clip/geometry/back_face.h"

namespace displayfile {

namespace {

double largest(const Point3& d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); }

bool are_in_line(const WholePoint& p, const WholePoint& q, const WholePoint& r) {
  return is_zero(cross(difference(q, p), difference(r, p)));
}

/// The largest magnitude of a coordinate entered in the segment.
double largest_coordinate(const RetainedScene& scene, const RetainedScene::Segment& segment) {
  double most = 0.0;
  for (std::uint32_t i = segment.first; i < segment.end; ++i) {
    for (const Point3& p : scene.entered_points(i)) most = std::max(most, largest(p));
  }
  return most;
}

}  // namespace

std::optional<std::array<std::size_t, 3>> entered_support(std::span<const Point3> v) {
  if (v.size() < 3) return std::nullopt;
  const Point3& p = v[0];
  const auto farthest = [&](auto&& measure) {
    std::size_t best = 0;
    double most = -1.0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const double here = measure(v[i]);
      if (here > most) {
        most = here;
        best = i;
      }
    }
    return best;
  };
  std::size_t q = 1, r = 2;
  if (v.size() > 3) {
    q = farthest([&](const Point3& i) { return largest(i - p); });
    int exponent = 0;
    std::frexp(largest(v[q] - p), &exponent);
    const auto from_p = [&](const Point3& i) {
      const Point3 d = i - p;
      return Point3(std::ldexp(d.x, -exponent), std::ldexp(d.y, -exponent),
                    std::ldexp(d.z, -exponent));
    };
    const Point3 to_q = from_p(v[q]);
    r = farthest([&](const Point3& i) { return largest(glm::cross(to_q, from_p(i))); });
  }
  const WholePoint whole_p = whole(p), whole_q = whole(v[q]);
  if (!are_in_line(whole_p, whole_q, whole(v[r]))) return std::array<std::size_t, 3>{0, q, r};
  if (v.size() == 3) return std::nullopt;
  for (r = 0; r < v.size(); ++r) {
    if (!are_in_line(whole_p, whole_q, whole(v[r]))) return std::array<std::size_t, 3>{0, q, r};
  }
  return std::nullopt;
}

struct TruePlanes::Plane {
  std::uint32_t polygon;
  WholePoint at, normal;
  Integer normal_squared;
};

TruePlanes::TruePlanes(const RetainedScene& scene, const std::optional<Touching>& touching)
    : scene_(scene), touching_(touching) {
  find_placings();
  plane_of_.resize(scene.size());
  std::iota(plane_of_.begin(), plane_of_.end(), 0u);
  find_planes();
}

/// The largest reach of the segments, before the modelling transformation.
double TruePlanes::entered_reach() const {
  constexpr double kUnits = 8.0, kDouble = 0x1p-52;
  double reach = 0.0;
  for (const RetainedScene::Segment& segment : scene_.segments()) {
    const auto [kind, length] = touching_of(segment);
    if (kind == Touching::Kind::length) reach = std::max(reach, length);
    if (kind == Touching::Kind::automatic) {
      reach = std::max(reach, kUnits * kDouble * largest_coordinate(scene_, segment));
    }
  }
  return reach;
}

void TruePlanes::find_placings() {
  const double reach = entered_reach();
  const int places = binary_places(reach);
  const Integer entered = scaled(reach, places);
  const RetainedScene::ModellingMatrix* last = nullptr;
  placing_of_.reserve(scene_.size());
  for (std::uint32_t i = 0; i < scene_.size(); ++i) {
    const RetainedScene::ModellingMatrix& matrix = scene_.modelling_matrix(i);
    if (last == nullptr || *last != matrix) {
      WholeMatrix whole_matrix(matrix);
      Reach of_matrix{entered * entered * whole_matrix.longest_squared(),
                      places + whole_matrix.places()};
      placings_.push_back({std::move(whole_matrix), std::move(of_matrix)});
      last = &matrix;
    }
    placing_of_.push_back(static_cast<std::uint32_t>(placings_.size() - 1));
  }
}

WholePoint TruePlanes::vertex(std::uint32_t polygon, std::size_t corner) const {
  return placed(polygon).matrix.apply(scene_.entered_points(polygon)[corner]);
}

std::optional<std::array<WholePoint, 3>> TruePlanes::own_plane(std::uint32_t polygon) const {
  const PointRow entered = scene_.entered_points(polygon);
  const auto support = entered_support({entered.data(), entered.size()});
  if (!support) return std::nullopt;
  const auto& [p, q, r] = *support;
  std::array points{vertex(polygon, p), vertex(polygon, q), vertex(polygon, r)};
  // A modelling transformation may have made it a line.
  if (are_in_line(points[0], points[1], points[2])) return std::nullopt;
  return points;
}

std::size_t TruePlanes::touching() const {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < plane_of_.size(); ++i) count += plane_of_[i] != i ? 1 : 0;
  return count;
}

namespace {

/// The reach, the greatest distance of a point that lies in a plane, rounded up.
double rounded_up(const Integer& squared, int places) {
  Division division;
  return std::sqrt(division.nearest_double(squared, Integer(1) << bits(2 * places))) * (1.0 + 1e-9);
}

Point3 rounded(const WholePoint& p) {
  Division division;
  const Integer one = Integer(1) << bits(p.places);
  return {division.nearest_double(p.x, one), division.nearest_double(p.y, one),
          division.nearest_double(p.z, one)};
}

/// A vector's direction: each coordinate is off by less than 2^-50.
Point3 direction_of(const WholePoint& d) {
  Division division;
  Integer longest = abs(d.x);
  for (const Integer& n : {d.y, d.z}) {
    if (abs(n) > longest) longest = abs(n);
  }
  const Point3 scaled_down(division.nearest_double(d.x, longest),
                           division.nearest_double(d.y, longest),
                           division.nearest_double(d.z, longest));
  return scaled_down / glm::length(scaled_down);
}

/// A fast test that a point is too far from a plane to lie in it.
struct FarFrom {
  Point3 direction;
  double offset, reach;
};

}  // namespace

/// Assigns planes to polygons in order of decreasing area, equal ones in order of entry: each lies
/// in the first plane found so far that it touches, or else its own is a new one.
void TruePlanes::find_planes() {
  std::vector<std::uint32_t> polygons;
  std::vector<double> area(scene_.size());
  double farthest = 0.0;
  for (std::uint32_t i = 0; i < scene_.size(); ++i) {
    for (const Point3& p : scene_.points(i)) farthest = std::max(farthest, largest(p));
    if (scene_[i].is_line()) continue;
    area[i] = glm::length(newell_normal(scene_.points(i)));
    polygons.push_back(i);
  }
  std::ranges::stable_sort(polygons, std::greater(), [&](std::uint32_t i) { return area[i]; });
  // A distance in doubles is off by less than this: see FarFrom.
  const double error = 0x1p-45 * farthest;
  std::vector<Plane> planes;
  std::vector<FarFrom> far_from;
  for (const std::uint32_t i : polygons) {
    ask_budget();
    if (!own_plane(i)) continue;
    const Point3 first = rounded(vertex(i, 0));
    const Reach& of_polygon = placed(i).reach;
    const double reach = rounded_up(of_polygon.squared, of_polygon.places);
    std::size_t k = 0;
    for (; k < planes.size(); ++k) {
      const auto& [direction, offset, of_plane] = far_from[k];
      const double distance = std::abs(glm::dot(direction, first) - offset);
      if (distance <= std::max(reach, of_plane) + error && lies_in(i, planes[k])) break;
    }
    if (k < planes.size()) {
      plane_of_[i] = planes[k].polygon;
      continue;
    }
    planes.push_back(plane_through(i));
    const Point3 direction = direction_of(planes.back().normal);
    far_from.push_back({direction, glm::dot(direction, rounded(planes.back().at)), reach});
  }
}

TruePlanes::Plane TruePlanes::plane_through(std::uint32_t polygon) const {
  const auto [p, q, r] = *own_plane(polygon);
  Plane plane{polygon, p, cross(difference(q, p), difference(r, p)), 0};
  plane.normal_squared = dot(plane.normal, plane.normal);
  return plane;
}

/// True if the polygon lies in the plane. With the normal n, and s = n . (v - p): s^2 <= reach^2
/// n^2 for each vertex v.
bool TruePlanes::lies_in(std::uint32_t polygon, const Plane& plane) const {
  const Reach &a = placed(polygon).reach, &b = placed(plane.polygon).reach;
  const bool is_b = (b.squared << bits(2 * a.places)) > (a.squared << bits(2 * b.places));
  const Reach& reach = is_b ? b : a;
  const PointRow entered = scene_.entered_points(polygon);
  return std::ranges::all_of(entered, [&](const Point3& v) {
    const WholePoint from = difference(placed(polygon).matrix.apply(v), plane.at);
    const Integer s = dot(plane.normal, from);
    const Integer left = s * s << bits(2 * reach.places);
    return left <= (reach.squared * plane.normal_squared << bits(2 * from.places));
  });
}

}  // namespace displayfile
