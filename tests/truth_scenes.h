#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"

// Small random scenes in which everything touches everything, entered straight into a display
// file, so that nothing is clipped and no coordinate is rounded on the way.

namespace displayfile::test {

/// Random numbers that are the same on every machine.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}
  int from(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<std::uint32_t>(high - low + 1));
  }
  bool one_in(int n) { return from(1, n) == 1; }
  double part() { return static_cast<double>(random_()) / 4294967296.0; }
  template <class T, std::size_t n>
  T of(const std::array<T, n>& choices) {
    return choices[random_() % n];
  }

 private:
  std::mt19937 random_;
};

using Vertices = std::vector<Point3>;

inline void enter(Segment& segment, const Vertices& vertices) {
  segment.enter_polygon(vertices, std::vector<std::uint8_t>(vertices.size(), 1));
}

/// One segment of polygons that are picked 0, 1, 2, ... in this order.
inline DisplayFile file_of(const std::vector<Vertices>& polygons, const LineStyle& lines = {}) {
  DisplayFile file;
  Segment& segment = file.create(1);
  segment.set_style(lines);
  for (std::size_t k = 0; k < polygons.size(); ++k) {
    segment.set_pick(static_cast<std::int32_t>(k));
    enter(segment, polygons[k]);
  }
  return file;
}

/// The item buffer as rows of letters, top row first; '.' is background.
inline std::string letters_of(const Picture& picture) {
  std::string text;
  for (std::size_t k = 0; k < picture.ids.size(); ++k) {
    text += picture.ids[k] < 0 ? '.' : static_cast<char>('a' + picture.ids[k]);
    if ((k + 1) % static_cast<std::size_t>(picture.width) == 0) text += '\n';
  }
  return text;
}

/// The number of places in which two item buffers of a size differ.
inline std::size_t different(const std::vector<std::int32_t>& a,
                             const std::vector<std::int32_t>& b) {
  std::size_t n = 0;
  for (std::size_t k = 0; k < a.size(); ++k) n += a[k] != b[k] ? 1 : 0;
  return n;
}

/// `sides` vertices: some polygons are concave or self-crossing.
template <class Vertex>
Vertices polygon(int sides, Vertex&& vertex) {
  Vertices vertices;
  for (int k = 0; k < sides; ++k) vertices.push_back(vertex());
  return vertices;
}

/// The polygons of a family of scenes: one after the other.
struct SceneFamily {
  std::string name;
  Vertices (*polygon)(Dice& dice);
  void (*transform)(Dice& dice, ImageTransformation& image) = nullptr;
};

