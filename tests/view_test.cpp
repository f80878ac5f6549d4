#include "clip/view/view_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/mat4x4.hpp>
#include <limits>
#include <random>
#include <string>

#include "clip/base/error.h"
#include "tests/error_of.h"

namespace displayfile {
namespace {

using test::error_of;

// The problem book's normalised perspective view volume, in our convention: the book looks
// along +z from the origin, we along -z, so its (x, y, z) is our (x, y, -z). Its window is
// x, y in [-1, 1] at z = 1, its front plane z = z_front and its back plane z = 1.
View book_view(double z_front) {
  View view;
  view.set_reference_point({0, 0, -1});
  view.set_perspective({0, 0, 0});
  view.set_depth(z_front - 1.0, 0.0);
  view.set_window({-1, 1, -1, 1});
  return view;
}

Point3 book_point(const ViewVolume& volume, double x, double y, double z) {
  return volume.to_device(volume.transform({x, y, -z}));
}

TEST(ViewVolume, DefaultViewPlaneCoordinatesEqualWorldCoordinates) {
  EXPECT_EQ(ViewVolume(View{}).view_plane(), glm::dmat4(1.0));
}

// Problem 10.1: from C(0,0,-10), P1(1,2,0) obscures P2(3,6,20); P3(2,4,6) lies on neither's
// projector.
TEST(ViewVolume, Problem10_1WhichPointObscuresWhich) {
  View view;
  view.set_reference_point({0, 0, -5});
  view.set_plane_normal({0, 0, 1});  // the book's viewer looks along +z
  view.set_perspective({0, 0, -10});
  view.set_depth(-1, 100);
  view.set_window({-10, 10, -10, 10});
  const ViewVolume volume(view);
  const Point3 p1 = volume.to_device(volume.transform({1, 2, 0}));
  const Point3 p2 = volume.to_device(volume.transform({3, 6, 20}));
  const Point3 p3 = volume.to_device(volume.transform({2, 4, 6}));
  EXPECT_NEAR(p1.x, p2.x, 1e-15);  // on the same projector
  EXPECT_NEAR(p1.y, p2.y, 1e-15);
  EXPECT_GT(p1.z, p2.z);  // P1 is nearer
  EXPECT_GT(std::abs(p3.x - p1.x), 1e-3);
}

// Problem 10.2: the transform takes P(x,y,z) to (x/z, y/z, (z - zf)/(z (1 - zf))) and so has
// the image of the perspective projection.
TEST(ViewVolume, Problem10_2PerspectiveBecomesParallel) {
  const double zf = 0.25;
  const ViewVolume volume(book_view(zf));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> across(-1, 1), depth(zf, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double z = depth(random), x = across(random) * z, y = across(random) * z;
    const Point3 q = book_point(volume, x, y, z);
    EXPECT_NEAR(q.x, (x / z + 1) / 2, 1e-15);
    EXPECT_NEAR(q.y, (y / z + 1) / 2, 1e-15);
    EXPECT_NEAR(q.z, 1.0 - (z - zf) / (z * (1 - zf)), 1e-14);  // ours grows toward the viewer
  }
}

// Problem 10.3: the view volume's corners go to those of the unit cube.
TEST(ViewVolume, Problem10_3ViewVolumeBecomesTheUnitCube) {
  const double zf = 0.125;
  const ViewVolume volume(book_view(zf));
  for (double z : {zf, 1.0}) {
    for (double x : {-z, z}) {
      for (double y : {-z, z}) {
        const Point3 q = book_point(volume, x, y, z);
        EXPECT_DOUBLE_EQ(q.x, x < 0 ? 0.0 : 1.0);
        EXPECT_DOUBLE_EQ(q.y, y < 0 ? 0.0 : 1.0);
        EXPECT_NEAR(q.z, z == zf ? 1.0 : 0.0, 1e-15);
      }
    }
  }
}

// The slides' matrix for a projection plane at v = 1 and a near plane at h:
// z' z = z/(1-h) - h/(1-h), with x' = x/z.
TEST(ViewVolume, SlidesMatrixForVEqualOne) {
  for (double h : {0.1, 0.5, 0.9}) {
    const ViewVolume volume(book_view(h));
    for (double z : {h, 0.95, 1.0}) {
      const Point3 q = book_point(volume, 0.3, -0.2, z);
      const double slides_z = (z / (1 - h) - h / (1 - h)) / z;
      EXPECT_NEAR(1.0 - q.z, slides_z, 1e-14);
      EXPECT_NEAR(2 * q.x - 1, 0.3 / z, 1e-14);
      EXPECT_NEAR(2 * q.y - 1, -0.2 / z, 1e-14);
    }
  }
}

// The critical fact of section 10.1: planes stay planes and depth order is kept.
TEST(ViewVolume, PerspectiveKeepsPlanesAndDepthOrder) {
  View view;
  view.set_reference_point({1, -2, 0.5});
  view.set_plane_normal({-1, 0.3, -2});
  view.set_up({0.1, 1, 0});
  view.set_perspective({6, -3, 9});
  view.set_depth(-4, 9);
  const ViewVolume volume(view);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 500; ++i) {
    const Point3 a(u(random), u(random), u(random)), b(u(random), u(random), u(random)),
        c(u(random), u(random), u(random));
    const Point3 d = a + u(random) * (b - a) + u(random) * (c - a);
    const auto device = [&](const Point3& p) { return volume.to_device(volume.transform(p)); };
    const Point3 p = device(a), q = device(b) - p, r = device(c) - p, s = device(d) - p;
    const double volume_of_four = q.x * (r.y * s.z - r.z * s.y) - q.y * (r.x * s.z - r.z * s.x) +
                                  q.z * (r.x * s.y - r.y * s.x);
    EXPECT_NEAR(volume_of_four, 0.0, 1e-15);
    const Point3 eye(6, -3, 9);  // two points of one projector
    const Point3 nearer = eye + 0.9 * (a - eye);
    EXPECT_GT(device(nearer).z, device(a).z);
    EXPECT_NEAR(device(nearer).x, device(a).x, 1e-12);
    EXPECT_NEAR(device(nearer).y, device(a).y, 1e-12);
  }
}

TEST(ViewVolume, FrontPlaneIsOneBackPlaneIsZero) {
  View view;
  view.set_distance(0.5);
  view.set_depth(-2, 6);
  for (bool perspective : {false, true}) {
    if (perspective) view.set_perspective({0.4, 0.1, 7});
    const ViewVolume volume(view);
    EXPECT_NEAR(volume.to_device(volume.transform({0, 0, 2})).z, 1.0, 1e-15);
    EXPECT_NEAR(volume.to_device(volume.transform({0, 0, -6})).z, 0.0, 1e-15);
  }
}

TEST(ViewVolume, ObliqueProjectionShearsWithDepth) {
  View view;
  view.set_parallel({0.5, 0.25, 1});
  view.set_window({0, 1, 0, 1});
  const ViewVolume volume(view);
  const Point3 p = volume.to_device(volume.transform({0.5, 0.5, 0.4}));
  EXPECT_NEAR(p.x, 0.5 - 0.5 * 0.4, 1e-15);
  EXPECT_NEAR(p.y, 0.5 - 0.25 * 0.4, 1e-15);
}

TEST(ViewVolume, OppositeDirectionsOfProjectionAreTheSame) {
  View view;
  view.set_parallel({0.5, 0.25, 1});
  const ViewVolume forward(view);
  view.set_parallel({-0.5, -0.25, -1});
  EXPECT_EQ(ViewVolume(view).matrix(), forward.matrix());
}

void expect_error(const View& view, const std::string& words) {
  test::expect_error([&] { ViewVolume volume(view); }, words);
}

TEST(ViewVolume, ParametersThatDoNotFitTogether) {
  View view;
  view.set_up({0, 0, 2});
  expect_error(view, "view up along the view plane normal");
  view = {};
  view.set_perspective({0, 0, -1});
  expect_error(view, "centre of projection on the wrong side");
  view.set_perspective({0, 0, 0});
  expect_error(view, "centre of projection on the wrong side");
  view.set_perspective({0, 0, 0.5});  // the default front plane is at z = 1
  expect_error(view, "centre of projection on the wrong side of the front plane");
  view.set_perspective({0, 0, 1});  // in that plane
  expect_error(view, "centre of projection on the wrong side of the front plane");
  view = {};
  view.set_parallel({1, 0, 0});
  expect_error(view, "direction of projection parallel to the view plane");
  view = {};
  view.set_window({0, 1e-110, 0, 1});
  expect_error(view, "view out of range");
}

TEST(ViewVolume, DirectionsThatAreNearlyParallelStillFit) {
  View view;
  view.set_up({1e-7, 0, 2});
  EXPECT_NO_THROW(ViewVolume volume(view));
}

TEST(View, RefusesWhatItCanTellAloneAndStaysAsItWas) {
  View view;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_THROW(view.set_plane_normal({0, 0, 0}), Error);
  EXPECT_THROW(view.set_plane_normal({0, nan, 0}), Error);
  EXPECT_THROW(view.set_up({0, 0, 0}), Error);
  EXPECT_THROW(view.set_parallel({0, 0, 0}), Error);
  EXPECT_THROW(view.set_perspective({inf, 0, 0}), Error);
  EXPECT_THROW(view.set_depth(1, 1), Error);
  EXPECT_THROW(view.set_depth(2, 1), Error);
  EXPECT_THROW(view.set_depth(nan, 1), Error);
  EXPECT_THROW(view.set_window({1, 1, 0, 1}), Error);
  EXPECT_THROW(view.set_window({0, 1, 2, 1}), Error);
  EXPECT_THROW(view.set_viewport({0, 1.5, 0, 1}), Error);
  EXPECT_THROW(view.set_viewport({0.5, 0.5, 0, 1}), Error);
  EXPECT_THROW(view.set_reference_point({1e101, 0, 0}), Error);
  EXPECT_THROW(view.set_distance(inf), Error);
  EXPECT_EQ(view.plane_normal, Point3(0, 0, -1));
  EXPECT_EQ(view.projection, View::Projection::parallel);
  EXPECT_EQ(view.window, (Rectangle{-1, 1, -1, 1}));
  EXPECT_EQ(view.front, -1.0);
}

/// Each bound of a range is tried from both sides, in each coordinate.
TEST(View, TakesWhatIsAtTheEndOfARange) {
  View view;
  view.set_viewport({0, 1, 0, 1});
  EXPECT_EQ(view.viewport, (Rectangle{0, 1, 0, 1}));
  const Rectangle inside{0.25, 0.75, 0.25, 0.75};
  view.set_viewport(inside);
  constexpr double kBeyond = 0x1p-40;
  Rectangle left = inside, right = inside, below = inside, above = inside;
  left.x_min = -kBeyond;
  right.x_max = 1.0 + kBeyond;
  below.y_min = -kBeyond;
  above.y_max = 1.0 + kBeyond;
  for (const Rectangle& wrong : {left, right, below, above}) {
    EXPECT_EQ(error_of([&] { view.set_viewport(wrong); }),
              "viewport leaves the display: expected values within 0 to 1");
  }
  for (const Rectangle& flat : {Rectangle{1, 1, 0, 1}, Rectangle{0, 1, 1, 1}, Rectangle{1, 0, 0, 1},
                                Rectangle{0, 1, 1, 0}}) {
    EXPECT_NE(error_of([&] { view.set_viewport(flat); }).find("viewport has no area"),
              std::string::npos);
    EXPECT_NE(error_of([&] { view.set_window(flat); }).find("window has no area"),
              std::string::npos);
  }
  EXPECT_EQ(view.viewport, inside);

  view.set_depth(-1e100, 1e100);
  view.set_depth(0.0, 0x1p-1000);
  EXPECT_EQ(view.front, 0.0);
  EXPECT_EQ(view.back, 0x1p-1000);
  EXPECT_EQ(error_of([&] { view.set_depth(0.5, 0.5); }),
            "front plane behind back plane: expected front distance < back distance");
  EXPECT_NE(error_of([&] { view.set_depth(0.0, 1e101); }).find("view depth is not"),
            std::string::npos);
  EXPECT_NE(error_of([&] { view.set_depth(-1e101, 0.0); }).find("view depth is not"),
            std::string::npos);
  EXPECT_EQ(view.back, 0x1p-1000);
}

/// From an eye: the target in the middle, the angle from the bottom to the top, the front plane
/// just before the eye and the back plane as far behind the target as the eye is before it.
TEST(LookAt, SeesTheAngleOfViewAroundTheTarget) {
  for (const double angle : {1.0, 60.0, 90.0, 179.0}) {
    const View view = look_at({2, 3, 9}, {2, 3, 4}, {0, 1, 0}, angle);
    const double half = 5.0 * std::tan(angle * 0.5 * 0.017453292519943295);
    EXPECT_NEAR(view.window.y_max, half, 1e-12 * half) << angle;
    EXPECT_EQ(view.window, (Rectangle{-view.window.y_max, view.window.y_max, -view.window.y_max,
                                      view.window.y_max}));
    EXPECT_EQ(view.reference_point, Point3(2, 3, 4));
    EXPECT_EQ(view.centre_of_projection, Point3(2, 3, 9));
    EXPECT_EQ(view.projection, View::Projection::perspective);
    EXPECT_EQ(view.plane_normal, Point3(0, 0, -5));
    EXPECT_DOUBLE_EQ(view.front, -0.999 * 5.0);
    EXPECT_DOUBLE_EQ(view.back, 5.0);
  }
  // The distance of the eye does not overflow, and each coordinate counts.
  for (const Point3& eye :
       {Point3(3e99, 4e99, 0), Point3(0, -3e99, 4e99), Point3(4e99, 0, -3e99)}) {
    EXPECT_DOUBLE_EQ(look_at(eye, {0, 0, 0}, {1, 1, 1}, 40.0).back, 5e99);
  }
}

TEST(LookAt, RefusesAnglesAndDirectionsThatShowNothing) {
  const auto error = [](double angle) {
    return error_of([&] { look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, angle); });
  };
  EXPECT_EQ(error(0x1p-20), "");
  EXPECT_EQ(error(180.0 - 0x1p-20), "");
  for (const double angle : {0.0, -1.0, 180.0, 181.0, std::nan("")}) {
    EXPECT_NE(error(angle).find("expected degrees, more than 0 and less than 180"),
              std::string::npos)
        << angle;
  }
  const auto error_of_up = [](const Point3& up) {
    return error_of([&] { look_at({0, 0, 5}, {0, 0, 0}, up); });
  };
  EXPECT_NE(error_of_up({0, 0, 3}).find("view up is along the line of sight"), std::string::npos);
  EXPECT_NE(error_of_up({0.9e-9, 0, -1}).find("view up is along"), std::string::npos);
  EXPECT_EQ(error_of_up({1.1e-9, 0, 1}), "");
  EXPECT_NE(error_of([] {
              look_at({1, 2, 3}, {1, 2, 3});
            }).find("the eye is at the target"),
            std::string::npos);
}

}  // namespace
}  // namespace displayfile
