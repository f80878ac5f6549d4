#include "hard/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "programs/scenes/hard_cases.h"

namespace displayfile {

namespace {

constexpr std::string_view kIntroduction = R"(# Hard cases

The wrong pixels of each method on scenes that break published implementations. A pixel is wrong if its
identifier in the item buffer is not that of exact arithmetic (`interp/truth/truth.h`). In the families of
[scenes that touch](#scenes-that-touch) exact arithmetic starts from the scene as entered
(`interp/truth/entered_truth.h`), in all others from the display file. One command prints this page:

    hard_table --document --size {0} --seeds {1} --random {2} > tests/hard/README.md

Without `--document` the same table goes to the terminal; `--csv FILE` writes it for programs,
`--families A,B` selects rows, `--without osmesa` omits columns, `--severity S` sets one severity for all,
`--severity sweep` shows the effect of a shrinking gap, and `--touching-off` that of `set-touching off` on
scenes that touch. It exits 1 if a method that claims to be exact has a wrong pixel
anywhere. `hard_table --list` prints the families with their sizes and severities. `ctest -R hard`
runs a smaller one, and compares the exact truths with a brute force in rationals on every family.

Each family has a generator `Scene make(n, severity, seed)` (`programs/scenes/hard_cases.h`); a
method is one line in `hard/methods.cpp`. Scenes are the same, bit for bit, on every machine.

## The methods

{3}
The plain z-buffer (`interp/visibility/plain_z_buffer.cpp`) steps x and z by adding, as textbooks do, and so
can be wrong about coverage as well as about depth; its integer formats spread [0,1] over all their
values and clamp depths outside. OSMesa draws triangles whose vertices are rounded to 1/256 pixel,
their depths to single precision, and its depth range is fitted to each scene: where all of a
scene lies within the gap (`ulp_stack`, `cycle`) the gap costs it nothing, and 32 bits of depth
gain little over 24. The depths that it granted:

{4}
## The table

{5} scenes of {0} x {0} pixels: for each family all its severities, with {1} seeds each; {2} random
degenerate scenes, with coordinates from a tiny grid. A cell is a sum of wrong pixels.

)";

constexpr std::string_view kTouching = R"(
## Scenes that touch

{0} scenes of {1} x {1} pixels of objects that touch as people draw them, with whole numbers and decimals, in parallel
and perspective views from anywhere, half of them turned and moved by a modelling transformation. They are judged by
the scene as entered: polygons that lie in one plane there lie in one plane, and the one entered later is visible,
however viewing rounds. Touching is automatic, which is the default:

{2}
The same scenes with `set-touching off`, against the same right pictures: planes that coincide exactly, in whole numbers, are
then right, and planes that decimals or a modelling transformation round are not. Methods that do not detect touching,
or are not exact, draw the same as before.

{3})";

/// Sum of the wrong pixels in a hundred of the row's pixels.
std::string percentage(long long wrong, long long pixels) {
  const double percent = 100.0 * static_cast<double>(wrong) / static_cast<double>(pixels);
  return percent < 0.1 ? "below 0.1" : fmt::format("{:.1f}", percent);
}

/// Lines of at most 100 characters, as far as words allow; then an empty line.
std::string wrapped(std::string_view text) {
  std::string lines;
  std::size_t length = 0;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (length > 0) {
      const bool full = length + 1 + word.size() > 100;
      lines += full ? '\n' : ' ';
      length = full ? 0 : length + 1;
    }
    lines += word;
    length += word.size();
  }
  return lines + "\n\n";
}

/// Which methods are right on the row, and how wrong the others are.
std::string what_each_does(const Tally& tally, std::span<const Method> methods) {
  std::string right, wrong;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::string& list = tally.wrong[i] == 0 ? right : wrong;
    if (!list.empty()) list += ", ";
    list += fmt::format("`{}`", methods[i].column);
    if (tally.wrong[i] != 0) list += ' ' + percentage(tally.wrong[i], tally.pixels);
  }
  if (wrong.empty()) return "Right in every pixel: all methods.";
  return fmt::format("Right in every pixel: {}. Wrong pixels in a hundred: {}.", right, wrong);
}

std::string paragraph(const HardCase& family, const Tally& tally, std::span<const Method> methods) {
  std::string severities;
  for (double severity : family.severities) severities += fmt::format(" {:g}", severity);
  return wrapped(fmt::format("**{}** ({}; n = {}; {}:{}). {} {}", family.name, family.what,
                             family.size, family.severity_means, severities, family.hard,
                             what_each_does(tally, methods)));
}

