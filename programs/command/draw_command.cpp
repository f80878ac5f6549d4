#include "programs/command/draw_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/parallel.h"
#include "hidden/exact/predicate_counts.h"
#include "interp/raster/antialias.h"
#include "programs/command/drawn_again.h"
#include "programs/command/turntable_command.h"
#include "programs/inputs/drawing_statistics.h"
#include "programs/inputs/drawn_inputs.h"
#include "programs/inputs/each_input.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/made_folders.h"
#include "programs/inputs/nothing_by_pens.h"
#include "programs/inputs/output_name.h"
#include "programs/inputs/output_paths.h"
#include "programs/options/length_unit.h"
#include "programs/options/number_in.h"
#include "programs/options/number_range.h"
#include "programs/options/option_groups.h"
#include "programs/options/pick_option.h"
#include "programs/options/picture_words.h"
#include "programs/process/progress.h"
#include "programs/process/stopwatch.h"
#include "programs/process/warnings.h"
#include "programs/sheet/drawing_scale.h"

namespace displayfile {

namespace {

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
  add_inputs(command, "INPUT", inputs,
             "drawing programs (.draw, or - for standard input) and meshes");
  add_with(command, with);
  add_output_options(command);
  add_picture_options(command);
  meshes.add_to(command, true);
  hidden_surfaces.add_to(command, LineWords::Takes::styles);
  vectors.add_to(command);
  command
      .add_flag("--crumbs", options.crumbs,
                "also draw pieces of lines that are shorter than they are wide and join no other")
      ->group(kHiddenSurfaceOptions);
  command.add_flag("--stats", stats, "print statistics of the drawing")->group(kReportOptions);
  command
      .add_option(
          "--pick", pick,
          "print the polygon that is visible at a pixel, counted from the upper left corner, "
          "or by a method of lines the one that hides there; with REACH, the line or edge "
          "that is visible within REACH pixels, or half its width, of it, if there is one")
      ->type_name("X,Y[,REACH]")
      ->group(kReportOptions);
  command
      .add_flag("--quiet", quiet,
                "no warnings and no progress; with many inputs, those not drawn are listed at the "
                "end, with reasons")
      ->group(kReportOptions);
  command.add_flag("--explain", explain, "print the method that auto chose, and why")
      ->group(kReportOptions);
  return command;
}

void DrawCommand::add_output_options(CLI::App& command) {
  command
      .add_option("-o,--output", output,
                  "the picture: " + listed(picture_formats()) +
                      "; or - for standard output. With fields, such as 'thumbnails/{name}.png', "
                      "one picture per input: {name} is its file name, {ext} its extension, "
                      "{folder} its folder, {number} its position on the command line")
      ->type_name(picture_file())
      ->required()
      ->group(kOutputOptions);
  command
      .add_option("--format", options.format,
                  "format of the picture, overriding the file's extension; on standard output png "
                  "by default, or ppm without libpng")
      ->type_name(picture_format_words())
      ->group(kOutputOptions);
  command
      .add_flag("--check", check,
                "writes nothing: draws to compare with the files that are there, prints those that "
                "differ or are missing, and exits with 1 if any does")
      ->group(kOutputOptions);
  command
      .add_option("--ids", options.ids,
                  "item buffer as .npy: pick identifiers of visible fills, -1 for none")
      ->type_name("IDS.npy")
      ->group(kOutputOptions);
  command.add_option("--depth", options.depth, "depth of visible fills as .npy, -inf for none")
      ->type_name("DEPTH.npy")
      ->group(kOutputOptions);
}

void DrawCommand::add_picture_options(CLI::App& command) {
  size.add_to(command, true);
  command
      .add_option("--samples", options.samples,
                  "antialiasing: each pixel is the mean of N x N samples; 1 for none, the default "
                  "with osmesa and plain-z-buffer")
      ->type_name("N")
      ->transform(number_in(1, kMostSamples))
      ->default_str(fmt::format("{}", kUsualSamples))
      ->group(kPictureOptions);
  shading.add_to(command);
  background.add_to(command);
  paper.add_to(command);
  command
      .add_option(
          "--scale", scale,
          "exact scale on paper, of a parallel view: windows are widened to it, and a figure "
          "that does not fit is refused; with --paper, --size in mm, or --dpi")
      ->type_name("PAPER:SCENE")
      ->group(kPaperOptions);
  command.add_option("--unit", unit, "unit of the scene, for --scale [mm]")
      ->type_name(kLengthUnits)
      ->group(kPaperOptions);
  command
      .add_option(
          "--line-width", line_width,
          "width of lines, overriding programs, except for kinds with a width of their own "
          "(--lines): in pixels, in mm with --paper or --pens, or with a unit (0.35mm, 1pt, "
          "2px)")
      ->type_name("WIDTH")
      ->group(kPictureOptions);
  command
      .add_option("--line-order", line_order,
                  "which of two lines that overlap in the picture is drawn over the other, "
                  "overriding programs: the one entered later, or the nearer one, as in pictures "
                  "of knots and pipes; depth takes all segments together [entry]")
      ->type_name("entry|depth")
      ->group(kPictureOptions);
  command
      .add_option("--halo", halo,
                  "gap beside a line where another one crosses in front of it, overriding "
                  "programs; needs line order depth; in pixels, in mm with --paper or --pens, or "
                  "with a unit (1mm, 3pt, 4px); 0 for none [0]")
      ->type_name("WIDTH")
      ->group(kPictureOptions);
  command
      .add_option(
          "--explode", explode,
          "an exploded view: the inputs, or the segments or objects of one, are moved apart "
          "along an axis in the order of their boxes, after those named as in z=0.5:LID,BODY, with "
          "gaps of FACTOR times their mean length [0.5]; or radially, by FACTOR times the "
          "distances of their middles from "
          "the middle of all [1]. Dash-dotted trace lines show the moves")
      ->type_name("x|y|z|-x|-y|-z|radial[=FACTOR]")
      ->group(kPictureOptions);
  command
      .add_option("--turntable", turntable,
                  "N views at equal angles around the up axis: OUT.png becomes OUT-000.png, "
                  "OUT-001.png, ..., --ids and --depth likewise. All are drawn from one BSP tree, "
                  "with --hidden world-ray-cast from one tree of boxes; z-buffer and other "
                  "image-space methods sort nothing, and methods of lines draw each view anew")
      ->type_name("N")
      ->group(kPictureOptions);
  command
      .add_option("--views", views,
                  "only a turntable's views from FIRST up to END, not including END; several "
                  "machines may share the N views")
      ->type_name("FIRST:END")
      ->group(kPictureOptions);
  command
      .add_option("--rows", rows,
                  "only the picture's rows from FIRST up to END, not including END, counted from "
                  "the top; for pixels")
      ->type_name("FIRST:END")
      ->group(kPictureOptions);
  command
      .add_option("--device", options.device,
                  "device that draws pixels: " + listed(raster_devices()))
      ->type_name(raster_device_words())
      ->capture_default_str()
      ->group(kPictureOptions);
  command
      .add_option("--threads", hidden_surfaces.surfaces.threads,
                  "maximum number of threads; the picture does not depend on it")
      ->type_name("N")
      ->transform(number_in(1, 1024))
      ->group(kPictureOptions);
}

namespace {

/// To which vertices are rounded for lengths that are exact on paper: 0.004 mm, or finer by
/// default.
double precision_at_scale(const PixelSize& pixel) {
  constexpr double kMillimetres = 0.004;
  const double usual = VectorOptions().precision;
  if (!pixel.millimetres) return usual;
  return std::clamp(kMillimetres / *pixel.millimetres, VectorOptions::kFinestPrecision, usual);
}

}  // namespace

/// With those that are words on the command line.
DrawOptions DrawCommand::all_options() {
  DrawOptions all = options;
  all.vectors = vectors.options();
  takes_papers_shape_ = paper.read(all, size, scale.has_value());
  if (scale && vectors.precision.empty()) {
    all.vectors.precision = precision_at_scale(pixel_size(all, size, output));
  }
  if (rows) {
    const NumberRange range = number_range("--rows", *rows, all.height, "rows");
    all.rows = PictureRows{range.first, range.end};
  }
  all.surfaces = hidden_surfaces.options();
  all.background = background.background();
  all.lettering = vectors.lettering();
  if (line_order) all.surfaces.line_order = displayfile::line_order(*line_order);
  if (halo) {
    all.surfaces.line_halo = halo_of_option(*halo, pixel_size(all, size, output));
  }
  if (turntable && all.pens && !all.pens->hatching && !all.surfaces.method) {
    all.surfaces.method = HiddenMethod::franklin;
  }
  return all;
}

TurntableViews DrawCommand::views_drawn() const {
  if (!turntable) {
    if (views) throw Error("--views: expected --turntable too");
    return {};
  }
  const int all = turntable_views(*turntable);
  if (!views) return {all, 0, all};
  const NumberRange range = number_range("--views", *views, all, "views");
  return {all, range.first, range.end};
}

std::optional<ExactScale> DrawCommand::exact_scale(const DrawOptions& drawing) const {
  const double unit_in_mm = unit.empty() ? 1.0 : millimetres_of_unit(unit);
  if (!scale) {
    if (!unit.empty()) throw Error(fmt::format("--unit {}: expected --scale too", unit));
    return std::nullopt;
  }
  const std::string name = "--scale " + *scale;
  const DrawingScale drawn = drawing_scale(*scale);
  const PixelSize pixel = pixel_size(drawing, size, output);
  if (!pixel.millimetres) {
    throw Error(name +
                ": a picture without a size on paper has no scale: expected --paper, or --size in "
                "mm, with .svg, .pdf or .eps, or --dpi with .png");
  }
  if (turntable) throw Error(name + ": expected one picture, not a turntable's views");
  return ExactScale{name, drawn.factor() * unit_in_mm, *pixel.millimetres * drawing.height};
}

MeshWords DrawCommand::entering(const DrawOptions& drawing) const {
  const auto pixel = [&] { return pixel_size(drawing, size, output); };
  MeshWords words = meshes;
  if (const auto& lines = hidden_surfaces.lines) {
    words.lines = lines->selection();
    words.line_styles = lines->styles(pixel());
  }
  if (explode) words.explosion = explosion_of_option(*explode);
  if (line_width) words.line_width = length_of_option("--line-width", *line_width, pixel());
  words.scale = exact_scale(drawing);
  words.widen = words.widen || takes_papers_shape_;
  words.touching = hidden_surfaces.touching;
  const bool for_pens = paper.pens || !paper.hatch.empty();
  if (for_pens && !words.lines && !std::ranges::all_of(inputs, is_drawing_program)) {
    words.lines_of_meshes = displayfile::line_selection("outline,boundary,crease");
  }
  return words;
}

StartingShading DrawCommand::starting_shading() const {
  const bool has_meshes = !std::ranges::all_of(inputs, is_drawing_program);
  const bool has_programs = std::ranges::any_of(inputs, is_drawing_program);
  // Hatching lines run on over the facets of curved surfaces, up to the creases that are drawn.
  const LineSelection lines = entering_.lines.value_or(LineSelection{});
  const StartingShading for_hatching{Shading::gouraud, lines.crease_degrees};
  return shading.starting(has_meshes, has_programs,
                          paper.hatch.empty() ? StartingShading{} : for_hatching);
}

std::string DrawCommand::draw_into(std::span<const std::string> drawn,
                                   const std::filesystem::path& file, const DrawOptions& drawing,
                                   MadeFolders* folders, NotInPicture& left_out) const {
  const auto make_folders = [&] {
    if (folders == nullptr) return;
    for (const auto& written : {file.string(), drawing.ids, drawing.depth}) {
      folders->make_for(written);
    }
  };
  if (turntable) {
    make_folders();
    return draw_turntable(drawn, file, drawing, entering_, starts_with_, views_drawn_,
                          {.explanation = explain, .statistics = stats}, left_out);
  }
  if (stats) reset_predicate_counts();
  const Destination to(file);
  const PicturePlan call = resolve_call(drawing, &to);
  if (pick && call.page) {
    throw Error(
        "--pick: a sheet of paper in pixels has no pick: expected no --paper, or no --dpi, for it");
  }
  Stopwatch watch;
  const bool picture_alone = call.kind() == PictureKind::raster && !explain && !stats && !pick;
  const DrawnInputs entered(
      drawn, call, entering_, starts_with_,
      picture_alone ? DrawnInputs::Use::picture : DrawnInputs::Use::display_file);
  const double entering_took = watch.lap();
  entered.check_window();
  warn_of_stretched_window(entered.system(), file.string(), drawing.width, drawing.height);
  warn_of_turned_images(entered.system(), file.string(), drawing.width, drawing.height);
  if (scale) warn_of_scaled_images(entered.system(), file.string(), *scale);
  const GraphicsSystem& system = entered.system();
  const PicturePlan& plan = entered.plan();
  std::string text = explain ? explanation_of_method(plan) : "";
  // Before the picture, since nothing is written where a limit is reached.
  const std::string pick_found = pick ? picked(system, pick_option(*pick), plan) : std::string();
  SortedDisplayFile sorted;
  std::vector<DrawWarning> warned;
  double drawing_took = 0.0;
  {
    Progress progress(fmt::format("drawing {} polygons", entered.polygons()));
    make_folders();
    watch.lap();
    warned = entered.draw(sorted, progress.told());
    drawing_took = watch.lap();
  }
  left_out.note(system, plan);
  left_out.note(warned, file.string());
  if (!entered.warn_if_nothing_is_seen(warned) && plan.options.pens &&
      pens_draw_nothing(sorted.display_file(), plan.options)) {
    warn_that_pens_draw_nothing(file.string(), plan.options);
  }
  text += pick_found;
  if (stats) {
    text += drawing_statistics(system, sorted.display_file(), plan) +
            times_of_drawing(entering_took, drawing_took);
  }
  return text;
}

/// An output's files: those of a turntable's views have numbers.
std::vector<std::string> DrawCommand::files_written(const std::filesystem::path& file) const {
  if (!turntable || file.empty()) return {file.string()};
  const TurntableViews& drawn = views_drawn_;
  std::vector<std::string> files;
  for (int k = drawn.first; k < drawn.end; ++k) {
    files.push_back(numbered(file, k, drawn.number).string());
  }
  return files;
}

/// The files of each input, checked before any is drawn.
std::vector<DrawCommand::Outputs> DrawCommand::outputs_of_each(const DrawOptions& drawing) const {
  std::vector<Outputs> of_each;
  std::map<std::filesystem::path, std::size_t> made;
  std::set<std::filesystem::path> read;
  for (const auto files_read : {std::span(inputs), std::span(lists_)}) {
    for (const std::string& name : files_read) {
      if (const auto file = input_at(name)) read.insert(*file);
    }
  }
  const std::vector<std::string> names = figure_names(figures_);
  const auto name = [&](const std::filesystem::path& pattern, std::size_t k) {
    if (pattern.empty()) return std::filesystem::path();
    std::filesystem::path file = output_name(pattern.string(), names[k], k, names.size());
    for (const std::string& written : files_written(file)) {
      const auto leads_to = output_at(written);
      if (!leads_to) continue;
      if (read.contains(*leads_to)) {
        throw Error(fmt::format("{}: the output of {} and an input: expected another name", written,
                                input_name(names[k])));
      }
      const auto [other, is_new] = made.emplace(*leads_to, k);
      if (is_new) continue;
      if (other->second == k) {
        throw Error(fmt::format("{}: two outputs of {} are one file: expected a file for each",
                                written, input_name(names[k])));
      }
      throw Error(
          fmt::format("{}: the output of {} and of {}: expected a name for each, by {{name}}, "
                      "{{ext}}, {{folder}} or {{number}}",
                      written, input_name(names[other->second]), input_name(names[k])));
    }
    return file;
  };
  for (std::size_t k = 0; k < names.size(); ++k) {
    of_each.push_back({name(output, k), name(drawing.ids, k), name(drawing.depth, k)});
  }
  return of_each;
}

namespace {

/// Throws Error for what would keep all inputs from being drawn: an option, or a missing folder.
void require_drawable_names(const std::string& output, const DrawOptions& options,
                            const std::filesystem::path& first, const std::filesystem::path& ids,
                            const std::filesystem::path& depth) {
  picture_kind(output, options);  // reports an unknown extension with the name as given
  const auto beside = [](const std::filesystem::path& pattern, const std::filesystem::path& file) {
    if (file.empty()) return file;
    const std::filesystem::path folder = folder_before_fields(pattern.string());
    if (!folder.empty() && !std::filesystem::exists(folder)) {
      throw Error(fmt::format("{}: cannot be written: there is no folder {}", pattern.string(),
                              folder.string()));
    }
    return folder / file.filename();
  };
  DrawOptions of_first = options;
  of_first.ids = beside(options.ids, ids).string();
  of_first.depth = beside(options.depth, depth).string();
  require_drawable(beside(output, first), of_first);
}

}  // namespace

int DrawCommand::draw_each(const DrawOptions& drawing, NotInPicture& left_out) const {
  const std::vector<Outputs> outputs = outputs_of_each(drawing);
  const std::vector<std::string> names = figure_names(figures_);
  require_drawable_names(output, drawing, outputs[0].picture, outputs[0].ids, outputs[0].depth);
  // llvmpipe has threads of its own, and the exact stage counts for the whole process.
  const bool several = drawing.device == raster_devices().front().name && !stats;
  const int at_a_time =
      several
          ? static_cast<int>(std::min<std::size_t>(
                names.size(), static_cast<std::size_t>(useful_threads(drawing.surfaces.threads))))
          : 1;
  MadeFolders folders;
  std::optional<DrawnAgain> again;
  if (check) again.emplace();
  std::vector<std::string> differing(names.size());
  std::vector<std::string> bad;
  for_each_input(
      names, at_a_time, fmt::format("drawing {} pictures", names.size()),
      [&](std::size_t k) {
        DrawOptions of_one = drawing;
        of_one.surfaces.threads = std::max(1, drawing.surfaces.threads / at_a_time);
        const Outputs& there = outputs[k];
        const Outputs drawn = again ? placed(*again, k, there) : there;
        of_one.ids = drawn.ids.string();
        of_one.depth = drawn.depth.string();
        std::string text =
            draw_into(figures_[k], drawn.picture, of_one, again ? nullptr : &folders, left_out);
        if (again) differing[k] = differences(*again, there, drawn);
        return text;
      },
      [&](std::size_t k, const InputResult& result) {
        if (!quiet && !again) std::cerr << result.warnings;
        if (!result.text.empty()) std::cout << names[k] << ":\n" << result.text;
        std::cout << differing[k];
        if (result.error.empty()) return;
        if (!quiet) std::cerr << "displayfile: " << result.error << '\n';
        bad.push_back(quiet ? result.error : input_name(names[k]));
      });
  const bool any_differs = std::ranges::any_of(differing, [](auto& text) { return !text.empty(); });
  if (bad.empty()) return any_differs ? 1 : 0;
  std::cerr << fmt::format("displayfile: {} of {} inputs not drawn:\n  {}\n", bad.size(),
                           names.size(), fmt::join(bad, "\n  "));
  return 2;
}

DrawCommand::Outputs DrawCommand::placed(const DrawnAgain& again, std::size_t k,
                                         const Outputs& there) {
  return {again.place(k, there.picture), again.place(k, there.ids), again.place(k, there.depth)};
}

std::string DrawCommand::differences(const DrawnAgain& again, const Outputs& there,
                                     const Outputs& drawn) const {
  std::string text;
  for (const auto file : {&Outputs::picture, &Outputs::ids, &Outputs::depth}) {
    const std::vector<std::string> all = files_written(there.*file);
    const std::vector<std::string> anew = files_written(drawn.*file);
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].empty()) continue;
      const std::string how = again.difference(all[k], anew[k]);
      if (!how.empty()) text += how + '\n';
    }
  }
  return text;
}

