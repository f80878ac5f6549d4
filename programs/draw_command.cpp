#include "programs/draw_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <span>

#include "hidden/exact/predicate_counts.h"
#include "interp/raster/antialias.h"
#include "interp/visibility/auto_method.h"
#include "programs/inputs.h"
#include "programs/progress.h"
#include "programs/turntable_command.h"

namespace displayfile {

namespace {

/// How often the predicates' filters were undecided.
std::string exact_stage_counts() {
  std::string text;
  const PredicateCounts counts = predicate_counts();
  for (std::size_t i = 0; i < kPredicates; ++i) {
    const StageCounts& count = counts[i];
    if (count.exact + count.by_definition == 0) continue;
    text += fmt::format("exact stage        {}: {} times, and {} zero by definition\n",
                        name_of(static_cast<Predicate>(i)), count.exact, count.by_definition);
  }
  return text.empty() ? "exact stage        never asked\n" : text;
}

/// What sorting the hidden surfaces cost; nothing if none were sorted.
std::string sort_counts(const DisplayFile& file, std::size_t polygons_and_lines) {
  const SortCounts counts = counts_of_sorts(file);
  if (counts.pieces == 0) return "";
  return fmt::format(
      "pieces             {} ({:.4f} a polygon or line)\n"
      "cuts               {}\n"
      "comparisons        {}\n"
      "depth of the tree  {}\n",
      counts.pieces, static_cast<double>(counts.pieces) / static_cast<double>(polygons_and_lines),
      counts.cuts, counts.comparisons, counts.depth);
}

std::string statistics(const GraphicsSystem& system, const DisplayFile& file,
                       const DrawOptions& options, PictureKind kind) {
  std::size_t lines = 0, visible = 0, drawn = 0;
  for (const Segment& segment : file.segments()) {
    lines += segment.lines();
    visible += segment.visible ? 1 : 0;
    drawn += segment.visible ? segment.polygons() + segment.lines() : 0;
  }
  const std::size_t polygons = file.polygons();
  std::string text = fmt::format(
      "segments           {} ({} visible)\n"
      "polygons entered   {} ({} not flat, triangulated)\n"
      "polygons stored    {}\n"
      "lines stored       {}\n"
      "display file       {} bytes ({:.1f} a polygon)\n"
      "picture            {} x {}, hidden surfaces by {}\n",
      file.segments().size(), visible, system.polygons_entered(), system.polygons_triangulated(),
      polygons, lines, file.bytes(),
      polygons == 0 ? 0.0 : static_cast<double>(file.bytes()) / static_cast<double>(polygons),
      options.width, options.height, name_of(drawing_method(system, options, kind)));
  return text + sort_counts(file, drawn);
}

std::string explanation(const GraphicsSystem& system, const DrawOptions& options,
                        PictureKind kind) {
  const HiddenMethod method = method_in_force(system, hidden_surface_options(options));
  if (method != HiddenMethod::automatic) return fmt::format("{}: as asked for\n", name_of(method));
  const MethodChoice choice = choose_method(system.display_file(), kind);
  return fmt::format("auto: {}: {}\n", name_of(choice.method), choice.reason);
}

/// For --help.
std::string listed(std::span<const Choice> choices) {
  std::string text;
  for (const Choice& choice : choices) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", choice.name, choice.what);
  }
  return text;
}

}  // namespace

CLI::App& DrawCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("draw", "Draw drawing programs and meshes");
  command
      .add_option("INPUT", inputs, "drawing programs (.draw, or - for standard input) and meshes")
      ->required();
  command.add_option("-o,--output", output, "the picture: " + listed(picture_formats()))
      ->required();
  size.add_to(command);
  hidden_surfaces.add_to(command);
  command.add_option("--device", options.device, listed(raster_devices()))->capture_default_str();
  command.add_option("--threads", options.threads, "the picture is the same for any number")
      ->check(CLI::Range(1, 1024));
  command
      .add_option("--samples", options.samples,
                  "antialiasing: the mean of N x N samples for each pixel")
      ->check(CLI::Range(1, kMostSamples))
      ->capture_default_str();
  command.add_flag("--explain", explain, "say which method auto picked, and why");
  command.add_option("--ids", options.ids,
                     "item buffer as .npy: the pick identifier seen, -1 for none");
  command.add_option("--depth", options.depth, "depth as .npy: of the fill seen, -inf for none");
  command.add_option("--turntable", turntable,
                     "N views, turned evenly all around the view-up axis, from one BSP tree, "
                     "or with --hidden world-ray-cast from one tree of boxes: "
                     "OUT.png becomes OUT-000.png, OUT-001.png, ..., --ids and --depth likewise");
  shading.add_to(command);
  meshes.add_to(command);
  command.add_flag("--stats", stats, "print what was drawn");
  return command;
}

/// With those that are words on the command line.
DrawOptions DrawCommand::all_options() const {
  DrawOptions all = options;
  size.read(all.width, all.height);
  const HiddenSurfaceOptions sorting = hidden_surfaces.options(options.threads);
  all.hidden = sorting.method;
  all.scope = sorting.scope;
  all.precision = sorting.precision;
  require_raster_device(options.device);
  return all;
}

int DrawCommand::run() const {
  const Shading start_with = shading.shading();
  DrawOptions drawing = all_options();
  if (turntable) {
    draw_turntable(inputs, output, drawing, start_with, turntable_views(*turntable), stats,
                   meshes.options());
    return 0;
  }
  GraphicsSystem system;
  RetainedScene scene;
  if (drawing.hidden == HiddenMethod::world_ray_cast) system.retain(&scene);
  system.set_threads(drawing.threads);
  system.set_shading(start_with);
  enter_inputs(inputs, system, static_cast<double>(drawing.width) / drawing.height,
               meshes.options());
  if (!drawing.hidden && std::ranges::none_of(inputs, is_drawing_program)) {
    drawing.hidden = HiddenMethod::automatic;
  }
  if (explain) std::cout << explanation(system, drawing, picture_kind(output));
  SortedDisplayFile sorted;
  {
    const Progress progress(fmt::format("drawing {} polygons", system.display_file().polygons()));
    draw(system, output, drawing, sorted);
  }
  if (stats) {
    std::cout << statistics(system, sorted.display_file(), drawing, picture_kind(output))
              << exact_stage_counts();
  }
  return 0;
}

}  // namespace displayfile
