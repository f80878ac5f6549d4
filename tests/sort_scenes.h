#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "hidden/sort/hidden_surface_sort.h"
#include "tests/predicate_inputs.h"

// Scenes for the tests of the object-space sorts, as the items that they take.

namespace displayfile::test {

using Loop = std::vector<Point3>;

/// Items with the arrays that Primitives only refers to.
struct ItemList {
  using Kind = Primitives::Kind;
  std::vector<Point3> points;
  std::vector<std::uint8_t> visible;
  std::vector<Primitives::Item> items;
  std::vector<Primitives::PlanePoints> planes;  // empty, or of all items

  void add(Kind kind, const Loop& vertices, std::vector<std::uint8_t> sides = {}) {
    if (sides.empty()) sides.resize(vertices.size(), 1);
    items.push_back({static_cast<std::uint32_t>(points.size()),
                     static_cast<std::uint32_t>(vertices.size()), kind});
    points.insert(points.end(), vertices.begin(), vertices.end());
    visible.insert(visible.end(), sides.begin(), sides.end());
    if (!planes.empty()) planes.push_back({Primitives::kOwnPlane, 0, 0});
  }
  /// A polygon that counts as lying in the plane of three points.
  void solid_in(const std::array<Point3, 3>& plane, const Loop& vertices) {
    planes.resize(items.size(), {Primitives::kOwnPlane, 0, 0});
    solid(vertices);
    const auto first = static_cast<std::uint32_t>(points.size());
    planes.resize(items.size());
    planes.back() = {first, first + 1, first + 2};
    points.insert(points.end(), plane.begin(), plane.end());
    visible.resize(points.size(), 0);
  }
  void solid(const Loop& vertices) { add(Kind::solid, vertices); }
  void hollow(const Loop& vertices) { add(Kind::hollow, vertices); }
  void line(const Point3& a, const Point3& b) { add(Kind::line, {a, b}, {0, 1}); }

  std::span<const Point3> points_of(std::size_t i) const {
    return std::span(points).subspan(items[i].first, items[i].sides);
  }
  std::span<const std::uint8_t> visible_of(std::size_t i) const {
    return std::span(visible).subspan(items[i].first, items[i].sides);
  }
  Primitives view() const { return {points, {}, visible, items, planes}; }

  ItemList without(std::size_t item) const {
    ItemList rest;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i == item) continue;
      const Loop vertices{points_of(i).begin(), points_of(i).end()};
      if (view().has_own_plane(i)) {
        rest.add(items[i].kind, vertices, {visible_of(i).begin(), visible_of(i).end()});
      } else {
        const auto& [p, q, r] = planes[i];
        rest.solid_in({points[p], points[q], points[r]}, vertices);
      }
    }
    return rest;
  }
  std::string text() const {
    constexpr const char* kNames[] = {"solid", "hollow", "line"};
    std::ostringstream out;
    out.precision(17);
    for (std::size_t i = 0; i < items.size(); ++i) {
      out << i << " " << kNames[static_cast<int>(items[i].kind)];
      for (const Point3& p : points_of(i)) out << "  " << p.x << " " << p.y << " " << p.z;
      if (!view().has_own_plane(i)) out << "  in";
      for (std::size_t k = 0; k < 3 && !view().has_own_plane(i); ++k) {
        const Point3& p = points[planes[i][k]];
        out << "  " << p.x << " " << p.y << " " << p.z;
      }
      out << "\n";
    }
    return out.str();
  }
};

/// The smallest part of the scene found for which `fails` still holds.
template <class Fails>
ItemList shrunken(ItemList list, const Fails& fails) {
  for (std::size_t i = list.items.size(); i-- > 0;) {
    ItemList rest = list.without(i);
    if (fails(rest)) list = std::move(rest);
  }
  return list;
}

/// A plane over the projection.
struct Slope {
  double z0, dx = 0.0, dy = 0.0;
  Point3 at(double x, double y) const { return {x, y, z0 + dx * x + dy * y}; }
};
inline Slope any_slope(Source& s) {
  const double dx = 2.0 * s.unit() - 1.0, dy = 2.0 * s.unit() - 1.0;
  return {s.unit() - 0.5 * (dx + dy), dx, dy};
}
inline Loop on_slope(Source& s, const Slope& slope, int sides) {
  Loop loop;
  for (int k = 0; k < sides; ++k) {
    const double x = s.unit(), y = s.unit();
    loop.push_back(slope.at(x, y));
  }
  return loop;
}
inline Point3 in_cube(Source& s) {
  const double x = s.unit(), y = s.unit(), z = s.unit();
  return {x, y, z};
}
/// A multiple of 1/n in each coordinate, z of 1/m.
inline Point3 on_grid(Source& s, int n, int m) {
  const int x = s.between(0, n), y = s.between(0, n), z = s.between(0, m);
  return {static_cast<double>(x) / n, static_cast<double>(y) / n, static_cast<double>(z) / m};
}

