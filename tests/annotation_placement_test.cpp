// Annotation placed automatically: over generated assemblies no leaders cross, and no text covers
// the figure or another text.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <string_view>
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

/// True if a side of either convex polygon separates them.
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

/// The drawing of one annotation.
struct Drawn {
  std::vector<std::pair<Point2, Point2>> leader;  // one line, or none
  Polygon box;                                    // of its text, or of its circle
  Polygon arrows;  // of a dimension: the parts outside the figure, in a hull
  Polygon number;  // of a dimension
  std::vector<std::pair<Point2, Point2>> lines;  // of a dimension
};

struct Assembly {
  GraphicsSystem system;
  AnnotationPage page;
  std::size_t labels = 0, dimensions = 0;
  std::vector<bool> number_alone = {};  // per dimension: its arrows are at the figure
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
  g.set_annotation_style(
      {.ends = seed % 2 == 0 ? AnnotationStyle::Ends::arrow : AnnotationStyle::Ends::dot,
       .placement = placement});
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
  const auto dimension = [&](const Annotation& one, bool number_alone) {
    g.annotate(one);
    result.number_alone.push_back(number_alone);
    ++result.dimensions;
  };
  // A plate, whose edges are measured on the side of the eye, as draughtsmen do.
  box_3(g, {-1.1, -1.1, -1.15}, {1.1, 1.1, -1.05});
  const auto near = [&](double x, double y, double z) {
    return Point3(std::copysign(x, x * eye.x), std::copysign(y, y * eye.y), z);
  };
  constexpr double kTop = -1.05, kBoss = -0.95;
  if (seed % 5 < 2) {
    for (const double x : {-1.1, -0.3}) {
      dimension(LinearDimension{LinearDimension::Axis::x, near(1.1, 1.1, kTop), near(x, 1.1, kTop),
                                near(0, 0.2, 0)},
                false);
    }
  }
  if (seed % 5 == 2 || seed % 5 == 4) {
    cylinder_3(g, near(0.6, 0.6, kTop), 0.4, 0.1, 12);
    dimension(DiameterDimension{near(0.2, 0.6, kBoss), near(1.0, 0.6, kBoss)}, true);
    dimension(RadiusDimension{near(0.6, 0.6, kBoss), near(0.6, 1.0, kBoss)}, true);
  }
  if (seed % 5 == 3 || seed % 5 == 4) {
    dimension(
        AngleDimension{near(1.1, 1.1, kTop), near(-1.1, 1.1, kTop), near(1.1, -1.1, kTop), 0.3},
        false);
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
    } else if (!is_label && mark.kind == Kind::line) {
      for (std::size_t i = 1; i < points.size(); ++i) {
        of.lines.emplace_back(points[i - 1], points[i]);
      }
    } else if (!is_label) {
      const bool is_number = mark.kind == Kind::text;
      if (is_number) of.number.insert(of.number.end(), points.begin(), points.end());
      if (!is_number && a.number_alone[mark.annotation - a.labels]) continue;
      of.arrows.insert(of.arrows.end(), points.begin(), points.end());
    }
  }
  for (Drawn& of : all) {
    if (!of.number.empty()) of.number = hull_of(of.number);
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

/// Faults of one picture: leaders that cross each other or dimensions, texts over the figure, over
/// each other or in a leader's way, anything outside of the picture.
std::vector<std::string> faults_of(const Assembly& a) {
  const std::vector<Drawn> all = drawn(a);
  const Polygon figure = figure_of(a);
  const auto is_inside = [&](const Polygon& polygon) {
    return std::ranges::all_of(polygon, [&](const Point2& p) {
      return p.x >= 0.0 && p.x <= a.page.width && p.y >= 0.0 && p.y <= a.page.height;
    });
  };
  std::vector<std::string> faults;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto fault = [&](bool is_one, std::string_view what, std::size_t j) {
      if (is_one) faults.push_back(fmt::format("{} {} {}", i, what, j));
    };
    const Polygon& own = all[i].box.empty() ? all[i].arrows : all[i].box;
    if (own.empty()) continue;
    fault(!apart(own, figure), "is over the figure", i);
    fault(!is_inside(own), "is not in the picture", i);
    for (std::size_t j = 0; j < all.size(); ++j) {
      const Polygon& other = all[j].box.empty() ? all[j].arrows : all[j].box;
      if (i == j || other.empty()) continue;
      fault(j < i && !apart(own, other), "covers", j);
      if (all[i].leader.empty()) continue;
      const auto& leader = all[i].leader[0];
      const Polygon& text = all[j].box.empty() ? all[j].number : all[j].box;
      fault(!text.empty() && !apart({leader.first, leader.second}, text),
            "has a leader over the text of", j);
      fault(std::ranges::any_of(all[j].lines,
                                [&](const auto& line) {
                                  return cross_each_other(leader.first, leader.second, line.first,
                                                          line.second);
                                }),
            "has a leader across dimension", j);
      if (j < i && !all[j].leader.empty()) {
        const auto& [from_other, to_other] = all[j].leader[0];
        fault(cross_each_other(leader.first, leader.second, from_other, to_other),
              "has a leader across that of", j);
      }
    }
  }
  return faults;
}

