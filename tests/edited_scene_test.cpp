// Objects that keep data of a retained scene, or of a display file, from picture to picture, while
// the application edits it: each picture equals that of a new object, or throws the same Error.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/views/retained_views.h"
#include "displayfile/views/turntable.h"
#include "interp/draw/other_eye.h"
#include "interp/draw/renderer.h"
#include "interp/draw/turntable_renderer.h"
#include "interp/draw/world_views.h"
#include "tests/error_of.h"
#include "tests/from_eyes.h"
#include "tests/retained_truth.h"

namespace displayfile {
namespace {

using test::FromEyes;

using test::error_of;
using test::Retained;

DrawOptions options_of(std::optional<HiddenMethod> method) {
  DrawOptions options{.width = 60, .height = 50, .samples = 1};
  options.surfaces.method = method;
  options.with_ids = !method || !finds_lines(*method);
  return options;
}

std::string bytes_of(const Picture& picture) {
  std::string bytes;
  for (const std::uint32_t pixel : picture.pixels) bytes += std::to_string(pixel) + ' ';
  for (const std::int32_t id : picture.ids) bytes += std::to_string(id) + ' ';
  return bytes;
}

/// The picture, or the reason why there is none.
template <class Draw>
std::string outcome(const Draw& draw) {
  std::string bytes;
  const std::string error = error_of([&] { bytes = bytes_of(draw()); });
  return error.empty() ? bytes : error;
}

/// One object that draws a scene from where it is looked at.
using Drawer = std::function<Picture(const View& view)>;
using MakeDrawer = Drawer (*)(const GraphicsSystem& system, const RetainedScene& scene);

template <class Object, class Draw>
Drawer drawer(std::shared_ptr<Object> object, const Draw& draw) {
  return [object, draw](const View& view) { return draw(*object, view); };
}

template <HiddenMethod method>
Drawer in_view(const GraphicsSystem& system, const RetainedScene& scene) {
  return drawer(
      std::make_shared<FromEyes>(scene, system.display_file()),
      [](FromEyes& renderer, const View& view) { return renderer.draw(view, options_of(method)); });
}

template <HiddenScope scope>
Drawer trees(const GraphicsSystem& system, const RetainedScene& retained) {
  return drawer(
      std::make_shared<RetainedViews>(retained, system.display_file(), SurfacePlan{.scope = scope}),
      [](RetainedViews& views, const View& view) {
        return draw(views.view(view), options_of(std::nullopt));
      });
}

Drawer rays(const GraphicsSystem& system, const RetainedScene& scene) {
  return drawer(std::make_shared<WorldViews>(scene, system.display_file()),
                [](WorldViews& views, const View& view) {
                  return draw(views.view(view), options_of(std::nullopt));
                });
}

template <HiddenMethod method>
Drawer turntable(const GraphicsSystem& system, const RetainedScene& scene) {
  const DrawOptions options =
      options_of(method == HiddenMethod::automatic ? std::nullopt : std::optional(method));
  return drawer(
      std::make_shared<TurntableRenderer>(system, scene, system.display_file(),
                                          TurntableViews{.number = 7, .fit_window = true}, options),
      [](TurntableRenderer& views, const View&) { return views.draw(2); });
}

template <HiddenMethod method>
Drawer renderer(const GraphicsSystem& system, const RetainedScene&) {
  return drawer(std::make_shared<Renderer>(), [&system](Renderer& renderer, const View&) {
    return renderer.draw(system, options_of(method));
  });
}

const std::map<std::string, MakeDrawer>& makers() {
  static const std::map<std::string, MakeDrawer> all{
      {"in a view, z-buffer", in_view<HiddenMethod::z_buffer>},
      {"in a view, scan line", in_view<HiddenMethod::scan_line>},
      {"in a view, lines", in_view<HiddenMethod::franklin>},
      {"in a view, bsp", in_view<HiddenMethod::bsp>},
      {"in a view, depth sort", in_view<HiddenMethod::depth_sort>},
      {"in a view, map", in_view<HiddenMethod::map>},
      {"one tree", trees<HiddenScope::all>},
      {"a tree of each segment", trees<HiddenScope::segment>},
      {"rays", rays},
      {"turntable, tree", turntable<HiddenMethod::automatic>},
      {"turntable, rays", turntable<HiddenMethod::world_ray_cast>},
      {"turntable, z-buffer", turntable<HiddenMethod::z_buffer>},
      {"renderer, z-buffer", renderer<HiddenMethod::z_buffer>},
      {"renderer, bsp", renderer<HiddenMethod::bsp>},
      {"renderer, lines", renderer<HiddenMethod::franklin>}};
  return all;
}

View look_at(const GraphicsSystem& system, const RetainedScene& scene) {
  return Turntable(scene, system.display_file(), system.view()).at(25.0).view;
}

std::string drawn_anew(MakeDrawer make, const GraphicsSystem& system, const RetainedScene& scene) {
  const View view = look_at(system, scene);
  return outcome([&] { return make(system, scene)(view); });
}

/// All kinds of objects, kept while the scene is edited.
class KeptObjects {
 public:
  KeptObjects(const GraphicsSystem& system, const RetainedScene& scene) {
    for (const auto& [name, make] : makers()) drawers_.emplace(name, make(system, scene));
    expect_as_anew(system, scene);
  }

