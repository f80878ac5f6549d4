#include "programs/scenes/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "brute_force_entered_truth.h"
#include "brute_force_truth.h"
#include "hard/methods.h"
#include "hard/right_picture.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "interp/visibility/plain_z_buffer.h"
#include "mesa_leaks.h"
#include "programs/scenes/generated_scenes.h"
#include "programs/scenes/random_scenes.h"
#include "tests/retained_truth.h"
#include "tests/slower.h"
#include "tests/without_entered.h"

// hard_table shows that the exact methods have no wrong pixel on these scenes.

namespace displayfile {
namespace {

/// One scene of a family, as a test's parameter.
struct Case {
  const HardCase* family;
  double severity;
};

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const HardCase& family : hard_cases()) {
    for (double severity : family.severities) cases.push_back({&family, severity});
  }
  return cases;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.family->name << ' ' << c.severity; }

std::string test_name(const ::testing::TestParamInfo<Case>& info) {
  return std::string(info.param.family->name) + "_" + std::to_string(info.index);
}

const Method& an_exact_method() {
  static const std::vector<Method> all = methods();
  return *std::ranges::find_if(all, &Method::exact);
}

class EveryHardCase : public ::testing::TestWithParam<Case> {
 protected:
  Scene make(std::uint64_t seed) const {
    const auto& [family, severity] = GetParam();
    return family->make(family->size, severity, seed);
  }
};

void expect_brute_force_of_display_file(const Scene& scene) {
  const DisplayFile file = test::without_entered(entered(scene).display_file());
  const Picture oracle = truth(file, 32, 32, true);
  const Picture naive = test::brute_force_truth(file, 32, 32);
  EXPECT_EQ(oracle.ids, naive.ids);
  EXPECT_EQ(oracle.depth, naive.depth);
}

EnteredTruth entered_truth_of(const test::Retained& retained, int size,
                              const std::optional<Touching>& touching = {}) {
  return entered_truth(retained.scene, retained.system.display_file(), size, size, true, touching);
}

/// Each polygon against each plane, in long numbers: the picture and the scene are smaller.
void expect_brute_force_of_what_was_entered(const Scene& scene) {
  constexpr int kSize = 7;
  test::Retained retained;
  enter(scene, retained.system);
  const EnteredTruth oracle = entered_truth_of(retained, kSize);
  const test::BruteForceEnteredTruth naive(retained.scene, retained.system.display_file(), kSize,
                                           kSize, scene.touching);
  EXPECT_EQ(oracle.touching, naive.touching());
  const Picture picture = naive.picture();
  EXPECT_EQ(oracle.picture.ids, picture.ids);
  EXPECT_EQ(oracle.picture.depth, picture.depth);
}

TEST_P(EveryHardCase, OracleAgreesWithBruteForce) {
  static test::Share share;
  if (!share.takes_next()) return;
  const auto& [family, severity] = GetParam();
  const Scene first = make(1);
  const auto is_viewed_anew = [](const Scene::Segment& segment) {
    return segment.view.has_value();
  };
  const bool viewing_rounds = first.view != unit_view() || !first.placements.empty() ||
                              std::ranges::any_of(first.segments, is_viewed_anew);
  const bool as_entered = family->judged_from == JudgedFrom::entered;
  if (as_entered || viewing_rounds) {
    expect_brute_force_of_what_was_entered(family->make(family->size / 3, severity, 1));
  }
  if (as_entered) return;
  for (std::uint64_t seed = 1; seed <= (test::kSlower > 1 ? 1 : 2); ++seed) {
    SCOPED_TRACE(seed);
    expect_brute_force_of_display_file(make(seed));
  }
}

TEST_P(EveryHardCase, SameSeedSameScene) {
  const Scene a = make(3), b = make(3);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.sides, b.sides);
  EXPECT_EQ(a.view, b.view);
}

INSTANTIATE_TEST_SUITE_P(HardCases, EveryHardCase, ::testing::ValuesIn(all_cases()), test_name);

TEST(HardCases, NamesAreDifferent) {
  std::set<std::string_view> names;
  for (const HardCase& family : hard_cases()) names.insert(family.name);
  EXPECT_EQ(names.size(), hard_cases().size());
  EXPECT_GE(names.size(), 40u);
}

/// Families that every method of today draws right: equal polygons round alike, and polygons that
/// are edge-on or have no area cover nothing, unless a method draws them.
constexpr std::array<std::string_view, 3> kDrawnRightByAll{"coplanar_copies", "edge_on",
                                                           "zero_area"};