inline Loop square(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

/// A simple polygon, mostly concave: its vertices around a centre.
inline Loop star_shaped(Source& s, const Slope& slope, int sides) {
  Loop loop;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / sides, radius = 0.08 + 0.4 * s.unit();
    loop.push_back(slope.at(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle)));
  }
  if (s.below(2) == 0) std::ranges::reverse(loop);
  return loop;
}
inline Loop convex(Source& s, const Slope& slope, int sides) {
  const double x = s.unit(), y = s.unit(), radius = 0.1 + 0.4 * s.unit(), turn = s.unit();
  Loop loop;
  for (int k = 0; k < sides; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + turn) / sides;
    loop.push_back(slope.at(x + radius * std::cos(angle), y + radius * std::sin(angle)));
  }
  if (s.below(2) == 0) std::ranges::reverse(loop);
  return loop;
}
/// A pentagram: all its vertices turn the same way, and it goes round twice.
inline Loop pentagram(Source& s, const Slope& slope) {
  Loop loop = convex(s, slope, 5);
  return {loop[0], loop[2], loop[4], loop[1], loop[3]};
}

/// Bars around a circle, each over the next one's start and under the end of the one before.
inline void add_ring_of_bars(ItemList& list, int n, double turn = 0.0, bool over = true) {
  const double radius = 0.4, pi = std::numbers::pi;
  const double width = 0.05 * std::sin(pi / n);
  const auto corner = [&](int k) {
    const double angle = 2.0 * pi * (k + turn) / n;
    return Point3{0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0.0};
  };
  for (int k = 0; k < n; ++k) {
    const Point3 a = corner(k), b = corner(k + 1), along = 0.15 * (b - a);
    const Point3 across = width / std::hypot(along.x, along.y) * Point3{-along.y, along.x, 0.0};
    const Point3 start = a - along + Point3(0, 0, over ? 0.25 : 0.75),
                 end = b + along + Point3(0, 0, over ? 0.75 : 0.25);
    list.solid({start - across, end - across, end + across, start + across});
  }
}

/// The polygons of a family of scenes, and whether they are flat.
struct SortFamily {
  std::string name;
  ItemList (*make)(Source& s);
  bool flat = true;
};

