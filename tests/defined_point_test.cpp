// The predicates of points that are defined by the lines and planes that cut them (judged as in
// tests/predicates_test.cpp).

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "clip/base/error.h"
#include "hidden/exact/defined_point.h"
#include "hidden/exact/depth_order.h"
#include "hidden/exact/exact_point.h"
#include "tests/predicate_truth.h"

namespace displayfile {
namespace {

using namespace test;

/// A scene of a few stored points and planes, and points defined by them.
struct Scene {
  std::vector<Point3> points;
  std::vector<std::array<Point3, 3>> plane_points;
  struct Definition {
    DefinedPoint::Kind kind;
    std::uint32_t a = 0, b = 0, own = 0, cut = 0;
  };
  std::vector<Definition> definitions;

  std::uint32_t add_point(const Point3& p) {
    points.push_back(p);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  std::uint32_t add_plane(const std::array<Point3, 3>& p) {
    plane_points.push_back(p);
    return static_cast<std::uint32_t>(plane_points.size() - 1);
  }

  /// `count` points defined by a few stored points, of which some lie in line in the projection,
  /// and a few planes, of which some go through stored points and two are (all but) one: as pieces
  /// of polygons are, whose vertices share their definitions. Points of a line are cut where no
  /// double is.
  void define_by_few(Source& s, Input input, int count) {
    const Grid grid(s);
    const Style style(s, false);
    const Step g = step(s, 100), d = step(s, 9);
    const auto any = [&] {
      return input == Input::random ? style.point(s) : grid.place(s, g + step(s, 20));
    };
    for (std::int64_t k = 0; k < 4; ++k) {
      const Step off_line = {0, 0, s.below(2) == 0 ? 0 : s.between(-9, 9)};
      add_point(input == Input::random ? style.point(s)
                                       : grid.place(s, g + (3 * k) * d + off_line));
    }
    for (int k = 0; k < 2; ++k) add_point(any());
    const auto stored = [&] { return points[static_cast<std::size_t>(s.below(6))]; };
    add_plane({stored(), stored(), any()});
    add_plane({stored(), any(), any()});
    add_plane({any(), any(), any()});
    const auto one = plane_points[static_cast<std::size_t>(s.below(3))];
    std::array copy{one[1], one[2], one[0]};
    if (s.below(2) == 0) {  // not quite
      for (Point3& p : copy) p = {grid.nudge(s, p.x), grid.nudge(s, p.y), grid.nudge(s, p.z)};
    }
    add_plane(copy);
    for (int k = 0; k < count; ++k) {
      Definition of{static_cast<DefinedPoint::Kind>(s.below(5))};
      of.a = static_cast<std::uint32_t>(s.below(4));
      of.b = static_cast<std::uint32_t>((static_cast<int>(of.a) + 1 + s.below(3)) % 4);
      of.own = static_cast<std::uint32_t>(s.below(4));
      of.cut = static_cast<std::uint32_t>(s.below(4));
      definitions.push_back(of);
    }
  }

  void define_random(Source& s, const Style& style) {
    const auto plane = [&] { return add_plane({style.point(s), style.point(s), style.point(s)}); };
    Definition d{static_cast<DefinedPoint::Kind>(s.below(5))};
    d.a = d.kind == DefinedPoint::Kind::plane_cut ? plane() : add_point(style.point(s));
    d.b = add_point(style.point(s));
    d.own = plane();
    d.cut = plane();
    definitions.push_back(d);
  }

  /// A point that is g on the grid, except for the nudges of its definition.
  void define_at(Source& s, const Grid& grid, const Step& g) {
    const int size = step_size(s);
    const Step along = step(s, size);
    Definition d{static_cast<DefinedPoint::Kind>(s.below(5))};
    switch (d.kind) {
      case DefinedPoint::Kind::stored: d.a = add_point(grid.place(s, g)); break;
      case DefinedPoint::Kind::lifted:
        d.a = add_point(grid.place(s, {g[0], g[1], s.between(-9, 9)}));
        d.own = add_plane(plane_through(s, grid, g, size));
        break;
      case DefinedPoint::Kind::edge_cut:
        d.a = add_point(grid.place(s, g + factor(s) * along));
        d.b = add_point(grid.place(s, g + factor(s) * along));
        d.cut = add_plane(plane_through(s, grid, g, size));
        break;
      case DefinedPoint::Kind::lifted_edge_cut: {
        const Step p = g + factor(s) * along, q = g + factor(s) * along;
        d.a = add_point(grid.place(s, {p[0], p[1], s.between(-9, 9)}));
        d.b = add_point(grid.place(s, {q[0], q[1], s.between(-9, 9)}));
        d.own = add_plane(plane_through(s, grid, g, size));
        d.cut = add_plane(plane_through(s, grid, g, size));
        break;
      }
      case DefinedPoint::Kind::plane_cut:
        d.own = add_plane(plane_through(s, grid, g, size));
        d.a = add_plane(plane_through(s, grid, g, size));
        d.cut = add_plane(plane_through(s, grid, g, size));
        break;
    }
    definitions.push_back(d);
  }

  int shift() const {
    Shift shift;
    for (const Point3& p : points) shift.include(p);
    for (const auto& plane : plane_points) {
      for (const Point3& p : plane) shift.include(p);
    }
    return shift.value();
  }
  QPlane exact_plane(std::uint32_t k, int shift) const {
    const auto& p = plane_points[k];
    return {exact(p[0], shift), exact(p[1], shift), exact(p[2], shift)};
  }

  /// The point by its definition, if there is one.
  std::optional<QPoint> exact_point(std::size_t k, int shift) const {
    const Definition& d = definitions[k];
    const auto lifted = [&](std::uint32_t p) -> std::optional<QPoint> {
      const QPoint v = exact(points[p], shift);
      const QPlane own = exact_plane(d.own, shift);
      if (own.c == 0) return std::nullopt;
      return QPoint{v.x, v.y, own.z(v.x, v.y)};
    };
    switch (d.kind) {
      case DefinedPoint::Kind::stored: return exact(points[d.a], shift);
      case DefinedPoint::Kind::lifted: return lifted(d.a);
      case DefinedPoint::Kind::edge_cut:
        return meet(exact(points[d.a], shift), exact(points[d.b], shift),
                    exact_plane(d.cut, shift));
      case DefinedPoint::Kind::lifted_edge_cut: {
        const auto p = lifted(d.a), q = lifted(d.b);
        if (!p || !q) return std::nullopt;
        return meet(*p, *q, exact_plane(d.cut, shift));
      }
      case DefinedPoint::Kind::plane_cut:
        return meet(exact_plane(d.own, shift), exact_plane(d.a, shift), exact_plane(d.cut, shift));
    }
    return std::nullopt;
  }

  std::string text() const {
    std::string all;
    for (const Point3& p : points) all += "point " + hex(p) + "\n";
    for (const auto& p : plane_points) all += "plane " + hex(p[0]) + hex(p[1]) + hex(p[2]) + "\n";
    for (const Definition& d : definitions) {
      std::ostringstream out;
      out << "kind " << static_cast<int>(d.kind) << ": a " << d.a << " b " << d.b << " own "
          << d.own << " cut " << d.cut << "\n";
      all += out.str();
    }
    return all;
  }
};

/// The scene as the predicates take it; made in the rounding mode of the call.
struct Built {
  std::vector<Plane> planes;
  Definitions all;
  std::vector<DefinedPoint> points;

