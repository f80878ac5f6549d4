// The predicates of stored points and planes against their definitions in GMP rationals, on random
// input and on exact zeros nudged by a few ulps, in every rounding mode.
// DISPLAYFILE_PREDICATE_TRIALS sets the number of each kind, for each predicate;
// DISPLAYFILE_PREDICATE_VERDICTS a folder where the rational verdicts are kept for comparison with
// the next build.

#include <gtest/gtest.h>

#include <cmath>
#include <thread>
#include <vector>

#include "hidden/exact/depth_comparison.h"
#include "hidden/exact/depth_order.h"
#include "hidden/exact/orientation.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane.h"
#include "tests/predicate_truth.h"

namespace displayfile {
namespace {

using namespace test;

// ---------------------------------------------------------------- points that are stored

struct OrientationCase {
  std::array<Point3, 3> p;
  bool make(Source& s, Input input) {
    if (input == Input::random) {
      const Style style(s, true);
      for (Point3& v : p) v = style.point(s);
      return true;
    }
    if (s.below(4) == 0) {  // on the line up to rounding
      const Style style(s, false);
      p[0] = style.point(s);
      p[1] = style.point(s);
      p[2] = p[0] + s.unit() * (p[1] - p[0]);
      return true;
    }
    const Grid grid(s);
    const Step g = step(s, s.below(2) == 0 ? 100 : 1), d = step(s, step_size(s));
    p = {grid.place(s, g), grid.place(s, g + factor(s) * d), grid.place(s, g + factor(s) * d)};
    return true;
  }
  std::optional<Q> truth() const {
    Shift shift;
    for (const Point3& v : p) shift.include(v);
    const int k = shift.value();
    return turn(exact(p[0], k), exact(p[1], k), exact(p[2], k));
  }
  int predicate() const { return orientation(p[0], p[1], p[2]); }
  std::string text() const { return hex(p[0]) + hex(p[1]) + hex(p[2]); }
};
TEST(Predicates, OrientationInTheProjection) {
  agrees<OrientationCase>(Predicate::orientation_2, 2.0);
}

struct FourPoints {
  std::array<Point3, 4> p;
  bool make(Source& s, Input input) {
    if (input == Input::random) {
      const Style style(s, true);
      for (Point3& v : p) v = style.point(s);
      return true;
    }
    if (s.below(4) == 0) {
      const Style style(s, false);
      for (int k = 0; k < 3; ++k) p[static_cast<std::size_t>(k)] = style.point(s);
      p[3] = p[0] + s.unit() * (p[1] - p[0]) + s.unit() * (p[2] - p[0]);
      return true;
    }
    const Grid grid(s);
    const int size = step_size(s);
    const Step g = step(s, s.below(2) == 0 ? 100 : 1), u = step(s, size), v = step(s, size);
    for (Point3& w : p) w = grid.place(s, g + factor(s) * u + factor(s) * v);
    return true;
  }
  std::optional<Q> truth() const {
    Shift shift;
    for (const Point3& v : p) shift.include(v);
    const int k = shift.value();
    return QPlane(exact(p[0], k), exact(p[1], k), exact(p[2], k)).at(exact(p[3], k));
  }
  std::string text() const { return hex(p[0]) + hex(p[1]) + hex(p[2]) + hex(p[3]); }
};
struct Orientation3Case : FourPoints {
  int predicate() const { return orientation(p[0], p[1], p[2], p[3]); }
};
TEST(Predicates, OrientationOfFourPoints) {
  agrees<Orientation3Case>(Predicate::orientation_3, 2.0);
}

struct SideOfPlaneCase : FourPoints {
  int predicate() const { return side_of_plane(p[3], Plane(p[0], p[1], p[2])); }
};
TEST(Predicates, SideOfAPlane) { agrees<SideOfPlaneCase>(Predicate::side_of_plane, 2.0); }

struct PlaneFacingCase : OrientationCase {
  int predicate() const { return facing(Plane(p[0], p[1], p[2])); }
};
TEST(Predicates, FacingOfAPlane) { agrees<PlaneFacingCase>(Predicate::orientation_2); }

// ---------------------------------------------------------------- pixel centres

struct CentresCase {
  double y = 0.0;
  std::int32_t pixels = 1, index = 0;
  bool make(Source& s, Input input) {
    const CentreGrid grid(s);
    pixels = grid.size.height;
    index = grid.row;
    if (input == Input::random) {
      y = Style(s, true).draw(s);
      return true;
    }
    Grid by_ulps(s);
    y = by_ulps.nudge(
        s, s.below(2) == 0 ? static_cast<double>(grid.y) * grid.y_step : (index + 0.5) / pixels);
    return true;
  }
  std::optional<Q> truth() const { return scaled(y, 0) * Q(pixels) - (Q(index) + Q(1, 2)); }
  int predicate() const { return compare_with_centres(y, pixels, index); }
  std::string text() const {
    std::ostringstream out;
    out << std::hexfloat << y << " row " << index << " of " << pixels;
    return out.str();
  }
};
TEST(Predicates, VertexAgainstARow) { agrees<CentresCase>(Predicate::row); }

struct CrossingCase {
  Point3 a, b;
  PixelCentre centre{0, 0, {1, 1}};
  bool make(Source& s, Input input) {
    const CentreGrid grid(s);
    centre = grid.centre();
    if (input == Input::random) {
      const Style style(s, true);
      a = style.point(s);
      b = style.point(s);
    } else {
      const Grid by_ulps(s);
      const std::int64_t dx = s.between(-9, 9), dy = factor(s), m = factor(s), n = factor(s);
      const auto place = [&](std::int64_t k) {
        return Point3(by_ulps.nudge(s, static_cast<double>(grid.x + k * dx) * grid.x_step),
                      by_ulps.nudge(s, static_cast<double>(grid.y + k * dy) * grid.y_step), 0.0);
      };
      a = place(m);
      b = place(n);
      if (s.below(4) == 0) {  // through the centre up to rounding
        const Style style(s, false);
        const double t = 1.0 + s.unit();
        a = style.point(s);
        b = {a.x + t * (centre.x - a.x), a.y + t * (centre.y - a.y), 0.0};
      } else if (s.below(3) == 0) {  // so short that the centre's own rounding decides
        centre = grid.any_centre(s);
        const double ulp = std::ldexp(1.0, -s.between(44, 53));
        const auto close = [&](double k) {
          return Point3(by_ulps.nudge(s, centre.x + k * ulp * static_cast<double>(dx)),
                        by_ulps.nudge(s, centre.y + k * ulp * static_cast<double>(dy)), 0.0);
        };
        a = close(static_cast<double>(m));
        b = close(static_cast<double>(n));
      }
    }
    return a.y != b.y;
  }
  Q crossing_x() const {
    const QPoint c = centre_of(centre), p = exact(a, 0), q = exact(b, 0);
    return p.x + (c.y - p.y) * (q.x - p.x) / (q.y - p.y);
  }
  std::optional<Q> truth() const { return crossing_x() - centre_of(centre).x; }
  int predicate() const { return crossing(Point2(a.x, a.y), Point2(b.x, b.y), centre); }
  std::string text() const { return hex(a) + hex(b) + text_of(centre); }
};
TEST(Predicates, CentreAgainstAnEdge) { agrees<CrossingCase>(Predicate::crossing, 2.0); }

struct FirstColumnCase : CrossingCase {
  // Zero where the column is the one of the definition; one off in either direction otherwise.
  std::int32_t expected = 0;
  bool make(Source& s, Input input) {
    if (!CrossingCase::make(s, input)) return false;
    find_expected();
    return true;
  }
  void find_expected() {
    const Q from_centre = crossing_x() * Q(centre.size.width) - Q(1, 2);
    mpz_class column;
    mpz_cdiv_q(column.get_mpz_t(), from_centre.get_num_mpz_t(), from_centre.get_den_mpz_t());
    const mpz_class width = centre.size.width;
    expected = static_cast<std::int32_t>(
        (column < 0 ? mpz_class(0) : (column > width ? width : column)).get_si());
  }
  std::optional<Q> truth() const {
    return Q(expected == 0 ? -1 : (expected == centre.size.width ? 1 : 0));
  }
  int predicate() const {
    const std::int32_t found =
        first_column_after_crossing(Point2(a.x, a.y), Point2(b.x, b.y), centre.row, centre.size);
    if (found != expected) return 2;
    return expected == 0 ? -1 : (expected == centre.size.width ? 1 : 0);
  }
};
TEST(Predicates, FirstColumnAfterAnEdge) { agrees<FirstColumnCase>(Predicate::crossing); }

// ---------------------------------------------------------------- order in depth

struct DepthAtPixelCase {
  std::array<Point3, 6> p;
  PixelCentre centre{0, 0, {1, 1}};
  bool make(Source& s, Input input) {
    const CentreGrid grid(s);
    centre = grid.centre();
    if (input == Input::random) {
      const Style style(s, s.below(4) == 0);
      for (Point3& v : p) v = style.point(s);
      return true;
    }
    if (s.below(4) == 0) {  // through one point near the centre, with every digit in use
      centre = grid.any_centre(s);
      const double z = s.unit();
      for (std::size_t k = 0; k < 6; k += 3) {
        const double up = s.unit() - 0.5, across = s.unit() - 0.5;
        for (std::size_t i = k; i < k + 3; ++i) {
          const double x = s.unit(), y = s.unit();
          p[i] = {x, y, z + up * (y - centre.y) + across * (x - centre.x)};
        }
      }
      return true;
    }
    if (s.below(4) == 0) {  // sheets an ulp or so apart, tilted alike
      const Style style(s, false);
      const Grid by_ulps(s);
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = p[k + 3] = style.point(s);
        p[k + 3].z = by_ulps.nudge(s, p[k + 3].z);
      }
      return true;
    }
    const Grid by_ulps(s);
    const int z_exponent = s.between(-30, 0);
    const std::int64_t z = s.between(-1000, 1000);
    // On the grid, or so small that the centre's own rounding decides.
    const double ulp = s.below(4) == 0 ? std::ldexp(1.0, -s.between(44, 53)) : 0.0;
    if (ulp > 0.0) centre = grid.any_centre(s);
    const auto place = [&](const Step& d) {
      const auto dx = static_cast<double>(d[0]), dy = static_cast<double>(d[1]);
      const double x =
          ulp > 0.0 ? centre.x + dx * ulp : (static_cast<double>(grid.x) + dx) * grid.x_step;
      const double y =
          ulp > 0.0 ? centre.y + dy * ulp : (static_cast<double>(grid.y) + dy) * grid.y_step;
      return Point3(by_ulps.nudge(s, x), by_ulps.nudge(s, y),
                    by_ulps.nudge(s, std::ldexp(static_cast<double>(z + d[2]), z_exponent)));
    };
    for (std::size_t k = 0; k < 6; k += 3) {
      const Step u = step(s, step_size(s)), v = step(s, step_size(s));
      p[k] = place(u);
      p[k + 1] = place(v);
      p[k + 2] = place(-1 * u + -1 * v);
    }
    return true;
  }
  std::optional<Q> truth() const {
    const QPlane a(exact(p[0], 0), exact(p[1], 0), exact(p[2], 0));
    const QPlane b(exact(p[3], 0), exact(p[4], 0), exact(p[5], 0));
    if (a.c == 0 || b.c == 0) return std::nullopt;
    const QPoint at = centre_of(centre);
    return a.z(at.x, at.y) - b.z(at.x, at.y);
  }
  int predicate() const {
    return depth_order(Plane(p[0], p[1], p[2]), Plane(p[3], p[4], p[5]), centre);
  }
  std::string text() const {
    std::string all;
    for (const Point3& v : p) all += hex(v);
    return all + text_of(centre);
  }
};
TEST(Predicates, DepthOrderAtAPixel) { agrees<DepthAtPixelCase>(Predicate::depth_at_pixel); }

/// By a comparison that is kept: prepared when needed, or from the start. Of some planes two or
/// three of the defining points are the same.
struct ComparedDepthsCase : DepthAtPixelCase {
  bool ready_first = false;
  bool make(Source& s, Input input) {
    ready_first = s.below(2) == 0;
    if (!DepthAtPixelCase::make(s, input)) return false;
    const std::size_t common = s.below(3) == 0 ? 2 + (s.below(4) == 0 ? 1 : 0) : 0;
    const auto from = static_cast<std::size_t>(s.below(3)),
               to = static_cast<std::size_t>(s.below(3));
    for (std::size_t k = 0; k < common; ++k) p[3 + (to + k) % 3] = p[(from + k) % 3];
    if (s.below(2) == 0) std::swap(p[3], p[4]);
    return true;
  }
  int predicate() const {
    DepthComparison comparison(Plane(p[0], p[1], p[2]), Plane(p[3], p[4], p[5]));
    if (ready_first) comparison.make_ready();
    const int first = comparison.order(centre);
    return comparison.order(centre) == first ? first : 2;
  }
};
TEST(Predicates, DepthsComparedOften) { agrees<ComparedDepthsCase>(Predicate::depth_at_pixel); }

TEST(Predicates, PlanesComparedAreOneOrParallel) {
  const Point3 p(0.1, 0.2, 0.375), q(0.7, 0.1, 0.5), r(0.3, 0.9, 0.125);
  const Point3 up(0.0, 0.0, 0x1p-50);  // no sum with it is rounded
  DepthComparison same(Plane(p, q, r), Plane(q, r, p)), turned(Plane(p, q, r), Plane(p, r, q)),
      above(Plane(p + up, r + up, q + up), Plane(p, q, r));
  for (DepthComparison* comparison : {&same, &turned, &above}) comparison->make_ready();
  for (const Point2 at : {Point2(0.0, 0.0), Point2(1e100, -1e100), Point2(1e-300, 0.3)}) {
    EXPECT_EQ(same.order_at_hand(at), 0);
    EXPECT_EQ(turned.order_at_hand(at), 0);
    EXPECT_EQ(above.order(at), 1);
  }
}

/// x + 2^-k y or x - 2^-k y against 1/2, at (1/2, 1/2): coefficients that lie ever farther apart.
TEST(Predicates, PlanesComparedDifferInTheSmallestCoefficient) {
  const Plane level(Point3(0.0, 0.0, 0.5), Point3(1.0, 0.0, 0.5), Point3(0.0, 1.0, 0.5));
  for (int k = 1; k <= 200; ++k) {
    for (const int sign : {-1, 0, 1}) {
      const double y_slope = sign * std::ldexp(1.0, -k);
      const Plane tilted(Point3(0.0, 0.0, 0.0), Point3(1.0, 0.0, 1.0), Point3(0.0, 1.0, y_slope));
      DepthComparison comparison(tilted, level);
      comparison.make_ready();
      EXPECT_EQ(comparison.order(PixelCentre(0, 0, {1, 1})), sign) << "k = " << k;
    }
  }
}

TEST(Predicates, CountsSumOverThreads) {
  reset_predicate_counts();
  const auto tie = [] { return orientation(Point2(0, 0), Point2(1, 1), Point2(3, 3)); };
  EXPECT_EQ(tie(), 0);
  std::thread([&] {
    EXPECT_EQ(tie(), 0);
    EXPECT_EQ(tie(), 0);
  }).join();
  const auto count = [] {
    return predicate_counts()[static_cast<std::size_t>(Predicate::orientation_2)].exact;
  };
  EXPECT_EQ(count(), 3u);
  reset_predicate_counts();
  EXPECT_EQ(count(), 0u);
}

}  // namespace
}  // namespace displayfile
