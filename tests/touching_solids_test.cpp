// Combined solids whose parts touch in points, along edges and in faces.

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/base/work_budget.h"
#include "displayfile/graphics_system.h"
#include "displayfile/solids/combining_steps.h"
#include "tests/error_of.h"
#include "tests/from_environment.h"
#include "tests/predicate_inputs.h"
#include "tests/random_views.h"
#include "tests/slower.h"
#include "tests/solid_scenes.h"
#include "tests/solid_truth.h"

namespace displayfile {
namespace {

using test::Entered;
using test::EnterSolid;
using test::from_environment;
using test::is_closed;
using test::Ray;
using test::SolidTree;
using test::Source;
using test::volume;

constexpr auto kUnion = SolidOperation::unite;
constexpr auto kIntersection = SolidOperation::intersect;
constexpr auto kDifference = SolidOperation::difference;

TEST(TouchingSolids, WhatTakesTooManyStepsIsAnErrorThatNamesTheParts) {
  CountedSteps steps("the union with part 2 of 3 of the solid", 2);
  steps.step();
  steps.step();
  test::expect_error([&] { steps.step(); }, "the union with part 2 of 3 of the solid");
  test::expect_error([&] { steps.step(); }, "in 2 steps");
}

Ray any_ray(Source& s) {
  const Point3 through{3 * s.unit() - 1.5, 3 * s.unit() - 1.5, 3 * s.unit() - 1.5};
  const Point3 direction = test::any_direction(s);
  return {through - 8.0 * direction, direction};
}

/// The verdict on one solid.
struct Verdict {
  std::string wrong;     ///< nothing if all is right
  bool is_hit = false;   ///< by some ray
  bool touches = false;  ///< some side belongs to more than two polygons
};

bool touches_itself(const Mesh& mesh) {
  using Side = std::pair<std::tuple<double, double, double>, std::tuple<double, double, double>>;
  std::vector<Side> sides;
  const auto key = [](const Point3& p) { return std::tuple(p.x, p.y, p.z); };
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const auto polygon = test::corners_of(mesh, i);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      sides.emplace_back(key(polygon[k]), key(polygon[(k + 1) % polygon.size()]));
    }
  }
  std::ranges::sort(sides);
  return std::ranges::adjacent_find(sides) != sides.end();
}

Verdict judge(const SolidTree& tree, Source& s, int rays) {
  const Mesh mesh = Entered([&](GraphicsSystem& g) { tree.enter(g); }).mesh();
  Verdict verdict;
  if (!is_closed(mesh)) verdict.wrong = "is not closed";
  verdict.touches = touches_itself(mesh);
  int decided = 0;
  for (int k = 0; k < 40 * rays && decided < rays && verdict.wrong.empty(); ++k) {
    const Ray ray = any_ray(s);
    const auto wrong = test::wrong_along(tree, mesh, ray);
    if (!wrong) continue;
    ++decided;
    verdict.wrong = *wrong;
    verdict.is_hit = verdict.is_hit || !test::true_depths(tree, ray)->empty();
  }
  if (verdict.wrong.empty() && decided < rays) verdict.wrong = "too few rays are decided";
  return verdict;
}

EnterSolid box(const Point3& low, const Point3& high) {
  return [=](GraphicsSystem& g) { box_3(g, low, high); };
}
EnterSolid wedge(const Point3& low, const Point3& high) {
  return [=](GraphicsSystem& g) { wedge_3(g, low, high); };
}
EnterSolid prism(const Point3& base, double radius, double height, int sides) {
  return [=](GraphicsSystem& g) { prism_3(g, base, radius, height, sides); };
}

void expect_right(const SolidTree& tree) {
  Source s(1);
  const Verdict verdict = judge(tree, s, 300);
  EXPECT_EQ(verdict.wrong, "");
  EXPECT_TRUE(verdict.is_hit);
}

double volume_of(const SolidTree& tree) {
  const Mesh mesh = Entered([&](GraphicsSystem& g) { tree.enter(g); }).mesh();
  EXPECT_TRUE(is_closed(mesh));
  return mesh.faces() == 0 ? 0.0 : volume(mesh);
}

// ---- Two that ended the process -----------------------------------------------------------------

TEST(TouchingSolids, InAPointAndTakenFromAgain) {
  const SolidTree tree(kDifference, {SolidTree(prism({0, 0, 0}, 1, 1, 4)),
                                     SolidTree(wedge({0.5, -0.5, 0.25}, {1, 0.5, 2})),
                                     SolidTree(box({2, 2, 2}, {3, 3, 3}))});
  EXPECT_NEAR(volume_of(tree), 2.0 - 69.0 / 392.0, 1e-12);
  expect_right(tree);
}

