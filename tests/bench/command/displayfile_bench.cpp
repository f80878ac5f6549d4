// The program displayfile-bench, which `displayfile bench` starts in its own place: its command
// line is that of the command (tests/bench/command/bench.md).

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>

#include "clip/base/error.h"
#include "clip/system/descriptors.h"
#include "displayfile/mesh/mesh_file.h"
#include "programs/manual/asked_of_itself.h"
#include "programs/manual/help_format.h"
#include "programs/options/empty_values.h"
#include "programs/options/number_in.h"
#include "programs/options/work_limits.h"
#include "programs/process/bench_program.h"
#include "programs/process/exit_status.h"
#include "programs/process/stop_signals.h"
#include "tests/bench/command/bench_command.h"

namespace displayfile {
namespace {

constexpr std::array kNamedValues{NamedValues{"METHOD", bench::method_names, nullptr},
                                  NamedValues{"SCENE", bench::scene_names, nullptr},
                                  NamedValues{"MESH", nullptr, mesh_extensions}};

int run(int argc, char** argv) {
  CLI::App app("A display-file, retained-mode 3D graphics system in the textbook style.",
               "displayfile");
  app.formatter(std::make_shared<HelpFormat>());
  app.require_subcommand(1);
  BenchCommand bench;
  auto* command = app.add_subcommand("bench", kBenchDescription);
  command
      ->add_option("SCENE", bench.scenes.names,
                   "generated scenes, families of hard cases, drawing programs and meshes; by "
                   "default all generated scenes and hard cases")
      ->type_name("SCENE|FILE.draw|MESH");
  command
      ->add_option("-o,--output", bench.page,
                   "the page, .html; finished results are kept in PAGE.partial until then, and an "
                   "interrupted run continues from them")
      ->type_name("PAGE.html")
      ->capture_default_str();
  command->add_option("--json", bench.json, "the figures as JSON")->type_name("FIGURES.json");
  command->add_flag("--full", bench.scenes.full,
                    "more sizes, precisions and rounds: hours instead of minutes");
  auto* methods =
      command->add_option("--methods", bench.methods, "only these methods, separated by commas")
          ->type_name("METHOD,...")
          ->delimiter(',');
  command
      ->add_option(
          "--roundoff", bench.roundoffs,
          "EPS of the precisions roundoff=EPS measured besides exact, separated by commas, or none")
      ->type_name("EPS,...")
      ->delimiter(',');
  command->add_option("--threads", bench.threads, "numbers of threads, separated by commas")
      ->type_name("N,...")
      ->delimiter(',')
      ->transform(number_in(1, 1024));
  command
      ->add_option("--polygons", bench.scenes.polygons,
                   "numbers of polygons of generated scenes, separated by commas")
      ->type_name("N,...")
      ->delimiter(',')
      ->transform(number_in(std::size_t{1}, std::size_t{10'000'000}));
  command
      ->add_option("--sizes", bench.scenes.sizes,
                   "picture sizes in pixels per side, separated by commas")
      ->type_name("N,...")
      ->delimiter(',')
      ->transform(number_in(1, 16384));
  command->add_option("--seed", bench.scenes.seed, "seed of all generated scenes")
      ->type_name("N")
      ->transform(any_number<std::uint64_t>());
  command->add_option("--rounds", bench.rounds, "rounds of each ratio")
      ->type_name("N")
      ->transform(number_in(1, 1000));
  command
      ->add_option("--seconds", bench.most_seconds,
                   "time limit for the rounds of one ratio; hard cases take less")
      ->type_name("SECONDS")
      ->transform(number_in(0.001, 1e6));
  command->add_flag(
      "--features,!--no-features", bench.features,
      "measure the cost of each feature, off and on; by default only if no SCENE is given");
  command
      ->add_flag(
          "--moving-camera", bench.moving_camera,
          "only the table of new views of retained scenes: speed relative to OSMesa, wrong pixels, "
          "bytes per triangle, growth; pictures of 1024 pixels per side unless --sizes is set")
      ->excludes(methods);
  const AskedOfItself asked(argc, argv);
  WorkLimitWords limits;
  limits.add_to(*command, !asked.for_any_machine());
  command->add_flag("--features-under-callgrind", bench.features_under_callgrind)->group("");
  command->add_option("--beside", bench.beside)->group("");
  refuse_empty_values(*command);
  if (asked.anything()) {
    asked.tell(app, kNamedValues);
    return 0;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);
    throw Error(fmt::format("{}: displayfile bench --help lists all", e.what()));
  }
  const WorkLimitsInForce in_force(limits);
  return bench.run();
}

}  // namespace
}  // namespace displayfile

int main(int argc, char** argv) {
  displayfile::keep_standard_descriptors();
  displayfile::leave_nothing_when_stopped();
  return displayfile::exit_status(displayfile::run, argc, argv);
}
