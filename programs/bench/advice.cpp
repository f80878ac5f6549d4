#include "programs/bench/advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <span>

#include "programs/bench/analysis.h"
#include "programs/bench/contenders.h"
#include "programs/bench/json_report.h"
#include "programs/bench/walk.h"

namespace displayfile::bench {

namespace {

/// What is less than this part of another's time is clearly faster: two runs agree on it.
constexpr double kClearly = 0.9;

/// The first in the tables of those that none is clearly faster than.
const Mean& best_of(std::span<const Mean> by_time) {
  const double most = by_time.front().time / kClearly;
  const auto end = std::ranges::find_if(by_time, [&](const Mean& m) { return m.time > most; });
  return *std::min_element(by_time.begin(), end,
                           [](const Mean& a, const Mean& b) { return a.place < b.place; });
}

/// True for the fixed methods that are exact, one of which is to be advised.
bool is_exact(const Column& column) { return column.exact && !column.is_automatic(); }

std::string listed(std::span<const Mean> all) {
  std::string text;
  for (const Mean& mean : all) {
    const Column& column = mean.column;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                        column.exact ? column.method : column.method + " with " + column.precision,
                        number(mean.time));
  }
  return text;
}

/// The fastest.
std::string first_of(const std::vector<Mean>& all) {
  return listed(std::span(all).first(std::min<std::size_t>(3, all.size())));
}

std::int64_t wrong_in(const Rows& rows, const Column& column) {
  std::int64_t wrong = 0;
  for (const SceneRow* row : rows) {
    const Cell* cell = measured(*row, column.method, column.precision);
    if (cell != nullptr) wrong += cell->wrong_pixels;
  }
  return wrong;
}

/// What the figures rest on, in words.
std::string over(const Rows& rows, std::size_t of) {
  const std::size_t left_out = of - rows.size();
  return fmt::format("{} scene{}{}", rows.size(), rows.size() == 1 ? "" : "s",
                     left_out == 0
                         ? ""
                         : fmt::format(" ({} more, from which an exact method was left out, "
                                       "do not count)",
                                       left_out));
}

/// Only what is in polygons can be written as vectors.
std::optional<Advice> plot_in_a_paper(const Report& report) {
  const Rows still = still_scenes(report);
  const auto gives_polygons = [](const Column& c) {
    return c.exact && is_in_object_space(c.method);
  };
  const Rows rows = with_nothing_left_out(report, still, gives_polygons);
  const auto fragments =
      means(report, rows, is_exact, [](const Cell& cell) { return cell.fragments; });
  if (rows.empty() || fragments.empty()) return std::nullopt;
  const Mean& best = fragments.front();
  Advice advice{"A plot in a paper: vectors, drawn once",
                best.column.name(),
                fmt::format("pixels cannot be scaled, so only the methods in object space draw "
                            "vectors; pieces of a polygon, over {}: {}",
                            over(rows, still.size()), listed(fragments)),
                {}};
  advice.why.emplace_back(
      "Vectors need polygons, in an order as from a sort or without overlap as from the map; an "
      "image-space method gives pixels.");
  advice.why.push_back(fmt::format(
      "Fragments a polygon (geometric mean over {}): {}. Fewer pieces are a smaller file; "
      "the map's are those alone that are seen.",
      over(rows, still.size()), listed(fragments)));
  const auto times = means(report, rows, gives_polygons, time_of);
  advice.why.push_back(fmt::format("Time of a picture, in reference times: {}.", listed(times)));
  for (const Column& column : columns(report)) {
    if (column.method != best.column.method || column.exact) continue;
    advice.why.push_back(fmt::format(
        "With {} the same method has {} wrong pixels on these scenes and {} on the hard cases; "
        "exact "
        "has {} and {}.",
        column.precision, wrong_in(rows, column), wrong_pixels(report, "", column).wrong,
        wrong_in(rows, best.column), wrong_pixels(report, "", best.column).wrong));
  }
  return advice;
}

/// Every view is a new one: nothing of a picture can be kept but what does not depend on the view.
std::optional<Advice> game_level(const Report& report) {
  const auto walks = names(report, BenchScene::Kind::walk);
  if (walks.empty()) return std::nullopt;
  const auto retained = [](const Column& c) { return c.precision == "retained tree"; };
  const auto wanted = [&](const Column& c) { return is_exact(c) || retained(c); };
  const Rows rows = with_nothing_left_out(report, {&shown_scene(report, walks.front())}, wanted);
  const auto times = means(report, rows, wanted,
                           [](const Cell& cell) { return std::optional(cell.again->median); });
  if (times.empty()) return std::nullopt;
  const Column& best = best_of(times).column;
  Advice advice{
      "A game level walked through",
      best.name(),
      fmt::format("each view is a new one; {} wrong pixels in {} views of {} polygons; time: {}",
                  wrong_in(rows, best), kViewsOfWalk, rows.front()->polygons, first_of(times)),
      {}};
  std::string list;
  for (const Mean& mean : times) {
    list += fmt::format("{}{} {} ({} wrong pixels)", list.empty() ? "" : ", ", mean.column.name(),
                        number(mean.time), wrong_in(rows, mean.column));
  }
  advice.why.push_back(fmt::format(
      "Time of {} of {} polygons, each view clipped and drawn anew, in reference times: {}.",
      rows.front()->scene.id(), rows.front()->polygons, list));
  const Cell* tree = measured(*rows.front(), "bsp", "retained tree");
  if (tree != nullptr) {
    advice.why.push_back(fmt::format(
        "The retained tree is built once, in world coordinates, and then only walked: with its "
        "building these views take {}. It sees world coordinates, so it may differ where the "
        "view's own rounding decides.",
        number(tree->time.median)));
  }
  return advice;
}

std::optional<Advice> huge_image(const Report& report) {
  Rows large;
  for (const std::string& name : names_but_hard_cases(report)) {
    const auto scenes = series(report, name, Fit::Against::pixels);
    if (!scenes.empty()) large.push_back(scenes.back());
  }
  const Rows rows = with_nothing_left_out(report, large, is_exact);
  std::size_t pixels = 0;
  for (const SceneRow* row : rows) pixels = std::max(pixels, row->scene.pixels());
  const auto times = means(report, rows, is_exact, time_of);
  if (rows.empty() || times.empty()) return std::nullopt;
  const Column& best = best_of(times).column;
  Advice advice{"A huge image",
                best.name(),
                fmt::format("time at {} pixels, over {}: {}", pixels, over(rows, large.size()),
                            first_of(times)),
                {}};
  advice.why.push_back(fmt::format(
      "At {} pixels, the most of this run, the exact methods take, in reference times (geometric "
      "mean over {}): {}. Wrong pixels of {} there: {}.",
      pixels, over(rows, large.size()), listed(times), advice.use, wrong_in(rows, best)));
  std::map<std::string, std::vector<double>> exponents;
  for (const Fit& fit : fits(report)) {
    if (fit.against == Fit::Against::pixels && fit.precision == "exact") {
      exponents[fit.method].push_back(fit.exponent);
    }
  }
  std::string grow;
  for (auto& [method, values] : exponents) {
    grow += fmt::format("{}{} {}", grow.empty() ? "" : ", ", method,
                        number(figure(spread(values).median)));
  }
  advice.why.push_back(fmt::format(
      "How they grow with the number of pixels (exponent, median over the scenes): {}.", grow));
  return advice;
}

std::optional<Advice> thin_sheets(const Report& report) {
  Rows rows;
  for (const SceneRow& row : report.scenes) {
    if (row.scene.gap && row.scene.severity >= 9.0 && row.scene.severity <= 13.0) {
      rows.push_back(&row);
    }
  }
  rows = with_nothing_left_out(report, rows, is_exact);
  const auto times = means(report, rows, is_exact, time_of);
  if (rows.empty() || times.empty()) return std::nullopt;
  const Column& best = best_of(times).column;
  Advice advice{"A stack of thin sheets: depths 1e-9 apart and less",
                best.name(),
                fmt::format("the exact methods have {} wrong pixels there; time: {}",
                            wrong_in(rows, best), first_of(times)),
                {}};
  std::string exact, others, last;
  std::int64_t pixels = 0;
  for (const SceneRow* row : rows) pixels += static_cast<std::int64_t>(row->scene.pixels());
  for (const Column& column : columns(report)) {
    if (measured(*rows.front(), column.method, column.precision) == nullptr) continue;
    std::string& list = column.exact ? exact : others;
    const double percent =
        100.0 * static_cast<double>(wrong_in(rows, column)) / static_cast<double>(pixels);
    if (column.exact || column.precision.empty()) {
      list += fmt::format("{}{} {:.3g}", list.empty() ? "" : "; ", column.method, percent);
    } else {
      const bool same = last == column.method;
      list += fmt::format("{}{} {:.3g}",
                          same           ? ", "
                          : list.empty() ? column.method + " with "
                                         : "; " + column.method + " with ",
                          column.precision, percent);
      last = column.method;
    }
  }
  advice.why.push_back(fmt::format(
      "Wrong pixels in a hundred over {} scenes whose gap is 1e-9 to 1e-13, of the exact methods: "
      "{}.",
      rows.size(), exact));
  advice.why.push_back(fmt::format("Of the others: {}.", others));
  advice.why.push_back(
      fmt::format("Time of the exact methods there, in reference times (geometric mean): {}. These "
                  "are small pictures, of {} pixels.",
                  listed(times), rows.front()->scene.pixels()));
  return advice;
}

std::optional<Advice> fastest_exact(const Report& report) {
  const Rows still = still_scenes(report);
  const Rows rows = with_nothing_left_out(report, still, is_exact);
  const auto times = means(report, rows, is_exact, time_of);
  if (times.empty()) return std::nullopt;
  const Column& usual = best_of(times).column;
  Advice advice{
      "Any other picture of pixels",
      usual.name(),
      fmt::format("least time of a picture over {}: {}", over(rows, still.size()), first_of(times)),
      {}};
  advice.why.push_back(
      fmt::format("The least time of a picture over {} (geometric mean, in reference times): {}.",
                  over(rows, still.size()), listed(times)));
  for (const SceneRow* row : rows) {
    const Cell* best = measured(*row, usual.method, usual.precision);
    if (best == nullptr) continue;
    const double least = kClearly * best->time.median;
    for (const Cell& cell : row->cells) {
      const bool fixed = cell.key.method != name_of(HiddenMethod::automatic);
      const bool better = cell.time.median < std::min(least, best->time.median);
      if (cell.skipped.empty() && cell.key.threads == 1 && cell.exact && fixed && better) {
        best = &cell;
      }
    }
    if (best->key.method == usual.method) continue;
    advice.why.push_back(fmt::format("But on {}: {}, at {}.", row->scene.id(), best->key.method,
                                     number(best->time.median)));
  }
  return advice;
}

}  // namespace

std::vector<Advice> advice(const Report& report) {
  std::vector<Advice> all;
  for (const auto& of : {plot_in_a_paper, game_level, huge_image, thin_sheets, fastest_exact}) {
    if (auto found = of(report)) all.push_back(std::move(*found));
  }
  return all;
}

}  // namespace displayfile::bench