// A suite whose pictures are empty, or that any method draws right, would judge nothing: in each
// other family some inexact method draws a pixel wrong.
TEST(HardCases, AreHard) {
  const auto all = methods();
  std::size_t painter_wrong = 0, float_wrong = 0;
  for (const HardCase& family : hard_cases()) {
    bool painter = false, single = false, any = false, empty = true;
    for (double severity : family.severities) {
      const Scene scene = family.make(family.size, severity, 1);
      const GraphicsSystem system = entered(scene);
      const Picture right = right_picture(scene, family.judged_from, 32);
      for (std::int32_t id : right.ids) empty = empty && id < 0;
      for (const Method& method : all) {
        const bool counted = method.column == "painter" || method.column == "float";
        if (method.exact || (any && !counted)) continue;
        const bool wrong = wrong_pixels(method.draw(system.display_file(), 32), right) > 0;
        any |= wrong;
        painter |= wrong && method.column == "painter";
        single |= wrong && method.column == "float";
      }
    }
    EXPECT_FALSE(empty) << family.name << ": no pixel of any severity shows a polygon";
    const bool known = std::ranges::find(kDrawnRightByAll, family.name) != kDrawnRightByAll.end();
    EXPECT_EQ(any, !known) << family.name << (known ? " is hard" : " has become easy");
    painter_wrong += painter;
    float_wrong += single;
  }
  EXPECT_GT(painter_wrong, hard_cases().size() / 2);
  EXPECT_GT(float_wrong, hard_cases().size() / 2);
}

/// The families of touching polygons, each scene as it was made.
template <class Judge>
void for_each_touching_scene(std::uint64_t seeds, const Judge& judge) {
  for (const HardCase& family : hard_cases()) {
    if (family.judged_from != JudgedFrom::entered) continue;
    for (const double severity : family.severities) {
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        SCOPED_TRACE(std::string(family.name) + " " + std::to_string(severity) + ", seed " +
                     std::to_string(seed));
        judge(family, family.make(family.size, severity, seed));
      }
    }
  }
}

/// No exact method has a wrong pixel where touching is automatic, as it is in every scene. The
/// first of them has some in every family if it has the display file alone: there rounding decides.
/// With touching off it has some where decals in decimals do not coincide.
TEST(TouchingFamilies, AreRightByEveryExactMethodAndNotWithoutTouching) {
  constexpr int kSize = 24;
  const std::vector<Method> all = methods();
  std::map<std::string_view, long long> wrong_when_off, wrong_as_viewed;
  test::Share share;
  for_each_touching_scene(1, [&](const HardCase& family, Scene scene) {
    const Picture right = right_picture(scene, family.judged_from, kSize);
    ASSERT_EQ(scene.touching, kUnlessSet);
    const GraphicsSystem system = entered(scene);
    for (const Method& method : all) {
      if (!method.exact || !share.takes_next()) continue;
      EXPECT_EQ(wrong_pixels(method.draw(system.display_file(), kSize), right), 0) << method.name;
    }
    const DisplayFile as_viewed = test::without_entered(system.display_file());
    wrong_as_viewed[family.name] += wrong_pixels(an_exact_method().draw(as_viewed, kSize), right);
    scene.touching = {Touching::Kind::off};
    wrong_when_off[family.name] +=
        wrong_pixels(an_exact_method().draw(entered(scene).display_file(), kSize), right);
  });
  EXPECT_EQ(wrong_as_viewed.size(), 11u);
  for (const auto& [family, pixels] : wrong_as_viewed) EXPECT_GT(pixels, 0) << family;
  EXPECT_GT(wrong_when_off["decals_on_slopes"], 0);
  EXPECT_EQ(wrong_when_off["rug_on_floor"], 0);
}

/// Polygons that are meant to touch lie within the default reach; a wider one finds no more.
TEST(TouchingFamilies, PolygonsLieInEachOthersPlanes) {
  for_each_touching_scene(2, [&](const HardCase&, const Scene& scene) {
    test::Retained retained;
    enter(scene, retained.system);
    const std::size_t touching = entered_truth_of(retained, 1).touching;
    EXPECT_GT(touching, scene.polygons() / 10);
    EXPECT_LT(touching, scene.polygons());
    const Touching wider{Touching::Kind::length, 1e-12};
    EXPECT_EQ(entered_truth_of(retained, 1, wider).touching, touching);
  });
}

/// Each generator makes views and placements as its family's words describe.
TEST(TouchingFamilies, ViewsAndPlacementsAreThoseOfTheSeverity) {
  for (const HardCase& family : hard_cases()) {
    if (family.judged_from != JudgedFrom::entered) continue;
    for (const double severity : family.severities) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(severity));
      const Scene scene = family.make(family.size, severity, 1);
      const bool perspective = scene.view.projection == View::Projection::perspective;
      EXPECT_EQ(perspective, severity == 1.0 || severity == 3.0);
      const auto is_turned = [](const Scene::Placement& placement) {
        return placement.degrees.x != 0.0 && placement.then_move != Point3(0.0);
      };
      EXPECT_EQ(std::ranges::any_of(scene.placements, is_turned), severity >= 2.0);
      EXPECT_NE(scene.view, family.make(family.size, severity, 2).view);
    }
  }
}