std::string DrawCommand::draw_one(const DrawOptions& drawing, NotInPicture& left_out) const {
  std::ostringstream unheard;
  std::optional<CollectedWarnings> collected;
  if (quiet) collected.emplace(unheard);
  std::string text = draw_into(inputs, output, drawing, nullptr, left_out);
  left_out.warn(output);
  return text;
}

int DrawCommand::check_one(const DrawOptions& drawing, NotInPicture& left_out) const {
  require_drawable(output, drawing);
  const DrawnAgain again;
  const Outputs there{output, drawing.ids, drawing.depth}, drawn = placed(again, 0, there);
  DrawOptions anew = drawing;
  anew.ids = drawn.ids.string();
  anew.depth = drawn.depth.string();
  std::ostringstream unheard;
  const CollectedWarnings collected(unheard);
  std::cout << draw_into(inputs, drawn.picture, anew, nullptr, left_out);
  const std::string text = differences(again, there, drawn);
  std::cout << text;
  return text.empty() ? 0 : 1;
}

/// The view of the options is fitted once, before any picture is drawn.
void DrawCommand::fit_to_all(const DrawOptions& drawing) {
  if (!meshes.fits_all()) return;
  if (!is_name_pattern(output)) {
    throw Error(
        "--fit all: one picture is fitted to all its inputs: expected a picture of each, "
        "such as -o '{name}.svg'");
  }
  if (turntable) throw Error("--fit all: expected pictures, not turntables");
  const MeshWords& words = entering_;
  entering_.together =
      displayfile::fit_to_all(figures_, words.options(), [&](GraphicsSystem& system) {
        starts_with_.start(system);
        words.start(system, static_cast<double>(drawing.width) / drawing.height);
      });
}

