// Sizes on paper by the command: --scale, --unit, --paper, --size in mm and --dpi, measured in the
// files; and views that many parts share.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include "interp/files/png_file.h"
#include "tests/command_fixture.h"

namespace {

using displayfile::Picture;

constexpr double kTolerance = 0.01;  // mm

/// The extents of the lines of a picture on paper, in mm from the upper left corner of the sheet.
struct Measured {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  double line_width = 0.0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// x' = a x + c y + e, y' = b x + d y + f.
struct Matrix {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;
};

/// The data of a path of straight lines.
void measure_path(const std::string& data, const Matrix& m, Measured& measured) {
  double x = 0.0, y = 0.0;
  char command = 'M';
  const auto number = [](const char*& p) {
    char* end = nullptr;
    const double value = std::strtod(p, &end);
    p = end;
    return value;
  };
  for (const char* p = data.c_str(); *p != 0;) {
    if (std::isalpha(static_cast<unsigned char>(*p)) != 0) {
      command = *p++;
    } else if (*p == ' ' || *p == ',') {
      ++p;
    } else {
      const bool is_relative = std::islower(static_cast<unsigned char>(command)) != 0;
      const double first = number(p);
      if (command == 'h') {
        x += first;
      } else if (command == 'v') {
        y += first;
      } else {
        while (*p == ' ' || *p == ',') ++p;
        const double second = number(p);
        x = is_relative ? x + first : first;
        y = is_relative ? y + second : second;
      }
      const double to_x = m.a * x + m.c * y + m.e, to_y = m.b * x + m.d * y + m.f;
      measured.left = std::min(measured.left, to_x);
      measured.right = std::max(measured.right, to_x);
      measured.top = std::min(measured.top, to_y);
      measured.bottom = std::max(measured.bottom, to_y);
    }
  }
}

/// All matches of an expression in a text.
std::vector<std::smatch> matches(const std::string& text, const char* expression) {
  const std::regex pattern(expression);
  return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

double number_of(const std::string& text) { return std::stod(text); }

/// A file of --paper: pixels on a sheet in mm.
Measured measured_svg(const std::string& svg) {
  Measured measured;
  const auto place = matches(svg, "<g transform=\"translate\\(([^ ]+) ([^)]+)\\) scale\\(([^)]+)");
  EXPECT_EQ(place.size(), 1u) << svg.substr(0, 500);
  if (place.size() != 1) return measured;
  const double pixel = number_of(place[0][3]);
  const Matrix on_sheet{pixel, 0, 0, pixel, number_of(place[0][1]), number_of(place[0][2])};
  for (const auto& path : matches(svg, "<path class=\"l[^\"]*\" d=\"([^\"]+)\"")) {
    measure_path(path[1], on_sheet, measured);
  }
  const auto width = matches(svg, "\\.l1[^{]*\\{stroke:[^;]+;stroke-width:([0-9.e-]+)");
  EXPECT_FALSE(width.empty());
  if (!width.empty()) measured.line_width = pixel * number_of(width[0][1]);
  return measured;
}

/// As poppler reads the PDF: in points.
Measured measured_pdf(const std::string& svg_of_pdf) {
  constexpr double kPoint = 25.4 / 72.0;
  Measured measured;
  const auto attribute = [](const std::string& element, const char* expression) {
    const auto found = matches(element, expression);
    return found.empty() ? std::string() : found[0][1].str();
  };
  for (const auto& path : matches(svg_of_pdf, "<path [^>]*/>")) {
    const std::string element = path[0];
    const std::string width = attribute(element, "stroke-width[:=]\"?([0-9.]+)");
    if (width.empty()) continue;
    const auto m = matches(element, "matrix\\(([^,]+),([^,]+),([^,]+),([^,]+),([^,]+),([^)]+)");
    Matrix matrix;
    if (!m.empty()) {
      matrix = {number_of(m[0][1]), number_of(m[0][2]), number_of(m[0][3]),
                number_of(m[0][4]), number_of(m[0][5]), number_of(m[0][6])};
    }
    measured.line_width = number_of(width) * std::hypot(matrix.a, matrix.b) * kPoint;
    for (double* const entry : {&matrix.a, &matrix.b, &matrix.c, &matrix.d, &matrix.e, &matrix.f}) {
      *entry *= kPoint;
    }
    measure_path(attribute(element, " d=\"([^\"]+)\""), matrix, measured);
  }
  return measured;
}

class PaperCommand : public Command {
 protected:
  PaperCommand() {
    write("plate.draw",
          "set-window -50 50 -30 30\nset-window-fit widen\nset-line-style solid 0 0 0 1\n"
          "open-segment 1\n"
          "move-abs-3 -40 -20 0\nline-abs-3 40 -20 0\nline-abs-3 40 20 0\nline-abs-3 -40 20 0\n"
          "line-abs-3 -40 -20 0\nclose-segment\n");
    write("square.draw",
          "set-window -1 1 -1 1\nset-line-style solid 0 0 0 1\nopen-segment 1\n"
          "move-abs-2 -0.5 -0.5\nline-abs-2 0.5 -0.5\nline-abs-2 0.5 0.5\nline-abs-2 -0.5 0.5\n"
          "line-abs-2 -0.5 -0.5\nclose-segment\n");
    write_box("box.obj", 60, 30, 20);
  }
  /// From the origin.
  void write_box(const std::string& name, double x, double y, double z) {
    std::string text;
    for (int k = 0; k < 8; ++k) {
      text += fmt::format("v {} {} {}\n", (k & 1) != 0 ? x : 0.0, (k & 2) != 0 ? y : 0.0,
                          (k & 4) != 0 ? z : 0.0);
    }
    write(name, text + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 2 4 8 6\nf 1 5 7 3\n");
  }
  Measured svg_of(const std::string& arguments) {
    EXPECT_EQ(run("draw " + arguments + " -o a.svg"), 0) << err_;
    return measured_svg(read(folder_ / "a.svg"));
  }
  Picture png_of(const std::string& arguments) {
    EXPECT_EQ(run("draw " + arguments + " -o a.png"), 0) << err_;
    return displayfile::read_png(folder_ / "a.png");
  }
  /// Pixels per metre that a PNG states; 0: none.
  unsigned density(const std::string& name) {
    const std::string png = read(folder_ / name);
    const std::size_t at = png.find("pHYs");
    if (at == png.npos) return 0;
    unsigned value = 0;
    for (std::size_t k = 4; k < 8; ++k) {
      value = value << 8 | static_cast<unsigned char>(png[at + k]);
    }
    EXPECT_EQ(png[at + 12], 1);  // the metre is the unit
    EXPECT_EQ(png.substr(at + 4, 4), png.substr(at + 8, 4));
    return value;
  }
};

/// Columns and rows with anything that is not white: first and last.
struct Drawn {
  int left, right, top, bottom;
};
Drawn drawn_in(const Picture& picture) {
  Drawn drawn{picture.width, -1, picture.height, -1};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.pixels[static_cast<std::size_t>(y * picture.width + x)] == 0xFFFFFFFFu) continue;
      drawn.left = std::min(drawn.left, x);
      drawn.right = std::max(drawn.right, x);
      drawn.top = std::min(drawn.top, y);
      drawn.bottom = std::max(drawn.bottom, y);
    }
  }
  return drawn;
}

constexpr const char* kLines = " --hidden franklin --parallel --eye 0,0";

TEST_F(PaperCommand, AScaleIsExactInTheMiddleOfTheSheet) {
  for (const auto& [scale, factor] : {std::pair("1:1", 1.0), {"1:2", 0.5}, {"3:2", 1.5}}) {
    for (const char* const paper : {"a4", "a4-landscape", "300x200", "a0", "letter --margin 3"}) {
      const Measured plate = svg_of(fmt::format("plate.draw --paper {} --scale {}", paper, scale));
      SCOPED_TRACE(fmt::format("{} {}", paper, scale));
      EXPECT_NEAR(plate.width(), 80.0 * factor, kTolerance);
      EXPECT_NEAR(plate.height(), 40.0 * factor, kTolerance);
      EXPECT_EQ(err_, "");
    }
  }
  for (const char* const size : {"", " --size 100x100"}) {  // of large pixels
    write("filled.draw",
          "set-window -50 50 -50 50\nopen-segment 1\nset-fill-style solid 0 0 0\n"
          "polygon-abs-2 -41.23 -20.77  40.11 -20.77  0.1 19.33\nclose-segment\n");
    ASSERT_EQ(
        run(std::string("draw filled.draw --hidden map --paper a0 --scale 1:1 -o a.svg") + size), 0)
        << err_;
    const std::string svg = read(folder_ / "a.svg");
    const auto unit = matches(svg, "transform=\"scale\\(([^)]+)"),
               path = matches(svg, "class=\"f1[^\"]*\" d=\"([^\"]+)");
    const auto place = matches(svg, "translate\\([^)]+\\) scale\\(([^)]+)");
    ASSERT_EQ(path.size(), 1u) << svg;
    const double step = number_of(unit.at(0)[1]) * number_of(place.at(0)[1]);
    Measured filled;
    measure_path(path[0][1], {step, 0, 0, step, 0, 0}, filled);
    EXPECT_NEAR(filled.width(), 81.34, kTolerance) << size;
    EXPECT_NEAR(filled.height(), 40.1, kTolerance) << size;
  }
  const Measured plate = svg_of("plate.draw --paper a4 --scale 1:1");
  EXPECT_NEAR(plate.left + plate.right, 210.0, 2.0 * kTolerance);
  EXPECT_NEAR(plate.top + plate.bottom, 297.0, 2.0 * kTolerance);
  const Measured sized = svg_of("plate.draw --paper a4 --size 300x200 --scale 1:1");
  EXPECT_NEAR(sized.width(), 80.0, kTolerance);
  const Measured sheet = svg_of("plate.draw --size 120x80mm --scale 1:1");
  EXPECT_NEAR(sheet.width(), 80.0, kTolerance);
  EXPECT_NEAR(sheet.left, 20.0, kTolerance);
  const Measured placed = svg_of("plate.draw --paper a4-portrait --size 120x80mm --scale 1:1");
  EXPECT_NEAR(placed.width(), 80.0, kTolerance);
  EXPECT_NEAR(placed.left, 65.0, kTolerance);
}

/// An image transformation changes the size in the picture.
TEST_F(PaperCommand, ImagesOfOtherScalesAreNamed) {
  const std::string plate = read(folder_ / "plate.draw");
  const std::string options = " --paper a4 --scale 1:1 -o a.svg";
  write("other.draw", plate + "set-image-scale 1 0.5 0.5\n");
  ASSERT_EQ(run("draw other.draw" + options), 0) << err_;
  EXPECT_NE(err_.find("a.svg: --scale 1:1: not that of segment 1, which set-image-scale changes"),
            std::string::npos)
      << err_;
  write("moved.draw", plate + "set-image-translation 1 0.1 0.1\nset-image-rotation 1 90\n");
  ASSERT_EQ(run("draw moved.draw" + options), 0) << err_;
  EXPECT_EQ(err_.find("--scale"), std::string::npos) << err_;
}

/// Sheets in pixels have a margin around the picture, in which a pick's pixels are.
TEST_F(PaperCommand, ASheetInPixelsHasNoPick) {
  expect_error("draw plate.draw -o a.png --paper a4 --dpi 50 --pick 10,10",
               "--pick: a sheet of paper in pixels has no pick");
  EXPECT_EQ(run("draw plate.draw -o a.png --dpi 50 --size 40x40mm --pick 10,10"), 0) << err_;
}

TEST_F(PaperCommand, AScaleIsInUnitsOfTheScene) {
  EXPECT_NEAR(svg_of("plate.draw --paper a4 --scale 1:10 --unit cm").width(), 80.0, kTolerance);
  EXPECT_NEAR(svg_of("plate.draw --paper a4 --scale 1:1000 --unit m").width(), 80.0, kTolerance);
  EXPECT_NEAR(svg_of("plate.draw --paper a4 --scale 1:25.4 --unit in").width(), 80.0, kTolerance);
  EXPECT_NEAR(svg_of("plate.draw --paper a4 --scale 1:1 --unit mm").width(), 80.0, kTolerance);
}

TEST_F(PaperCommand, MeshesAndPensHaveAScaleToo) {
  const Measured box = svg_of(std::string("box.obj --paper a4 --scale 1:1") + kLines);
  EXPECT_NEAR(box.width(), 60.0, kTolerance);
  EXPECT_NEAR(box.height(), 30.0, kTolerance);
  const Measured above =
      svg_of("box.obj --paper a4 --scale 2:1 --hidden franklin --parallel --eye 0,90");
  EXPECT_NEAR(above.width(), 120.0, kTolerance);
  EXPECT_NEAR(above.height(), 40.0, kTolerance);
  write("view.draw", "set-viewport 0 0.5 0 0.5\n");
  const Measured quarter = svg_of(std::string("view.draw box.obj --paper a4 --scale 1:1") + kLines);
  EXPECT_NEAR(quarter.width(), 60.0, kTolerance);
  EXPECT_NEAR(quarter.left + 30.0, 10.0 + 190.0 / 4.0, 0.2);
  ASSERT_EQ(run("draw plate.draw --pens --scale 1:1 -o a.svg"), 0) << err_;
  const std::string pens = read(folder_ / "a.svg");
  Measured strokes;
  for (const auto& path : matches(pens, " d=\"([^\"]+)\"")) measure_path(path[1], {}, strokes);
  EXPECT_NEAR(strokes.width(), 80.0, kTolerance);
  EXPECT_NEAR(strokes.height(), 40.0, kTolerance);
}

/// With no margin but that of the paper.
TEST_F(PaperCommand, WhatDoesNotFitIsRefusedWithTheExcess) {
  write_box("whole.obj", 190, 30, 20);
  EXPECT_NEAR(svg_of(std::string("whole.obj --paper a4 --scale 1:1") + kLines).width(), 190.0,
              kTolerance);
  const std::string scaled = std::string(" --paper a4 --scale 1:1 -o a.pdf") + kLines;
  write_box("wide.obj", 191.5, 30, 20);
  expect_error("draw wide.obj" + scaled, "191.5 x 30 mm at this scale");
  EXPECT_NE(err_.find("--scale 1:1: "), std::string::npos) << err_;
  // The picture has whole pixels.
  const auto excess = matches(err_, ": ([0-9.]+) mm too wide");
  ASSERT_EQ(excess.size(), 1u) << err_;
  EXPECT_NEAR(number_of(excess[0][1]), 1.5, 0.25);
  write_box("high.obj", 30, 300, 20);
  expect_error("draw high.obj" + scaled, "mm too high");
  expect_error("draw plate.draw --paper a4 --scale 2:1 -o a.svg", "200 x 120 mm at this scale");
  expect_error("draw plate.draw --paper a5 --size 200x90mm -o a.svg", "does not fit on the paper");
  EXPECT_NE(err_.find("is 10 mm too wide"), std::string::npos) << err_;
}

/// The figure counts, not only the window in which it stands.
TEST_F(PaperCommand, AFigureThatLeavesThePaperIsRefused) {
  write("big.draw",
        "set-parallel 0 0 1\nopen-segment 1\nbox-3 -500 500 -500 500 0 1\nclose-segment\n");
  expect_error(
      "draw big.draw --paper a4 --scale 1:1 -o a.svg",
      "big.draw: 6 of 6 polygons, lines and annotations reach beyond the picture at --scale 1:1");
  expect_error("draw big.draw --paper a4 --scale 1:5 --fit each -o a.svg",
               "200 x 200 mm at this scale");
  EXPECT_NEAR(svg_of("big.draw --paper a4 --scale 1:5.3 --fit each --hidden franklin").width(),
              1000.0 / 5.3, kTolerance);
  // A window that a program sets may leave some out, with a warning.
  write("part.draw",
        "set-parallel 0 0 1\nset-window -5 5 -5 5\nopen-segment 1\n"
        "polygon-abs-3 -1 -1 0  1 -1 0  0 1 0\npolygon-abs-3 -1 -1 0  900 -1 0  0 1 0\n"
        "close-segment\n");
  ASSERT_EQ(run("draw part.draw --paper a4 --scale 1:1 -o a.svg"), 0) << err_;
  EXPECT_EQ(err_,
            "part.draw: 1 of 2 polygons, lines and annotations reach beyond the picture at "
            "--scale 1:1\n");
  ASSERT_EQ(run("draw part.draw -o a.svg"), 0) << err_;
  EXPECT_EQ(err_, "");
}

/// The default window -1 1 -1 1 is not a setting.
TEST_F(PaperCommand, AFigureBeyondAWindowThatIsNotSetGivesAWarning) {
  const std::string boxes = "open-segment 1\nbox-3 0 40 0 20 0 1\nclose-segment\n";
  write("boxes.draw", "set-parallel 0 0 1\n" + boxes);
  const std::string warning =
      "boxes.draw: 6 of 6 polygons, lines and annotations reach beyond the window -1 1 -1 1, which "
      "no "
      "set-window sets: --fit each fits it\n";
  ASSERT_EQ(run("draw boxes.draw -o a.png"), 0) << err_;
  EXPECT_EQ(err_, warning);
  ASSERT_EQ(run("draw - -o a.png", "boxes.draw"), 0) << err_;
  EXPECT_EQ(err_, "standard input" + warning.substr(warning.find(':')));
  ASSERT_EQ(run("draw boxes.draw --fit each -o a.png"), 0) << err_;
  EXPECT_EQ(err_, "");
  const Measured fitted = svg_of("boxes.draw --fit each --hidden franklin --paper 120x120");
  EXPECT_NEAR(fitted.width(), 90.0, 0.1);
  EXPECT_NEAR(fitted.height(), 45.0, 0.1);
  write("inside.draw", "open-segment 1\nbox-3 -1 1 -1 1 -1 1\nclose-segment\n");
  ASSERT_EQ(run("draw inside.draw -o a.png"), 0) << err_;
  EXPECT_EQ(err_, "");
  write("set.draw", "set-window -2 2 -2 2\n" + boxes);
  expect_error("draw set.draw --fit each -o a.png",
               "set.draw: sets a window: expected none with --fit each");
  write("two.draw",
        "set-parallel 0 0 1\n" + boxes +
            "set-viewport 0 0.5 0 0.5\nopen-segment 2\nbox-3 0 1 0 1 0 1\nclose-segment\n");
  expect_error("draw two.draw --fit each -o a.png",
               "two.draw: has several views: expected one with --fit each");
}

/// A part as large as the sheet of a laser cutter.
TEST_F(PaperCommand, WhatIsAsLargeAsThePaperFits) {
  write_box("plate.obj", 80, 1, 50);
  const Measured plate = svg_of(
      "plate.obj --paper 80x50 --margin 0 --scale 1:1 --hidden franklin "
      "--parallel --eye 0,90");
  EXPECT_NEAR(plate.left, 0.0, kTolerance);
  EXPECT_NEAR(plate.right, 80.0, kTolerance);
  EXPECT_NEAR(plate.bottom, 50.0, kTolerance);
  write_box("page.obj", 277, 190, 1);
  EXPECT_NEAR(
      svg_of(std::string("page.obj --paper a4-landscape --scale 1:1 --size 277x190mm") + kLines)
          .width(),
      277.0, kTolerance);
}

TEST_F(PaperCommand, ASizeInMillimetresIsTheSheetOfPensToo) {
  ASSERT_EQ(run("draw box.obj --pens --size 100x70mm -o a.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "a.svg").find("width=\"100mm\" height=\"70mm\""), std::string::npos);
  ASSERT_EQ(run("draw box.obj --pens --paper a4-landscape --size 100x70mm -o a.svg"), 0) << err_;
  EXPECT_NE(read(folder_ / "a.svg").find("width=\"297mm\" height=\"210mm\""), std::string::npos);
}

/// Commands that write one file have no fields for many.
TEST_F(PaperCommand, FieldsAreForCommandsThatDrawMany) {
  for (const char* const command :
       {"sheet box.obj -o '{name}.svg'", "export box.obj -o '{name}.stl'",
        "dump plate.draw -o '{name}.txt'", "import box.obj -o '{name}.draw'",
        "steps plate.draw --hidden franklin -o '{number}.json'"}) {
    expect_error(command, "this command writes one file: expected a name without fields");
  }
  expect_error("draw box.obj -o a.dxf", ".dxf files are lines for pens: expected pens, or one of");
  EXPECT_EQ(run("sheet box.obj -o a.svg --unit inch"), 0) << err_;
  EXPECT_EQ(run("sheet box.obj -o b.svg --unit in"), 0) << err_;
  EXPECT_EQ(read(folder_ / "a.svg"), read(folder_ / "b.svg"));
}

TEST_F(PaperCommand, WhatHasNoScaleIsRefusedByName) {
  expect_error("draw box.obj --paper a4 --scale 1:1 -o a.svg",
               "--scale 1:1: a perspective view has no scale: expected --parallel");
  expect_error("draw plate.draw --scale 1:1 -o a.svg", "--scale 1:1: a picture without a size");
  expect_error("draw plate.draw --scale 1:1 -o a.png", "--scale 1:1: a picture without a size");
  expect_error("draw plate.draw --paper a4 --scale 1:1 -o a.png",
               ".png files have no size on paper without dpi");
  expect_error("draw box.obj --parallel --paper a4 --scale 1:9 --turntable 3 -o a.svg",
               "--scale 1:9: expected one picture");
  for (const char* const bad : {"1", "1:", "0:1", "1:-2", "2x", "''"}) {
    expect_error(std::string("draw plate.draw --paper a4 -o a.svg --scale ") + bad, "--scale");
  }
  expect_error("draw plate.draw --paper a4 -o a.svg --unit m", "--unit m: expected --scale too");
  expect_error("draw plate.draw --paper a4 -o a.svg --scale 1:1 --unit ell",
               "--unit ell: expected");
}

TEST_F(PaperCommand, WidthsOnPaperAreMillimetresOrPoints) {
  const std::string plate = "plate.draw --paper a4-landscape --line-width ";
  EXPECT_NEAR(svg_of(plate + "0.35").line_width, 0.35, kTolerance);
  EXPECT_NEAR(svg_of(plate + "0.5mm").line_width, 0.5, kTolerance);
  EXPECT_NEAR(svg_of(plate + "1pt").line_width, 25.4 / 72.0, kTolerance);
  EXPECT_NEAR(svg_of("plate.draw --size 80x60mm --line-width 0.7").line_width, 0.7, kTolerance);
  EXPECT_NEAR(svg_of("plate.draw --paper a0").line_width, 25.4 / 72.0, kTolerance);  // a point
}

/// A box of 60 x 30 fills nine tenths of the width between the margins.
TEST_F(PaperCommand, APictureTakesTheShapeOfThePaper) {
  const auto width = [&](const std::string& options) {
    return svg_of("box.obj" + options + kLines).width();
  };
  EXPECT_NEAR(width(" --paper a4-landscape"), 277.0 * 0.9, 0.3);
  EXPECT_NEAR(width(" --paper a4"), 190.0 * 0.9, 0.3);
  EXPECT_NEAR(width(" --paper a4-landscape --size 512x512"), 190.0 * 0.9, 0.3);
  EXPECT_NEAR(width(" --paper a4 --margin 0"), 210.0 * 0.9, 0.3);
  EXPECT_NEAR(width(" --size 80x60mm"), 80.0 * 0.9, 0.3);
  EXPECT_NE(read(folder_ / "a.svg").find("width=\"80mm\" height=\"60mm\""), std::string::npos);
}

/// A window that a program sets is widened to the paper's shape, not stretched.
TEST_F(PaperCommand, TheShapeOfThePaperDistortsNothing) {
  for (const char* const paper : {"a4", "a4-landscape", "300x100", "80x200"}) {
    const Measured square = svg_of(std::string("square.draw --paper ") + paper);
    EXPECT_NEAR(square.width(), square.height(), kTolerance) << paper;
    EXPECT_EQ(err_, "") << paper;
  }
  const Measured stretched = svg_of("square.draw --paper a4 --size 400x200");
  EXPECT_NEAR(stretched.width(), 2.0 * stretched.height(), kTolerance);
  EXPECT_NE(err_.find("is stretched"), std::string::npos) << err_;
  write("turned.draw", "set-image-centre 1 0.5 0.5\nset-image-rotation 1 45\n");
  svg_of("square.draw turned.draw --paper a4");
  EXPECT_NE(err_.find("set-image-rotation"), std::string::npos) << err_;
  svg_of("square.draw turned.draw --paper a4 --size 400x400");
  EXPECT_EQ(err_, "");
  png_of("square.draw turned.draw --size 400x200");
  EXPECT_NE(err_.find("set-image-rotation distorts in 400 x 200 pixels"), std::string::npos)
      << err_;
}

TEST_F(PaperCommand, PixelsHaveADensity) {
  const Picture figure = png_of("plate.draw --size 80x60mm --dpi 300");
  EXPECT_EQ(figure.width, 945);
  EXPECT_EQ(figure.height, 709);
  EXPECT_EQ(density("a.png"), 11811u);
  png_of("plate.draw --dpi 72");
  EXPECT_EQ(density("a.png"), 2835u);
  png_of("plate.draw");
  EXPECT_EQ(density("a.png"), 0u);
  png_of("plate.draw --dpi 100 --background none");
  EXPECT_EQ(density("a.png"), 3937u);
  const Drawn plate = drawn_in(png_of("plate.draw --size 100x80mm --dpi 254 --scale 1:1"));
  EXPECT_NEAR(plate.right - plate.left, 800, 2);
  EXPECT_NEAR(plate.bottom - plate.top, 400, 2);
  const Drawn thin =
      drawn_in(png_of("plate.draw --size 100x80mm --dpi 254 --scale 1:1 "
                      "--line-width 2mm"));
  EXPECT_NEAR(thin.right - thin.left, 820, 2);
}

TEST_F(PaperCommand, ASheetInPixelsHasThePictureInItsMiddle) {
  const Picture sheet = png_of("plate.draw --paper a4 --dpi 127 --scale 1:1 --background 0.8,1,1");
  EXPECT_EQ(sheet.width, 1050);
  EXPECT_EQ(sheet.height, 1485);
  EXPECT_EQ(density("a.png"), 5000u);
  EXPECT_EQ(sheet.pixels.front(), sheet.pixels.back());
  const Drawn plate = drawn_in(png_of("plate.draw --paper a4 --dpi 127 --scale 1:1"));
  EXPECT_NEAR(plate.left + plate.right, 1050, 3);
  EXPECT_NEAR(plate.top + plate.bottom, 1485, 3);
  EXPECT_NEAR(plate.right - plate.left, 400, 2);
  const std::string sheet_of = "draw plate.draw --paper a4 --dpi 127 -o ";
  expect_error(sheet_of + "a.png --rows 0:5", "has no rows, ids or depth");
  expect_error(sheet_of + "a.png --ids a.npy", "has no rows, ids or depth");
  expect_error(sheet_of + "a.png --size 2000x100", "does not fit on the paper");
  expect_error(sheet_of + "a.svg", ".svg files have no dpi: expected .png");
  expect_error("draw plate.draw --dpi 127 -o a.ppm", ".ppm files have no dpi");
  expect_error("draw plate.draw --dpi 0 -o a.png", "--dpi 0: expected 1 to 100000");
  expect_error("draw plate.draw --size 80x60mm -o a.png", "without dpi");
  for (const char* const bad : {"80x60in", "80mm", "x60mm", "0x60mm", "80x1e9mm", "80x60mmx"}) {
    expect_error(std::string("draw plate.draw -o a.svg --size ") + bad, "--size");
  }
  expect_error("truth plate.draw --ids a.npy --size 80x60mm",
               "--size 80x60mm: expected WIDTHxHEIGHT in pixels");
}

TEST_F(PaperCommand, OneViewIsFittedToAllParts) {
  write_box("small.obj", 20, 10, 5);
  write_box("large.obj", 60, 20, 5);
  const auto widths = [&](const std::string& options) {
    EXPECT_EQ(run("draw small.obj large.obj -o '{name}.svg' --paper a4 " + options + kLines), 0)
        << err_;
    return std::pair(measured_svg(read(folder_ / "small.svg")).width(),
                     measured_svg(read(folder_ / "large.svg")).width());
  };
  const auto [small, large] = widths("--fit all");
  EXPECT_NEAR(large, 3.0 * small, 4.0 * kTolerance);
  EXPECT_NEAR(large, 190.0 * 0.9, 0.3);
  const auto [own_small, own_large] = widths("--fit each");
  EXPECT_NEAR(own_small, own_large, 0.3);
  write("view.draw", "set-parallel 0 0 -1\n");
  ASSERT_EQ(run("draw --with view.draw small.obj large.obj -o '{name}.svg' --paper a4 --fit all "
                "--hidden franklin"),
            0)
      << err_;
  EXPECT_NEAR(measured_svg(read(folder_ / "large.svg")).width(),
              3.0 * measured_svg(read(folder_ / "small.svg")).width(), 4.0 * kTolerance);
  write("window.draw", "set-window 0 9 0 9\n");
  EXPECT_EQ(run("draw --with window.draw small.obj large.obj -o '{name}.svg' --fit all"), 2);
  EXPECT_NE(err_.find("--fit all: expected a mesh before which"), std::string::npos) << err_;
  expect_error("draw small.obj large.obj -o a.svg --fit all", "expected a picture of each");
  expect_error("draw small.obj -o '{name}.svg' --fit some", "--fit some: expected each or all");
  expect_error("draw small.obj -o '{name}.svg' --fit all --no-fit", "expected one of them");
  expect_error("draw small.obj -o '{name}.svg' --fit all --turntable 2", "not turntables");
  expect_error("draw plate.draw -o '{name}.svg' --fit all", "--fit all: expected a mesh");
  expect_error("draw - small.obj -o '{name}.svg' --fit all", "not standard input");
}

TEST_F(PaperCommand, ACameraStandsBesideAWindowThatAProgramSets) {
  write("window.draw", "set-window -50 50 -50 50\n");
  const std::string box = "window.draw box.obj --hidden franklin --paper 120x120 --parallel";
  const Measured front = svg_of(box + " --eye 0,0");
  EXPECT_NEAR(front.width(), 60.0, 0.1);  // of 100 units on 100 mm
  EXPECT_NEAR(front.height(), 30.0, 0.1);
  const Measured above = svg_of(box + " --eye 0,90");
  EXPECT_NEAR(above.width(), 60.0, 0.1);
  EXPECT_NEAR(above.height(), 20.0, 0.1);
  const Measured aside = svg_of(box + " --eye 0,0 --look-at 0,0,0");
  EXPECT_NEAR(aside.left, 60.0, 0.1);
  write_box("small.obj", 20, 10, 5);
  EXPECT_NEAR(svg_of("window.draw small.obj --hidden franklin --paper 120x120 --parallel --eye 0,0")
                  .width(),
              20.0, 0.1);
  ASSERT_EQ(run("draw window.draw box.obj --eye 40,20 -o a.svg"), 0) << err_;
  expect_error("draw window.draw box.obj --fov 30 -o a.svg", "an angle of view, and a window");
  write("camera.draw", "set-window -50 50 -50 50\nset-perspective 0 0 200\n");
  expect_error("draw camera.draw box.obj --eye 0,90 -o a.svg",
               "--eye: expected a mesh before which no program sets the camera");
}

class PaperPdf : public PaperCommand {
 protected:
  void SetUp() override {
    PaperCommand::SetUp();
    if (std::system("command -v pdftocairo > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "pdftocairo is not installed";
    }
  }
  Measured pdf_of(const std::string& arguments) {
    EXPECT_EQ(run("draw " + arguments + " -o a.pdf"), 0) << err_;
    const std::string folder = folder_.string();
    EXPECT_EQ(std::system(
                  fmt::format("cd '{}' && pdftocairo -noshrink -nocenter -svg a.pdf b.svg", folder)
                      .c_str()),
              0);
    return measured_pdf(read(folder_ / "b.svg"));
  }
};

TEST_F(PaperPdf, ScalesAndWidthsAreExact) {
  for (const auto& [scale, factor] : {std::pair("1:1", 1.0), {"1:2", 0.5}, {"3:2", 1.5}}) {
    for (const char* const paper : {"a4", "a4-landscape", "letter --margin 3"}) {
      SCOPED_TRACE(fmt::format("{} {}", paper, scale));
      const Measured plate =
          pdf_of(fmt::format("plate.draw --paper {} --scale {} --line-width 0.5mm", paper, scale));
      EXPECT_NEAR(plate.width(), 80.0 * factor, kTolerance);
      EXPECT_NEAR(plate.height(), 40.0 * factor, kTolerance);
      EXPECT_NEAR(plate.line_width, 0.5, kTolerance);
    }
  }
  const Measured plate = pdf_of("plate.draw --paper a4 --scale 1:1 --line-width 2pt");
  EXPECT_NEAR(plate.left, 65.0, 0.02);
  EXPECT_NEAR(plate.top, 128.5, 0.02);
  EXPECT_NEAR(plate.line_width, 2.0 * 25.4 / 72.0, kTolerance);
  const Measured box = pdf_of(std::string("box.obj --paper a4 --scale 1:1") + kLines);
  EXPECT_NEAR(box.width(), 60.0, kTolerance);
  const Measured pens = pdf_of("plate.draw --pens --scale 1:1");
  EXPECT_NEAR(pens.width(), 80.0, kTolerance);
  // Without paper a pixel is a point.
  EXPECT_NEAR(pdf_of("plate.draw --line-width 0.5mm").line_width, 0.5, kTolerance);
  const Measured figure = pdf_of("plate.draw --size 120x80mm --scale 1:1");
  EXPECT_NEAR(figure.width(), 80.0, kTolerance);
  EXPECT_NEAR(figure.left, 20.0, 0.02);
}

}  // namespace
