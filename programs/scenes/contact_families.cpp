#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "clip/view/transformation.h"
#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Objects in contact as people draw them: rugs on floors, windows in walls, assembled parts, in
// whole numbers and decimals. Views are from anywhere, so that viewing rounds every plane. Truth is
// decided from the coordinates as entered: polygons coplanar there are coplanar, and the one
// entered later is visible. All is drawn about the origin.

namespace displayfile {

namespace {

/// A multiple of a hundredth, as it is written with two decimals.
double decimal(Random& random, double low, double high) {
  return std::round(random.between(low, high) * 100.0) / 100.0;
}

Point3 decimals(Random& random, double low, double high) {
  return Point3{decimal(random, low, high), decimal(random, low, high), decimal(random, low, high)};
}

// ---- Views ------------------------------------------------------------------------------

/// Severities: 0 parallel, 1 perspective, 2 and 3 the same with all turned and moved.
bool is_perspective(double severity) { return static_cast<int>(severity) % 2 == 1; }
bool is_placed(double severity) { return severity >= 2.0; }

Point3 random_direction(Random& random) {
  const double z = random.between(-1.0, 1.0);
  return {std::sqrt(1.0 - z * z) * on_circle(random.unit()), z};
}

View looking(const Point3& into) {
  View view;
  view.set_plane_normal(into);
  view.set_up(std::abs(into.y) > 0.9 ? Point3(1.0, 0.0, 0.0) : Point3(0.0, 1.0, 0.0));
  return view;
}

/// A view of a ball, from anywhere outside of it. Every other parallel view is oblique.
View view_from_outside(Random& random, bool perspective, const Point3& middle, double radius) {
  const Point3 into = random_direction(random);
  View view = looking(into);
  view.set_reference_point(middle);
  view.set_depth(-radius, radius);
  view.set_window({-radius, radius, -radius, radius});
  const double away = random.between(1.5, 4.0) * radius;
  const Point3 aside = 0.3 * random_direction(random);
  const bool oblique = random.below(2) == 0;
  if (perspective) {
    view.set_perspective(middle - away * into);
  } else {
    view.set_parallel(oblique ? into + aside : into);
  }
  return view;
}

/// A scene without polygons, turned and moved if its severity requires it.
Scene touching_scene(Random& random, double severity) {
  Scene scene;
  scene.touching = kUnlessSet;
  if (!is_placed(severity)) return scene;
  const Point3 degrees = decimals(random, -180.0, 180.0);
  scene.place(Point3(0.0), degrees, decimals(random, -1.0, 1.0));
  return scene;
}

/// The transformation of the scene's placement, if it has one.
ModellingTransformation transformation_of(const Scene& scene) {
  ModellingTransformation made;
  if (scene.placements.empty()) return made;
  const Scene::Placement& placement = scene.placements.front();
  made.rotate_x(placement.degrees.x);
  made.rotate_y(placement.degrees.y);
  made.rotate_z(placement.degrees.z);
  made.translate(placement.then_move);
  return made;
}

/// The same with a view of a ball about the drawing's origin.
Scene seen_from_outside(Random& random, double severity, double radius) {
  Scene scene = touching_scene(random, severity);
  scene.view = view_from_outside(random, is_perspective(severity),
                                 transformation_of(scene).apply(Point3(0.0)), radius);
  return scene;
}

// ---- Things -----------------------------------------------------------------------------

/// A square in a level plane, in whole numbers or in decimals.
Polygon random_floor(Random& random, double height) {
  const double half = random.below(2) == 0 ? 2.0 : decimal(random, 1.8, 2.2);
  return {
      {-half, height, -half}, {-half, height, half}, {half, height, half}, {half, height, -half}};
}

double random_height(Random& random) {
  return random.below(3) == 0 ? -1.0 : decimal(random, -1.0, 0.0);
}

/// A polygon of three to six corners in decimals, in a level plane.
Polygon random_rug(Random& random, const Point2& centre, double radius, double height) {
  Polygon rug;
  const std::size_t corners = 3 + random.below(4);
  const double turn = random.unit();
  for (std::size_t k = 0; k < corners; ++k) {
    const double turns = turn + static_cast<double>(k) / static_cast<double>(corners);
    const Point2 corner = centre + radius * on_circle(turns);
    rug.push_back(
        {std::round(corner.x * 100.0) / 100.0, height, std::round(corner.y * 100.0) / 100.0});
  }
  return rug;
}

void add_rugs(Random& random, std::size_t n, double height, Scene& scene) {
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 centre = random_place(random, {-1.2, 1.2});
    scene.add(random_rug(random, centre, random.between(0.3, 0.9), height));
  }
}

/// Each stands on the floor, or on another box, or beside it and against it.
void add_boxes(Random& random, std::size_t n, double height, Scene& scene) {
  Point3 low{0.0}, high{0.0};
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 size = decimals(random, 0.2, 0.7);
    if (i % 3 == 0) {
      low = {decimal(random, -1.5, 0.8), height, decimal(random, -1.5, 0.8)};
    } else if (i % 3 == 1) {
      low = {decimal(random, low.x, high.x), high.y, decimal(random, low.z, high.z)};
    } else {
      low = {high.x, height, low.z};
    }
    high = i % 3 == 2 ? Point3(low.x + size.x, height + size.y, low.z + size.z) : low + size;
    scene.add(box(low, high));
  }
}

