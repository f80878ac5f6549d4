#include "interp/vector/sampled/seen_band.h"

#include <algorithm>

namespace displayfile {

void SeenBand::find(int first_row, int end_row, std::span<const std::uint32_t> polygons) {
  first_row_ = first_row;
  end_row_ = end_row;
  first_kept_ = std::max(0, first_row - kMargin);
  end_kept_ = std::min(drawing_.height, end_row + kMargin);
  const std::size_t size =
      static_cast<std::size_t>(end_kept_ - first_kept_) * static_cast<std::size_t>(drawing_.width);
  cells_.assign(size, {});
  begun_.clear();
  for (const std::uint32_t polygon : polygons) {
    if (drawing_.polygons[polygon].filled) begun_.push_back(polygon);
  }
  std::ranges::sort(begun_);  // what comes later is taken to be entered later
  SeenDepths depths({drawing_.width, drawing_.height});
  for (const std::uint32_t polygon : begun_) {
    const auto vertices = drawing_.vertices_of(drawing_.polygons[polygon]);
    const auto [p, q, r] = support_vertices(vertices).index;
    depths.begin_polygon(vertices, Plane(vertices[p], vertices[q], vertices[r]));
    scan_convert(polygon, first_kept_, end_kept_, [&](int row, int first, int end) {
      depths.draw_span(row, first, end, &cells_[index(0, row)]);
    });
  }
}

ItemsByRow::ItemsByRow(std::vector<Rows> rows) : rows_(std::move(rows)) {
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].first <= rows_[i].last) by_first_row_.push_back(i);
  }
  std::ranges::stable_sort(by_first_row_, {}, [&](std::uint32_t i) { return rows_[i].first; });
}

std::span<const std::uint32_t> ItemsByRow::reaching(int first_row, int end_row) {
  std::erase_if(active_, [&](std::uint32_t i) { return rows_[i].last < first_row; });
  for (; next_ < by_first_row_.size() && rows_[by_first_row_[next_]].first < end_row; ++next_) {
    if (rows_[by_first_row_[next_]].last >= first_row) active_.push_back(by_first_row_[next_]);
  }
  return active_;
}

}  // namespace displayfile