/// A scene enters its placements and views as described, and leaves no transformation behind.
TEST(Scenes, PolygonsAreMovedTurnedAndMovedAgain) {
  Scene scene;
  scene.add({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  scene.place({1, 0, 0}, {0, 0, 90}, {0, 0, 5});
  scene.add({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  scene.add({{2, 0, 0}, {3, 0, 0}, {2, 1, 0}});
  scene.place({0, 0, 1}, {90, 90, 0}, {0, 0, 0});
  View inset = unit_view();
  inset.set_viewport({0.5, 0.75, 0.5, 0.75});
  scene.open_segment(inset);
  scene.add({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  test::Retained retained;
  retained.system.translate_3(10, 0, 0);
  enter(scene, retained.system);
  const auto corner = [&](std::uint32_t polygon, std::size_t k) {
    return retained.scene.points(polygon)[k];
  };
  EXPECT_EQ(corner(0, 1), Point3(11, 0, 0));
  EXPECT_EQ(corner(1, 0), Point3(10, 1, 5));
  EXPECT_EQ(corner(1, 1), Point3(10, 2, 5));
  EXPECT_EQ(corner(1, 2), Point3(9, 1, 5));
  EXPECT_EQ(corner(2, 0), Point3(10, 3, 5));
  // (0, 0, 1) turns to (0, -1, 0) about x, and stays about y.
  EXPECT_EQ(corner(3, 0), Point3(10, -1, 0));
  ASSERT_EQ(retained.scene.segments().size(), 2u);
  EXPECT_EQ(retained.scene.segments()[0].view.viewport, (Rectangle{0, 1, 0, 1}));
  EXPECT_EQ(retained.scene.segments()[1].view.viewport, (Rectangle{0.5, 0.75, 0.5, 0.75}));
  retained.system.open_segment(3);
  retained.system.polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  retained.system.close_segment();
  EXPECT_EQ(corner(4, 0), Point3(10, 0, 0));
}

/// Centres on the bar's lower side are left undecided by the order of sorts. Coplanar polygons are
/// coplanar there too.
TEST(TouchingFamilies, AreRightAtCentresOnSidesOfOthers) {
  constexpr int kSize = 64;
  Scene scene;
  scene.touching = kUnlessSet;
  scene.view = View();
  scene.place(Point3(0.0), {33.3, 21.7, 0.0}, Point3(0.0));
  scene.add({{-0.8, -0.8, 0.1}, {0.8, -0.8, 0.1}, {0.8, 0.8, 0.1}, {-0.8, 0.8, 0.1}});
  scene.add({{-0.7, -0.61, 0.1}, {0.63, -0.6, 0.1}, {0.67, 0.7, 0.1}, {-0.6, 0.63, 0.1}});
  scene.place(Point3(0.0), Point3(0.0), Point3(0.0));
  const double side = 1.0 / kSize;
  scene.add({{-0.9, side, 0.9}, {0.9, side, 0.9}, {0.9, 0.06, 0.9}, {-0.9, 0.06, 0.9}});
  const Picture right = right_picture(scene, JudgedFrom::entered, kSize);
  EXPECT_GT(std::ranges::count(right.ids, 1), 1000);
  for (const bool in_segments : {false, true}) {
    if (in_segments) scene.segments.push_back({2, {}});
    const GraphicsSystem system = entered(scene);
    for (const Method& method : methods()) {
      if (!method.exact) continue;
      EXPECT_EQ(wrong_pixels(method.draw(system.display_file(), kSize), right), 0) << method.name;
    }
  }
}

TEST(HardCases, TenThousandSides) {
  const GraphicsSystem system = entered(hard_case("many_sides").make(10000, 0.3, 1));
  const Picture right = truth(system.display_file(), 32, 32, false);
  EXPECT_EQ(right.ids, test::brute_force_truth(system.display_file(), 32, 32).ids);
  EXPECT_EQ(wrong_pixels(an_exact_method().draw(system.display_file(), 32), right), 0);
}

TEST(RandomDegenerateScenes, OracleAgreesWithBruteForce) {
  for (std::uint64_t seed = 0; seed < 1000 / test::kSlower; ++seed) {
    const GraphicsSystem system = entered(random_degenerate_scene(seed));
    ASSERT_EQ(truth(system.display_file(), 32, 32, true).ids,
              test::brute_force_truth(system.display_file(), 32, 32).ids)
        << "seed " << seed;
  }
}

TEST(GeneratedScenes, HaveTheSizeAskedForAndAreSeen) {
  for (const GeneratedScene& scene : generated_scenes()) {
    for (std::size_t n : {12u, 1000u, 20000u}) {
      const Scene made = scene.make(n, 1);
      EXPECT_LE(made.polygons(), n) << scene.name;
      EXPECT_GE(2 * made.polygons(), n) << scene.name;
      EXPECT_NE(made.points, scene.make(n, 2).points) << scene.name;
    }
    const GraphicsSystem system = entered(scene.make(1000, 1));
    const Picture right = truth_as_entered(system.display_file(), 32, 32, false);
    long long seen = 0;
    for (std::int32_t id : right.ids) seen += id >= 0;
    EXPECT_GT(seen, 32 * 32 / 4) << scene.name;
    EXPECT_EQ(wrong_pixels(an_exact_method().draw(system.display_file(), 32), right), 0)
        << scene.name;
  }
}

GraphicsSystem two_sheets(double distance) {
  GraphicsSystem system;
  Scene scene;
  const double near = 0.5 + distance;
  scene.add({{0, 0, near}, {1, 0, near}, {1, 1, near}, {0, 1, near}});  // nearer, entered first
  scene.add({{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}});
  enter(scene, system);
  return system;
}

// Each depth format distinguishes sheets down to its own step, and not below it.
TEST(PlainZBuffer, DepthFormatsHaveTheirSteps) {
  const auto shows_the_near_one = [](DepthFormat format, double distance) {
    RasterRequest request;
    request.width = request.height = 4;
    request.ids = true;
    const GraphicsSystem system = two_sheets(distance);
    return draw_with_plain_z_buffer(system.display_file(), request, format).ids[5] == 0;
  };
  const std::pair<DepthFormat, double> steps[] = {{DepthFormat::float_64, 0x1p-53},
                                                  {DepthFormat::float_32, 0x1p-24},
                                                  {DepthFormat::integer_32, 0x1p-32},
                                                  {DepthFormat::integer_24, 0x1p-24},
                                                  {DepthFormat::integer_16, 0x1p-16}};
  for (const auto& [format, step] : steps) {
    EXPECT_TRUE(shows_the_near_one(format, 2.0 * step)) << static_cast<int>(format);
    EXPECT_FALSE(shows_the_near_one(format, 0.25 * step)) << static_cast<int>(format);
  }
}

/// As a method of pictures, under its names, it draws the same as by itself.
TEST(PlainZBuffer, IsAMethodOfPicturesAtEachDepthFormat) {
  const std::pair<const char*, DepthFormat> names[] = {
      {"plain-z-buffer", DepthFormat::float_32},
      {"plain-z-buffer=float", DepthFormat::float_32},
      {"plain-z-buffer=double", DepthFormat::float_64},
      {"plain-z-buffer=16", DepthFormat::integer_16},
      {"plain-z-buffer=24", DepthFormat::integer_24},
      {"plain-z-buffer=32", DepthFormat::integer_32}};
  const GraphicsSystem system = entered(generated_scene("planes").make(20, 5));
  // Too close for the coarsest format.
  const GraphicsSystem sheets = two_sheets(0x1p-18);
  for (const auto& [name, format] : names) {
    RasterRequest request;
    request.width = request.height = 64;
    request.ids = true;
    const Picture alone = draw_with_plain_z_buffer(system.display_file(), request, format);
    request.surfaces.method = hidden_method(name);
    request.surfaces.threads = 2;
    const Picture picture = draw_with_software(system.display_file(), request);
    EXPECT_EQ(picture.ids, alone.ids) << name;
    EXPECT_TRUE(is_image_space(request.surfaces.method)) << name;
    const bool wrong = draw_with_software(sheets.display_file(), request).ids[0] != 0;
    EXPECT_EQ(wrong, format == DepthFormat::integer_16) << name;
  }
}

/// `auto` picks among those that decide exactly.
TEST(PlainZBuffer, IsNotAmongTheExactMethods) {
  for (const ImageSpaceEntry& entry : image_space_methods()) {
    EXPECT_FALSE(name_of(entry.method).starts_with("plain")) << name_of(entry.method);
  }
}

TEST(PlainZBuffer, DrawsWhatIsTrueWhereNothingIsClose) {
  const GraphicsSystem system = entered(generated_scene("soup").make(60, 5));
  const Picture right = truth(system.display_file(), 64, 64, true);
  RasterRequest request;
  request.width = request.height = 64;
  request.ids = request.depth = true;
  const Picture plain =
      draw_with_plain_z_buffer(system.display_file(), request, DepthFormat::float_64);
  EXPECT_EQ(plain.ids, right.ids);
  for (std::size_t i = 0; i < right.depth.size(); ++i) {
    if (right.ids[i] >= 0) {
      EXPECT_NEAR(plain.depth[i], right.depth[i], 1e-9);
    }
  }
}

}  // namespace
}  // namespace displayfile
