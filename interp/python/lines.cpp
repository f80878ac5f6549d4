#include "interp/python/lines.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"
#include "interp/python/entering.h"
#include "interp/python/system.h"

namespace displayfile::python {

namespace py = pybind11;

OwnLineStyle own_line_style_in(py::handle colour, py::handle width, std::string_view what) {
  OwnLineStyle style;
  style.width = if_given(width, std::string(what) + "width", number_in);
  if (colour.is_none()) return style;
  const std::vector<double> rgb = numbers_in(colour, std::string(what) + "colour");
  if (rgb.size() != 3) {
    throw Error(fmt::format("{}colour: expected red, green and blue", what));
  }
  style.colour = Colour{rgb[0], rgb[1], rgb[2]};
  return style;
}

void with_line_style(GraphicsSystem& system, const OwnLineStyle& own,
                     const std::function<void()>& enter) {
  SystemInside::keep_line_style(system, [&] {
    SystemInside::by_default(system, Setting::line_style, [&] { system.set_line_style({}); });
    LineStyle line = system.looks().attributes.line;
    if (line.kind == LineStyle::Kind::none) line = {};
    if (own.colour) line.colour = *own.colour;
    if (own.width) line.width = *own.width;
    if (line != system.looks().attributes.line) system.set_line_style(line);
    enter();
  });
}

namespace {

/// Enters lines through `counts` points each, one after another.
int polyline(System& self, py::handle points, py::handle counts, py::handle segment,
             py::handle colour, py::handle width) {
  const auto name = if_given(segment, "segment", whole_number_in);
  const std::vector<Point3> all = points_in(points, "points");
  const std::vector<std::int32_t> runs = whole_numbers_in(counts, "counts");
  const OwnLineStyle style = own_line_style_in(colour, width, "");
  return in_followed_segment(self, {name}, [&](GraphicsSystem& system) {
    with_line_style(system, style, [&] {
      std::size_t next = 0;
      for (const std::int32_t count : runs) {
        for (std::int32_t k = 0; k < count; ++k) {
          const Point3& p = all.at(next++);
          k == 0 ? system.move_abs_3(p.x, p.y, p.z) : system.line_abs_3(p.x, p.y, p.z);
        }
      }
    });
  });
}

}  // namespace

void add_lines(SystemClass& system) { system.def("_polyline", polyline); }

}  // namespace displayfile::python