TEST(TouchingSolids, InAPointWithinOthersEnds) {
  const auto ball = [](GraphicsSystem& g) {
    g.save_transformation_3();
    g.rotate_y_3(90);
    sphere_3(g, {1, 1, -0.5}, 0.75, 4);
    g.restore_transformation_3();
  };
  const SolidTree both(kUnion,
                       {SolidTree(wedge({-0.5, -0.5, -1}, {0.25, 0.75, 0.75})), SolidTree(ball)});
  const SolidTree tree(
      kDifference, {SolidTree(box({-0.5, -0.5, -1}, {0.5, 0.5, 0.25})),
                    SolidTree(kDifference, {both, SolidTree(prism({-1, 0.5, -1}, 0.75, 0.5, 3))})});
  expect_right(tree);
}

// ---- Each way to touch --------------------------------------------------------------------------

TEST(TouchingSolids, AlongAnEdgeTheyAreOneSolid) {
  const SolidTree both(
      kUnion, {SolidTree(box({0, 0, 0}, {1, 1, 1})), SolidTree(box({1, 1, 0}, {2, 2, 1}))});
  EXPECT_EQ(volume_of(both), 2.0);
  expect_right(both);
  const SolidTree drilled(kDifference, {both, SolidTree(box({0.5, 0.5, 0.5}, {1.5, 1.5, 2}))});
  EXPECT_EQ(volume_of(drilled), 2.0 - 0.25);
  expect_right(drilled);
  const SolidTree filled(
      kUnion, {both, SolidTree(box({0, 1, 0}, {1, 2, 1})), SolidTree(box({1, 0, 0}, {2, 1, 1}))});
  EXPECT_EQ(volume_of(filled), 4.0);
  const Mesh mesh = Entered([&](GraphicsSystem& g) { filled.enter(g); }).mesh();
  EXPECT_FALSE(touches_itself(mesh));
  expect_right(filled);
}

TEST(TouchingSolids, TheEdgeIsDrawnWhereTheyTouch) {
  for (int turns = 0; turns < 8; ++turns) {
    const Entered entered([=](GraphicsSystem& g) {
      for (int k = 0; k < turns; ++k) k % 2 == 0 ? g.rotate_z_3(90) : g.rotate_x_3(90);
      g.begin_solid(kUnion);
      box_3(g, {0, 0, 0}, {1, 1, 1});
      box_3(g, {1, 1, 0}, {2, 2, 1});
      g.end_solid();
    });
    double drawn = 0.0;
    for (const std::uint32_t i : entered.polygons()) drawn += entered.drawn_length(i);
    EXPECT_DOUBLE_EQ(drawn, 2 * 2 * 12) << turns;  // each side of each box from both of its faces
  }
}

TEST(TouchingSolids, TheEdgeIsDrawnBetweenFacesInOnePlane) {
  const auto tent = [](GraphicsSystem& g, double x) {
    const std::array<Point2, 3> profile{{{x, 0}, {x + 1, 0}, {x + 0.5, 1}}};
    extrude_3(g, 0, 1, profile);
  };
  for (const double first : {0.0, 1.0}) {
    const Entered entered([=](GraphicsSystem& g) {
      g.begin_solid(kUnion);
      tent(g, first);
      tent(g, 1.0 - first);
      g.end_solid();
    });
    double drawn = 0.0;
    for (const std::uint32_t i : entered.polygons()) drawn += entered.drawn_length(i);
    EXPECT_NEAR(drawn, 2 * 2 * (2 * (1 + 2 * std::sqrt(1.25)) + 3), 1e-12);
  }
}

TEST(TouchingSolids, FacesThatOverlapInAnyWayAreCutAlike) {
  const SolidTree both(
      kUnion, {SolidTree(box({0, 0, 0}, {1, 1, 1})), SolidTree(box({1, 1, 0}, {2, 2, 1}))});
  for (int i = 0; i < 7; ++i) {
    for (int j = i; j < 7; ++j) {
      const Point3 at(0.25 * i, 0.25 * j, 0);
      for (const SolidTree& other :
           {SolidTree(prism(at, 0.5, 1, 4)), SolidTree(box(at, at + Point3(0.5, 0.75, 1))),
            SolidTree(prism(at, 0.5, 1, 8))}) {
        EXPECT_NEAR(volume_of(SolidTree(kUnion, {both, other})) +
                        volume_of(SolidTree(kIntersection, {both, other})),
                    2.0 + volume_of(other), 1e-12)
            << i << " " << j;
      }
    }
  }
}

