
#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Polygons that pass through each other.

namespace displayfile {

namespace {

double centre_of_pixel(std::size_t i, double pixels) {
  return (static_cast<double>(i) + 0.5) / pixels;
}

Scene interpenetrating(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    Polygon triangle = random_regular(random, 3, {}, {0.7, 0.7}, {0.0});
    for (Point3& p : triangle) p.z = 0.5 + slope * (random.unit() - 0.5);
    scene.add(triangle);
  }
  return scene;
}

Scene crossing_grid(std::size_t n, double /*severity*/, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  for (std::size_t i = 0; i < n; ++i) {
    const double offset = static_cast<double>(i) / static_cast<double>(n);
    all.push_back(rectangle(0.0, 0.0, 1.0, 1.0, {offset, 1.0 - 2.0 * offset, 0.0}));
    all.push_back(rectangle(0.0, 0.0, 1.0, 1.0, {offset, 0.0, 1.0 - 2.0 * offset}));
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene pencil_of_planes(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  const double axis = centre_of_pixel(static_cast<std::size_t>(pixels) / 2, pixels);
  for (std::size_t i = 0; i < n; ++i) {  // all contain the line x = axis, z = 1/2, exactly
    const double rise = random.dyadic(10) - 0.5;
    all.push_back({{axis - 0.5, 0.0, 0.5 - rise},
                   {axis + 0.5, 0.0, 0.5 + rise},
                   {axis + 0.5, 1.0, 0.5 + rise},
                   {axis - 0.5, 1.0, 0.5 - rise}});
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene oblique_pencil(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Point3 from(0.1, 0.0, 0.3), to(0.9, 1.0, 0.6);  // the line, stored in every triangle
  for (std::size_t i = 0; i < n; ++i) {
    const bool left = random.below(2) == 0;
    const Point3 third(left ? 0.0 : 1.0, left ? 1.0 : 0.0, 0.45 + slope * (random.unit() - 0.5));
    scene.add({from, to, third});
  }
  return scene;
}

Scene bundle_of_planes(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double centre = centre_of_pixel(static_cast<std::size_t>(pixels) / 2, pixels);
  for (std::size_t i = 0; i < n; ++i) {  // all contain the point (centre, centre, 1/2), exactly
    const double a = random.dyadic(10) - 0.5, b = random.dyadic(10) - 0.5;
    scene.add({{centre - 0.5, centre - 0.5, 0.5 - (a + b) / 2.0},
               {centre + 0.5, centre - 0.5, 0.5 + (a - b) / 2.0},
               {centre + 0.5, centre + 0.5, 0.5 + (a + b) / 2.0},
               {centre - 0.5, centre + 0.5, 0.5 - (a - b) / 2.0}});
  }
  return scene;
}

Scene crossing_at_centres(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  for (std::size_t i = 0; i < n; ++i) {  // z = 1/2 at a whole column, or row, of centres
    const double line = centre_of_pixel(random.below(static_cast<std::size_t>(pixels)), pixels);
    const double slope = random.dyadic(8) - 0.5;
    const Sheet along_x{0.5 - slope * line, slope, 0.0}, along_y{0.5 - slope * line, 0.0, slope};
    all.push_back(rectangle(0.0, 0.0, 1.0, 1.0, i % 2 == 0 ? along_x : along_y));
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene undecided_at_one_pixel(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const auto side = static_cast<std::size_t>(pixels);
    const Point2 centre{centre_of_pixel(random.below(side), pixels),
                        centre_of_pixel(random.below(side), pixels)};
    // Both triangles pass the centre at the same depth, up to the rounding of their vertices.
    for (int k = 0; k < 2; ++k) {
      const Sheet sheet{0.0, random.between(-9.0, 9.0), random.between(-9.0, 9.0)};
      const Sheet moved{0.5 - sheet.at(centre.x, centre.y), sheet.dx, sheet.dy};
      scene.add(regular(3, centre, 2.0 / pixels, random.unit(), moved));
    }
  }
  return scene;
}

Scene equal_depth_lines(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto side = static_cast<std::size_t>(pixels);
  for (std::size_t i = 0; i < n; ++i) {  // planes through many centres of a slanting line
    const double x = centre_of_pixel(random.below(side), pixels);
    const double y = centre_of_pixel(random.below(side), pixels);
    const double a = static_cast<double>(1 + random.below(3)) / 4.0;
    const double b = -static_cast<double>(1 + random.below(3)) / 4.0;
    scene.add(rectangle(0.0, 0.0, 1.0, 1.0, {0.5 - a * x - b * y, a, b}));
  }
  return scene;
}

Scene piercing_needles(std::size_t n, double width, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.add(rectangle(0.0, 0.0, 1.0, 1.0, {0.4, 0.125, 0.0625}));
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 from = random_point(random, {0.1, 0.1}), to = random_point(random, {0.9, 0.9});
    scene.add(bar(from, to, width));
  }
  return scene;
}

Scene crossing_boxes(std::size_t n, double shear, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 low{random.dyadic(4) * 0.5, random.dyadic(4) * 0.5, random.dyadic(3) * 0.5};
    const Point3 size{0.25 + random.dyadic(4) / 4.0, 0.25 + random.dyadic(4) / 4.0, 0.25};
    scene.add(box(low, low + size, {shear, shear / 2.0}));
  }
  return scene;
}

Scene interlocked_links(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {  // frames: a square with a hole, joined by a slit
    const Point2 c = random_place(random, {0.2, 0.8});
    const Sheet sheet = random_sheet(random, 0.5, gap(severity));
    Polygon frame = rectangle(c.x - 0.25, c.y - 0.25, c.x + 0.25, c.y + 0.25, sheet);
    frame.push_back(frame.front());
    const Polygon hole = rectangle(c.x - 0.15, c.y - 0.15, c.x + 0.15, c.y + 0.15, sheet);
    frame.insert(frame.end(), hole.begin(), hole.end());
    frame.push_back(hole.front());
    scene.add(frame);
  }
  return scene;
}

Scene moebius_strip(std::size_t n, double twist, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  const double turn = random.unit();
  const auto rim = [&](std::size_t i, double side) {
    const double turns = static_cast<double>(i) / static_cast<double>(n);
    const Point2 out = on_circle(turns), roll = on_circle(turn + turns * twist / 2.0);
    const double r = 0.35 + 0.12 * side * roll.x;
    return Point3(0.5 + r * out.x, 0.5 + r * out.y * 0.6, 0.5 + 0.12 * side * roll.y + 0.3 * out.y);
  };
  for (std::size_t i = 0; i < n; ++i) {
    all.push_back({rim(i, -1.0), rim(i + 1, -1.0), rim(i + 1, 1.0)});
    all.push_back({rim(i, -1.0), rim(i + 1, 1.0), rim(i, 1.0)});
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene self_crossing_surface(std::size_t n, double /*severity*/, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double shift = random.unit();
  std::vector<Polygon> all;
  const std::size_t m = side_of_square(n);
  const auto at = [&](std::size_t i, std::size_t k) {  // a figure-of-eight tube closed in a ring
    const double u = static_cast<double>(i) / static_cast<double>(m);
    const double v = static_cast<double>(k) / static_cast<double>(m);
    const Point2 ring = on_circle(u), once = on_circle(v), twice = on_circle(2.0 * v + shift);
    const double r = 0.3 + 0.15 * once.y;
    return Point3(0.5 + r * ring.x, 0.5 + r * ring.y, 0.5 + 0.2 * twice.y + 0.1 * ring.x);
  };
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = 0; k < m; ++k) {
      all.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      all.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

}  // namespace

std::vector<HardCase> crossing_families() {
  return {
      {"interpenetrating",
       "large triangles at random",
       "range of z",
       12,
       {1.0, 1e-6},
       interpenetrating,
       "No polygon is before another; the visible border runs along the lines where they cross."},
      {"crossing_grid",
       "planes of two families, all through each other",
       "none",
       6,
       {0},
       crossing_grid,
       "All planes cross on one pattern of lines, many of them at the same points."},
      {"pencil_of_planes",
       "planes through one line, which runs through a column of centres",
       "picture size meant",
       16,
       {32, 64},
       pencil_of_planes,
       "On the common line all depths tie exactly and the last plane must be visible; a column to "
       "the left and right the order is reversed."},
      {"oblique_pencil",
       "triangles that share an oblique edge",
       "range of z",
       16,
       {1.0, 1e-9},
       oblique_pencil,
       "Depths agree along an edge that no pixel grid contains, and the fan opens within 1e-9 of "
       "depth."},
      {"bundle_of_planes",
       "planes through one point, a pixel's centre",
       "picture size meant",
       16,
       {32, 64},
       bundle_of_planes,
       "At one pixel all depths tie exactly."},
      {"crossing_at_centres",
       "planes that cross along rows or columns of centres",
       "picture size meant",
       12,
       {32, 64},
       crossing_at_centres,
       "The crossing line runs through centres: each pixel on it is an exact tie."},
      {"undecided_at_one_pixel",
       "pairs that meet at a pixel's centre but for the rounding of their vertices",
       "picture size meant",
       60,
       {32, 64},
       undecided_at_one_pixel,
       "At one pixel of each pair the depths differ by less than a double can hold; neighbours are "
       "far apart, so only that pixel can be wrong."},
      {"equal_depth_lines",
       "planes with equal depths at many centres",
       "picture size meant",
       8,
       {32, 64},
       equal_depth_lines,
       "Slopes are quarters, so that planes tie exactly at centres all along slanting lines."},
      {"piercing_needles",
       "needles through a sheet",
       "width",
       40,
       {0.1, 0.03, 0.003},
       piercing_needles,
       "Each thin bar is cut by the sheet: half of it must show."},
      {"crossing_boxes",
       "boxes on a coarse grid, through each other",
       "shear",
       8,
       {0.0, 0.25},
       crossing_boxes,
       "Boxes with faces in common planes that also pass through each other, as careless modelling "
       "leaves them."},
      {"interlocked_links",
       "frames with holes, through each other",
       "gap 10^-s",
       10,
       {0, 6, 12},
       interlocked_links,
       "Concave frames, with a slit of no width, linked like a chain: seen through the holes is a "
       "link that is before the frame elsewhere."},
      {"moebius_strip",
       "one-sided strip, its halves seen from both sides",
       "half twists",
       40,
       {1, 5},
       moebius_strip,
       "There is no consistent front: back-face removal must be off, and with many twists the "
       "strip passes through itself."},
      {"self_crossing_surface",
       "a closed surface that passes through itself",
       "none",
       100,
       {0},
       self_crossing_surface,
       "A smooth surface with a curve of self-intersection, where triangles of unlike size cross."},
  };
}

}  // namespace displayfile
