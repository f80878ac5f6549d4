#include "displayfile/mesh/lost_detail.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "hidden/exact/largest_coordinate.h"

namespace displayfile {

namespace {

/// Between neighbouring numbers of single precision.
double distance_between_floats(double size) {
  const auto f = static_cast<float>(size);
  return static_cast<double>(std::nextafter(f, std::numeric_limits<float>::infinity())) -
         static_cast<double>(f);
}

}  // namespace

void LostDetail::add_edge(const Point3& from, const Point3& to) {
  constexpr double kEnough = 64.0;
  const double size = std::max(largest_coordinate(from), largest_coordinate(to));
  const double length = glm::distance(from, to);
  ++edges_;
  if (length >= kEnough * distance_between_floats(size)) return;
  ++lost_;
  largest_ = std::max(largest_, size);
}

std::optional<std::string> LostDetail::sentence() const {
  if (10 * lost_ <= edges_) return std::nullopt;
  return fmt::format(
      "its coordinates, up to {:.6g}, were read in single precision, which rounds them to "
      "multiples of {:.2g}: {} of {} edges are too short for that",
      largest_, distance_between_floats(largest_), lost_, edges_);
}

}  // namespace displayfile
