#include "interp/vector/sampled/seen_band.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace displayfile {

SeenBand::SeenBand(const SampledScene& drawing) : drawing_(drawing) {
  z_buffer_.prepare({drawing.scene, drawing.size, std::nullopt}, 1);
}

void SeenBand::find(int first_row, int end_row) {
  first_row_ = first_row;
  end_row_ = end_row;
  first_kept_ = std::max(0, first_row - kMargin);
  end_kept_ = std::min(drawing_.size.height, end_row + kMargin);
  seen_.resize(static_cast<std::size_t>(end_kept_ - first_kept_) *
               static_cast<std::size_t>(drawing_.size.width));
  z_buffer_.draw_rows(first_kept_, end_kept_, [&](int row, int first, std::span<const Fill> seen) {
    std::ranges::copy(seen, seen_.data() + index(first, row));
  });
}

ActiveByRow::ActiveByRow(std::vector<Rows> rows) : rows_(std::move(rows)) {
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    if (rows_[i].first <= rows_[i].last) by_first_row_.push_back(i);
  }
  std::ranges::stable_sort(by_first_row_, {}, [&](std::uint32_t i) { return rows_[i].first; });
}

std::span<const std::uint32_t> ActiveByRow::reaching(int first_row, int end_row) {
  std::erase_if(active_, [&](std::uint32_t i) { return rows_[i].last < first_row; });
  for (; next_ < by_first_row_.size() && rows_[by_first_row_[next_]].first < end_row; ++next_) {
    if (rows_[by_first_row_[next_]].last >= first_row) active_.push_back(by_first_row_[next_]);
  }
  return active_;
}

ActiveByRow::Rows rows_reached(std::span<const Point3> polygon, int height) {
  constexpr ActiveByRow::Rows kNone{1, 0};
  Point3 low = polygon[0], high = low;
  for (const Point3& v : polygon) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y)) return kNone;
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  if (high.x < 0.0 || low.x > 1.0 || high.y < 0.0 || low.y > 1.0) return kNone;
  const auto row = [&](double y) {
    return static_cast<int>(std::clamp(std::floor(y * height), 0.0, height - 1.0));
  };
  return {row(low.y), row(high.y)};
}

}  // namespace displayfile
