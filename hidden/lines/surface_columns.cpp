#include "hidden/lines/surface_columns.h"

#include <cassert>
#include <cmath>

namespace displayfile {

SurfaceColumns::SurfaceColumns(const GridSurface& surface, const Verticals& verticals,
                               double touching)
    : surface_(surface), verticals_(verticals) {
  const Rectangle box = verticals.box();
  const double width = box.x_max - box.x_min;
  // A column is as wide as an average side.
  double widths = 0.0;
  std::uint32_t sides = 0;
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    widths += std::abs(verticals.in_columns(a).x - verticals.in_columns(b).x);
    ++sides;
  };
  for (std::uint32_t j = 0; j <= surface.rows(); ++j) {
    for (std::uint32_t i = 0; i <= surface.columns(); ++i) {
      if (i > 0) add(surface.number(i - 1, j), surface.number(i, j));
      if (j > 0) add(surface.number(i, j - 1), surface.number(i, j));
    }
  }
  const double most = 4.0 * (surface.columns() + surface.rows()) + 16.0;
  const bool has_width = width > 0.0 && widths > 0.0;
  const double wanted = has_width ? width * sides / widths : 1.0;
  const double count = std::floor(std::clamp(wanted, 1.0, most));
  left_ = box.x_min;
  width_ = width / count;
  per_width_ = has_width ? count / width : 0.0;
  const double size = std::abs(box.y_min) + std::abs(box.y_max) + width;
  // Coordinates have rounding errors, and the reach may turn a plane by a similar error.
  constexpr double kOfRounding = 0x1p-48, kOfTouching = 16.0;
  in_line_ = std::max(kOfRounding, kOfTouching * touching);
  margin_ = std::max(1e-9 * size, 2.0 * verticals.largest_scale() * in_line_);
  size_ = static_cast<std::uint32_t>(count);
}

std::vector<SurfaceColumns::Range> SurfaceColumns::parts(std::size_t count) const {
  if (count <= 1) return {{0, size_}};
  std::vector<std::size_t> points(size_, 0);
  for (std::uint32_t k = 0; k < surface_.points(); ++k) {
    ++points[of(verticals_.in_columns(k).x)];
  }
  std::vector<Range> all;
  std::size_t before = 0;
  for (std::uint32_t column = 0, first = 0; column < size_; ++column) {
    before += points[column];
    const bool is_full = before * count >= surface_.points() * (all.size() + 1);
    if (!is_full && column + 1 < size_) continue;
    all.push_back({first, column + 1});
    first = column + 1;
  }
  assert(!all.empty() && all.back().end == size_);
  return all;
}

}  // namespace displayfile