namespace families {

inline ItemList triangles(Source& s) {
  ItemList list;
  for (int k = s.between(2, 10); k > 0; --k) list.solid({in_cube(s), in_cube(s), in_cube(s)});
  return list;
}

inline ItemList quads_not_flat(Source& s) {
  ItemList list;
  const double off = std::pow(10.0, -s.between(1, 16));
  for (int k = s.between(2, 8); k > 0; --k) {
    Loop quad = convex(s, any_slope(s), 4);
    for (Point3& p : quad) p.z += off * (s.unit() - 0.5);
    list.solid(quad);
  }
  return list;
}

/// Concave and self-crossing, in a plane; some repeat a vertex or go there and back.
inline ItemList concave_and_crossing(Source& s) {
  ItemList list;
  for (int k = s.between(2, 6); k > 0; --k) {
    const Slope slope = any_slope(s);
    Loop loop;
    switch (s.below(4)) {
      case 0: loop = star_shaped(s, slope, s.between(5, 12)); break;
      case 1: loop = pentagram(s, slope); break;
      default: loop = on_slope(s, slope, s.between(3, 8)); break;
    }
    if (s.below(6) == 0) loop.insert(loop.begin() + 1, loop[1]);
    if (s.below(6) == 0) loop.insert(loop.begin() + 2, {loop[0], loop[1]});
    list.solid(loop);
  }
  return list;
}

/// Random vertices, as far off any plane as they like.
inline ItemList anything(Source& s) {
  ItemList list;
  for (int k = s.between(2, 7); k > 0; --k) {
    Loop loop;
    for (int n = s.between(3, 8); n > 0; --n) loop.push_back(in_cube(s));
    list.solid(loop);
  }
  return list;
}

/// So few places that everything touches everything.
inline ItemList tiny_grid(Source& s) {
  ItemList list;
  const int n = s.between(2, 4), m = s.between(1, 3);
  for (int k = s.between(2, 9); k > 0; --k) {
    Loop loop;
    for (int sides = s.below(2) == 0 ? 3 : s.between(3, 6); sides > 0; --sides) {
      loop.push_back(on_grid(s, n, m));
    }
    list.solid(loop);
  }
  return list;
}

inline ItemList coplanar(Source& s) {
  ItemList list;
  const Slope slopes[] = {{0.5}, {0.25, 0.25, 0.125}, {0.75, -0.5, 0.25}};
  for (int k = s.between(2, 9); k > 0; --k) {
    if (!list.items.empty() && s.below(3) == 0) {  // one more of an earlier one
      const auto again =
          list.points_of(static_cast<std::size_t>(s.below(static_cast<int>(list.items.size()))));
      Loop loop(again.begin(), again.end());
      std::rotate(loop.begin(), loop.begin() + s.below(static_cast<int>(loop.size())), loop.end());
      if (s.below(2) == 0) std::ranges::reverse(loop);
      list.solid(loop);
      continue;
    }
    Loop loop;
    const Slope& slope = slopes[s.below(3)];
    for (int n = s.between(3, 5); n > 0; --n) {
      const double x = s.between(0, 8) / 8.0, y = s.between(0, 8) / 8.0;
      loop.push_back(slope.at(x, y));
    }
    list.solid(loop);
  }
  return list;
}

/// Planes through one axis, or one point.
inline ItemList interpenetrating(Source& s) {
  ItemList list;
  const bool axis = s.below(2) == 0;
  for (int k = s.between(2, 7); k > 0; --k) {
    const double dx = s.between(-4, 4) / 4.0, dy = axis ? 0.0 : s.between(-4, 4) / 4.0;
    const Slope slope{0.5 - 0.5 * (dx + dy), dx, dy};
    list.solid(s.below(2) == 0 ? pentagram(s, slope) : convex(s, slope, s.between(3, 6)));
  }
  return list;
}

inline ItemList cycles(Source& s) {
  ItemList list;
  for (int rings = s.between(1, 2); rings > 0; --rings) {
    const int n = s.between(3, 20);
    add_ring_of_bars(list, n, s.unit(), s.below(2) == 0);
  }
  return list;
}

inline ItemList sheets_an_ulp_apart(Source& s) {
  ItemList list;
  for (int k = s.between(2, 10); k > 0; --k) {
    const double z = 0.5 + s.between(0, 6) * 0x1p-53;
    Loop loop;
    for (int n = s.between(3, 5); n > 0; --n) {
      const double x = s.unit(), y = s.unit();
      loop.push_back({x, y, z});
    }
    list.solid(loop);
  }
  return list;
}

/// Nearly one plane, and tilted.
inline ItemList nearly_coplanar(Source& s) {
  ItemList list;
  const double gap = std::pow(10.0, -s.between(3, 17));
  for (int k = s.between(2, 8); k > 0; --k) {
    Loop loop = on_slope(s, {0.3, 0.3, 1.0 / 7}, 3);
    for (Point3& p : loop) p.z += gap * s.between(-1, 1);
    list.solid(loop);
  }
  return list;
}

inline ItemList lines(Source& s) {
  ItemList list;
  const bool grid = s.below(2) == 0;
  const auto point = [&] { return grid ? on_grid(s, 4, 2) : in_cube(s); };
  for (int k = s.between(4, 12); k > 0; --k) {
    const Point3 a = point(), b = point(), c = point();
    if (s.below(2) == 0) {
      list.line(a, b);
    } else {
      list.solid({a, b, c});
    }
  }
  return list;
}

/// Solid and hollow ones and lines, some sides not drawn.
inline ItemList hollow(Source& s) {
  ItemList list;
  for (int k = s.between(3, 9); k > 0; --k) {
    const Loop loop = s.below(2) == 0 ? star_shaped(s, any_slope(s), s.between(4, 9))
                                      : convex(s, any_slope(s), s.between(3, 5));
    std::vector<std::uint8_t> visible;
    for (std::size_t i = 0; i < loop.size(); ++i) visible.push_back(s.below(4) == 0 ? 0 : 1);
    list.add(s.below(2) == 0 ? ItemList::Kind::solid : ItemList::Kind::hollow, loop, visible);
    if (s.below(3) == 0) {
      const Point3 a = in_cube(s), b = in_cube(s);
      list.line(a, b);
    }
  }
  return list;
}

/// Polygons that are lines in the projection, among others.
inline ItemList edge_on(Source& s) {
  ItemList list;
  for (int k = s.between(3, 9); k > 0; --k) {
    if (s.below(2) == 0) {
      list.solid({in_cube(s), in_cube(s), in_cube(s)});
      continue;
    }
    Loop loop;
    const double slope = s.between(-2, 2) / 2.0;
    for (int n = s.between(3, 5); n > 0; --n) {
      const double x = s.between(0, 16) / 16.0, z = s.unit();
      loop.push_back({x, 0.25 + slope * x, z});
    }
    std::vector<std::uint8_t> visible(loop.size(), 1);
    if (s.below(2) == 0) visible.assign(loop.size(), 0);
    list.add(s.below(4) == 0 ? ItemList::Kind::hollow : ItemList::Kind::solid, loop, visible);
  }
  return list;
}

/// Rectangles along the axes, level or rising at 45 degrees along one of them, on a grid: every
/// cut's coordinates are doubles, so that nothing is rounded.
inline ItemList dyadic(Source& s) {
  ItemList list;
  for (int k = s.between(2, 9); k > 0; --k) {
    const double x0 = s.between(0, 14) / 16.0, x1 = x0 + s.between(1, 8) / 16.0;
    const double y0 = s.between(0, 14) / 16.0, y1 = y0 + s.between(1, 8) / 16.0;
    const int way = s.between(-2, 2);
    const Slope slope{s.between(-4, 12) / 16.0, way == 1 || way == -1 ? way : 0.0,
                      way == 2 || way == -2 ? way / 2.0 : 0.0};
    list.solid({slope.at(x0, y0), slope.at(x1, y0), slope.at(x1, y1), slope.at(x0, y1)});
  }
  return list;
}

}  // namespace families

