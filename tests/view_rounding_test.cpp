// The bound of viewing's rounding.

#include "displayfile/views/view_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "displayfile/views/retained_views.h"
#include "tests/random_views.h"
#include "tests/retained_truth.h"
#include "tests/sort_scenes.h"
#include "tests/world_truth.h"

namespace displayfile {
namespace {

using namespace test;

TEST(ViewRounding, BoundsWhatTheTransformationRounds) {
  using test::Q;
  Source s(1);
  double most_of_bound = 0.0;
  for (int trial = 0; trial < 20000; ++trial) {
    const View view = test::any_view(s);
    const ViewVolume volume(view);
    ClipPipeline pipeline(volume);
    const double scale = std::pow(10.0, s.between(-3, 2));
    const Point3 ends[] = {Point3(0.5) + scale * (test::in_cube(s) - Point3(0.5)),
                           Point3(0.5) + scale * (test::in_cube(s) - Point3(0.5))};
    Point3 viewed[2];
    if (!pipeline.clip_line(ends[0], ends[1], viewed[0], viewed[1])) continue;
    const double bound = ViewRounding(view, volume).of(ends, viewed, 0.0);
    // The distance of the clipped point from the line, viewed exactly.
    const auto exactly = [&](const Point3& p) {
      const glm::dmat4& m = volume.matrix();
      const auto row = [&](int i) -> Q {
        return Q(m[0][i]) * Q(p.x) + Q(m[1][i]) * Q(p.y) + Q(m[2][i]) * Q(p.z) + Q(m[3][i]);
      };
      return std::array<Q, 3>{row(0), row(1), row(3)};
    };
    const auto a = exactly(ends[0]), b = exactly(ends[1]);
    const std::array<Q, 3> line = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                   a[0] * b[1] - a[1] * b[0]};
    const double slope = std::abs(line[0].get_d()) + std::abs(line[1].get_d());
    if (slope == 0.0) continue;
    for (const Point3& p : viewed) {
      const Q off = line[0] * Q(p.x) + line[1] * Q(p.y) + line[2];
      const double distance = std::abs(off.get_d()) / slope;  // no more than along x and along y
      ASSERT_LE(distance, bound) << test::text_of(view);
      most_of_bound = std::max(most_of_bound, distance / bound);
    }
  }
  EXPECT_GT(most_of_bound, 1e-3) << "the bound says next to nothing";
}

/// Quadrangles that are flat within the tolerance only, seen from so near that it shows: a piece's
/// vertices are in the plane, the whole polygon's are not.
TEST(ViewRounding, CountsWhatIsNotQuiteFlat) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_line_style({LineStyle::Kind::none});
  constexpr double kBent = 1e-6;
  g.open_segment(1);
  g.polygon_abs_3({{-1, -1, 0}, {0, -1, 0}, {0, 1, kBent}, {-1, 1, 0}});
  g.polygon_abs_3({{0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, kBent}});
  for (const double y : {-0.2, -0.1, 0.0, 0.1, 0.2}) {  // enough of them to cut and not be cut
    g.polygon_abs_3({{-1, y, -0.5}, {1, y, -0.5}, {1, y, 0.5}, {-1, y, 0.5}});
  }
  g.close_segment();
  ASSERT_EQ(g.counts().triangulated, 0);
  RetainedViews views(retained.scene, g.display_file(), {});
  EXPECT_GT(views.counts().cuts, 0u);
  View view = test::looking({0.8, 0.3, -0.6});
  view.set_parallel(view.plane_normal);
  constexpr double kWindow = 1e-5;
  view.set_window({-kWindow, kWindow, -kWindow, kWindow});
  for (const Point2 at :
       {Point2(-1.0, 0.9), Point2(-0.2, -1.0), Point2(0.0, -0.9), Point2(0.2, -1)}) {
    view.set_reference_point({at.x, at.y, 0.5 * kBent});
    const Judged picture = judged(views.view(view), 64);
    EXPECT_TRUE(picture.wrong.empty()) << picture.wrong.size() << " at " << at.x << " " << at.y;
  }
}

}  // namespace
}  // namespace displayfile
