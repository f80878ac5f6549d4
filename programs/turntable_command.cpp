#include "programs/turntable_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "clip/error.h"
#include "displayfile/retained_views.h"
#include "displayfile/turntable.h"
#include "interp/picture_checks.h"
#include "interp/view_renderer.h"
#include "interp/visibility/image_space.h"
#include "programs/inputs.h"
#include "programs/progress.h"

namespace displayfile {

namespace {

/// Views without a tree: by a method that works in image space, named as such, or finds lines.
bool draws_each_anew(const DrawOptions& options) {
  const HiddenMethod method = surfaces_of(options.hidden.value_or(HiddenMethod::automatic));
  return finds_lines(method) || (method != HiddenMethod::automatic &&
                                 method != HiddenMethod::world_ray_cast && is_image_space(method));
}

void require_views(const DrawOptions& options) {
  const HiddenMethod method = surfaces_of(options.hidden.value_or(HiddenMethod::automatic));
  if (options.pens) require_drawn_by_pens(method, *options.pens);
  if (method == HiddenMethod::bsp || is_image_space(method)) return;
  if (finds_lines(method)) return require_drawable_by(method, options);
  throw Error(
      fmt::format("--turntable draws all views from one BSP tree, by rays from one tree of boxes, "
                  "or by a method that works in image space or finds lines, not by {}: expected "
                  "--hidden bsp, --hidden z-buffer or another of those, or no --hidden",
                  name_of(method)));
}

/// With the outputs of one view.
DrawOptions options_of_view(const DrawOptions& options, int number, int views) {
  DrawOptions of_view = options;
  if (!options.ids.empty()) of_view.ids = numbered(options.ids, number, views);
  if (!options.depth.empty()) of_view.depth = numbered(options.depth, number, views);
  return of_view;
}

/// Before the long work, and before any file is written.
void require_all_drawable(const std::filesystem::path& output, const DrawOptions& options,
                          const ViewsDrawn& views) {
  picture_kind(output, options);  // an unknown extension is told with the name as given
  for (int k = views.first; k < views.end; ++k) {
    require_drawable(numbered(output, k, views.all), options_of_view(options, k, views.all));
  }
}

/// By rays that are cast before viewing.
bool casts_into_world(const DrawOptions& options) {
  return options.hidden && surfaces_of(*options.hidden) == HiddenMethod::world_ray_cast;
}

/// With what the inputs set in place of what was not asked for, so far as views follow it.
DrawOptions with_settings(const GraphicsSystem& system, DrawOptions options) {
  const HiddenMethod method = method_in_force(system, hidden_surface_options(options));
  if (finds_lines(method)) {
    const auto usual = options.hidden ? HiddenScope::all : HiddenScope::segment;
    if (!options.scope) options.scope = system.hidden_scope().value_or(usual);
    options.hidden = method;
    if (!options.precision) options.precision = system.precision();
    require_views(options);
  }
  options.hidden_lines = hidden_lines_in_force(system, hidden_surface_options(options));
  if (!options.background) options.background = system.background();
  return options;
}

RetainedViews::Options tree_options(const GraphicsSystem& system, const DrawOptions& options) {
  return {options.scope.value_or(system.hidden_scope().value_or(HiddenScope::all)),
          options.precision.value_or(system.precision()),
          options.hidden_lines.value_or(HiddenLines::none), options.threads};
}

/// What of the statistics does not depend on the kind of tree.
std::string polygons_entered(const GraphicsSystem& system) {
  return fmt::format("polygons entered   {} ({} not flat, triangulated)\n",
                     system.polygons_entered(), system.polygons_triangulated());
}

std::string statistics(const GraphicsSystem& system, const RetainedViews& trees, int views) {
  const SortCounts& counts = trees.counts();
  return polygons_entered(system) +
         fmt::format(
             "views              {}, from {} tree{} in world coordinates\n"
             "pieces             {}\n"
             "cuts               {}\n"
             "comparisons        {}\n"
             "depth of the tree  {}\n"
             "walks              {}, and {} needless: the eye crossed no plane\n",
             views, trees.trees(), trees.trees() == 1 ? "" : "s", counts.pieces, counts.cuts,
             counts.comparisons, counts.depth, trees.walks(), trees.reused());
}

std::string statistics(const GraphicsSystem& system, const WorldViews& trees, int views) {
  return polygons_entered(system) +
         fmt::format(
             "views              {}, from 1 tree of boxes in world coordinates\n"
             "polygons cast at   {}\n",
             views, trees.polygons());
}

std::string statistics(const GraphicsSystem& system, const ViewRenderer&, int views) {
  return polygons_entered(system) +
         fmt::format("views              {}, each viewed anew and not sorted\n", views);
}

}  // namespace

int turntable_views(const std::string& text) {
  constexpr int kMost = 10000;
  int views = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, views);
  if (failure != std::errc{} || stop != end || views < 1 || views > kMost) {
    throw Error(fmt::format("--turntable {}: expected a number of views, 1 to {}", text, kMost));
  }
  return views;
}

