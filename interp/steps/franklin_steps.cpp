#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hidden/lines/cell_grid.h"
#include "hidden/lines/franklin_finder.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_lines.h"

namespace displayfile {

namespace {

/// Observer of the system's form of Franklin's method (hidden/lines/franklin.md), with cells of
/// several sizes where the original has one: records the cells along a line.
class FranklinSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"grid", 0, "lay grids of cells over the picture, the next of cells twice as wide"},
      {"block", 0, "a polygon that covers a whole cell may be its blocking face: the nearest is"},
      {"", 0, "put each polygon into the cells of its size that it meets, the nearest first,"},
      {"", 1, "but not into those whose blocking face is before all of it"},
      {"line", 0, "for each line that is drawn:"},
      {"all", 1, "behind the blocking faces of the cells that have it: all of it is hidden"},
      {"cells", 1, "for each stretch of it in a cell, grid by grid, largest cells first:"},
      {"blocked", 2, "it is behind the blocking faces there: all of the stretch is hidden"},
      {"", 2, "otherwise hold the line against the polygons of the cell, until it is hidden:"},
      {"misses", 3, "the polygon hides no part of it"},
      {"hides", 3, "where it covers the line and is nearer, there is a hidden part"},
      {"seen", 1, "draw what is hidden nowhere"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"hidden", "Hidden of the line, in shares of it", PanelEntry::Kind::table,
       "by|from|to|where"},
      {"cell", "Polygons in the cells of the stretch, the nearest first", PanelEntry::Kind::list},
      {"grids", "Grids", PanelEntry::Kind::table, "cells|polygons in them|blocked"},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  FranklinSteps(const StepItems& scene, StepRecord& record)
      : record_(record),
        lines_(scene, record),
        grid_(lines_.lines(), 1),
        finder_(lines_.lines(), grid_, lines_.policy(), Observer{this}) {}

  void run() {
    tell_grids();
    const std::vector<std::uint32_t> order = grid_.lines_by_cell(lines_.lines());
    lines_.find_all(order, *this, at("seen"));
  }

  /// Called by find_seen.
  const std::vector<PartOfLine>& hidden_parts(const LineTable::Line& line) {
    line_ = &line;
    hidden_.clear();
    cells_.clear();
    record_.step(at("line"), fmt::format("Which parts of {} are seen?", lines_.name(line)));
    show();
    return finder_.hidden_parts(line);
  }

 private:
  struct Observer {
    FranklinSteps* steps;
    void all_blocked() const { steps->tell_all_blocked(); }
    void cells(std::size_t level, const CellsOfStretch& stretch) const {
      steps->tell_cells(level, stretch);
    }
    void blocked() const { steps->tell_blocked(); }
    void compared(std::uint32_t polygon) const { steps->tell_polygon(polygon); }
  };
  static bool blocks(float behind) { return behind > -std::numeric_limits<float>::infinity(); }

  void tell_grids() {
    std::vector<StepRow> rows;
    std::size_t blocked = 0;
    for (const CellGrid::Level& level : grid_.levels()) {
      const auto with_face = static_cast<std::size_t>(std::ranges::count_if(level.behind, blocks));
      blocked += with_face;
      rows.push_back({{fmt::format("{} by {}", level.columns, level.rows),
                       std::to_string(level.entries.size()), std::to_string(with_face)}});
    }
    record_.step(at("grid"), grid_.levels().empty()
                                 ? "Nothing hides anything: there is no grid."
                                 : fmt::format("The finest grid has {} by {} cells.",
                                               grid_.levels()[0].columns, grid_.levels()[0].rows));
    if (!grid_.levels().empty()) mark_grid();
    record_.show(panel("grids"), std::move(rows));
    if (blocked == 0) return;
    record_.step(at("block"),
                 fmt::format("Polygons cover {} as a whole.", counted(blocked, "cell")));
    const CellGrid::Level& finest = grid_.levels()[0];
    for (std::uint32_t row = 0; row < finest.rows; ++row) {
      for (std::uint32_t column = 0; column < finest.columns; ++column) {
        if (!blocks(finest.behind[std::size_t{row} * finest.columns + column])) continue;
        mark_cell(StepRole::front, 0, column, row);
      }
    }
  }

