#include "programs/command/truth_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/nearest_word.h"
#include "displayfile/files.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/text/output_file.h"
#include "interp/files/npy_file.h"
#include "interp/truth/entered_truth.h"
#include "interp/truth/truth.h"
#include "interp/truth/world_truth.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/output_paths.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/number_in.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"

namespace displayfile {

CLI::App& TruthCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "truth",
      "Find the visible fill at each pixel, or the visible parts of each line, by exact "
      "arithmetic, independent of the methods; with --hidden compare a method of lines with it, "
      "and exit with 1 if any length is missing or extra");
  add_inputs(command, "INPUT", inputs, "drawing programs and meshes");
  size.add_to(command);
  meshes.add_to(command);
  command
      .add_option("--ids", ids,
                  "item buffer as .npy: pick identifiers of visible fills, -1 for none")
      ->type_name("IDS.npy");
  command
      .add_option("--depth", depth, "depth of visible fills as .npy, rounded once, -inf for none")
      ->type_name("DEPTH.npy");
  command
      .add_option("--from", from,
                  "coordinates from which pixels are computed; entered (default): the points and "
                  "matrices entered, with touching polygons in one plane; world: world "
                  "coordinates; display-file: its coordinates, rounded by viewing. If entered or "
                  "world is set, the number of pixels that differ from display-file is printed")
      ->type_name("display-file|world|entered");
  add_touching_option(command, meshes.touching);
  command
      .add_option("--seen-lines", seen_lines,
                  "the visible parts of lines as a dump, equal to that of a correct method of "
                  "lines (dump --hidden franklin)")
      ->type_name("LINES.txt");
  command
      .add_option("--hidden", hidden,
                  "print the missing and extra length of visible lines by this method")
      ->type_name("LINE-METHOD");
  add_word_option(command, "--precision", judged.precision, precision, "precision of that method")
      ->type_name("exact|roundoff[=EPS]")
      ->default_str("exact");
  command
      .add_option("--line-samples", line_samples,
                  "check at least this many random points of lines instead of whole lines, for "
                  "large scenes")
      ->type_name("N")
      ->transform(any_number<std::size_t>());
  command
      .add_option("--threads", judged.threads,
                  "maximum number of threads for lines; the result does not depend on it")
      ->type_name("N")
      ->transform(number_in(1, 1024));
  return command;
}

int TruthCommand::run() {
  const std::vector<std::string> lists = input_lists(inputs);
  inputs = input_names(inputs);
  const From from_what = judged_from();
  const bool retains = from_what != From::display_file;
  if (ids.empty() && (from.empty() || !retains) && !wants_lines()) {
    throw Error(
        "truth: --ids is required: expected a file for the item buffer, or --seen-lines or "
        "--hidden for lines");
  }
  if (!from.empty() && retains && wants_lines()) {
    throw Error(fmt::format(
        "--from {}: lines are computed in display-file coordinates: expected --ids alone", from));
  }
  if (meshes.touching && from_what == From::world) {
    throw Error("--touching: expected --from display-file or entered");
  }
  if (ids.empty() && !depth.empty() && wants_lines()) {
    throw Error("--depth: expected --ids too");
  }
  if (hidden.empty() && (line_samples != 0 || !judged.precision.exact)) {
    throw Error("--line-samples and --precision: expected --hidden and a method of lines too");
  }
  require_files_of_their_own({ids, depth, seen_lines}, inputs, lists);
  judged.method = judged_method();
  int width = 0, height = 0;
  size.read(width, height);
  RetainedScene retained;
  GraphicsSystem system;
  if (retains) system.retain(&retained);
  // Methods of lines draw the sides of bare meshes.
  const auto drawn_by = wants_lines() ? std::optional(judged.method) : std::nullopt;
  enter_inputs(inputs, system, meshes, size.aspect(), {.method = drawn_by});
  // Every output must be writable before the long work, and all are written before any is there.
  std::optional<OutputFile> lines_file;
  if (!seen_lines.empty()) lines_file.emplace(seen_lines);
  std::vector<std::unique_ptr<RowFile>> arrays;
  if (!ids.empty()) arrays.push_back(ids_row_file(ids, width, height));
  if (!depth.empty()) arrays.push_back(depth_row_file(depth, width, height));

  if (wants_lines() && contains(system.hidden_surfaces().lines.kinds, LineKind::intersection)) {
    warnings() << fmt::format(
        "{}: left out: lines in which polygons pass through each other, which truth does not "
        "find\n",
        input_name(inputs.front()));
  }
  const DisplayFile& file = system.display_file();
  std::string report;
  int status = 0;
  if (lines_file) write_seen_lines(file, lines_file->stream());
  if (!hidden.empty()) status = judge_lines(file, report);
  if (!ids.empty() || (!from.empty() && retains)) {
    const Picture picture = true_picture(system, retained, from_what, report);
    for (const auto& array : arrays) array->write(picture);
  }
  if (lines_file) lines_file->finish();
  for (const auto& array : arrays) array->finish();
  if (lines_file) lines_file->commit();
  for (const auto& array : arrays) array->commit();
  reports() << report;
  return status;
}

