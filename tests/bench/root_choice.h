#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hidden/sort/hidden_surface_sort.h"
#include "tests/bench/device_scene.h"

namespace displayfile::bench {

inline constexpr std::array kRootChoices = {RootChoice::last, RootChoice::sample, RootChoice::free};
std::string_view name_of(RootChoice root);

/// What the exact BSP sort of a scene costs with a choice of root: counts, the same in every run.
struct RootCost {
  std::string scene;
  RootChoice root;
  std::size_t polygons;
  double pieces;       ///< a polygon
  double comparisons;  ///< a polygon
  std::uint32_t depth;
};
RootCost root_cost(const DeviceScene& scene, RootChoice root, int threads);

std::string csv(const std::vector<RootCost>& costs);

/// A figure in SVG: comparisons and pieces a polygon against the number of polygons, a column a
/// scene, a line a choice of root.
std::string figure(const std::vector<RootCost>& costs);

}  // namespace displayfile::bench
