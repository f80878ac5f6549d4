// The command `displayfile`: draws, dumps, checks and compares drawing programs and meshes.
// Exit status: 0 done, 1 a difference was found, 2 the input or the command line was wrong.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <functional>
#include <iostream>
#include <new>
#include <optional>
#include <thread>

#include "clip/error.h"
#include "displayfile/sorted_display_file.h"
#include "interp/raster/software.h"
#include "programs/bench/bench_command.h"
#include "programs/commands.h"
#include "programs/segment_outputs.h"
#include "programs/turntable_command.h"

namespace displayfile {
namespace {

void parse_size(const std::string& text, int& pixels_across, int& pixels_up) {
  long long width = 0, height = 0;
  const char *p = text.data(), *end = p + text.size();
  const auto w = std::from_chars(p, end, width);
  const bool cross = w.ec == std::errc{} && w.ptr != end && (*w.ptr == 'x' || *w.ptr == 'X');
  const auto h = cross ? std::from_chars(w.ptr + 1, end, height) : w;
  if (!cross || h.ec != std::errc{} || h.ptr != end) {
    throw Error(fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, such as 512x512", text));
  }
  require_picture_size(width, height);
  pixels_across = static_cast<int>(width);
  pixels_up = static_cast<int>(height);
}

int run(int argc, char** argv) {
  CLI::App app("A display-file, retained-mode 3D graphics system in the textbook style.",
               "displayfile");
  app.require_subcommand(1);
  std::function<int()> chosen;

  DrawCommand draw;
  std::string size = "512x512", device = "software";
  std::optional<std::string> turntable;
  std::string shading = "flat";
  const char* const shading_words =
      "flat, or gouraud for smooth meshes; what the inputs start with";
  HiddenSurfaceWords words;
  const int processors = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  draw.options.threads = processors;
  auto* command = app.add_subcommand("draw", "Draw drawing programs and meshes");
  command
      ->add_option("INPUT", draw.inputs,
                   "drawing programs (.draw, or - for standard input) and meshes")
      ->required();
  command->add_option("-o,--output", draw.output, "the picture: .png .ppm .svg .pdf")->required();
  command->add_option("--size", size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  words.add_to(*command);
  command->add_option("--device", device, "software or osmesa")->capture_default_str();
  command->add_option("--threads", draw.options.threads, "the picture is the same for any number")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--samples", draw.options.samples,
                   "antialiasing: the mean of N x N samples for each pixel")
      ->check(CLI::Range(1, kMostSamples))
      ->capture_default_str();
  command->add_flag("--explain", draw.explain, "say which method auto picked, and why");
  command->add_option("--ids", draw.options.ids,
                      "item buffer as .npy: the pick identifier seen, -1 for none");
  command->add_option("--depth", draw.options.depth,
                      "depth as .npy: of the fill seen, -inf for none");
  command->add_option("--turntable", turntable,
                      "N views, turned evenly all around the view-up axis, from one BSP tree: "
                      "OUT.png becomes OUT-000.png, OUT-001.png, ..., --ids and --depth likewise");
  command->add_option("--shading", shading, shading_words)->capture_default_str();
  command->add_flag("--stats", draw.stats, "print what was drawn");
  command->callback([&] {
    parse_size(size, draw.options.width, draw.options.height);
    const HiddenSurfaceOptions sorting = words.options(draw.options.threads);
    draw.options.hidden = sorting.method;
    draw.options.scope = sorting.scope;
    draw.options.precision = sorting.precision;
    if (device != "software" && device != "osmesa") {
      throw Error(fmt::format("--device {}: expected software or osmesa", device));
    }
    if (device == "osmesa") draw.options.device = RasterDevice::osmesa;
    draw.shading = displayfile::shading(shading);
    if (turntable) draw.turntable = turntable_views(*turntable);
    chosen = [&] { return draw.run(); };
  });

  DumpCommand dump;
  dump.threads = processors;
  dump.add_to(app).callback([&] { chosen = [&] { return dump.run(); }; });

  CheckCommand check;
  check.threads = processors;
  check.add_to(app).callback([&] { chosen = [&] { return check.run(); }; });

  TruthCommand truth;
  command = app.add_subcommand(
      "truth", "What is seen at each pixel, by exact arithmetic alone, whatever the methods do");
  command->add_option("INPUT", truth.inputs, "drawing programs and meshes")->required();
  command->add_option("--size", size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  command
      ->add_option("--ids", truth.ids, "item buffer as .npy: the pick identifier seen, -1 for none")
      ->required();
  command->add_option("--depth", truth.depth,
                      "depth as .npy: of the fill seen, rounded once, -inf for none");
  command->callback([&] {
    parse_size(size, truth.width, truth.height);
    chosen = [&] { return truth.run(); };
  });

  CompareCommand compare;
  command = app.add_subcommand("compare",
                               "Wrong pixels and largest difference of two pictures or .npy files, "
                               "or the first difference of two dumps; exit 1 if they differ");
  command->add_option("A", compare.a)->required();
  command->add_option("B", compare.b)->required();
  command->add_option("--marks", compare.marks,
                      "picture (.png) of where: wrong pixels red, the rest light grey");
  command->callback([&] { chosen = [&] { return compare.run(); }; });

  ImportCommand import;
  command = app.add_subcommand("import", "Write a drawing program from meshes");
  command->add_option("MESH", import.meshes)->required();
  command->add_option("-o,--output", import.output, "the drawing program, .draw")->required();
  command->add_option("--shading", shading, shading_words)->capture_default_str();
  command->callback([&] {
    import.shading = displayfile::shading(shading);
    chosen = [&] { return import.run(); };
  });

  BenchCommand bench;
  command = app.add_subcommand(
      "bench", "Speed against error of every method: a table, JSON, and a page with plots");
  command->add_option("SCENE", bench.scenes.names,
                      "generated scenes, families of hard cases, drawing programs and meshes; "
                      "default, as without any: all generated scenes and hard cases");
  command
      ->add_option("-o,--output", bench.page,
                   "the page, .html; what is finished is kept in "
                   "PAGE.partial until then, and an interrupted run "
                   "goes on from there")
      ->capture_default_str();
  command->add_option("--json", bench.json, "the figures for programs");
  command->add_option("--readme", bench.readme,
                      "rewrite the blocks of this file that are marked <!-- bench: NAME -->");
  command->add_flag("--full", bench.scenes.full,
                    "more sizes, precisions and rounds: hours instead of minutes");
  command->add_option("--methods", bench.methods, "only these, with commas between")
      ->delimiter(',');
  command
      ->add_option("--roundoff", bench.roundoffs,
                   "EPS of the precisions roundoff=EPS beside exact, with commas between, or none")
      ->delimiter(',');
  command->add_option("--threads", bench.threads, "numbers of threads, with commas between")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--polygons", bench.scenes.polygons, "of generated scenes, with commas between")
      ->delimiter(',')
      ->check(CLI::Range(std::size_t{1}, std::size_t{10'000'000}));
  command->add_option("--sizes", bench.scenes.sizes, "pixels a side, with commas between")
      ->delimiter(',')
      ->check(CLI::Range(1, 16384));
  command->add_option("--seed", bench.scenes.seed, "of all scenes that are generated");
  command->add_option("--rounds", bench.rounds, "of each ratio")->check(CLI::Range(1, 1000));
  command
      ->add_option("--seconds", bench.most_seconds,
                   "at most for the rounds of one ratio; hard cases take less")
      ->check(CLI::Range(0.001, 1e6));
  command->add_flag(
      "--features,!--no-features", bench.features,
      "what each feature costs, off and on; without it, only where no SCENE is named");
  command->add_flag("--features-under-callgrind", bench.features_under_callgrind)->group("");
  command->callback([&] { chosen = [&] { return bench.run(); }; });

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return chosen();
}

}  // namespace
}  // namespace displayfile

int main(int argc, char** argv) {
  try {
    return displayfile::run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::cerr << "displayfile: out of memory\n";
  } catch (const std::exception& e) {
    std::cerr << "displayfile: " << e.what() << '\n';
  }
  return 2;
}
