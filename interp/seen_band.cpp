#include "interp/seen_band.h"

#include <algorithm>
#include <limits>

namespace displayfile {

void SeenBand::find(int first_row, int end_row, std::span<const std::uint32_t> polygons) {
  first_row_ = first_row;
  end_row_ = end_row;
  first_kept_ = std::max(0, first_row - kMargin);
  end_kept_ = std::min(drawing_.height, end_row + kMargin);
  const std::size_t size =
      static_cast<std::size_t>(end_kept_ - first_kept_) * static_cast<std::size_t>(drawing_.width);
  seen_.assign(size, kBackground);
  depth_.assign(size, -std::numeric_limits<double>::infinity());
  for (const std::uint32_t polygon : polygons) {
    const CollectedDrawing::Polygon& p = drawing_.polygons[polygon];
    if (!p.filled) continue;
    scan_convert(polygon, first_kept_, end_kept_, [&](int row, int first, int end) {
      const double row_depth = p.depth.row(row);
      std::size_t at = index(first, row);
      for (int i = first; i < end; ++i, ++at) {
        const double z = p.depth.at(row_depth, i);
        const bool nearer = z > depth_[at] ||
                            (z == depth_[at] && (seen_[at] == kBackground || polygon > seen_[at]));
        if (!nearer) continue;
        depth_[at] = z;
        seen_[at] = polygon;
      }
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
