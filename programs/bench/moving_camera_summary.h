#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "programs/bench/summary.h"

namespace displayfile::bench {

/// How the time of a new view grows with the triangles: the exponent of the power that fits best.
struct GrowthOfNewViews {
  std::string scene;  ///< name
  int threads = 1;
  std::size_t points = 0;  ///< that it was fitted through
  double exponent = 0.0;
};
/// The scenes that were measured with two numbers of triangles at least have one.
std::vector<GrowthOfNewViews> growth_of_new_views(const Report& report);

/// A new view of a retained scene, against OSMesa's resident, indexed mesh and a new matrix: a row
/// a scene at each number of polygons. Nothing if the report has none.
std::optional<Summary> moving_camera(const Report& report);

/// True of what is in that table: a text that has it need not tell it again.
bool is_of_moving_camera(const Beside& beside);

}  // namespace displayfile::bench
