// The memory of a polygon that an application enters, in bytes of operator new that are held once
// its segment is closed: for triangles with points of their own and for those that share them, in a
// display file alone and with a retained scene. It calls only long-standing routines, to be built
// with the libraries of older trees too (tests/bench/README.md, entered_bytes).
//   entered_bytes [SIDE]
// prints a line each: the bytes of a triangle and a name. They are the mean of five scenes, of 2
// SIDE^2 triangles to twice as many, since arrays that double hold up to twice what they use.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "command/counted_memory.h"  // beside this file, in older trees too
#include "displayfile/graphics_system.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile::bench {
namespace {

/// A height field of 2 n^2 triangles, inside of the default view also if it is turned.
struct Field {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
};

Field height_field(std::uint32_t n) {
  Field field;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) {
      const double x = 1.2 * i / n - 0.6, y = 1.2 * j / n - 0.6;
      field.vertices.emplace_back(x, y, 0.3 * std::sin(5.0 * x) * std::cos(7.0 * y));
    }
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      for (const std::uint32_t corner : {a, b, c, a, c, d}) field.corners.push_back(corner);
    }
  }
  return field;
}

struct Entering {
  const char* name;
  bool shared, retained, turned;
};
constexpr Entering kEnterings[] = {
    {"points of their own", false, false, false},
    {"points of their own, turned", false, false, true},
    {"shared points", true, false, false},
    {"shared points, turned", true, false, true},
    {"retained, points of their own", false, true, false},
    {"retained, points of their own, turned", false, true, true},
    {"retained, shared points", true, true, false},
    {"retained, shared points, turned", true, true, true},
};

void enter(const Field& field, const Entering& how, GraphicsSystem& system) {
  system.set_line_style({LineStyle::Kind::none});
  if (how.turned) system.rotate_z_3(30.0);
  system.open_segment(1);
  if (how.shared) {
    system.polygons_abs_3({field.vertices, field.corners});
  } else {
    for (std::size_t k = 0; k < field.corners.size(); k += 3) {
      const Point3 triangle[3]{field.vertices[field.corners[k]],
                               field.vertices[field.corners[k + 1]],
                               field.vertices[field.corners[k + 2]]};
      system.polygon_abs_3(triangle);
    }
  }
  system.close_segment();
}

double bytes_a_triangle(const Field& field, const Entering& how) {
  std::int64_t held = 0;
  counted_memory([&] {
    RetainedScene scene;
    GraphicsSystem system;
    if (how.retained) system.retain(&scene);
    enter(field, how, system);
    held = bytes_held_now();
  });
  return 3.0 * static_cast<double>(held) / static_cast<double>(field.corners.size());
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  using namespace displayfile::bench;
  const int side = argc > 1 ? std::atoi(argv[1]) : 250;
  if (side < 1 || side > 5000) {
    std::fprintf(stderr, "entered_bytes: expected a side of 1 to 5000\n");
    return 2;
  }
  constexpr int kSizes = 5;
  std::vector<Field> fields;
  for (int k = 0; k < kSizes; ++k) {
    fields.push_back(height_field(
        static_cast<std::uint32_t>(std::lround(side * std::exp2(0.5 * k / (kSizes - 1))))));
  }
  for (const Entering& how : kEnterings) {
    double sum = 0.0;
    for (const Field& field : fields) sum += bytes_a_triangle(field, how);
    std::printf("%.2f\t%s\n", sum / kSizes, how.name);
  }
  return 0;
}
