// The command `displayfile`: draws, dumps, checks and compares drawing programs and meshes.
// Exit status: 0 done, 1 a difference was found, 2 the input or the command line was wrong, or a
// limit was reached.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/nearest_word.h"
#include "clip/system/descriptors.h"
#include "clip/system/process_memory.h"
#include "programs/command/check_command.h"
#include "programs/command/compare_command.h"
#include "programs/command/draw_command.h"
#include "programs/command/dump_command.h"
#include "programs/command/export_command.h"
#include "programs/command/import_command.h"
#include "programs/command/page_command.h"
#include "programs/command/sheet_command.h"
#include "programs/command/steps_command.h"
#include "programs/command/surface_command.h"
#include "programs/command/truth_command.h"
#include "programs/inputs/mistaken_words.h"
#include "programs/inputs/picture_check.h"
#include "programs/manual/asked_of_itself.h"
#include "programs/manual/help_format.h"
#include "programs/options/empty_values.h"
#include "programs/options/named_values.h"
#include "programs/options/work_limits.h"
#include "programs/process/bench_program.h"
#include "programs/process/exit_status.h"
#include "programs/process/stop_signals.h"
#include "programs/process/version.h"

namespace displayfile {
namespace {

constexpr std::string_view kHelp = "help";
char help_option[] = "--help";

/// The command line, ended by a null pointer. `help` and `help COMMAND` are `--help` and
/// `COMMAND --help`.
std::vector<char*> command_line(int argc, char** argv) {
  std::vector<char*> words(argv, argv + argc);
  if (argc > 1 && words[1] == kHelp) {
    if (argc > 3) throw Error("help: expected one command, such as displayfile help draw");
    words.erase(words.begin() + 1);
    words.push_back(help_option);
  }
  words.push_back(nullptr);
  return words;
}

/// Throws Error if the first word is neither an option nor a command's name.
void require_known_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  names.emplace_back(kHelp);
  const std::string_view name = argv[1];
  if (std::ranges::find(names, name) != names.end()) return;
  if (std::error_code error; std::filesystem::is_regular_file(name, error)) {
    throw Error(fmt::format("unknown command '{}': it is a file: expected {} before it", name,
                            fmt::join(names, ", ")));
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw Error(fmt::format("unknown command '{}':{} expected one of {}", name,
                          did_you_mean(name, known), fmt::join(names, " ")));
}

/// The message about an option that the command does not have, otherwise about the error.
std::string wrong_command_line(const CLI::App& app, const CLI::ParseError& error) {
  const auto chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::string help =
      (chosen.empty() ? "" : app.get_name() + " ") + command.get_name() + " --help lists all";
  const std::vector<std::string> extras = app.remaining(true);
  const auto starts_with_dash = [](const std::string& word) {
    return word.starts_with('-') && word != "--";  // which ends the options
  };
  const auto unknown = std::ranges::find_if(extras, starts_with_dash);
  if (unknown == extras.end()) return fmt::format("{}: {}", error.what(), help);
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string name = unknown->substr(0, unknown->find('='));
  if (command.get_name() == "surface" && !name.starts_with("--")) {
    return fmt::format(
        "unknown option '{}': put an expression that begins with - in parentheses; {}", *unknown,
        help);
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  return fmt::format("unknown option '{}':{} {}", name, did_you_mean(name, known), help);
}

/// An input that is no file may be the value of an option.
void require_no_mistaken_values(const CLI::App& app, int argc, char** argv) {
  for (const CLI::App* command : app.get_subcommands()) {
    for (const CLI::Option* option : command->get_options()) {
      if (!option->get_positional() || option->get_items_expected_max() <= 1) continue;
      return displayfile::require_no_mistaken_values(
          *command, std::span(argv, static_cast<std::size_t>(argc)).subspan(2));
    }
  }
}

/// Gives it all processors, if it has threads, and `check` the check of pictures.
template <class Command>
void prepare(Command& command) {
  const auto all = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  if constexpr (requires { command.hidden_surfaces.surfaces.threads; }) {
    command.hidden_surfaces.surfaces.threads = all;
  } else if constexpr (requires { command.judged.threads; }) {
    command.judged.threads = all;
  } else if constexpr (requires { command.threads; }) {
    command.threads = all;
  }
  if constexpr (requires { command.other; }) command.other = std::make_shared<PictureCheck>();
}

/// The parser to which commands are added, and their common state.
struct CommandLine {
  CLI::App& app;
  const AskedOfItself& asked;
  WorkLimitWords& limits;
  std::function<int()>& chosen;  ///< runs the command that the words name
};

template <class Command>
void add(const CommandLine& line) {
  const auto command = std::make_shared<Command>();
  prepare(*command);
  CLI::App& subcommand = command->add_to(line.app);
  if (line.asked.subcommand() == subcommand.get_name()) {
    line.limits.add_to(subcommand, !line.asked.for_any_machine());
    refuse_empty_values(subcommand);
  }
  subcommand.callback([command, &limits = line.limits, &chosen = line.chosen] {
    chosen = [command, &limits] {
      const WorkLimitsInForce in_force(limits);
      return command->run();
    };
  });
}

/// All but bench, which is another program's.
struct NamedCommand {
  std::string_view name;
  void (*add)(const CommandLine& line);
};
constexpr NamedCommand kCommands[] = {
    {"draw", add<DrawCommand>},       {"dump", add<DumpCommand>},
    {"check", add<CheckCommand>},     {"truth", add<TruthCommand>},
    {"compare", add<CompareCommand>}, {"import", add<ImportCommand>},
    {"export", add<ExportCommand>},   {"surface", add<SurfaceCommand>},
    {"sheet", add<SheetCommand>},     {"steps", add<StepsCommand>},
    {"page", add<PageCommand>}};

int run(int count, char** as_given) {
  std::vector<char*> words = command_line(count, as_given);
  const int argc = static_cast<int>(words.size()) - 1;
  char** const argv = words.data();
  CLI::App app("A display-file, retained-mode 3D graphics system in the textbook style.",
               "displayfile");
  app.formatter(std::make_shared<HelpFormat>());
  app.set_version_flag("--version", version, "Print the version and the libraries that were found");
  app.require_subcommand(1);
  app.footer("displayfile help COMMAND lists a command's options.");
  std::function<int()> chosen;
  WorkLimitWords limits;
  const AskedOfItself asked(argc, argv);
  const CommandLine line{app, asked, limits, chosen};
  // The options of the others would only take time at every start.
  const auto is_named = [&](const NamedCommand& command) { return command.name == argv[1]; };
  const bool wants_all = asked.anything() || argc < 2 || std::ranges::none_of(kCommands, is_named);
  for (const NamedCommand& command : kCommands) {
    if (wants_all || is_named(command)) command.add(line);
  }
  const CLI::App& bench = add_bench(app);

  if (asked.anything()) {
    if (asked.of_subcommand(bench)) start_bench(argv);
    asked.tell(app, named_values());
    return 0;
  }
  if (argc == 1) {
    std::cerr << app.help();
    return 2;
  }
  require_known_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (bench.parsed()) start_bench(argv);  // that was --help
    if (e.get_exit_code() == 0) return app.exit(e);
    throw Error(wrong_command_line(app, e));
  }
  if (bench.parsed()) start_bench(argv);
  require_no_mistaken_values(app, argc, argv);
  return chosen();
}

}  // namespace
}  // namespace displayfile

int main(int argc, char** argv) {
  displayfile::keep_standard_descriptors();
  displayfile::keep_freed_memory();
  displayfile::leave_nothing_when_stopped();
  return displayfile::exit_status(displayfile::run, argc, argv);
}
