#include "programs/bench/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "programs/bench/advice.h"
#include "programs/bench/analysis.h"
#include "programs/bench/beside.h"
#include "programs/bench/contenders.h"
#include "programs/bench/json_report.h"
#include "programs/bench/line_summary.h"
#include "programs/bench/moving_camera_summary.h"
#include "programs/bench/summary_parts.h"
#include "programs/inputs.h"

namespace displayfile::bench {

namespace {

using Row = std::vector<std::string>;

bool is_roundoff(std::string_view precision) { return precision.starts_with("roundoff="); }

/// In the order of the report, once each.
Row distinct(const std::vector<Column>& all, std::string Column::*part, const auto& wanted) {
  Row found;
  for (const Column& column : all) {
    if (!wanted(column)) continue;
    if (std::ranges::find(found, column.*part) == found.end()) found.push_back(column.*part);
  }
  return found;
}

Row roundoffs(const std::vector<Column>& all) {
  return distinct(all, &Column::precision,
                  [](const Column& c) { return is_roundoff(c.precision); });
}

/// A row a method: its count when exact, with each ROUNDOFF, and in what other formats it has.
std::optional<Summary> wrong_pixels_of_hard_cases(const Report& report) {
  const std::vector<Column> all = columns(report);
  std::int64_t pixels = 0;
  for (const Column& column : all) {
    pixels = std::max(pixels, wrong_pixels(report, "", column).pixels);
  }
  if (pixels == 0) return std::nullopt;
  const Row precisions = roundoffs(all);
  const auto families = names(report, BenchScene::Kind::hard_case).size();
  const auto cases = std::ranges::count(report.scenes, BenchScene::Kind::hard_case,
                                        [](const SceneRow& row) { return row.scene.kind; });
  Summary summary{
      "wrong-pixels",
      "Wrong pixels",
      fmt::format(
          "Wrong pixels, counted against the exact truth over {} hard cases of {} families, "
          "{} pixels in all:",
          cases, families, grouped(pixels)),
      {}};
  Row head{"method", "exact"};
  head.insert(head.end(), precisions.begin(), precisions.end());
  head.emplace_back("otherwise");
  summary.rows.push_back(head);
  for (const std::string& method :
       distinct(all, &Column::method, [](const Column&) { return true; })) {
    Row row(head.size());
    row.front() = method;
    for (const Column& column : all) {
      const Wrong sum = wrong_pixels(report, "", column);
      if (column.method != method || sum.pixels == 0) continue;
      // A peer may have drawn only some of the pixels.
      const std::string count =
          sum.pixels == pixels ? grouped(sum.wrong)
                               : fmt::format("{} of {}", grouped(sum.wrong), grouped(sum.pixels));
      const auto at = std::ranges::find(head, column.precision);
      if (at != head.end()) {
        row[static_cast<std::size_t>(at - head.begin())] = count;
      } else {
        const std::string of = column.precision.empty() ? "" : column.precision + ' ';
        row.back() += (row.back().empty() ? "" : "; ") + of + count;
      }
    }
    if (std::ranges::any_of(row.begin() + 1, row.end(), [](const auto& t) { return !t.empty(); })) {
      summary.rows.push_back(std::move(row));
    }
  }
  return summary;
}

/// Rows of the largest picture of each scene.
template <class Cells>
void add_rows(const Report& report, Summary& summary, Cells&& cells_of) {
  for (const std::string& name : names_but_hard_cases(report)) {
    const SceneRow& row = largest_picture(report, name);
    const Row figures = cells_of(row);
    if (std::ranges::all_of(figures, [](const auto& text) { return text.empty(); })) continue;
    Row cells{short_name(name), grouped(static_cast<std::int64_t>(row.polygons)),
              fmt::format("{0} x {0}", row.scene.size)};
    cells.insert(cells.end(), figures.begin(), figures.end());
    summary.rows.push_back(std::move(cells));
  }
}

std::optional<Summary> beside_osmesa(const Report& report) {
  using namespace beside;
  Summary summary{
      "osmesa",
      "Beside OSMesa",
      "How many times as fast the exact z-buffer is as OSMesa with 24 bits of depth: the same "
      "triangles, into which polygons are cut, in the same colours, back faces removed on both "
      "sides or on neither, as many "
      "threads on both sides (one: the processor's time; several: the time on the wall). OSMesa "
      "draws an indexed mesh whose vertices triangles share, flat, in a context that is there, and "
      "waits until all is drawn; nothing is read back, while our picture is in memory. Start-up: "
      "everything new and a picture of one triangle; ours a system and a picture, OSMesa's a "
      "context, a frame buffer and its vertices. New vertices: ours enters all triangles anew and "
      "draws them; OSMesa's vertices are handed over anew and drawn. Moving camera: a turn of 8 "
      "views; ours views what it retains and draws it, in OSMesa all is resident, in buffers or in "
      "a "
      "display list, whichever is faster, and each view is another matrix. Same picture again: the "
      "display file and the mesh as they were.",
      {{"scene", "polygons", "picture"}}};
  const std::vector<int> threads = threads_of(report, kOsmesa);
  for (const int n : threads) {
    for (const char* what : {kStartUp, kNewVertices, kNewViews, kAgain}) {
      summary.rows.front().push_back(on_threads(what, n));
    }
  }
  LeftOut left_out;
  add_rows(report, summary, [&](const SceneRow& row) {
    Row cells;
    for (const int n : threads) {
      // A run of new views alone has a table of its own.
      if (find_beside(report, row.scene.id(), n, kOsmesa, kStartUp) == nullptr) return Row();
      for (const char* what : {kStartUp, kNewVertices, kNewViews, kAgain}) {
        cells.push_back(shown(report, row, n, kOsmesa, what, left_out));
      }
    }
    return cells;
  });
  if (summary.rows.size() == 1) return std::nullopt;
  summary.text += left_out.words();
  return summary;
}

/// How many rays Embree casts at a time.
std::string packet_width(const Report& report) {
  for (const Beside& b : report.beside) {
    if (b.what == beside::kPacket) return fmt::format("{:g}", *b.count);
  }
  return "";
}

std::optional<Summary> beside_embree(const Report& report) {
  using namespace beside;
  Summary summary{
      "embree",
      "Rays beside Embree",
      fmt::format(
          "How many times as fast our ray caster (ray-cast, exact) is as Embree, which is in "
          "single "
          "precision: the same triangles, one ray a pixel through its centre, as many threads on "
          "both sides. Embree casts coherent packets of {} rays, as wide as this processor's "
          "vectors, of which what is the same for all is filled in once; its device is there and "
          "its triangles are in its own form. Rays: cast at a tree that is there, and for each "
          "pixel what is hit is noted. Building: making that tree, ours with the edges and planes "
          "of the triangles. Moderate and high are the qualities of Embree's tree.",
          packet_width(report)),
      {{"scene", "polygons", "picture"}}};
  const std::vector<int> threads = threads_of(report, kEmbree);
  const std::array<std::pair<const char*, const char*>, 2> qualities{
      std::pair(kEmbree, "moderate"), std::pair(kEmbreeHigh, "high")};
  for (const int n : threads) {
    for (const char* what : {kRays, kBuilding}) {
      for (const auto& [other, quality] : qualities) {
        summary.rows.front().push_back(on_threads(fmt::format("{}, {}", what, quality), n));
      }
    }
  }
  LeftOut left_out;
  add_rows(report, summary, [&](const SceneRow& row) {
    Row cells;
    for (const int n : threads) {
      for (const char* what : {kRays, kBuilding}) {
        for (const auto& [other, quality] : qualities) {
          cells.push_back(shown(report, row, n, other, what, left_out));
        }
      }
    }
    return cells;
  });
  if (summary.rows.size() == 1) return std::nullopt;
  summary.text += left_out.words();
  return summary;
}

/// A row a method: all the scenes together.
std::optional<Summary> exactness(const Report& report) {
  Summary summary{
      "exactness",
      "What exactness costs",
      "The time of a method that decides exactly, over that of the same code without its exact "
      "stages, on one thread: the geometric mean over the scenes, the least and the greatest; and "
      "the wrong pixels that it then has on these scenes. What is timed is the method's own work "
      "on "
      "a viewed scene, from making ready to what is seen at every pixel; of a sort, the sort and "
      "the painting of its order. The code without exact stages has a ROUNDOFF of 0: what doubles "
      "tell is taken. The z-buffer's takes what single precision tells. Without any ROUNDOFF a "
      "sort "
      "would cut what crosses by rounding alone: it has one of 1e-12. The map has no other "
      "precision.",
      {{"method", "exact over rounded", "scenes", "wrong pixels without"}}};
  LeftOut left_out;
  std::vector<std::string> methods;
  for (const Beside& b : report.beside) {
    if (b.other != beside::kRounded) continue;
    if (std::ranges::find(methods, b.what) == methods.end()) methods.push_back(b.what);
  }
  for (const std::string& method : methods) {
    std::vector<double> ratios;
    std::int64_t wrong = 0;
    for (const Beside& b : report.beside) {
      if (b.other != beside::kRounded || b.what != method) continue;
      if (!b.left_out.empty()) {
        left_out.add(b.scene, method, b.left_out);
        continue;
      }
      ratios.push_back(1.0 / b.times_faster->median);
      wrong += static_cast<std::int64_t>(*b.count);
    }
    if (ratios.empty()) continue;
    const Spread range = spread(ratios);
    summary.rows.push_back({method,
                            fmt::format("{:.2f} ({:.2f} to {:.2f})", geometric_mean(ratios),
                                        range.least, range.greatest),
                            fmt::format("{}", ratios.size()), grouped(wrong)});
  }
  if (summary.rows.size() == 1) return std::nullopt;
  summary.text += left_out.words();
  return summary;
}

/// A row a scene: ours and gl2ps's, of the same triangles.
std::optional<Summary> pieces(const Report& report) {
  using namespace beside;
  Summary summary{
      "pieces",
      "Pieces of a triangle, beside gl2ps",
      "Pieces that a sort makes of a triangle, 1 if it cut nothing; of the map those that are "
      "seen, since what is hidden is in none. All get the same triangles, gl2ps's in single "
      "precision, with and without GL2PS_BEST_ROOT; and how many "
      "times "
      "as fast ours is as each, on one thread by the processor's time, as gl2ps has but one. Timed "
      "is the sort alone: ours from the triangles to the order and the points of its pieces, "
      "gl2ps's "
      "gl2psEndPage in a format that writes no polygons, without the handing over.",
      {{"scene", "triangles"}}};
  Row& head = summary.rows.front();
  Row ours;
  for (const HiddenMethod method : kObjectSpaceMethods) ours.emplace_back(name_of(method));
  head.insert(head.end(), ours.begin(), ours.end());
  head.insert(head.end(), {kGl2ps, kGl2psBestRoot});
  for (const std::string& name : ours) {
    head.insert(head.end(), {name + " beside gl2ps", name + " beside best root"});
  }
  LeftOut left_out;
  for (const std::string& name : names_but_hard_cases(report)) {
    const SceneRow& row = shown_scene(report, name);
    const auto cell = [&](std::string_view other, std::string_view what) {
      return shown(report, row, 1, other, what, left_out);
    };
    const Beside* const triangles = find_beside(report, row.scene.id(), 1, kGl2ps, kTriangles);
    if (triangles == nullptr) continue;
    Row of_scene{short_name(name), grouped(static_cast<std::int64_t>(*triangles->count))};
    for (const std::string& method : ours) of_scene.push_back(cell(method, kPieces));
    for (const char* peer : {kGl2ps, kGl2psBestRoot}) of_scene.push_back(cell(peer, kPieces));
    for (const std::string& method : ours) {
      for (const char* peer : {kGl2ps, kGl2psBestRoot}) of_scene.push_back(cell(peer, method));
    }
    summary.rows.push_back(std::move(of_scene));
  }
  if (summary.rows.size() == 1) return std::nullopt;
  summary.text += left_out.words();
  return summary;
}

std::optional<Summary> which_when(const Report& report) {
  Summary summary{"advice",
                  "Which method when",
                  "From this run alone; times are in those of " + report.reference +
                      ", geometric means over the scenes from which no method was left out. Of "
                      "methods within a tenth of the fastest the first of the tables is named.",
                  {{"for", "use", "why"}}};
  for (const Advice& a : advice(report)) summary.rows.push_back({a.purpose, a.use, a.reason});
  if (summary.rows.size() == 1) return std::nullopt;
  return summary;
}

/// The purposes that the method is advised for, in short.
std::string used_for(const std::vector<Advice>& all, const Column& column) {
  std::string text;
  for (const Advice& a : all) {
    if (a.use != column.name()) continue;
    text += (text.empty() ? "" : "; ") + a.purpose.substr(0, a.purpose.find(':'));
  }
  return text;
}

/// The geometric mean of the pieces that a sort, ours or another's, or the map makes of a triangle;
/// empty if it has none on one of the scenes.
std::string pieces_a_triangle(const Report& report, const Rows& rows, const Column& column) {
  const bool has_pieces = is_in_object_space(column.method);
  const std::string whose = has_pieces ? column.method : beside::kGl2psBestRoot;
  if (!has_pieces && column.name() != beside::kGl2psBestRootColumn) return "";
  std::vector<double> each;
  for (const SceneRow* row : rows) {
    const Beside* const found = find_beside(report, row->scene.id(), 1, whose, beside::kPieces);
    if (found == nullptr || !found->count) return "";
    each.push_back(*found->count);
  }
  return fmt::format("{:.3g}", geometric_mean(each));
}

/// A sentence that stands beside figures of the hard cases.
std::string about_hard_cases(const Report& report, std::size_t count) {
  return fmt::format(
      "{} stress scenes of {} pixels each: the hard cases, which are made so that rounding decides",
      count, picture_sizes_of_hard_cases(report));
}

std::string in_a_hundred(const Wrong& wrong) {
  return wrong.pixels == 0 ? "" : fmt::format("{:.3g}", wrong.percent());
}

/// One screen: a row a method or peer, of the precisions of one those in a series.
std::optional<Summary> methods(const Report& report) {
  const auto shown = [](const Column& c) { return is_in_series(c); };
  const Rows still = still_scenes(report);
  const Rows rows = with_nothing_left_out(report, still, shown);
  if (rows.empty()) return std::nullopt;
  const auto hard_cases = static_cast<std::size_t>(std::ranges::count(
      report.scenes, BenchScene::Kind::hard_case, [](const SceneRow& r) { return r.scene.kind; }));
  std::string names;
  for (const SceneRow* row : rows) {
    names += (names.empty() ? "" : ", ") + short_name(row->scene.name);
  }
  Summary summary{
      "methods",
      "Methods",
      fmt::format(
          "Times of a picture in those of {}, geometric means over the {} scenes from which "
          "none was left out ({}): anew, from the display file; and the same picture again. A peer "
          "is "
          "warm, and has the polygons in its own form. gl2ps sorts, and draws no pixels. Wrong "
          "pixels are in a hundred of all: {}. Pieces are those of a triangle, of the same "
          "triangles; the map's are those that are seen.",
          report.reference, rows.size(), names,
          hard_cases == 0
              ? "of the scenes that were timed"
              : "of the scenes that were timed, and of " + about_hard_cases(report, hard_cases)),
      {{"method", "anew", "again", "wrong, %: scenes timed"}}};
  Row& head = summary.rows.front();
  if (hard_cases > 0) {
    head.push_back(fmt::format("wrong, %: stress scenes, {}", picture_sizes_of_hard_cases(report)));
  }
  head.insert(head.end(), {"bytes a polygon", "pieces", "advised for"});
  const std::vector<Advice> advised = advice(report);
  const auto mean_of = [&](const Column& column, const auto& value) -> std::string {
    const auto all = means(
        report, rows, [&](const Column& c) { return c == column; }, value);
    return all.empty() ? "" : fmt::format("{:.3g}", all.front().time);
  };
  for (const Column& column : columns(report)) {
    if (!shown(column)) continue;
    const std::string anew = mean_of(column, time_of);
    if (anew.empty()) continue;
    std::vector<double> bytes;
    for (const SceneRow* row : rows) {
      const Cell* cell = measured(*row, column.method, column.precision);
      if (!cell->bytes) continue;
      bytes.push_back(static_cast<double>(std::max<std::int64_t>(1, *cell->bytes)) /
                      static_cast<double>(std::max<std::size_t>(1, row->polygons)));
    }
    Row cells{column.name(), anew,
              mean_of(column,
                      [](const Cell& cell) {
                        return cell.again ? std::optional(cell.again->median) : std::nullopt;
                      }),
              in_a_hundred(wrong_pixels(rows, column))};
    if (hard_cases > 0) cells.push_back(in_a_hundred(wrong_pixels(report, "", column)));
    cells.insert(cells.end(), {bytes.empty() ? "" : fmt::format("{:.0f}", geometric_mean(bytes)),
                               pieces_a_triangle(report, rows, column), used_for(advised, column)});
    summary.rows.push_back(std::move(cells));
  }
  if (summary.rows.size() == 1) return std::nullopt;
  return summary;
}

/// Who is on a front: name, time, and the errors.
std::string listed(const std::vector<SpeedAndError>& front, bool has_hard_cases) {
  std::string text;
  for (const SpeedAndError& one : front) {
    text += fmt::format("{}{} (time {:.3g}, {:.3g} % wrong", text.empty() ? "" : "; ",
                        one.column.name(), one.time, one.percent_timed);
    if (has_hard_cases)
      text += fmt::format(" of the scenes timed, {:.3g} % of the stress scenes", one.percent);
    text += ")";
  }
  return text;
}

/// Who is on the fronts, in words.
std::optional<Summary> front(const Report& report) {
  const auto found = front_of_all(report);
  if (!found) return std::nullopt;
  const bool has_hard_cases = found->hard_cases > 0;
  const std::string timed = listed(found->front_timed, has_hard_cases);
  const std::string stress = listed(found->front, has_hard_cases);
  std::string text =
      timed == stress
          ? fmt::format("On the front, from fastest to most accurate: {}.", timed)
          : fmt::format(
                "On the front, from fastest to most accurate, by the errors of the scenes timed: "
                "{}. By those of the stress scenes: {}.",
                timed, stress);
  text += fmt::format(
      " For anything else something is both faster and more accurate. Time is that of a picture "
      "from the display file, in those of {}, the geometric mean over the {} scene{} from which no "
      "method was left out{}; peers are warm, and have the polygons in their own form. Errors are "
      "pixels in a hundred whose polygon is not the one that exact arithmetic gives",
      report.reference, found->scenes, found->scenes == 1 ? "" : "s",
      found->scenes_left_out == 0 ? ""
                                  : fmt::format(" ({} more do not count)", found->scenes_left_out));
  text += has_hard_cases ? fmt::format(": of the scenes timed, and of {}.",
                                       about_hard_cases(report, found->hard_cases))
                         : ", of these scenes.";
  return Summary{"front", "Speed against error", text, {}};
}

std::optional<Summary> automatic(const Report& report) {
  const auto bounds = auto_bounds(report);
  if (!bounds) return std::nullopt;
  return Summary{
      "auto",
      "The method that picks itself",
      fmt::format(
          "--hidden auto draws pixels by the z-buffer, whatever the scene. Over {} scenes it "
          "takes {} times what the best fixed method takes in total ({}); at worst it takes "
          "{} times the best method on a scene ({}, where {} is best). --explain says what it "
          "picks, for vectors too.",
          bounds->scenes, number(bounds->total), bounds->best_fixed, number(bounds->worst),
          bounds->worst_scene, bounds->best_there),
      {}};
}

/// Scenes of which the rounding of viewing is told together.
struct ViewingGroup {
  std::string name;
  bool (*has)(const BenchScene& scene);
};

/// A gap of 10^-11 is far above the rounding of viewing, which is some 10^-16 times a few.
constexpr double kSmallestFarGap = 11.0;

const std::array<ViewingGroup, 6>& viewing_groups() {
  using Kind = BenchScene::Kind;
  static const std::array<ViewingGroup, 6> groups{{
      {"meshes",
       [](const BenchScene& s) { return s.kind == Kind::input && !is_drawing_program(s.name); }},
      {"drawing programs",
       [](const BenchScene& s) { return s.kind == Kind::input && is_drawing_program(s.name); }},
      {"generated scenes",
       [](const BenchScene& s) { return s.kind == Kind::generated || s.kind == Kind::surface; }},
      {"hard cases, gap from 1e-1 to 1e-11",
       [](const BenchScene& s) { return s.gap && s.severity <= kSmallestFarGap; }},
      {"hard cases, gap below that",
       [](const BenchScene& s) { return s.gap && s.severity > kSmallestFarGap; }},
      {"hard cases of other kinds",
       [](const BenchScene& s) { return s.kind == Kind::hard_case && !s.gap; }},
  }};
  return groups;
}

/// The names of those that differ, the ones with the most pixels first, and how many more.
std::string where_viewing_decides(std::vector<const ViewingRow*> rows) {
  constexpr std::size_t kNamed = 4;
  std::vector<std::pair<std::string, std::size_t>> names;
  for (const ViewingRow* row : rows) {
    if (row->different == 0) continue;
    const std::string name = short_name(row->scene.name);
    const auto known = std::ranges::find(names, name, [](const auto& n) { return n.first; });
    if (known == names.end()) {
      names.emplace_back(name, row->different);
    } else {
      known->second += row->different;
    }
  }
  std::ranges::stable_sort(names, std::greater(), [](const auto& n) { return n.second; });
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i) {
    text += fmt::format("{}{} ({})", i == 0 ? "" : ", ", names[i].first, names[i].second);
  }
  if (names.size() > kNamed) text += fmt::format(" and {} more", names.size() - kNamed);
  return text;
}

std::optional<Summary> viewing(const Report& report) {
  Summary summary{
      "viewing",
      "Where exactness begins",
      fmt::format(
          "Exact means: from the coordinates in the display file. Viewing rounds to doubles before "
          "that. Counted here are pixels in which the truth of the display file differs from that "
          "of the world, which is viewed in exact arithmetic (displayfile truth --from world; "
          "of hard cases of what touches, --from entered); scenes in the unit cube are entered "
          "through a turned perspective view. Of these, ties: "
          "both polygons are there, within {:g} of the view volume's depth, as where polygons "
          "coincide in the world. In the others an edge or a plane seen edge-on runs through the "
          "pixel centre but for rounding, or a slope, a size or an image transformation is so "
          "large "
          "that it makes rounding seen.",
          ViewingRow::kTie),
      {{"scenes", "number", "pixels", "differ", "of these ties", "where"}}};
  for (const ViewingGroup& group : viewing_groups()) {
    std::vector<const ViewingRow*> rows;
    ViewingRow sum{};
    for (const ViewingRow& row : report.viewing) {
      if (!group.has(row.scene)) continue;
      rows.push_back(&row);
      sum.pixels += row.pixels;
      sum.different += row.different;
      sum.ties += row.ties;
    }
    if (rows.empty()) continue;
    const auto count = [](std::size_t n) { return grouped(static_cast<std::int64_t>(n)); };
    summary.rows.push_back({group.name, count(rows.size()), count(sum.pixels), count(sum.different),
                            count(sum.ties), where_viewing_decides(rows)});
  }
  if (summary.rows.size() == 1) return std::nullopt;
  return summary;
}

struct Entry {
  std::string_view name;
  std::optional<Summary> (*of)(const Report&);
};
constexpr std::array kEntries{
    Entry{"front", front},
    Entry{"methods", methods},
    Entry{"lines", hidden_lines},
    Entry{"surfaces", hidden_lines_of_surfaces},
    Entry{"moving-camera", moving_camera},
    Entry{"osmesa", beside_osmesa},
    Entry{"embree", beside_embree},
    Entry{"pieces", pieces},
    Entry{"exactness", exactness},
    Entry{"advice", which_when},
    Entry{"auto", automatic},
    Entry{"wrong-pixels", wrong_pixels_of_hard_cases},
    Entry{"viewing", viewing},
};

}  // namespace

bool Summary::is_of_numbers(std::size_t column) const {
  return std::ranges::all_of(rows.begin() + 1, rows.end(), [&](const auto& row) {
    return row[column].empty() || row[column] == kSkipped ||
           std::string_view("0123456789").find(row[column].front()) != std::string_view::npos;
  });
}

std::vector<Summary> summaries(const Report& report) {
  std::vector<Summary> all;
  for (const Entry& entry : kEntries) {
    if (auto summary = entry.of(report)) all.push_back(std::move(*summary));
  }
  return all;
}

std::vector<std::string> summary_names() {
  std::vector<std::string> names;
  names.reserve(kEntries.size());
  for (const Entry& entry : kEntries) names.emplace_back(entry.name);
  return names;
}

}  // namespace displayfile::bench
