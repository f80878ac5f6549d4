#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "clip/base/collected_text.h"
#include "clip/base/error.h"
#include "displayfile/looks/colour_words.h"
#include "displayfile/looks/height_colours.h"
#include "displayfile/user_routines/axes.h"
#include "hidden/triangles/triangulation.h"
#include "interp/files/png_file.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"
#include "interp/python/system.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

py::tuple colour_of(py::handle name, py::handle what) {
  const std::string word = word_in(name, "colour");
  const auto colour = colour_of_word(word);
  if (!colour) {
    throw Error(fmt::format("{}:{} expected the name of a colour, #rrggbb, or red, green and blue",
                            word_in(what, "what"), nearest_colour_name(word)));
  }
  return py::make_tuple(colour->r, colour->g, colour->b);
}

py::array height_colours(int steps) {
  std::vector<Point3> colours;
  for (int k = 0; k < steps; ++k) colours.push_back(height_colour((k + 0.5) / steps));
  return owned(std::move(colours));
}

py::list ticks(double low, double high) {
  constexpr int kMostSteps = 8;
  py::list all;
  for (const double tick : axis_ticks(low, high, kMostSteps)) {
    all.append(py::make_tuple(tick, axis_number(tick)));
  }
  return all;
}

/// The vertices of triangles that tile the faces, their corners among those of the faces, the face
/// of each, and the number of faces.
py::tuple triangles_of(py::handle vertices, py::handle faces, py::handle sides) {
  const std::vector<Point3> points = points_in(vertices, "vertices");
  const Faces polygons = faces_in(faces, sides, points.size());
  const std::size_t count =
      polygons.sides.empty() ? polygons.corners.size() / 3 : polygons.sides.size();
  std::vector<std::int64_t> vertex_of, corner_of, face;
  Triangulation triangulation;
  std::vector<Point3> polygon;
  std::size_t first = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t n = polygons.sides.empty() ? 3 : polygons.sides[k];
    if (n < 3 || first + n > polygons.corners.size()) {
      throw Error(fmt::format("face {} of {} corners: expected at least 3, and all of them", k, n));
    }
    const auto of_face = std::span(polygons.corners).subspan(first, n);
    polygon.clear();
    for (const std::uint32_t corner : of_face) polygon.push_back(points[corner]);
    for (const auto& triangle : triangulation.triangulate(polygon)) {
      for (const std::uint32_t corner : triangle.vertex) {
        vertex_of.push_back(of_face[corner]);
        corner_of.push_back(static_cast<std::int64_t>(first + corner));
      }
      face.push_back(static_cast<std::int64_t>(k));
    }
    first += n;
  }
  const auto triangles = static_cast<py::ssize_t>(face.size());
  return py::make_tuple(owned<std::int64_t>(std::move(vertex_of), {triangles, 3}),
                        owned<std::int64_t>(std::move(corner_of), {triangles, 3}),
                        owned(std::move(face)), count);
}

/// A PNG file of an array (H, W, 4) of bytes.
py::bytes png_of(const py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>& of) {
  if (of.ndim() != 3 || of.shape(2) != 4) throw Error("pixels: expected shape (H, W, 4)");
  Picture picture{static_cast<int>(of.shape(1)), static_cast<int>(of.shape(0)), {}, {}, {}};
  picture.pixels.resize(static_cast<std::size_t>(of.shape(0) * of.shape(1)));
  std::memcpy(picture.pixels.data(), of.data(), 4 * picture.pixels.size());
  for (std::uint32_t& pixel : picture.pixels) pixel = in_bytes(pixel);
  CollectedText written;
  written.exceptions(std::ios::badbit);
  write_png(picture, written);
  return py::bytes(std::move(written).str());
}

}  // namespace

void add_scalars(py::module_& module) {
  module.def("_colour_of", colour_of);
  module.def("_height_colours", height_colours);
  module.def("_ticks", ticks);
  module.def("_number", axis_number);
  module.def("_triangles_of", triangles_of);
  module.def("_png_of", png_of);
}

}  // namespace displayfile::python
