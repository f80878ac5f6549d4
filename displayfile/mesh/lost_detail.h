#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "clip/point.h"

namespace displayfile {

/// Whether a mesh that was read in single precision lost detail by it: a coordinate is rounded to a
/// multiple of the distance between neighbouring floats of its size. An edge loses detail if it is
/// shorter than 64 such distances, those of its ends' largest coordinate: then rounding may turn it
/// and change its length by more than one in a hundred. A mesh does if more than one in ten of its
/// edges do, so that a few slivers say nothing.
class LostDetail {
 public:
  /// An edge of a face, as it was read.
  void add_edge(const Point3& from, const Point3& to);
  /// A sentence that says so; nothing if none was lost.
  std::optional<std::string> sentence() const;

 private:
  std::size_t edges_ = 0, lost_ = 0;
  double largest_ = 0.0;  // coordinate of the edges that lost detail
};

}  // namespace displayfile