/// A prism of six sides that stands on a level plane.
std::vector<Polygon> stud(const Point3& foot, double radius, double height) {
  const auto round_at = [&](double y) {
    Polygon round;
    for (std::size_t k = 0; k < 6; ++k) {
      const Point2 corner = radius * on_circle(static_cast<double>(k) / 6.0);
      round.push_back({foot.x + corner.x, y, foot.z + corner.y});
    }
    return round;
  };
  const Polygon bottom = round_at(foot.y), top = round_at(foot.y + height);
  std::vector<Polygon> all{bottom, top};
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t next = (k + 1) % 6;
    all.push_back({bottom[k], bottom[next], top[next], top[k]});
  }
  return all;
}

/// A polygon in the plane z = 0, moved to the coordinate plane of another axis.
Polygon turned_to(int axis, const Polygon& flat) {
  Polygon turned;
  for (const Point3& p : flat) {
    Point3& corner = turned.emplace_back();
    for (int k = 0; k < 3; ++k) corner[(axis + 1 + k) % 3] = p[k];
  }
  return turned;
}

// ---- Families ---------------------------------------------------------------------------

Scene rug_on_floor(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 2.5);
  const double height = random_height(random);
  scene.add(random_floor(random, height));
  add_rugs(random, n, height, scene);
  return scene;
}

Scene flush_windows(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 2.0);
  const Point3 size = decimals(random, 1.0, 1.3);
  scene.add(box(-size, size));
  for (std::size_t i = 0; i < n; ++i) {  // a frame in each wall in turn, and a pane in the frame
    const bool along_x = i % 2 == 0;
    const double wall = (i % 4 < 2 ? 1.0 : -1.0) * (along_x ? size.z : size.x);
    const double left = decimal(random, -0.9, 0.3), foot = decimal(random, -0.9, 0.3);
    const double wide = decimal(random, 0.3, 0.6), high = decimal(random, 0.3, 0.6);
    const auto in_wall = [&](double inset) {
      const auto at = [&](double u, double v) {
        return along_x ? Point3(u, v, wall) : Point3(wall, v, u);
      };
      const double right = left + wide - inset, top = foot + high - inset;
      return Polygon{at(left + inset, foot + inset), at(right, foot + inset), at(right, top),
                     at(left + inset, top)};
    };
    scene.add(in_wall(0.0));
    scene.add(in_wall(0.05));
  }
  return scene;
}

Scene boxes_on_floor(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 2.5);
  const double height = random_height(random);
  scene.add(random_floor(random, height));
  add_boxes(random, n, height, scene);
  return scene;
}

