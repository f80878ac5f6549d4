#include "programs/bench/analysis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>

#include "programs/bench/growth.h"

namespace displayfile::bench {

std::string_view name_of(Fit::Against against) {
  return against == Fit::Against::polygons ? "polygons" : "pixels";
}

namespace {

bool is_series(const SceneRow& row, std::string_view name) {
  return row.scene.name == name && row.scene.kind != BenchScene::Kind::hard_case;
}

}  // namespace

/// The scenes that share what the most of them share.
std::vector<const SceneRow*> series(const Report& report, std::string_view name,
                                    Fit::Against against) {
  const bool by_polygons = against == Fit::Against::polygons;
  std::map<std::size_t, std::vector<const SceneRow*>> groups;
  for (const SceneRow& row : report.scenes) {
    if (!is_series(row, name)) continue;
    const auto size = static_cast<std::size_t>(row.scene.size);
    groups[by_polygons ? size : row.polygons].push_back(&row);
  }
  std::vector<const SceneRow*> largest;
  for (const auto& [shared, rows] : groups) {
    if (rows.size() >= 2 && rows.size() > largest.size()) largest = rows;
  }
  std::ranges::sort(largest, {}, [&](const SceneRow* row) {
    return by_polygons ? row->polygons : static_cast<std::size_t>(row->scene.size);
  });
  return largest;
}

const Cell* measured(const SceneRow& row, std::string_view method, std::string_view precision,
                     int threads) {
  const auto cell = std::ranges::find_if(row.cells, [&](const Cell& c) {
    return c.key.threads == threads && c.key.method == method && c.key.precision == precision;
  });
  return cell == row.cells.end() || !cell->skipped.empty() ? nullptr : &*cell;
}

std::vector<Growth> growth(std::span<const SceneRow* const> scenes, std::string_view method,
                           std::string_view precision) {
  std::vector<Growth> points;
  for (const SceneRow* row : scenes) {
    const Cell* cell = measured(*row, method, precision);
    if (cell == nullptr || !row->growth) continue;
    const auto polygons = static_cast<double>(row->polygons);
    const bool by_polygons = scenes.front()->polygons != scenes.back()->polygons;
    points.push_back({by_polygons ? polygons : static_cast<double>(row->scene.pixels()),
                      cell->time.median * row->growth->median});
  }
  return points;
}

std::vector<Fit> fits(const Report& report) {
  std::vector<Fit> all;
  for (const std::string& name : names_but_hard_cases(report)) {
    for (const Fit::Against against : {Fit::Against::polygons, Fit::Against::pixels}) {
      const auto scenes = series(report, name, against);
      if (scenes.empty()) continue;
      for (const Column& column : columns(report)) {
        std::vector<double> sizes, times;
        for (const Growth& g : growth(scenes, column.method, column.precision)) {
          sizes.push_back(g.size);
          times.push_back(g.time);
        }
        if (sizes.size() < 2) continue;
        all.push_back({name, column.method, column.precision, against, sizes.size(),
                       figure(fitted_exponent(sizes, times))});
      }
    }
  }
  return all;
}

std::vector<const Cell*> pareto_front(const SceneRow& row) {
  std::vector<const Cell*> front;
  for (const Cell& cell : row.cells) {
    if (cell.skipped.empty() && cell.key.threads == 1) front.push_back(&cell);
  }
  std::ranges::sort(front, [](const Cell* a, const Cell* b) {
    return std::pair(a->time.median, a->wrong_pixels) < std::pair(b->time.median, b->wrong_pixels);
  });
  std::int64_t fewest = std::numeric_limits<std::int64_t>::max();
  std::erase_if(front, [&](const Cell* cell) {
    if (cell->wrong_pixels >= fewest) return true;
    fewest = cell->wrong_pixels;
    return false;
  });
  return front;
}

std::optional<AutoBounds> auto_bounds(const Report& report) {
  const std::vector<Column> all = columns(report);
  const auto automatic = std::ranges::find_if(all, &Column::is_automatic);
  if (automatic == all.end()) return std::nullopt;
  AutoBounds bounds{0, 0.0, "", 0.0, "", "", 0};
  double total = 0.0;
  std::map<std::string, double> totals;  // infinite where a scene was skipped
  for (const SceneRow& row : report.scenes) {
    const Cell* const own = measured(row, automatic->method, automatic->precision);
    if (own == nullptr) continue;
    const Cell* best = nullptr;
    for (const Column& column : all) {
      if (!column.exact || column.is_automatic()) continue;
      const Cell* const cell = measured(row, column.method, column.precision);
      totals[column.name()] +=
          cell == nullptr ? std::numeric_limits<double>::infinity() : cell->time.median;
      if (cell == nullptr) continue;
      if (best == nullptr || cell->time.median < best->time.median) best = cell;
    }
    if (best == nullptr) continue;
    ++bounds.scenes;
    total += own->time.median;
    const double ratio = own->time.median / best->time.median;
    bounds.above_twice += ratio > 2.0 ? 1 : 0;
    if (ratio <= bounds.worst) continue;
    bounds.worst = figure(ratio);
    bounds.worst_scene = row.scene.id();
    bounds.best_there = best->key.contender();
  }
  if (bounds.scenes == 0) return std::nullopt;
  const auto best = std::ranges::min_element(totals, {}, [](const auto& t) { return t.second; });
  bounds.best_fixed = best->first;
  bounds.total = figure(total / best->second);
  return bounds;
}

const SceneRow& shown_scene(const Report& report, std::string_view name) {
  const SceneRow* shown = nullptr;
  for (const SceneRow& row : report.scenes) {
    if (row.scene.name != name) continue;
    const auto rank = [](const SceneRow& r) { return std::pair(r.polygons, r.scene.size); };
    if (shown == nullptr || rank(row) > rank(*shown)) shown = &row;
  }
  return *shown;
}

const SceneRow& largest_picture(const Report& report, std::string_view name) {
  const SceneRow* largest = nullptr;
  for (const SceneRow& row : report.scenes) {
    if (row.scene.name != name) continue;
    const auto rank = [](const SceneRow& r) { return std::pair(r.scene.size, r.polygons); };
    if (largest == nullptr || rank(row) > rank(*largest)) largest = &row;
  }
  return *largest;
}

std::string short_name(const std::string& scene) {
  return std::filesystem::path(scene).stem().string();
}

std::vector<std::string> names(const Report& report, BenchScene::Kind kind) {
  std::vector<std::string> found;
  for (const SceneRow& row : report.scenes) {
    const bool is_new = found.empty() || found.back() != row.scene.name;
    if (row.scene.kind == kind && is_new) found.push_back(row.scene.name);
  }
  return found;
}

std::vector<std::string> names_but_hard_cases(const Report& report) {
  std::vector<std::string> found = names(report, BenchScene::Kind::generated);
  for (const auto kind :
       {BenchScene::Kind::surface, BenchScene::Kind::walk, BenchScene::Kind::input}) {
    for (const std::string& name : names(report, kind)) found.push_back(name);
  }
  return found;
}

std::vector<const SceneRow*> still_scenes(const Report& report) {
  std::vector<const SceneRow*> rows;
  for (const std::string& name : names_but_hard_cases(report)) {
    const SceneRow& row = shown_scene(report, name);
    if (row.scene.kind != BenchScene::Kind::walk) rows.push_back(&row);
  }
  return rows;
}

int most_threads(const Report& report) {
  int most = 1;
  for (const SceneRow& row : report.scenes) {
    for (const Cell& cell : row.cells) most = std::max(most, cell.key.threads);
  }
  return most;
}

double geometric_mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += std::log(v);
  return values.empty() ? 0.0 : std::exp(sum / static_cast<double>(values.size()));
}

