#include "hidden/touching/planes_in_reach.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <limits>
#include <span>

#include "clip/base/round_to_nearest.h"
#include "clip/geometry/bounds.h"
#include "hidden/exact/entered_plane.h"
#include "hidden/touching/planes_in_row.h"

namespace displayfile {

namespace {

constexpr float kAnyTurn = std::numeric_limits<float>::infinity();

/// Bounds the errors of a point, of a difference of two, and of a cross product of two differences
/// over the longer one, as a fraction of the largest sum of magnitudes that gives a coordinate.
constexpr double kRoundingInWorld = 0x1p-46;
/// Covers the rounding of bounds.
constexpr double kOfRounding = 1.0 + 0x1p-20;
/// Normals with a larger error bound are unknown.
constexpr double kMostUncertain = 0.25;

/// Three directions of length 1, orthogonal up to 2^-12, with no special relation to any scene.
/// Normals are oriented toward the first one.
constexpr Point3 kOneSide(0.5242, -0.7633, 0.3770);
constexpr std::array<std::array<float, 3>, 2> kCosines{
    {{0.8290F, 0.5593F, -0.0202F}, {-0.1954F, 0.3231F, 0.9260F}}};
constexpr float kLongest = 1.01F;

/// In single precision, u = 2^-24: the errors of a normal, and of a point and a distance relative
/// to the farthest, are u; the sums of a distance add three. Cosines of two normals differ by up to
/// 16 u more than the true ones, including the keys of cells.
constexpr double kFloatRounding = 0x1p-20;
constexpr float kFloatTolerance = 0x1p-19F;

/// A polygon's three support corners and their plane, in the frame and in single precision.
struct PlaneInReach {
  std::array<std::array<float, 3>, 3> corners;
  PlanesInRow::Plane plane;  ///< its normal has length 1
  float per_height;          ///< the longest side over twice the area; infinite if unknown
  std::uint32_t polygon;

  std::array<float, 3> middle() const {
    constexpr float kThird = 1.0F / 3.0F;
    std::array<float, 3> middle;
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] = (corners[0][k] + corners[1][k] + corners[2][k]) * kThird;
    }
    return middle;
  }
};

/// The maximum differences of a polygon's own plane from other planes in which it lies.
struct Tolerance {
  float normal, distance;
};

std::size_t runs_length(std::span<const PlanesInRow::Run> runs) {
  std::size_t length = 0;
  for (const PlanesInRow::Run& run : runs) length += run.end - run.begin;
  return length;
}

/// Cells of one size over normals and distances of planes, in lists by a hash. The planes of a list
/// are consecutive, and so are the lists of cells adjacent along the distance.
class PlaneCells {
 public:
  using Run = PlanesInRow::Run;

  /// Cells are `side` wide along two cosines of the normal, and `side` times `per_distance` along
  /// the distance. `planes` is the maximum number of planes.
  PlaneCells(std::size_t planes, float side, float per_distance)
      : per_cosine_(1.0F / side),
        per_distance_(1.0F / (side * per_distance)),
        shift_(64 - std::countr_zero(std::bit_ceil(std::max<std::size_t>(planes, 2)))),
        first_((std::size_t{1} << (64 - shift_)) + 1, 0) {
    lists_.reserve(planes);
  }

  /// Counts a plane; called for all planes first, in order.
  void count(const PlaneInReach& plane) {
    const Keys at = in_cells(plane.plane.normal, plane.plane.distance);
    const std::size_t list = list_of(base_of(index(at.x), index(at.y)), index(at.z));
    lists_.push_back(static_cast<std::uint32_t>(list));
    ++first_[list];
  }
  void begin_lists() {
    std::uint32_t end = 0;
    for (std::uint32_t& first : first_) first = end += first;  // the ends of lists, until `place`
  }
  /// The place of a plane; called after begin_lists, from the last plane to the first.
  std::uint32_t place(std::uint32_t plane) { return --first_[lists_[plane]]; }

