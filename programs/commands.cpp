#include "programs/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "clip/error.h"
#include "displayfile/input_file.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/output_file.h"
#include "displayfile/text/dump_compare.h"
#include "hidden/exact/predicate_counts.h"
#include "interp/files/npy_file.h"
#include "interp/files/picture_compare.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"
#include "interp/truth/truth.h"
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

std::string measures(const PictureDifference& d) {
  if (!d.same_size) return "the sizes differ\n";
  std::string text = fmt::format("{} wrong pixels of {}, largest difference {}\n", d.wrong_pixels,
                                 d.pixels, d.largest);
  if (d.background_and_polygon + d.polygon_and_polygon > 0) {
    text += fmt::format(
        "  {} show the background in the first only, {} in the second only, {} different "
        "polygons\n",
        d.background_in_first, d.background_and_polygon - d.background_in_first,
        d.polygon_and_polygon);
  }
  if (d.finite_in_both + d.finite_in_one > 0) {
    text += fmt::format("  depth error: largest {}, mean {}, over {} pixels finite in both\n",
                        d.largest_error, d.mean_error, d.finite_in_both);
    text += fmt::format("  {} pixels finite in only one\n", d.finite_in_one);
  }
  return text;
}

/// Marks the wrong pixels if that is asked for, and prints what was found; the exit status.
template <class Raster>
int report(const Raster& a, const Raster& b, const std::string& marks) {
  const PictureDifference difference = compare(a, b);
  if (!marks.empty()) write_png(marked(a, b), marks);
  std::cout << measures(difference);
  return difference.differs() ? 1 : 0;
}

std::string explanation(const GraphicsSystem& system, const DrawOptions& options,
                        PictureKind kind) {
  const HiddenMethod method = method_in_force(system, hidden_surface_options(options));
  if (method != HiddenMethod::automatic) return fmt::format("{}: as asked for\n", name_of(method));
  const MethodChoice choice = choose_method(system.display_file(), kind);
  return fmt::format("auto: {}: {}\n", name_of(choice.method), choice.reason);
}

}  // namespace

int DrawCommand::run() const {
  if (turntable) {
    draw_turntable(inputs, output, options, shading, *turntable, stats);
    return 0;
  }
  GraphicsSystem system;
  RetainedScene scene;
  if (options.hidden == HiddenMethod::world_ray_cast) system.retain(&scene);
  system.set_threads(options.threads);
  system.set_shading(shading);
  DrawOptions drawing = options;
  enter_inputs(inputs, system, static_cast<double>(options.width) / options.height);
  if (!drawing.hidden && std::ranges::none_of(inputs, is_drawing_program)) {
    drawing.hidden = HiddenMethod::automatic;
  }
  if (explain) std::cout << explanation(system, drawing, picture_kind(output));
  SortedDisplayFile sorted;
  {
    const Progress progress(fmt::format("drawing {} polygons", system.display_file().polygons()));
    draw(system, output, drawing, sorted);
  }
  if (pick) std::cout << picked(system, *pick, drawing);
  if (stats) {
    std::cout << statistics(system, sorted.display_file(), drawing, picture_kind(output))
              << exact_stage_counts();
  }
  return 0;
}

int TruthCommand::run() const {
  GraphicsSystem system;
  enter_inputs(inputs, system, static_cast<double>(width) / height);
  // Every output must be writable before the long work, and any is written.
  OutputFile{ids};
  if (!depth.empty()) OutputFile{depth};
  Picture picture;
  {
    Progress progress(fmt::format("the truth of {} polygons", system.display_file().polygons()));
    picture =
        truth(system.display_file(), width, height, !depth.empty(),
              [&](std::size_t done, std::size_t polygons) { progress.update(done, polygons); });
  }
  write_npy(picture.ids, width, height, ids);
  if (!depth.empty()) write_npy(picture.depth, width, height, depth);
  return 0;
}

int CompareCommand::run() const {
  const auto extension = [](const std::string& name) {
    return std::filesystem::path(name).extension().string();
  };
  const auto read_picture = [&](const std::string& name) {
    return extension(name) == ".png" ? read_png(name) : read_ppm(name);
  };
  const auto is_picture = [&](const std::string& name) {
    return extension(name) == ".png" || extension(name) == ".ppm";
  };
  if (is_picture(a) != is_picture(b) || (extension(a) == ".npy") != (extension(b) == ".npy")) {
    throw Error(fmt::format("{} and {}: expected two pictures, two .npy files or two dumps", a, b));
  }
  if (!marks.empty() && extension(marks) != ".png") {
    throw Error(fmt::format("{}: expected a .png file for the marks", marks));
  }
  if (is_picture(a)) return report(read_picture(a), read_picture(b), marks);
  if (extension(a) == ".npy") return report(read_npy(a), read_npy(b), marks);
  if (!marks.empty()) throw Error(fmt::format("{} and {}: dumps have no pixels to mark", a, b));
  const auto difference = first_difference(read_text_file(a), read_text_file(b));
  std::cout << (difference ? *difference : std::string("no difference")) << '\n';
  return difference ? 1 : 0;
}

int ImportCommand::run() const {
  OutputFile file(output);
  GraphicsSystem system;
  Recorder recorder(file.stream());
  system.set_recorder(&recorder);
  for (const std::string& mesh : meshes) {
    if (is_drawing_program(mesh)) throw Error(mesh + " is a drawing program: expected a mesh");
  }
  if (shading != Shading::flat) system.set_shading(shading);
  const Progress progress("importing " + meshes.front());
  const Mesh::Skipped skipped = import_meshes(meshes, system);
  file.commit();
  report_skipped(skipped);
  return 0;
}

}  // namespace displayfile
