#include "tests/bench/command/waves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "programs/scenes/random.h"
#include "programs/scenes/shapes.h"

namespace displayfile::bench {

namespace {

/// One of the waves that a surface is the sum of.
struct Wave {
  double x, y, phase, amplitude;
  double at(double u, double v) const { return amplitude * std::sin(x * u + y * v + phase); }
};

std::vector<Wave> waves_of(std::uint64_t seed) {
  constexpr int kWaves = 5;
  Random random(seed);
  std::vector<Wave> waves;
  for (int k = 1; k <= kWaves; ++k) {
    const Point2 way = (3.0 * k) * on_circle(random.unit());
    waves.push_back({way.x, way.y, 2.0 * std::numbers::pi * random.unit(), 0.5 / k});
  }
  return waves;
}

}  // namespace

void enter_waves(std::size_t n, std::uint64_t seed, GraphicsSystem& system) {
  const auto cells = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(n) / 2.0)));
  const std::vector<Wave> waves = waves_of(seed);
  const auto at = [&](int k) { return -1.0 + 2.0 * k / cells; };
  std::vector<double> heights;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      double height = 0.0;
      for (const Wave& wave : waves) height += wave.at(at(i), at(j));
      heights.push_back(0.4 * height);
    }
  }
  const Point3 eye(2.5, -4.0, 3.0);
  system.set_view_plane_normal(-eye);
  system.set_view_up({0.0, 0.0, 1.0});
  system.set_perspective(eye);
  system.set_window(-2.0, 2.0, -2.0, 2.0);
  system.set_view_depth(-4.0, 4.0);
  system.set_line_style({LineStyle::Kind::none});
  system.set_fill_style({FillStyle::Kind::solid, {0.5, 0.65, 0.8}});
  system.open_segment(1);
  system.surface_3({-1.0, 1.0, cells + 1, -1.0, 1.0, cells + 1, heights});
  system.close_segment();
}

}  // namespace displayfile::bench