namespace scenes {

/// A step of n from -n/4 to 5n/4 over n: on the picture and around it.
inline double step(Dice& dice, int n) {
  return static_cast<double>(dice.from(-n / 4, n + n / 4)) / n;
}

inline Vertices on_a_grid(Dice& dice) {
  return polygon(dice.from(3, 9), [&] {
    const double x = step(dice, 8), y = step(dice, 8);
    return Point3{x, y, dice.from(0, 4) / 4.0};
  });
}

inline Vertices on_pixel_centres(Dice& dice) {  // of 32 x 32
  return polygon(dice.from(3, 7), [&] {
    const double x = (2 * dice.from(-2, 33) + 1) / 64.0, y = (2 * dice.from(-2, 33) + 1) / 64.0;
    return Point3{x, y, dice.from(0, 2) / 2.0};
  });
}

inline Vertices on_thirds_and_tenths(Dice& dice) {  // coordinates and products that are rounded
  const int n = dice.of(std::array{3, 7, 10, 13});
  return polygon(dice.from(3, 6), [&] {
    const double x = step(dice, n), y = step(dice, n);
    return Point3{x, y, dice.from(0, 5) / 10.0};
  });
}

inline Vertices degenerate(Dice& dice) {
  Vertices v = on_a_grid(dice);
  switch (dice.from(0, 4)) {
    case 0: v.insert(v.begin() + dice.from(0, 2), v[1]); break;  // repeated
    case 1:
      v.resize(3);
      v[2] = v[0];
      break;  // zero area
    case 2:   // edge-on
      for (Point3& p : v) p.y = 2.0 * p.x - 0.5;
      break;
    case 3: v.insert(v.end(), v.rbegin(), v.rend()); break;  // there and back
    default:
      v.push_back(v[0]);
      v.push_back(v[1]);
      break;
  }
  return v;
}

inline Vertices coplanar(Dice& dice) {  // all on one tilted plane, or an ulp above it
  const bool above = dice.one_in(4);
  return polygon(dice.from(3, 6), [&] {
    const double x = step(dice, 8), y = step(dice, 8);
    const double z = 0.25 + 0.25 * x + 0.125 * y;
    return Point3{x, y, above ? std::nextafter(z, 2.0) : z};
  });
}

inline Vertices nearly_coplanar(Dice& dice) {
  const double slope_x = 0.3, slope_y = 1.0 / 7, gap = std::pow(10.0, -dice.from(3, 17));
  return polygon(3, [&] {
    const double x = step(dice, 10), y = step(dice, 10);
    return Point3{x, y, 0.3 + slope_x * x + slope_y * y + gap * dice.from(-1, 1)};
  });
}

inline Vertices interpenetrating(Dice& dice) {  // planes through one axis
  const double slope = dice.from(-4, 4) / 4.0;
  return polygon(dice.from(3, 5), [&] {
    const double x = step(dice, 16), y = step(dice, 16);
    return Point3{x, y, 0.5 + slope * (x - 0.5)};
  });
}

inline Vertices sheets_an_ulp_apart(Dice& dice) {
  const double z = 0.5 + dice.from(0, 5) * 0x1p-53;
  return polygon(dice.from(3, 6), [&] {
    const double x = step(dice, 9), y = step(dice, 9);
    return Point3{x, y, z};
  });
}

inline Vertices slivers_through_centres(Dice& dice) {
  const double y0 = dice.part(), slope = dice.from(-2, 2) / 4.0;
  const double x0 = -0.25, x1 = 1.25, y1 = y0 + slope * (x1 - x0);
  const double nudge = dice.from(-3, 3) * 0x1p-54;
  const double centre = (2 * dice.from(0, 31) + 1) / 64.0;
  switch (dice.from(0, 2)) {
    case 0: return {{x0, y0, 0}, {x1, y1, 1}, {x1, y1 + 0x1p-40, 0}};
    case 1: return {{x0, centre, 0}, {x1, centre + nudge, 1}, {0.5, 1, 0.5}};
    default: return {{centre, -1, 0}, {centre + nudge, 2, 1}, {x0, 0.5, 0.5}};
  }
}

inline Vertices huge_with_small_detail(Dice& dice) {
  const double offset = std::ldexp(1.0, dice.of(std::array{20, 45, 60, 200}));
  Vertices v = {{-offset, -offset, dice.from(-1, 1) * offset},
                {offset, -offset + dice.from(0, 3), dice.from(-1, 1) * offset},
                {step(dice, 8), offset, dice.from(0, 4) * 0x1p-20}};
  if (dice.one_in(2)) v.emplace_back(step(dice, 8) * 0x1p-30 + 0.5, 0.5, 0.5);
  return v;
}

inline Vertices tiny(Dice& dice) {  // depths far below 1, and polygons between the centres
  const double unit = dice.of(std::array{0x1p-1074, 0x1p-1022, 0x1p-500});
  return polygon(dice.from(3, 5), [&] {
    const double near = dice.one_in(3) ? 0x1p-60 : 1.0;
    return Point3{step(dice, 6) * near, step(dice, 6) * near, dice.from(-5, 5) * unit};
  });
}

inline Vertices far_apart_in_depth(Dice& dice) {
  const double depth = dice.of(std::array{1e-9, 1.0, 1e9, 1e90});
  return polygon(dice.from(3, 5), [&] {
    return Point3{step(dice, 5), step(dice, 5), dice.from(-3, 3) * depth};
  });
}

inline Vertices anything(Dice& dice) {
  return polygon(dice.from(3, 9), [&] {
    const double x = 1.5 * dice.part() - 0.25, y = 1.5 * dice.part() - 0.25;
    return Point3{x, y, dice.part()};
  });
}

inline Vertices mixed(Dice& dice) {
  return dice.of(std::array{on_a_grid, on_pixel_centres, on_thirds_and_tenths, degenerate, coplanar,
                            interpenetrating, sheets_an_ulp_apart, slivers_through_centres,
                            huge_with_small_detail, tiny, far_apart_in_depth, anything})(dice);
}

inline void turned_and_moved(Dice& dice, ImageTransformation& image) {
  image.scale = {dice.from(-3, 3) / 2.0, dice.of(std::array{1.0, -1.0, 1.1, 0.0})};
  image.rotation = dice.of(std::array{0.0, 30.0, 45.0, 90.0, 180.0, -17.3});
  image.translation = {dice.from(0, 4) / 4.0, dice.from(0, 10) / 10.0};
}

inline Vertices far_from_the_origin(Dice& dice) {  // brought back by the transformation
  Vertices v = on_a_grid(dice);
  for (Point3& p : v) p += Point3{1e6, -1e6, 0};
  return v;
}

inline void back_to_the_origin(Dice&, ImageTransformation& image) {
  image.translation = {-1e6, 1e6};
}

}  // namespace scenes

