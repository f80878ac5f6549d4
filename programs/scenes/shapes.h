#pragma once

#include "programs/scenes/random.h"
#include "programs/scenes/scene.h"

namespace displayfile {

// Pieces that the generators build scenes from. Only + - * / and square roots are used, so that
// a scene is the same, bit for bit, on every machine.

/// A plane over the projection: z = z0 + dx x + dy y, rounded.
struct Sheet {
  double z0, dx = 0.0, dy = 0.0;
  double at(double x, double y) const { return z0 + dx * x + dy * y; }
  Point3 point(double x, double y) const { return {x, y, at(x, y)}; }
  Point3 point(const Point2& p) const { return point(p.x, p.y); }
};

/// 10^exponent, correctly rounded for exponents of magnitude up to 22.
double power_of_ten(int exponent);

/// A gap of 10^-severity.
double gap(double severity);

/// x moved by that many units in the last place.
double nudged(double x, int ulps);

/// The point of the unit circle at this many turns, counterclockwise from (1, 0).
Point2 on_circle(double turns);

Polygon rectangle(double x_min, double y_min, double x_max, double y_max, const Sheet& sheet);
/// The corners of a regular polygon on a circle, moved in z on to the sheet.
Polygon regular(std::size_t sides, const Point2& centre, double radius, double turn,
                const Sheet& sheet);
/// A bar from a to b of the given width, its z running from a's to b's; `roll` is the change of
/// z from its right side to its left.
Polygon bar(const Point3& a, const Point3& b, double width, double roll = 0.0);

// The order of several random numbers in the arguments of one call would be the compiler's choice:
// these functions draw them in the order of their own arguments.

struct Range {
  double low = 0.0, high = 1.0;
};
Point2 random_place(Random& random, const Range& range = {});
Point3 random_point(Random& random, const Range& z = {});
/// A triangle with random corners in the unit square, on the sheet.
Polygon random_triangle(Random& random, const Sheet& sheet);
/// With random z too.
Polygon random_triangle(Random& random);
/// A regular polygon on the sheet, with its centre in a random place, of random radius, turned.
Polygon random_regular(Random& random, std::size_t sides, const Range& place, const Range& radius,
                       const Sheet& sheet);
/// A sheet through z0 in the picture's middle, with slopes between -slope/2 and slope/2.
Sheet random_sheet(Random& random, double z0, double slope);
/// A sheet in the middle of the depths, 0.3 to 0.7, with slopes of up to a quarter.
Sheet any_sheet(Random& random);

/// The six faces of a box, its light faces out; points are sheared by (dx, dy) for each unit
/// of z, so that the sides show.
std::vector<Polygon> box(const Point3& low, const Point3& high, const Point2& shear = {0.0, 0.0});

/// Bars around a circle, each above the next one's start and below the end of the one before.
/// `rise` is half of the change of z along a bar, `roll` the change across it.
std::vector<Polygon> ring_of_bars(std::size_t n, const Point2& centre, double radius, double rise,
                                  double roll, double z, double turn);

/// The polygon begun at another vertex, or run through backwards.
Polygon begun_at(const Polygon& polygon, std::size_t first);
Polygon backwards(const Polygon& polygon);

/// A rounded square root.
std::size_t side_of_square(std::size_t n);

}  // namespace displayfile