/// The picture of the display file, or one from before viewing: then the report has the number of
/// pixels in which the two differ.
Picture TruthCommand::true_picture(const GraphicsSystem& system, const RetainedScene& retained,
                                   From judged_from, std::string& report) const {
  const DisplayFile& file = system.display_file();
  int width = 0, height = 0;
  size.read(width, height);
  const auto with_progress = [&](std::string_view what, auto&& judge) {
    Progress progress(fmt::format("the truth of {} {}polygons", file.polygons(), what));
    return judge([&](std::size_t done, std::size_t polygons) { progress.update(done, polygons); });
  };
  const auto of_display_file = [&](bool with_depth) {
    return with_progress("", [&](const WorkProgress& progress) {
      return truth(file, width, height, with_depth, progress);
    });
  };
  if (judged_from == From::display_file) return of_display_file(!depth.empty());
  std::size_t touching_polygons = 0;
  Picture before_viewing =
      with_progress(from.empty() ? from : from + " ", [&](const WorkProgress& progress) {
        if (judged_from == From::world) {
          return world_truth(retained, file, width, height, !depth.empty(), progress);
        }
        EnteredTruth entered =
            entered_truth(retained, file, width, height, !depth.empty(), std::nullopt, progress);
        touching_polygons = entered.touching;
        return std::move(entered.picture);
      });
  if (from.empty()) return before_viewing;
  report += fmt::format("{} of {} pixels differ from the display file, which viewing rounded\n",
                        different_pixels(of_display_file(false), before_viewing),
                        before_viewing.ids.size());
  if (judged_from == From::entered) {
    report += fmt::format("polygons in the planes of others: {}\n", touching_polygons);
  }
  return before_viewing;
}

/// By Franklin's method if none is judged.
HiddenMethod TruthCommand::judged_method() const {
  if (hidden.empty()) return HiddenMethod::franklin;
  std::vector<HiddenMethod> methods;
  for (const HiddenMethodEntry& entry : hidden_methods()) {
    if (finds_lines(entry.method)) methods.push_back(entry.method);
  }
  return method_among(hidden, methods,
                      "finds no lines, and its item buffer can be compared with that of --ids");
}

void TruthCommand::write_seen_lines(const DisplayFile& file, std::ostream& to) const {
  Progress progress("the truth of lines");
  dump(true_line_drawing(file, judged.threads, progress.told()), to);
}

int TruthCommand::judge_lines(const DisplayFile& file, std::string& report) const {
  Progress progress("the truth of lines");
  SurfacePlan plan = judged;
  plan.progress = progress.told();
  const JudgedLines found = judged_lines(file, plan, line_samples);
  const std::string places =
      found.samples == 0 ? "whole"
                         : fmt::format("at {} points, {} wrong", found.samples, found.wrong);
  report += fmt::format(
      "lines           {}, judged {}\npieces seen     {} by {}\ntotal length    {} of the "
      "picture's side\nmissing length  {}\nextra length    {}\n",
      found.lines, places, found.pieces, hidden, found.errors.length, found.errors.missing,
      found.errors.extra);
  return found.are_right() ? 0 : 1;
}

/// Standard output may be an output.
std::ostream& TruthCommand::reports() const {
  const bool is_output = ids == "-" || depth == "-" || seen_lines == "-";
  return is_output ? std::cerr : std::cout;
}

TruthCommand::From TruthCommand::judged_from() const {
  if (from.empty()) return ids.empty() ? From::display_file : From::entered;
  constexpr std::array<std::string_view, 3> kWords{"display-file", "world", "entered"};
  const auto* const word = std::ranges::find(kWords, from);
  if (word == kWords.end()) {
    throw Error(fmt::format("--from {}:{} expected display-file, world or entered", from,
                            did_you_mean(from, kWords)));
  }
  return static_cast<From>(word - kWords.begin());
}

}  // namespace displayfile