/// In the order of the scene that was measured with the most of them.
std::vector<Column> columns(const Report& report) {
  std::vector<const SceneRow*> rows;
  for (const SceneRow& row : report.scenes) rows.push_back(&row);
  std::ranges::stable_sort(rows, std::greater(),
                           [](const SceneRow* row) { return row->cells.size(); });
  std::vector<Column> found;
  for (const SceneRow* row : rows) {
    for (const Cell& cell : row->cells) {
      const Column column{cell.key.method, cell.key.precision, cell.exact};
      if (std::ranges::find(found, column) == found.end()) found.push_back(column);
    }
  }
  return found;
}

bool is_in_series(const Column& column) {
  constexpr std::array<std::string_view, 6> kOthers{"",        "float",  "double",
                                                    "24 bits", "single", "bsp, best root"};
  return column.exact || std::ranges::find(kOthers, column.precision) != kOthers.end();
}

Rows with_nothing_left_out(const Report& report, Rows rows,
                           const std::function<bool(const Column&)>& wanted) {
  for (const Column& column : columns(report)) {
    if (!wanted(column)) continue;
    const auto is_tried = [&](const SceneRow* row) {
      return std::ranges::any_of(row->cells, [&](const Cell& cell) {
        return cell.key.threads == 1 && cell.key.method == column.method &&
               cell.key.precision == column.precision;
      });
    };
    if (std::ranges::none_of(rows, is_tried)) continue;
    std::erase_if(rows, [&](const SceneRow* row) {
      return measured(*row, column.method, column.precision) == nullptr;
    });
  }
  return rows;
}

