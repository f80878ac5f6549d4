#include "programs/command/check_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <sstream>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/files.h"
#include "displayfile/text/dump_compare.h"
#include "programs/inputs/each_input.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/made_folders.h"
#include "programs/inputs/mistaken_words.h"
#include "programs/inputs/output_name.h"
#include "programs/inputs/output_paths.h"
#include "programs/inputs/program_place.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"
#include "programs/options/picture_tolerance.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

namespace fs = std::filesystem;

/// Compares the instructions in an input's segments with a dump.
class InstructionCheck : public GoldenCheck {
 public:
  explicit InstructionCheck(const CheckedInputs& inputs) : inputs_(inputs) {}

  std::string_view extension() const override { return ".txt"; }
  void read_golden(const std::string& file, const std::string& with) override {
    if (is_picture_file(file)) {
      throw Error(fmt::format("{}: a picture: expected --picture too, or a dump", file));
    }
    if (is_drawing_program(file)) {
      const DrawnFile of_program = drawn(with_common(with, {{file}}).front());
      golden_ = dump(of_program.file, of_program.fills);
    } else {
      golden_ = read_text_file(file);
      require_dump(golden_, file);
    }
  }
  std::optional<GoldenDifference> difference(const Figure& figure) const override {
    const DrawnFile of_figure = drawn(figure);
    const std::string dumped = dump(of_figure.file, of_figure.fills);
    const auto found = find_difference(dumped, golden_);
    if (!found) return std::nullopt;
    const auto line =
        program_line_of(*found, {figure, of_figure.file, dumped}, inputs_.meshes, aspect());
    return GoldenDifference{found->text, line.value_or(0)};
  }
  void update(const Figure& figure, const std::string& golden) const override {
    const DrawnFile of_figure = drawn(figure);
    update_golden(of_figure.file, golden, of_figure.fills);
  }

 private:
  double aspect() const { return inputs_.size.size.empty() ? 1.0 : inputs_.size.aspect(); }
  DrawnFile drawn(const Figure& figure) const {
    return as_drawn(figure, inputs_.hidden_surfaces, inputs_.meshes, aspect());
  }

  const CheckedInputs& inputs_;
  std::string golden_;  // a dump
};

std::string flat_name(const std::string& input, std::string_view extension) {
  if (input == "-") throw Error("check needs files: the golden file is named after its input");
  return fs::path(input).stem().string() + std::string(extension);
}

void require_golden(const std::string& file, const std::string& input) {
  if (fs::exists(file)) return;
  if (input != "-" && !fs::exists(input)) throw Error(fmt::format("{}: no such file", input));
  throw Error(fmt::format("{}: there is no golden file {}: --update writes it", input, file));
}

enum class Verdict { passed, written, differs, bad };

struct Row {
  Verdict verdict;
  std::string input, text;
};

std::string table(std::span<const Row> rows) {
  std::size_t widest = 0;
  for (const Row& row : rows) widest = std::max(widest, row.input.size());
  std::string text;
  for (const auto& [verdict, input, what] : rows) {
    const char* const word = verdict == Verdict::passed    ? "passed "
                             : verdict == Verdict::written ? "written"
                             : verdict == Verdict::bad     ? "bad    "
                                                           : "differs";
    text += what.empty() ? fmt::format("{}  {}\n", word, input)
                         : fmt::format("{}  {:<{}}  {}\n", word, input, widest, what);
  }
  return text;
}

std::vector<Row> those_that_fail(std::span<const Row> rows) {
  std::vector<Row> failing;
  std::ranges::copy_if(rows, std::back_inserter(failing), [](const Row& row) {
    return row.verdict == Verdict::differs || row.verdict == Verdict::bad;
  });
  return failing;
}

std::string totals(std::span<const Row> rows) {
  const auto count = [&](Verdict verdict) {
    return std::ranges::count(rows, verdict, &Row::verdict);
  };
  if (count(Verdict::written) > 0) {
    return fmt::format("{} inputs: {} golden files written, {} bad\n", rows.size(),
                       count(Verdict::written), count(Verdict::bad));
  }
  return fmt::format("{} input{}: {} passed, {} differ, {} bad\n", rows.size(),
                     rows.size() == 1 ? "" : "s", count(Verdict::passed), count(Verdict::differs),
                     count(Verdict::bad));
}

/// The message without the input's name before it, which the table has. A place in the file stays.
std::string without_name(const std::string& message, const std::string& input) {
  if (!message.starts_with(input + ":")) return message;
  const std::string rest = message.substr(input.size() + 1);
  return rest.starts_with(' ') ? rest.substr(1) : rest;
}

/// A difference in the form that follows the input's name and a colon: with the line in the input,
/// if it is known. Empty if there is none.
std::string after_name(const std::optional<GoldenDifference>& difference) {
  if (!difference) return "";
  return difference->line == 0 ? " " + difference->text
                               : fmt::format("{}: {}", difference->line, difference->text);
}

}  // namespace

