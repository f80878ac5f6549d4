
#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Which pixels a polygon covers: edges and vertices at pixel centres, thin and tiny polygons.

namespace displayfile {

namespace {

/// A coordinate of a random column, or row, of centres.
double any_centre(Random& random, double pixels) {
  return (static_cast<double>(random.below(static_cast<std::size_t>(pixels))) + 0.5) / pixels;
}

/// A pixel's centre, at a random depth.
Point3 any_pixel(Random& random, double pixels) {
  const double x = any_centre(random, pixels), y = any_centre(random, pixels);
  return {x, y, random.unit()};
}

Scene edges_through_centres(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // whole slopes from centre to centre, drawn farther
    const Point3 middle = any_pixel(random, pixels);
    Polygon triangle;
    for (int k = 0; k < 3; ++k) {
      const auto step = [&] { return static_cast<double>(random.below(33)) - 16.0; };
      const double dx = step() / pixels;
      triangle.push_back(middle + Point3(dx, step() / pixels, 0.0));
    }
    scene.add(triangle);
  }
  return scene;
}

Scene vertices_at_centres(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    scene.add({any_pixel(random, pixels), any_pixel(random, pixels), any_pixel(random, pixels)});
  }
  return scene;
}

Scene edges_on_rows(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const double low = any_centre(random, pixels), high = any_centre(random, pixels);
    const double left = any_centre(random, pixels), right = any_centre(random, pixels);
    const Sheet sheet{random.unit()};
    // A step in each side: horizontal edges in the middle of the polygon as well.
    const double middle = any_centre(random, pixels);
    scene.add({sheet.point(left, low), sheet.point(right, low), sheet.point(right, middle),
               sheet.point(right + 0.125, middle), sheet.point(right + 0.125, high),
               sheet.point(left, high)});
  }
  return scene;
}

Scene ulp_off_centres(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    Polygon polygon(3 + random.below(3));
    const auto off_centre = [&] {
      const double centre = any_centre(random, pixels);
      return nudged(centre, static_cast<int>(random.below(3)) - 1);
    };
    for (Point3& p : polygon) p = {off_centre(), off_centre(), 0.5};
    scene.add(polygon);
  }
  return scene;
}

Scene edges_past_centres(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // long edges that pass a centre by their rounding
    const Point3 centre = any_pixel(random, pixels);
    const double length = random.between(0.1, 0.7);
    const Point2 along = length * on_circle(random.unit());
    const double beyond = random.between(0.1, 2.0);
    const Point3 from(centre.x - along.x, centre.y - along.y, centre.z);
    const Point3 to(centre.x + beyond * along.x, centre.y + beyond * along.y, centre.z);
    scene.add({from, to, Point3(random_place(random), centre.z)});
  }
  return scene;
}

Scene pixel_sized(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 place = random_place(random);
    const double z = random.unit();
    Polygon triangle;
    for (int k = 0; k < 3; ++k) {
      const Point2 off = random_place(random, {-1.0, 1.0});
      triangle.push_back({place.x + off.x / pixels, place.y + off.y / pixels, z});
    }
    scene.add(triangle);
  }
  return scene;
}

Scene subpixel(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // around centres: each covers one or none
    const Point3 centre = any_pixel(random, 32.0);
    Polygon triangle;
    for (int k = 0; k < 3; ++k) {
      const Point2 off = random_place(random, {-1.0, 1.0});
      triangle.push_back(
          {centre.x + off.x * gap(severity), centre.y + off.y * gap(severity), centre.z});
    }
    scene.add(triangle);
  }
  return scene;
}

Scene slivers(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // long, thin, and along centres
    const Point3 from = any_pixel(random, 32.0), to = any_pixel(random, 32.0);
    const Point2 off = random_place(random, {-1.0, 1.0});
    scene.add({from, to, to + Point3(off * gap(severity), 0.0)});
  }
  return scene;
}

Scene crossing_needles(std::size_t n, double width, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 along = on_circle(random.unit()), through = random_place(random);
    const double rise = random.between(-0.4, 0.4);
    scene.add(bar(Point3(through - along, 0.5 - rise), Point3(through + along, 0.5 + rise), width));
  }
  return scene;
}

Scene edge_on(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.add(rectangle(0.0, 0.0, 1.0, 1.0, {0.25, 0.125, 0.25}));
  for (std::size_t i = 0; i < n; ++i) {  // walls exactly along the projectors
    const double a = random.dyadic(5), b = random.dyadic(5);
    const Point2 from(a, 0.0), to(slope == 0.0 ? a : b, 1.0);
    scene.add({Point3(from, 0.0), Point3(to, 0.0), Point3(to, 1.0), Point3(from, 1.0)});
    scene.add({Point3(from, 0.9), Point3(to, 0.8), Point3(0.5 * (from + to), 1.0)});
  }
  return scene;
}