TEST(AnnotationPlacement, FiftyAssembliesHaveNoFault) {
  std::size_t as_entered = 0;
  std::size_t leaders = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Assembly a = assembly(seed);
    EXPECT_EQ(fmt::format("{}", fmt::join(faults_of(a), "; ")), "") << "seed " << seed;
    EXPECT_TRUE(annotation_faults(a.system.display_file(), a.page).empty());
    for (const Drawn& label : drawn(a)) leaders += label.leader.size();
    as_entered += faults_of(assembly(seed, AnnotationStyle::Placement::entered)).size();
  }
  EXPECT_GT(leaders, 300u);
  EXPECT_GT(as_entered, 500u);  // the test sees faults
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
  EXPECT_TRUE(faults_of(a).empty());
  const std::vector<Drawn> all = drawn(a);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(all[i].box[0].y > 256, i < 2);
  // A balloon's line ends at the point of the circle that is nearest to the figure.
  for (const std::size_t i : {2u, 3u}) {
    const auto [low, high] = std::ranges::minmax(all[i].box, {}, &Point2::y);
    EXPECT_NEAR(glm::distance(all[i].leader[0].first, high), 0.0, 1e-6) << low.y;
  }
}

/// Labels without a free cell stay where they were entered.
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

/// The parts list takes a corner in which it covers nothing; labels stay clear of it and of
/// annotation entered with a place.
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

/// Where other annotation is in all corners, a parts list stands beside the figure; where there is
/// no room at all it is named.
TEST(AnnotationPlacement, APartsListBesideTheFigure) {
  const auto list_of = [](std::string_view polygon, std::string_view others) {
    return replayed(
        fmt::format("open-segment 1\n{}\n{}\nset-annotation-placement auto\n"
                    "balloon-3 0 0 0 1 \"Shaft\"\nparts-list bottom-right\nclose-segment\n",
                    polygon, others));
  };
  constexpr AnnotationPage kPage{512, 512, kPixelsOfMillimetre};
  const GraphicsSystem beside = list_of("polygon-abs-3 -1 -.8 0  0 -.8 0  0 .8 0  -1 .8 0",
                                        "leader-3 -0.2 0 0 \"low corner\" 14 -64\n"
                                        "leader-3 -0.2 0 0 \"high corner\" 14 62");
  Polygon list;
  for (const AnnotationMark& mark : annotation_marks(beside.display_file(), kPage)) {
    if (mark.kind == Kind::blank && mark.points.size() == 4) list = mark.points;
  }
  ASSERT_EQ(list.size(), 4u);
  EXPECT_GT(list[0].x, 256.0);
  EXPECT_LT(list[1].x, 512.0);
  EXPECT_LT(list[0].y, 480.0);
  EXPECT_GT(list[2].y, 25.0);
  const GraphicsSystem full = list_of("polygon-abs-3 -1 -1 0  1 -1 0  1 1 0  -1 1 0", "");
  EXPECT_EQ(annotation_faults(full.display_file(), kPage),
            std::vector<std::string>{
                "annotation placement auto has no room for balloon 1, the parts list, which may "
                "cover the figure: expected larger paper, a larger window or a smaller scale"});
}

