#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Polygons that touch: shared vertices and edges, a vertex on another's plane.

namespace displayfile {

namespace {

Scene t_junctions(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  // A wall of bricks of unlike lengths, turned so that corners lie on pixel centres and edges run
  // through others; where bricks meet, a corner of one lies exactly on an edge of another.
  const auto corner = [&](std::size_t along, std::size_t up, double z) {
    const auto u = static_cast<double>(along), v = static_cast<double>(up);
    return Point3((3.0 * u - v + 4.5) / pixels, (u + 3.0 * v - 3.5) / pixels, z);
  };
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t left = 0; left < n;) {
      const std::size_t right = left + 1 + random.below(4);
      const double z = random.unit();
      scene.add({corner(left, row, z), corner(right, row, z), corner(right, row + 1, z),
                 corner(left, row + 1, z)});
      left = right;
    }
  }
  return scene;
}

Scene shared_edges(std::size_t n, double roughness, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const std::size_t m = side_of_square(n);
  std::vector<Point3> grid;
  for (std::size_t k = 0; k < (m + 1) * (m + 1); ++k) {
    const double x = static_cast<double>(k % (m + 1)) + 0.8 * (random.unit() - 0.5);
    const double y = static_cast<double>(k / (m + 1)) + 0.8 * (random.unit() - 0.5);
    const auto side = static_cast<double>(m);
    const auto snapped = [&](double t) {  // to centres, borders and quarters of pixels
      return static_cast<double>(static_cast<int>((t / side + 1.0) * 128.0 + 0.5)) / 128.0 - 1.0;
    };
    grid.emplace_back(snapped(x), snapped(y), 0.5 + roughness * (random.unit() - 0.5));
  }
  for (std::size_t row = 0; row < m; ++row) {
    for (std::size_t column = 0; column < m; ++column) {
      const std::size_t k = row * (m + 1) + column;
      const Point3 &a = grid[k], &b = grid[k + 1], &c = grid[k + m + 2], &d = grid[k + m + 1];
      scene.add({a, b, c});
      scene.add({a, c, d});
    }
  }
  return scene;
}

Scene tiles_on_centres(std::size_t n, double pixels, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const auto centre = [&] {
    return (static_cast<double>(random.below(static_cast<std::size_t>(pixels))) + 0.5) / pixels;
  };
  for (std::size_t i = 0; i < n; ++i) {  // four triangles around a centre, edges through others
    const double x = centre(), y = centre(), r = 8.0 / pixels;
    const Sheet sheet{random.dyadic(4) / 2.0, 0.125, 0.25};
    const Polygon corners = rectangle(x - r, y - r, x + r, y + r, sheet);
    for (std::size_t k = 0; k < 4; ++k) {
      scene.add({sheet.point(x, y), corners[k], corners[(k + 1) % 4]});
    }
  }
  return scene;
}

Scene fan_of_needles(std::size_t n, double spread, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Point3 hub(0.515625, 0.484375, 0.5);  // a pixel centre at 32 x 32
  std::vector<Polygon> needles;
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = static_cast<double>(i) / static_cast<double>(n);
    const double width = 1.5 / static_cast<double>(n), z = 0.5 + spread * (random.unit() - 0.5);
    const Point2 middle(0.515625, 0.484375);
    needles.push_back({hub, Point3(middle + 0.7 * on_circle(turn), z),
                       Point3(middle + 0.7 * on_circle(turn + width), z)});
  }
  random.shuffle(needles);
  scene.add(needles);
  return scene;
}

