#include "programs/command/sheet_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "clip/base/error.h"
#include "clip/base/without_choice.h"
#include "interp/device/picture.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/output_paths.h"
#include "programs/options/camera_options.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"
#include "programs/options/title_words.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"
#include "programs/sheet/arrangement.h"
#include "programs/sheet/part.h"

namespace displayfile {

namespace {

struct LengthUnit {
  const char* name;
  double millimetres;
};
constexpr std::array kUnits{LengthUnit{"mm", 1.0}, LengthUnit{"cm", 10.0}, LengthUnit{"m", 1000.0},
                            LengthUnit{"inch", 25.4}};

double millimetres_of(const std::string& unit) {
  const auto* const found = std::ranges::find(kUnits, unit, &LengthUnit::name);
  if (found != kUnits.end()) return found->millimetres;
  throw Error(fmt::format("--unit {}: expected mm, cm, m or inch", unit));
}

SheetProjection projection_of(const std::string& word) {
  if (word == "third") return SheetProjection::third;
  if (word == "first") return SheetProjection::first;
  throw Error(fmt::format("--projection {}: expected third or first", word));
}

constexpr std::array<std::string_view, 3> kCutViews{"front", "top", "side"};
using Positions = std::array<std::optional<double>, 4>;

/// Positions of sections in the front, top and side view, as `front=0`.
Positions sections_of(const std::vector<std::string>& words) {
  Positions positions;
  for (const std::string& word : words) {
    const auto fail = [&](std::string_view what) {
      throw Error(fmt::format("--section {}: {}", word, what));
    };
    constexpr std::string_view kExpected = "expected front=POSITION, top=POSITION or side=POSITION";
    const std::size_t equals = word.find('=');
    const auto* const view = std::ranges::find(kCutViews, word.substr(0, equals));
    if (equals == std::string::npos || view == kCutViews.end()) fail(kExpected);
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const auto [stop, failure] = std::from_chars(word.data() + equals + 1, end, value);
    if (failure != std::errc{} || stop != end || !std::isfinite(value)) fail(kExpected);
    auto& position = positions[static_cast<std::size_t>(view - kCutViews.begin())];
    if (position) fail("the view already has a section: expected one per view");
    position = value;
  }
  return positions;
}

/// Whether a face of the part lies in the plane at a position of a view.
bool has_face_at(const Mesh& part, ViewKind view, double position) {
  const auto in_plane = [&](std::uint32_t corner) {
    return in_view(view, part.vertices[corner]).z == position;
  };
  for (std::size_t i = 0; i < part.faces(); ++i) {
    if (std::ranges::all_of(part.face(i), in_plane)) return true;
  }
  return false;
}

/// Whether a plane at a position of a view has a part of a face behind it and another not: false in
/// a gap between bodies.
bool cuts_a_face(const Mesh& part, ViewKind view, double position) {
  const auto behind = [&](std::uint32_t corner) {
    return in_view(view, part.vertices[corner]).z < position;
  };
  for (std::size_t i = 0; i < part.faces(); ++i) {
    const auto corners = part.face(i);
    if (std::ranges::any_of(corners, behind) && !std::ranges::all_of(corners, behind)) return true;
  }
  return false;
}

/// Throws Error unless the plane at a position of a view cuts the part. Since what lies in the
/// plane counts as before it (section.md), a face at the part's near end is cut, and one at its far
/// end has nothing behind it.
void require_cut(const Mesh& part, ViewKind view, std::string_view name, double position) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const std::uint32_t corner : part.corners) {
    const double along = in_view(view, part.vertices[corner]).z + 0.0;  // 0, not -0, in messages
    low = std::min(low, along);
    high = std::max(high, along);
  }
  const auto fail = [&](const std::string& what) {
    throw Error(fmt::format("--section {}={}: {}", name, position, what));
  };
  if (low == high) fail(fmt::format("the part is flat there, at {}: expected no section", low));
  if (position < low || position > high) {
    fail(fmt::format("expected a position that cuts the part, {} to {}", low, high));
  }
  const bool inside = position > low && position < high;
  if (inside || (position == high && has_face_at(part, view, high))) return;
  fail(fmt::format("touches the part and cuts nothing: expected a position between {} and {}", low,
                   high));
}

void read_paper(const std::string& word, double margin, SheetWords& words) {
  Paper paper = paper_of(word);
  paper.margin = margin;
  constexpr int kWide = 2, kHigh = 1;  // four views are wider than high
  const PaperFit fit = fit_on_paper(paper, kWide, kHigh);
  words.width = fit.width;
  words.height = fit.height;
  words.margin = margin;
}

}  // namespace