std::filesystem::path numbered(const std::filesystem::path& file, int number, int views) {
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(views - 1).size());
  const std::string name =
      fmt::format("{}-{:0{}}{}", file.stem().string(), number, digits, file.extension().string());
  return file.parent_path() / name;
}

std::string draw_turntable(std::span<const std::string> inputs, const std::filesystem::path& output,
                           const DrawOptions& options, const MeshWords& meshes, Shading shading,
                           const ViewsDrawn& views, bool stats, NotInVectors& left_out) {
  require_views(options);
  for (const auto& file : {output, options.ids, options.depth}) {
    if (file == "-") throw Error("--turntable draws many views: expected a file name, not -");
  }
  require_all_drawable(output, options, views);
  GraphicsSystem system;
  RetainedScene scene;
  system.set_threads(options.threads);
  system.set_shading(shading);
  system.retain(&scene);
  const double aspect = static_cast<double>(options.width) / options.height;
  MeshWords turning = meshes;
  turning.turning = true;
  const std::optional<Upright> fitted =
      enter_inputs(inputs, system, turning, aspect,
                   {.method = options.hidden, .hidden_lines = options.hidden_lines});
  warn_of_stretched_window(system, output.string(), options.width, options.height);
  left_out.note(system, options, picture_kind(output, options));
  Turntable turntable(scene, system.display_file(), system.view());
  const Camera looking = meshes.camera();
  if (fitted) turntable.set_axis(fitted->up);
  if (fitted && looking.fit && !looking.angle_of_view) turntable.fit_window(views.all);
  const DrawOptions drawing = with_settings(system, options);
  if (draws_each_anew(drawing) || casts_into_world(drawing)) {
    require_hidden_lines_drawn(*drawing.hidden_lines, *drawing.hidden, drawing);
  }
  const auto draw_all = [&](auto trees, const auto& draw_view) -> std::string {
    const int count = views.end - views.first;
    Progress progress(fmt::format("drawing {} views", count));
    for (int k = views.first; k < views.end; ++k) {
      const auto [view, lights] = turntable.at(360.0 * k / views.all);
      draw_view(trees, view, lights, numbered(output, k, views.all),
                options_of_view(drawing, k, views.all));
      progress.update(static_cast<std::size_t>(k - views.first) + 1,
                      static_cast<std::size_t>(count));
    }
    return stats ? statistics(system, trees, count) : "";
  };
  if (draws_each_anew(drawing)) {
    return draw_all(ViewRenderer(scene, system.display_file()),
                    [](ViewRenderer& renderer, const View& view, const glm::dmat3& lights,
                       const std::filesystem::path& file,
                       const DrawOptions& of_view) { renderer.draw(view, file, of_view, lights); });
  }
  const auto draw_from_tree = [](auto& trees, const View& view, const glm::dmat3& lights,
                                 const std::filesystem::path& file, const DrawOptions& of_view) {
    draw(trees.view(view, lights), file, of_view);
  };
  if (casts_into_world(drawing)) {
    return draw_all(WorldViews(scene, system.display_file()), draw_from_tree);
  }
  return draw_all(RetainedViews(scene, system.display_file(), tree_options(system, drawing)),
                  draw_from_tree);
}

}  // namespace displayfile
