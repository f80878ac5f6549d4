#include "programs/command/sheet_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <string_view>
#include <unordered_map>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "displayfile/text/characters.h"
#include "interp/device/picture.h"
#include "programs/inputs/input_names.h"
#include "programs/inputs/output_paths.h"
#include "programs/options/camera_options.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/length_unit.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"
#include "programs/options/title_words.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"
#include "programs/sheet/arrangement.h"
#include "programs/sheet/part.h"
#include "programs/sheet/shown_points.h"
#include "programs/sheet/view_words.h"

namespace displayfile {

namespace {

SheetProjection projection_of(const std::string& word) {
  if (word == "third") return SheetProjection::third;
  if (word == "first") return SheetProjection::first;
  throw Error(fmt::format("--projection {}: expected third or first", word));
}

/// True if a face of the part lies in the plane at a position of a view.
bool has_face_at(const Mesh& part, ViewKind view, double position) {
  const auto in_plane = [&](std::uint32_t corner) {
    return in_view(view, part.vertices[corner]).z == position;
  };
  for (std::size_t i = 0; i < part.faces(); ++i) {
    if (std::ranges::all_of(part.face(i), in_plane)) return true;
  }
  return false;
}

/// True if a plane at a position of a view has one part of a face behind it and another not: false
/// in a gap between bodies.
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

/// Throws Error unless the plane at a position of a view cuts the part. Since points in the plane
/// count as before it (section.md), a face at the part's near end is cut, and one at its far end
/// has nothing behind it.
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

/// Each name of parts once, in order, and the number of parts with it.
std::vector<PartsListRow> listed(std::span<const NamedPart> parts) {
  std::vector<PartsListRow> all;
  std::unordered_map<std::string_view, std::size_t> row_of;
  for (const NamedPart& part : parts) {
    const auto [row, is_new] = row_of.try_emplace(part.name, all.size());
    const int number = static_cast<int>(all.size()) + 1;
    is_new ? all.push_back({number, part.name, 1}) : void(++all[row->second].quantity);
  }
  return all;
}

/// Which parts are named in --uncut, by their own names or those of their inputs. Throws Error for
/// names of none.
std::vector<std::uint8_t> parts_named(const std::string& words, const Part& part) {
  std::vector<std::uint8_t> named(part.parts.size(), 0);
  for (const std::string_view word : words_between_commas(words)) {
    bool is_known = false;
    for (std::size_t i = 0; i < part.parts.size(); ++i) {
      if (part.parts[i].name != word && part.parts[i].input != word) continue;
      named[i] = 1;
      is_known = true;
    }
    if (is_known) continue;
    std::vector<std::string> names;
    for (const PartsListRow& one : listed(part.parts)) names.push_back(one.name);
    constexpr std::size_t kMost = 12;
    const bool has_more = names.size() > kMost;
    names.resize(std::min(names.size(), kMost));
    throw Error(fmt::format("--uncut {}: no part has this name: expected some of {}{}", word,
                            fmt::join(names, ", "), has_more ? ", ..." : ""));
  }
  return named;
}

/// Throws Error if a detail's circle contains nothing of the view.
void require_shown(const DetailWanted& detail, const PartDrawing& view, const std::string& word) {
  const Point2 nearest = glm::clamp(detail.middle, view.low, view.high);
  if (glm::distance(nearest, detail.middle) < detail.radius) return;
  throw Error(
      fmt::format("--detail {}: nothing of the view is there: expected a circle within {} to "
                  "{} and {} to {}",
                  word, view.low.x, view.high.x, view.low.y, view.high.y));
}

/// Warns of each part of --uncut that no section plane goes through.
void warn_of_whole_parts(const Part& part, const std::vector<std::uint8_t>& uncut,
                         std::span<const ViewWanted> views) {
  const auto is_cut = [&](const std::string& name) {
    for (std::size_t object = 0; object < part.part_of.size(); ++object) {
      if (part.parts[part.part_of[object]].name != name) continue;
      for (const ViewWanted& view : views) {
        if (view.position && goes_through(part, object, view.kind, *view.position)) return true;
      }
    }
    return false;
  };
  std::vector<std::string> names;
  for (std::size_t i = 0; i < part.parts.size(); ++i) {
    const std::string& name = part.parts[i].name;
    if (uncut[i] == 0 || std::ranges::find(names, name) != names.end()) continue;
    names.push_back(name);
    if (!is_cut(name)) {
      warnings() << fmt::format("--uncut {}: no section plane goes through it\n", name);
    }
  }
}

/// The title of the first program that has one, for the title block; --title takes its place.
void take_title(std::span<const KeptAnnotation> annotations, const std::string& asked,
                SheetWords& words) {
  const KeptAnnotation* first = nullptr;
  for (const KeptAnnotation& title : annotations) {
    if (title.kind != KeptAnnotation::Kind::title || !asked.empty()) continue;
    if (first != nullptr) {
      warnings() << fmt::format("title {}: left out: the title block has {}\n",
                                in_quotation_marks(title.characters),
                                in_quotation_marks(first->characters));
      continue;
    }
    first = &title;
    words.title = title.characters;
  }
}

/// That of the balloons, so that the numbers are theirs; of the parts only if it is requested and
/// no balloon has a name.
std::vector<PartsListRow> parts_list_of(const Part& part, bool is_asked) {
  const bool has_list = std::ranges::any_of(part.annotations, [](const KeptAnnotation& one) {
    return one.kind == KeptAnnotation::Kind::list;
  });
  if (!is_asked && !has_list) return {};
  std::vector<PartsListRow> rows = parts_list_rows(part.annotations);
  for (const std::string& fault : parts_list_faults(rows)) warnings() << fault << '\n';
  if (!rows.empty()) return rows;
  if (is_asked) return listed(part.parts);
  warnings() << "parts-list: left out: no balloon has a name: expected --parts-list for a list of "
                "the parts\n";
  return {};
}

/// The annotation at points of the part, each in a view.
PartAnnotation placed_annotation(const Part& part, std::span<const ViewWanted> wanted,
                                 std::span<const PartDrawing> views) {
  PartAnnotation annotation{{}, {}, part.axes};
  const ShownPoints shown(part, wanted, views);
  for (const KeptAnnotation& one : part.annotations) {
    if (one.anchors() == 0) continue;
    annotation.all.push_back(one);
    annotation.shown_in.push_back(is_label(one) ? shown.view_of(one.points[0]) : 0);
  }
  return annotation;
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
  command.add_option("--unit", unit, "unit of the part's coordinates [mm]")
      ->type_name(kLengthUnits)
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
  command
      .add_option("--detail", details,
                  "also draw a part of a view at another scale: the circle about X,Y, coordinates "
                  "of the view in the part's unit, to the right and up; may be repeated")
      ->type_name("front=X,Y,RADIUS@PAPER:PART|top=DETAIL|side=DETAIL|isometric=DETAIL")
      ->group(kPictureOptions);
  command
      .add_flag("--parts-list", parts_list,
                "list the parts above the title block: the balloons that have names, or else all "
                "parts")
      ->group(kPictureOptions);
  command
      .add_option("--uncut", uncut,
                  "parts that sections leave whole, such as shafts and bolts: names of inputs "
                  "without folder and extension, of objects of meshes, or PROGRAM:SEGMENT")
      ->type_name("PART,...")
      ->group(kPictureOptions);
  command
      .add_option(
          "--centre-lines", centre_lines,
          "centre lines of what turned routines made (cylinder-3, cone-3, sphere-3, torus-3, "
          "turn-3), but in the isometric view; meshes have none")
      ->type_name("on|off")
      ->capture_default_str()
      ->group(kPictureOptions);
  command
      .add_option(
          "--hatch", hatch,
          "distance between hatching lines in mm; neighbouring parts differ in direction, and "
          "others, if need be, in a wider distance [2]")
      ->type_name("MM")
      ->transform(any_number<double>())
      ->group(kPictureOptions);
  command.add_option("--lines", lines, "kinds of edges drawn as lines, as in draw")
      ->type_name("KIND,...")
      ->capture_default_str()
      ->group(kHiddenSurfaceOptions);
  command
      .add_option(
          "--hidden-lines", hidden_lines,
          "views that show hidden lines, dashed, with commas between them; by default those "
          "that are neither cut nor isometric")
      ->type_name("front|top|side|isometric|all|none,...")
      ->group(kHiddenSurfaceOptions);
  command
      .add_option(
          "--title", title,
          "title in the title block; by default, or if empty, that of a program, or else the "
          "part's file name")
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
  if (!unit.empty()) words.unit = millimetres_of_unit(unit);
  words.title = title_or_name(title, std::filesystem::path(inputs.front()).stem().string());
  require_drawable("--date", date);
  words.date = date;
  words.hatch = hatch.value_or(words.hatch);
  if (!(words.hatch >= kClosestHatching && words.hatch <= kLargestSheet)) {
    throw Error(fmt::format("--hatch {}: expected {} to {} mm", words.hatch, kClosestHatching,
                            kLargestSheet));
  }
  std::optional<DrawingScale> asked;
  if (!scale.empty()) asked = drawing_scale(scale);
  const auto positions = sections_of(sections);
  const auto hidden = hidden_lines_in_views(hidden_lines, positions);
  words.details = details_of(details);
  if (centre_lines != "on" && centre_lines != "off") {
    throw Error(fmt::format("--centre-lines {}: expected on or off", centre_lines));
  }
  if (hatch && sections.empty()) throw Error("--hatch has no effect without --section");
  if (!uncut.empty() && sections.empty()) throw Error("--uncut has no effect without --section");
  const LineSelection selection = selection_of(LineWords(lines));
  if (!up.empty()) upright_of_option(up);
  const Part part = read_part(inputs, up, import.limits());
  if (unit.empty()) warn_of_metres(inputs);
  const auto kinds = views_of_sheet(words.projection);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (!positions[k]) continue;
    require_cut(part.mesh, kinds[k], kViewNames[k], *positions[k]);
    if (!cuts_a_face(part.mesh, kinds[k], *positions[k])) {
      warnings() << fmt::format("{}: the section plane at {} does not cut the part\n",
                                inputs.front(), *positions[k]);
    }
  }
  std::array<ViewWanted, 4> wanted;
  for (std::size_t k = 0; k < 4; ++k) {
    const bool has_centre_lines = centre_lines == "on" && kinds[k] != ViewKind::isometric;
    wanted[k] = {kinds[k], positions[k], hidden[k], has_centre_lines, {}};
  }
  if (!uncut.empty()) {
    const std::vector<std::uint8_t> named = parts_named(uncut, part);
    for (ViewWanted& view : wanted) view.uncut = named;
    warn_of_whole_parts(part, named, wanted);
  }
  std::array<PartDrawing, 4> views;
  {
    Progress progress("finding the lines of four views");
    const WithoutChoice by_this_method_alone;
    for (std::size_t k = 0; k < 4; ++k) {
      views[k] = view_of_part(part, wanted[k], selection, threads);
      progress.update(k + 1, 4);
    }
  }
  if (!std::ranges::all_of(views, &PartDrawing::closed)) {
    warnings() << fmt::format(
        "{}: not closed and consistently oriented: the section is open, without hatching\n",
        inputs.front());
  }
  for (std::size_t i = 0; i < words.details.size(); ++i) {
    require_shown(words.details[i], views[words.details[i].view], details[i]);
  }
  take_title(part.annotations, title, words);
  words.parts = parts_list_of(part, parts_list);
  const PartAnnotation annotation = placed_annotation(part, wanted, views);
  words.least_gap = std::max(words.least_gap, gap_for_labels(annotation));
  const DrawingScale chosen = scale_of_sheet(views, words, asked ? &*asked : nullptr);
  DrawingSheet sheet = arrange(views, annotation, words, chosen);
  sheet.font = font;
  write_sheet(sheet, output);
  for (const std::string& field : sheet.shortened) {
    warnings() << fmt::format("{}: too long for the title block, shortened: {}\n", output, field);
  }
  for (const std::string& sentence : sheet.not_as_wanted) {
    warnings() << fmt::format("{}: {}\n", output, sentence);
  }
  return 0;
}

}  // namespace displayfile