Scene vertex_on_plane(std::size_t n, double reach, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet{0.25, 0.25, 0.125};  // exact for coordinates of few bits
  std::vector<Polygon> all{rectangle(0.0, 0.0, 1.0, 1.0, sheet)};
  for (std::size_t i = 0; i < n; ++i) {
    const auto on_plane = [&] {
      const double x = random.dyadic(6);
      return sheet.point(x, random.dyadic(6));
    };
    Polygon triangle{on_plane(), on_plane(), on_plane()};
    // One or two of the vertices stay on the plane.
    const std::size_t moved = 1 + random.below(2);
    for (std::size_t k = 0; k < moved; ++k) triangle[k].z += reach * (random.dyadic(3) - 0.5);
    all.push_back(triangle);
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene touching_points(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  for (std::size_t i = 0; i < n; ++i) {  // from both sides, tip to tip
    const Point3 tip{random.dyadic(5), random.dyadic(5), 0.5};
    for (double side : {-1.0, 1.0}) {
      const double z = 0.5 + side * slope * random.dyadic(4);
      all.push_back({tip, tip + Point3(side * 0.25, -0.125, z - 0.5),
                     tip + Point3(side * 0.125, 0.25, z - 0.5)});
      all.push_back({tip, tip + Point3(-side * 0.25, -0.125, z - 0.5),
                     tip + Point3(side * 0.25, -0.125, 0.5 - z)});
    }
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene touching_edges(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  for (std::size_t i = 0; i < n; ++i) {  // roofs and gutters over one ridge
    const double x = random.dyadic(5), rise = slope * (random.dyadic(4) - 0.5);
    const Point3 low(x, 0.0, 0.5), high(x, 1.0, 0.5);
    all.push_back({low, {x + 0.25, 0.0, 0.5 + rise}, {x + 0.25, 1.0, 0.5 + rise}, high});
    all.push_back({low, high, {x - 0.25, 1.0, 0.5 + rise}, {x - 0.25, 0.0, 0.5 + rise}});
    all.push_back({low, {x + 0.25, 0.0, 0.5 - rise}, {x + 0.25, 1.0, 0.5 - rise}, high});
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene nested_boxes(std::size_t n, double shear, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  double size = 0.75;
  for (std::size_t i = 0; i < n; ++i, size *= 0.75) {  // all share the corner nearest the viewer
    const Point3 corner(0.75, 0.75, 1.0);
    for (Polygon& face : box(corner - size, corner, {shear, shear})) all.push_back(face);
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene stacked_cubes(std::size_t n, double shear, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  for (std::size_t i = 0; i < n; ++i) {  // faces of neighbours coincide, back to back
    const Point3 low{0.25 * static_cast<double>(random.below(4)),
                     0.25 * static_cast<double>(random.below(4)),
                     0.25 * static_cast<double>(random.below(3))};
    for (Polygon& face : box(low, low + 0.25, {shear, shear})) all.push_back(face);
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene folded_paper(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet = random_sheet(random, 0.5, slope);
  for (std::size_t i = 0; i < n; ++i) {  // two faces of one sheet, on each other
    const Polygon face = random_triangle(random, sheet);
    scene.add(face);
    scene.add(begun_at(backwards(face), random.below(3)));
  }
  return scene;
}

Scene quads_rounded_off_plane(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet = random_sheet(random, 0.5, slope);
  const std::size_t m = side_of_square(n);
  const double turn = random.unit();
  const auto corner = [&](std::size_t i, std::size_t k) {  // a turned grid, rounded
    const Point2 axis = on_circle(turn);
    const double u = 1.5 * static_cast<double>(i) / static_cast<double>(m) - 0.75;
    const double v = 1.5 * static_cast<double>(k) / static_cast<double>(m) - 0.75;
    return sheet.point(0.5 + u * axis.x - v * axis.y, 0.5 + u * axis.y + v * axis.x);
  };
  std::vector<Polygon> all;
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t k = 0; k < m; ++k) {
      all.push_back({corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)});
      // And one of twice the size in the same plane, with another first vertex.
      all.push_back(
          begun_at({corner(i, k), corner(i + 2, k), corner(i + 2, k + 2), corner(i, k + 2)},
                   random.below(4)));
    }
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

}  // namespace

std::vector<HardCase> touching_families() {
  return {
      {"t_junctions",
       "turned rows of bricks of different lengths",
       "picture size meant",
       8,
       {32, 64},
       t_junctions,
       "A brick's corner lies exactly on the edges of the row beside, at a pixel's centre: the "
       "rule for edges must leave no crack and draw no pixel twice."},
      {"shared_edges",
       "a triangulated height field with vertices on a fine grid",
       "roughness",
       100,
       {0.0, 0.5},
       shared_edges,
       "Neighbours share edges and run along them in opposite directions; many vertices are pixel "
       "centres. An edge that both do not step alike cracks."},
      {"tiles_on_centres",
       "triangles that meet at a pixel's centre, edges through others",
       "picture size meant",
       10,
       {32, 64},
       tiles_on_centres,
       "Four triangles share a vertex on a centre and edges along diagonals of centres; each "
       "centre must belong to one."},
      {"fan_of_needles",
       "needles that share a vertex at a pixel's centre",
       "range of z",
       300,
       {0.0, 0.5},
       fan_of_needles,
       "Hundreds of edges run into one centre, where all depths tie; a needle is thinner than a "
       "pixel nearly everywhere."},
      {"vertex_on_plane",
       "triangles with a vertex or two exactly on a sheet",
       "reach off it",
       20,
       {1.0, 0x1p-30},
       vertex_on_plane,
       "A plane test of such a vertex must return 'on', or the splitter makes slivers; with a "
       "reach of 2^-30 the rest is nearly coplanar as well."},
      {"touching_points",
       "tip to tip, from both sides",
       "slope",
       12,
       {0.5},
       touching_points,
       "Nothing crosses: triangles touch in one point, where all depths tie, and coordinates on a "
       "coarse grid put edges through centres."},
      {"touching_edges",
       "roofs and gutters on one ridge",
       "slope",
       8,
       {0.5, 0x1p-40},
       touching_edges,
       "Planes touch along an edge without crossing, from both sides."},
      {"nested_boxes",
       "boxes that share a corner and parts of three faces",
       "shear",
       6,
       {0.0, 0.25},
       nested_boxes,
       "Three faces of every box are coplanar with the next one's: over a third of the picture, "
       "the order of entry decides."},
      {"stacked_cubes",
       "cubes whose faces coincide with their neighbours'",
       "shear",
       12,
       {0.0, 0.25},
       stacked_cubes,
       "Faces coincide back to back, and cubes may occur twice: exact ties between opposite "
       "orientations."},
      {"folded_paper",
       "two faces of a sheet on each other, in opposite directions",
       "slope",
       10,
       {0.7, 30.0},
       folded_paper,
       "The same three vertices in another order give the same plane; computed depths do not "
       "agree. The second face must win everywhere."},
      {"quads_rounded",
       "quadrilaterals on a turned grid, off their plane by rounding",
       "slope",
       36,
       {0.0, 0.7},
       quads_rounded_off_plane,
       "Each quadrilateral's fourth vertex is off the plane of three by rounding, and a second "
       "layer uses other vertices of nearly the same plane."},
  };
}

}  // namespace displayfile
