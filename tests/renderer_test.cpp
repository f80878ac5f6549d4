// The data that a Renderer keeps between pictures change none of them: whatever it drew before,
// each is that of a new one; with the counts of the data that it made.

#include "interp/draw/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "programs/scenes/generated_scenes.h"
#include "tests/error_of.h"
#include "tests/retained_truth.h"

namespace displayfile {
namespace {

using test::error_of;
using test::Retained;

constexpr HiddenMethod kInView[]{HiddenMethod::z_buffer,       HiddenMethod::scan_line,
                                 HiddenMethod::franklin,       HiddenMethod::bsp,
                                 HiddenMethod::world_ray_cast, HiddenMethod::depth_sort};

DrawOptions options_of(HiddenMethod method) {
  DrawOptions options{.width = 60, .height = 50, .samples = 1};
  options.surfaces.method = method;
  options.with_ids = !finds_lines(method);
  return options;
}

/// A generated scene with shadows, and a triangle with its outline.
void enter_scene(GraphicsSystem& g, const char* name, std::uint64_t seed) {
  g.set_light({0.4, 0.9, 0.6}, 0.3);
  g.set_shadows(true);
  enter(generated_scene(name).make(24, seed), g);
  g.set_line_style({LineStyle::Kind::solid, {0, 0, 0}});
  const double at = 0.1 * static_cast<double>(seed);
  g.open_segment(60);
  g.polygon_abs_3({{at - 1, -1, 0.85}, {at + 1, -1, 0.85}, {at, 1, 0.85}});
  g.close_segment();
}

void expect_same(const Picture& drawn, const Picture& anew) {
  EXPECT_EQ(drawn.pixels, anew.pixels);
  EXPECT_EQ(drawn.ids, anew.ids);
}

bool differ(const Picture& a, const Picture& b) { return a.pixels != b.pixels; }

TEST(RendererKeeps, NothingOfOneSceneForAnother) {
  Retained one, other;
  enter_scene(one.system, "soup", 3);
  enter_scene(other.system, "soup", 5);
  Renderer renderer;
  for (const HiddenMethod method : kInView) {
    SCOPED_TRACE(name_of(method));
    const DrawOptions options = options_of(method);
    std::vector<Picture> anew;
    for (const Retained* retained : {&one, &other}) {
      const InView in{retained->scene, retained->system.display_file(), retained->system.view()};
      anew.push_back(Renderer().draw(in, options));
    }
    EXPECT_TRUE(differ(anew[0], anew[1]));
    for (const int which : {0, 1, 0, 0, 1}) {
      const Retained& retained = which == 0 ? one : other;
      const InView in{retained.scene, retained.system.display_file(), retained.system.view()};
      expect_same(renderer.draw(in, options), anew[static_cast<std::size_t>(which)]);
    }
  }
}

/// The visibility of segments is that of the given display file, not of the scene.
TEST(RendererKeeps, NothingOfOneDisplayFileForAnother) {
  Retained retained;
  enter_scene(retained.system, "soup", 3);
  GraphicsSystem& g = retained.system;
  g.open_segment(70);
  g.polygon_abs_3({{-1, -1, 0.9}, {1, -1, 0.9}, {0, 1, 0.9}});
  g.close_segment();
  const View view = g.view();
  const DisplayFile all = g.display_file();
  DisplayFile some = all;
  some.segment(70).visible = false;
  Renderer renderer;
  for (const HiddenMethod method : kInView) {
    SCOPED_TRACE(name_of(method));
    const DrawOptions options = options_of(method);
    const Picture of_all = Renderer().draw(InView{retained.scene, all, view}, options);
    const Picture of_some = Renderer().draw(InView{retained.scene, some, view}, options);
    EXPECT_TRUE(differ(of_all, of_some));
    for (const bool whole : {true, false, true}) {
      const DisplayFile& file = whole ? all : some;
      expect_same(renderer.draw(InView{retained.scene, file, view}, options),
                  whole ? of_all : of_some);
    }
  }
}

/// Nor data of a deleted scene, where another has its place in memory.
TEST(RendererKeeps, NothingOfASceneThatIsGone) {
  Renderer renderer;
  for (const HiddenMethod method : kInView) {
    SCOPED_TRACE(name_of(method));
    const DrawOptions options = options_of(method);
    std::optional<Retained> retained;
    const RetainedScene* before = nullptr;
    for (const char* name : {"soup", "city", "terrain"}) {
      retained.emplace();
      enter_scene(retained->system, name, 3);
      EXPECT_TRUE(before == nullptr || before == &retained->scene);
      before = &retained->scene;
      const InView in{retained->scene, retained->system.display_file(), retained->system.view()};
      expect_same(renderer.draw(in, options), Renderer().draw(in, options));
    }
  }
}

/// A kept tree is valid for one plan.
TEST(RendererKeeps, TreesForOnePlanAlone) {
  Retained retained;
  enter_scene(retained.system, "soup", 3);
  const InView in{retained.scene, retained.system.display_file(), retained.system.view()};
  std::vector<DrawOptions> plans(4, options_of(HiddenMethod::bsp));
  plans[1].surfaces.scope = HiddenScope::segment;
  plans[2].surfaces.root = RootChoice::last;
  plans[3].surfaces.precision = Precision{.exact = false, .roundoff = 1e-3};
  Renderer renderer;
  std::vector<std::uint64_t> pieces;
  for (const std::size_t k : {0u, 1u, 0u, 2u, 0u, 3u, 0u, 1u, 2u, 3u}) {
    SCOPED_TRACE(k);
    Renderer anew;
    expect_same(renderer.draw(in, plans[k]), anew.draw(in, plans[k]));
    const Renderer::Trees kept = renderer.trees(), made = anew.trees();
    EXPECT_EQ(kept.sorted, made.sorted);
    EXPECT_EQ(kept.pieces, made.pieces);
    EXPECT_EQ(kept.cuts, made.cuts);
    EXPECT_EQ(kept.comparisons, made.comparisons);
    EXPECT_EQ(kept.depth, made.depth);
    pieces.push_back(made.pieces);
  }
  EXPECT_NE(pieces[0], pieces[3]);  // another root, other pieces
  // The same plan again: the same tree, walked once more or not at all.
  const Renderer::Trees before = renderer.trees();
  renderer.draw(in, plans[3]);
  EXPECT_EQ(renderer.trees().walks + renderer.trees().reused, before.walks + before.reused + 1);
}

TEST(RendererKeeps, WhatCastsShadowsWhileTheSceneStays) {
  Retained one, other;
  enter_scene(one.system, "soup", 3);
  enter_scene(other.system, "city", 5);
  const DrawOptions options = options_of(HiddenMethod::z_buffer);
  const auto in = [](const Retained& retained) {
    return InView{retained.scene, retained.system.display_file(), retained.system.view()};
  };
  Renderer renderer;
  renderer.draw(in(one), options);
  const std::size_t lists = renderer.made().caster_lists;
  EXPECT_EQ(renderer.made().caster_trees, 1u);
  EXPECT_GT(lists, 0u);
  EXPECT_GT(renderer.bytes_of_casters(), 0u);
  renderer.draw(in(one), options);
  EXPECT_EQ(renderer.made().caster_trees, 1u);
  EXPECT_EQ(renderer.made().caster_lists, lists);
  renderer.draw(in(other), options);
  EXPECT_EQ(renderer.made().caster_trees, 2u);
  const std::size_t more = renderer.made().caster_lists;
  EXPECT_GT(more, lists);  // of both, though those of the first are gone
  renderer.draw(in(one), options);
  EXPECT_EQ(renderer.made().caster_trees, 3u);
  EXPECT_EQ(renderer.made().caster_lists, more + lists);
  // An edited scene has others, too.
  one.system.open_segment(70);
  one.system.polygon_abs_3({{-1, -1, 0.9}, {1, -1, 0.9}, {0, 1, 0.9}});
  one.system.close_segment();
  expect_same(renderer.draw(in(one), options), Renderer().draw(in(one), options));
  EXPECT_EQ(renderer.made().caster_trees, 4u);
}

std::optional<std::int32_t> id_of(const std::optional<Pick>& pick) {
  return pick ? std::optional(pick->id) : std::nullopt;
}

/// Pictures of several sizes and of a scene that changes, by one tree of boxes each.
TEST(RendererKeeps, ATreeToPickByForOneSizeAndDisplayFile) {
  GraphicsSystem g;
  enter(generated_scene("soup").make(24, 3), g);
  Renderer renderer;
  int seen = 0;
  for (int round = 0; round < 4; ++round) {
    for (const int size : {40, 90, 40}) {
      DrawOptions options{.width = size, .height = size, .samples = 1};
      for (int k = 0; k < 25; ++k) {
        const double x = (k % 5 + 0.5) * size / 5.0, y = (k / 5 + 0.5) * size / 5.0;
        const auto kept = renderer.pick(g, x, y, options), anew = Renderer().pick(g, x, y, options);
        ASSERT_EQ(id_of(kept), id_of(anew)) << round << ' ' << size << ' ' << x << ' ' << y;
        seen += anew ? 1 : 0;
      }
    }
    g.open_segment(80 + round);  // in front of a part of the scene
    const double at = -1.0 + 0.5 * round;
    g.polygon_abs_3({{at, -1, 0.99}, {at + 0.5, -1, 0.99}, {at + 0.5, 1, 0.99}, {at, 1, 0.99}});
    g.close_segment();
  }
  EXPECT_GT(seen, 100);
  // A picture that cannot be drawn has no picks.
  DrawOptions none{.width = 0, .height = 40};
  EXPECT_NE(error_of([&] { renderer.pick(g, 1, 1, none); }), "");
}

TEST(RendererKeeps, NoPictureWhereDrawingFails) {
  Retained retained;
  enter_scene(retained.system, "soup", 3);
  const InView in{retained.scene, retained.system.display_file(), retained.system.view()};
  Renderer renderer;
  const DrawOptions options = options_of(HiddenMethod::z_buffer);
  const Picture drawn = renderer.draw(in, options);
  DrawOptions limited = options_of(HiddenMethod::depth_sort);
  WorkBudget spent;
  spent.stop();
  limited.surfaces.budget = &spent;
  EXPECT_NE(error_of([&] { renderer.draw(in, limited); }), "");
  EXPECT_TRUE(renderer.take_picture().pixels.empty());
  expect_same(renderer.draw(in, options), drawn);
  EXPECT_NE(error_of([&] { renderer.draw(retained.system, limited); }), "");
  EXPECT_TRUE(renderer.take_picture().pixels.empty());
  Picture taken = (renderer.draw(in, options), renderer.take_picture());
  expect_same(taken, drawn);
  EXPECT_TRUE(renderer.take_picture().pixels.empty());
  renderer.give_back(std::move(taken));
  expect_same(renderer.take_picture(), drawn);
}

}  // namespace
}  // namespace displayfile