Scene flush_boxes(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 1.8);
  // Four planes along each axis: faces lie in each other's, inside and outside.
  std::array<Point3, 4> planes;
  for (int k = 0; k < 4; ++k) {
    planes[static_cast<std::size_t>(k)] = decimals(random, -1.0 + 0.5 * k, -0.6 + 0.5 * k);
  }
  for (std::size_t i = 0; i < n; ++i) {
    Point3 low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t first = random.below(3);
      low[axis] = planes[first][axis];
      high[axis] = planes[first + 1 + random.below(3 - first)][axis];
    }
    scene.add(box(low, high));
  }
  return scene;
}

/// A brick with two studs on it. Every other wall runs along z.
void add_brick(const Point3& low, const Point3& size, bool along_z, Scene& scene) {
  const Point3 turned = along_z ? Point3(size.z, size.y, size.x) : size;
  scene.add(box(low, low + turned));
  for (const double along : {0.25, 0.75}) {
    const Point3 foot = along_z ? Point3(0.5 * size.z, size.y, along * size.x)
                                : Point3(along * size.x, size.y, 0.5 * size.z);
    scene.add(stud(low + foot, 0.08, 0.06));
  }
}

Scene bricks(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 1.5);
  constexpr std::size_t kRow = 2;  // of each of two walls, which share their corner
  const Point3 size = Point3(0.6, 0.3, 0.3) + decimals(random, -0.05, 0.05);
  const Point3 corner{-0.9, -0.7, -0.9};
  for (std::size_t i = 0; i < n; ++i) {  // whose coordinates are computed, as a loop draws walls
    const bool along_z = i % 2 == 1;
    const std::size_t row = i / (2 * kRow);
    const double place = static_cast<double>(i / 2 % kRow), half = row % 2 == 0 ? 0.0 : 0.5;
    const double along = (place + half) * size.x, up = static_cast<double>(row) * size.y;
    add_brick(corner + (along_z ? Point3(0.0, up, along) : Point3(along, up, 0.0)), size, along_z,
              scene);
  }
  return scene;
}

Scene decals_on_slopes(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 2.5);
  const double rise = decimal(random, 0.3, 1.2), ridge = decimal(random, 0.2, 0.8);
  const auto on_roof = [&](double x, double z) { return Point3(x, ridge - rise * std::abs(z), z); };
  for (const double side : {1.7, -1.7}) {
    scene.add({on_roof(-2.0, 0.0), on_roof(2.0, 0.0), on_roof(2.0, side), on_roof(-2.0, side)});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const double x = decimal(random, -1.8, 0.8), z = side * decimal(random, 0.1, 0.8);
    const double right = x + decimal(random, 0.3, 1.0), foot = z + side * decimal(random, 0.3, 0.8);
    if (random.below(2) == 0) {
      scene.add({on_roof(x, z), on_roof(right, z), on_roof(right, foot), on_roof(x, foot)});
    } else {
      scene.add({on_roof(x, z), on_roof(right, foot), on_roof(x, foot)});
    }
  }
  return scene;
}

Scene parts_in_decimals(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 2.2);
  const Scene::Placement whole =
      scene.placements.empty() ? Scene::Placement{} : scene.placements.front();
  scene.placements.clear();
  const auto rounded = [](double x) { return std::round(x * 100.0) / 100.0; };
  // Each part is drawn about its own corner and moved to touch the one before: beside it, on it or
  // behind it. A plate on its face is a part too.
  Point3 place = decimals(random, -1.5, -1.3);
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 size = decimals(random, 0.5, 0.9);
    scene.place(place, whole.degrees, whole.then_move);
    scene.add(box(Point3(0.0), size));
    const int front = static_cast<int>(random.below(3)), next = static_cast<int>(random.below(3));
    Point3 on_face = place + 0.1;
    on_face[front] = place[front] + size[front];
    for (int axis = 0; axis < 3; ++axis) on_face[axis] = rounded(on_face[axis]);
    scene.place(on_face, whole.degrees, whole.then_move);
    scene.add(turned_to(front, rectangle(0.0, 0.0, 0.25, 0.35, {0.0})));
    place[next] = rounded(place[next] + size[next]);
  }
  return scene;
}

