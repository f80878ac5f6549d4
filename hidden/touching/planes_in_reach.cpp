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

#include "clip/bounds.h"

namespace displayfile {

namespace {

constexpr double kAnyTurn = std::numeric_limits<double>::infinity();

/// A point, a difference of two, and a cross product of two of these over the longer one, are off
/// by less than this, times the largest sum of magnitudes that gives a coordinate.
constexpr double kRoundingInWorld = 0x1p-46;
/// Pays for the rounding of bounds.
constexpr double kOfRounding = 1.0 + 0x1p-20;
/// Normals that may be off by more are unknown.
constexpr double kMostUncertain = 0.25;

/// Three orthogonal directions of length 1, up to 2^-12, that no scene has a special relation to.
/// Normals are turned to the side of the first one.
constexpr Point3 kOneSide(0.5242, -0.7633, 0.3770);
constexpr std::array kCosines{Point3(0.8290, 0.5593, -0.0202), Point3(-0.1954, 0.3231, 0.9260)};
constexpr double kLongest = 1.01;

/// A support plane, and its polygon's three support corners relative to a fixed point of the world.
struct InReach {
  std::array<Point3, 3> corners;
  Point3 normal;        ///< of length 1
  double distance;      ///< of the plane from the fixed point, along the normal
  double error;         ///< of a point's distance from the plane, at most
  double normal_error;  ///< of the normal
  double tolerance;     ///< by how much normals of planes that it lies in may differ, at most
  double off;           ///< the same of distances
  std::uint32_t polygon;
};

/// What is compared with corners, of a plane in a cell.
struct InCell {
  Point3 normal;
  double distance, near;  ///< a corner within `near` of the plane may be within reach
  std::uint32_t plane;
};

/// Cells of one size over normals and distances of planes, in lists by a hash. The planes of a list
/// follow each other.
class PlaneCells {
 public:
  /// Cells are `side` wide along two cosines of the normal, and `side` times `per_distance` along
  /// the distance. At most that many planes.
  PlaneCells(std::size_t planes, double side, double per_distance)
      : per_cosine_(1.0 / side),
        per_distance_(1.0 / (side * per_distance)),
        shift_(64 - std::countr_zero(std::bit_ceil(std::max<std::size_t>(planes, 2)))),
        first_((std::size_t{1} << (64 - shift_)) + 1, 0) {
    lists_.reserve(planes);
  }

  /// First all planes are counted, in order,
  void count(const Point3& normal, double distance) {
    const Point3 at = in_cells(normal, distance);
    const std::size_t list = list_of(index(at.x), index(at.y), index(at.z));
    lists_.push_back(static_cast<std::uint32_t>(list));
    ++first_[list];
  }
  void begin_lists() {
    std::uint32_t end = 0;
    for (std::uint32_t& first : first_) first = end += first;  // the ends of lists, until now
    planes_.resize(lists_.size());
  }
  /// and then added, from the last to the first.
  void add(const InCell& plane) { planes_[--first_[lists_[plane.plane]]] = plane; }

  std::span<const InCell> planes() const { return planes_; }

  /// Calls visit(plane) for all with normals and distances that differ by no more, and for others;
  /// returns for how many.
  template <class Visit>
  std::size_t visit_near(const Point3& normal, double distance, double tolerance, double off,
                         const Visit& visit) const {
    const Point3 at = in_cells(normal, distance);
    const double wide = tolerance * kLongest * per_cosine_, deep = off * per_distance_;
    const std::int64_t first_z = index(at.z - deep), last_z = index(at.z + deep),
                       first_y = index(at.y - wide), last_y = index(at.y + wide),
                       last_x = index(at.x + wide);
    std::size_t visited = 0;
    for (std::int64_t x = index(at.x - wide); x <= last_x; ++x) {
      for (std::int64_t y = first_y; y <= last_y; ++y) {
        visited += visit_lists(x, y, first_z, last_z, visit);
      }
    }
    return visited;
  }