  /// The cells of all planes within a tolerance of a normal and a distance.
  struct Range {
    std::int32_t first_x, last_x, first_y, last_y, first_z, last_z;
  };
  Range range(const PlanesInRow::Plane& plane, const Tolerance& tolerance) const {
    const Keys at = in_cells(plane.normal, plane.distance);
    const float wide = tolerance.normal * kLongest * per_cosine_,
                deep = tolerance.distance * per_distance_;
    return {index(at.x - wide), index(at.x + wide), index(at.y - wide),
            index(at.y + wide), index(at.z - deep), index(at.z + deep)};
  }
  /// Adds runs that contain all planes in these cells, and others.
  void find_runs(const Range& range, std::vector<Run>& runs) const {
    for (std::int32_t x = range.first_x; x <= range.last_x; ++x) {
      for (std::int32_t y = range.first_y; y <= range.last_y; ++y) {
        find_lists(base_of(x, y), range.first_z, range.last_z, runs);
      }
    }
  }

  /// For a range of at most two cells along each axis: the first of each two consecutive lists that
  /// together contain all planes in these cells. Avoids unpredictable branches, and prefetches what
  /// `run` reads.
  using Lists = std::array<std::uint32_t, 4>;
  std::optional<Lists> find_lists(const Range& range) const {
    if (range.last_x - range.first_x > 1 || range.last_y - range.first_y > 1 ||
        range.last_z - range.first_z > 1) {
      return std::nullopt;
    }
    const std::uint64_t mixed = this->mixed(range.first_x, range.first_y);
    Lists lists;
    std::size_t last = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint64_t other = mixed + (k % 2) * kOfX + (k / 2) * kOfY;
      const std::size_t list = list_of(static_cast<std::size_t>(other >> shift_), range.first_z);
      __builtin_prefetch(&first_[list]);
      lists[k] = static_cast<std::uint32_t>(list);
      last = std::max(last, list);
    }
    return last + 2 < first_.size() ? std::optional(lists) : std::nullopt;
  }
  Run run(std::uint32_t list) const { return {first_[list], first_[list + 2]}; }

 private:
  struct Keys {
    float x, y, z;
  };
  /// An offset that makes all numbers positive, so that truncation rounds them down.
  static constexpr float kAbove = 0x1p20F;
  static std::int32_t index(float at) { return static_cast<std::int32_t>(at + kAbove); }
  Keys in_cells(const std::array<float, 3>& n, float distance) const {
    const auto cosine = [&](const std::array<float, 3>& along) {
      return (n[0] * along[0] + n[1] * along[1] + n[2] * along[2]) * per_cosine_;
    };
    return {cosine(kCosines[0]), cosine(kCosines[1]), distance * per_distance_};
  }
  static constexpr std::uint64_t kOfX = 0x9e3779b97f4a7c15u, kOfY = 0xc2b2ae3d27d4eb4fu;
  static std::uint64_t mixed(std::int32_t x, std::int32_t y) {
    return static_cast<std::uint32_t>(x) * kOfX + static_cast<std::uint32_t>(y) * kOfY;
  }
  std::size_t base_of(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(mixed(x, y) >> shift_);
  }
  std::size_t list_of(std::size_t base, std::int32_t z) const {
    return (base + static_cast<std::uint32_t>(z)) & (first_.size() - 2);
  }
  void find_lists(std::size_t base, std::int32_t first_z, std::int32_t last_z,
                  std::vector<Run>& runs) const {
    const std::size_t lists = first_.size() - 1;
    for (std::int64_t left = std::int64_t{last_z} - first_z + 1; left > 0;) {
      const std::size_t list = list_of(base, last_z - static_cast<std::int32_t>(left - 1));
      const std::size_t end = std::min(lists, list + static_cast<std::size_t>(left));
      if (first_[list] < first_[end]) runs.push_back({first_[list], first_[end]});
      left -= static_cast<std::int64_t>(end - list);
    }
  }

  float per_cosine_, per_distance_;
  int shift_;
  std::vector<std::uint32_t> first_;  // of each list
  std::vector<std::uint32_t> lists_;  // of the planes, in order
};

