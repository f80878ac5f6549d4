// From an application's calls, and from a drawing program, to a display file: polygons entered one
// call each in times of all at once (GraphicsSystem::polygons_abs_3), rates, and bytes.

#include <cmath>
#include <span>
#include <sstream>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"
#include "tests/bench/benchmark.h"

namespace displayfile::bench {

const char* const kAbout = "Entering polygons and replaying them";

namespace {

enum class Drawn { unlit, a_style_each, lit };

/// A height field of 2 n^2 triangles, within the window.
struct Field {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  std::vector<FillStyle> fills;  ///< one each, each different from the previous one

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
    for (std::size_t k = 0; k < triangles(); ++k) {
      const double grey = static_cast<double>(k % 97) / 96.0;
      fills.push_back({FillStyle::Kind::solid, {grey, 0.5, 1.0 - grey}});
    }
  }
  std::size_t triangles() const { return corners.size() / 3; }
};

void enter(const Field& field, bool at_once, Drawn drawn, GraphicsSystem& system) {
  const bool each = drawn == Drawn::a_style_each;
  system.open_segment(1);
  if (at_once) {
    system.polygons_abs_3({field.vertices,
                           field.corners,
                           {},
                           std::span(field.fills).first(each ? field.fills.size() : 0)});
  } else {
    for (std::size_t k = 0; k < field.corners.size(); k += 3) {
      if (each) system.set_fill_style(field.fills[k / 3]);
      const auto at = [&](std::size_t i) { return field.vertices[field.corners[k + i]]; };
      system.polygon_abs_3({at(0), at(1), at(2)});
    }
  }
  system.close_segment();
}

double seconds_of(const Field& field, bool at_once, Drawn drawn) {
  GraphicsSystem system;
  system.set_perspective({0.1, 0.2, 5});
  if (drawn == Drawn::lit) system.set_light({1, 2, 3});
  enter(field, at_once, drawn, system);  // its memory is used again
  system.delete_all_segments();
  return seconds([&] { enter(field, at_once, drawn, system); });
}

void print_one_by_one(const Options& options) {
  const Field field(
      static_cast<std::uint32_t>(std::sqrt(static_cast<double>(options.polygons) / 2.0)));
  for (const auto& [drawn, words] : {std::pair(Drawn::unlit, "one style"),
                                     {Drawn::a_style_each, "one style each"},
                                     {Drawn::lit, "one style, lit"}}) {
    const Spread ratio = ratio_of_seconds(
        options.rounds, [&, drawn = drawn] { return seconds_of(field, true, drawn); },
        [&, drawn = drawn] { return seconds_of(field, false, drawn); });
    print_row({{"table", "one call each, in times of all at once"},
               {"triangles", field.triangles()},
               {"", words},
               {"time", figures(ratio)}});
  }
}

void print_rate(const char* what, double unit, std::size_t triangles, std::size_t bytes,
                const Options& options, const auto& work) {
  std::vector<double> rates;
  for (int i = 0; i < options.rounds; ++i) {
    GraphicsSystem system;
    rates.push_back(static_cast<double>(triangles) / seconds([&] { work(system); }) / unit);
  }
  print_row({{"table", "rates"},
             {"triangles", triangles},
             {"work", what},
             {"of the rate", figures(spread(rates))},
             {"bytes a triangle", bytes / triangles}});
}

void print_rates(const Options& options) {
  const auto entered = [](const Field& field, GraphicsSystem& system) {
    system.set_line_style({LineStyle::Kind::none});
    enter(field, false, Drawn::unlit, system);
    return system.display_file().bytes();
  };
  for (const std::uint32_t n : {158U, 500U, 1414U}) {  // 50,000, half a million, 4 million
    const Field field(n);
    GraphicsSystem first;
    print_rate("entered, of 4 million a second", 4e6, field.triangles(), entered(field, first),
               options, [&](GraphicsSystem& system) { entered(field, system); });
  }
  const Field field(316);
  std::ostringstream text;
  Recorder recorder(text);
  GraphicsSystem recorded;
  recorded.set_recorder(&recorder);
  const std::size_t bytes = entered(field, recorded);
  print_rate("replayed from a drawing program, of 1 million a second", 1e6, field.triangles(),
             bytes, options, [program = text.str()](GraphicsSystem& system) {
               replay(program, "bench.draw", system);
             });
}

}  // namespace

void run(const Options& options) {
  print_one_by_one(options);
  print_rates(options);
}

}  // namespace displayfile::bench
