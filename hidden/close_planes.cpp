#include "hidden/close_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace displayfile {

namespace {

/// Unit normals that differ by no more than this in each component may be of planes that are close.
/// They differ by 2^-20 at most in truth: of planes within reach because polygons are kWidths times
/// as wide, of others by definition. What is rounded adds no more, if widths are kRoundings of
/// the largest coordinate, and vertices lie off the plane by no more than kBent of the width.
constexpr double kAngle = 0x1p-18, kWidths = 3.0 * 0x1p20, kRoundings = 0x1p-30, kBent = 0x1p-22;
/// Comparisons of a plane, on average; more take longer than to look at all polygons.
constexpr std::size_t kMostCompared = 64;

/// A polygon's plane in the world, by three of its corners that are far apart.
struct PlaneInWorld {
  Point3 normal, through;
  double size, width;  ///< how far it goes from there at most; the least width of the triangle
  bool is_bent;
};

/// Three corners that are far apart, the first of them the polygon's first.
std::array<std::size_t, 3> spread_corners(std::span<const Point3> points) {
  if (points.size() == 3) return {0, 1, 2};
  std::array<std::size_t, 3> spread{0, 0, 0};
  double farthest = -1.0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Point3 along = points[k] - points[0];
    const double off = glm::dot(along, along);
    if (off > farthest) farthest = off, spread[1] = k;
  }
  const Point3 along = points[spread[1]] - points[0];
  farthest = -1.0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Point3 across = glm::cross(along, points[k] - points[0]);
    const double off = glm::dot(across, across);
    if (off > farthest) farthest = off, spread[2] = k;
  }
  return spread;
}

/// The plane of world points; its width is no number if they are in line.
PlaneInWorld plane_of(std::span<const Point3> points) {
  const std::array<std::size_t, 3> spread = spread_corners(points);
  const Point3 at = points[spread[0]], a = points[spread[1]] - at, b = points[spread[2]] - at,
               c = b - a;
  const Point3 normal = glm::cross(a, b);
  const double twice_area = glm::length(normal);
  const double longest =
      std::sqrt(std::max(std::max(glm::dot(a, a), glm::dot(b, b)), glm::dot(c, c)));
  PlaneInWorld plane{normal / twice_area, at, longest, twice_area / longest, false};
  if (points.size() == 3) return plane;
  double size = 0.0, off = 0.0;  // the squared size
  for (const Point3& p : points) {
    const Point3 to = p - at;
    size = std::max(size, glm::dot(to, to));
    off = std::max(off, std::abs(glm::dot(plane.normal, to)));
  }
  plane.size = std::max(longest, std::sqrt(size));
  plane.is_bent = off > kBent * plane.width;
  return plane;
}

/// Three points of which two are one have no plane; others may have one, however thin it is.
bool has_no_plane(const PointRow& points) {
  return points.size() < 3 ||
         (points.size() == 3 &&
          (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]));
}

bool are_alike(const Point3& a, const Point3& b) {
  const double sign = glm::dot(a, b) < 0.0 ? -1.0 : 1.0;
  const Point3 off = glm::abs(a - sign * b);
  return std::max({off.x, off.y, off.z}) <= kAngle;
}

double longest_column(const glm::dmat4x3& modelling) {
  double longest = 1.0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, glm::length(modelling[k]));
  return longest;
}

}  // namespace

ClosePlanes::ClosePlanes(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of,
                         double reach, double near)
    : polygons_(polygons) {
  is_known_ = enter(polygons, polygon_of, reach, near) && find_touching();
  if (!is_known_) may_touch_ = all();
}

