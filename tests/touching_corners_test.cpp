// Corners that are on a line, or on a side, up to rounding: polygons behind the crack that rounding
// leaves are hidden, and a side along another polygon's plane is not where that passes through it.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/intersection_lines.h"
#include "tests/length_of_lines.h"

namespace displayfile {
namespace {

using test::expect_length;
using test::kMethodsOfLines;
using test::length_of;

// ---- Corners close to lines ---------------------------------------------------------------------

/// The far side of the first polygon is right behind the side that the others share, of which the
/// third has a part alone: its corner there is on the line only up to rounding.
TEST(TouchingCorners, ASideBehindASharedOneWithACornerAlongItIsHidden) {
  expect_length(
      "set-view-reference-point 0.0 72.0 0.0\n"
      "set-view-plane-normal 0.0 0.0 -1.0\n"
      "set-view-up 0.0 1.0 0.0\n"
      "set-parallel 0.0 0.0 1.0\n"
      "set-window -188.03444790782353 188.03444790782353 -188.03444790782353 188.03444790782353\n"
      "set-view-depth -188.03444790782353 188.03444790782353\n"
      "set-hidden-line-removal on\n"
      "set-back-face-removal off\n"
      "set-line-style solid 0 0 0\n"
      "open-segment 1\n"
      "polygon-abs-3 -56.625 144.0 -7.875 -42.0 144.0 -42.0 -84.0 0.0 -84.0 -120.0 0.0 "
      "0.0 -97.5 54.0 0.0\n"
      "polygon-abs-3 -84.0 0.0 84.0 -42.0 144.0 42.0 -47.625 144.0 28.875\n"
      "polygon-abs-3 -79.078125 16.875 79.078125 -84.0 0.0 84.0 -65.625 0.0 91.875\n"
      "close-segment\n",
      {0, 0, 0}, 1.866883123574);
}

/// Plates of a box in single precision, turned and moved. A corner of one is on the side of
/// another, and within reach of it; that side's far end is not within reach of the small face's
/// plane.
TEST(TouchingCorners, ASmallFaceBesideASideDoesNotHideAStretchOfIt) {
  GraphicsSystem g;
  replay(
      "set-view-reference-point 172.19775589796325 318.3494149987174 -1283.320149667458\n"
      "set-view-plane-normal 0.9124912859100278 -0.1356977908885135 -0.3859349202731475\n"
      "set-view-up 0.034909168172158445 0.24764815510333388 0.9682209155205453\n"
      "set-parallel -0.9124912859100278 0.1356977908885135 0.3859349202731475\n"
      "set-window -307.1402754442992 307.1402754442992 -307.1402754442992 307.1402754442992\n"
      "set-view-depth -307.1402754442992 307.1402754442992\n"
      "set-back-face-removal off\n"
      "set-fill-style solid 1 1 1\n"
      "set-line-style solid 0 0 0\n"
      "set-hidden-line-removal on\n"
      "set-back-face-removal off\n"
      "set-lines crease\n"
      "set-touching 0.0006195888272486627\n"
      "open-segment 1\n"
      "polygon-abs-3 171.8023223876953 102.23967742919922 -1086.2607421875 "
      "178.36276245117188 112.23853302001953 -1085.2689208984375 -121.92456817626953 "
      "330.40155029296875 -1298.380126953125\n"
      "polygon-abs-3 -121.92456817626953 330.40155029296875 -1298.380126953125 "
      "-128.48500061035156 320.4026794433594 -1299.3719482421875 171.8023223876953 "
      "102.23967742919922 -1086.2607421875\n"
      "polygon-abs-3 180.2216033935547 96.12295532226562 -1080.28564453125 "
      "359.5401916503906 369.42486572265625 -1053.176513671875 351.1209411621094 "
      "375.5415954589844 -1059.151611328125\n"
      "polygon-abs-3 351.1209411621094 375.5415954589844 -1059.151611328125 "
      "171.8023223876953 102.23967742919922 -1086.2607421875 180.2216033935547 "
      "96.12295532226562 -1080.28564453125\n"
      "polygon-abs-3 351.1209411621094 375.5415954589844 -1059.151611328125 "
      "458.97705078125 324.9836120605469 -1262.8841552734375 279.6584167480469 "
      "51.68169403076172 -1289.9932861328125\n"
      "polygon-abs-3 279.6584167480469 51.68169403076172 -1289.9932861328125 "
      "171.8023223876953 102.23967742919922 -1086.2607421875 351.1209411621094 "
      "375.5415954589844 -1059.151611328125\n"
      "close-segment\n",
      "test", g);
  for (const HiddenMethod method : kMethodsOfLines) {
    EXPECT_NEAR(length_of(g, method, Colour{0, 0, 0}), 0.49940279892650885, 1e-6)
        << name_of(method);
  }
}

/// Two triangles of a wall and three of a rib far behind it, which are edge-on up to rounding: the
/// depth of their plane is arbitrary there, but that of the rib's sides is not.
TEST(TouchingCorners, SidesOfFacesSeenNearlyEdgeOnAreHiddenByAWall) {
  GraphicsSystem g;
  replay(
      "set-view-reference-point 4108.341552734375 -1847.4799194335938 342\n"
      "set-view-plane-normal 0.39073112848927377 -0.9205048534524404 -0\n"
      "set-view-distance 0\n"
      "set-view-up 0 0 1\n"
      "set-parallel -0.39073112848927377 0.9205048534524404 0\n"
      "set-view-depth -14.777276780418386 57.9376127570934\n"
      "set-window -72.50625814743573 60.826921543798036 -66.66658984561691 "
      "66.66658984561685\n"
      "set-hidden-line-removal on\n"
      "set-back-face-removal off\n"
      "set-line-style solid 0 0 0\n"
      "set-lines outline crease\n"
      "set-touching 0.001985376002267003\n"
      "open-segment 1\n"
      "polygon-abs-3 4163.50830078125 -1808.9410400390625 289 4053.0478515625 "
      "-1855.8287353515625 289 4053.0478515625 -1855.8287353515625 395\n"
      "polygon-abs-3 4163.50830078125 -1808.9410400390625 289 4053.0478515625 "
      "-1855.8287353515625 395 4163.50830078125 -1808.9410400390625 395\n"
      "polygon-abs-3 4134.8935546875 -1843.90087890625 345 4163.63525390625 "
      "-1886.018798828125 295 4144.0986328125 -1839.9935302734375 345\n"
      "polygon-abs-3 4163.63525390625 -1886.018798828125 295 4163.63525390625 "
      "-1886.018798828125 289 4142.14501953125 -1835.3909912109375 345\n"
      "polygon-abs-3 4142.14501953125 -1835.3909912109375 345 4144.0986328125 "
      "-1839.9935302734375 345 4163.63525390625 -1886.018798828125 295\n"
      "close-segment\n",
      "test", g);
  for (const HiddenMethod method : kMethodsOfLines) {
    EXPECT_EQ(length_of(g, method, Colour{0, 0, 0}), 0.0) << name_of(method);
  }
}

// ---- Where polygons pass through each other -----------------------------------------------------

/// The notch of a plate around a post, whose corners are on both sides of each of the post's faces.
/// One face of the post is wider than the notch: beyond it the plate is passed through.
TEST(TouchingCorners, NoIntersectionAlongASideInTheOthersPlane) {
  for (int degrees = 0; degrees < 90; ++degrees) {
    if (degrees == 45) continue;  // the post is seen edge-on
    SCOPED_TRACE(degrees);
    for (const double wider : {0.0, 0.1}) {
      GraphicsSystem g;
      g.set_view_plane_normal({-1, -2, -2});
      g.set_parallel({1, 2, 2});
      g.set_window(-3, 3, -3, 3);
      g.set_view_depth(-5, 5);
      g.rotate_x_3(degrees);
      g.open_segment(1);
      g.polygon_abs_3({{-0.9, 0, -0.7},
                       {-0.3, 0, -0.7},
                       {-0.3, 0, 0.1},
                       {0.3, 0, 0.1},
                       {0.3, 0, -0.7},
                       {0.9, 0, -0.7},
                       {0.9, 0, 0.7},
                       {-0.9, 0, 0.7}});
      const double x = 0.3 + wider;
      g.polygon_abs_3({{-0.3, -0.2, 0.1}, {x, -0.2, 0.1}, {x, 0.4, 0.1}, {-0.3, 0.4, 0.1}});
      g.close_segment();
      const auto lines = intersection_lines(ViewedScene(g.display_file()).primitives(), 1);
      ASSERT_EQ(lines.size(), wider > 0.0 ? 1u : 0u);
      if (lines.empty()) continue;
      // As long as the part beyond the notch.
      const Primitives items = ViewedScene(g.display_file()).primitives();
      const auto length = [](const Point3& a, const Point3& b) {
        return glm::distance(Point2(a), Point2(b));
      };
      const double notch = length(items.points[2], items.points[3]);
      EXPECT_NEAR(length(lines[0].start, lines[0].end), notch * wider / 0.6, 1e-12);
    }
  }
}

}  // namespace
}  // namespace displayfile
