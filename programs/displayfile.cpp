// The command `displayfile`: draws, dumps, checks and compares drawing programs and meshes.
// Exit status: 0 done, 1 a difference was found, 2 the input or the command line was wrong.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <functional>
#include <optional>
#include <span>
#include <thread>

#include "clip/error.h"
#include "displayfile/sorted_display_file.h"
#include "interp/raster/software.h"
#include "programs/bench_program.h"
#include "programs/commands.h"
#include "programs/exit_status.h"
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

/// For --help.
std::string listed(std::span<const Choice> choices) {
  std::string text;
  for (const Choice& choice : choices) {
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", choice.name, choice.what);
  }
  return text;
}

int run(int argc, char** argv) {
  CLI::App app("A display-file, retained-mode 3D graphics system in the textbook style.",
               "displayfile");
  app.require_subcommand(1);
  std::function<int()> chosen;

  DrawCommand draw;
  std::string size = "512x512";
  std::optional<std::string> turntable, pick;
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
  command->add_option("-o,--output", draw.output, "the picture: " + listed(picture_formats()))
      ->required();
  command->add_option("--size", size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  words.add_to(*command);
  command->add_option("--device", draw.options.device, listed(raster_devices()))
      ->capture_default_str();
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
  command->add_option("--pick", pick,
                      "X,Y[,REACH] in pixels from the upper left corner: print what is seen there, "
                      "a polygon, or a line or edge within REACH of it");
  command->add_option("--turntable", turntable,
                      "N views, turned evenly all around the view-up axis, from one BSP tree, "
                      "or with --hidden world-ray-cast from one tree of boxes: "
                      "OUT.png becomes OUT-000.png, OUT-001.png, ..., --ids and --depth likewise");
  command->add_option("--shading", shading, shading_words)->capture_default_str();
  command->add_flag("--stats", draw.stats, "print what was drawn");
  command->callback([&] {
    parse_size(size, draw.options.width, draw.options.height);
    const HiddenSurfaceOptions sorting = words.options(draw.options.threads);
    draw.options.hidden = sorting.method;
    draw.options.scope = sorting.scope;
    draw.options.precision = sorting.precision;
    require_raster_device(draw.options.device);
    draw.shading = displayfile::shading(shading);
    if (turntable) draw.turntable = turntable_views(*turntable);
    if (pick) draw.pick = pick_option(*pick);
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

  const CLI::App& bench = add_bench(app);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (bench.parsed()) start_bench(argv);  // that was --help
    return app.exit(e) == 0 ? 0 : 2;
  }
  if (bench.parsed()) start_bench(argv);
  return chosen();
}

}  // namespace
}  // namespace displayfile

int main(int argc, char** argv) { return displayfile::exit_status(displayfile::run, argc, argv); }