/// The search, step by step.
class PlanesInReach {
 public:
  PlanesInReach(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of, double reach)
      : polygons_(polygons), polygon_of_(polygon_of), entered_reach_(reach) {}

  std::optional<MayTouch> find() {
    if (!enter_some() && !enter_all()) return std::nullopt;
    if (!leave_out_unknown()) return std::nullopt;
    find_cells();
    if (!look_in_cells()) return std::nullopt;
    return found();
  }

 private:
  bool enter_some() { return set_frame(polygons_ / kSome + 1) && enter(); }
  bool enter_all() { return set_frame(1) && enter(); }
  bool set_frame(std::uint32_t step);
  bool enter();
  void enter(const std::array<Point3, 3>& corners, std::uint32_t polygon);
  bool leave_out_unknown();
  void find_cells();
  PlaneCells put_in_cells();
  bool look_in_cells();
  bool look_at_badly_known(std::span<const std::uint32_t> looking);
  void look_around(const PlaneCells& cells, std::span<const std::uint32_t> own);
  void look_at(std::uint32_t own, std::span<const PlanesInRow::Run> runs);
  void look_at_pairs();
  bool may_touch(std::uint32_t own, std::uint32_t other, double near) const;
  bool may_touch_by_doubles(std::uint32_t own, std::uint32_t other) const;
  void add_pair(std::uint32_t own, std::uint32_t other);
  MayTouch found() const;

  /// Error bound of a normal, computed in doubles.
  double normal_error(const PlaneInReach& plane) const {
    return 4.0 * rounding_ * double{plane.per_height} + 0x1p-48;
  }
  /// A point that is farther from the plane, computed in doubles, is not within reach of it.
  double near(double normal_error) const {
    return (reach_ + 2.0 * normal_error * farthest_ + 8.0 * rounding_) * kOfRounding;
  }
  bool is_well_known(const PlaneInReach& plane) const {
    return normal_error(plane) <= normal_error_;
  }
  /// Includes the errors of the other normals that cells find.
  Tolerance tolerance(const PlaneInReach& plane) const;
  /// The size of cells for which a search examines at most two along each axis.
  static float cells_for(const Tolerance& tolerance) {
    return 2.0F * kLongest * std::max(tolerance.normal, tolerance.distance / kPerDistance);
  }
  /// True if the search examines few cells along each axis.
  bool fits_cells(const Tolerance& tolerance) const {
    constexpr float kMostAlong = 8.0F;
    return cells_for(tolerance) <= std::min(kMostAlong * cells_, kLargestCells);
  }
  std::size_t most_compared() const { return kMostCompared * planes_.size(); }
  bool takes_long() const {
    return compared_ > most_compared() || 2 * touching_ > planes_.size() + kFew;
  }

  /// With more comparisons per plane this takes about as long as TouchingPlanes; also if most
  /// polygons touch others.
  static constexpr std::size_t kMostCompared = 64, kFew = 64;
  /// More pairs per polygon are not worth their memory.
  static constexpr std::size_t kMostPairs = 8;
  static constexpr std::size_t kAtOnce = 32;  // polygons
  static constexpr std::uint32_t kSome = 256;
  /// Larger cells hardly distinguish normals; cells smaller than float precision are useless.
  static constexpr float kLargestCells = 0.25F, kSmallestCells = 0x1p-17F;
  /// The width of cells along distances in the frame, relative to that along cosines.
  static constexpr float kPerDistance = 0.5F;

