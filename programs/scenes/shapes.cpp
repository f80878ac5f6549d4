#include "programs/scenes/shapes.h"

#include <algorithm>
#include <cmath>

namespace displayfile {

double power_of_ten(int exponent) {
  double power = 1.0;  // exact up to 10^22
  for (int i = 0; i < std::abs(exponent); ++i) power *= 10.0;
  return exponent < 0 ? 1.0 / power : power;
}

double gap(double severity) { return power_of_ten(-static_cast<int>(severity)); }

double nudged(double x, int ulps) {
  const double toward = ulps < 0 ? -HUGE_VAL : HUGE_VAL;
  for (int i = 0; i < std::abs(ulps); ++i) x = std::nextafter(x, toward);
  return x;
}

Point2 on_circle(double turns) {
  turns -= std::floor(turns);
  const int eighth = static_cast<int>(turns * 8.0);
  const bool mirrored = eighth % 2 != 0;
  const double rest = turns - eighth / 8.0;
  const double angle = (mirrored ? 0.125 - rest : rest) * 6.283185307179586;
  double cosine = 0.0, sine = 0.0, term = 1.0;  // Taylor's series, which ends fast below pi/4
  for (int k = 0; k < 20; ++k) {
    (k % 2 == 0 ? cosine : sine) += k % 4 < 2 ? term : -term;
    term *= angle / (k + 1);
  }
  if (mirrored) std::swap(cosine, sine);
  switch (eighth / 2) {
    case 0: return {cosine, sine};
    case 1: return {-sine, cosine};
    case 2: return {-cosine, -sine};
    default: return {sine, -cosine};
  }
}

Polygon rectangle(double x_min, double y_min, double x_max, double y_max, const Sheet& sheet) {
  return {sheet.point(x_min, y_min), sheet.point(x_max, y_min), sheet.point(x_max, y_max),
          sheet.point(x_min, y_max)};
}

Polygon regular(std::size_t sides, const Point2& centre, double radius, double turn,
                const Sheet& sheet) {
  Polygon polygon;
  for (std::size_t i = 0; i < sides; ++i) {
    const double turns = turn + static_cast<double>(i) / static_cast<double>(sides);
    polygon.push_back(sheet.point(centre + radius * on_circle(turns)));
  }
  return polygon;
}

Polygon bar(const Point3& a, const Point3& b, double width, double roll) {
  const Point2 along(b.x - a.x, b.y - a.y);
  const double length = std::sqrt(along.x * along.x + along.y * along.y);
  const Point3 half(-along.y / length * width / 2.0, along.x / length * width / 2.0, roll / 2.0);
  return {a - half, b - half, b + half, a + half};
}

Point2 random_place(Random& random, const Range& range) {
  const double x = random.between(range.low, range.high);
  return {x, random.between(range.low, range.high)};
}

Point3 random_point(Random& random, const Range& z) {
  const Point2 place = random_place(random);
  return {place, random.between(z.low, z.high)};
}

Polygon random_triangle(Random& random, const Sheet& sheet) {
  Polygon triangle;
  for (int i = 0; i < 3; ++i) triangle.push_back(sheet.point(random_place(random)));
  return triangle;
}

Polygon random_triangle(Random& random) {
  Polygon triangle;
  for (int i = 0; i < 3; ++i) triangle.push_back(random_point(random));
  return triangle;
}

Polygon random_regular(Random& random, std::size_t sides, const Range& place, const Range& radius,
                       const Sheet& sheet) {
  const Point2 centre = random_place(random, place);
  const double size = random.between(radius.low, radius.high);
  return regular(sides, centre, size, random.unit(), sheet);
}

Sheet random_sheet(Random& random, double z0, double slope) {
  const Point2 slopes = random_place(random, {-0.5 * slope, 0.5 * slope});
  return {z0 - 0.5 * (slopes.x + slopes.y), slopes.x, slopes.y};
}

Sheet any_sheet(Random& random) {
  const double z = random.between(0.3, 0.7);
  return random_sheet(random, z, 0.5);
}

std::vector<Polygon> box(const Point3& low, const Point3& high, const Point2& shear) {
  const auto corner = [&](int i) {
    const double z = i & 4 ? high.z : low.z;
    return Point3((i & 1 ? high.x : low.x) + shear.x * z, (i & 2 ? high.y : low.y) + shear.y * z,
                  z);
  };
  const auto face = [&](int a, int b, int c, int d) {
    return Polygon{corner(a), corner(b), corner(c), corner(d)};
  };
  return {face(0, 2, 3, 1), face(4, 5, 7, 6), face(0, 1, 5, 4),
          face(2, 6, 7, 3), face(0, 4, 6, 2), face(1, 3, 7, 5)};
}

std::vector<Polygon> ring_of_bars(std::size_t n, const Point2& centre, double radius, double rise,
                                  double roll, double z, double turn) {
  std::vector<Polygon> bars;
  const auto corner = [&](std::size_t i) {
    return centre + radius * on_circle(turn + static_cast<double>(i) / static_cast<double>(n));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 from = corner(i), to = corner(i + 1), beyond = 0.25 * (to - from);
    bars.push_back(bar(Point3(from - beyond, z + rise), Point3(to + beyond, z - rise),
                       radius * 1.6 / static_cast<double>(n), roll));
  }
  return bars;
}

Polygon begun_at(const Polygon& polygon, std::size_t first) {
  Polygon turned = polygon;
  const auto offset = static_cast<std::ptrdiff_t>(first % turned.size());
  std::rotate(turned.begin(), turned.begin() + offset, turned.end());
  return turned;
}

Polygon backwards(const Polygon& polygon) { return {polygon.rbegin(), polygon.rend()}; }

std::size_t side_of_square(std::size_t n) {
  return static_cast<std::size_t>(std::sqrt(static_cast<double>(n)) + 0.5);
}

}  // namespace displayfile