const HardCase* family_of(const TableRow& row) {
  const auto family = std::ranges::find(hard_cases(), std::string_view(row.name), &HardCase::name);
  return family == hard_cases().end() ? nullptr : &*family;
}

/// The rows of the families, or of random scenes, that are judged from there.
std::vector<TableRow> judged_from(JudgedFrom from, std::span<const TableRow> rows) {
  std::vector<TableRow> some;
  for (const TableRow& row : rows) {
    const HardCase* family = family_of(row);
    if ((family ? family->judged_from : JudgedFrom::display_file) == from) some.push_back(row);
  }
  return some;
}

constexpr std::string_view kRandomParagraph =
    "**random degenerate** (2 to 12 polygons of 3 to 6 sides, coordinates multiples of 1/8, 1/6, "
    "1/7 or 1/64, three to five levels of depth). Everything touches everything: vertices on "
    "vertices, edges on edges and on pixel centres, planes that coincide or cross at centres. "
    "{}\n\n";

constexpr std::string_view kSweeps = R"(## How the error grows as a gap shrinks

Polygons a gap apart, from a tenth of the depth range to less than a double can hold. After each
table, where each method breaks: the largest gap with a wrong pixel, and the largest with more than
one pixel in a hundred wrong. For comparison, the steps of the formats: 1.5e-5 in 16 bits,
6.0e-8 in 24 bits, 2.3e-10 in 32 bits; between 1/2 and 1, 6.0e-8 in a float and 1.1e-16 in a double.
Where polygons are parallel a format breaks at its step; where they cross, the pixels near the
crossing go wrong long before.

Below about 1e-16 the gap vanishes in the rounding of the vertices themselves: the polygons are then
in one plane, the later one is rightly visible, and the counts fall. OSMesa's errors at every gap are
errors of coverage.

)";

}  // namespace

std::string where_each_breaks(std::span<const TableRow> sweep, std::span<const Method> methods) {
  std::string text;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::string first_wrong, breaks;
    for (const TableRow& row : sweep) {
      if (first_wrong.empty() && row.tally.wrong[i] > 0) first_wrong = row.name;
      if (breaks.empty() && row.tally.wrong[i] * 100 > row.tally.pixels) breaks = row.name;
    }
    text += fmt::format("- {}: ", methods[i].name);
    if (first_wrong.empty()) {
      text += "no wrong pixel at any gap\n";
    } else {
      text += fmt::format("first wrong pixels at {}, more than one in a hundred {}\n", first_wrong,
                          breaks.empty() ? "at no gap" : "from " + breaks + " on");
    }
  }
  return text;
}

std::string notes(std::span<const Method> methods) {
  std::string text;
  for (const Method& method : methods) {
    if (method.note) text += fmt::format("- {}: {}\n", method.name, method.note());
  }
  return text;
}

std::string document(std::span<const TableRow> rows, std::span<const TableRow> off_rows,
                     std::span<const Sweep> sweeps, std::span<const Method> methods, int size,
                     int seeds, int random) {
  std::string list;
  for (const Method& method : methods)
    list += fmt::format("- `{}`: {}\n", method.column, method.name);
  const std::string osmesa = notes(methods);
  const auto of_display_file = judged_from(JudgedFrom::display_file, rows);
  const auto touching = judged_from(JudgedFrom::entered, rows);
  std::string text = fmt::format(kIntroduction, size, seeds, random, list,
                                 osmesa.empty() ? "- nothing: this build has none\n" : osmesa,
                                 total(of_display_file).scenes);
  text += markdown_table(of_display_file, methods, "family");
  text += fmt::format(kTouching, total(touching).scenes, size,
                      markdown_table(touching, methods, "family"),
                      markdown_table(off_rows, methods, "family"));
  text += "\n## The difficulty of each family, and the errors of each method\n\n";
  for (const TableRow& row : rows) {
    const HardCase* family = family_of(row);
    text += family ? paragraph(*family, row.tally, methods)
                   : wrapped(fmt::format(kRandomParagraph, what_each_does(row.tally, methods)));
  }
  text += kSweeps;
  for (const Sweep& sweep : sweeps) {
    text += fmt::format("### {}\n\n{}\n{}\n", sweep.families,
                        markdown_table(sweep.rows, methods, "gap"),
                        where_each_breaks(sweep.rows, methods));
  }
  text.pop_back();
  return text;
}

}  // namespace displayfile
