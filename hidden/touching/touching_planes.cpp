#include "hidden/touching/touching_planes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/round_to_nearest.h"
#include "clip/base/work_budget.h"
#include "clip/geometry/back_face.h"
#include "hidden/exact/entered_plane.h"
#include "hidden/touching/key_grid.h"
#include "hidden/touching/plane_tree.h"

namespace displayfile {

namespace {

constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// Covers the rounding in the computation of a tolerance.
constexpr double kWider = 1.0 + 0x1p-40;

/// A point near the frame's centre, and directions of lengths below 1 (the first one's is 1.1),
/// with no special relation to any scene.
constexpr Point3 kFrom(0.0572, -0.0833, 0.0411), kToward(0.5719, -0.8327, 0.4113);
constexpr std::array kAlong{Point3(0.6682, 0.3787, -0.6257), Point3(-0.3525, 0.6323, 0.6750)};

std::vector<std::uint32_t> all_of(std::uint32_t polygons) {
  std::vector<std::uint32_t> numbers(polygons);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

}  // namespace

/// The state of the search. Polygons that have a plane are renumbered in order of entry, as indices
/// of their own planes in `own_`.
class TouchingPlanes::Search {
 public:
  Search(TouchingPlanes& result, const PolygonOf& polygon_of, double reach)
      : result_(result), polygon_of_(polygon_of), entered_reach_(reach) {}

  void enter(std::span<const std::uint32_t> polygons);
  void find_planes();
  /// The same, by comparing these pairs of the entered polygons.
  void find_planes(std::span<const std::uint32_t> polygons, std::span<const Pair> pairs);
  void keep(std::uint32_t polygons);

 private:
  using Plane = PlaneTree::Plane;
  /// A polygon's own plane.
  struct OwnPlane {
    EnteredPlane::Corners corners;
    std::uint32_t polygon, modelling;
  };
  /// A plane in the frame, in doubles.
  struct Estimate {
    Plane plane{0.0};
    double radius = 0.0;  ///< error bound of the distance of a scene's point from it
    double tilt = 0.0;    ///< bound on the sine of the angle to smaller polygons that touch it
  };
  /// The best known approximation of a plane.
  struct Known {
    Plane plane;
    double radius;
    bool is_close;  ///< as accurate as doubles allow
  };
  static constexpr std::size_t kMostReady = 1024;
  /// Recently used planes, prepared for exact tests.
  struct Ready {
    std::uint32_t own = kNone;
    std::optional<EnteredPlane> plane;
  };

  std::uint32_t modelling_of(const EnteredPolygon& polygon);
  void set_order();
  void find_frame();
  Estimate find_estimate(const OwnPlane& own);
  void find_keys();
  Estimate estimate(const OwnPlane& plane) const;
  Estimate estimate_closely(const EnteredPlane& plane, const OwnPlane& own) const;
  Plane in_frame(const Point3& normal, const Point3& through) const;
  KeyGrid::Keys keys_of(const Plane& plane) const;
  bool keys_are_near(std::uint32_t own, std::uint32_t other) const;

  void take_corners(std::uint32_t own);
  void find_plane(std::uint32_t own);
  bool look_in_grid(std::uint32_t own);
  std::uint64_t most_compared() const;
  bool look_at_all(std::uint32_t own);
  void look_in_tree(std::uint32_t own);
  void build_tree();
  void found(std::uint32_t own);
  void consider(std::uint32_t plane, std::uint32_t own);
  bool comes_before(std::uint32_t a, std::uint32_t b) const {
    return area_[a] > area_[b] || (area_[a] == area_[b] && a < b);
  }
  const Known& known_closely(std::uint32_t own);
  /// How close a plane passes to the corners of the current polygon.
  enum class Passage : std::uint8_t { within_reach, near, beyond };
  Passage passage(const Known& plane) const;
  bool touches(std::uint32_t own, std::uint32_t plane);
  const EnteredPlane& ready(std::uint32_t plane);
  void keep_members(const std::vector<std::uint32_t>& sharing);
  Point3 in_frame(const Point3& world) const { return (world - centre_) * scale_; }

