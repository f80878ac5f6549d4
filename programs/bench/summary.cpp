#include "programs/bench/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "programs/bench/advice.h"
#include "programs/bench/analysis.h"
#include "programs/bench/json_report.h"
#include "programs/inputs.h"

namespace displayfile::bench {

namespace {

using Row = std::vector<std::string>;

std::string_view reference_method() { return name_of(HiddenMethod::z_buffer); }

/// A ratio as it is read: 0.42, 3.2, 17.
std::string times(double ratio) {
  return fmt::format("{:.{}f}", ratio, ratio < 1.0 ? 2 : ratio < 9.95 ? 1 : 0);
}

/// With a comma after the thousands.
std::string grouped(std::int64_t count) {
  const std::string digits = fmt::format("{}", count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

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

/// The scene of that name with the largest picture, and of several such the one with the most
/// polygons.
const SceneRow& largest_picture(const Report& report, std::string_view name) {
  const SceneRow* largest = nullptr;
  for (const SceneRow& row : report.scenes) {
    if (row.scene.name != name) continue;
    const auto rank = [](const SceneRow& r) { return std::pair(r.scene.size, r.polygons); };
    if (largest == nullptr || rank(row) > rank(*largest)) largest = &row;
  }
  return *largest;
}

/// How many times as fast the reference is as a peer; empty if one of them was not measured.
struct Faster {
  std::string first, again, threads;
};
Faster faster(const SceneRow& row, std::string_view peer, std::string_view precision, int threads) {
  const Cell* theirs = measured(row, peer, precision);
  if (theirs == nullptr) return {};
  Faster result{times(theirs->time.median), "", ""};  // in reference times
  const Cell* ours = measured(row, reference_method(), "exact");
  if (ours != nullptr && ours->again && theirs->again) {
    result.again = times(theirs->again->median / ours->again->median);
  }
  const Cell* together = measured(row, reference_method(), "exact", threads);
  if (threads > 1 && together != nullptr) {
    result.threads = times(theirs->time.median / together->time.median);
  }
  return result;
}

std::optional<Summary> speed(const Report& report) {
  const int threads = most_threads(report);
  Summary summary{
      "speed",
      "Speed beside others",
      "How many times as fast the exact z-buffer is as OSMesa with 24 bits of depth and as "
      "Embree's "
      "primary rays, from the same display file, on one thread each, by the processor's time. A "
      "first picture makes everything anew: OSMesa's its context and its vertex buffers, and it is "
      "read back; Embree's its scene. Again is the same picture with what is kept, OSMesa's not "
      "read "
      "back.",
      {{"scene", "polygons", "picture", "OSMesa, first", "OSMesa, again"}}};
  Row& head = summary.rows.front();
  if (threads > 1) head.push_back(fmt::format("OSMesa, first, ours on {} threads", threads));
  head.insert(head.end(), {"Embree, first", "Embree, again"});
  for (const std::string& name : names_but_hard_cases(report)) {
    const SceneRow& row = largest_picture(report, name);
    if (row.scene.kind == BenchScene::Kind::walk) continue;
    const Faster osmesa = faster(row, "osmesa", "24 bits", threads);
    const Faster embree = faster(row, "embree", "single", 1);
    if (osmesa.first.empty() && embree.first.empty()) continue;
    Row cells{short_name(row.scene.name), grouped(static_cast<std::int64_t>(row.polygons)),
              fmt::format("{0} x {0}", row.scene.size), osmesa.first, osmesa.again};
    if (threads > 1) cells.push_back(osmesa.threads);
    cells.insert(cells.end(), {embree.first, embree.again});
    summary.rows.push_back(std::move(cells));
  }
  if (summary.rows.size() == 1) return std::nullopt;
  return summary;
}

/// The method's exact time over its time with a ROUNDOFF, on each scene measured with both.
std::vector<double> costs_of_exactness(const Report& report, const std::string& method,
                                       const std::string& precision) {
  std::vector<double> ratios;
  for (const SceneRow& row : report.scenes) {
    if (row.scene.kind == BenchScene::Kind::hard_case) continue;
    const Cell* exact = measured(row, method, "exact");
    const Cell* rounded = measured(row, method, precision);
    if (exact == nullptr || rounded == nullptr) continue;
    ratios.push_back(exact->time.median / rounded->time.median);
  }
  return ratios;
}

std::optional<Summary> exactness(const Report& report) {
  const std::vector<Column> all = columns(report);
  const Row precisions = roundoffs(all);
  Summary summary{"exactness",
                  "What exactness costs",
                  "The time of a method that decides exactly, over its time with a ROUNDOFF: the "
                  "geometric mean over the scenes that were measured with both, and the least and "
                  "the greatest.",
                  {{"method"}}};
  Row& head = summary.rows.front();
  head.insert(head.end(), precisions.begin(), precisions.end());
  for (const std::string& method :
       distinct(all, &Column::method, [](const Column& c) { return is_roundoff(c.precision); })) {
    Row row{method};
    for (const std::string& precision : precisions) {
      const auto ratios = costs_of_exactness(report, method, precision);
      if (ratios.empty()) {
        row.emplace_back();
        continue;
      }
      const Spread range = spread(ratios);
      row.push_back(fmt::format("{:.2f} ({:.2f} to {:.2f})", geometric_mean(ratios), range.least,
                                range.greatest));
    }
    if (std::ranges::any_of(row.begin() + 1, row.end(), [](const auto& t) { return !t.empty(); })) {
      summary.rows.push_back(std::move(row));
    }
  }
  if (summary.rows.size() == 1) return std::nullopt;
  return summary;
}

/// On the scene of the name with the most polygons, in the largest picture where it was measured.
std::optional<double> fragments(const Report& report, const SceneRow& shown, const Column& column) {
  std::optional<double> found;
  int size = 0;
  for (const SceneRow& row : report.scenes) {
    if (row.scene.name != shown.scene.name || row.polygons != shown.polygons) continue;
    const Cell* cell = measured(row, column.method, column.precision);
    if (cell == nullptr || !cell->fragments || row.scene.size < size) continue;
    found = cell->fragments;
    size = row.scene.size;
  }
  return found;
}

/// A row a scene, a column a sort: the exact ones, and the peers'.
std::optional<Summary> pieces(const Report& report) {
  std::vector<const SceneRow*> scenes;
  for (const std::string& name : names_but_hard_cases(report)) {
    scenes.push_back(&shown_scene(report, name));
  }
  std::vector<Column> sorts = columns(report);
  std::erase_if(sorts, [&](const Column& column) {
    return is_roundoff(column.precision) || std::ranges::none_of(scenes, [&](const SceneRow* row) {
             return fragments(report, *row, column).has_value();
           });
  });
  if (sorts.empty()) return std::nullopt;
  Summary summary{"pieces",
                  "Pieces of a polygon",
                  "Pieces that a sort makes of a polygon; 1 is a sort that cut nothing. gl2ps gets "
                  "triangles.",
                  {{"scene", "polygons"}}};
  for (const Column& column : sorts) summary.rows.front().push_back(column.name());
  for (const SceneRow* shown : scenes) {
    Row row{short_name(shown->scene.name), grouped(static_cast<std::int64_t>(shown->polygons))};
    bool any = false;
    for (const Column& column : sorts) {
      const auto each = fragments(report, *shown, column);
      row.push_back(each ? fmt::format("{:g}", *each) : "");
      any = any || each;
    }
    if (any) summary.rows.push_back(std::move(row));
  }
  return summary;
}

std::optional<Summary> methods(const Report& report) {
  Summary summary{"methods",
                  "Methods",
                  "Which method when, from this run alone; times are in those of " +
                      report.reference +
                      ", geometric means over the scenes. Of methods within a tenth of the "
                      "fastest the first of the tables is named.",
                  {{"for", "use", "why"}}};
  for (const Advice& a : advice(report)) summary.rows.push_back({a.purpose, a.use, a.reason});
  if (summary.rows.size() == 1) return std::nullopt;
  return summary;
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
      {"generated scenes", [](const BenchScene& s) { return s.kind == Kind::generated; }},
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
          "of the world, which is viewed in exact arithmetic (displayfile truth --from world); "
          "scenes in the unit cube are entered through a turned perspective view. Of these, ties: "
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
    Entry{"viewing", viewing},
    Entry{"methods", methods},
    Entry{"auto", automatic},
    Entry{"speed", speed},
    Entry{"wrong-pixels", wrong_pixels_of_hard_cases},
    Entry{"exactness", exactness},
    Entry{"pieces", pieces},
};

}  // namespace

bool Summary::is_of_numbers(std::size_t column) const {
  return std::ranges::all_of(rows.begin() + 1, rows.end(), [&](const auto& row) {
    return row[column].empty() ||
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