CLI::App& SheetCommand::add_to(CLI::App& app) {
  CLI::App& command = *app.add_subcommand(
      "sheet", "Draw a part on a sheet of paper: front, top, side and isometric view");
  add_inputs(command, "PART", inputs, "meshes and drawing programs of polygons");
  command.add_option("-o,--output", output, "the sheet: .svg, .pdf or .dxf")
      ->type_name("OUT.{svg,pdf,dxf}")
      ->required()
      ->group(kOutputOptions);
  command.add_option("--paper", paper, "paper size, as in draw: a4, a3-portrait, 300x200")
      ->type_name("PAPER")
      ->capture_default_str()
      ->group(kPaperOptions);
  command.add_option("--margin", margin, "distance from the paper's edge to the frame in mm")
      ->type_name("MM")
      ->transform(any_number<double>())
      ->capture_default_str()
      ->group(kPaperOptions);
  command
      .add_option("--scale", scale,
                  "scale such as 1:2; by default the largest standard scale (ISO 5455) that fits")
      ->type_name("PAPER:PART")
      ->group(kPictureOptions);
  command
      .add_option("--projection", projection,
                  "third: the top view above and the right side on the right; first: the top view "
                  "below and the left side on the right")
      ->type_name("third|first")
      ->capture_default_str()
      ->group(kPictureOptions);
  command.add_option("--unit", unit, "unit of the part's coordinates")
      ->type_name("mm|cm|m|inch")
      ->capture_default_str()
      ->group(kPictureOptions);
  command
      .add_option("--up", up,
                  "up axis; by default that of the first input that states one, otherwise y. A "
                  "drawing program states it by setting a view; for one that sets none, shapes "
                  "along z, such as cylinders, lie on the sheet unless --up z is given")
      ->type_name("x|y|z|-x|-y|-z")
      ->group(kPictureOptions);
  command
      .add_option(
          "--section", sections,
          "draw this view as a section with the cut face hatched; POSITION is along the direction "
          "toward the view's viewer, in the part's unit; may be repeated for other views")
      ->type_name("front=POSITION|top=POSITION|side=POSITION")
      ->group(kPictureOptions);
  command.add_option("--hatch", hatch, "distance between hatching lines in mm")
      ->type_name("MM")
      ->transform(any_number<double>())
      ->capture_default_str()
      ->group(kPictureOptions);
  command.add_option("--lines", lines, "kinds of edges drawn as lines, as in draw")
      ->type_name("KIND,...")
      ->capture_default_str()
      ->group(kHiddenSurfaceOptions);
  command
      .add_option("--title", title,
                  "title in the title block; by default, or if empty, the part's file name")
      ->type_name("TITLE")
      ->group(kPictureOptions);
  command.add_option("--date", date, "date in the title block; by default none")
      ->type_name("DATE")
      ->group(kPictureOptions);
  command
      .add_option("--font", font,
                  "font of texts in .svg and .pdf, by the name that the system has for it; or "
                  "hershey, or hershey:NAME: letters as strokes, in .dxf too (Debian: "
                  "hershey-fonts-data)")
      ->type_name("NAME|hershey[:NAME]")
      ->capture_default_str()
      ->group(kPictureOptions);
  command
      .add_option("--threads", threads,
                  "maximum number of threads; the sheet does not depend on it")
      ->type_name("N")
      ->transform(number_in(1, 1024))
      ->group(kPictureOptions);
  import.add_to(command);
  return command;
}

int SheetCommand::run() {
  const std::vector<std::string> lists = input_lists(inputs);
  inputs = input_names(inputs);
  require_sheet_file(output, font);
  require_files_of_their_own({output}, inputs, lists);
  SheetWords words;
  read_paper(paper, margin, words);
  words.projection = projection_of(projection);
  words.unit = millimetres_of(unit);
  words.title = title_or_name(title, std::filesystem::path(inputs.front()).stem().string());
  require_drawable("--date", date);
  words.date = date;
  words.hatch = hatch;
  if (!(hatch >= kClosestHatching && hatch <= kLargestSheet)) {
    throw Error(
        fmt::format("--hatch {}: expected {} to {} mm", hatch, kClosestHatching, kLargestSheet));
  }
  std::optional<DrawingScale> asked;
  if (!scale.empty()) asked = drawing_scale(scale);
  const auto positions = sections_of(sections);
  const LineSelection selection = line_selection_of_option(lines);
  if (!up.empty()) upright_of_option(up);
  const Part part = read_part(inputs, up, import.limits());
  const auto kinds = views_of_sheet(words.projection);
  for (std::size_t k = 0; k < kCutViews.size(); ++k) {
    if (!positions[k]) continue;
    require_cut(part.mesh, kinds[k], kCutViews[k], *positions[k]);
    if (!cuts_a_face(part.mesh, kinds[k], *positions[k])) {
      warnings() << fmt::format("{}: the section plane at {} does not cut the part\n",
                                inputs.front(), *positions[k]);
    }
  }
  std::array<PartDrawing, 4> views;
  {
    Progress progress("finding the lines of four views");
    const WithoutChoice by_this_method_alone;
    for (std::size_t k = 0; k < 4; ++k) {
      views[k] = view_of_part(part, kinds[k], selection, positions[k], threads);
      progress.update(k + 1, 4);
    }
  }
  if (!std::ranges::all_of(views, &PartDrawing::closed)) {
    warnings() << fmt::format(
        "{}: not closed and consistently oriented: the section is open, without hatching\n",
        inputs.front());
  }
  const DrawingScale chosen = scale_of_sheet(views, words, asked ? &*asked : nullptr);
  DrawingSheet sheet = arrange(views, words, chosen);
  sheet.font = font;
  write_sheet(sheet, output);
  for (const std::string& field : sheet.shortened) {
    warnings() << fmt::format("{}: too long for the title block, shortened: {}\n", output, field);
  }
  return 0;
}

}  // namespace displayfile