  /// Marks the borders of the finest cells in all further steps.
  void mark_grid() {
    const auto& [columns, rows] = static_cast<const CellLayout::Size&>(grid_.levels()[0]);
    const Point2 low = grid_.layout().origin();
    const double cell = grid_.layout().cell();
    const Point2 high = low + Point2(columns * cell, rows * cell);
    for (std::uint32_t k = 0; k <= columns; ++k) {
      const double x = low.x + k * cell;
      record_.mark(StepRole::none, {{x, low.y}, {x, high.y}}, StepMark::Kind::line, true);
    }
    for (std::uint32_t k = 0; k <= rows; ++k) {
      const double y = low.y + k * cell;
      record_.mark(StepRole::none, {{low.x, y}, {high.x, y}}, StepMark::Kind::line, true);
    }
  }

  /// Marks a cell as a closed chain of points: cells do not consist of whole pixels.
  void mark_cell(StepRole role, std::size_t level, std::uint32_t column, std::uint32_t row) {
    const double cell = std::ldexp(grid_.layout().cell(), static_cast<int>(level));
    const Point2 low = grid_.layout().origin() + Point2(column * cell, row * cell);
    const Point2 high = low + Point2(cell, cell);
    record_.mark(role, {low, {high.x, low.y}, high, {low.x, high.y}, low}, StepMark::Kind::line);
  }

  void tell_all_blocked() {
    record_.step(
        at("all"),
        "The cells that have the line have blocking faces before it: all of it is hidden.");
    hidden_.push_back({{"blocking faces", "0", "1", "both sides"}});
    show();
  }

  void tell_cells(std::size_t level, const CellsOfStretch& stretch) {
    part_ = stretch.part;
    level_ = level;
    cells_.clear();
    const CellGrid::Level& cells = grid_.levels()[level];
    std::vector<std::uint32_t> polygons;
    for (std::uint32_t j = stretch.low; j <= stretch.high; ++j) {
      cells_.push_back(stretch.cell(j));
      for (const CellGrid::Entry& entry : cells.in_cell(stretch.cell(j))) {
        polygons.push_back(entry.polygon);
      }
    }
    record_.step(
        at("cells"),
        fmt::format("The stretch from {} goes through {} of the grid of {} by {}, with {}.",
                    words_of(part_), counted(cells_.size(), "cell"), cells.columns, cells.rows,
                    counted(polygons.size(), "polygon")));
    record_.show(panel("cell"), StepRecord::rows(polygons, [&](std::uint32_t polygon) {
                   return record_.row(polygon);
                 }));
    show();
  }

  void tell_blocked() {
    record_.step(at("blocked"),
                 "The stretch is behind the blocking faces of its cells: it is hidden.");
    hidden_.push_back({{"blocking faces", fmt::format("{:.3g}", part_.from),
                        fmt::format("{:.3g}", part_.to), "both sides"}});
    lines_.mark(StepRole::hidden, *line_, part_);
    show();
  }

  void tell_polygon(std::uint32_t polygon) {
    lines_.tell_covered(polygon, *line_, {at("misses"), at("hides")}, hidden_);
    show();
  }

  void show() {
    for (const std::size_t cell : cells_) {
      const std::uint32_t columns = grid_.levels()[level_].columns;
      mark_cell(StepRole::active, level_, static_cast<std::uint32_t>(cell % columns),
                static_cast<std::uint32_t>(cell / columns));
    }
    lines_.mark(StepRole::root, *line_);
    record_.show(panel("hidden"), hidden_);
  }

  StepRecord& record_;
  StepLines lines_;
  CellGrid grid_;
  Franklin<ExactLines, Observer> finder_;
  const LineTable::Line* line_ = nullptr;
  std::vector<StepRow> hidden_;
  PartOfLine part_{};
  std::size_t level_ = 0;
  std::vector<std::size_t> cells_;
};

}  // namespace

const SteppedAlgorithm kFranklinSteps{
    HiddenMethod::franklin,
    "Franklin's cells",
    "Franklin 1980; the chapter's section \"Franklin algorithm\"",
    "hidden/lines/franklin_finder.h",
    FranklinSteps::kListing,
    FranklinSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { FranklinSteps(scene, record).run(); }};

}  // namespace displayfile