/// The number of a radius and of a diameter stands on its line, beyond the figure; an arc is
/// larger, or between the opposite directions.
TEST(AnnotationPlacement, NumbersStandOutsideOfTheFigure) {
  const auto marks_of = [](std::string_view routine) {
    const GraphicsSystem g = replayed(
        fmt::format("open-segment 1\npolygon-abs-3 -.5 -.5 0  .5 -.5 0  .5 .5 0  -.5 .5 0\n"
                    "set-annotation-placement auto\n{}\nclose-segment\n",
                    routine));
    return annotation_marks(g.display_file(), {512, 512, kPixelsOfMillimetre});
  };
  const auto number_of = [](std::span<const AnnotationMark> marks) {
    const auto text = std::ranges::find(marks, Kind::text, &AnnotationMark::kind);
    return 512.0 * Point2(text->text.anchor);
  };
  const auto radius = marks_of("radius-dimension-3 0 0 0  .3 0 0");
  EXPECT_GT(number_of(radius).x, 384.0);
  EXPECT_NEAR(number_of(radius).y, 256.0, 20.0);
  const auto left = marks_of("diameter-dimension-3 -.4 0 0  0 0 0");
  EXPECT_LT(number_of(left).x, 128.0);
  EXPECT_NEAR(number_of(left).y, 256.0, 20.0);
  EXPECT_EQ(std::ranges::count(left, Kind::area, &AnnotationMark::kind), 2);
  const auto right = marks_of("diameter-dimension-3 .4 0 0  0 0 0");
  EXPECT_GT(number_of(right).x, 384.0);
  const auto opposite = marks_of("angle-dimension-3 -.5 -.5 0  .5 -.5 0  -.5 .5 0  .2");
  EXPECT_LT(number_of(opposite).x, 128.0);
  EXPECT_LT(number_of(opposite).y, 128.0);
  // Extension lines begin at the vertex.
  const auto from_vertex = std::ranges::count_if(opposite, [](const AnnotationMark& mark) {
    return mark.kind == Kind::line && mark.points.size() == 2 &&
           glm::distance(mark.points[0], {128, 128}) < 10.0;
  });
  EXPECT_EQ(from_vertex, 2);
  const auto larger = marks_of("angle-dimension-3 0 0 0  .5 -.5 0  .5 .5 0  .1");
  EXPECT_GT(number_of(larger).x, 384.0);
}

/// Labels keep to the side that no dimension is on.
TEST(AnnotationPlacement, LeadersDoNotCrossDimensions) {
  std::string program =
      "open-segment 1\npolygon-abs-3 -.4 -.4 0  .4 -.4 0  .4 .4 0  -.4 .4 0\n"
      "set-annotation-placement auto\nlinear-dimension-3 y  -.4 -.4 0  -.4 .4 0  -.2 0 0\n";
  for (const double y : {-0.3, -0.1, 0.1, 0.3}) {
    program += fmt::format("balloon-3 -.35 {} 0 1\n", y);
  }
  const GraphicsSystem g = replayed(program + "close-segment\n");
  std::size_t circles = 0;
  for (const AnnotationMark& mark :
       annotation_marks(g.display_file(), {512, 512, kPixelsOfMillimetre})) {
    if (mark.kind != Kind::blank) continue;
    ++circles;
    EXPECT_GT(mark.points[0].x, 140.0);
  }
  EXPECT_EQ(circles, 4u);
}

}  // namespace
}  // namespace displayfile
