#include "hidden/exact/entered_outline.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/mat4x4.hpp>
#include <limits>

#include "clip/system/fused_product.h"
#include "hidden/exact/entered_plane.h"
#include "hidden/exact/plane_in_picture.h"
#include "hidden/exact/predicate_counts.h"
#include "hidden/exact/rounding.h"

namespace displayfile {

namespace {

ExactNumber exact(double value) { return ExactNumber(value); }

/// A pixel's row or column, twice its centre: 2 index + 1.
ExactNumber twice_centre(std::int32_t index) { return ExactNumber(2 * std::int64_t{index} + 1); }

}  // namespace

// ---- Viewing and clipping ---------------------------------------------------------------------

EnteredProjection::EnteredProjection(const ViewVolume& volume, const ImageTransformation& image)
    : volume_(volume), has_image_(!image.is_identity()) {
  const glm::dmat4 &m = volume.matrix(), &plane = volume.view_plane();
  for (int column = 0; column < 4; ++column) {
    const auto at = static_cast<std::size_t>(column);
    matrix_[0][at] = exact(m[column][0]);
    matrix_[1][at] = exact(m[column][1]);
    matrix_[2][at] = exact(m[column][3]);
    matrix_[3][at] = exact(plane[column][2]);
    of_z_[at] = exact(m[column][2]);
  }
  front_z_ = exact(volume.front_z());
  back_z_ = exact(volume.back_z());
  nearest_w_ = exact(volume.nearest_w());
  const auto clips = [&](ClipPlane side) { return (volume.active() & bit_of(side)) != 0; };
  if (clips(ClipPlane::back)) sides_.push_back(Side::back);
  if (clips(ClipPlane::front)) {
    sides_.push_back(Side::front);
  } else if (volume.is_perspective()) {
    sides_.push_back(Side::eye);
  }
  sides_.insert(sides_.end(), {Side::left, Side::right, Side::bottom, Side::top});

  // The viewport, u = x_min w + (x_max - x_min) x and v likewise, and then the image
  // transformation.
  const Rectangle& viewport = volume.viewport();
  const ExactNumber u_at = exact(viewport.x_min), u_wide = exact(viewport.x_max) - u_at;
  const ExactNumber v_at = exact(viewport.y_min), v_wide = exact(viewport.y_max) - v_at;
  const ImageMatrix on_image(image);
  const HomogeneousPoint of_x = on_image.apply(HomogeneousPoint(1.0, 0.0, 0.0, 0.0));
  const HomogeneousPoint of_y = on_image.apply(HomogeneousPoint(0.0, 1.0, 0.0, 0.0));
  const HomogeneousPoint of_w = on_image.apply(HomogeneousPoint(0.0, 0.0, 0.0, 1.0));
  for (int row = 0; row < 2; ++row) {
    to_picture_[static_cast<std::size_t>(row)] = {
        exact(of_x[row]) * u_wide, exact(of_y[row]) * v_wide,
        exact(of_x[row]) * u_at + exact(of_y[row]) * v_at + exact(of_w[row])};
  }
}

std::array<ExactNumber, 3> EnteredProjection::in_world(const Point3& entered,
                                                       const glm::dmat4x3* modelling) {
  std::array<ExactNumber, 3> world{exact(entered.x), exact(entered.y), exact(entered.z)};
  if (modelling != nullptr) {
    const std::array<ExactNumber, 3> own = world;
    for (int row = 0; row < 3; ++row) {
      const auto& m = *modelling;
      world[static_cast<std::size_t>(row)] = exact(m[0][row]) * own[0] + exact(m[1][row]) * own[1] +
                                             exact(m[2][row]) * own[2] + exact(m[3][row]);
    }
  }
  return world;
}

ExactNumber EnteredProjection::along(const std::array<ExactNumber, 4>& row,
                                     const std::array<ExactNumber, 3>& world) {
  return row[0] * world[0] + row[1] * world[1] + row[2] * world[2] + row[3];
}

EnteredProjection::Vertex EnteredProjection::viewed(const Point3& entered,
                                                    const glm::dmat4x3* modelling) const {
  const std::array<ExactNumber, 3> world = in_world(entered, modelling);
  return {along(matrix_[0], world), along(matrix_[1], world), along(matrix_[2], world),
          along(matrix_[3], world), exact(1.0)};
}

/// A positive multiple of the distance: 0 on the plane, negative outside.
ExactNumber EnteredProjection::inside(Side side, const Vertex& v) const {
  switch (side) {
    case Side::back: return v.view_z - back_z_ * v.unit;
    case Side::front: return front_z_ * v.unit - v.view_z;
    case Side::eye: return v.w - nearest_w_ * v.unit;
    case Side::left: return v.x;
    case Side::right: return v.w - v.x;
    case Side::bottom: return v.y;
    case Side::top: return v.w - v.y;
  }
  return {};
}

/// A vertex on the plane is inside: a side is cut only from strictly inside to outside.
void EnteredProjection::clip(Side side) {
  distances_.clear();
  bool any_outside = false, any_inside = false;
  for (const Vertex& v : polygon_) {
    distances_.push_back(inside(side, v));
    (distances_.back().sign() < 0 ? any_outside : any_inside) = true;
  }
  if (!any_outside) return;
  clipped_.clear();
  const std::size_t sides = any_inside ? polygon_.size() : 0;
  for (std::size_t to = 0, from = sides - 1; to < sides; from = to++) {
    const auto cut = [&](std::size_t in, std::size_t out) {
      const auto between = [&](const ExactNumber& a, const ExactNumber& b) {
        return distances_[in] * b - distances_[out] * a;
      };
      const Vertex &p = polygon_[in], &q = polygon_[out];
      clipped_.push_back({between(p.x, q.x), between(p.y, q.y), between(p.w, q.w),
                          between(p.view_z, q.view_z), between(p.unit, q.unit)});
    };
    const int at_from = distances_[from].sign(), at_to = distances_[to].sign();
    if (at_from > 0 && at_to < 0) cut(from, to);
    if (at_from < 0 && at_to > 0) cut(to, from);
    if (at_to >= 0) clipped_.push_back(polygon_[to]);
  }
  polygon_.swap(clipped_);
}

bool EnteredProjection::outline(const EnteredPolygon& polygon, EnteredOutline& outline) {
  outline.vertices.clear();
  polygon_.clear();
  for (const Point3& p : polygon.points) polygon_.push_back(viewed(p, polygon.modelling));
  for (const Side side : sides_) {
    if (!polygon_.empty()) clip(side);
  }
  if (polygon_.size() < 3) return true;
  for (const Vertex& v : polygon_) {
    if (v.w.sign() <= 0) {
      outline.vertices.clear();
      return false;
    }
    const auto picture = [&](std::size_t row) {
      const auto& [of_x, of_y, of_w] = to_picture_[row];
      return of_x * v.x + of_y * v.y + of_w * v.w;
    };
    EnteredOutline::Vertex& made = outline.vertices.emplace_back();
    made.x = picture(0);
    made.y = picture(1);
    made.w = v.w;
    made.near = Point2(rounded_quotient(made.x, made.w), rounded_quotient(made.y, made.w));
  }
  return true;
}

namespace {

/// a x + b y + c z + d in doubles, if no operation rounds.
std::optional<double> unrounded(const std::array<double, 4>& factors, const Point3& p) {
  const std::array<double, 3> at{p.x, p.y, p.z};
  double sum = factors[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const double product = factors[k] * at[k];
    const double next = sum + product, added = next - sum;
    const bool is_exact = fused_product(factors[k], at[k], -product) == 0.0 &&
                          (sum - (next - added)) + (product - added) == 0.0;
    if (!is_exact) return std::nullopt;
    sum = next;
  }
  return sum;
}

}  // namespace

bool EnteredProjection::are_unrounded(const EnteredPolygon& polygon,
                                      std::span<const Point3> device) const {
  const Rectangle& viewport = volume_.viewport();
  const bool is_whole = viewport == Rectangle{0.0, 1.0, 0.0, 1.0};
  if (has_image_ || !is_whole || polygon.points.size() != device.size()) return false;
  const glm::dmat4& m = volume_.matrix();
  const auto row_of = [](const auto& matrix, int row) {
    return std::array<double, 4>{matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]};
  };
  for (std::size_t i = 0; i < device.size(); ++i) {
    Point3 world = polygon.points[i];
    if (polygon.modelling != nullptr) {
      for (int k = 0; k < 3; ++k) {
        const auto coordinate = unrounded(row_of(*polygon.modelling, k), polygon.points[i]);
        if (!coordinate) return false;
        world[k] = *coordinate;
      }
    }
    const auto w = unrounded(row_of(m, 3), world);
    if (!w) return false;
    for (int k = 0; k < 2; ++k) {
      const auto coordinate = unrounded(row_of(m, k), world);
      if (!coordinate) return false;
      if (fused_product(device[i][k], *w, -*coordinate) != 0.0) return false;
    }
  }
  return true;
}