  std::uint32_t polygons_;
  const TouchingPlanes::PolygonOf& polygon_of_;
  double entered_reach_;
  std::vector<PlaneInReach> planes_;
  std::vector<std::uint8_t> touches_;  // per plane in planes_
  std::size_t touching_ = 0, compared_ = 0;
  std::optional<PlanesInRow> in_cells_;  // the planes by cells
  std::vector<PlanesInRow::Run> runs_;
  using Pair = MayTouch::Pair;
  std::vector<Pair> compared_pairs_;
  std::vector<Pair> pairs_;  // by index in planes_
  // The frame, in which most points are no farther from the origin than 1.
  Point3 from_{0.0};
  double scale_ = 1.0;
  double reach_ = 0.0;
  double rounding_ = 0.0;        // error of points in the frame
  double farthest_ = 0.0;        // largest distance of support corners from the origin
  double near_ = 0.0;            // near() in floats, for planes that cells find
  double float_error_ = 0.0;     // of a distance from a plane in floats
  bool are_floats_good_ = true;  // that error is small compared with the reach
  double normal_error_ = 0.0;    // largest normal error of planes that cells find
  float cells_ = 0.0F;           // their size
};

/// The three support corners, in world coordinates; nothing if there is no plane. A triangle's
/// corners are returned even if collinear.
std::optional<std::array<Point3, 3>> corners_of(const EnteredPolygon& polygon) {
  std::array<std::size_t, 3> support{0, 1, 2};
  if (polygon.points.size() != 3) {
    const auto found = support_of_entered(polygon.points.row());
    if (!found) return std::nullopt;
    support = *found;
  }
  return std::array{polygon.in_world(support[0]), polygon.in_world(support[1]),
                    polygon.in_world(support[2])};
}

/// Sets the frame around all polygons, or every `step`th one. False if their coordinates are too
/// small or too large.
bool PlanesInReach::set_frame(std::uint32_t step) {
  constexpr double kMost = 0x1p900;  // larger coordinates cannot be scaled
  Bounds bounds;
  for (std::uint32_t i = 0; i < polygons_; i += step) {
    const EnteredPolygon polygon = polygon_of_(i);
    for (std::size_t k = 0; k < polygon.points.size(); ++k) bounds.include(polygon.in_world(k));
  }
  from_ = bounds.middle();
  const double size = 0.5 * glm::length(bounds.high - bounds.low);
  if (!(size > 1.0 / kMost && size < kMost)) return false;
  int exponent = 0;
  std::frexp(size, &exponent);
  scale_ = std::ldexp(1.0, -exponent);
  return true;
}

/// Enters the polygons with planes. False if some are far outside of the frame, or there are none.
bool PlanesInReach::enter() {
  constexpr double kFarthest = 4.0;
  double largest_sum = 0.0;  // the largest sum of magnitudes that gives a world coordinate
  std::optional<Modelling> modelling;
  planes_.clear();
  planes_.reserve(polygons_);
  reach_ = entered_reach_;
  farthest_ = 0.0;
  for (std::uint32_t i = 0; i < polygons_; ++i) {
    const EnteredPolygon polygon = polygon_of_(i);
    const auto corners = corners_of(polygon);
    if (!corners) continue;
    enter(*corners, i);
    if (polygon.modelling == nullptr) continue;
    if (!modelling || !modelling->is_of(polygon.modelling)) {
      modelling.emplace(polygon.modelling, entered_reach_);
      reach_ = std::max(reach_, modelling->reach().high);
    }
    for (const Point3& v : polygon.points) {
      largest_sum = std::max(largest_sum, modelling->magnitude(glm::abs(v)));
    }
  }
  farthest_ = std::sqrt(farthest_) * kOfRounding;
  if (planes_.empty() || !(farthest_ <= kFarthest)) return false;
  const Point3 from = glm::abs(from_);
  const double largest = std::max({from.x, from.y, from.z}) + farthest_ / scale_;
  rounding_ = kRoundingInWorld * std::max(largest, largest_sum) * scale_;
  farthest_ += rounding_;
  reach_ *= scale_ * kOfRounding;
  float_error_ = kFloatRounding * farthest_;
  constexpr double kOfReach = 0.125;
  are_floats_good_ = float_error_ <= kOfReach * reach_;
  return true;
}