Scene floor_under_the_eye(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = touching_scene(random, severity);
  const double half = random.below(2) == 0 ? 20.0 : decimal(random, 15.0, 25.0);
  scene.add({{-half, 0.0, -half}, {-half, 0.0, half}, {half, 0.0, half}, {half, 0.0, -half}});
  for (std::size_t i = 0; i < n; ++i) {  // near the eye, most of them, some right under it
    const double radius = random.between(0.5, 4.0);
    scene.add(random_rug(random, random_place(random, {-4.0, 4.0}), radius, 0.0));
  }
  const Point3 eye{decimal(random, -1.0, 1.0), decimal(random, 0.5, 2.0),
                   decimal(random, -1.0, 1.0)};
  const Point2 ahead = on_circle(random.unit());
  const Point3 into = glm::normalize(Point3(ahead.x, -random.between(0.2, 1.0), ahead.y));
  const ModellingTransformation placed = transformation_of(scene);
  const Point3 eye_in_world = placed.apply(eye), into_in_world = placed.apply_to_difference(into);
  scene.view = looking(into_in_world);
  scene.view.set_reference_point(eye_in_world + into_in_world);
  scene.view.set_perspective(eye_in_world);
  scene.view.set_depth(-0.5, 30.0);
  return scene;
}

Scene two_views(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 2.5);
  Scene drawn;
  const double height = random_height(random);
  drawn.add(random_floor(random, height));
  add_rugs(random, n, height, drawn);
  add_boxes(random, n, height, drawn);
  View other = view_from_outside(random, random.below(2) == 0,
                                 transformation_of(scene).apply(Point3(0.0)), 1.8);
  other.set_viewport({0.4, 0.95, 0.3, 0.85});
  for (int time = 0; time < 2; ++time) {  // a second time in an inset
    if (time == 1) scene.open_segment(other);
    const Point3* vertex = drawn.points.data();
    for (const std::uint32_t sides : drawn.sides) {
      scene.add(std::span(vertex, sides));
      vertex += sides;
    }
  }
  return scene;
}

Scene image_transformed(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 2.5);
  const double height = random_height(random);
  ImageTransformation image;
  image.scale = Point2{decimal(random, 0.6, 1.4), decimal(random, 0.6, 1.4)};
  image.rotation = decimal(random, -40.0, 40.0);
  image.translation = Point2{decimal(random, -0.1, 0.1), decimal(random, -0.1, 0.1)};
  scene.open_segment(image);
  scene.add(random_floor(random, height));
  add_rugs(random, n, height, scene);
  scene.open_segment(
      image);  // objects standing there are a segment of their own, transformed alike
  add_rugs(random, n, height, scene);
  add_boxes(random, n, height, scene);
  return scene;
}

Scene rug_on_drilled_table(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene = seen_from_outside(random, severity, 2.2);
  const double height = random_height(random), thick = decimal(random, 0.1, 0.3);
  const Point2 notch{decimal(random, -0.4, 0.4), decimal(random, -0.2, 0.4)};
  const Point2 centre{decimal(random, -1.1, -0.9), decimal(random, -0.7, -0.5)};
  const std::vector<Point2> outline{{-1.8, -1.4}, {1.8, -1.4},    {1.8, notch.y},
                                    notch,        {notch.x, 1.4}, {-1.8, 1.4}};
  for (const double level : {height - thick, height}) {  // the hole is joined to the outline
    Polygon face;
    for (const Point2& p : outline) face.push_back({p.x, level, p.y});
    face.push_back(face.front());
    for (std::size_t k = 9; k-- > 0;) {
      const Point2 p = centre + 0.5 * on_circle(static_cast<double>(k) / 8.0);
      face.push_back({p.x, level, p.y});
    }
    scene.add(face);
  }
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Point2 &a = outline[k], &b = outline[(k + 1) % outline.size()];
    scene.add({{a.x, height - thick, a.y},
               {b.x, height - thick, b.y},
               {b.x, height, b.y},
               {a.x, height, a.y}});
  }
  for (std::size_t i = 0; i < n; ++i) {  // some over the hole's edge, some over the table's
    const Point2 near = centre + random_place(random, {-0.5, 1.5});
    scene.add(random_rug(random, near, random.between(0.2, 0.7), height));
  }
  return scene;
}

