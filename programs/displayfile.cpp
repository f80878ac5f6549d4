// The command `displayfile`: draws, dumps, checks and compares drawing programs and meshes.
// Exit status: 0 done, 1 a difference was found, 2 the input or the command line was wrong.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <thread>

#include "programs/bench_program.h"
#include "programs/check_command.h"
#include "programs/compare_command.h"
#include "programs/draw_command.h"
#include "programs/dump_command.h"
#include "programs/exit_status.h"
#include "programs/import_command.h"
#include "programs/truth_command.h"

namespace displayfile {
namespace {

int run(int argc, char** argv) {
  CLI::App app("A display-file, retained-mode 3D graphics system in the textbook style.",
               "displayfile");
  app.require_subcommand(1);
  std::function<int()> chosen;
  const auto add = [&](auto& command) {
    command.add_to(app).callback([&] { chosen = [&] { return command.run(); }; });
  };
  DrawCommand draw;
  DumpCommand dump;
  CheckCommand check;
  TruthCommand truth;
  CompareCommand compare;
  ImportCommand import;
  draw.options.threads = dump.threads = check.threads =
      static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  add(draw);
  add(dump);
  add(check);
  add(truth);
  add(compare);
  add(import);
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