int DrawCommand::run() {
  lists_ = input_lists(inputs);
  std::vector<Figure> figures = input_figures(inputs);
  if (!is_name_pattern(output)) figures = {inputs_of(figures)};
  figures_ = with_common(with, std::move(figures));
  inputs = inputs_of(figures_);
  if (check && output == "-") {
    throw Error("--check: standard output is no file to compare with: expected -o FILE");
  }
  const DrawOptions drawing = all_options();
  entering_ = entering(drawing);
  starts_with_ = starting_shading();
  views_drawn_ = views_drawn();
  if (pick) pick_option(*pick);
  if (pick && turntable) {
    throw Error(fmt::format("--pick {}: expected one picture, and not a turntable's views", *pick));
  }
  NotInPicture left_out;
  if (quiet) Progress::show_none();
  if (scale && unit.empty() && !quiet && !check) warn_of_metres(inputs);
  fit_to_all(drawing);
  if (is_name_pattern(output)) {
    const int status = draw_each(drawing, left_out);
    if (!quiet && !check) left_out.warn(output);
    return status;
  }
  for (const auto& file : {drawing.ids, drawing.depth}) {
    if (!is_name_pattern(file)) continue;
    throw Error(
        fmt::format("{}: has a field, and {} has none: expected both or neither", file, output));
  }
  std::vector<std::string> written;
  for (const auto& file : {std::filesystem::path(output), std::filesystem::path(drawing.ids),
                           std::filesystem::path(drawing.depth)}) {
    std::ranges::move(files_written(file), std::back_inserter(written));
  }
  require_files_of_their_own(written, inputs, lists_);
  if (check) return check_one(drawing, left_out);
  const std::string text = draw_one(drawing, left_out);
  (output == "-" ? std::cerr : std::cout) << text;
  return 0;
}

}  // namespace displayfile
