// Annotation placed automatically: over generated assemblies no leaders cross, and no text covers
// the figure or another text.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/annotation/page_annotation.h"
#include "tests/replayed.h"

namespace displayfile {
namespace {

using namespace test;
using Kind = AnnotationMark::Kind;
using Polygon = std::vector<Point2>;

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool cross_each_other(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
}

/// Gift wrapping: slow and plain.
Polygon hull_of(const Polygon& points) {
  Polygon hull{
      *std::ranges::min_element(points, {}, [](const Point2& p) { return std::pair(p.x, p.y); })};
  for (;;) {
    Point2 next = hull.back();
    for (const Point2& p : points) {
      const double t = turn(hull.back(), next, p);
      if (next == hull.back() || t < 0.0 ||
          (t == 0.0 && glm::distance(hull.back(), p) > glm::distance(hull.back(), next))) {
        next = p;
      }
    }
    if (next == hull.front() || hull.size() > points.size()) return hull;
    hull.push_back(next);
  }
}

/// True if a side of one convex polygon, or of the other, has the other one beyond it.
bool apart(const Polygon& a, const Polygon& b) {
  const auto has_beyond = [](const Polygon& of, const Polygon& other) {
    for (std::size_t i = 0; i < of.size(); ++i) {
      const Point2& from = of[i];
      const Point2& to = of[(i + 1) % of.size()];
      if (std::ranges::all_of(other, [&](const Point2& p) { return turn(from, to, p) < 0.0; })) {
        return true;
      }
    }
    return false;
  };
  return has_beyond(a, b) || has_beyond(b, a);
}

/// What one annotation draws.
struct Drawn {
  std::vector<std::pair<Point2, Point2>> leader;  // one line, or none
  Polygon box;                                    // of its text, or of its circle
  Polygon arrows;  // of a dimension: its line and its text, in a hull
};

struct Assembly {
  GraphicsSystem system;
  AnnotationPage page;
  std::size_t labels = 0, dimensions = 0;
};

/// Parts and their labels: boxes and cylinders, in a random view, with room around the figure.
Assembly assembly(unsigned seed,
                  AnnotationStyle::Placement placement = AnnotationStyle::Placement::automatic) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
  };
  Assembly result;
  const bool wide = seed % 3 == 0;
  result.page = {wide ? 900 : 640, wide ? 600 : 640, kPixelsOfMillimetre};
  GraphicsSystem& g = result.system;
  const Point3 eye(uniform(-3, 3), uniform(-3, 3), uniform(1.5, 4));
  g.set_aspect_ratio(static_cast<double>(result.page.width) / result.page.height);
  View view = fit(look_at(eye, {0, 0, 0}), {-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}, g.aspect_ratio());
  const double room = uniform(1.5, 2.0);
  const Rectangle w = view.window;
  view.set_window({room * w.x_min, room * w.x_max, room * w.y_min, room * w.y_max});
  g.set_view(view);
  g.open_segment(1);
  g.set_annotation_placement(placement);
  g.set_annotation_ends(seed % 2 == 0 ? AnnotationStyle::Ends::arrow : AnnotationStyle::Ends::dot);
  const int parts = 4 + static_cast<int>(random() % 12);
  for (int k = 0; k < parts; ++k) {
    const Point3 low(uniform(-1, 0.6), uniform(-1, 0.6), uniform(-1, 0.6));
    const Point3 high = low + Point3(uniform(0.1, 0.6), uniform(0.1, 0.6), uniform(0.1, 0.6));
    if (random() % 2 == 0) {
      box_3(g, low, high);
    } else {
      cylinder_3(g, 0.5 * (low + high), 0.5 * (high.x - low.x), 0.3, 12);
    }
    const Point3 at(uniform(low.x, high.x), uniform(low.y, high.y), high.z);
    if (seed % 4 == 1 || (seed % 4 == 2 && k % 2 == 0)) {
      g.annotate(Leader{at, fmt::format("part {}", k + 1)});
    } else {
      g.annotate(Balloon{at, k + 1, fmt::format("Part {}", k + 1)});
    }
    ++result.labels;
  }
  if (seed % 5 < 2) {
    for (const double x : {0.8, 0.3}) {
      g.annotate(
          LinearDimension{LinearDimension::Axis::x, {-0.9, -1, -1}, {x, -1, -1}, {0, -0.2, 0}});
      ++result.dimensions;
    }
  }
  g.close_segment();
  return result;
}

