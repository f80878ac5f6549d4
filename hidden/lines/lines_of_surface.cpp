#include "hidden/lines/lines_of_surface.h"

#include <algorithm>

namespace displayfile {

namespace {

/// The lines of a surface's cells, cell by cell.
class LinesOfCells {
 public:
  LinesOfCells(const GridSurface& surface, const Primitives& items,
               std::span<const std::int32_t> picks, std::vector<LineToDraw>& lines)
      : surface_(surface), items_(items), picks_(picks), lines_(lines) {}

  /// In order of corners: those of the triangle at (i + 1, j), then of the other one.
  void add_cell(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t one = surface_.first_triangle(i, j), other = one + 1;
    const std::uint32_t of_row = 2 * surface_.columns();
    const Point3 &a = surface_.point(surface_.number(i, j)),
                 &b = surface_.point(surface_.number(i + 1, j)),
                 &c = surface_.point(surface_.number(i + 1, j + 1)),
                 &d = surface_.point(surface_.number(i, j + 1));
    constexpr LineName kNobody{GridSurface::kNone, 0};
    const bool last_column = i + 1 == surface_.columns(), last_row = j + 1 == surface_.rows();
    add({one, 0}, {other, 1}, c, a);
    add({one, 1}, j == 0 ? kNobody : LineName{other - of_row, 2}, a, b);
    add({one, 2}, last_column ? kNobody : LineName{other + 2, 0}, b, c);
    add({other, 0}, i == 0 ? kNobody : LineName{one - 2, 2}, d, a);
    add({other, 1}, {one, 0}, a, c);
    add({other, 2}, last_row ? kNobody : LineName{one + of_row, 1}, c, d);
  }

 private:
  /// A side, and the same as the polygon beside it has it. It is there once, as the first's that
  /// draws it.
  void add(const LineName& name, const LineName& beside, const Point3& from, const Point3& to) {
    const LineKinds own = kinds(name);
    if (own == 0 || Point2(from) == Point2(to)) return;
    LineToDraw line{name, own, name.item};
    if (beside.item != GridSurface::kNone) {
      const LineKinds of_other = kinds(beside);
      if (beside.item < name.item && of_other != 0) return;
      line.kinds = static_cast<LineKinds>(own | of_other);
      const auto [first, second] = std::minmax(name.item, beside.item);
      line.pick_item = !picks_.empty() && picks_[second] < picks_[first] ? second : first;
    }
    lines_.push_back(line);
  }
  LineKinds kinds(const LineName& name) const {
    return items_.visible_at(items_.items[name.item].first + name.corner);
  }

  const GridSurface& surface_;
  const Primitives& items_;
  std::span<const std::int32_t> picks_;
  std::vector<LineToDraw>& lines_;
};

}  // namespace

void add_lines_of(const GridSurface& surface, const Primitives& items,
                  std::span<const std::int32_t> picks, std::vector<LineToDraw>& lines) {
  LinesOfCells cells(surface, items, picks, lines);
  for (std::uint32_t j = 0; j < surface.rows(); ++j) {
    for (std::uint32_t i = 0; i < surface.columns(); ++i) cells.add_cell(i, j);
  }
}

}  // namespace displayfile
