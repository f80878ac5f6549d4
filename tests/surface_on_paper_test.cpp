// Widths and letters of surfaces in units of length.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "interp/files/png_file.h"
#include "tests/command_fixture.h"

namespace {

using displayfile::Picture;

constexpr double kTrueLength = 0.01, kPointOnPaper = 25.4 / 72.0;  // mm

class SurfaceOnPaper : public Command {
 protected:
  /// An SVG on paper: lengths in mm.
  struct Lengths {
    std::set<std::string> widths;  ///< as written, in pixels
    std::set<std::string> letters;
    double pixel = 0.0;

    static bool all_are(const std::set<std::string>& written, double pixel, double length) {
      for (const std::string& number : written) {
        if (std::abs(std::strtod(number.c_str(), nullptr) * pixel - length) > kTrueLength) {
          return false;
        }
      }
      return !written.empty();
    }
    bool lines_are(double length) const { return all_are(widths, pixel, length); }
    bool letters_are(double length) const { return all_are(letters, pixel, length); }
  };
  Lengths lengths_of(const std::string& arguments) {
    EXPECT_EQ(run("surface " + arguments + " -o a.svg"), 0) << err_;
    const std::string svg = read(folder_ / "a.svg");
    Lengths found;
    const auto each = [&](const char* expression, auto take) {
      const std::regex what(expression);
      for (std::sregex_iterator m(svg.begin(), svg.end(), what); m != std::sregex_iterator(); ++m) {
        take((*m)[1].str());
      }
    };
    // The first width of the style sheet is that of all segments, which each style replaces.
    each("\\.l[0-9][^{]*\\{[^}]*stroke-width:([0-9.]+)", [&](const std::string& number) {
      if (number != "0") found.widths.insert(number);  // the legend's colours have no edges
    });
    each("font-size[:=]\"?([0-9.]+)",
         [&](const std::string& number) { found.letters.insert(number); });
    // The first one is that of the sheet.
    each("scale\\(([0-9.]+)\\)", [&](const std::string& number) {
      if (found.pixel == 0.0) found.pixel = std::strtod(number.c_str(), nullptr);
    });
    return found;
  }
};

TEST_F(SurfaceOnPaper, LinesAndLettersHaveTheirSizes) {
  for (const std::string surface :
       {"x*y --contours 4", "x*y --colour height", "x*y x --colour height --size 80x60mm"}) {
    const std::string paper = surface.find("--size") == surface.npos ? " --paper a6" : "";
    const auto in_points = lengths_of(surface + paper + " --line-width 0.4pt --text-size 7pt");
    EXPECT_TRUE(in_points.lines_are(0.4 * kPointOnPaper)) << surface;
    EXPECT_TRUE(in_points.letters_are(7.0 * kPointOnPaper)) << surface;
    const auto in_millimetres = lengths_of(surface + paper + " --line-width 0.3 --text-size 2");
    EXPECT_TRUE(in_millimetres.lines_are(0.3)) << surface;
    EXPECT_TRUE(in_millimetres.letters_are(2.0)) << surface;
  }
}

/// Also where they are larger than usual, and with a legend.
TEST_F(SurfaceOnPaper, LettersStayInThePicture) {
  for (const char* const size : {"4pt", "8pt", "9pt"}) {
    for (const char* const colours : {"", " --colour height --labels x,y,temperature"}) {
      const std::string arguments =
          fmt::format("'1000*x*y' --size 80x60mm --dpi 300 --text-size {}{}", size, colours);
      ASSERT_EQ(run("surface " + arguments + " -o a.png"), 0) << arguments << err_;
      const Picture picture = displayfile::read_png(folder_ / "a.png");
      for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
          const bool is_at_side =
              x == 0 || y == 0 || x == picture.width - 1 || y == picture.height - 1;
          if (!is_at_side) continue;
          ASSERT_EQ(picture.pixels[static_cast<std::size_t>(y * picture.width + x)], 0xFFFFFFFFu)
              << arguments << " at " << x << ' ' << y;
        }
      }
    }
  }
}

TEST_F(SurfaceOnPaper, ARecordedProgramHasTheSameSizes) {
  const std::string options = " --size 400x300 ";
  ASSERT_EQ(run("surface x*y -o a.svg --text-size 20 --line-width 2 --program s.draw" + options), 0)
      << err_;
  ASSERT_EQ(run("draw s.draw -o b.svg" + options), 0) << err_;
  EXPECT_EQ(read(folder_ / "a.svg"), read(folder_ / "b.svg"));
}

TEST_F(SurfaceOnPaper, WhatCannotBeIsRefusedByName) {
  const auto refuses = [&](const std::string& options, const std::string& message) {
    expect_error("surface x*y -o a.svg " + options, message);
  };
  refuses("--text-size 8pt", "--text-size 8pt: a length in pt needs a picture whose size in mm");
  refuses("--line-width 1mm", "--line-width 1mm: a length in mm needs a picture whose size in mm");
  refuses("--text-size 0", "--text-size 0: expected lengths above 0");
  refuses("--text-size big", "--text-size big: expected a length");
  refuses("--line-width -1", "--line-width -1: expected lengths above 0");
  refuses("--text-size 200", "--text-size: letters of 0.417 of the picture's height leave no room");
  refuses("--text-size 8 --no-axes", "--text-size 8: expected axes or --colour height");
  EXPECT_EQ(run("surface x*y -o a.svg --text-size 8 --no-axes --colour height"), 0) << err_;
}

}  // namespace