 private:
  static constexpr double kAbove = 0x1p20;  // more than any is below 0
  static std::int64_t index(double at) { return static_cast<std::int64_t>(at + kAbove); }
  Point3 in_cells(const Point3& normal, double distance) const {
    return {glm::dot(normal, kCosines[0]) * per_cosine_,
            glm::dot(normal, kCosines[1]) * per_cosine_, distance * per_distance_};
  }
  /// Those of cells that follow each other along the distance do so too, up to the last one.
  std::size_t list_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const auto bits = [](std::int64_t i) { return static_cast<std::uint64_t>(i); };
    const std::uint64_t mixed = (bits(x) << 32 ^ bits(y)) * std::uint64_t{0x9e3779b97f4a7c15u};
    return static_cast<std::size_t>((mixed >> shift_) + bits(z)) & (first_.size() - 2);
  }
  template <class Visit>
  std::size_t visit_lists(std::int64_t x, std::int64_t y, std::int64_t first_z, std::int64_t last_z,
                          const Visit& visit) const {
    std::size_t visited = 0;
    while (first_z <= last_z) {
      const std::size_t list = list_of(x, y, first_z), lists = first_.size() - 1;
      const std::size_t end =
          std::min(lists, list + static_cast<std::size_t>(last_z - first_z) + 1);
      for (std::uint32_t k = first_[list]; k < first_[end]; ++k) visit(planes_[k]);
      visited += first_[end] - first_[list];
      first_z += static_cast<std::int64_t>(end - list);
    }
    return visited;
  }

  double per_cosine_, per_distance_;
  int shift_;
  std::vector<std::uint32_t> first_;  // of each list
  std::vector<std::uint32_t> lists_;  // of the planes, in order
  std::vector<InCell> planes_;
};

/// The search, step by step.
class PlanesInReach {
 public:
  PlanesInReach(std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of)
      : polygons_(polygons), polygon_of_(polygon_of) {}

  std::optional<std::vector<std::uint32_t>> find(double reach) {
    enter(reach);
    if (!find_planes()) return std::nullopt;
    find_cells();
    if (!look_in_cells()) return std::nullopt;
    std::vector<std::uint32_t> found;
    for (std::size_t k = 0; k < planes_.size(); ++k) {
      if (touches_[k] != 0) found.push_back(planes_[k].polygon);
    }
    return found;
  }

 private:
  void enter(double reach);
  bool find_planes();
  bool find_plane(InReach& plane) const;
  void find_cells();
  bool look_in_cells();
  bool look_at_badly_known(const PlaneCells& cells);
  PlaneCells cells_of(double size) const;
  void look_around(const PlaneCells& cells, std::uint32_t own);
  void look_at(std::uint32_t own, const InCell& other);
  InCell in_cell(std::uint32_t k) const {
    const InReach& plane = planes_[k];
    return {plane.normal, plane.distance, reach_ + plane.error, k};
  }
  bool is_well_known(const InReach& plane) const { return plane.normal_error <= normal_error_; }
  /// The size of the cells of which it looks in at most two along each axis.
  double cells_for(const InReach& plane) const {
    return 2.0 * std::max(plane.tolerance, plane.off / per_distance_);
  }
  bool takes_long() const {
    return compared_ > kMostCompared * planes_.size() || 2 * touching_ > planes_.size() + kFew;
  }

  /// It looks in a few cells along each axis.
  bool fits_cells(const InReach& plane) const {
    constexpr double kMostAlong = 8.0;
    return cells_for(plane) <= std::min(kMostAlong * cells_, kLargestCells);
  }

  /// More take about as long as TouchingPlanes; so do the polygons, if most touch others.
  static constexpr std::size_t kMostCompared = 64, kFew = 64;
  /// Larger cells tell hardly any normals apart.
  static constexpr double kLargestCells = 0.25;