  /// Draws the scene as it is now, twice: the second picture uses the data kept by the first.
  void expect_as_anew(const GraphicsSystem& system, const RetainedScene& scene) {
    const View view = look_at(system, scene);
    for (const auto& [name, make] : makers()) {
      SCOPED_TRACE(name);
      const std::string anew = drawn_anew(make, system, scene);
      for (int k = 0; k < 2; ++k) {
        EXPECT_TRUE(outcome([&, &own = drawers_.at(name)] { return own(view); }) == anew);
      }
      if (last_[name] != anew) ++changed_;
      last_[name] = anew;
    }
  }
  /// The number of pictures so far that differed from the one before.
  int changed() const { return changed_; }

 private:
  std::map<std::string, Drawer> drawers_;
  std::map<std::string, std::string> last_;
  int changed_ = 0;
};

void enter_triangle(GraphicsSystem& g, int name, double z) {
  g.open_segment(name);
  g.set_fill_style({FillStyle::Kind::solid, {0.1 * name, 0.5, 0.3}});
  g.polygon_abs_3({{-0.7, -0.6, z}, {0.8, -0.2, -z}, {0.1, 0.6, 0.4 * z}});
  g.close_segment();
}

/// A mesh whose polygons share vertices, with shadows on it.
void enter_mesh(GraphicsSystem& g, int name, double height) {
  const std::vector<Point3> vertices{
      {-0.4, -0.4, 0}, {0.4, -0.4, 0}, {0.4, 0.4, 0}, {-0.4, 0.4, 0}, {0, 0, height}};
  g.open_segment(name);
  g.set_shadows(true);
  g.polygons_abs_3({vertices, std::vector<std::uint32_t>{0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4}});
  g.set_shadows(false);
  g.close_segment();
}

struct Edit {
  std::string name;
  std::function<void(GraphicsSystem&)> carry_out;
};

/// In an order in which each finds the objects that it edits.
std::vector<Edit> edits() {
  return {
      {"another segment", [](GraphicsSystem& g) { enter_triangle(g, 6, 0.3); }},
      {"a mesh", [](GraphicsSystem& g) { enter_mesh(g, 8, 0.7); }},
      {"a segment deleted", [](GraphicsSystem& g) { g.delete_segment(2); }},
      {"renamed", [](GraphicsSystem& g) { g.rename_segment(6, 60); }},
      {"another one under the old name", [](GraphicsSystem& g) { enter_triangle(g, 6, -0.8); }},
      {"replaced by one of as many points",
       [](GraphicsSystem& g) {
         g.delete_segment(6);
         enter_triangle(g, 6, 0.9);
       }},
      {"not visible", [](GraphicsSystem& g) { g.set_visibility(8, false); }},
      {"visible again", [](GraphicsSystem& g) { g.set_visibility(8, true); }},
      {"one is open",
       [](GraphicsSystem& g) {
         g.open_segment(9);
         g.polygon_abs_3({{-0.9, 0, 0.6}, {0.9, 0, 0.6}, {0, 0.2, 0.6}});
       }},
      {"more in it",
       [](GraphicsSystem& g) {
         g.polygon_abs_3({{-0.9, 0, 0}, {0.9, 0, 0}, {0, -0.5, 0.9}});
       }},
      {"closed", [](GraphicsSystem& g) { g.close_segment(); }},
      {"lines selected",
       [](GraphicsSystem& g) {
         g.set_line_style({LineStyle::Kind::solid});
         g.set_hidden_surfaces({.lines = line_selection("outline")});
         enter_mesh(g, 10, -0.6);
       }},
      {"what fails",
       [](GraphicsSystem& g) {
         EXPECT_THROW(g.enter_segments([&] {
           enter_triangle(g, 11, 0.1);
           throw std::runtime_error("no");
         }),
                      std::runtime_error);
       }},
      {"all images moved",
       [](GraphicsSystem& g) {
         for (const int name : {4, 6, 8, 9, 10, 60}) g.set_image_translation(name, 0.1, 0.05);
       }},
      {"one of them moved on", [](GraphicsSystem& g) { g.set_image_rotation(8, 20.0); }},
      {"all deleted", [](GraphicsSystem& g) { g.delete_all_segments(); }},
      {"entered anew", [](GraphicsSystem& g) { test::enter_two_segments(g); }},
      {"the last one deleted", [](GraphicsSystem& g) { g.delete_segment(2); }},
      {"a mesh alone",
       [](GraphicsSystem& g) {
         g.delete_all_segments();
         enter_mesh(g, 1, 0.5);
       }},
  };
}

void carry_out_all(GraphicsSystem& system, const RetainedScene& scene) {
  test::enter_two_segments(system);
  KeptObjects kept(system, scene);
  for (const Edit& edit : edits()) {
    SCOPED_TRACE(edit.name);
    edit.carry_out(system);
    kept.expect_as_anew(system, scene);
  }
  EXPECT_GE(kept.changed(), 100);
}

TEST(EditedScene, WhatIsKeptDrawsTheSceneAsItIs) {
  Retained retained;
  carry_out_all(retained.system, retained.scene);
}

TEST(EditedScene, ASceneOfTheSystemsOwnIsFollowedToo) {
  GraphicsSystem system;
  system.retain();
  carry_out_all(system, *system.retained());
}

/// The picture is that of a system without these edits.
TEST(EditedScene, WhatIsTakenBackIsNotDrawn) {
  GraphicsSystem system;
  system.retain();
  test::enter_two_segments(system);
  KeptObjects kept(system, *system.retained());
  const int changed = kept.changed();
  EXPECT_THROW(system.all_or_nothing([&] {
    system.delete_segment(4);
    enter_mesh(system, 12, 0.5);
    throw std::runtime_error("no");
  }),
               std::runtime_error);
  kept.expect_as_anew(system, *system.retained());
  EXPECT_EQ(kept.changed(), changed);
  system.delete_segment(4);
  kept.expect_as_anew(system, *system.retained());
  EXPECT_GT(kept.changed(), changed);
}

/// Room for vertices that were not entered moves those that were.
TEST(EditedScene, WhatIsRefusedMovesNothing) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  enter_mesh(g, 1, 0.5);
  KeptObjects kept(g, retained.scene);
  const int changed = kept.changed();
  retained.scene.begin_shared(100000, 100000, 300000);
  kept.expect_as_anew(g, retained.scene);
  EXPECT_EQ(kept.changed(), changed);
}

constexpr HiddenMethod kInView[] = {HiddenMethod::z_buffer, HiddenMethod::bsp,
                                    HiddenMethod::world_ray_cast, HiddenMethod::franklin,
                                    HiddenMethod::map};

TEST(EditedScene, AMovedSystemIsFollowed) {
  auto first = std::make_unique<GraphicsSystem>();
  first->retain();
  test::enter_two_segments(*first);
  const DrawOptions options = options_of(std::nullopt);
  Renderer renderer;
  renderer.draw(in_view(*first, first->view()), options);
  RetainedViews views(*first->retained(), first->display_file(), {});
  const WorldViews world(*first->retained(), first->display_file());
  GraphicsSystem system(std::move(*first));
  first.reset();
  system.delete_segment(4);
  const View view = look_at(system, *system.retained());
  const RetainedScene& scene = *system.retained();
  const DisplayFile& file = system.display_file();
  EXPECT_EQ(bytes_of(renderer.draw(in_view(system, view), options)),
            bytes_of(Renderer().draw(in_view(system, view), options)));
  EXPECT_EQ(bytes_of(draw(views.view(view), options)),
            bytes_of(draw(RetainedViews(scene, file, {}).view(view), options)));
  EXPECT_EQ(bytes_of(draw(world.view(view), options)),
            bytes_of(draw(WorldViews(scene, file).view(view), options)));
}

/// Holders of a copy continue with it, and a renderer prepares for the next scene.
TEST(EditedScene, OfASceneThatIsGone) {
  Renderer renderer;
  std::optional<RetainedViews> views;
  std::optional<WorldViews> world;
  std::string tree_before, rays_before;
  const View view;
  const DrawOptions options = options_of(std::nullopt);
  {
    Retained retained;
    test::enter_two_segments(retained.system);
    const DisplayFile& file = retained.system.display_file();
    views.emplace(retained.scene, file);
    world.emplace(retained.scene, file);
    for (const auto method : kInView) {
      renderer.draw(InView{retained.scene, file, view}, options_of(method));
    }
    tree_before = bytes_of(draw(views->view(view), options));
    rays_before = bytes_of(draw(world->view(view), options));
  }
  Retained next;
  enter_triangle(next.system, 1, 0.3);
  const InView in{next.scene, next.system.display_file(), view};
  for (const auto method : kInView) {
    EXPECT_EQ(bytes_of(renderer.draw(in, options_of(method))),
              bytes_of(Renderer().draw(in, options_of(method))));
  }
  EXPECT_EQ(bytes_of(draw(views->view(view), options)), tree_before);
  EXPECT_EQ(bytes_of(draw(world->view(view), options)), rays_before);
}

TEST(EditedScene, CountsOfWhatIsKeptGoOn) {
  Retained retained;
  GraphicsSystem& g = retained.system;
  g.set_light({0.2, 0.3, 1.0});
  enter_mesh(g, 1, 0.5);
  FromEyes renderer(retained.scene, g.display_file());
  const DrawOptions options = options_of(HiddenMethod::z_buffer);
  renderer.draw(g.view(), options);
  const Renderer::Made before = renderer.made();
  EXPECT_EQ(before.caster_trees, 1u);
  renderer.draw(g.view(), options);
  EXPECT_EQ(renderer.made().caster_trees, 1u);
  enter_mesh(g, 2, 0.9);
  renderer.draw(g.view(), options);
  EXPECT_EQ(renderer.made().caster_trees, 2u);
  EXPECT_GE(renderer.made().caster_lists, before.caster_lists);
}

/// Its program is that of the unchanged system.
TEST(EditedScene, AnotherEyeRefusesASystemThatChanged) {
  const std::vector<Edit> changes{
      {"a segment", [](GraphicsSystem& g) { enter_triangle(g, 5, 0.2); }},
      {"deleted", [](GraphicsSystem& g) { g.delete_segment(1); }},
      {"renamed", [](GraphicsSystem& g) { g.rename_segment(1, 7); }},
      {"hidden", [](GraphicsSystem& g) { g.set_visibility(1, false); }},
      {"moved", [](GraphicsSystem& g) { g.set_image_translation(1, 0.2, 0.0); }},
      {"background",
       [](GraphicsSystem& g) {
         g.set_background({Background::Kind::solid, {0, 0, 1}});
       }},
      {"method", [](GraphicsSystem& g) { g.set_hidden_surfaces({.method = HiddenMethod::map}); }},
      {"hidden lines",
       [](GraphicsSystem& g) { g.set_hidden_surfaces({.hidden_lines = HiddenLines::dashed}); }},
      {"z-buffer", [](GraphicsSystem& g) { g.set_hidden_surfaces({.z_buffer = true}); }}};
  for (const Edit& change : changes) {
    SCOPED_TRACE(change.name);
    GraphicsSystem system;
    std::ostringstream recorded;
    Recorder recorder(recorded);
    system.retain();
    system.set_recorder(&recorder);
    system.set_perspective({0, 0, 5});
    enter_triangle(system, 1, 0.3);
    OtherEye eye(system, *system.retained(), recorded.str());
    EXPECT_TRUE(eye.draws(options_of(HiddenMethod::z_buffer)));
    EXPECT_NO_THROW(eye.draw(options_of(HiddenMethod::z_buffer)));
    EXPECT_NO_THROW(eye.system());
    change.carry_out(system);
    const std::string why = "another eye, and the system has changed since it was made: ";
    EXPECT_TRUE(error_of([&] { eye.draw(options_of(HiddenMethod::z_buffer)); }).starts_with(why));
    EXPECT_TRUE(error_of([&] { eye.system(); }).starts_with(why));
    EXPECT_TRUE(error_of([&] { eye.program(); }).starts_with(why));
  }
}

}  // namespace
}  // namespace displayfile
