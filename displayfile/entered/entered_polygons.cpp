#include "displayfile/entered/entered_polygons.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <numeric>
#include <utility>

#include "clip/base/growing_array.h"
#include "clip/geometry/bounds.h"
#include "hidden/exact/entered_plane.h"

namespace displayfile {

namespace {

/// True if the points are equal bit for bit.
bool are_equal(const PointRow& a, const PointRow& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point3)) == 0;
}

}  // namespace

PointRow EnteredPolygons::points(std::size_t i) const {
  if (are_retained_) return retained_.points(i);
  const std::size_t first = first_[i];
  const std::size_t end = i + 1 < first_.size() ? first_[i + 1] : corners();
  if (corners_.empty()) return std::span(points_).subspan(first, end - first);
  return {points_, std::span(corners_).subspan(first, end - first)};
}

const EnteredPolygons::Matrix* EnteredPolygons::modelling(std::size_t i) const {
  return runs_.at(i);
}

double EnteredPolygons::largest_in_world() const { return runs_.largest_in_world(largest_); }

double EnteredPolygons::longest() const { return runs_.longest_column(); }

std::size_t EnteredPolygons::bytes() const {
  const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
  return size(points_) + size(corners_) + size(first_) + size(runs_.runs()) + size(not_seen_) +
         size(bent_) + size(line_ends_);
}

void EnteredPolygons::enter(const PointRow& points, const Matrix* modelling) {
  if (are_retained_ && entered_again_ < retained_.size()) return enter_again(points, modelling);
  keep_by_themselves();
  begin_polygon(modelling);
  for (const Point3& p : points) {
    if (!corners_.empty()) corners_.push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back(p);
  }
  note_if_bent(points, modelling);
}

void EnteredPolygons::enter_shared(std::span<const Point3> vertices,
                                   std::span<const std::uint32_t> corners,
                                   const Matrix* modelling) {
  if (are_retained_ && entered_again_ < retained_.size()) {
    return enter_again({vertices, corners}, modelling);
  }
  keep_by_themselves();
  if (corners_.empty()) {
    corners_.resize(points_.size());
    std::iota(corners_.begin(), corners_.end(), 0u);
  }
  begin_polygon(modelling);
  for (const std::uint32_t corner : corners) {
    std::uint32_t& number = number_of_shared_[corner];
    if (number == kNotKept) {
      number = static_cast<std::uint32_t>(points_.size());
      points_.push_back(vertices[corner]);
    }
    corners_.push_back(number);
  }
  if (corners.size() > 3) note_if_bent({vertices, corners}, modelling);
}

/// Enters the next polygon of the retained scene.
void EnteredPolygons::enter_again(const PointRow& points, const Matrix* modelling) {
  assert(are_equal(points, retained_.points(entered_again_)));
  begin_modelling(modelling);
  ++entered_again_;
  note_if_bent(points, modelling);
}

/// Records the polygon entered last if it is not planar.
void EnteredPolygons::note_if_bent(const PointRow& points, const Matrix* modelling) {
  if (points.size() <= 3 || !is_bent({points.row(), modelling}, largest_)) return;
  bent_.push_back(static_cast<std::uint32_t>(size() - 1));
}

/// Reserves at least twice the present capacity, so that many small calls cost no more than one.
void EnteredPolygons::reserve_more(std::size_t polygons, std::size_t corners) {
  const auto make_room = [](auto& array, std::size_t more) {
    const std::size_t size = array.size() + more;
    if (size > array.capacity()) array.reserve(std::max(size, 2 * array.capacity()));
  };
  make_room(first_, polygons);
  make_room(corners_, corners);
}

void EnteredPolygons::free_room() {
  number_of_shared_ = decltype(number_of_shared_)();  // {} would leave its room
  displayfile::free_room(corners_);
  displayfile::free_room(first_);
  displayfile::free_room(points_);
  displayfile::free_room(not_seen_);
  displayfile::free_room(bent_);
  displayfile::free_room(line_ends_);
}

bool EnteredPolygons::are_those_of(const RetainedPolygons& retained) const {
  if (are_retained_ || retained.size() != size()) return false;
  for (std::size_t i = 0; i < size(); ++i) {
    if (retained.primitive(i).is_line()) return false;
    if (!are_equal(points(i), retained.points(i))) return false;
  }
  return true;
}

void EnteredPolygons::keep_in(const RetainedPolygons& retained) {
  if (!are_those_of(retained)) return;
  retained_ = retained;
  are_retained_ = true;
  entered_again_ = retained.size();
  points_ = decltype(points_)();  // {} would leave their room
  corners_ = decltype(corners_)();
  first_ = decltype(first_)();
}

void EnteredPolygons::begin_retained(const RetainedPolygons& retained) {
  assert(size() == 0);
  for (std::size_t i = 0; i < retained.size(); ++i) {
    if (retained.primitive(i).is_line()) return;
  }
  retained_ = retained;
  are_retained_ = true;
}

/// Copies the retained polygons into arrays of this object, so that more can be entered.
void EnteredPolygons::keep_by_themselves() {
  if (!are_retained_) return;
  const RetainedPolygons retained = std::exchange(retained_, {});
  are_retained_ = false;
  for (std::size_t i = 0; i < entered_again_; ++i) {
    first_.push_back(static_cast<std::uint32_t>(points_.size()));
    const PointRow points = retained.points(i);
    points_.insert(points_.end(), points.begin(), points.end());
  }
}

void EnteredPolygons::begin_polygon(const Matrix* modelling) {
  begin_modelling(modelling);
  first_.push_back(static_cast<std::uint32_t>(this->corners()));
}

void EnteredPolygons::begin_modelling(const Matrix* modelling) { runs_.begin(size(), modelling); }

void EnteredPolygons::include(const Point3& p) {
  largest_ = std::max(largest_, largest_coordinate(p));
}

}  // namespace displayfile