  std::uint32_t polygons_;
  const TouchingPlanes::PolygonOf& polygon_of_;
  std::vector<InReach> planes_;
  std::vector<std::uint8_t> touches_;  // of planes_
  std::size_t touching_ = 0, compared_ = 0;
  Bounds bounds_;             // of the support corners
  Point3 from_{0.0};          // the fixed point
  double reach_ = 0.0;        // in the world
  double largest_sum_ = 0.0;  // of magnitudes, that gives a coordinate there
  double rounding_ = 0.0;     // of points there
  double farthest_ = 0.0;     // of the support corners from the fixed point
  double per_distance_ = 1.0;
  double normal_error_ = 0.0;  // of planes that cells find
  double cells_ = 0.0;         // their size
};

/// Takes the support corners, in the world.
void PlanesInReach::enter(double reach) {
  planes_.reserve(polygons_);
  std::optional<Modelling> modelling;
  reach_ = reach;
  for (std::uint32_t i = 0; i < polygons_; ++i) {
    const EnteredPolygon polygon = polygon_of_(i);
    std::array<std::size_t, 3> support{0, 1, 2};
    if (polygon.points.size() != 3) {
      const auto found = support_of_entered(polygon.points.row());
      if (!found) continue;
      support = *found;
    }
    InReach& plane = planes_.emplace_back();
    plane.polygon = i;
    for (std::size_t k = 0; k < 3; ++k) {
      plane.corners[k] = polygon.in_world(support[k]);
      bounds_.include(plane.corners[k]);
    }
    if (polygon.modelling == nullptr) continue;
    if (!modelling || !modelling->is_of(polygon.modelling)) {
      modelling.emplace(polygon.modelling, reach);
      reach_ = std::max(reach_, modelling->reach().high);
    }
    for (const Point3& v : polygon.points) {
      largest_sum_ = std::max(largest_sum_, modelling->magnitude(glm::abs(v)));
    }
  }
}

/// False if one is not known, or there are none.
bool PlanesInReach::find_planes() {
  if (planes_.empty()) return false;
  const Point3 corner = glm::max(glm::abs(bounds_.low), glm::abs(bounds_.high));
  from_ = bounds_.middle();
  reach_ *= kOfRounding;
  rounding_ =
      kRoundingInWorld * std::max(std::max(corner.x, corner.y), std::max(corner.z, largest_sum_));
  farthest_ = 0.5 * glm::length(bounds_.high - bounds_.low) * kOfRounding + rounding_;
  per_distance_ = 0.5 * farthest_;
  if (!(rounding_ > 0.0 && farthest_ < std::numeric_limits<double>::max())) return false;
  std::size_t kept = 0;
  for (InReach& plane : planes_) {
    if (find_plane(plane)) {
      planes_[kept++] = plane;
    } else if (support_of_entered(polygon_of_(plane.polygon).points.row())) {
      return false;
    }
  }
  planes_.resize(kept);
  touches_.assign(kept, 0);
  return kept > 0;
}

/// False if the normal is not known.
bool PlanesInReach::find_plane(InReach& plane) const {
  const Point3 p = plane.corners[0] - from_, a = plane.corners[1] - plane.corners[0],
               b = plane.corners[2] - plane.corners[0], c = b - a;
  const Point3 across = glm::cross(a, b);
  const double twice_area = glm::length(across);
  const double longest =
      std::sqrt(std::max(std::max(glm::dot(a, a), glm::dot(b, b)), glm::dot(c, c)));
  const double per_area = 1.0 / twice_area;
  plane.normal_error = 4.0 * rounding_ * longest * per_area + 0x1p-48;
  if (!(twice_area > 0.0 && plane.normal_error <= kMostUncertain)) return false;
  const double sign = glm::dot(across, kOneSide) < 0.0 ? -per_area : per_area;
  plane.corners = {p, p + a, p + b};
  plane.normal = sign * across;
  plane.distance = glm::dot(plane.normal, p);
  plane.error = 2.0 * plane.normal_error * farthest_ + 8.0 * rounding_;
  const double tilt =
      2.0 * reach_ * (longest + 4.0 * rounding_) / (twice_area - rounding_ * longest);
  const double turned = tilt <= 0.5 ? tilt + tilt * tilt + plane.normal_error : kAnyTurn;
  plane.tolerance = turned * kOfRounding;
  plane.off = (turned * glm::length(p) + reach_ + 8.0 * rounding_) * kOfRounding;
  return true;
}

/// Finds the size of cells, and the error of normals that is taken into account there.
void PlanesInReach::find_cells() {
  constexpr double kPart = 0x1p-6;  // of the tolerance that half of them have
  constexpr double kOfMost = 0.75;
  std::vector<double> sizes;
  sizes.reserve(planes_.size());
  for (const InReach& plane : planes_) sizes.push_back(cells_for(plane));
  const auto nth = [&](double part) {
    const auto n = static_cast<std::ptrdiff_t>(part * static_cast<double>(sizes.size()));
    std::ranges::nth_element(sizes, sizes.begin() + n);
    return sizes[static_cast<std::size_t>(n)];
  };
  normal_error_ = 0.5 * kPart * std::min(nth(0.5), kLargestCells);
  cells_ = nth(kOfMost) + 2.0 * normal_error_ * (1.0 + farthest_ / per_distance_);
  for (InReach& plane : planes_) {
    plane.tolerance += normal_error_;
    plane.off += normal_error_ * farthest_;
  }
}

PlaneCells PlanesInReach::cells_of(double size) const {
  PlaneCells cells(planes_.size(), size, per_distance_);
  for (const InReach& plane : planes_) cells.count(plane.normal, plane.distance);
  cells.begin_lists();
  for (auto k = static_cast<std::uint32_t>(planes_.size()); k-- > 0;) cells.add(in_cell(k));
  return cells;
}

/// Most look in one or two cells along each axis.
bool PlanesInReach::look_in_cells() {
  const PlaneCells cells = cells_of(cells_);
  if (!look_at_badly_known(cells)) return false;
  for (std::uint32_t k = 0; k < planes_.size(); ++k) {
    if (fits_cells(planes_[k])) look_around(cells, k);
    if (takes_long()) return false;
  }
  return true;
}

/// Compares with all the few polygons that would look in many cells, and those whose normals are
/// off by more than is taken into account there.
bool PlanesInReach::look_at_badly_known(const PlaneCells& cells) {
  std::vector<std::uint32_t> looking, unknown;
  for (std::uint32_t k = 0; k < planes_.size(); ++k) {
    if (!fits_cells(planes_[k])) looking.push_back(k);
    if (!is_well_known(planes_[k])) unknown.push_back(k);
  }
  compared_ += (looking.size() + unknown.size()) * planes_.size();
  if (takes_long()) return false;
  for (const std::uint32_t k : looking) {
    for (const InCell& other : cells.planes()) look_at(k, other);
  }
  for (const std::uint32_t k : unknown) {
    const InCell plane = in_cell(k);
    for (std::uint32_t own = 0; own < planes_.size(); ++own) look_at(own, plane);
  }
  return true;
}

void PlanesInReach::look_around(const PlaneCells& cells, std::uint32_t own) {
  const InReach& plane = planes_[own];
  const auto look = [&](double sign) {
    compared_ += cells.visit_near(sign * plane.normal, sign * plane.distance, plane.tolerance,
                                  plane.off, [&](const InCell& other) { look_at(own, other); });
  };
  look(1.0);
  // Planes that differ so little may be turned the other way.
  if (std::abs(glm::dot(plane.normal, kOneSide)) <= kLongest * plane.tolerance) look(-1.0);
}

/// Marks both if the first may lie in the plane of the other.
void PlanesInReach::look_at(std::uint32_t own, const InCell& other) {
  for (const Point3& v : planes_[own].corners) {
    if (std::abs(glm::dot(other.normal, v) - other.distance) > other.near) return;
  }
  if (own == other.plane) return;
  touching_ += (touches_[own] == 0 ? 1u : 0u) + (touches_[other.plane] == 0 ? 1u : 0u);
  touches_[own] = touches_[other.plane] = 1;
}

}  // namespace

std::optional<std::vector<std::uint32_t>> planes_in_reach(
    std::uint32_t polygons, const TouchingPlanes::PolygonOf& polygon_of, double reach) {
  return PlanesInReach(polygons, polygon_of).find(reach);
}

}  // namespace displayfile