// ---- Planes -----------------------------------------------------------------------------------

/// Computed from the cofactors of the three points' homogeneous coordinates.
std::optional<PlaneInPicture> EnteredProjection::plane(const EnteredPolygon& polygon) const {
  const auto support = support_of_entered({polygon.points.data(), polygon.points.size()});
  if (!support) return std::nullopt;
  struct Homogeneous {
    ExactNumber x, y, z, w;
  };
  std::array<Homogeneous, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto world = in_world(polygon.points[(*support)[k]], polygon.modelling);
    const ExactNumber x = along(matrix_[0], world), y = along(matrix_[1], world);
    const ExactNumber w = along(matrix_[2], world);
    const auto picture = [&](std::size_t row) {
      return to_picture_[row][0] * x + to_picture_[row][1] * y + to_picture_[row][2] * w;
    };
    at[k] = {picture(0), picture(1), along(of_z_, world), w};
  }
  const auto cofactor = [&](auto u, auto v, auto t) {
    const auto minor = [&](std::size_t i, std::size_t j) {
      return at[i].*v * (at[j].*t) - at[j].*v * (at[i].*t);
    };
    return at[0].*u * minor(1, 2) - at[1].*u * minor(0, 2) + at[2].*u * minor(0, 1);
  };
  using H = Homogeneous;
  PlaneInPicture plane{cofactor(&H::y, &H::z, &H::w), -cofactor(&H::x, &H::z, &H::w),
                       cofactor(&H::x, &H::y, &H::w), -cofactor(&H::x, &H::y, &H::z)};
  const bool is_line = plane.a.sign() == 0 && plane.b.sign() == 0 && plane.is_edge_on();
  if (is_line) return std::nullopt;
  return plane;
}