  TouchingPlanes& result_;
  const PolygonOf& polygon_of_;
  double entered_reach_;
  std::vector<Modelling> modellings_;
  std::vector<OwnPlane> own_;
  std::vector<std::uint32_t> sides_;
  std::vector<double> area_;
  std::vector<std::uint32_t> taken_;  // per polygon, the plane in which it lies

  // A frame in which all points lie between -1 and 1.
  Point3 low_{kNoBound}, high_{-kNoBound}, centre_{0.0};
  double scale_ = 1.0, magnitude_ = 0.0, rounding_ = 0x1p-52;
  double point_error_ = 0.0, reach_ = 0.0, least_reach_ = 0.0, diameter_ = 0.0, farthest_ = 0.0,
         close_radius_ = 0.0;

  std::vector<KeyGrid::Keys> keys_;
  std::vector<double> wide_;  // tolerance of the keys of planes in which it may lie
  std::optional<KeyGrid> grid_;
  std::vector<std::uint32_t> order_;    // the definition's order
  std::vector<std::uint32_t> founded_;  // planes that polygons lie in, in the same order
  std::vector<Known> known_;
  std::optional<PlaneTree> tree_;
  WorkSteps steps_;

  std::array<Point3, 3> corners_;  // of the current polygon, in the frame
  std::uint32_t first_plane_ = kNone;
  std::vector<Ready> ready_;
};

std::uint32_t TouchingPlanes::Search::modelling_of(const EnteredPolygon& polygon) {
  if (modellings_.empty() || !modellings_.back().is_of(polygon.modelling)) {
    modellings_.emplace_back(polygon.modelling, entered_reach_);
  }
  return static_cast<std::uint32_t>(modellings_.size() - 1);
}

/// Enters the polygons' own planes, areas and bounds.
void TouchingPlanes::Search::enter(std::span<const std::uint32_t> polygons) {
  std::vector<Point3> world;
  own_.reserve(polygons.size());
  sides_.reserve(polygons.size());
  area_.reserve(polygons.size());
  for (const std::uint32_t i : polygons) {
    steps_.step();
    const EnteredPolygon polygon = polygon_of_(i);
    const std::span<const Point3> points(polygon.points.data(), polygon.points.size());
    const auto support = support_of_entered(points);
    if (!support) continue;
    const std::uint32_t number = modelling_of(polygon);
    const Modelling& modelling = modellings_[number];
    const auto& [p, q, r] = *support;
    const EnteredPlane::Corners corners{points[p], points[q], points[r]};
    if (modelling.is_singular() && modelling.puts_in_line(corners[0], corners[1], corners[2])) {
      continue;
    }
    std::span<const Point3> in_world = points;
    if (!modelling.is_identity()) {
      world.clear();
      Point3 most(0.0);
      for (const Point3& v : points) {
        world.push_back(modelling.apply(v));
        most = glm::max(most, glm::abs(v));
      }
      magnitude_ = std::max(magnitude_, modelling.magnitude(most));
      in_world = world;
    }
    for (const Point3& v : in_world) {
      low_ = glm::min(low_, v);
      high_ = glm::max(high_, v);
    }
    own_.push_back({corners, i, number});
    sides_.push_back(static_cast<std::uint32_t>(points.size()));
    area_.push_back(glm::length(newell_normal(in_world)));
  }
}

void TouchingPlanes::Search::find_planes() {
  taken_.resize(own_.size());
  std::iota(taken_.begin(), taken_.end(), 0u);
  if (own_.empty()) return;
  find_frame();
  find_keys();
  grid_.emplace(wide_);
  set_order();
  ready_.resize(std::min(kMostReady, own_.size()));
  for (const std::uint32_t own : order_) find_plane(own);
}

void TouchingPlanes::Search::find_planes(std::span<const std::uint32_t> polygons,
                                         std::span<const Pair> pairs) {
  taken_.resize(own_.size());
  std::iota(taken_.begin(), taken_.end(), 0u);
  if (own_.empty()) return;
  find_frame();
  known_.reserve(own_.size());
  for (const OwnPlane& own : own_) find_estimate(own);
  set_order();
  ready_.resize(std::min(kMostReady, own_.size()));
  std::vector<std::uint32_t> own_of(polygons.size(), kNone);
  for (std::uint32_t i = 0, k = 0; i < polygons.size() && k < own_.size(); ++i) {
    if (own_[k].polygon == polygons[i]) own_of[i] = k++;
  }
  std::vector<std::uint32_t> first(own_.size() + 1, 0), planes(pairs.size());  // by polygon
  for (const Pair& pair : pairs) {
    if (own_of[pair.polygon] != kNone) ++first[own_of[pair.polygon]];
  }
  for (std::uint32_t sum = 0; std::uint32_t & end : first) end = sum += end;
  for (const Pair& pair : pairs) {
    if (own_of[pair.polygon] != kNone) planes[--first[own_of[pair.polygon]]] = own_of[pair.plane];
  }
  for (const std::uint32_t own : order_) {
    take_corners(own);
    first_plane_ = kNone;
    steps_.step(first[own + 1] - first[own] + 1);
    for (std::uint32_t k = first[own]; k < first[own + 1]; ++k) {
      ++result_.counts_.compared;
      const std::uint32_t plane = planes[k];
      if (plane != kNone && taken_[plane] == plane) consider(plane, own);
    }
    if (first_plane_ != kNone) taken_[own] = first_plane_;
  }
}

/// Sorts by comes_before: a radix sort of the areas, whose bits increase with them, in stable
/// steps, so that equal areas stay in order of entry.
void TouchingPlanes::Search::set_order() {
  constexpr int kBits = 11;
  constexpr std::uint64_t kDigits = 1u << kBits;
  std::vector<std::uint32_t> before(own_.size());
  order_.resize(own_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  for (int shift = 0; shift < 64; shift += kBits) {
    const auto digit = [&](std::uint32_t k) {
      const std::uint64_t bits = ~std::bit_cast<std::uint64_t>(area_[k]);
      return static_cast<std::size_t>(bits >> shift & (kDigits - 1));
    };
    std::array<std::uint32_t, kDigits> next{};
    for (const std::uint32_t k : order_) ++next[digit(k)];
    if (next[digit(0)] == order_.size()) continue;
    std::uint32_t first = 0;
    for (std::uint32_t& count : next) first += std::exchange(count, first);
    std::swap(before, order_);
    for (const std::uint32_t k : before) order_[next[digit(k)]++] = k;
  }
}

void TouchingPlanes::Search::find_frame() {
  rounding_ = is_double_double_sound() ? 0x1p-53 : 0x1p-52;
  centre_ = 0.5 * low_ + 0.5 * high_;
  const Point3 half = glm::max(high_ - centre_, centre_ - low_);
  int exponent = 0;
  std::frexp(std::max({half.x, half.y, half.z}) * (1.0 + 0x1p-50), &exponent);
  scale_ = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  for (const Modelling& modelling : modellings_) {
    reach_ = std::max(reach_, modelling.reach().high);
  }
  least_reach_ = modellings_.front().reach().low * scale_ / kWider;
  reach_ *= scale_ * kWider;
  // A world coordinate has an error of up to 3.01 roundings of a sum.
  const double world_error = 5.3 * rounding_ * magnitude_ * scale_;
  point_error_ = world_error + 2.0 * rounding_;
  diameter_ = 3.5 + 4.0 * world_error;
  farthest_ = 1.875 + 4.0 * world_error;
  close_radius_ = std::max(16.0 * reach_, 0x1p-45);
}

/// A plane in the frame, with its normal oriented toward a fixed direction.
TouchingPlanes::Search::Plane TouchingPlanes::Search::in_frame(const Point3& normal,
                                                               const Point3& through) const {
  const double distance = glm::dot(normal, in_frame(through));
  return glm::dot(normal, kToward) < 0.0 ? Plane(-normal, -distance) : Plane(normal, distance);
}

/// Two cosines of the plane's normal, multiplied by `farthest_` like their tolerance, and its
/// distance.
KeyGrid::Keys TouchingPlanes::Search::keys_of(const Plane& plane) const {
  const Point3 normal(plane);
  return {farthest_ * std::abs(glm::dot(normal, kAlong[0])),
          farthest_ * std::abs(glm::dot(normal, kAlong[1])),
          std::abs(glm::dot(normal, kFrom) - plane.w)};
}

TouchingPlanes::Search::Estimate TouchingPlanes::Search::estimate(const OwnPlane& own) const {
  const Modelling& modelling = modellings_[own.modelling];
  const Point3 p = modelling.apply(own.corners[0]);
  const Point3 u = (modelling.apply(own.corners[1]) - p) * scale_;
  const Point3 v = (modelling.apply(own.corners[2]) - p) * scale_;
  const double error = modelling.is_identity() ? 0.0 : point_error_;
  const double a = glm::length(u), b = glm::length(v);
  const Point3 normal = glm::cross(u, v);
  const double length = glm::length(normal);
  const double off =
      (2.1 * error * (a + b) + 6.0 * rounding_ * a * b + 5.0 * error * error) * kWider;
  const double relative = length > 0x1p-450 ? off / length : kNoBound;
  if (!(relative <= 0.125)) return {in_frame(Point3(1.0, 0.0, 0.0), p), kNoBound, kNoBound};
  const double radius =
      ((2.0 * relative + 8.0 * rounding_) * diameter_ + 2.0 * point_error_ + 24.0 * rounding_) *
      kWider;
  const double longest = std::max({a, b, glm::length(u - v)});
  const double tilt = 2.0 * reach_ * (longest + 8.0 * error) / (length * (1.0 - relative)) * kWider;
  return {in_frame(normal / length, p), radius, tilt};
}

TouchingPlanes::Search::Estimate TouchingPlanes::Search::estimate_closely(
    const EnteredPlane& plane, const OwnPlane& own) const {
  const Point3 p = modellings_[own.modelling].apply(own.corners[0]);
  const double off = plane.normal_error();
  if (!(off <= 1.0)) return {in_frame(Point3(1.0, 0.0, 0.0), p), kNoBound, kNoBound};
  const double radius = (off * diameter_ + 2.0 * point_error_ + 24.0 * rounding_) * kWider;
  return {in_frame(plane.normal(), p), radius, kNoBound};
}

/// Finds the estimate of the next plane and stores it as known.
TouchingPlanes::Search::Estimate TouchingPlanes::Search::find_estimate(const OwnPlane& own) {
  constexpr double kGood = 0x1p-32;  // few planes have keys this close by chance
  steps_.step();
  Estimate of = estimate(own);
  if (!(of.radius <= std::max(close_radius_, kGood))) {
    const EnteredPlane plane(own.corners, modellings_[own.modelling]);
    const Estimate close = estimate_closely(plane, own);
    if (close.radius < of.radius) {
      of.plane = close.plane;
      of.radius = close.radius;
    }
  }
  known_.push_back({of.plane, of.radius, of.radius <= close_radius_});
  return of;
}

/// Finds the keys of planes, and their tolerances.
void TouchingPlanes::Search::find_keys() {
  keys_.reserve(own_.size());
  wide_.reserve(own_.size());
  known_.reserve(own_.size());
  double largest_radius = 0.0;
  for (const OwnPlane& own : own_) {
    const auto [plane, radius, tilt] = find_estimate(own);
    keys_.push_back(keys_of(plane));
    const double wide = tilt <= 0.5 ? (tilt + tilt * tilt) * farthest_ + reach_ : kNoBound;
    wide_.push_back((wide + radius) * kWider);
    largest_radius = std::max(largest_radius, radius);
  }
  for (double& wide : wide_) wide += largest_radius;
}

/// True if the other plane's keys are within the polygon's tolerance.
bool TouchingPlanes::Search::keys_are_near(std::uint32_t own, std::uint32_t other) const {
  const KeyGrid::Keys &a = keys_[own], &b = keys_[other];
  const double wide = wide_[own];
  return !(std::abs(a[0] - b[0]) > wide) && !(std::abs(a[1] - b[1]) > wide) &&
         !(std::abs(a[2] - b[2]) > wide);
}

void TouchingPlanes::Search::take_corners(std::uint32_t own) {
  const Modelling& modelling = modellings_[own_[own].modelling];
  for (std::size_t k = 0; k < 3; ++k) {
    corners_[k] = in_frame(modelling.apply(own_[own].corners[k]));
  }
}

/// Finds the first plane in which the polygon lies, or founds a new one, its own.
void TouchingPlanes::Search::find_plane(std::uint32_t own) {
  take_corners(own);
  first_plane_ = kNone;
  if (!look_in_grid(own) && !look_at_all(own)) look_in_tree(own);
  if (first_plane_ == kNone) {
    found(own);
  } else {
    taken_[own] = first_plane_;
  }
  if (!tree_ && result_.counts_.compared > most_compared()) build_tree();
}

/// About the cost of a tree.
std::uint64_t TouchingPlanes::Search::most_compared() const {
  constexpr std::uint64_t kPatience = 32;  // comparisons per polygon
  return kPatience * own_.size();
}

/// Compares the polygon with founded planes in order. False if that may take longer than a tree.
bool TouchingPlanes::Search::look_at_all(std::uint32_t own) {
  if (tree_ || result_.counts_.compared + founded_.size() > most_compared()) return false;
  for (const std::uint32_t plane : founded_) {
    ++result_.counts_.compared;
    steps_.step();
    consider(plane, own);
    if (first_plane_ != kNone) break;
  }
  return true;
}

/// Compares the polygon with founded planes whose keys are within its tolerance. False if there are
/// so many that searching the tree, or all planes, is faster.
bool TouchingPlanes::Search::look_in_grid(std::uint32_t own) {
  constexpr std::size_t kFew = 64;
  if (!grid_->has_size_for(wide_[own])) return false;
  std::size_t visited = 0;
  const std::size_t most = tree_ ? kFew : own_.size();
  grid_->visit_near(keys_[own], wide_[own], [&](std::uint32_t plane) {
    if (visited == most) return false;
    ++visited;
    if (keys_are_near(own, plane)) consider(plane, own);
    return true;
  });
  result_.counts_.compared += visited;
  steps_.step(visited + 1);
  return visited < most;
}

void TouchingPlanes::Search::build_tree() {
  std::vector<Plane> planes;
  planes.reserve(own_.size());
  for (std::uint32_t k = 0; k < own_.size(); ++k) planes.push_back(known_[k].plane);
  tree_.emplace(planes);
  for (const std::uint32_t k : founded_) {
    const Known& plane = known_closely(k);
    tree_->insert(k, plane.plane, plane.radius, area_[k]);
  }
}

void TouchingPlanes::Search::look_in_tree(std::uint32_t own) {
  if (!tree_) build_tree();
  const auto best_area = [&] { return area_[first_plane_ == kNone ? own : first_plane_]; };
  const std::size_t looked_at =
      tree_->visit_near(corners_, reach_, best_area(), [&](std::uint32_t plane) {
        ++result_.counts_.compared;
        consider(plane, own);
        return best_area();
      });
  result_.counts_.compared += looked_at;
  steps_.step(looked_at);
}

/// Founds the polygon's own plane: other polygons may lie in it.
void TouchingPlanes::Search::found(std::uint32_t own) {
  founded_.push_back(own);
  grid_->insert(own, keys_[own]);
  if (!tree_) return;
  const Known& plane = known_closely(own);
  tree_->insert(own, plane.plane, plane.radius, area_[own]);
}

/// Takes a founded plane if the polygon lies in it and it is the first such plane so far.
void TouchingPlanes::Search::consider(std::uint32_t plane, std::uint32_t own) {
  if (!comes_before(plane, first_plane_ == kNone ? own : first_plane_)) return;
  Passage passage = this->passage(known_[plane]);
  if (passage == Passage::near && !known_[plane].is_close) {
    passage = this->passage(known_closely(plane));
  }
  if (passage == Passage::beyond) return;
  const bool is_triangle_in_reach = passage == Passage::within_reach && sides_[own] == 3;
  if (is_triangle_in_reach || touches(own, plane)) first_plane_ = plane;
}

const TouchingPlanes::Search::Known& TouchingPlanes::Search::known_closely(std::uint32_t own) {
  Known& plane = known_[own];
  if (!plane.is_close) {
    const Estimate of = estimate_closely(ready(own), own_[own]);
    if (of.radius < plane.radius) plane = {of.plane, of.radius, true};
    plane.is_close = true;
  }
  return plane;
}

/// By the estimate and its radius. Only returns within_reach if all polygons have the same matrix.
TouchingPlanes::Search::Passage TouchingPlanes::Search::passage(const Known& known) const {
  const Plane& n = known.plane;
  const double near = (reach_ + known.radius) * kWider;
  bool is_within = modellings_.size() == 1;
  for (const Point3& v : corners_) {
    const double off = std::abs(n.x * v.x + n.y * v.y + n.z * v.z - n.w);
    if (off > near) return Passage::beyond;
    is_within = is_within && (off + known.radius) * kWider < least_reach_;
  }
  return is_within ? Passage::within_reach : Passage::near;
}

/// True if no vertex of the polygon is farther from the plane than the reach, exactly.
bool TouchingPlanes::Search::touches(std::uint32_t own, std::uint32_t plane) {
  ++result_.counts_.tested;
  const EnteredPlane& of = ready(plane);
  const Modelling& modelling = modellings_[own_[own].modelling];
  const auto is_reached = [&](const Point3& v) { return of.reaches(v, modelling); };
  if (sides_[own] == 3) return std::ranges::all_of(own_[own].corners, is_reached);
  const EnteredPolygon polygon = polygon_of_(own_[own].polygon);
  return std::ranges::all_of(polygon.points, is_reached);
}

const EnteredPlane& TouchingPlanes::Search::ready(std::uint32_t plane) {
  Ready& ready = ready_[plane % ready_.size()];
  if (ready.own != plane) {
    ready.plane.emplace(own_[plane].corners, modellings_[own_[plane].modelling]);
    ready.own = plane;
  }
  return *ready.plane;
}

/// Stores in whose plane each polygon lies, and the polygons that share each.
void TouchingPlanes::Search::keep(std::uint32_t polygons) {
  std::vector<std::uint32_t> sharing(own_.size(), 0);
  for (const std::uint32_t k : order_) {
    if (taken_[k] == k) continue;
    ++sharing[taken_[k]];
    ++result_.touching_;
  }
  keep_members(sharing);
  result_.plane_.assign(polygons, kNone);
  for (std::uint32_t k = 0; k < own_.size(); ++k) {
    assert(taken_[taken_[k]] == taken_[k]);
    result_.plane_[own_[k].polygon] = own_[taken_[k]].polygon;
  }
}

/// `sharing`: for each plane the number of other polygons that lie in it.
void TouchingPlanes::Search::keep_members(const std::vector<std::uint32_t>& sharing) {
  if (result_.touching_ == 0) return;
  std::vector<std::uint32_t> shared;
  for (std::uint32_t k = 0; k < own_.size(); ++k) {
    if (sharing[k] > 0) shared.push_back(k);
  }
  std::ranges::sort(shared, [&](std::uint32_t a, std::uint32_t b) { return comes_before(a, b); });
  std::vector<std::uint32_t> next(own_.size());
  result_.members_.resize(result_.touching_ + shared.size());
  std::uint32_t first = 0;
  for (const std::uint32_t plane : shared) {
    result_.first_member_.push_back(first);
    result_.members_[first] = own_[plane].polygon;
    next[plane] = first + 1;
    first += sharing[plane] + 1;
  }
  assert(first == result_.members_.size());
  result_.first_member_.push_back(first);
  for (const std::uint32_t k : order_) {
    if (taken_[k] != k) result_.members_[next[taken_[k]]++] = own_[k].polygon;
  }
}

TouchingPlanes::TouchingPlanes(std::uint32_t polygons, const PolygonOf& polygon_of, double reach)
    : TouchingPlanes(polygons, all_of(polygons), polygon_of, reach) {}

TouchingPlanes::TouchingPlanes(std::uint32_t polygons, std::span<const std::uint32_t> looked_at,
                               const PolygonOf& polygon_of, double reach,
                               const std::vector<Pair>* pairs) {
  assert(std::ranges::is_sorted(looked_at) && (looked_at.empty() || looked_at.back() < polygons));
  const RoundToNearest mode;
  Search search(*this, polygon_of, reach);
  search.enter(looked_at);
  pairs == nullptr ? search.find_planes() : search.find_planes(looked_at, *pairs);
  search.keep(polygons);
}

void TouchingPlanes::keep_members_alone() {
  plane_ = decltype(plane_)();  // assigning {} would keep the memory
}

}  // namespace displayfile
