#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hidden/lines/cell_grid.h"
#include "hidden/lines/cell_walk.h"
#include "hidden/lines/line_against_polygon.h"

namespace displayfile {

/// Null observer; compiles to nothing.
struct FranklinUnobserved {
  static void all_blocked() {}
  static void cells(std::size_t /*level*/, const CellsOfStretch& /*stretch*/) {}
  static void blocked() {}
  static void compared(std::uint32_t /*polygon*/) {}
};

/// Finds the hidden parts of lines one by one, cell by cell along each. An Observer is notified
/// when blocking faces hide a whole line; otherwise, for its stretches level by level, when
/// blocking faces hide one, or which polygons the line is compared with there.
template <class Policy, class Observer = FranklinUnobserved>
class Franklin {
 public:
  Franklin(const LineTable& scene, const CellGrid& grid, const Policy& policy,
           const Observer& observer = {})
      : scene_(scene),
        grid_(grid),
        line_(scene, policy),
        looked_at_(scene.items(), 0),
        observer_(observer) {}

  const std::vector<PartOfLine>& hidden_parts(const LineTable::Line& line) {
    parts_.clear();
    box_ = scene_.extent(line);
    if (grid_.hides(box_)) {
      observer_.all_blocked();
      parts_.add_both({0.0, 1.0});
      return parts_.hidden();
    }
    begin_line(line);
    const auto levels = grid_.levels();
    for (std::size_t k = levels.size(); k-- > 0;) {
      if (levels[k].entries.empty()) continue;
      walk(levels[k], std::ldexp(1.0, -static_cast<int>(k)));
      if (parts_.hides({0.0, 1.0})) break;
    }
    return parts_.hidden();
  }

 private:
  /// A part of the line in one column of cells (or one row for a steep line), and its depth bounds.
  struct Stretch {
    PartOfLine part;
    double nearest, farthest;
  };

  void begin_line(const LineTable::Line& line) {
    line_.look_at(line);
    from_ = grid_.layout().in_cells(Point2(scene_.point(line.a)));
    to_ = grid_.layout().in_cells(Point2(scene_.point(line.b)));
    depth_from_ = scene_.point(line.a).z;
    depth_to_ = scene_.point(line.b).z;
    by_plane_ = line.by_plane;
    if (++number_ == 0) {  // all numbers were used
      std::ranges::fill(looked_at_, 0);
      number_ = 1;
    }
  }

  /// Hidden parts between two cell borders end at them or at true ends: no new ends are made here.
  void walk(const CellGrid::Level& level, double scale) {
    walk_cells(level, from_ * scale, to_ * scale, [&](const CellsOfStretch& cells) {
      find_hidden(level, stretch(cells.part), cells);
      return true;
    });
  }

  void find_hidden(const CellGrid::Level& level, const Stretch& stretch,
                   const CellsOfStretch& cells) {
    if (parts_.hides(stretch.part)) return;
    observer_.cells(static_cast<std::size_t>(&level - grid_.levels().data()), cells);
    if (cells.inside && !level.behind.empty()) {
      bool blocked = true;
      for (std::uint32_t j = cells.low; blocked && j <= cells.high; ++j) {
        blocked = level.behind[cells.cell(j)] > stretch.nearest;
      }
      if (blocked) {
        observer_.blocked();
        parts_.add_both(stretch.part);
        return;
      }
    }
    for (std::uint32_t j = cells.low; j <= cells.high; ++j) {
      for (const CellGrid::Entry& entry : level.in_cell(cells.cell(j))) {
        if (entry.z_max <= stretch.farthest) break;  // and so are those after it
        if (!entry.meets(box_) || looked_at_[entry.polygon] == number_) continue;
        looked_at_[entry.polygon] = number_;
        const bool hides = line_.hide(entry.polygon, parts_);
        observer_.compared(entry.polygon);
        if (hides && parts_.hides(stretch.part)) return;
      }
    }
  }

  Stretch stretch(const PartOfLine& part) const {
    if (by_plane_ || (part.from == 0.0 && part.to == 1.0)) return {part, box_.z_max, box_.z_min};
    const double rise = depth_to_ - depth_from_;
    const double p = depth_from_ + part.from * rise, q = depth_from_ + part.to * rise;
    const double error = 0x1p-48 * (std::abs(depth_from_) + std::abs(depth_to_));
    return {part, std::max(p, q) + error, std::min(p, q) - error};
  }

  const LineTable& scene_;
  const CellGrid& grid_;
  LineAgainstPolygon<Policy> line_;
  HiddenParts parts_;
  Extent box_{};
  Point2 from_{0.0}, to_{0.0};
  double depth_from_ = 0.0, depth_to_ = 0.0;
  bool by_plane_ = false;
  std::vector<std::uint32_t> looked_at_;  // per polygon, the last line compared with it
  std::uint32_t number_ = 0;              // of the line
  [[no_unique_address]] Observer observer_;
};

}  // namespace displayfile
