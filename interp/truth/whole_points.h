#pragma once

#include <array>
#include <glm/mat4x3.hpp>

#include "clip/point.h"
#include "interp/truth/whole_numbers.h"

namespace displayfile {

// Points in space in integer coordinates, before viewing, for the truth alone.

/// A point, or a difference of two: its coordinates are x, y, z over 2^places.
struct WholePoint {
  Integer x, y, z;
  int places = 0;
};

/// Converts finite coordinates exactly.
WholePoint whole(const Point3& point);

/// The same point with at least that many places.
WholePoint with_places(WholePoint point, int places);

/// The result has the places of the argument that has more.
WholePoint difference(const WholePoint& a, const WholePoint& b);
/// A product has the sum of both arguments' places.
WholePoint cross(const WholePoint& a, const WholePoint& b);
Integer dot(const WholePoint& a, const WholePoint& b);
bool is_zero(const WholePoint& difference);

/// A modelling matrix, whose twelve doubles are taken as exact.
class WholeMatrix {
 public:
  explicit WholeMatrix(const glm::dmat4x3& matrix);

  WholePoint apply(const Point3& point) const;
  /// The square of the length of the longest of its first three columns, times 4^places().
  const Integer& longest_squared() const { return longest_squared_; }
  int places() const { return places_; }

 private:
  std::array<std::array<Integer, 3>, 4> columns_;  // times 2^places_
  int places_;
  Integer longest_squared_;
};

}  // namespace displayfile