std::vector<Drawn> drawn(const Assembly& a) {
  const auto marks = annotation_marks(a.system.display_file(), a.page);
  std::vector<Drawn> all(a.labels + a.dimensions);
  std::vector<int> lines(all.size());
  for (const AnnotationMark& mark : marks) {
    Drawn& of = all[mark.annotation];
    const bool is_label = mark.annotation < a.labels;
    const Polygon points = points_of(std::span(&mark, 1), a.page);
    if (is_label && mark.kind == Kind::line && !mark.closed && ++lines[mark.annotation] == 1) {
      of.leader.emplace_back(mark.points[0], mark.points[1]);
    } else if (is_label && (mark.kind == Kind::text || mark.kind == Kind::blank)) {
      of.box.insert(of.box.end(), points.begin(), points.end());
    } else if (!is_label && mark.kind != Kind::line) {
      of.arrows.insert(of.arrows.end(), points.begin(), points.end());
    }
  }
  for (Drawn& of : all) {
    if (!of.box.empty()) of.box = hull_of(of.box);
    if (!of.arrows.empty()) of.arrows = hull_of(of.arrows);
  }
  return all;
}

Polygon figure_of(const Assembly& a) {
  Polygon points;
  const ViewedScene scene(a.system.display_file());
  for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
    for (std::size_t i = 0; i < scene.points(item).size(); ++i) {
      const Point3 p = scene.points(item)[i];
      points.emplace_back(p.x * a.page.width, p.y * a.page.height);
    }
  }
  return hull_of(points);
}

/// Faults of one picture: leaders that cross, texts over the figure, over each other or in a
/// leader's way, anything outside of the picture.
int faults_of(const Assembly& a) {
  const std::vector<Drawn> all = drawn(a);
  const Polygon figure = figure_of(a);
  const auto is_inside = [&](const Polygon& polygon) {
    return std::ranges::all_of(polygon, [&](const Point2& p) {
      return p.x >= 0.0 && p.x <= a.page.width && p.y >= 0.0 && p.y <= a.page.height;
    });
  };
  int faults = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Polygon& own = all[i].box.empty() ? all[i].arrows : all[i].box;
    if (own.empty()) continue;
    faults += apart(own, figure) ? 0 : 1;
    faults += is_inside(own) ? 0 : 1;
    for (std::size_t j = 0; j < all.size(); ++j) {
      const Polygon& other = all[j].box.empty() ? all[j].arrows : all[j].box;
      if (i == j || other.empty()) continue;
      if (j < i) faults += apart(own, other) ? 0 : 1;
      if (all[i].leader.empty()) continue;
      const auto& [from, to] = all[i].leader[0];
      if (!all[j].box.empty()) faults += apart({from, to}, other) ? 0 : 1;
      if (j < i && !all[j].leader.empty()) {
        const auto& [from_other, to_other] = all[j].leader[0];
        faults += cross_each_other(from, to, from_other, to_other) ? 1 : 0;
      }
    }
  }
  return faults;
}

TEST(AnnotationPlacement, FiftyAssembliesHaveNoFault) {
  int as_entered = 0;
  std::size_t leaders = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Assembly a = assembly(seed);
    EXPECT_EQ(faults_of(a), 0) << "seed " << seed;
    for (const Drawn& label : drawn(a)) leaders += label.leader.size();
    as_entered += faults_of(assembly(seed, AnnotationStyle::Placement::entered));
  }
  EXPECT_GT(leaders, 300u);
  EXPECT_GT(as_entered, 500);  // the test sees faults
}