constexpr std::string_view kSeen = "0 parallel, 1 perspective, 2 and 3 the same turned and moved";

}  // namespace

std::vector<HardCase> contact_families() {
  const std::vector<double> any_view{0, 1, 2, 3}, perspective{1, 3};
  constexpr JudgedFrom kEntered = JudgedFrom::entered;
  return {
      {"rug_on_floor", "rugs that lie in a floor's plane and on each other", kSeen, 5, any_view,
       rug_on_floor,
       "One level plane as entered, and after viewing as many planes as there are polygons, a few "
       "units of the last place apart.",
       kEntered},
      {"flush_windows", "frames in the planes of a house's walls, and panes in the frames", kSeen,
       8, any_view, flush_windows,
       "Three layers in one plane; each wall is seen at another slope, some nearly edge-on.",
       kEntered},
      {"boxes_on_floor", "boxes on a floor, on each other and against each other", kSeen, 9,
       any_view, boxes_on_floor,
       "Faces lie back to back, and the foot of each box lies in the floor; much of this is "
       "visible only from below.",
       kEntered},
      {"flush_boxes", "boxes between a few planes, whose faces lie in each other's", kSeen, 8,
       any_view, flush_boxes,
       "Boxes overlap, and most of the visible surface lies in the plane of several; the order of "
       "entry decides which is visible.",
       kEntered},
      {"bricks", "two walls of bricks with studs, that meet in a corner", kSeen, 8, any_view,
       bricks,
       "The top of a row is computed differently from the foot of the next, and differs in the "
       "last place; studs stand on one and reach into the other; in the corner bricks of both "
       "walls overlap, side in side.",
       kEntered},
      {"decals_on_slopes", "rectangles and triangles in the slopes of a roof, in decimals", kSeen,
       10, any_view, decals_on_slopes,
       "The slope is a decimal too: as doubles hardly any decal lies in the roof's plane, even "
       "before viewing.",
       kEntered},
      {"parts_in_decimals",
       "boxes and plates on them, drawn about the origin and moved by decimals", kSeen, 8, any_view,
       parts_in_decimals,
       "Sides and places add up in decimals but not as doubles: faces that meet are apart by a "
       "rounded sum. Places are a few sides away; farther out such sums exceed the reach, which is "
       "that of the parts' own coordinates.",
       kEntered},
      {"floor_under_the_eye", "a floor that passes under and behind the eye, with rugs",
       "1 perspective, 3 the same turned and moved", 10, perspective, floor_under_the_eye,
       "Clipped where it passes the eye, so that its corners in the picture are rounded "
       "intersections; toward the horizon all depths are close.",
       kEntered},
      {"two_views", "rugs and boxes on a floor, in one view and again in an inset", kSeen, 3,
       any_view, two_views,
       "Each plane occurs twice, rounded by two views: contact in one must not be confused with "
       "the other, which lies over it in the picture.",
       kEntered},
      {"image_transformed", "a floor, and the objects on it in a segment of their own", kSeen, 3,
       any_view, image_transformed,
       "Both segments are scaled, turned and moved in the picture, which rounds once more after "
       "viewing.",
       kEntered},
      {"rug_on_drilled_table", "rugs on a table top with a notch and a hole", kSeen, 6, any_view,
       rug_on_drilled_table,
       "A concave polygon with a slit of no width to its hole: its support plane goes through "
       "corners that are far from where the rugs lie.",
       kEntered},
  };
}

}  // namespace displayfile