inline const std::vector<SceneFamily>& scene_families() {
  static const std::vector<SceneFamily> families = {
      {"on a grid", scenes::on_a_grid},
      {"on pixel centres", scenes::on_pixel_centres},
      {"on thirds and tenths", scenes::on_thirds_and_tenths},
      {"degenerate", scenes::degenerate},
      {"coplanar", scenes::coplanar},
      {"nearly coplanar", scenes::nearly_coplanar},
      {"interpenetrating", scenes::interpenetrating},
      {"sheets an ulp apart", scenes::sheets_an_ulp_apart},
      {"slivers through centres", scenes::slivers_through_centres},
      {"huge with small detail", scenes::huge_with_small_detail},
      {"tiny", scenes::tiny},
      {"far apart in depth", scenes::far_apart_in_depth},
      {"anything", scenes::anything},
      {"turned and moved", scenes::on_a_grid, scenes::turned_and_moved},
      {"far from the origin", scenes::far_from_the_origin, scenes::back_to_the_origin},
      {"mixed", scenes::mixed},
      {"mixed, turned and moved", scenes::mixed, scenes::turned_and_moved},
  };
  return families;
}

/// A scene of up to three segments and `polygons` polygons; now and then a hollow fill, a segment
/// that is not visible, and a pick identifier that is used twice. Sides are drawn in that style.
inline DisplayFile scene(const SceneFamily& family, std::uint32_t seed, int polygons,
                         const LineStyle& lines = {LineStyle::Kind::none}) {
  Dice dice(seed);
  DisplayFile file;
  int name = 0;
  for (int k = 0; k < polygons; ++k) {
    if (k == 0 || (name < 3 && dice.one_in(4))) {
      Segment& segment = file.create(++name);
      if (family.transform != nullptr) family.transform(dice, segment.image);
      segment.visible = !dice.one_in(8);
    }
    Segment& segment = file.segment(name);
    const bool hollow = dice.one_in(10);
    segment.set_style(FillStyle{hollow ? FillStyle::Kind::hollow : FillStyle::Kind::solid});
    segment.set_style(lines);
    segment.set_pick(dice.one_in(10) ? 0 : k);
    enter(segment, family.polygon(dice));
  }
  return file;
}

struct PictureShape {
  int width, height;
};
inline constexpr std::array<PictureShape, 9> kSmallShapes = {
    {{32, 32}, {7, 13}, {33, 1}, {1, 1}, {32, 17}, {31, 33}, {1, 32}, {1023, 1}, {1, 513}}};

}  // namespace displayfile::test
