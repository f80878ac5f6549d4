#include "tests/bench/seams/tilings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <random>

#include "interp/device/picture.h"
#include "tests/bench/device_scene.h"

namespace displayfile::bench {

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_()) / 4294967296.0; }
  Colour colour() {
    const double r = (*this)(), g = (*this)();
    return {r, g, (*this)()};
  }

 private:
  std::mt19937 engine_;
};

constexpr int kRings = 9;
constexpr int kDiscSide = 200;

/// Vertices on rings, by angle in turns; from ring to ring triangles by the smaller angle.
std::vector<std::array<Point3, 3>> disc_triangles() {
  Random random(7);
  std::vector<std::vector<double>> turns(kRings + 1);
  std::vector<std::vector<Point3>> points(kRings + 1);
  const Point3 centre(0.5037, 0.4981, 0.5);
  points[0] = {centre};
  turns[0] = {0.0};
  for (int k = 1; k <= kRings; ++k) {
    const int n = k == kRings ? 6 * kRings : 6 * k;
    for (int i = 0; i < n; ++i) {
      const double turn = (i + 0.3 + 0.4 * random()) / n;
      const double radius = 0.45 * (k == kRings ? k : k - 0.15 + 0.3 * random()) / kRings;
      const double angle = 2.0 * std::numbers::pi * turn;
      turns[static_cast<std::size_t>(k)].push_back(turn);
      points[static_cast<std::size_t>(k)].push_back(
          centre + radius * Point3(std::cos(angle), std::sin(angle), 0.0));
    }
  }
  std::vector<std::array<Point3, 3>> triangles;
  for (std::size_t k = 0; k < kRings; ++k) {
    const auto &in = points[k], &out = points[k + 1];
    const auto turn_of = [&](const std::vector<double>& ring, std::size_t i) {
      return ring[i % ring.size()] + static_cast<double>(i / ring.size());
    };
    std::size_t i = 0, o = 0;  // the next that is not joined yet
    const std::size_t inner = in.size() == 1 ? 0 : in.size();
    while (i < inner || o < out.size()) {
      const bool outward = o < out.size() &&
                           (i >= inner || turn_of(turns[k + 1], o + 1) <= turn_of(turns[k], i + 1));
      const Point3 &p = in[i % in.size()], &q = out[o % out.size()];
      triangles.push_back({p, q, outward ? out[(o + 1) % out.size()] : in[(i + 1) % in.size()]});
      outward ? ++o : ++i;
    }
  }
  return triangles;
}

template <class ColourOf>
Tiling disc(const std::string& name, ColourOf colour_of) {
  Tiling tiling{name, kDiscSide, {}};
  for (const auto& t : disc_triangles()) {
    tiling.tiles.push_back({{t[0], t[1], t[2]}, colour_of()});
  }
  return tiling;
}

using Triangle = std::array<Point2, 3>;

double cross(const Point2& o, const Point2& p, const Point2& q) {
  return (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
}

/// True if a side of the first has the second on its other side.
bool separates(const Triangle& a, const Triangle& b) {
  const double turn = cross(a[0], a[1], a[2]) > 0.0 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto outside = [&](const Point2& p) {
      return turn * cross(a[i], a[(i + 1) % 3], p) <= 1e-12;
    };
    if (std::ranges::all_of(b, outside)) return true;
  }
  return false;
}

/// Which triangles overlap one that came before and is kept.
std::vector<bool> overlapping(const std::vector<Triangle>& triangles) {
  constexpr int kCells = 256;
  std::vector<std::vector<std::size_t>> cells(kCells * kCells);
  std::vector<bool> left_out(triangles.size());
  const auto cell = [](double v) {
    return std::clamp(static_cast<int>(v * kCells), 0, kCells - 1);
  };
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const auto& t = triangles[k];
    const auto [x0, x1] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [y0, y1] = std::minmax({t[0].y, t[1].y, t[2].y});
    const auto each_cell = [&, x0 = x0, x1 = x1, y0 = y0, y1 = y1](const auto& visit) {
      for (int y = cell(y0); y <= cell(y1); ++y) {
        for (int x = cell(x0); x <= cell(x1); ++x) {
          visit(cells[static_cast<std::size_t>(y * kCells + x)]);
        }
      }
    };
    bool overlaps = cross(t[0], t[1], t[2]) == 0.0;
    each_cell([&](const std::vector<std::size_t>& others) {
      for (const std::size_t o : others) {
        overlaps = overlaps || !(separates(t, triangles[o]) || separates(triangles[o], t));
      }
    });
    left_out[k] = overlaps;
    if (!overlaps) each_cell([&](std::vector<std::size_t>& others) { others.push_back(k); });
  }
  return left_out;
}

}  // namespace

Tiling one_colour_disc() {
  return disc("disc, one colour", [] { return Colour(0.1, 0.25, 0.5); });
}
Tiling one_colour_disc_of_elements() {
  Tiling tiling = one_colour_disc();
  tiling.name = "disc, one colour, elements";
  tiling.apart = true;
  return tiling;
}
Tiling two_colour_disc() {
  return disc("disc, two colours", [random = Random(3)]() mutable {
    return random() < 0.5 ? Colour(0.9, 0.1, 0.1) : Colour(0.0, 0.2, 0.6);
  });
}
Tiling many_colour_disc() {
  return disc("disc, many colours", [random = Random(4)]() mutable { return random.colour(); });
}

Tiling stripes() {
  Tiling tiling{"stripes, many colours", kDiscSide, {}};
  Random random(5);
  double bottom = 0.06, left = 0.0, right = 0.0;
  for (int k = 0; k < 10; ++k) {
    const double top = bottom + 0.08 + 0.01 * random();
    const double a = left + 0.03 * (random() - 0.5), b = right + 0.03 * (random() - 0.5);
    tiling.tiles.push_back({{{0.1, bottom + left, 0.5},
                             {0.9, bottom + right, 0.5},
                             {0.9, top + b, 0.5},
                             {0.1, top + a, 0.5}},
                            random.colour()});
    bottom = top;
    left = a;
    right = b;
  }
  return tiling;
}

Tiling front_faces(const std::string& mesh) {
  const DeviceScene scene = read_model(mesh).entered;
  Tiling tiling{std::filesystem::path(mesh).stem().string() + ", front faces", 512, {}};
  std::vector<Triangle> triangles;
  for (const auto& polygon : scene.polygons) {
    const Point3* p = &scene.points[polygon.first];
    triangles.push_back({Point2(p[0]), Point2(p[1]), Point2(p[2])});
  }
  const std::vector<bool> left_out = overlapping(triangles);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    if (left_out[k]) continue;
    const Point3* p = &scene.points[scene.polygons[k].first];
    const Point3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double grey = 0.2 + 0.8 * std::abs(glm::dot(normal, Point3(0.3, 0.5, 0.81))) /
                                  std::max(glm::length(normal), 1e-300);
    tiling.tiles.push_back({{p[0], p[1], p[2]}, Colour(std::min(grey, 1.0))});
  }
  return tiling;
}

Tiling in_black(const Tiling& tiling) {
  Tiling black = tiling;
  black.apart = false;
  for (auto& tile : black.tiles) tile.colour = Colour(0.0);
  return black;
}

std::vector<Colour> colours_of(const Tiling& tiling) {
  std::map<std::uint32_t, Colour> by_pixel;
  for (const auto& tile : tiling.tiles) by_pixel.emplace(pixel_of(tile.colour), tile.colour);
  std::vector<Colour> colours;
  for (const auto& [pixel, colour] : by_pixel) colours.push_back(colour);
  return colours;
}

}  // namespace displayfile::bench