std::vector<Mean> means(const Report& report, const Rows& rows,
                        const std::function<bool(const Column&)>& wanted,
                        const std::function<std::optional<double>(const Cell&)>& value) {
  std::vector<Mean> all;
  if (rows.empty()) return all;
  std::size_t place = 0;
  for (const Column& column : columns(report)) {
    ++place;
    if (!wanted(column)) continue;
    std::vector<double> values;
    for (const SceneRow* row : rows) {
      const Cell* cell = measured(*row, column.method, column.precision);
      const auto v = cell == nullptr ? std::nullopt : value(*cell);
      if (v) values.push_back(*v);
    }
    if (values.size() == rows.size()) {
      all.push_back({column, figure(geometric_mean(values)), place});
    }
  }
  std::ranges::stable_sort(all, {}, &Mean::time);
  return all;
}

namespace {

/// Those of `all`, which are in the order of time, that none before is as accurate as.
std::vector<SpeedAndError> front_by(double SpeedAndError::*error, std::vector<SpeedAndError> all) {
  std::ranges::stable_sort(
      all, {}, [&](const SpeedAndError& one) { return std::pair(one.time, one.*error); });
  std::vector<SpeedAndError> front;
  for (SpeedAndError& one : all) {
    if (front.empty() || one.*error < front.back().*error) front.push_back(std::move(one));
  }
  return front;
}

}  // namespace

std::optional<FrontOfAll> front_of_all(const Report& report) {
  const auto any = [](const Column& column) { return !column.is_automatic(); };
  const Rows still = still_scenes(report);
  const Rows rows = with_nothing_left_out(report, still, any);
  FrontOfAll found;
  found.scenes = rows.size();
  found.scenes_left_out = still.size() - rows.size();
  found.hard_cases = static_cast<std::size_t>(std::ranges::count(
      report.scenes, BenchScene::Kind::hard_case, [](const SceneRow& r) { return r.scene.kind; }));
  for (const Mean& mean : means(report, rows, any, time_of)) {
    const double timed = wrong_pixels(rows, mean.column).percent();
    const double percent =
        found.hard_cases > 0 ? wrong_pixels(report, "", mean.column).percent() : timed;
    found.all.push_back({mean.column, mean.time, figure(percent), figure(timed)});
  }
  if (found.all.empty()) return std::nullopt;
  std::ranges::stable_sort(
      found.all, {}, [](const SpeedAndError& one) { return std::pair(one.time, one.percent); });
  found.front = front_by(&SpeedAndError::percent, found.all);
  found.front_timed = front_by(&SpeedAndError::percent_timed, found.all);
  return found;
}

const Beside* find_beside(const Report& report, const std::string& scene, int threads,
                          std::string_view other, std::string_view what) {
  const auto found = std::ranges::find_if(report.beside, [&](const Beside& beside) {
    return beside.scene == scene && beside.threads == threads && beside.other == other &&
           beside.what == what;
  });
  return found == report.beside.end() ? nullptr : &*found;
}

Wrong wrong_pixels(const Rows& rows, const Column& column) {
  Wrong sum;
  for (const SceneRow* row : rows) {
    const Cell* cell = measured(*row, column.method, column.precision);
    if (cell == nullptr) continue;
    sum.wrong += cell->wrong_pixels;
    sum.pixels += static_cast<std::int64_t>(row->scene.pixels());
  }
  return sum;
}

std::string picture_sizes_of_hard_cases(const Report& report) {
  int least = std::numeric_limits<int>::max(), most = 0;
  for (const SceneRow& row : report.scenes) {
    if (row.scene.kind != BenchScene::Kind::hard_case) continue;
    least = std::min(least, row.scene.size);
    most = std::max(most, row.scene.size);
  }
  if (most == 0) return "";
  return least == most ? fmt::format("{0} x {0}", most)
                       : fmt::format("{0} x {0} to {1} x {1}", least, most);
}

Wrong wrong_pixels(const Report& report, std::string_view family, const Column& column,
                   double gap) {
  Wrong sum;
  for (const SceneRow& row : report.scenes) {
    const BenchScene& scene = row.scene;
    if (scene.kind != BenchScene::Kind::hard_case) continue;
    if (!family.empty() && scene.name != family) continue;
    if (gap >= 0.0 && !(scene.gap && scene.severity == gap)) continue;
    const Cell* cell = measured(row, column.method, column.precision);
    if (cell == nullptr) continue;
    sum.wrong += cell->wrong_pixels;
    sum.pixels += static_cast<std::int64_t>(scene.pixels());
  }
  return sum;
}

}  // namespace displayfile::bench
