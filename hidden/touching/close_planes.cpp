#include "hidden/touching/close_planes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "hidden/exact/entered_plane.h"
#include "hidden/exact/rounding.h"
#include "hidden/touching/planes_in_reach.h"

namespace displayfile {

namespace {

/// Unit normals that differ by at most this in each component may belong to close planes. The true
/// difference is at most 2^-20: for planes within reach since polygons are at least kWidths times
/// as wide as the reach, for others by definition. Rounding adds no more, if widths are at least
/// kRoundings of the largest coordinate.
constexpr double kAngle = 0x1p-18, kWidths = 3.0 * 0x1p20, kRoundings = 0x1p-30;
/// Bounds the errors of a point, of a difference of two points, and of their contribution to a
/// normal, each as a fraction of the largest sum that gives a coordinate, several times over.
/// Underflow adds less than kTiny.
constexpr double kRoundingOfPoints = 0x1p-46;
/// Maximum comparisons per plane, on average; more take longer than comparing all polygons.
constexpr std::size_t kMostCompared = 64;

/// A polygon's support plane in the world.
struct PlaneInWorld {
  Point3 normal, through;
  double size, width;  ///< the polygon's extent from `through`; the support triangle's least height
};

/// A collinear triangle's width may be 0 or NaN.
PlaneInWorld plane_of(std::span<const Point3> points, const std::array<std::size_t, 3>& support) {
  const auto& [p, q, r] = support;
  const Point3 at = points[p], a = points[q] - at, b = points[r] - at, c = b - a;
  const Point3 normal = glm::cross(a, b);
  const double twice_area = glm::length(normal);
  const double longest =
      std::sqrt(std::max(std::max(glm::dot(a, a), glm::dot(b, b)), glm::dot(c, c)));
  PlaneInWorld plane{normal / twice_area, at, longest, twice_area / longest};
  if (points.size() == 3) return plane;
  double squared = 0.0;
  for (const Point3& v : points) squared = std::max(squared, glm::dot(v - at, v - at));
  plane.size = std::max(longest, std::sqrt(squared));
  return plane;
}

/// Nothing for a polygon without a plane. A triangle's three points may be collinear nevertheless.
std::optional<std::array<std::size_t, 3>> quick_support(const PointRow& points) {
  if (points.size() != 3) return support_of_entered(points.row());
  if (points[0] == points[1] || points[1] == points[2] || points[2] == points[0]) return {};
  return std::array<std::size_t, 3>{0, 1, 2};
}

bool are_alike(const Point3& a, const Point3& b) {
  const double sign = glm::dot(a, b) < 0.0 ? -1.0 : 1.0;
  const Point3 off = glm::abs(a - sign * b);
  return std::max({off.x, off.y, off.z}) <= kAngle;
}

/// The largest sum of magnitudes that gives a world coordinate.
double sum_of_products(const glm::dmat4x3& m, const Point3& p) {
  double most = 0.0;
  for (int k = 0; k < 3; ++k) {
    most = std::max(most, std::abs(m[0][k] * p.x) + std::abs(m[1][k] * p.y) +
                              std::abs(m[2][k] * p.z) + std::abs(m[3][k]));
  }
  return most;
}

/// True for triangles on opposite sides of a shared side: viewing keeps the line where their planes
/// meet.
bool meet_at_a_side(const EnteredPolygon& a, const EnteredPolygon& b) {
  if (a.points.size() != 3 || b.points.size() != 3) return false;
  if (a.modelling != b.modelling) return false;
  const auto other_corner = [](const PointRow& points, const PointRow& others) {
    std::size_t at = 3;
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::ranges::find(others, points[k]) != others.end()) continue;
      if (at != 3) return std::size_t{3};
      at = k;
    }
    return at;
  };
  const std::size_t of_a = other_corner(a.points, b.points),
                    of_b = other_corner(b.points, a.points);
  if (of_a == 3 || of_b == 3) return false;
  const Point3 &p = a.points[(of_a + 1) % 3], &q = a.points[(of_a + 2) % 3];
  const auto turn = [&](const Point3& v) { return glm::cross(q - p, v - p); };
  return glm::dot(turn(a.points[of_a]), turn(b.points[of_b])) < 0.0;
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
  is_known_ = enter(polygons, polygon_of, reach, near) && find_touching(polygon_of);
  if (is_known_) return;
  auto in_reach = planes_in_reach(polygons, polygon_of, reach);
  may_touch_ = in_reach ? std::move(in_reach->polygons) : all();
  if (in_reach) pairs_ = std::move(in_reach->pairs);
}

