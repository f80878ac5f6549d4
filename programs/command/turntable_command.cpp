#include "programs/command/turntable_command.h"

#include <fmt/format.h>

#include <charconv>

#include "clip/base/error.h"
#include "programs/inputs/drawing_statistics.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/nothing_by_pens.h"
#include "programs/process/progress.h"
#include "programs/process/stopwatch.h"

namespace displayfile {

namespace {

/// The statistics that do not depend on the kind of tree.
std::string polygons_entered(const GraphicsSystem& system) {
  return fmt::format("polygons entered   {} ({} not flat, triangulated)\n",
                     system.counts().polygons, system.counts().triangulated);
}

std::string statistics(const GraphicsSystem& system, const Renderer& renderer, int views) {
  const Renderer::Trees trees = renderer.trees();
  if (trees.polygons_in_boxes > 0) {
    return polygons_entered(system) +
           fmt::format(
               "views              {}, from 1 tree of boxes in world coordinates\n"
               "polygons cast at   {}\n",
               views, trees.polygons_in_boxes);
  }
  if (trees.sorted == 0) {
    return polygons_entered(system) +
           fmt::format("views              {}, each viewed anew and not sorted\n", views);
  }
  return polygons_entered(system) +
         fmt::format(
             "views              {}, from {} tree{} in world coordinates\n"
             "pieces             {}\n"
             "cuts               {}\n"
             "comparisons        {}\n"
             "depth of the tree  {}\n"
             "walks              {}, and {} needless: the eye crossed no plane\n",
             views, trees.sorted, trees.sorted == 1 ? "" : "s", trees.pieces, trees.cuts,
             trees.comparisons, trees.depth, trees.walks, trees.reused);
}

std::string explanation(const DrawOptions& options) {
  const HiddenMethod method = options.surfaces.method.value_or(HiddenMethod::automatic);
  if (is_colour_rule(method)) {
    return fmt::format("{}: the rule's colours, by one BSP tree in world coordinates\n",
                       name_of(method));
  }
  if (surfaces_of(method) == HiddenMethod::automatic) {
    return "auto: bsp: a turntable's views are drawn from one BSP tree in world coordinates\n";
  }
  return fmt::format("{}: {}\n", name_of(method),
                     options.pens ? "for pens: visible lines only" : "as set");
}

}  // namespace

int turntable_views(const std::string& text) {
  constexpr int kMost = TurntableViews::kMost;
  int views = 0;
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, views);
  if (failure != std::errc{} || stop != end || views < 1 || views > kMost) {
    throw Error(fmt::format("--turntable {}: expected a number of views, 1 to {}", text, kMost));
  }
  return views;
}

std::string draw_turntable(std::span<const std::string> inputs, const std::filesystem::path& output,
                           const DrawOptions& options, const MeshWords& meshes,
                           const StartingShading& shading, const TurntableViews& views,
                           const TurntableReport& report, NotInPicture& left_out) {
  if (options.pens && options.pens->hatching) {
    throw Error(
        "a turntable's views are not hatched: expected --pens without --hatch, or no --turntable");
  }
  require_turntable_method(options);
  for (const auto& file : {output.string(), options.ids, options.depth}) {
    if (file == "-") throw Error("--turntable draws many views: expected a file name, not -");
  }
  require_views_drawable(views, output, options);
  GraphicsSystem system;
  RetainedScene scene;
  system.set_threads(options.surfaces.threads);
  shading.start(system);
  system.retain(&scene);
  Stopwatch watch;
  const double aspect = static_cast<double>(options.width) / options.height;
  MeshWords turning = meshes;
  turning.turning = true;
  const std::optional<Upright> fitted = enter_inputs(
      inputs, system, turning, aspect,
      {.method = options.surfaces.method, .hidden_lines = options.surfaces.hidden_lines});
  const double entering_took = watch.lap();
  warn_of_stretched_window(system, output.string(), options.width, options.height);
  warn_of_turned_images(system, output.string(), options.width, options.height);
  const Destination to(output);
  left_out.note(system, resolve(system, options, &to));
  const Camera looking = meshes.camera();
  TurntableViews turned = views;
  if (fitted) turned.axis = fitted->up;
  turned.fit_window = fitted && looking.fit && !looking.angle_of_view;
  TurntableRenderer turntable(system, scene, system.display_file(), turned, options);
  const int count = views.end - views.first;
  Progress progress(fmt::format("drawing {} views", count));
  int empty = 0;
  for (int k = views.first; k < views.end; ++k) {
    turntable.draw_numbered(k, output);
    if (pens_draw_nothing(turntable.renderer().drawn_by_pens(), turntable.options())) ++empty;
    progress.update(static_cast<std::size_t>(k - views.first) + 1, static_cast<std::size_t>(count));
  }
  if (empty > 0) {
    warn_that_pens_draw_nothing(fmt::format("{}: {} of {} views", output.string(), empty, count),
                                turntable.options());
  }
  std::string text = report.explanation ? explanation(turntable.options()) : "";
  if (!report.statistics) return text;
  return text + statistics(system, turntable.renderer(), count) +
         times_of_drawing(entering_took, watch.lap());
}

}  // namespace displayfile