Scene nearly_edge_on(std::size_t n, double ulps, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.add(rectangle(0.0, 0.0, 1.0, 1.0, {0.5}));
  const auto lean = [&] {
    return 1 + static_cast<int>(random.below(static_cast<std::size_t>(ulps)));
  };
  for (std::size_t i = 0; i < n; ++i) {  // walls that lean by some ulps, through centres
    const double middle = (static_cast<double>(random.below(8)) + 16.5) / 32.0;
    const double low = nudged(middle, -lean()), high = nudged(middle, lean());
    scene.add({{low, 0.0, 0.0}, {low, 1.0, 0.0}, {high, 1.0, 1.0}, {high, 0.0, 1.0}});
    scene.add({{0.0, low, 1.0}, {1.0, low, 1.0}, {1.0, high, 0.0}, {0.0, high, 0.0}});
  }
  return scene;
}

Scene ill_conditioned_planes(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    // Three vertices nearly in line in the projection, at unlike depths.
    const Point3 centre = any_pixel(random, 32.0);
    const Point2 along = 0.4 * on_circle(random.unit());
    const Point2 off = random_place(random, {-1.0, 1.0});
    const Point2 middle = Point2(centre) + off * gap(severity);
    scene.add({Point3(Point2(centre) - along, random.unit()), Point3(Point2(centre) + along, 0.5),
               Point3(middle, centre.z)});
  }
  return scene;
}

Scene steep_planes(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const double slope = 1.0 / gap(severity);
    const Point2 along = on_circle(random.unit()), through = random_place(random);
    const Sheet sheet{0.5 - slope * (along.x * through.x + along.y * through.y), slope * along.x,
                      slope * along.y};
    scene.add(random_regular(random, 3, {0.2, 0.8}, {0.3, 0.6}, sheet));
  }
  return scene;
}

}  // namespace

std::vector<HardCase> coverage_families() {
  return {
      {"edges_through_centres",
       "edges of whole slopes, through pixel centres",
       "picture size meant",
       16,
       {32, 64},
       edges_through_centres,
       "A centre on a left or top edge belongs to the polygon, one on a right or bottom edge does "
       "not; stepping by a rounded slope leaves the centre to one side or the other."},
      {"vertices_at_centres",
       "triangles with all vertices at pixel centres",
       "picture size meant",
       16,
       {32, 64},
       vertices_at_centres,
       "A vertex on a row of centres must be counted once, by one of its two edges."},
      {"edges_on_rows",
       "level and upright edges on rows and columns of centres",
       "picture size meant",
       10,
       {32, 64},
       edges_on_rows,
       "Level edges on a row of centres count for nothing; upright ones are inclusive on the left "
       "and exclusive on the right."},
      {"ulp_off_centres",
       "vertices at centres, or off by the last place",
       "picture size meant",
       24,
       {32, 64},
       ulp_off_centres,
       "In pixel units a coordinate's last place can be lost, and with it the side of the centre."},
      {"edges_past_centres",
       "long edges that pass a centre by their rounding",
       "picture size meant",
       40,
       {32, 64},
       edges_past_centres,
       "Each edge would pass through a centre, but its ends are rounded: the side is decided far "
       "below the last place of the crossing."},
      {"pixel_sized",
       "triangles as large as a pixel",
       "picture size meant",
       1500,
       {32, 64},
       pixel_sized,
       "Most cover one centre or none; snapping vertices, as graphics hardware does, moves them by "
       "a large part of their size."},
      {"subpixel",
       "triangles around a centre, far smaller than a pixel",
       "size 10^-s",
       600,
       {3, 9, 15},
       subpixel,
       "Whether the one centre is inside is decided by coordinates that differ in their last "
       "digits; snapping makes such a triangle vanish."},
      {"slivers",
       "from centre to centre, as wide as the gap",
       "width 10^-s",
       60,
       {2, 8, 15},
       slivers,
       "Thin triangles along lines of centres: the cover is decided by the last places, and the "
       "plane is badly determined."},
      {"crossing_needles",
       "needles across the picture, at all depths",
       "width",
       60,
       {0.03, 0.001},
       crossing_needles,
       "Thin bars, many of them steep in depth, which cross and pierce each other within a pixel."},
      {"edge_on",
       "walls exactly along the projectors",
       "0: upright, 1: slanting",
       16,
       {0, 1},
       edge_on,
       "They cover nothing, though they have area in space and no finite depth slope: a control "
       "for divisions by zero and for cracks."},
      {"nearly_edge_on",
       "walls that lean by the last place, through centres",
       "ulps",
       8,
       {1, 3},
       nearly_edge_on,
       "A wall as wide as the last place covers a whole column of centres, and its depth goes from "
       "one end of the range to the other within that width."},
      {"ill_conditioned_planes",
       "three vertices nearly in line in the projection",
       "offset 10^-s",
       100,
       {1, 3, 8, 15},
       ill_conditioned_planes,
       "Cancellation leaves few digits of the plane's coefficients, while the centres inside must "
       "still be ordered."},
      {"steep_planes",
       "planes that rise far more than the picture is wide",
       "slope 10^s",
       12,
       {3, 9, 15},
       steep_planes,
       "Depths run out of [0,1]: integer formats clamp, and a step of one pixel is larger than the "
       "range."},
  };
}

}  // namespace displayfile