CLI::App& CheckCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("check",
                                          "Compare each input's dump with a golden file; on a "
                                          "difference report the first one and exit with 1");
  add_inputs(command, "INPUT", inputs, "drawing programs and meshes");
  add_with(command, with);
  command
      .add_option("--golden", golden,
                  "folder of golden files, NAME.txt for NAME.draw, or FOLDER/NAME.txt where inputs "
                  "in several folders share a name; or one golden file or drawing program to "
                  "compare all inputs with")
      ->type_name("FOLDER|FILE")
      ->required()
      ->group(kGoldenOptions);
  command.add_flag("--update", update, "write the golden files")->group(kGoldenOptions);
  command
      .add_flag("--summary", summary,
                "print a table of all inputs: passed, differs and how, or bad; with totals")
      ->group(kReportOptions);
  command
      .add_flag(
          "--quiet", quiet,
          "no warnings and no progress; at the end a table of inputs that do not pass, if any")
      ->group(kReportOptions);
  if (other != nullptr) other->add_to(command);
  hidden_surfaces.add_to(command);
  command
      .add_option("--size", size.size,
                  "in pixels; by default for pictures the size of the golden picture, and 512x512 "
                  "with --update; for instructions a square")
      ->type_name("WIDTHxHEIGHT")
      ->group(kPictureOptions);
  command
      .add_option("--threads", hidden_surfaces.surfaces.threads,
                  "the result is the same for any number")
      ->type_name("N")
      ->transform(number_in(1, 1024))
      ->group(kPictureOptions);
  meshes.add_to(command);
  return command;
}

bool CheckCommand::is_one_file() const {
  if (fs::exists(golden)) return !fs::is_directory(golden);
  const std::string extension = extension_of(golden);
  return extension == ".txt" || extension == ".png" || extension == ".draw";
}

/// The golden file of each input; `golden` is a folder.
std::vector<std::string> CheckCommand::golden_files(std::string_view extension) const {
  std::map<std::string, int> of_that_name;
  for (const std::string& input : inputs) ++of_that_name[flat_name(input, extension)];
  std::map<std::string, std::string> input_of;
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    const std::string flat = flat_name(input, extension);
    const fs::path in_folder = fs::path(golden) / folder_within(input) / flat;
    const bool keeps_folder = of_that_name[flat] > 1 || fs::exists(in_folder);
    files.push_back((keeps_folder ? in_folder : fs::path(golden) / flat).string());
    const auto [other_input, is_new] = input_of.emplace(files.back(), input);
    if (!is_new) {
      throw Error(fmt::format("{} and {}: two inputs have the golden file {}", other_input->second,
                              input, files.back()));
    }
  }
  return files;
}

int CheckCommand::run() {
  const std::vector<std::string> lists = input_lists(inputs);
  const std::vector<Figure> figures = with_common(with, input_figures(inputs));
  inputs = figure_names(figures);
  CheckedInputs checked{hidden_surfaces.options(), meshes, size};
  checked.meshes.lines = hidden_surfaces.line_selection();
  checked.meshes.touching = hidden_surfaces.touching;
  checked.meshes.options();  // all words are understood before any work is done
  if (!checked.size.size.empty()) checked.size.aspect();
  InstructionCheck instructions(checked);
  GoldenCheck& check = other != nullptr && other->asked_for(checked)
                           ? static_cast<GoldenCheck&>(*other)
                           : instructions;
  const bool one_file = is_one_file();
  if (one_file && update && (inputs.size() > 1 || is_drawing_program(golden))) {
    throw Error(
        fmt::format("{}: --update writes a golden file for each input: expected a folder", golden));
  }
  if (one_file && update && extension_of(golden) != check.extension()) {
    throw Error(fmt::format("{}: expected a golden file that ends in {}, or a folder", golden,
                            check.extension()));
  }
  const std::vector<std::string> files =
      one_file ? std::vector(inputs.size(), golden) : golden_files(check.extension());
  if (update) require_files_of_their_own(files, inputs_of(figures), lists);
  if (quiet) Progress::show_none();
  if (one_file && !update) {
    require_golden(golden, inputs.front());
    std::ostringstream unheard;
    std::optional<CollectedWarnings> collected;
    if (quiet) collected.emplace(unheard);
    check.read_golden(golden, with);
  }
  const bool in_a_table = summary || quiet;
  MadeFolders folders;
  std::vector<Row> rows;
  for_each_input(
      inputs, 1, "checking",
      [&](std::size_t k) -> std::string {
        for (const std::string& input : figures[k]) require_no_folder_or_pattern(input);
        if (update) {
          folders.make_for(files[k]);
          check.update(figures[k], files[k]);
          return "";
        }
        if (!one_file) {
          require_golden(files[k], inputs[k]);
          check.read_golden(files[k], with);
        }
        return after_name(check.difference(figures[k]));
      },
      [&](std::size_t k, const InputResult& result) {
        if (!quiet) std::cerr << result.warnings;
        const bool bad = !result.error.empty();
        const Verdict verdict = bad                   ? Verdict::bad
                                : update              ? Verdict::written
                                : result.text.empty() ? Verdict::passed
                                                      : Verdict::differs;
        if (bad && !in_a_table) std::cerr << "displayfile: " << result.error << '\n';
        if (verdict == Verdict::differs && !in_a_table) {
          std::cout << inputs[k] << ':' << result.text << '\n';
        }
        const std::string what = bad ? result.error : inputs[k] + ':' + result.text;
        rows.push_back(
            {verdict, inputs[k], result.text.empty() && !bad ? "" : without_name(what, inputs[k])});
      });
  const bool any_bad = std::ranges::find(rows, Verdict::bad, &Row::verdict) != rows.end();
  const bool any_differs = std::ranges::find(rows, Verdict::differs, &Row::verdict) != rows.end();
  if (in_a_table) std::cout << table(quiet ? those_that_fail(rows) : rows);
  if (summary || (rows.size() > 1 && (any_bad || any_differs))) std::cout << totals(rows);
  return any_bad ? 2 : any_differs ? 1 : 0;
}

}  // namespace displayfile