void PlanesInReach::enter(const std::array<Point3, 3>& corners, std::uint32_t polygon) {
  const Point3 p = (corners[0] - from_) * scale_, q = (corners[1] - from_) * scale_,
               r = (corners[2] - from_) * scale_;
  const Point3 a = q - p, b = r - p, c = r - q, across = glm::cross(a, b);
  const double per_area = 1.0 / std::sqrt(glm::dot(across, across));  // per twice the area
  const double longest = std::max(std::max(glm::dot(a, a), glm::dot(b, b)), glm::dot(c, c));
  const Point3 normal = (glm::dot(across, kOneSide) < 0.0 ? -per_area : per_area) * across;
  farthest_ =
      std::max(farthest_, std::max(std::max(glm::dot(p, p), glm::dot(q, q)), glm::dot(r, r)));
  const auto floats = [](const Point3& v) {
    return std::array{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  planes_.push_back({{floats(p), floats(q), floats(r)},
                     {floats(normal), static_cast<float>(glm::dot(normal, p))},
                     static_cast<float>(std::sqrt(longest) * per_area * kOfRounding),
                     polygon});
}

/// Removes polygons without a plane. False if a plane is not known accurately enough, or none is
/// left.
bool PlanesInReach::leave_out_unknown() {
  std::size_t kept = 0;
  for (const PlaneInReach& plane : planes_) {
    if (normal_error(plane) <= kMostUncertain) {
      if (&planes_[kept] != &plane) planes_[kept] = plane;
      ++kept;
    } else if (support_of_entered(polygon_of_(plane.polygon).points.row())) {
      return false;
    }
  }
  planes_.resize(kept);
  touches_.assign(kept, 0);
  return kept > 0;
}

Tolerance PlanesInReach::tolerance(const PlaneInReach& plane) const {
  constexpr float kUp = 1.0F + 0x1p-18F;
  const float per_height = plane.per_height;
  const float bent = 4.0F * static_cast<float>(rounding_) * per_height;  // at most 1/4
  // The longest side exceeds the triangle's height on it.
  const float tilt = 2.0F * static_cast<float>(reach_) * per_height * (1.0F + 3.0F * bent) * kUp;
  const float turned = tilt <= 0.5F ? tilt + tilt * tilt + bent + 0x1p-47F : kAnyTurn;
  const auto& [x, y, z] = plane.corners[0];
  const float off = turned * std::sqrt(x * x + y * y + z * z) + static_cast<float>(reach_) +
                    8.0F * static_cast<float>(rounding_);
  const float more = static_cast<float>(normal_error_) + kFloatTolerance;
  return {turned * kUp + more, off * kUp + more * static_cast<float>(std::max(1.0, farthest_))};
}

/// Finds the size of cells, and the error of normals that they allow for, from a sample of the
/// planes.
void PlanesInReach::find_cells() {
  constexpr float kPart = 0x1p-6F;  // of the median tolerance
  constexpr double kOfMost = 0.9, kOfNearlyAll = 0.99;
  constexpr double kOfReach = 0x1p-6;
  const std::size_t step = planes_.size() / (std::size_t{4} * kSome) + 1;
  std::vector<float> sizes;
  std::vector<double> errors;
  for (std::size_t k = 0; k < planes_.size(); k += step) {
    sizes.push_back(cells_for(tolerance(planes_[k])));
    errors.push_back(normal_error(planes_[k]));
  }
  std::ranges::sort(sizes);
  std::ranges::sort(errors);
  const auto nth = [](const auto& of, double part) {
    return of[static_cast<std::size_t>(part * static_cast<double>(of.size()))];
  };
  normal_error_ = std::min(double{0.5F * kPart * std::min(nth(sizes, 0.5), kLargestCells)},
                           std::max(kOfReach * reach_, nth(errors, kOfNearlyAll)));
  const auto error = static_cast<float>(normal_error_);
  const float most = nth(sizes, kOfMost) + 2.0F * error * (1.0F + 1.0F / kPerDistance);
  cells_ = std::max(kSmallestCells, kLongest * most);
}

PlaneCells PlanesInReach::put_in_cells() {
  PlaneCells cells(planes_.size(), cells_, kPerDistance);
  for (const PlaneInReach& plane : planes_) cells.count(plane);
  cells.begin_lists();
  near_ = (near(normal_error_) + float_error_) * kOfRounding;
  in_cells_.emplace(planes_.size(), static_cast<float>(near_ * kOfRounding));
  for (auto k = static_cast<std::uint32_t>(planes_.size()); k-- > 0;) {
    in_cells_->put(cells.place(k), planes_[k].plane, k);
  }
  return cells;
}

/// Searches in cells; most planes examine one or two along each axis.
bool PlanesInReach::look_in_cells() {
  const PlaneCells cells = put_in_cells();
  std::array<std::uint32_t, kAtOnce> own;
  std::size_t n = 0;
  std::vector<std::uint32_t> looking;
  for (std::uint32_t k = 0; k < planes_.size(); ++k) {
    if (fits_cells(tolerance(planes_[k]))) {
      own[n++] = k;
    } else {
      looking.push_back(k);
    }
    if (n < kAtOnce && k + 1 < planes_.size()) continue;
    look_around(cells, std::span(own).first(n));
    n = 0;
    if (takes_long() || looking.size() > kMostCompared) return false;
  }
  return look_at_badly_known(looking);
}

/// Compares all planes with the few that would examine many cells, and with those whose normals
/// have a larger error than the cells allow for.
bool PlanesInReach::look_at_badly_known(std::span<const std::uint32_t> looking) {
  std::vector<std::uint32_t> unknown;
  for (std::uint32_t k = 0; k < planes_.size(); ++k) {
    if (!is_well_known(planes_[k])) unknown.push_back(k);
  }
  compared_ += (looking.size() + unknown.size()) * planes_.size();
  if (takes_long()) return false;
  const std::array<PlanesInRow::Run, 1> all{{{0, in_cells_->size()}}};
  for (const std::uint32_t k : looking) {
    look_at(k, all);
    look_at_pairs();
  }
  for (const std::uint32_t k : unknown) {
    const double near = this->near(normal_error(planes_[k])) + float_error_;
    for (std::uint32_t own = 0; own < planes_.size(); ++own) {
      if (may_touch(own, k, near)) add_pair(own, k);
    }
  }
  return !takes_long();
}

/// Searches for several planes at a time, so that memory is prefetched for the next while one is
/// compared.
void PlanesInReach::look_around(const PlaneCells& cells, std::span<const std::uint32_t> own) {
  std::array<std::uint32_t, kAtOnce> few;  // those of `own` that examine few cells
  std::array<PlaneCells::Lists, kAtOnce> lists;
  std::array<std::array<PlanesInRow::Run, 4>, kAtOnce> runs;
  std::size_t n = 0;
  for (const std::uint32_t k : own) {
    const Tolerance tolerance = this->tolerance(planes_[k]);
    const auto& [normal, distance] = planes_[k].plane;
    const PlaneCells::Range range = cells.range(planes_[k].plane, tolerance);
    const auto found = cells.find_lists(range);
    few[n] = k;
    if (found) lists[n++] = *found;
    // Planes that differ this little may have opposite orientations.
    const float to_side = normal[0] * static_cast<float>(kOneSide.x) +
                          normal[1] * static_cast<float>(kOneSide.y) +
                          normal[2] * static_cast<float>(kOneSide.z);
    const bool may_be_turned = std::abs(to_side) <= kLongest * tolerance.normal;
    if (found && !may_be_turned) continue;
    runs_.clear();
    if (!found) cells.find_runs(range, runs_);
    if (may_be_turned) {
      cells.find_runs(cells.range({{-normal[0], -normal[1], -normal[2]}, -distance}, tolerance),
                      runs_);
    }
    compared_ += runs_length(runs_);
    look_at(k, runs_);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      runs[i][k] = cells.run(lists[i][k]);
      in_cells_->read_ahead(runs[i][k].begin);
    }
    compared_ += runs_length(runs[i]);
  }
  for (std::size_t i = 0; i < n; ++i) look_at(few[i], runs[i]);
  look_at_pairs();
}

void PlanesInReach::look_at(std::uint32_t own, std::span<const PlanesInRow::Run> runs) {
  for (const std::uint32_t at : in_cells_->near(planes_[own].middle(), runs)) {
    in_cells_->read_number_ahead(at);
    compared_pairs_.push_back({own, at});
  }
}

void PlanesInReach::look_at_pairs() {
  std::size_t kept = 0;
  for (const auto& [own, at] : compared_pairs_) {
    const std::uint32_t other = in_cells_->number(at);
    if (own == other) continue;
    __builtin_prefetch(&planes_[other].plane);
    compared_pairs_[kept++] = {own, other};
  }
  for (const auto& [own, other] : std::span(compared_pairs_).first(kept)) {
    if (may_touch(own, other, near_)) add_pair(own, other);
  }
  compared_pairs_.clear();
}

/// True if the first polygon may lie in the plane of the other.
bool PlanesInReach::may_touch(std::uint32_t own, std::uint32_t other, double near) const {
  const auto& [n, distance] = planes_[other].plane;
  for (const auto& v : planes_[own].corners) {
    const float off = n[0] * v[0] + n[1] * v[1] + n[2] * v[2] - distance;
    if (double{std::abs(off)} > near) return false;
  }
  return own != other && (are_floats_good_ || may_touch_by_doubles(own, other));
}

bool PlanesInReach::may_touch_by_doubles(std::uint32_t own, std::uint32_t other) const {
  const auto plane = corners_of(polygon_of_(planes_[other].polygon)),
             corners = corners_of(polygon_of_(planes_[own].polygon));
  if (!plane || !corners) return false;
  const auto& of = *plane;
  const Point3 a = (of[1] - of[0]) * scale_, b = (of[2] - of[0]) * scale_;
  const Point3 normal = glm::normalize(glm::cross(a, b));
  const double near = this->near(normal_error(planes_[other]));
  return std::ranges::none_of(*corners, [&](const Point3& v) {
    return std::abs(glm::dot(normal, (v - of[0]) * scale_)) > near;
  });
}

void PlanesInReach::add_pair(std::uint32_t own, std::uint32_t other) {
  pairs_.push_back({own, other});
  touching_ += (touches_[own] == 0 ? 1u : 0u) + (touches_[other] == 0 ? 1u : 0u);
  touches_[own] = touches_[other] = 1;
}

MayTouch PlanesInReach::found() const {
  MayTouch found;
  std::vector<std::uint32_t> number(planes_.size());
  for (std::size_t k = 0; k < planes_.size(); ++k) {
    number[k] = static_cast<std::uint32_t>(found.polygons.size());
    if (touches_[k] != 0) found.polygons.push_back(planes_[k].polygon);
  }
  if (pairs_.size() > kMostPairs * planes_.size()) return found;
  found.pairs.emplace();
  found.pairs->reserve(pairs_.size());
  for (const auto& [own, other] : pairs_) found.pairs->push_back({number[own], number[other]});
  return found;
}

}  // namespace

std::optional<MayTouch> planes_in_reach(std::uint32_t polygons,
                                        const TouchingPlanes::PolygonOf& polygon_of, double reach) {
  const RoundToNearest mode;
  return PlanesInReach(polygons, polygon_of, reach).find();
}

}  // namespace displayfile