  explicit Built(const Scene& scene) {
    for (const auto& p : scene.plane_points) planes.emplace_back(p[0], p[1], p[2]);
    all = {scene.points, planes};
    for (const Scene::Definition& d : scene.definitions) points.push_back(build(scene, d));
  }
  DefinedPoint build(const Scene& scene, const Scene::Definition& d) const {
    switch (d.kind) {
      case DefinedPoint::Kind::stored: return stored_point(scene.points[d.a]);
      case DefinedPoint::Kind::lifted: return lifted_point(all, d.a, d.own);
      case DefinedPoint::Kind::edge_cut: return edge_cut(all, d.a, d.b, d.cut);
      case DefinedPoint::Kind::lifted_edge_cut: return lifted_edge_cut(all, d.a, d.b, d.own, d.cut);
      case DefinedPoint::Kind::plane_cut: return plane_cut(all, d.own, d.a, d.cut);
    }
    return {};
  }
};

struct SceneCase {
  Scene scene;
  unsigned with_rests = 0;  // a bit each
  std::string text() const {
    return scene.text() + "with rests: " + std::to_string(with_rests) + "\n";
  }
  /// The scene with the rests of these; a point so far away that no double holds it stays.
  Built built() const {
    Built built(scene);
    for (std::size_t k = 0; k < built.points.size(); ++k) {
      if ((with_rests >> k & 1) == 0) continue;
      try {
        built.points[k] = with_rest(built.all, built.points[k]);
      } catch (const Error&) {
      }
    }
    return built;
  }
};

/// A case whose points share their definitions.
template <class Case>
struct Sharing : Case {
  bool make(Source& s, Input input) {
    this->scene.define_by_few(s, input, Case::kPoints);
    this->with_rests = static_cast<unsigned>(s.below(1 << Case::kPoints));
    this->choose(s);
    return true;
  }
};

/// The styles whose spread keeps the rationals of a cut short enough to judge by the million,
/// and now and then one that does not.
Style style_of_cuts(Source& s) { return Style(s, s.below(20) == 0); }

struct DefinedSideCase : SceneCase {
  static constexpr int kPoints = 1;
  std::uint32_t plane = 0;
  void choose(Source& s) { plane = static_cast<std::uint32_t>(s.below(4)); }
  bool make(Source& s, Input input) {
    if (input == Input::random) {
      const Style style = style_of_cuts(s);
      scene.define_random(s, style);
      plane = scene.add_plane({style.point(s), style.point(s), style.point(s)});
    } else {
      const Grid grid(s);
      const Step g = step(s, 100);
      scene.define_at(s, grid, g);
      plane = scene.add_plane(plane_through(s, grid, g, step_size(s)));
      if (s.below(8) == 0) plane = scene.definitions[0].cut;
      if (plane >= scene.plane_points.size()) plane = 0;
    }
    return true;
  }
  std::optional<Q> truth() const {
    const int k = scene.shift();
    const auto p = scene.exact_point(0, k);
    if (!p) return std::nullopt;
    return scene.exact_plane(plane, k).at(*p);
  }
  int predicate() const {
    const Built built = this->built();
    return side_of_plane(built.all, built.points[0], built.planes[plane]);
  }
};
TEST(DefinedPoints, SideOfADefinedPointToAPlane) {
  agrees<DefinedSideCase>(Predicate::side_of_plane, 2.0);
}

struct DefinedTurnCase : SceneCase {
  static constexpr int kPoints = 3;
  static void choose(Source&) {}
  bool make(Source& s, Input input) {
    if (input == Input::random) {
      const Style style = style_of_cuts(s);
      for (int k = 0; k < 3; ++k) scene.define_random(s, style);
    } else {
      const Grid grid(s);
      const Step g = step(s, 100), d = step(s, 9);
      for (int k = 0; k < 3; ++k) {
        const Step off_line = {0, 0, s.between(-9, 9)};
        scene.define_at(s, grid, g + factor(s) * d + off_line);
      }
    }
    with_rests = static_cast<unsigned>(s.below(8));
    return true;
  }
  std::optional<Q> truth() const {
    const int k = scene.shift();
    const auto a = scene.exact_point(0, k), b = scene.exact_point(1, k),
               c = scene.exact_point(2, k);
    if (!a || !b || !c) return std::nullopt;
    return turn(*a, *b, *c);
  }
  int predicate() const {
    const Built built = this->built();
    const auto& p = built.points;
    const int turn = orientation(built.all, p[0], p[1], p[2]);
    return orientation_at_hand(built.all, p[0], p[1], p[2]).value_or(turn) == turn ? turn : 2;
  }
};
TEST(DefinedPoints, SideOfADefinedPointToALine) {
  agrees<DefinedTurnCase>(Predicate::side_of_line, 0.5);
}

TEST(DefinedPoints, SideOfAPointToALineOfPointsThatShareDefinitions) {
  agrees<Sharing<DefinedTurnCase>>(Predicate::side_of_line, 0.5);
}

struct CompareCase : SceneCase {
  static constexpr int kPoints = 2;
  int axis = 0;  // 2: by x then y
  void choose(Source& s) { axis = s.below(3); }
  bool make(Source& s, Input input) {
    choose(s);
    if (input == Input::random) {
      const Style style = style_of_cuts(s);
      for (int k = 0; k < 2; ++k) scene.define_random(s, style);
    } else {
      const Grid grid(s);
      const Step g = step(s, 100);
      Step h = s.below(2) == 0 ? g : step(s, 100);
      if (axis < 2) h[static_cast<std::size_t>(axis)] = g[static_cast<std::size_t>(axis)];
      scene.define_at(s, grid, g);
      scene.define_at(s, grid, h);
    }
    with_rests = static_cast<unsigned>(s.below(4));
    return true;
  }
  std::optional<Q> truth() const {
    const int k = scene.shift();
    const auto a = scene.exact_point(0, k), b = scene.exact_point(1, k);
    if (!a || !b) return std::nullopt;
    const QPoint d = *a - *b;
    switch (axis) {
      case 0: return d.x;
      case 1: return d.y;
      default: return d.x != 0 ? d.x : d.y;
    }
  }
  int predicate() const {
    const Built built = this->built();
    const DefinedPoint &a = built.points[0], &b = built.points[1];
    switch (axis) {
      case 0: return compare_x(built.all, a, b);
      case 1: return compare_y(built.all, a, b);
      default: {
        const int order = compare_xy(built.all, a, b);
        return compare_xy_at_hand(built.all, a, b).value_or(order) == order ? order : 2;
      }
    }
  }
};
TEST(DefinedPoints, ComparisonsOfDefinedPoints) { agrees<CompareCase>(Predicate::compare, 0.5); }

TEST(DefinedPoints, ComparisonsOfPointsThatShareDefinitions) {
  agrees<Sharing<CompareCase>>(Predicate::compare, 0.5);
}

TEST(DefinedPoints, SideOfAPointToAPlaneThatSharesItsDefinition) {
  agrees<Sharing<DefinedSideCase>>(Predicate::side_of_plane, 0.5);
}

/// Where planes nearly agree, points that they cut lie within an ulp of each other.
TEST(DefinedPoints, PointsWithRestsTakeExactArithmeticSeldom) {
  Source s(5);
  const auto near = [&](double value) { return value * (1.0 + s.between(-4, 4) * 0x1p-52); };
  const auto near_plane = [&] {
    return std::array{Point3(near(0.1), near(0.2), near(0.3)),
                      Point3(near(0.9), near(0.3), near(0.4)),
                      Point3(near(0.2), near(0.8), near(0.6))};
  };
  const DefinedPoint far_off = stored_point({0.9, 0.1, 0.5});
  long undecided = 0, undecided_with_rests = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    SceneCase c;
    const std::uint32_t from = c.scene.add_point({0.15, near(0.3), 0.2}),
                        to = c.scene.add_point({0.65, near(0.4), 0.7});
    for (int k = 0; k < 2; ++k) {
      c.scene.definitions.push_back(
          {DefinedPoint::Kind::lifted_edge_cut, from, to, c.scene.add_plane(near_plane()),
           c.scene.add_plane({Point3(0.3, 0.1, near(0.1)), Point3(near(0.4), 0.9, near(0.5)),
                              Point3(near(0.3), 0.2, 0.9)})});
    }
    for (const unsigned rests : {0U, 3U}) {
      c.with_rests = rests;
      const Built built = c.built();
      const auto& p = built.points;
      const bool at_hand = orientation_at_hand(built.all, p[0], p[1], far_off).has_value();
      (rests == 0 ? undecided : undecided_with_rests) += at_hand ? 0 : 1;
    }
  }
  EXPECT_GT(undecided, 1000);
  EXPECT_LT(undecided_with_rests, undecided / 20);
}

/// Zero where every coordinate is the double nearest to the truth.
struct RoundedCase : SceneCase {
  std::optional<QPoint> point;
  int k = 0;
  bool make(Source& s, Input input) {
    if (input == Input::random) {
      scene.define_random(s, style_of_cuts(s));
    } else {
      const Grid grid(s);
      scene.define_at(s, grid, step(s, 2));
    }
    return true;
  }
  std::optional<Q> truth() {
    k = scene.shift();
    point = scene.exact_point(0, k);
    if (!point) return std::nullopt;
    const Q largest = scaled(1e200, k);
    if (abs(point->x) > largest || abs(point->y) > largest || abs(point->z) > largest) {
      return std::nullopt;
    }
    return point->x;
  }
  /// Nearest, and even if two are equally near.
  bool nearest(double value, const Q& exact_value) const {
    const Q error = abs(scaled(value, k) - exact_value);
    for (const double other : {std::nextafter(value, 1e300), std::nextafter(value, -1e300)}) {
      const Q others = abs(scaled(other, k) - exact_value);
      if (others < error) return false;
      int exponent = 0;
      const double digits = std::frexp(value, &exponent);
      const int last = std::max(exponent - 53, -1074);
      const bool even = std::fmod(std::ldexp(digits, exponent - last), 2.0) == 0.0;
      if (others == error && !even) return false;
    }
    return true;
  }
  mutable Point3 found{0.0};
  int predicate() const {
    const Built built(scene);
    found = rounded(built.all, built.points[0]);
    return sgn(point->x);
  }
  bool right() const {
    return nearest(found.x, point->x) && nearest(found.y, point->y) && nearest(found.z, point->z);
  }
};
TEST(DefinedPoints, RoundedCoordinatesAreTheNearest) {
  for (const Input input : {Input::random, Input::near_zero}) {
    Source s(7);
    const long count = trials_are_set() ? trials() : trials() / 4;
    for (long done = 0; done < count;) {
      RoundedCase c;
      c.make(s, input);
      if (!c.truth()) continue;
      in_mode(kModes[static_cast<std::size_t>(done++ % 4)], [&c] { return c.predicate(); });
      ASSERT_TRUE(c.right()) << c.text() << hex(c.found);
    }
  }
}

/// Double-doubles determine the nearest double, except for a few that are badly conditioned.
TEST(DefinedPoints, CloseNumbersRoundAsExactOnesDoAndNearlyAlways) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const auto point = [&] {
    return Point3(coordinate(random), coordinate(random), coordinate(random));
  };
  int decided = 0;
  constexpr int kScenes = 400;
  for (int n = 0; n < kScenes; ++n) {
    std::vector<Point3> points;
    std::vector<Plane> planes;
    for (int i = 0; i < 2; ++i) points.push_back(point());
    for (int i = 0; i < 3; ++i) planes.emplace_back(point(), point(), point());
    const Definitions all{points, planes};
    for (const DefinedPoint& v : {lifted_point(all, 0, 0), edge_cut(all, 0, 1, 1),
                                  lifted_edge_cut(all, 0, 1, 0, 1), plane_cut(all, 0, 1, 2)}) {
      const ExactPoint exact = exact_point(all, v);
      const auto close = rounded_closely(all, v);
      decided += close ? 1 : 0;
      if (!close) continue;
      EXPECT_EQ(*close, Point3(rounded_quotient(exact.xyz.x, exact.w),
                               rounded_quotient(exact.xyz.y, exact.w),
                               rounded_quotient(exact.xyz.z, exact.w)));
    }
  }
  EXPECT_GE(decided, 4 * kScenes * 99 / 100);
}

/// A coordinate midway between two doubles, which no radius decides.
TEST(DefinedPoints, CloseNumbersDoNotDecideTies) {
  const std::vector<Point3> points{{0.0, 0.0, 0.0}, {1.0 + 0x1p-52, 1.0, 1.0}};
  const std::vector<Plane> planes{Plane({0.5, 0.5, 0.5}, {0.5, 1.5, 0.5}, {0.5, 0.5, 1.5})};
  const Definitions all{points, planes};
  const DefinedPoint v = edge_cut(all, 0, 1, 0);
  const ExactPoint exact = exact_point(all, v);
  EXPECT_EQ(rounded(all, v).x, 0.5);
  EXPECT_EQ(rounded(all, v).y, rounded_quotient(exact.xyz.y, exact.w));
  const std::vector<Point3> beside{{1.0, 0.0, 0.0}, {1.0 + 0x1p-52, 1.0, 0.0}};
  const std::vector<Plane> midway{Plane({0.0, 0.5, 0.0}, {1.0, 0.5, 0.0}, {0.0, 0.5, 1.0})};
  const Definitions tied{beside, midway};
  EXPECT_FALSE(rounded_closely(tied, edge_cut(tied, 0, 1, 0)));
  EXPECT_EQ(rounded(tied, edge_cut(tied, 0, 1, 0)).x, 1.0);
}

struct DepthAtPointCase : SceneCase {
  std::uint32_t first = 0, second = 0;
  bool make(Source& s, Input input) {
    if (input == Input::random) {
      const Style style = style_of_cuts(s);
      scene.define_random(s, style);
      first = scene.add_plane({style.point(s), style.point(s), style.point(s)});
      second = scene.add_plane({style.point(s), style.point(s), style.point(s)});
    } else {
      const Grid grid(s);
      const Step g = step(s, 100), up = {0, 0, s.between(-9, 9)};
      scene.define_at(s, grid, g);
      first = scene.add_plane(plane_through(s, grid, g + up, step_size(s)));
      second =
          s.below(16) == 0 ? first : scene.add_plane(plane_through(s, grid, g + up, step_size(s)));
    }
    return true;
  }
  std::optional<Q> truth() const {
    const int k = scene.shift();
    const QPlane a = scene.exact_plane(first, k), b = scene.exact_plane(second, k);
    const auto at = scene.exact_point(0, k);
    if (!at || a.c == 0 || b.c == 0) return std::nullopt;
    return a.z(at->x, at->y) - b.z(at->x, at->y);
  }
  int predicate() const {
    const Built built(scene);
    const Plane &a = built.planes[first], &b = built.planes[second];
    if (scene.definitions[0].kind == DefinedPoint::Kind::stored) {
      const Point3& at = built.points[0].near;
      return depth_order(a, b, Point2(at.x, at.y));
    }
    return depth_order(built.all, a, b, built.points[0]);
  }
};
TEST(DefinedPoints, DepthOrderAlongAProjector) {
  agrees<DepthAtPointCase>(Predicate::depth_at_point);
}

TEST(DefinedPoints, AnEdgeAndItsReverseAreCutAtTheSamePoint) {
  Source s(11);
  for (int k = 0; k < 2000; ++k) {
    const Style style(s, false);
    const std::vector<Point3> points = {style.point(s), style.point(s)};
    const std::vector<Plane> planes = {Plane(style.point(s), style.point(s), style.point(s))};
    const Definitions all{points, planes};
    EXPECT_EQ(rounded(all, edge_cut(all, 0, 1, 0)), rounded(all, edge_cut(all, 1, 0, 0)));
  }
}

TEST(DefinedPoints, AMissingPointIsAnError) {
  const std::vector<Point3> points = {{0, 0, 1}, {1, 0, 1}};
  const std::vector<Plane> planes = {Plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                                     Plane({0, 0, 2}, {1, 0, 2}, {0, 1, 2}),
                                     Plane({0, 0, 0}, {0, 1, 0}, {0, 0, 1})};
  const Definitions all{points, planes};
  const DefinedPoint parallel = edge_cut(all, 0, 1, 0);
  EXPECT_THROW(rounded(all, parallel), Error);
  EXPECT_THROW(side_of_plane(all, parallel, planes[1]), Error);
  EXPECT_THROW(rounded(all, plane_cut(all, 0, 1, 2)), Error);
}

TEST(DefinedPoints, APointTooFarForADoubleIsAnError) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const std::vector<Point3> points = {{-1e90, 0, 0}, {1e90, 0, tiny}};
  const std::vector<Plane> planes = {Plane({0, 0, 1e90}, {1, 0, 1e90}, {0, 1, 1e90})};
  const Definitions all{points, planes};
  EXPECT_THROW(rounded(all, edge_cut(all, 0, 1, 0)), Error);
  EXPECT_EQ(side_of_plane(all, edge_cut(all, 0, 1, 0), planes[0]), 0);
}

}  // namespace
}  // namespace displayfile
