#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/lines/cells_in_order.h"
#include "hidden/lines/grid_surface.h"
#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/perimeter_polyline.h"
#include "hidden/lines/surface_columns.h"
#include "hidden/lines/verticals.h"
#include "hidden/lines/visible_pieces.h"

namespace displayfile {

/// The part of a line that some perimeters cover.
enum class Known { nothing, part, all };

/// Both perimeters, exact, in some of the columns.
class PerimeterPolylines {
 public:
  using Line = LineInColumns;

  PerimeterPolylines(const GridSurface& surface, const Verticals& verticals,
                     const SurfaceColumns& columns, const SurfaceColumns::Range& range)
      : columns_(columns),
        range_(range),
        upper_(PerimeterPolyline::Bound::upper, surface, verticals, columns, range),
        lower_(PerimeterPolyline::Bound::lower, surface, verticals, columns, range) {}

  Line line(std::uint32_t a, std::uint32_t b) const { return columns_.line_between(a, b); }
  Known known(const Line& line) const {
    if (line.last < range_.first || line.first >= range_.end) return Known::nothing;
    return line.first >= range_.first && line.last < range_.end ? Known::all : Known::part;
  }
  /// Parameters of the parts run from that end of the line. False if a side of a perimeter lies on
  /// the line in the picture, so that planes must decide whether it hides any of it.
  bool find_hidden(const Line& line, std::uint32_t from, std::vector<PartOfLine>& parts) {
    parts.clear();
    const bool on_upper = upper_.find_within(line, line.p != from, below_);
    if (below_.empty() && !on_upper) return true;
    const bool on_lower = lower_.find_within(line, line.p != from, above_);
    if (above_.empty() && !on_lower) return true;
    intersect(below_, above_, parts);
    return !on_upper && !on_lower;
  }
  void extend(const Line& side) {
    upper_.extend(side);
    lower_.extend(side);
  }

 private:
  const SurfaceColumns& columns_;
  SurfaceColumns::Range range_;
  PerimeterPolyline upper_, lower_;
  std::vector<PartOfLine> below_, above_;
};

/// Maps a surface's sides to names; other names are left for the general method.
class NamedSides {
 public:
  NamedSides(const GridSurface& surface, const Verticals& verticals,
             std::span<const LineName> names, const Primitives& items)
      : of_side_(surface.sides(), kNone) {
    for (std::uint32_t n = 0; n < names.size(); ++n) {
      const auto [item, corner] = names[n];
      const std::uint32_t side = surface.side(item, corner);
      if (side == GridSurface::kNone || is_along(verticals, items, names[n])) {
        others_.push_back(names[n]);
      } else {
        of_side_[side] = n;
      }
    }
  }
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::uint32_t name(std::uint32_t side) const {
    assert(side < of_side_.size());
    return of_side_[side];
  }
  std::span<const LineName> others() const { return others_; }

 private:
  static bool is_along(const Verticals& verticals, const Primitives& items, const LineName& name) {
    const PointRow corners = items.points_of(items.items[name.item]);
    const Point3 &from = corners[(name.corner + 2) % 3], &to = corners[name.corner];
    return verticals.are_along(Point2(from), Point2(to));
  }

  std::vector<std::uint32_t> of_side_;
  std::vector<LineName> others_;
};

/// The visible parts of the named lines.
class SeenParts {
 public:
  explicit SeenParts(std::size_t names) : first_(names, PartOfLine{0.0, 0.0}) {}

  /// Adds the visible parts of a name, by one thread at a time per name; parts after the first go
  /// to `others`.
  void add(std::uint32_t name, const std::vector<PartOfLine>& hidden,
           std::vector<SeenPart>& others) {
    double from = 0.0;
    for (const PartOfLine& part : hidden) {
      if (from < part.from) add(name, PartOfLine{from, part.from}, others);
      from = part.to;
    }
    if (from < 1.0) add(name, PartOfLine{from, 1.0}, others);
  }

  std::vector<VisiblePiece> pieces(std::span<const LineName> names,
                                   std::vector<SeenPart> others) const {
    std::ranges::stable_sort(others, {}, &SeenPart::name);
    std::vector<VisiblePiece> pieces;
    pieces.reserve(names.size() + others.size());
    auto other = others.begin();
    for (std::uint32_t n = 0; n < names.size(); ++n) {
      const auto [item, corner] = names[n];
      const auto add = [&, item = item, corner = corner](const PartOfLine& part) {
        pieces.push_back({item, corner, part.from, part.to});
      };
      if (first_[n].from < first_[n].to) add(first_[n]);
      for (; other != others.end() && other->name == n; ++other) add(other->part);
    }
    return pieces;
  }

 private:
  void add(std::uint32_t name, const PartOfLine& part, std::vector<SeenPart>& others) {
    PartOfLine& first = first_[name];
    if (first.from < first.to) {
      others.push_back({name, part});
    } else {
      first = part;
    }
  }