inline const std::vector<SortFamily>& sort_families() {
  static const std::vector<SortFamily> all = {
      {"triangles", families::triangles},
      {"quads not flat", families::quads_not_flat, false},
      {"concave and crossing", families::concave_and_crossing},
      {"anything", families::anything, false},
      {"tiny grid", families::tiny_grid, false},
      {"coplanar", families::coplanar},
      {"interpenetrating", families::interpenetrating},
      {"cycles", families::cycles},
      {"sheets an ulp apart", families::sheets_an_ulp_apart},
      {"nearly coplanar", families::nearly_coplanar},
      {"lines", families::lines},
      {"hollow", families::hollow},
      {"edge-on", families::edge_on},
      {"dyadic", families::dyadic},
  };
  return all;
}

/// Scenes of every family, each with its family's name and its seed.
template <class Use>
void for_each_scene_of_families(int of_each, const Use& use) {
  for (const SortFamily& family : sort_families()) {
    for (int seed = 0; seed < of_each; ++seed) {
      Source s(static_cast<std::uint64_t>(seed));
      use(family.make(s), family.name, seed);
    }
  }
}

/// A method with its choice of a root.
struct Way {
  std::string name;
  HiddenMethod method;
  RootChoice root = RootChoice::free;
  /// Trees may be as deep as polygons are many.
  bool is_chain() const {
    const bool by_order = root == RootChoice::last || root == RootChoice::first;
    return method == HiddenMethod::plain_bsp || (method == HiddenMethod::bsp && by_order);
  }
};
inline const std::vector<Way>& ways() {
  static const std::vector<Way> all = {
      {"bsp, last", HiddenMethod::bsp, RootChoice::last},
      {"bsp, first", HiddenMethod::bsp, RootChoice::first},
      {"bsp, sample", HiddenMethod::bsp, RootChoice::sample},
      {"bsp, free", HiddenMethod::bsp, RootChoice::free},
      {"plain bsp", HiddenMethod::plain_bsp},
      {"depth sort", HiddenMethod::depth_sort},
  };
  return all;
}
inline SortedPieces sorted(const ItemList& list, const Way& way, const Precision& precision = {},
                           int threads = 1) {
  return sort_hidden_surfaces(
      list.view(),
      {.method = way.method, .precision = precision, .root = way.root, .threads = threads});
}

/// Polygons of all sizes, enough for cells of several levels to have blocking faces: some on a
/// grid, some far outside, some steep.
inline ItemList crowd(Source& s, int polygons) {
  ItemList list;
  const bool on_a_grid = s.below(2) == 0;
  for (int k = 0; k < polygons; ++k) {
    const double size = std::pow(2.0, -s.between(0, 6)), tilt = s.below(3) == 0 ? 1.0 : 0.01;
    const Point3 at = in_cube(s);
    Loop loop;
    for (int n = s.below(3) == 0 ? s.between(4, 6) : 3; n > 0; --n) {
      const Point3 p = at + size * Point3(s.unit() - 0.5, s.unit() - 0.5, tilt * (s.unit() - 0.5));
      loop.push_back(on_a_grid ? Point3(std::round(p.x * 64.0), std::round(p.y * 64.0),
                                        std::round(p.z * 16.0)) /
                                     64.0
                               : p);
    }
    if (s.below(20) == 0) {
      list.line(loop[0], loop[1] + 2.0 * (loop[1] - loop[0]));
    } else if (s.below(20) == 0) {
      list.hollow(loop);
    } else {
      list.solid(loop);
    }
  }
  return list;
}

}  // namespace displayfile::test
