#include "displayfile/shapes/swept.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/work_budget.h"
#include "clip/geometry/corners.h"
#include "clip/geometry/unit.h"
#include "clip/view/transformation.h"

namespace displayfile {

namespace {

/// Twice the area, computed about the first point; positive if counterclockwise.
double turning_of_profile(std::span<const Point2> profile) {
  double sum = 0.0;
  for (std::size_t k = 2; k < profile.size(); ++k) {
    const Point2 a = profile[k - 1] - profile[0], b = profile[k] - profile[0];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

void require_profile(std::span<const Point2> profile) {
  if (profile.size() < 3) {
    throw Error(fmt::format("profile of {} points: expected at least 3", profile.size()));
  }
  for (std::size_t k = 0; k < profile.size(); ++k) {
    const Point2& p = profile[k];
    if (!in_range({p, 0.0})) {
      throw Error(fmt::format(
          "point {} of the profile, {} {}: expected finite numbers of magnitude at most 1e100",
          k + 1, p.x, p.y));
    }
    if (p != profile[next_corner(k, profile.size())]) continue;
    throw Error(fmt::format("point {} of the profile, {} {}, is equal to the next: expected none",
                            k + 1, p.x, p.y));
  }
  if (turning_of_profile(profile) == 0.0) throw Error("profile of no area: expected some");
}

/// A profile and its normals, counterclockwise.
struct Profile {
  std::vector<Point2> points, normals;
};

Profile counterclockwise(std::span<const Point2> points, std::span<const Point2> normals = {}) {
  if (turning_of_profile(points) > 0.0) {
    return {{points.begin(), points.end()}, {normals.begin(), normals.end()}};
  }
  return {{points.rbegin(), points.rend()}, {normals.rbegin(), normals.rend()}};
}

/// A direction around the axis, counted in facets.
Point2 around(double facet, int facets) {
  const auto [sine, cosine] = sine_cosine_of_degrees(360.0 * facet / facets);
  return {cosine, sine};
}

/// The polygons between the rings of a profile's points.
class TurnedProfile {
 public:
  TurnedProfile(const Profile& profile, int facets, TurnedLight light)
      : profile_(profile), facets_(facets), light_(light) {
    for (int j = 0; j < facets; ++j) around_.push_back(around(j, facets));
    for (const Point2& p : profile.points) {
      ring_.push_back(static_cast<std::uint32_t>(solid_.vertices.size()));
      if (p.x == 0.0) {
        solid_.vertices.emplace_back(0.0, 0.0, p.y);
      } else {
        for (const Point2& a : around_) solid_.vertices.emplace_back(p.x * a, p.y);
      }
    }
    for (std::size_t k = 0; k < profile.points.size(); ++k) add_side(k);
  }
  ClosedShape take() { return std::move(solid_); }

 private:
  bool on_axis(std::size_t point) const { return profile_.points[point].x == 0.0; }
  std::uint32_t vertex(std::size_t point, int j) const {
    const int place = on_axis(point) ? 0 : j == facets_ ? 0 : j;
    return ring_[point] + static_cast<std::uint32_t>(place);
  }

  /// Adds the profile's side from point p to the next.
  void add_side(std::size_t p) {
    const std::size_t q = next_corner(p, profile_.points.size());
    if (on_axis(p) && on_axis(q)) return;
    const bool is_level = profile_.points[p].y == profile_.points[q].y;
    if (is_level && (on_axis(p) || on_axis(q))) return add_cap(on_axis(p) ? q : p, on_axis(q));
    steps_.step(static_cast<std::size_t>(facets_));
    for (int j = 0; j < facets_; ++j) {
      std::uint32_t sides = 0;
      const auto add = [&](std::size_t point, int at) {
        solid_.corners.push_back(vertex(point, at));
        add_normal(p, q, point, on_axis(point) ? j + 0.5 : at);
        ++sides;
      };
      add(p, j);
      if (!on_axis(p)) add(p, j + 1);
      if (!on_axis(q)) add(q, j + 1);
      add(q, j);
      solid_.sides.push_back(sides);
    }
  }

  /// Adds one polygon across the axis; it faces upward if z grows away from the solid there.
  void add_cap(std::size_t point, bool from_above) {
    for (int j = 0; j < facets_; ++j) {
      solid_.corners.push_back(vertex(point, from_above ? j : facets_ - 1 - j));
      if (light_ != TurnedLight::facets) solid_.normals.emplace_back(0.0);
    }
    solid_.sides.push_back(static_cast<std::uint32_t>(facets_));
  }

  /// Adds the normal of a corner of the side from p to q.
  void add_normal(std::size_t p, std::size_t q, std::size_t point, double facet) {
    if (light_ == TurnedLight::facets) return;
    const Point2 along = profile_.points[q] - profile_.points[p];
    const Point2 n = light_ == TurnedLight::smooth ? profile_.normals[point]
                                                   : Point2(unit(Point3(along.y, -along.x, 0.0)));
    solid_.normals.emplace_back(n.x * around(facet, facets_), n.y);
  }

  const Profile& profile_;
  int facets_;
  TurnedLight light_;
  std::vector<Point2> around_;
  std::vector<std::uint32_t> ring_;  // the first vertex of each point's
  ClosedShape solid_;
  WorkSteps steps_;
};

}  // namespace

ClosedShape extruded(std::span<const Point2> profile, double z_min, double z_max) {
  require_profile(profile);
  if (!(z_min < z_max) || !in_range({z_min, z_max, 0.0})) {
    throw Error(fmt::format("extruded from z {} to {}: expected finite numbers, z-min < z-max",
                            z_min, z_max));
  }
  const std::vector<Point2> points = counterclockwise(profile).points;
  const auto n = static_cast<std::uint32_t>(points.size());
  ClosedShape solid;
  for (const double z : {z_min, z_max}) {
    for (const Point2& p : points) solid.vertices.emplace_back(p, z);
  }
  for (std::uint32_t k = 0; k < n; ++k) solid.corners.push_back(n - 1 - k);
  for (std::uint32_t k = 0; k < n; ++k) solid.corners.push_back(n + k);
  solid.sides = {n, n};
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = next_corner(k, n);
    solid.add({k, next, n + next, n + k});
  }
  return solid;
}

void require_facets(int facets) {
  if (facets >= kFewestFacets && facets <= kMostFacets) return;
  throw Error(fmt::format("{} facets: expected {} to {}", facets, kFewestFacets, kMostFacets));
}

ClosedShape turned(std::span<const Point2> profile, int facets, TurnedLight light,
                   std::span<const Point2> normals) {
  require_facets(facets);
  require_profile(profile);
  for (std::size_t k = 0; k < profile.size(); ++k) {
    if (profile[k].x >= 0.0) continue;
    throw Error(fmt::format("point {} of the profile is at {} from the axis: expected 0 or more",
                            k + 1, profile[k].x));
  }
  const std::size_t polygons = profile.size() * static_cast<std::size_t>(facets);
  constexpr std::size_t kBytes = 2 * sizeof(Point3) + 5 * sizeof(std::uint32_t);
  return with_memory(
      polygons * kBytes, [&] { return fmt::format("a shape of {} polygons", polygons); },
      [&] {
        const Profile solid = counterclockwise(profile, normals);
        return TurnedProfile(solid, facets, light).take();
      });
}

}  // namespace displayfile