  std::vector<PartOfLine> first_;  // the visible part of each name; empty: none
};

/// Null observer; compiles to nothing.
struct PerimeterUnobserved {
  static void cell(std::uint32_t /*i*/, std::uint32_t /*j*/) {}
  static void drawn(std::uint32_t /*name*/, const std::vector<PartOfLine>& /*hidden*/) {}
  static void extends(std::uint32_t /*from*/, std::uint32_t /*to*/) {}
};

/// Draws the sides of a surface's cells, nearest first (algorithm of T. J. Wright). An Observer is
/// notified of each cell, of its drawn named sides with their hidden parts, and of the sides, by
/// their points, that move the perimeters.
template <class Perimeters, class Observer = PerimeterUnobserved>
class PerimeterMethod {
 public:
  PerimeterMethod(const GridSurface& surface, const NamedSides& named,
                  std::span<const LineName> names, Perimeters perimeters, SeenParts& seen,
                  const Observer& observer = {})
      : surface_(surface),
        named_(named),
        names_(names),
        perimeters_(std::move(perimeters)),
        seen_(seen),
        passed_(surface.sides(), 0),
        observer_(observer) {}

  void draw(const CellsInOrder& order, CountedWork& work) {
    WorkSteps steps;
    std::size_t drawn = 0;
    order.for_each_cell([&](std::uint32_t i, std::uint32_t j, bool second_first) {
      if (gave_up()) return;
      observer_.cell(i, j);
      const std::uint32_t a = surface_.number(i, j), b = surface_.number(i + 1, j),
                          c = surface_.number(i + 1, j + 1), d = surface_.number(i, j + 1);
      const Side diagonal{a, c, surface_.diagonal(i, j)};
      const std::array first{Side{a, b, surface_.side_along_x(i, j)},
                             Side{b, c, surface_.side_along_y(i + 1, j)}, diagonal};
      const std::array second{Side{d, a, surface_.side_along_y(i, j)},
                              Side{c, d, surface_.side_along_x(i, j + 1)}, diagonal};
      draw_triangle(second_first ? second : first);
      draw_triangle(second_first ? first : second);
      steps.step();
      if (++drawn % kCellsAtATime == 0) work.add(kCellsAtATime);
    });
    work.add(drawn % kCellsAtATime);
  }

  /// Names of lines that are undecided, since others lie on them in the picture.
  const std::vector<std::uint32_t>& undecided() const { return undecided_; }
  /// True if it stopped because too many lines were undecided: the general methods are faster then.
  bool gave_up() const { return undecided_.size() > kFewUndecided + decided_ / kDecidedForEach; }
  const std::vector<SeenPart>& others() const { return others_; }
  /// The hidden parts of lines that extend beyond these perimeters, possibly several per line and
  /// at least an empty one.
  const std::vector<SeenPart>& hidden_in_part() const { return hidden_in_part_; }

 private:
  using Line = typename Perimeters::Line;
  static constexpr std::size_t kCellsAtATime = 1024;
  static constexpr std::size_t kFewUndecided = 64, kDecidedForEach = 8;
  struct Side {
    std::uint32_t from, to, number;
  };

  /// Everything nearer than a side precedes the nearer of its triangles, which moves the perimeters
  /// only after all its sides were drawn.
  void draw_triangle(const std::array<Side, 3>& sides) {
    std::array<Line, 3> extending;
    std::size_t count = 0;
    for (const Side& side : sides) {
      if (passed_[side.number] != 0) continue;
      passed_[side.number] = 1;
      const Line line = perimeters_.line(side.from, side.to);
      if (!draw(side, line)) continue;
      extending[count++] = line;
      observer_.extends(side.from, side.to);
    }
    for (std::size_t k = 0; k < count; ++k) perimeters_.extend(extending[k]);
  }

  /// False if it is entirely hidden, and so within the perimeters.
  bool draw(const Side& side, const Line& line) {
    const Known known = perimeters_.known(line);
    if (known == Known::nothing) return false;
    const std::uint32_t name = named_.name(side.number);
    if (name == NamedSides::kNone) return true;
    // A cell's first triangle runs along its sides to greater x and y, but back along the diagonal;
    // the second the other way.
    const auto [low, high] = std::minmax(side.from, side.to);
    const bool is_diagonal = side.number >= surface_.diagonal(0, 0);
    const bool from_low = surface_.is_first(names_[name].item) != is_diagonal;
    if (!perimeters_.find_hidden(line, from_low ? low : high, hidden_)) {
      undecided_.push_back(name);
      return true;
    }
    ++decided_;
    observer_.drawn(name, hidden_);
    if (known == Known::part) {
      hidden_in_part_.push_back({name, {0.0, 0.0}});
      for (const PartOfLine& part : hidden_) hidden_in_part_.push_back({name, part});
      return true;
    }
    seen_.add(name, hidden_, others_);
    return hidden_.size() != 1 || hidden_[0].from > 0.0 || hidden_[0].to < 1.0;
  }

  const GridSurface& surface_;
  const NamedSides& named_;
  std::span<const LineName> names_;
  Perimeters perimeters_;
  SeenParts& seen_;
  std::vector<std::uint8_t> passed_;
  std::vector<PartOfLine> hidden_;
  std::vector<SeenPart> others_, hidden_in_part_;
  std::vector<std::uint32_t> undecided_;
  std::size_t decided_ = 0;
  [[no_unique_address]] Observer observer_;
};

}  // namespace displayfile
