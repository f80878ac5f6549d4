#include "hidden/touching_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "clip/back_face.h"
#include "clip/work_budget.h"
#include "hidden/number_set.h"
#include "hidden/plane_tree.h"

namespace displayfile {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Pays for the rounding of a tolerance's own computation.
constexpr double kWider = 1.0 + 0x1p-40;

}  // namespace

/// While the planes are looked for. Polygons that have a plane are numbered anew, in order of
/// entry: by their own planes, in `own`.
class TouchingPlanes::Search {
 public:
  Search(TouchingPlanes& result, const PolygonOf& polygon_of)
      : result_(result), polygon_of_(polygon_of) {}

  void enter(std::uint32_t polygons);
  void find_planes();
  void keep(std::uint32_t polygons);

 private:
  /// What it takes to compare a polygon with planes in doubles.
  struct Tolerance {
    double key;   ///< the plane's distance from one fixed point
    double wide;  ///< by how much more or less the key of a plane that it touches may be
  };
  struct Ranked {
    double key;
    std::uint32_t own;
  };
  /// Recently used planes, made ready; one of them for each remainder.
  struct Ready {
    std::uint32_t own = kNone;
    std::optional<EnteredPlane> plane;
  };

  std::uint32_t modelling_of(const EnteredPolygon& polygon);
  void measure();
  void find_frame();
  double estimate(std::uint32_t own);
  void rank_by_key();
  void find_plane(std::uint32_t own);
  std::size_t look_among_neighbours(std::uint32_t own, std::size_t most);
  void look_in_tree(std::uint32_t own);
  void build_tree();
  void found(std::uint32_t own);
  void consider(std::uint32_t plane, std::uint32_t own);
  bool comes_before(std::uint32_t a, std::uint32_t b) const {
    return area_[a] > area_[b] || (area_[a] == area_[b] && a < b);
  }
  bool passes_near(std::uint32_t plane) const;
  bool touches(std::uint32_t own, std::uint32_t plane);
  const EnteredPlane& ready(std::uint32_t plane);
  void keep_members(const std::vector<std::uint32_t>& sharing);
  Point3 in_frame(const Point3& world) const { return (world - centre_) * scale_; }

  TouchingPlanes& result_;
  const PolygonOf& polygon_of_;
  std::vector<OwnPlane> own_;
  std::vector<std::uint32_t> sides_;
  std::vector<double> area_;
  std::vector<std::uint32_t> taken_;  // the plane that each lies in

  // A frame in which all points lie between -1 and 1.
  Point3 low_{kInfinity}, high_{-kInfinity}, centre_{0.0};
  double scale_ = 1.0, magnitude_ = 0.0, rounding_ = 0x1p-52;
  double point_error_ = 0.0, reach_ = 0.0, diameter_ = 0.0;

  std::vector<PlaneTree::Plane> planes_;  // in the frame
  std::vector<Tolerance> tolerance_;
  double largest_radius_ = 0.0, near_ = 0.0;
  std::vector<Ranked> ranked_;
  std::vector<std::uint32_t> rank_;
  std::optional<NumberSet> founders_;  // by rank
  std::vector<std::uint32_t> linked_;
  std::optional<PlaneTree> tree_;
  std::uint64_t looked_at_ = 0;
  WorkSteps steps_;

  std::array<Point3, 3> corners_;  // of the polygon that is looked for, in the frame
  std::uint32_t first_plane_ = kNone;
  std::vector<Ready> ready_;
};

std::uint32_t TouchingPlanes::Search::modelling_of(const EnteredPolygon& polygon) {
  std::vector<Modelling>& all = result_.modellings_;
  if (all.empty() || !all.back().is_of(polygon.modelling)) {
    all.emplace_back(polygon.modelling, result_.reach_);
  }
  return static_cast<std::uint32_t>(all.size() - 1);
}

