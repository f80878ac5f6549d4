#include "programs/compare_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "clip/error.h"
#include "displayfile/file_extension.h"
#include "displayfile/input_file.h"
#include "displayfile/text/dump_compare.h"
#include "interp/files/npy_file.h"
#include "interp/files/picture_compare.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"

namespace displayfile {

namespace {

std::string measures(const PictureDifference& d) {
  if (!d.same_size) return "the sizes differ\n";
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

/// Marks the wrong pixels if that is asked for, and prints what was found; the exit status.
template <class Raster>
int report(const Raster& a, const Raster& b, const std::string& marks) {
  const PictureDifference difference = compare(a, b);
  if (!marks.empty()) write_png(marked(a, b), marks);
  std::cout << measures(difference);
  return difference.differs() ? 1 : 0;
}

}  // namespace

CLI::App& CompareCommand::add_to(CLI::App& app) {
  CLI::App& command =
      *app.add_subcommand("compare",
                          "Wrong pixels and largest difference of two pictures or .npy files, "
                          "or the first difference of two dumps; exit 1 if they differ");
  command.add_option("A", a)->required();
  command.add_option("B", b)->required();
  command.add_option("--marks", marks,
                     "picture (.png) of where: wrong pixels red, the rest light grey");
  return command;
}

int CompareCommand::run() const {
  const auto read_picture = [](const std::string& name) {
    return extension_of(name) == ".png" ? read_png(name) : read_ppm(name);
  };
  const auto is_picture = [](const std::string& name) {
    return extension_of(name) == ".png" || extension_of(name) == ".ppm";
  };
  const auto is_npy = [](const std::string& name) { return extension_of(name) == ".npy"; };
  if (is_picture(a) != is_picture(b) || is_npy(a) != is_npy(b)) {
    throw Error(fmt::format("{} and {}: expected two pictures, two .npy files or two dumps", a, b));
  }
  if (!marks.empty() && extension_of(marks) != ".png") {
    throw Error(fmt::format("{}: expected a .png file for the marks", marks));
  }
  if (is_picture(a)) return report(read_picture(a), read_picture(b), marks);
  if (is_npy(a)) return report(read_npy(a), read_npy(b), marks);
  if (!marks.empty()) throw Error(fmt::format("{} and {}: dumps have no pixels to mark", a, b));
  const auto difference = first_difference(read_text_file(a), read_text_file(b));
  std::cout << (difference ? *difference : std::string("no difference")) << '\n';
  return difference ? 1 : 0;
}

}  // namespace displayfile
