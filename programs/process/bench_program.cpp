#include "programs/process/bench_program.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "clip/base/error.h"
#include "clip/system/own_files.h"

namespace displayfile {

CLI::App& add_bench(CLI::App& app) {
  CLI::App& bench = *app.add_subcommand("bench", kBenchDescription);
  bench.prefix_command();
  bench.set_help_flag();
  return bench;
}

void start_bench(char** argv) {
  std::error_code unknown;
  const auto own_folder = file_of_program(unknown).parent_path();
  const std::array places{own_folder / "displayfile-bench",
                          (own_folder / DISPLAYFILE_BENCH_FOLDER / "displayfile-bench")};
  int why = 0;
  for (const auto& program : places) {
    replace_program(program, argv);
    if (errno != ENOENT) why = errno;
  }
  throw Error(fmt::format("bench: {} cannot be started, nor {}: {}", places[0].string(),
                          places[1].lexically_normal().string(),
                          why == 0 ? "neither is there (its target is displayfile_bench_program)"
                                   : std::strerror(why)));
}

}  // namespace displayfile