/// Takes the polygons' own planes, areas and bounds.
void TouchingPlanes::Search::enter(std::uint32_t polygons) {
  std::vector<Point3> world;
  for (std::uint32_t i = 0; i < polygons; ++i) {
    steps_.step();
    const EnteredPolygon polygon = polygon_of_(i);
    const std::span<const Point3> points(polygon.points.data(), polygon.points.size());
    const auto support = support_of_entered(points);
    if (!support) continue;
    const std::uint32_t number = modelling_of(polygon);
    const Modelling& modelling = result_.modellings_[number];
    const auto& [p, q, r] = *support;
    const EnteredPlane::Corners corners{points[p], points[q], points[r]};
    if (modelling.is_singular() && modelling.puts_in_line(corners[0], corners[1], corners[2])) {
      continue;
    }
    world.clear();
    for (const Point3& v : points) {
      world.push_back(modelling.apply(v));
      magnitude_ = std::max(magnitude_, modelling.magnitude(v));
      low_ = glm::min(low_, world.back());
      high_ = glm::max(high_, world.back());
    }
    own_.push_back({corners, i, number});
    sides_.push_back(static_cast<std::uint32_t>(points.size()));
    area_.push_back(glm::length(newell_normal(world)));
    taken_.push_back(static_cast<std::uint32_t>(taken_.size()));
  }
}

void TouchingPlanes::Search::find_planes() {
  if (own_.empty()) return;
  find_frame();
  measure();
  rank_by_key();
  std::ranges::sort(linked_, [&](std::uint32_t a, std::uint32_t b) { return comes_before(a, b); });
  ready_.resize(std::min<std::size_t>(1024, own_.size()));
  for (const std::uint32_t own : linked_) find_plane(own);
}

void TouchingPlanes::Search::find_frame() {
  rounding_ = is_double_double_sound() ? 0x1p-53 : 0x1p-52;
  centre_ = 0.5 * low_ + 0.5 * high_;
  const Point3 half = glm::max(high_ - centre_, centre_ - low_);
  int exponent = 0;
  std::frexp(std::max({half.x, half.y, half.z}) * (1.0 + 0x1p-50), &exponent);
  scale_ = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  for (const Modelling& modelling : result_.modellings_) {
    reach_ = std::max(reach_, modelling.reach().high);
  }
  reach_ *= scale_ * kWider;
  // Of what is off, the length. Three roundings of a sum are 3.01 of a coordinate.
  const double world_error = 5.3 * rounding_ * magnitude_ * scale_;
  point_error_ = world_error + 2.0 * rounding_;
  diameter_ = 3.5 + 4.0 * world_error;
}

void TouchingPlanes::Search::measure() {
  planes_.resize(own_.size());
  tolerance_.resize(own_.size());
  for (std::uint32_t k = 0; k < own_.size(); ++k) {
    largest_radius_ = std::max(largest_radius_, estimate(k));
  }
  for (Tolerance& tolerance : tolerance_) tolerance.wide += largest_radius_;
  near_ = (reach_ + largest_radius_) * kWider;
}

/// The plane in the frame, and its key; returns by how much the key may be off.
double TouchingPlanes::Search::estimate(std::uint32_t own) {
  const OwnPlane& plane = own_[own];
  const Modelling& modelling = result_.modellings_[plane.modelling];
  const Point3 p = modelling.apply(plane.corners[0]);
  const Point3 u = (modelling.apply(plane.corners[1]) - p) * scale_;
  const Point3 v = (modelling.apply(plane.corners[2]) - p) * scale_;
  const double error = modelling.is_identity() ? 0.0 : point_error_;
  const double a = glm::length(u), b = glm::length(v);
  Point3 normal = glm::cross(u, v);
  const double length = glm::length(normal);
  const double off =
      (2.1 * error * (a + b) + 6.0 * rounding_ * a * b + 5.0 * error * error) * kWider;
  const double relative = length > 0x1p-450 ? off / length : kInfinity;
  double radius = kInfinity, wide = kInfinity;
  if (relative <= 0.125) {
    normal /= length;
    radius = (2.0 * relative + 8.0 * rounding_) * diameter_;
    const double tilt = 2.0 * reach_ * (a + b + 4.0 * error) / (length * (1.0 - relative)) * kWider;
    if (tilt <= 0.5) wide = 1.5 * tilt * diameter_ + reach_;
  }
  if (!(radius <= std::max(16.0 * reach_, 0x1p-32))) {
    const EnteredPlane exact(plane.corners, modelling);
    if (exact.normal_error() * diameter_ < radius) {
      normal = exact.normal();
      radius = exact.normal_error() * diameter_;
    }
  }
  if (!(radius <= diameter_)) {
    normal = Point3(1.0, 0.0, 0.0);
    radius = kInfinity;
  }
  radius = (radius + 2.0 * point_error_ + 24.0 * rounding_) * kWider;
  // Far from whatever a scene is made of; which side of it a plane has does not matter.
  constexpr Point3 kFrom(0.5719, -0.8327, 0.4113);
  const double distance = glm::dot(normal, in_frame(p)), from = glm::dot(normal, kFrom);
  planes_[own] =
      from < 0.0 ? PlaneTree::Plane(-normal, -distance) : PlaneTree::Plane(normal, distance);
  tolerance_[own] = {std::abs(from - distance), (wide + radius) * kWider};
  return radius;
}