// ---- Scan conversion --------------------------------------------------------------------------

OutlineRows::OutlineRows(const EnteredOutline& outline, const PictureSize& size) : size_(size) {
  if (outline.vertices.empty()) return;
  const EnteredOutline::Vertex* from = &outline.vertices.back();
  std::int32_t from_row = first_row_above(*from);
  for (const EnteredOutline::Vertex& to : outline.vertices) {
    const std::int32_t to_row = first_row_above(to);
    if (from_row < to_row) add_side(*from, to, from_row, to_row);
    if (to_row < from_row) add_side(to, *from, to_row, from_row);
    from = &to;
    from_row = to_row;
  }
}

/// The first row, from 0 to the height, whose centre is above the vertex.
std::int32_t OutlineRows::first_row_above(const EnteredOutline::Vertex& v) const {
  const double t = v.near.y * size_.height - 0.5;
  if (t < -1.0) return 0;
  if (!(t < size_.height)) return size_.height;
  // Rounding errs by less than a row: the result is the row of t, the one before or the one after.
  const auto is_above = [&](std::int32_t row) {
    const ExactNumber twice_height(2 * std::int64_t{size_.height});
    return (twice_centre(row) * v.w - twice_height * v.y).sign() > 0;
  };
  const auto low = static_cast<std::int32_t>(std::floor(t));
  const double fraction = t - low;
  constexpr double kClose = 0x1p-16;  // far more than rounding errors
  if (fraction > kClose && fraction < 1.0 - kClose) return std::max(low + 1, 0);
  const std::int32_t centre = fraction < 0.5 ? low : low + 1;
  count_exact(Predicate::row);
  return std::clamp(is_above(centre) ? centre : centre + 1, 0, size_.height);
}

void OutlineRows::add_side(const EnteredOutline::Vertex& low, const EnteredOutline::Vertex& high,
                           std::int32_t first_row, std::int32_t end_row) {
  assert(0 <= first_row && first_row < end_row && end_row <= size_.height);
  const Point2 a(low.near.x * size_.width, low.near.y * size_.height);
  const Point2 b(high.near.x * size_.width, high.near.y * size_.height);
  const double rise = b.y - a.y, dx_dy = (b.x - a.x) / rise;
  const double heights = std::abs(a.y) + std::abs(b.y);
  // Twice the bound of interp/scan/scan_convert.md, since the ends are rounded too.
  const double error =
      rise > 32.0 * kUnit * heights
          ? 32.0 * kUnit * (std::abs(a.x) + std::abs(b.x) + 2.0 * std::abs(dx_dy) * heights)
          : std::numeric_limits<double>::infinity();
  sides_.push_back({first_row, end_row, a.x, a.y, dx_dy, error,
                    cross(ExactVector{low.x, low.y, low.w}, ExactVector{high.x, high.y, high.w})});
}

void OutlineRows::find_columns(int row) {
  columns_.clear();
  for (const Side& side : sides_) {
    if (side.first_row <= row && row < side.end_row) columns_.push_back(column(side, row));
  }
  assert(columns_.size() % 2 == 0);  // a closed line crosses a row up as often as down
  std::ranges::sort(columns_);
}

/// The first column, from 0 to the width, whose centre lies at or right of where the side crosses
/// the row.
std::int32_t OutlineRows::column(const Side& side, int row) const {
  const auto is_reached = [&](std::int32_t column) {
    count_exact(Predicate::crossing);
    const ExactProjector centre(PixelCentre(column, row, size_));
    return (side.line.x * centre.x + side.line.y * centre.y + side.line.z * centre.w).sign() <= 0;
  };
  std::int32_t low = 0, high = size_.width;  // the column is one of low to high
  if (side.error < 0.25) {
    const double t = side.x + (row + 0.5 - side.y) * side.dx_dy - 0.5;
    if (t < -side.error) return 0;
    if (t > size_.width + side.error) return size_.width;
    const auto floor = static_cast<std::int32_t>(std::floor(t));
    const double fraction = t - floor;
    if (fraction > side.error && fraction < 1.0 - side.error) {
      return std::min(floor + 1, size_.width);
    }
    low = std::clamp(fraction < 0.5 ? floor : floor + 1, 0, size_.width);
    high = std::min(low + 1, size_.width);
  }
  while (low < high) {
    const std::int32_t middle = low + (high - low) / 2;
    is_reached(middle) ? high = middle : low = middle + 1;
  }
  return low;
}

}  // namespace displayfile
