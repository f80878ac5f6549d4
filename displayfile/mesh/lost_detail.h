#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "clip/point.h"

namespace displayfile {

/// Detects whether a mesh read in single precision lost detail. A coordinate is rounded to a
/// multiple of the spacing of floats of its size. An edge loses detail if it is shorter than 64
/// such spacings at its largest coordinate: rounding may then rotate it and change its length by
/// more than 1 %. A mesh does if more than one in ten of its edges do, so that a few slivers do not
/// count.
class LostDetail {
 public:
  /// Adds an edge of a face, as read.
  void add_edge(const Point3& from, const Point3& to);
  /// A warning; nothing if no detail was lost.
  std::optional<std::string> sentence() const;

 private:
  std::size_t edges_ = 0, lost_ = 0;
  double largest_ = 0.0;  // of the edges that lost detail
};

}  // namespace displayfile