TEST(TouchingSolids, FacesKeepTheColoursAndPickIdentifiersOfTheirParts) {
  const Entered entered([](GraphicsSystem& g) {
    g.begin_solid(kUnion);
    g.set_fill_style({.colour = {1, 0, 0}});
    g.set_pick_id(7);
    box_3(g, {0, 0, 0}, {1, 1, 1});
    g.set_fill_style({.colour = {0, 0, 1}});
    g.set_pick_id(9);
    box_3(g, {1, 1, 0}, {2, 2, 1});
    g.end_solid();
  });
  std::array<int, 2> faces{0, 0};
  for (const std::uint32_t i : entered.polygons()) {
    const Point3 middle = 0.5 * (entered.scene.points(i)[0] + entered.scene.points(i)[2]);
    const bool is_first = middle.x + middle.y < 2.0;
    EXPECT_EQ(entered.scene[i].pick, is_first ? 7 : 9);
    EXPECT_EQ(entered.scene.attributes(i).fill.colour.r, is_first ? 1.0 : 0.0);
    ++faces[is_first ? 0 : 1];
  }
  EXPECT_EQ(faces, (std::array{6, 6}));
}

TEST(TouchingSolids, InAPointFromInsideAndFromOutside) {
  const SolidTree cube(box({-1, -1, -1}, {1, 1, 1}));
  const auto tip = [](double to, int turns) {
    return SolidTree([=](GraphicsSystem& g) {
      g.save_transformation_3();
      for (int k = 0; k < turns; ++k) g.rotate_x_3(90);
      cone_3(g, {0, 0, to - 0.5}, 0.25, 0.5, 4);
      g.restore_transformation_3();
    });
  };
  for (const int turns : {0, 1, 2, 3}) {
    const SolidTree hollow(kDifference, {cube, tip(1, turns)});
    expect_right(hollow);
    expect_right(SolidTree(kDifference, {hollow, SolidTree(box({0, 0, 0}, {1, 1, 1}))}));
    expect_right(SolidTree(kUnion, {hollow, SolidTree(box({0, 0, 1}, {1, 1, 2})),
                                    SolidTree(box({-1, -1, 1}, {0, 0, 1.5}))}));
  }
}

TEST(TouchingSolids, CutOpenTheyAreClosed) {
  const auto half = [](double side) {
    return Entered([=](GraphicsSystem& g) {
             g.set_cutting_plane(1, side, 0.25 * side, 0.5 * side, 0.7 * side);
             g.set_cut_faces({CutFaces::Kind::closed});
             g.begin_solid(kUnion);
             box_3(g, {0, 0, 0}, {1, 1, 1});
             box_3(g, {1, 1, 0}, {2, 2, 1});
             box_3(g, {0, 1, 1}, {1, 2, 2});
             g.end_solid();
           })
        .mesh();
  };
  const Mesh one = half(1), other = half(-1);
  EXPECT_TRUE(is_closed(one));
  EXPECT_TRUE(is_closed(other));
  EXPECT_NEAR(volume(one) + volume(other), 3.0, 1e-12);
}

TEST(TouchingSolids, RaysAskTheBudget) {
  GraphicsSystem g;
  g.open_segment(1);
  g.begin_solid(kUnion);
  g.begin_solid(kUnion);
  box_3(g, {-2, -2, 0}, {0, 0, 1});
  box_3(g, {0, 0, 0}, {2, 2, 1});
  g.end_solid();
  sphere_3(g, {6, 0, 0}, 1, 48);  // whose triangles are near no other
  WorkBudget budget({.comparisons = 1});
  const BudgetInForce in_force(budget);
  EXPECT_THROW(g.end_solid(), LimitReached);
}

TEST(TouchingSolids, ABudgetEndsThemAndNothingIsLost) {
  for (const bool touching : {false, true}) {
    GraphicsSystem g;
    g.open_segment(1);
    g.begin_solid(kUnion);
    if (touching) {
      g.begin_solid(kUnion);
      box_3(g, {-2, -2, 0}, {0, 0, 1});
      box_3(g, {0, 0, 0}, {2, 2, 1});
      g.end_solid();
    }
    sphere_3(g, {0, 0, 0}, 1, 48);
    sphere_3(g, {0.5, 0.1, 0}, 1, 48);
    WorkBudget budget({.comparisons = 1});
    {
      const BudgetInForce in_force(budget);
      EXPECT_THROW(g.end_solid(), LimitReached);
    }
    EXPECT_EQ(g.counts().solids_open, 1u);
    g.end_solid();
    g.close_segment();
    EXPECT_GT(g.counts().polygons, 0);
  }
}

// ---- At random ----------------------------------------------------------------------------------