/// Puts planes in order of their keys. Where no other key is within a polygon's tolerance, it lies
/// in its own plane; the others remain to be looked at.
void TouchingPlanes::Search::rank_by_key() {
  for (std::uint32_t k = 0; k < own_.size(); ++k) ranked_.push_back({tolerance_[k].key, k});
  std::ranges::sort(ranked_, [](const Ranked& a, const Ranked& b) {
    return a.key != b.key ? a.key < b.key : a.own < b.own;
  });
  rank_.resize(own_.size());
  founders_.emplace(own_.size());
  for (std::size_t k = 0; k < ranked_.size(); ++k) {
    const auto [key, own] = ranked_[k];
    rank_[own] = static_cast<std::uint32_t>(k);
    const double wide = tolerance_[own].wide;
    const bool is_linked = (k > 0 && !(key - ranked_[k - 1].key > wide)) ||
                           (k + 1 < ranked_.size() && !(ranked_[k + 1].key - key > wide));
    if (is_linked) {
      linked_.push_back(own);
    } else {
      founders_->insert(k);
    }
  }
}

/// The first plane that the polygon lies in, or else its own is a new one.
void TouchingPlanes::Search::find_plane(std::uint32_t own) {
  constexpr std::size_t kFew = 64;         // are compared sooner than the tree is searched
  constexpr std::uint64_t kPatience = 64;  // comparisons a plane, about what a tree costs to build
  const Modelling& modelling = result_.modellings_[own_[own].modelling];
  for (std::size_t k = 0; k < 3; ++k) {
    corners_[k] = in_frame(modelling.apply(own_[own].corners[k]));
  }
  first_plane_ = kNone;
  const std::size_t most = tree_ ? kFew : std::numeric_limits<std::size_t>::max();
  const std::size_t looked_at = look_among_neighbours(own, most);
  if (looked_at == most) look_in_tree(own);
  looked_at_ += looked_at;
  steps_.step(looked_at + 1);
  if (first_plane_ == kNone) {
    found(own);
  } else {
    taken_[own] = first_plane_;
  }
  if (!tree_ && looked_at_ > kPatience * own_.size()) build_tree();
}

/// Compares the polygon with founded planes whose keys are within its tolerance; returns how many,
/// or `most`, if there are more.
std::size_t TouchingPlanes::Search::look_among_neighbours(std::uint32_t own, std::size_t most) {
  const std::size_t rank = rank_[own];
  const auto [key, wide] = tolerance_[own];
  std::size_t count = 0;
  for (std::size_t k = founders_->before(rank); k != NumberSet::kNone; k = founders_->before(k)) {
    if (key - ranked_[k].key > wide) break;
    if (count++ == most) return most;
    consider(ranked_[k].own, own);
  }
  for (std::size_t k = founders_->after(rank); k != NumberSet::kNone; k = founders_->after(k)) {
    if (ranked_[k].key - key > wide) break;
    if (count++ == most) return most;
    consider(ranked_[k].own, own);
  }
  return count;
}

void TouchingPlanes::Search::build_tree() {
  tree_.emplace(planes_);
  if (founders_->contains(0)) tree_->insert(ranked_[0].own, area_[ranked_[0].own]);
  for (std::size_t k = founders_->after(0); k != NumberSet::kNone; k = founders_->after(k)) {
    tree_->insert(ranked_[k].own, area_[ranked_[k].own]);
  }
}

