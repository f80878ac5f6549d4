
#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Nearly coplanar polygons: their separation shrinks with the severity.

namespace displayfile {

namespace {

Scene parallel_sheets(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> sheets;
  for (std::size_t i = 0; i < n; ++i) {
    const Sheet sheet{0.1 + static_cast<double>(i) * gap(severity), 0.125, 0.0625};
    sheets.push_back(random_regular(random, 3 + random.below(4), {}, {0.7, 0.7}, sheet));
  }
  random.shuffle(sheets);
  scene.add(sheets);
  return scene;
}

Scene ulp_stack(std::size_t n, double ulps, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> sheets;
  double z = 0.5;
  for (std::size_t i = 0; i < n; ++i, z = nudged(z, static_cast<int>(ulps))) {
    sheets.push_back(random_regular(random, 3 + random.below(4), {}, {0.6, 0.6}, {z}));
  }
  random.shuffle(sheets);
  scene.add(sheets);
  return scene;
}

Scene ulp_stack_tilted(std::size_t n, double ulps, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> sheets;
  const Polygon lowest{{-0.1, -0.1, 0.3}, {1.2, 0.1, 0.45}, {0.3, 1.3, 0.7}};
  for (std::size_t i = 0; i < n; ++i) {
    Polygon sheet = lowest;
    for (Point3& p : sheet) p.z = nudged(p.z, static_cast<int>(i) * static_cast<int>(ulps));
    sheets.push_back(begun_at(sheet, random.below(3)));
  }
  random.shuffle(sheets);
  scene.add(sheets);
  return scene;
}

Scene ulp_interleaved(std::size_t n, double ulps, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Polygon base{{-0.1, -0.1, 0.3}, {1.2, 0.1, 0.45}, {0.3, 1.3, 0.7}};
  const auto range = static_cast<int>(ulps);
  for (std::size_t i = 0; i < n; ++i) {
    Polygon sheet = base;
    for (Point3& p : sheet) {
      p.z = nudged(p.z,
                   static_cast<int>(random.below(2 * static_cast<std::size_t>(ulps) + 1)) - range);
    }
    scene.add(begun_at(sheet, random.below(3)));
  }
  return scene;
}

Scene nearly_coplanar(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet{0.3, 0.25, 0.125};
  for (std::size_t i = 0; i < n; ++i) {
    Polygon triangle = random_triangle(random, sheet);
    for (Point3& p : triangle) p.z += gap(severity) * (random.unit() - 0.5);
    scene.add(triangle);
  }
  return scene;
}

Scene shallow_crossing(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet base{0.4, 0.25, -0.125};
  scene.add(rectangle(0.0, 0.0, 1.0, 1.0, base));
  for (std::size_t i = 1; i < n; ++i) {
    const Point2 across = on_circle(random.unit()), through = random_place(random);
    Polygon crossing = rectangle(0.0, 0.0, 1.0, 1.0, base);
    for (Point3& p : crossing) {
      p.z += gap(severity) * ((p.x - through.x) * across.x + (p.y - through.y) * across.y);
    }
    scene.add(crossing);
  }
  return scene;
}

Scene saw(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet base{0.4, 0.125, 0.25};
  const double width = 1.0 / static_cast<double>(n);
  std::vector<Polygon> teeth{rectangle(0.0, 0.0, 1.0, 1.0, base)};
  for (std::size_t i = 0; i < n; ++i) {
    const double left = static_cast<double>(i) * width;
    Polygon tooth{base.point(left, 0.0), base.point(left + width, 0.0),
                  base.point(left + width / 2.0, 1.0)};
    for (Point3& p : tooth) p.z += (i % 2 == 0 ? 1.0 : -1.0) * gap(severity);
    teeth.push_back(tooth);
  }
  random.shuffle(teeth);
  scene.add(teeth);
  return scene;
}

Scene thin_plates(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  for (std::size_t i = 0; i < n; ++i) {
    const Sheet back{random.between(0.2, 0.6), random.between(-0.2, 0.2), 0.0};
    Sheet front = back;
    front.z0 += gap(severity);
    const Polygon face = random_regular(random, 4, {}, {0.2, 0.5}, back);
    Polygon other = face;
    for (Point3& p : other) p.z = front.at(p.x, p.y);
    scene.add(other);  // the front first: the back must not show through
    scene.add(backwards(face));
  }
  return scene;
}

Scene poking_corners(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const Sheet sheet{0.5, 0.0625, 0.125};
  std::vector<Polygon> all{rectangle(0.0, 0.0, 1.0, 1.0, sheet)};
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 tip = random_place(random, {0.1, 0.9});
    const Polygon foot = regular(3, tip, 0.15, random.unit(), {sheet.at(tip.x, tip.y) - 0.1});
    Point3 apex = sheet.point(tip);
    apex.z += gap(severity);
    for (std::size_t k = 0; k < 3; ++k) all.push_back({foot[k], foot[(k + 1) % 3], apex});
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

Scene hinged_pages(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> pages;
  const Point3 top(0.1, 0.95, 0.3), bottom(0.2, 0.05, 0.5);  // the spine
  for (std::size_t i = 0; i < n; ++i) {
    const double lift = static_cast<double>(i) * gap(severity);
    pages.push_back({bottom, {0.9, 0.1, 0.2 + lift}, top});
  }
  random.shuffle(pages);
  scene.add(pages);
  return scene;
}

Scene shingles(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  std::vector<Polygon> all;
  const double step = 1.0 / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {  // each lies on the next one's lower edge
    const double y = static_cast<double>(i) * step;
    all.push_back({{0.0, y, 0.4},
                   {1.0, y, 0.4},
                   {1.0, y + 1.5 * step, 0.4 - gap(severity)},
                   {0.0, y + 1.5 * step, 0.4 - gap(severity)}});
  }
  random.shuffle(all);
  scene.add(all);
  return scene;
}

}  // namespace

std::vector<HardCase> gap_families() {
  return {
      {"parallel_sheets", "tilted sheets, each nearer by the gap, entered in random order",
       "gap 10^-s", 8, kGaps, parallel_sheets,
       "The plainest case of z-fighting: as soon as the gap falls below the resolution of a format "
       "or a tolerance, the later sheet is visible instead of the nearer one, over the whole "
       "overlap."},
      {"nearly_coplanar", "random triangles within the gap of one plane", "gap 10^-s", 20, kGaps,
       nearly_coplanar,
       "The triangles also cross each other, at angles of the size of the gap, so there is no gap "
       "that would be safe."},
      {"shallow_crossing", "sheets that cross a base along a line, at an angle of the gap",
       "gap 10^-s", 6, kGaps, shallow_crossing,
       "The depths agree along a line and part by the gap over the whole picture: a band around "
       "the line is undecided, and it widens to the whole picture."},
      {"saw", "a sheet with teeth in turn before and behind it by the gap", "gap 10^-s", 16, kGaps,
       saw,
       "Half of the teeth must show and half must not: ties are wrong whichever way they are "
       "broken."},
      {"thin_plates", "plates as thick as the gap, the front entered before the back", "gap 10^-s",
       6, kGaps, thin_plates,
       "Without back-face removal the back of each plate shows through where the thickness is "
       "lost; thin walls in building models are an example."},
      {"poking_corners",
       "pyramids whose tips poke through a sheet by the gap",
       "gap 10^-s",
       12,
       {2, 4, 9},
       poking_corners,
       "The visible part of each pyramid is a tip of the size of the gap: few pixels, but each is "
       "decided by a depth close to the sheet's."},
      {"hinged_pages", "pages with a common spine, their outer corners a gap apart", "gap 10^-s", 8,
       kGaps, hinged_pages,
       "The gap closes toward the spine, so every format fails near the spine first."},
      {"shingles", "rows that lie on each other's edges, a gap deep", "gap 10^-s", 10, kGaps,
       shingles, "Each row passes from behind one neighbour to before the other within the gap."},
      {"ulp_stack",
       "level sheets, each nearer by the last place",
       "ulps apart",
       16,
       {1, 4},
       ulp_stack,
       "The depths are stored numbers, no two alike, so a comparison of doubles is right; any "
       "tolerance, and any narrower format, sees one plane."},
      {"ulp_stack_tilted",
       "tilted triangles, each nearer by the last place",
       "ulps apart",
       16,
       {1, 4},
       ulp_stack_tilted,
       "As the level stack, but every depth is computed, and its rounding is as large as the "
       "distance of the sheets."},
      {"ulp_interleaved",
       "tilted triangles, each vertex off by some of the last place",
       "largest number of ulps",
       16,
       {1, 3, 100},
       ulp_interleaved,
       "The sheets cross each other everywhere within a few of the last place: only exact "
       "comparisons are right."},
  };
}

}  // namespace displayfile