/// On a coarse grid, and turned by right angles: parts touch. Lists in braces are evaluated in
/// order, so that a seed is the same solid by every compiler.
SolidTree any_convex(Source& s) {
  const auto grid = [&](int low, int high) { return s.between(low, high) / 4.0; };
  const Point3 low{grid(-4, 1), grid(-4, 1), grid(-4, 1)};
  const Point3 size{grid(2, 6), grid(2, 6), grid(2, 6)};
  const double radius = grid(2, 4);
  const int kind = s.below(6), sides = s.between(3, 6);
  const int x = s.below(2), y = s.below(2), z = s.below(2);
  return SolidTree([=](GraphicsSystem& g) {
    g.save_transformation_3();
    if (x == 1) g.rotate_x_3(90);
    if (y == 1) g.rotate_y_3(90);
    if (z == 1) g.rotate_z_3(90);
    const Point3 middle = low + 0.5;
    if (kind == 0) box_3(g, low, low + size);
    if (kind == 1) wedge_3(g, low, low + size);
    if (kind == 2) prism_3(g, middle, radius, size.z, sides);
    if (kind == 3) cylinder_3(g, middle, radius, size.z, 8);
    if (kind == 4) cone_3(g, middle, radius, size.z, sides);
    if (kind == 5) sphere_3(g, middle, radius, 4);
    g.restore_transformation_3();
  });
}

SolidTree any_tree(Source& s, int depth) {
  if (depth == 0) return any_convex(s);
  const SolidOperation operation =
      std::array{kUnion, kIntersection, kDifference}[static_cast<std::size_t>(s.below(3))];
  const int parts = s.between(2, 3), deepest = s.below(parts);
  std::vector<SolidTree> all;
  for (int k = 0; k < parts; ++k) {
    const int depth_of_part = k == deepest ? depth - 1 : s.below(3) == 0 ? s.below(depth) : 0;
    all.push_back(any_tree(s, depth_of_part));
  }
  return {operation, std::move(all)};
}

/// The results so far of a separate process.
struct Found {
  int seed = 0, answers = 0, errors = 0, wrong = 0, hit = 0, touching = 0;
  char first_wrong[400] = "";

  void add(const Found& other) {
    answers += other.answers;
    errors += other.errors;
    wrong += other.wrong;
    hit += other.hit;
    touching += other.touching;
  }
};

void judge_random(int seed, Found& found) {
  found.seed = seed;
  Source s(static_cast<std::uint64_t>(seed));
  const SolidTree tree = any_tree(s, 1 + seed % 5);
  try {
    const Verdict verdict = judge(tree, s, 8);
    ++found.answers;
    found.hit += verdict.is_hit ? 1 : 0;
    found.touching += verdict.touches ? 1 : 0;
    if (verdict.wrong.empty()) return;
    ++found.wrong;
    std::snprintf(found.first_wrong, sizeof found.first_wrong, "seed %d: %s", seed,
                  verdict.wrong.c_str());
  } catch (const Error&) {
    ++found.errors;
  }
}

/// Judges in a process of its own, which ends by a crash, or after kSecondsEach of processor time
/// in a loop without an end.
void judge_in_a_process(int first, int end, Found& found) {
  constexpr rlim_t kSecondsEach = 20;
  const pid_t process = fork();
  ASSERT_GE(process, 0);
  if (process == 0) {
    const rlim_t seconds = kSecondsEach * static_cast<rlim_t>((end - first) * test::kSlower);
    const rlimit time{seconds, seconds};
    setrlimit(RLIMIT_CPU, &time);
    try {
      for (int seed = first; seed < end; ++seed) judge_random(seed, found);
    } catch (const std::exception& error) {
      ++found.wrong;
      std::snprintf(found.first_wrong, sizeof found.first_wrong, "seed %d: %s", found.seed,
                    error.what());
    }
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(process, &status, 0), process);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
      << "the solid of seed " << found.seed << " ends the process, or does not end";
  EXPECT_EQ(found.wrong, 0) << found.first_wrong;
}

TEST(TouchingSolids, AtRandomEachDepthIsRight) {
  const int first = from_environment("DISPLAYFILE_FIRST_SOLID", 0);
  const int solids = from_environment("DISPLAYFILE_SOLIDS", 400 / test::kSlower);
  constexpr int kAtATime = 20;
  void* const shared =
      mmap(nullptr, sizeof(Found), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  Found all;
  for (int done = 0; done < solids; done += kAtATime) {
    auto* const found = new (shared) Found;
    judge_in_a_process(first + done, first + std::min(done + kAtATime, solids), *found);
    all.add(*found);
  }
  munmap(shared, sizeof(Found));
  std::printf("%d solids: %d answers, %d errors; %d are hit, %d touch themselves\n", solids,
              all.answers, all.errors, all.hit, all.touching);
  EXPECT_EQ(all.answers + all.errors, solids);
  EXPECT_GT(all.answers, 9 * solids / 10);
  EXPECT_GT(all.hit, solids / 3);
  EXPECT_GE(all.touching, solids / 100);  // none of the few of a sanitized test
}

}  // namespace
}  // namespace displayfile
