#include "programs/scenes/families.h"
#include "programs/scenes/shapes.h"

// Perspective and oblique views.

namespace displayfile {

namespace {

/// The viewer at `eye` above the view plane z = 0, looking along -z at a window of two by two.
View perspective_view(double eye, double front, double back) {
  View view;
  view.set_perspective({0.0, 0.0, eye});
  view.set_depth(front, back);
  return view;
}

Scene near_front_plane(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  // The front plane almost touches the viewer: most of the depth range is spent on near objects.
  scene.view = perspective_view(1.0, -(1.0 - gap(severity)), 100.0);
  for (std::size_t i = 0; i < n; ++i) {
    const double z = -random.between(1.0, 99.0), reach = 1.0 - z;
    const Point2 place = random_place(random, {-1.0, 1.0});
    Polygon face = regular(4, reach * place, reach * 0.7, random.unit(), {z, 0.01, 0.01});
    scene.add(face);
  }
  return scene;
}

Scene ground_to_horizon(std::size_t n, double severity, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  const double far = 1.0 / gap(severity);
  scene.view = perspective_view(2.0, -1.0, far);
  const double step = far / static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) {  // road and stripes on it, to the horizon
    const double near = 1.0 - static_cast<double>(i) * step, back = near - 1.5 * step;
    scene.add({{-far, -1.0, near}, {far, -1.0, near}, {far, -1.0, back}, {-far, -1.0, back}});
    const double shift = random.between(-1.0, 1.0);
    scene.add({{shift - 0.5, -1.0, near},
               {shift + 0.5, -1.0, near},
               {shift + 0.5, -1.0, back},
               {shift - 0.5, -1.0, back}});
  }
  return scene;
}

Scene decals_in_perspective(std::size_t n, double slope, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.view = perspective_view(3.0, -1.0, 5.0);
  const Sheet wall{-1.0, slope, slope / 2.0};
  scene.add(rectangle(-2.0, -2.0, 2.0, 2.0, wall));
  for (std::size_t i = 0; i < n; ++i) {
    scene.add(random_regular(random, 4, {-1.5, 1.5}, {0.2, 0.8}, wall));
  }
  return scene;
}

Scene behind_the_viewer(std::size_t n, double reach, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.view = perspective_view(1.0, -0.5, 10.0);
  for (std::size_t i = 0; i < n; ++i) {  // cut where it passes the viewer
    Polygon triangle;
    for (int k = 0; k < 3; ++k) {
      const Point2 place = random_place(random, {-reach, reach});
      triangle.emplace_back(place, random.between(-5.0, 5.0));
    }
    scene.add(triangle);
  }
  return scene;
}

Scene oblique_view(std::size_t n, double slant, std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.view.set_parallel({slant, -slant / 3.0, 1.0});
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 low{0.125 * static_cast<double>(random.below(6)),
                     0.125 * static_cast<double>(random.below(6)),
                     0.25 * static_cast<double>(random.below(3))};
    scene.add(box(low, low + 0.25));
  }
  return scene;
}

}  // namespace

std::vector<HardCase> view_families() {
  return {
      {"near_front_plane",
       "perspective with the front plane close to the viewer",
       "its distance 10^-s",
       16,
       {2, 6, 12},
       near_front_plane,
       "The perspective transform spends the depth range close to the viewer; everything farther "
       "shares the last few digits."},
      {"ground_to_horizon",
       "a road and its stripes, to the horizon",
       "length 10^s",
       20,
       {2, 5, 8},
       ground_to_horizon,
       "A plane seen at a grazing angle, with overlapping coplanar stripes, most of which fall "
       "within one row."},
      {"decals_in_perspective",
       "squares in the plane of a wall, in perspective",
       "slope",
       10,
       {0.0, 0.5},
       decals_in_perspective,
       "Coplanar in the world, but each vertex is rounded after the perspective division."},
      {"behind_the_viewer",
       "triangles that pass the viewer, cut by the front plane",
       "reach",
       20,
       {3, 1000},
       behind_the_viewer,
       "Clipped in homogeneous coordinates; depths behind the back plane are below 0, where "
       "integers clamp."},
      {"oblique_view",
       "cubes with shared faces in an oblique projection",
       "slant",
       10,
       {0.5, 3.0},
       oblique_view,
       "Coinciding faces and shared edges after a shear that rounds."},
  };
}

}  // namespace displayfile
