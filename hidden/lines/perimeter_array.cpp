#include "hidden/lines/perimeter_array.h"

#include <algorithm>
#include <limits>

namespace displayfile {

PerimeterArray::PerimeterArray(const GridSurface& surface, const Verticals& verticals,
                               double roundoff)
    : surface_(surface), verticals_(verticals) {
  const Rectangle box = verticals.box();
  left_ = box.x_min;
  width_ = std::max((box.x_max - box.x_min) / kColumns, std::numeric_limits<double>::min());
  equal_ = roundoff * (box.y_max - box.y_min);
  constexpr double kNothing = std::numeric_limits<double>::infinity();
  columns_.assign(kColumns, {kNothing, -kNothing});
}

std::uint32_t PerimeterArray::index(double column) const {
  return static_cast<std::uint32_t>(std::clamp(column, 0.0, kColumns - 1.0));
}

void PerimeterArray::find_hidden(std::uint32_t a, std::uint32_t b,
                                 std::vector<PartOfLine>& parts) const {
  parts.clear();
  const Point2 &p = verticals_.in_columns(a), &q = verticals_.in_columns(b);
  const std::uint32_t first = index(column_of(p.x)), last = index(column_of(q.x));
  const bool hidden_at_a = is_hidden(first, p.y), hidden_at_b = is_hidden(last, q.y);
  if (!hidden_at_a && !hidden_at_b) return;
  if (hidden_at_a && hidden_at_b) {
    parts.push_back({0.0, 1.0});
    return;
  }
  const int step = last > first ? 1 : -1;
  std::uint32_t column = first;
  const auto height = [&](double x) { return p.y + (q.y - p.y) * ((x - p.x) / (q.x - p.x)); };
  while (column != last) {
    column = static_cast<std::uint32_t>(static_cast<int>(column) + step);
    const double x = left_ + (column + 0.5) * width_;
    if (column != last && is_hidden(column, height(x)) == hidden_at_a) continue;
    const double border = left_ + (step > 0 ? column : column + 1) * width_;
    const double part =
        verticals_.part_at_column(Point2(surface_.point(a)), Point2(surface_.point(b)), border);
    const PartOfLine hidden = hidden_at_a ? PartOfLine{0.0, part} : PartOfLine{part, 1.0};
    if (hidden.from < hidden.to) parts.push_back(hidden);
    return;
  }
}

void PerimeterArray::extend(std::uint32_t a, std::uint32_t b) {
  Point2 p = verticals_.in_columns(a), q = verticals_.in_columns(b);
  if (p.x > q.x) std::swap(p, q);
  const auto include = [&](std::uint32_t column, double y) {
    Range& range = columns_[column];
    range = {std::min(range.low, y), std::max(range.high, y)};
  };
  const std::uint32_t first = index(column_of(p.x)), last = index(column_of(q.x));
  include(first, p.y);
  for (std::uint32_t k = first + 1; k < last; ++k) {
    const double x = left_ + (k + 0.5) * width_;
    include(k, p.y + (q.y - p.y) * ((x - p.x) / (q.x - p.x)));
  }
  include(last, q.y);
}

}  // namespace displayfile