void TouchingPlanes::Search::look_in_tree(std::uint32_t own) {
  const auto best_area = [&] { return first_plane_ == kNone ? area_[own] : area_[first_plane_]; };
  const std::size_t looked_at =
      tree_->visit_near(corners_, near_, best_area(), [&](std::uint32_t plane) {
        consider(plane, own);
        return best_area();
      });
  result_.counts_.compared += looked_at;
  steps_.step(looked_at);
}

void TouchingPlanes::Search::found(std::uint32_t own) {
  founders_->insert(rank_[own]);
  if (tree_) tree_->insert(own, area_[own]);
}

/// Takes a founded plane if it is the first so far that the polygon lies in.
void TouchingPlanes::Search::consider(std::uint32_t plane, std::uint32_t own) {
  ++result_.counts_.compared;
  if (!comes_before(plane, first_plane_ == kNone ? own : first_plane_)) return;
  if (passes_near(plane) && touches(own, plane)) first_plane_ = plane;
}

bool TouchingPlanes::Search::passes_near(std::uint32_t plane) const {
  const PlaneTree::Plane& n = planes_[plane];
  for (const Point3& v : corners_) {
    if (std::abs(n.x * v.x + n.y * v.y + n.z * v.z - n.w) > near_) return false;
  }
  return true;
}

/// None of the polygon's vertices is farther from the plane than the reach, exactly.
bool TouchingPlanes::Search::touches(std::uint32_t own, std::uint32_t plane) {
  ++result_.counts_.tested;
  const EnteredPlane& of = ready(plane);
  const Modelling& modelling = result_.modellings_[own_[own].modelling];
  const auto is_reached = [&](const Point3& v) { return of.reaches(v, modelling); };
  if (!std::ranges::all_of(own_[own].corners, is_reached)) return false;
  if (sides_[own] == 3) return true;
  const EnteredPolygon polygon = polygon_of_(own_[own].polygon);
  return std::ranges::all_of(polygon.points, is_reached);
}

const EnteredPlane& TouchingPlanes::Search::ready(std::uint32_t plane) {
  Ready& ready = ready_[plane % ready_.size()];
  if (ready.own != plane) {
    ready.plane.emplace(own_[plane].corners, result_.modellings_[own_[plane].modelling]);
    ready.own = plane;
  }
  return *ready.plane;
}

/// Keeps the planes that polygons lie in, and which polygons share one.
void TouchingPlanes::Search::keep(std::uint32_t polygons) {
  std::vector<std::uint32_t> number(own_.size(), kNone);
  result_.plane_.assign(polygons, kNone);
  std::vector<std::uint32_t> sharing(own_.size(), 0);
  for (std::uint32_t k = 0; k < own_.size(); ++k) {
    if (taken_[k] == k) {
      number[k] = static_cast<std::uint32_t>(result_.planes_.size());
      result_.planes_.push_back(own_[k]);
    } else {
      ++sharing[taken_[k]];
      ++result_.touching_;
    }
  }
  for (std::uint32_t k = 0; k < own_.size(); ++k) {
    result_.plane_[own_[k].polygon] = number[taken_[k]];
  }
  keep_members(sharing);
}

/// `sharing`: of each plane how many polygons lie in it besides its own.
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
  result_.first_member_.push_back(first);
  for (const std::uint32_t k : linked_) {
    if (taken_[k] != k) result_.members_[next[taken_[k]]++] = own_[k].polygon;
  }
}

TouchingPlanes::TouchingPlanes(std::uint32_t polygons, const PolygonOf& polygon_of, double reach)
    : reach_(reach) {
  Search search(*this, polygon_of);
  search.enter(polygons);
  if (reach > 0.0) search.find_planes();
  search.keep(polygons);
}

bool TouchingPlanes::lies_in(const Point3& entered, const glm::dmat4x3* modelling,
                             std::uint32_t polygon) const {
  if (plane_[polygon] == kNone) return false;
  const OwnPlane& plane = planes_[plane_[polygon]];
  const Modelling& of_plane = modellings_[plane.modelling];
  const EnteredPlane ready(plane.corners, of_plane);
  if (of_plane.is_of(modelling)) return ready.reaches(entered, of_plane);
  return ready.reaches(entered, Modelling(modelling, reach_));
}

std::size_t TouchingPlanes::bytes() const {
  const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
  return size(modellings_) + size(planes_) + size(plane_) + size(first_member_) + size(members_);
}

}  // namespace displayfile
