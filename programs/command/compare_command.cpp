#include "programs/command/compare_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/text/dump_compare.h"
#include "interp/files/npy_file.h"
#include "interp/files/picture_compare.h"
#include "interp/files/png_file.h"
#include "programs/inputs/output_paths.h"

namespace displayfile {

namespace {

/// Returns the text that compares two pictures or two arrays, `first` and `second`.
template <class Pixels>
std::string measures(const PictureDifference& d, const Pixels& first, const Pixels& second) {
  if (!d.same_size) {
    return fmt::format("the sizes differ: {}x{} and {}x{}\n", first.width, first.height,
                       second.width, second.height);
  }
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

void require_no_vectors(const std::string& name) {
  const std::string extension = extension_of(name);
  if (extension == ".svg" || extension == ".pdf" || extension == ".eps") {
    throw Error(fmt::format(
        "{}: vectors are not compared: expected a picture of pixels, a .npy file or a dump", name));
  }
}

}  // namespace

CLI::App& CompareCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "compare",
      "Print wrong pixels and largest difference of two pictures or .npy files, or the first "
      "difference of two dumps; exit with 1 if they differ");
  command.add_option("A", a)->type_name("FILE")->required();
  command.add_option("B", b)->type_name("FILE")->required();
  command
      .add_option("--marks", marks,
                  "picture (.png) that marks wrong pixels red, the rest light grey")
      ->type_name("MARKS.png");
  tolerance.add_to(command);
  return command;
}

int CompareCommand::run() const {
  for (const std::string& name : {a, b}) require_no_vectors(name);
  const auto is_npy = [](const std::string& name) { return extension_of(name) == ".npy"; };
  if (is_picture_file(a) != is_picture_file(b) || is_npy(a) != is_npy(b)) {
    throw Error(fmt::format("{} and {}: expected two pictures, two .npy files or two dumps", a, b));
  }
  if (!marks.empty() && extension_of(marks) != ".png") {
    throw Error(fmt::format("{}: expected a .png file for the marks", marks));
  }
  if (a == "-" && b == "-") throw Error("-: standard input is read twice: expected it once");
  const std::array<std::string, 2> inputs{a, b};
  require_files_of_their_own({marks}, inputs);
  const auto print = [](const std::string& text, bool passes) {
    std::cout << text;
    return passes ? 0 : 1;
  };
  tolerance.require_number();
  if (is_picture_file(a)) {
    const Picture first = read_picture(a), second = read_picture(b);
    const PictureDifference difference = displayfile::compare(first, second, tolerance.channel);
    if (!marks.empty()) write_png(marked(first, second, tolerance.channel), marks);
    return print(measures(difference, first, second), tolerance.passes(difference));
  }
  if (tolerance.is_set()) {
    throw Error(fmt::format("{} and {}: --tolerance and --wrong-pixels apply to pictures", a, b));
  }
  if (is_npy(a)) {
    const NpyArray first = read_npy(a), second = read_npy(b);
    const PictureDifference difference = displayfile::compare(first, second);
    if (!marks.empty()) write_png(marked(first, second), marks);
    return print(measures(difference, first, second), !difference.differs());
  }
  if (!marks.empty()) throw Error(fmt::format("{} and {}: dumps have no pixels to mark", a, b));
  const std::string first = read_text_file(a), second = read_text_file(b);
  const auto difference = first_difference(first, second, input_name(a), input_name(b));
  std::cout << (difference ? *difference : std::string("no difference")) << '\n';
  return difference ? 1 : 0;
}

}  // namespace displayfile
