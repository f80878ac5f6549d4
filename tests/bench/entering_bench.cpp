// Entering polygons: many at once against one call each (GraphicsSystem::polygons_abs_3).

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

#include "displayfile/graphics_system.h"

namespace {

using namespace displayfile;

/// A height field of 2 n^2 triangles, within the window.
struct Field {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  std::vector<FillStyle> fills;  ///< one each, and each another than the last

  explicit Field(std::uint32_t n) {
    const auto at = [n](std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; };
    for (std::uint32_t j = 0; j <= n; ++j) {
      for (std::uint32_t i = 0; i <= n; ++i) {
        const double x = 1.8 * i / n - 0.9, y = 1.8 * j / n - 0.9;
        vertices.emplace_back(x, y, 0.2 * std::sin(7.0 * x) * std::cos(5.0 * y));
      }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
      for (std::uint32_t i = 0; i < n; ++i) {
        corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        corners.insert(corners.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
    for (std::size_t k = 0; k < corners.size() / 3; ++k) {
      const double grey = static_cast<double>(k % 97) / 96.0;
      fills.push_back({FillStyle::Kind::solid, {grey, 0.5, 1.0 - grey}});
    }
  }
};

enum class Drawn { unlit, a_style_each, lit };

const char* words(Drawn drawn) {
  if (drawn == Drawn::unlit) return "one style";
  return drawn == Drawn::lit ? "one style, lit" : "one style each";
}

void enter(const Field& field, bool at_once, Drawn drawn, GraphicsSystem& system) {
  const bool each = drawn == Drawn::a_style_each;
  const std::span<const FillStyle> fills =
      each ? std::span(field.fills) : std::span<const FillStyle>();
  system.open_segment(1);
  if (at_once) {
    system.polygons_abs_3({field.vertices, field.corners, {}, fills});
  } else {
    for (std::size_t k = 0; k < field.corners.size(); k += 3) {
      if (each) system.set_fill_style(fills[k / 3]);
      const Point3 triangle[]{field.vertices[field.corners[k]],
                              field.vertices[field.corners[k + 1]],
                              field.vertices[field.corners[k + 2]]};
      system.polygon_abs_3(triangle);
    }
  }
  system.close_segment();
}

double seconds(const Field& field, bool at_once, Drawn drawn) {
  GraphicsSystem system;
  system.set_perspective({0.1, 0.2, 5});
  if (drawn == Drawn::lit) system.set_light({1, 2, 3});
  enter(field, at_once, drawn, system);  // its memory is used again
  system.delete_all_segments();
  const auto start = std::chrono::steady_clock::now();
  enter(field, at_once, drawn, system);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Entering polygons one call each, in times of entering them at once");
  std::uint32_t n = 300;
  int rounds = 9;
  app.add_option("--side", n, "of the field: 2 n^2 triangles")->check(CLI::Range(1, 5000));
  app.add_option("--rounds", rounds, "measured in turn")->check(CLI::Range(1, 1000));
  CLI11_PARSE(app, argc, argv);
  const Field field(n);
  for (const Drawn drawn : {Drawn::unlit, Drawn::a_style_each, Drawn::lit}) {
    std::vector<double> ratios;
    for (int k = 0; k < rounds; ++k) {
      const double one_by_one = seconds(field, false, drawn);
      ratios.push_back(one_by_one / seconds(field, true, drawn));
    }
    std::ranges::sort(ratios);
    std::printf("%zu triangles, %s: median of %d rounds %.2f (%.2f to %.2f)\n",
                field.corners.size() / 3, words(drawn), rounds, ratios[ratios.size() / 2],
                ratios.front(), ratios.back());
  }
}