/// Where the figure fills the picture texts cover it, but they are in the picture, clear of each
/// other, and their leaders do not cross.
TEST(AnnotationPlacement, WithoutRoom) {
  GraphicsSystem g = replayed(
      "set-annotation-placement auto\nopen-segment 1\npolygon-abs-3 -1 -1 0  1 -1 0  1 1 0  -1 1 "
      "0\n"
      "leader-3 -0.5 0.5 0 \"upper left\"\nleader-3 0.5 0.5 0 \"upper right\"\n"
      "balloon-3 -0.5 -0.5 0 3\nballoon-3 0.5 -0.5 0 4\nclose-segment\n");
  Assembly a{std::move(g), {512, 512, kPixelsOfMillimetre}, 4};
  const std::vector<Drawn> all = drawn(a);
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_FALSE(all[i].box.empty());
    for (const Point2& p : all[i].box) {
      EXPECT_TRUE(p.x >= 0 && p.x <= 512 && p.y >= 0 && p.y <= 512) << i;
    }
    EXPECT_EQ(all[i].box[0].x < 256, i % 2 == 0);
    for (std::size_t j = 0; j < i; ++j) EXPECT_TRUE(apart(all[i].box, all[j].box));
  }
}

/// A figure as wide as the picture has its texts above and below.
TEST(AnnotationPlacement, InRows) {
  GraphicsSystem g = replayed(
      "set-annotation-placement auto\nopen-segment 1\n"
      "polygon-abs-3 -1 -.4 0  1 -.4 0  1 .4 0  -1 .4 0\n"
      "leader-3 -0.5 0.2 0 \"one\"\nleader-3 0.5 0.2 0 \"two\"\n"
      "balloon-3 -0.5 -0.2 0 3\nballoon-3 0.5 -0.2 0 4\nclose-segment\n");
  Assembly a{std::move(g), {512, 512, kPixelsOfMillimetre}, 4};
  EXPECT_EQ(faults_of(a), 0);
  const std::vector<Drawn> all = drawn(a);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(all[i].box[0].y > 256, i < 2);
  // A balloon's line ends at the point of the circle that is nearest to the figure.
  for (const std::size_t i : {2u, 3u}) {
    const auto [low, high] = std::ranges::minmax(all[i].box, {}, &Point2::y);
    EXPECT_NEAR(glm::distance(all[i].leader[0].first, high), 0.0, 1e-6) << low.y;
  }
}

/// What has no cell stays where it was entered.
TEST(AnnotationPlacement, MoreLabelsThanPlaces) {
  std::string program =
      "set-annotation-placement auto\nopen-segment 1\n"
      "polygon-abs-3 -.2 -.2 0  .2 -.2 0  .2 .2 0  -.2 .2 0\n";
  for (int k = 0; k < 60; ++k) program += fmt::format("balloon-3 0 0 0 {} \"\" 100 0\n", k + 1);
  Assembly a{replayed(program + "close-segment\n"), {512, 512, kPixelsOfMillimetre}, 60};
  const double entered = 256 + 100 * kPixelsOfMillimetre;
  std::size_t stay = 0;
  for (const Drawn& label : drawn(a)) {
    ASSERT_FALSE(label.box.empty());
    double x = 0.0;
    for (const Point2& p : label.box) x += p.x / static_cast<double>(label.box.size());
    if (std::abs(x - entered) < 1.0) ++stay;
  }
  EXPECT_GT(stay, 10u);
  EXPECT_LT(stay, 50u);
}

/// The parts list takes a corner in which it covers nothing; labels stay clear of it and of what
/// was entered with a place.
TEST(AnnotationPlacement, OfAPartsList) {
  const auto corner = [](std::string_view polygon) {
    GraphicsSystem g = replayed(
        fmt::format("open-segment 1\n{}\nset-annotation-placement auto\n"
                    "balloon-3 0 0 0 1 \"Shaft\"\nparts-list bottom-right\nclose-segment\n",
                    polygon));
    for (const AnnotationMark& mark :
         annotation_marks(g.display_file(), {512, 512, kPixelsOfMillimetre})) {
      if (mark.annotation != 1 || mark.kind != Kind::blank) continue;
      return std::pair(mark.points[0].x > 256, mark.points[0].y > 256);
    }
    return std::pair(false, false);
  };
  EXPECT_EQ(corner("polygon-abs-3 0 0 0  .1 0 0  .1 .1 0"), std::pair(true, false));
  EXPECT_EQ(corner("polygon-abs-3 0 0 0  1 0 0  1 -1 0  0 -1 0"), std::pair(false, false));
  EXPECT_EQ(corner("polygon-abs-3 -1 0 0  1 0 0  1 -1 0  -1 -1 0"), std::pair(true, true));
}

}  // namespace
}  // namespace displayfile
