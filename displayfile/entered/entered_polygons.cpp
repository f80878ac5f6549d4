#include "displayfile/entered/entered_polygons.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>
#include <utility>

#include "clip/base/growing_array.h"
#include "hidden/exact/entered_plane.h"

namespace displayfile {

namespace {

/// To the bit.
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
  const auto after = std::ranges::upper_bound(runs_, i, {}, &Run::first);
  if (after == runs_.begin()) return nullptr;
  const Matrix& matrix = std::prev(after)->matrix;
  return matrix == Matrix(1.0) ? nullptr : &matrix;
}

double EnteredPolygons::largest_in_world() const {
  double most = largest_;
  for (const auto& [first, m] : runs_) {
    for (int k = 0; k < 3; ++k) {
      const double row = std::abs(m[0][k]) + std::abs(m[1][k]) + std::abs(m[2][k]);
      most = std::max(most, row * largest_ + std::abs(m[3][k]));
    }
  }
  return most;
}

double EnteredPolygons::longest() const {
  double most = 1.0;
  for (const auto& [first, m] : runs_) {
    for (int k = 0; k < 3; ++k) most = std::max(most, glm::length(m[k]));
  }
  return most;
}

std::size_t EnteredPolygons::bytes() const {
  const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
  return size(points_) + size(corners_) + size(first_) + size(runs_) + size(not_seen_) +
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

/// The next of the retained ones.
void EnteredPolygons::enter_again(const PointRow& points, const Matrix* modelling) {
  assert(are_equal(points, retained_.points(entered_again_)));
  begin_modelling(modelling);
  ++entered_again_;
  note_if_bent(points, modelling);
}

/// The polygon that was entered last.
void EnteredPolygons::note_if_bent(const PointRow& points, const Matrix* modelling) {
  if (points.size() <= 3 || !is_bent({points.row(), modelling}, largest_)) return;
  bent_.push_back(static_cast<std::uint32_t>(size() - 1));
}

/// At least twice the room there is, so that many small calls cost no more than one.
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

/// More are entered.
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

void EnteredPolygons::begin_modelling(const Matrix* modelling) {
  if (modelling != nullptr) {
    begin_run(*modelling);
  } else if (!runs_.empty()) {
    begin_run(Matrix(1.0));
  }
}

void EnteredPolygons::begin_run(const Matrix& matrix) {
  if (!runs_.empty() && runs_.back().matrix == matrix) return;
  runs_.push_back({static_cast<std::uint32_t>(size()), matrix});
}

void EnteredPolygons::include(const Point3& p) {
  largest_ = std::max({largest_, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

}  // namespace displayfile