std::vector<std::uint32_t> ClosePlanes::all() const {
  std::vector<std::uint32_t> numbers(polygons_);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

/// False if some polygon's plane is not known accurately enough.
bool ClosePlanes::enter(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of,
                        double reach, double near) {
  Point3 least(std::numeric_limits<double>::infinity()), most(-least);
  double thinnest = least.x, longest = 1.0, largest_size = 0.0, largest_sum = 0.0;
  glm::dmat4x3 modelling(1.0);
  std::vector<Point3> through, world;
  planes_.reserve(polygons);
  through.reserve(polygons);
  for (std::uint32_t i = 0; i < polygons; ++i) {
    const EnteredPolygon polygon = polygon_of(i);
    const auto support = quick_support(polygon.points);
    if (!support) continue;
    world.clear();
    for (std::size_t k = 0; polygon.modelling != nullptr && k < polygon.points.size(); ++k) {
      world.push_back(polygon.in_world(k));
      largest_sum = std::max(largest_sum, sum_of_products(*polygon.modelling, polygon.points[k]));
    }
    const PlaneInWorld plane =
        plane_of(polygon.modelling == nullptr ? polygon.points.row() : std::span(world), *support);
    if (!(plane.width > 0.0)) {
      if (!support_of_entered(polygon.points.row())) continue;
      return false;
    }
    thinnest = std::min(thinnest, plane.width);
    if (polygon.modelling != nullptr && *polygon.modelling != modelling) {
      modelling = *polygon.modelling;
      longest = std::max(longest, longest_column(modelling));
    }
    if (!(thinnest >= kWidths * reach * longest)) return false;
    least = glm::min(least, plane.through);
    most = glm::max(most, plane.through);
    largest_size = std::max(largest_size, plane.size);
    planes_.push_back({plane.normal, 0.0, i, Distance::far});
    through.push_back(plane.through);
  }
  if (planes_.empty()) return true;
  const Point3 corner = glm::max(glm::abs(least), glm::abs(most)), size = most - least;
  const double largest = std::max({corner.x, corner.y, corner.z}) + largest_size;
  // An arbitrary point, which no plane is meant to contain. Planes close at a polygon are close
  // there.
  const Point3 from = least + Point3(0.6180, 0.2716, 0.4142) * size;
  reach_ = reach * longest;
  near_ = near * longest;
  rounding_ = kRoundingOfPoints * std::max(largest, largest_sum);
  window_ = 2.0 * kAngle * (glm::length(size) + largest_size) + near_;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    planes_[i].off = std::abs(glm::dot(planes_[i].normal, through[i] - from));
  }
  std::ranges::sort(planes_, {}, &Entered::off);
  return thinnest >= std::max(kWidths * reach_, kRoundings * largest);
}

/// The distance of a polygon from the other's plane: all of its vertices may be that close.
ClosePlanes::Distance ClosePlanes::distance_from(const EnteredPolygon& plane,
                                                 const EnteredPolygon& polygon) const {
  const auto support = support_of_entered(plane.points.row());
  if (!support) return Distance::far;
  const Point3 at = plane.in_world((*support)[0]), a = plane.in_world((*support)[1]) - at,
               b = plane.in_world((*support)[2]) - at, normal = glm::cross(a, b);
  const double twice_area = glm::length(normal);
  double off = 0.0, size = 0.0;
  for (std::size_t k = 0; k < polygon.points.size(); ++k) {
    const Point3 to = polygon.in_world(k) - at;
    off = std::max(off, std::abs(glm::dot(normal, to)));
    size = std::max(size, glm::dot(to, to));
  }
  // The error of a coordinate of the normal is at most the rounding error times this length.
  const double longest = std::sqrt(std::max(glm::dot(a, a), glm::dot(b, b)));
  const double rounded =
      rounding_ * (twice_area + 2.0 * longest * (std::sqrt(size) + near_)) + kTiny;
  if (!(off > reach_ * twice_area + rounded)) return Distance::touching;
  return off > near_ * twice_area + rounded ? Distance::far : Distance::near;
}

/// The smaller distance of either polygon from the other's plane.
ClosePlanes::Distance ClosePlanes::distance_of(const EnteredPolygon& a,
                                               const EnteredPolygon& b) const {
  const Distance from_a = distance_from(a, b);
  if (from_a == Distance::touching) return from_a;
  const Distance nearer = std::min(from_a, distance_from(b, a));
  return nearer == Distance::near && meet_at_a_side(a, b) ? Distance::far : nearer;
}

/// False if it takes too many comparisons. Removes planes that are close to no other.
bool ClosePlanes::find_touching(const TouchingPlanes::PolygonOf& polygon_of) {
  std::size_t compared = 0;
  const auto look_at = [&](Entered& a, Entered& b) {
    ++compared;
    if (!are_alike(a.normal, b.normal)) return;
    const Distance distance = distance_of(polygon_of(a.polygon), polygon_of(b.polygon));
    a.nearest = std::min(a.nearest, distance);
    b.nearest = std::min(b.nearest, distance);
  };
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    Entered& plane = planes_[i];
    for (std::size_t j = i + 1; plane.nearest != Distance::touching && j < planes_.size(); ++j) {
      if (planes_[j].off - plane.off > window_) break;
      look_at(plane, planes_[j]);
    }
    for (std::size_t j = i; plane.nearest != Distance::touching && j-- > 0;) {
      if (plane.off - planes_[j].off > window_) break;
      // Touching planes have not been compared with all planes above them, and maybe not with this
      // one.
      if (planes_[j].nearest == Distance::touching) look_at(plane, planes_[j]);
    }
    if (compared > kMostCompared * (planes_.size() + 1)) return false;
  }
  std::erase_if(planes_, [](const Entered& plane) { return plane.nearest == Distance::far; });
  for (const Entered& plane : planes_) {
    if (plane.nearest == Distance::touching) may_touch_.push_back(plane.polygon);
  }
  std::ranges::sort(may_touch_);
  return true;
}

/// Polygons in one plane are mostly consecutive: such a run is represented by its first.
std::vector<std::uint32_t> ClosePlanes::near_others(const TouchingPlanes& touching) const {
  if (!is_known_) return all();
  if (planes_.empty()) return {};
  assert(std::ranges::is_sorted(planes_, {}, &Entered::off));
  std::vector<std::uint32_t> plane_of = all();
  for (std::size_t k = 0; k < touching.shared_planes(); ++k) {
    const auto members = touching.members(k);
    for (const std::uint32_t polygon : members) plane_of[polygon] = members.front();
  }
  std::vector<std::size_t> first;  // of the runs in one plane; and the end
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const bool goes_on = i > 0 && plane_of[planes_[i - 1].polygon] == plane_of[planes_[i].polygon];
    if (!goes_on) first.push_back(i);
  }
  first.push_back(planes_.size());
  std::vector<std::uint8_t> is_found(first.size(), 0);  // per run
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
