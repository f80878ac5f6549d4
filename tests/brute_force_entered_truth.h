#pragma once

#include <glm/geometric.hpp>

#include "clip/geometry/back_face.h"
#include "clip/geometry/unit.h"
#include "clip/surfaces.h"
#include "tests/brute_force_world_truth.h"

// The result of interp/truth/entered_truth.h, in rationals, literally by the definition: each
// polygon against each plane, without a filter; and then ray by ray.

namespace displayfile::test {

class BruteForceEnteredTruth : public BruteForceWorldTruth {
 public:
  BruteForceEnteredTruth(const RetainedScene& scene, const DisplayFile& file, int width, int height,
                         const Touching& touching = {})
      : BruteForceWorldTruth(width, height) {
    find_planes(scene, touching);
    for (const RetainedScene::Segment& part : scene.segments()) {
      const displayfile::Segment& segment = file.segment(part.name);
      if (!segment.visible) continue;
      const ViewVolume volume(part.view);
      const Looking look{volume, part.view, segment.image};
      for (std::uint32_t i = part.first; i < part.end; ++i) {
        const bool is_solid =
            !scene[i].is_line() && scene.attributes(i).fill.kind == FillStyle::Kind::solid;
        if (is_solid) enter(scene, i, look);
      }
    }
  }

  std::size_t touching() const { return touching_; }

 private:
  struct Found {
    std::vector<Place> places;
    std::array<std::size_t, 3> support;
    bool has_plane = false;
    std::size_t plane_of;
    Q reach_squared;
    double area = 0.0;
  };

  static Place minus(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static Place across(const Place& a, const Place& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  static Q product(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Place exactly(const Point3& p) { return {Q(p.x), Q(p.y), Q(p.z)}; }
  static bool in_line(const Place& a, const Place& b, const Place& c) {
    return across(minus(b, a), minus(c, a)) == Place{0, 0, 0};
  }
  static double most(double x, double y, double z) {
    return std::max({std::abs(x), std::abs(y), std::abs(z)});
  }

  /// By the measures of the definition, in doubles.
  static std::optional<std::array<std::size_t, 3>> spread(std::span<const Point3> v) {
    std::size_t q = 1, r = 2;
    if (v.size() > 3) {
      const Point3 p = v[0];
      q = 0;
      double farthest = 0.0;
      for (std::size_t i = 1; i < v.size(); ++i) {
        const double here = most(v[i].x - p.x, v[i].y - p.y, v[i].z - p.z);
        if (here > farthest) farthest = here, q = i;
      }
      double unit = 1.0;
      while (farthest > 0.0 && farthest / unit >= 1.0) unit *= 2.0;
      while (farthest > 0.0 && farthest / unit < 0.5) unit /= 2.0;
      const auto from_p = [&](std::size_t i) {
        return Point3((v[i].x - p.x) / unit, (v[i].y - p.y) / unit, (v[i].z - p.z) / unit);
      };
      const Point3 a = from_p(q);
      r = 0;
      double largest = 0.0;
      for (std::size_t i = 1; i < v.size(); ++i) {
        const Point3 b = from_p(i);
        const double here =
            most(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
        if (here > largest) largest = here, r = i;
      }
    }
    for (std::size_t tried = 0; tried <= v.size(); ++tried) {
      if (!in_line(exactly(v[0]), exactly(v[q]), exactly(v[r]))) return {{0, q, r}};
      if (v.size() == 3 || tried == v.size()) break;
      r = tried;
    }
    return std::nullopt;
  }

  void find_planes(const RetainedScene& scene, const Touching& touching) {
    Q largest = 0;
    for (std::uint32_t i = 0; i < scene.size(); ++i) {
      for (const Point3& p : scene.entered_points(i)) {
        largest = std::max({largest, Q(std::abs(p.x)), Q(std::abs(p.y)), Q(std::abs(p.z))});
      }
    }
    Q reach = 0;
    if (touching.kind == Touching::Kind::automatic) reach = largest * 8 * Q(0x1p-52);
    if (touching.kind == Touching::Kind::length) reach = Q(touching.length);
    std::vector<std::size_t> order;
    for (std::uint32_t i = 0; i < scene.size(); ++i) {
      found_.push_back(place(scene, i, reach));
      if (found_.back().has_plane) order.push_back(i);
    }
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return found_[a].area > found_[b].area; });
    std::vector<std::size_t> planes;
    for (const std::size_t i : order) {
      const auto plane = std::ranges::find_if(planes, [&](std::size_t k) { return lies_in(i, k); });
      if (plane == planes.end()) {
        planes.push_back(i);
      } else {
        found_[i].plane_of = *plane;
        ++touching_;
      }
    }
  }

  static Found place(const RetainedScene& scene, std::uint32_t i, const Q& reach) {
    Found found;
    found.plane_of = i;
    if (scene[i].is_line()) return found;
    const glm::dmat4x3& m = scene.modelling_matrix(i);
    const PointRow entered = scene.entered_points(i);
    for (const Point3& p : entered) {
      Place& world = found.places.emplace_back();
      for (std::size_t row = 0; row < 3; ++row) {
        const int r = static_cast<int>(row);
        world[row] = Q(m[0][r]) * Q(p.x) + Q(m[1][r]) * Q(p.y) + Q(m[2][r]) * Q(p.z) + Q(m[3][r]);
      }
    }
    Q longest = 0;
    for (int column = 0; column < 3; ++column) {
      const Place c = exactly(m[column]);
      longest = std::max(longest, product(c, c));
    }
    found.reach_squared = reach * reach * longest;
    const auto support = spread({entered.data(), entered.size()});
    if (!support) return found;
    found.support = *support;
    const auto& [p, q, r] = found.support;
    found.has_plane = !in_line(found.places[p], found.places[q], found.places[r]);
    found.area = glm::length(newell_normal(scene.points(i)));
    return found;
  }

  bool lies_in(std::size_t i, std::size_t plane) const {
    const Found& of = found_[plane];
    const Place& at = of.places[of.support[0]];
    const Place normal =
        across(minus(of.places[of.support[1]], at), minus(of.places[of.support[2]], at));
    const Q reach = std::max(found_[i].reach_squared, of.reach_squared);
    return std::ranges::all_of(found_[i].places, [&](const Place& v) {
      const Q s = product(normal, minus(v, at));
      return s * s <= reach * product(normal, normal);
    });
  }

  void enter(const RetainedScene& scene, std::uint32_t i, const Looking& look) {
    const Found& found = found_[i];
    Polygon polygon = seen_through(look, scene[i].pick);
    for (const Place& p : found.places) polygon.vertices.push_back(vertex(look, p));
    if (scene.attributes(i).back_face_removal && turned_away(polygon)) return;
    if (!found.has_plane) return;
    polygon.support = found.support;
    const Found& of = found_[found.plane_of];
    const auto at = [&](std::size_t k) { return vertex(look, of.places[of.support[k]]); };
    polygon.plane = {at(0), at(1), at(2)};
    const auto& [a, b, c] = *polygon.plane;
    if (picture_determinant(a, b, c) == 0) polygon.plane.reset();
    polygons_.push_back(polygon);
  }

  std::vector<Found> found_;  // by primitive
  std::size_t touching_ = 0;
};

}  // namespace displayfile::test