std::vector<std::uint32_t> ClosePlanes::all() const {
  std::vector<std::uint32_t> numbers(polygons_);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

/// False if some polygon's plane is not known well enough.
bool ClosePlanes::enter(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of,
                        double reach, double near) {
  Point3 least(std::numeric_limits<double>::infinity()), most(-least);
  double thinnest = least.x, longest = 1.0, largest_size = 0.0;
  glm::dmat4x3 modelling(1.0);
  std::vector<Point3> through, world;
  planes_.reserve(polygons);
  through.reserve(polygons);
  for (std::uint32_t i = 0; i < polygons; ++i) {
    const EnteredPolygon polygon = polygon_of(i);
    if (has_no_plane(polygon.points)) continue;
    world.clear();
    for (std::size_t k = 0; polygon.modelling != nullptr && k < polygon.points.size(); ++k) {
      world.push_back(polygon.in_world(k));
    }
    const PlaneInWorld plane =
        plane_of(polygon.modelling == nullptr ? polygon.points.row() : std::span(world));
    if (plane.is_bent || !(plane.width > 0.0)) return false;
    thinnest = std::min(thinnest, plane.width);
    if (polygon.modelling != nullptr && *polygon.modelling != modelling) {
      modelling = *polygon.modelling;
      longest = std::max(longest, longest_column(modelling));
    }
    least = glm::min(least, plane.through);
    most = glm::max(most, plane.through);
    largest_size = std::max(largest_size, plane.size);
    planes_.push_back({plane.normal, 0.0, i});
    through.push_back(plane.through);
  }
  if (planes_.empty()) return true;
  const Point3 corner = glm::max(glm::abs(least), glm::abs(most)), size = most - least;
  const double largest = std::max({corner.x, corner.y, corner.z}) + largest_size;
  // No plane was made to go through this point. Two that are close at a polygon are so there.
  const Point3 from = least + Point3(0.6180, 0.2716, 0.4142) * size;
  window_ = 2.0 * kAngle * (glm::length(size) + largest_size) + near * longest;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    planes_[i].off = std::abs(glm::dot(planes_[i].normal, through[i] - from));
  }
  std::ranges::sort(planes_, {}, &Entered::off);
  return thinnest >= std::max(kWidths * reach * longest, kRoundings * largest);
}

/// False if it takes too many comparisons. Planes that are close to no other are left out.
bool ClosePlanes::find_touching() {
  std::vector<Entered> close;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    bool has_one = false;
    const auto look_at = [&](std::size_t j) {
      ++compared;
      has_one = are_alike(planes_[i].normal, planes_[j].normal);
    };
    for (std::size_t j = i + 1; !has_one && j < planes_.size(); ++j) {
      if (planes_[j].off - planes_[i].off > window_) break;
      look_at(j);
    }
    for (std::size_t j = i; !has_one && j-- > 0;) {
      if (planes_[i].off - planes_[j].off > window_) break;
      look_at(j);
    }
    if (compared > kMostCompared * (planes_.size() + 1)) return false;
    if (has_one) close.push_back(planes_[i]);
  }
  planes_ = std::move(close);
  for (const Entered& plane : planes_) may_touch_.push_back(plane.polygon);
  std::ranges::sort(may_touch_);
  return true;
}

/// Polygons in one plane follow each other mostly: they are looked at together, by the first.
std::vector<std::uint32_t> ClosePlanes::near_others(const TouchingPlanes& touching) const {
  if (!is_known_) return all();
  if (planes_.empty()) return {};
  std::vector<std::uint32_t> plane_of = all();
  for (std::size_t k = 0; k < touching.shared_planes(); ++k) {
    const auto members = touching.members(k);
    for (const std::uint32_t polygon : members) plane_of[polygon] = members.front();
  }
  std::vector<std::size_t> first;  // of the runs in one plane, and the end
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const bool goes_on = i > 0 && plane_of[planes_[i - 1].polygon] == plane_of[planes_[i].polygon];
    if (!goes_on) first.push_back(i);
  }
  first.push_back(planes_.size());
  std::vector<std::uint8_t> is_found(first.size(), 0);  // of the runs
  std::size_t compared = 0;
  for (std::size_t a = 0; a + 1 < first.size(); ++a) {
    const Entered &one = planes_[first[a]], &last = planes_[first[a + 1] - 1];
    for (std::size_t b = a + 1; b + 1 < first.size(); ++b) {
      const Entered& other = planes_[first[b]];
      if (other.off - last.off > window_) break;
      if (++compared > kMostCompared * (std::size_t{polygons_} + 1)) return all();
      const bool are_one = plane_of[one.polygon] == plane_of[other.polygon];
      if (are_one || !are_alike(one.normal, other.normal)) continue;
      is_found[a] = is_found[b] = 1;
    }
  }
  std::vector<std::uint32_t> found;
  for (std::size_t run = 0; run + 1 < first.size(); ++run) {
    if (is_found[run] == 0) continue;
    for (std::size_t i = first[run]; i < first[run + 1]; ++i) found.push_back(planes_[i].polygon);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace displayfile
