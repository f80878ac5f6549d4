#include <pybind11/stl.h>

#include <array>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"
#include "interp/python/arguments.h"
#include "interp/python/entering.h"
#include "interp/python/system.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

/// The depth of the front plane, where nothing hides the marks.
constexpr double kFront = 1.0;

/// Rectangles (left, right, bottom, top), lines from x, y to x, y, and texts (x, y, size,
/// characters), in parts of the picture's height.
struct Beside {
  std::vector<std::array<double, 4>> rectangles;
  std::vector<std::array<double, 3>> fills;
  std::vector<std::array<double, 4>> lines;
  std::vector<std::tuple<double, double, double, std::string>> texts;
};

void enter(GraphicsSystem& system, const Beside& all) {
  system.set_line_style({LineStyle::Kind::none});
  for (std::size_t k = 0; k < all.rectangles.size(); ++k) {
    const auto& [left, right, low, high] = all.rectangles[k];
    const auto& [r, g, b] = all.fills[k];
    system.set_fill_style({FillStyle::Kind::solid, {r, g, b}});
    system.polygon_abs_3(
        {{left, low, kFront}, {right, low, kFront}, {right, high, kFront}, {left, high, kFront}});
  }
  system.set_line_style({});
  for (const auto& [x, y, to_x, to_y] : all.lines) {
    system.move_abs_3(x, y, kFront);
    system.line_abs_3(to_x, to_y, kFront);
  }
  const TextStyle before = system.looks().attributes.text;
  for (const auto& [x, y, size, characters] : all.texts) {
    system.set_text_style({.size = size, .alignment = TextStyle::Alignment::left, .always = true});
    system.move_abs_3(x, y, kFront);
    system.text(characters);
  }
  system.set_text_style(before);
}

int enter_beside(System& self, py::handle segment, double width,
                 std::vector<std::array<double, 4>> rectangles,
                 std::vector<std::array<double, 3>> fills, std::vector<std::array<double, 4>> lines,
                 std::vector<std::tuple<double, double, double, std::string>> texts) {
  const auto name = if_given(segment, "segment", whole_number_in);
  const Beside all{std::move(rectangles), std::move(fills), std::move(lines), std::move(texts)};
  return self.work([&](GraphicsSystem& system, Renderer&) {
    if (const auto open = system.open_segment_name()) system.open_segment(*open);  // is refused
    int entered = 0;
    self.followed().enter_beside(system, width, [&] {
      SystemInside::keep_fill_style(system, [&] {
        SystemInside::keep_line_style(
            system, [&] { entered = in_segment(system, name, [&] { enter(system, all); }); });
      });
    });
    return entered;
  });
}

}  // namespace

void add_beside(SystemClass& system) { system.def("_beside", enter_beside); }

}  // namespace displayfile::python
