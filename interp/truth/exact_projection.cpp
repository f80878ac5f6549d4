#include "interp/truth/exact_projection.h"

#include <algorithm>
#include <cstddef>
#include <glm/mat4x4.hpp>

#include "clip/base/error.h"
#include "clip/view/view_volume.h"

namespace displayfile {

namespace {

/// Divides out the numbers' common powers of two, to keep them short.
void shorten(std::initializer_list<Integer*> numbers) {
  std::size_t common = trailing_zeros(Integer(0));
  for (const Integer* n : numbers) common = std::min(common, trailing_zeros(*n));
  if (common == 0 || common == trailing_zeros(Integer(0))) return;
  for (Integer* n : numbers) *n >>= common;
}

}  // namespace

ExactProjection::ExactProjection(const View& view, const ImageTransformation& image, int width,
                                 int height) {
  const ViewVolume volume(view);
  const glm::dmat4 &m = volume.matrix(), &plane = volume.view_plane();
  std::array<double, 4> toward{};
  for (int column = 0; column < 4 && (view.front_clipping || view.back_clipping); ++column) {
    toward[static_cast<std::size_t>(column)] = plane[column][2];
  }
  places_ = std::max(common_places(std::span(&m[0][0], 16)), common_places(toward));
  for (std::size_t column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      matrix_[static_cast<std::size_t>(row)][column] =
          scaled(m[static_cast<int>(column)][row], places_);
    }
    toward_[column] = scaled(toward[column], places_);
  }

  const bool perspective = view.projection == View::Projection::perspective;
  if (view.back_clipping) sides_.push_back(Side::back);
  if (view.front_clipping) {
    sides_.push_back(Side::front);
  } else if (perspective) {
    sides_.push_back(Side::eye);
  }
  sides_.insert(sides_.end(), {Side::left, Side::right, Side::bottom, Side::top});
  eye_ = Limit(volume.nearest_w());
  front_ = Limit(volume.front_z());
  back_ = Limit(volume.back_z());

  // The viewport: u = x_min w + (x_max - x_min) x, and v likewise; then the image transformation.
  const Rectangle& r = view.viewport;
  const std::array ends{r.x_min, r.x_max, r.y_min, r.y_max};
  const int viewport_places = common_places(ends);
  const auto end = [&](std::size_t i) { return scaled(ends[i], viewport_places); };
  const Integer u_at = end(0), u_wide = end(1) - end(0), v_at = end(2), v_wide = end(3) - end(2);
  const ImageMatrix on_image(image);
  const HomogeneousPoint column_x = on_image.apply(HomogeneousPoint(1.0, 0.0, 0.0, 0.0)),
                         column_y = on_image.apply(HomogeneousPoint(0.0, 1.0, 0.0, 0.0)),
                         column_w = on_image.apply(HomogeneousPoint(0.0, 0.0, 0.0, 1.0));
  const std::array entries{column_x.x, column_y.x, column_w.x, column_x.y, column_y.y, column_w.y};
  const int image_places = common_places(entries);
  for (std::size_t row = 0; row < 2; ++row) {
    const auto entry = [&](std::size_t i) { return scaled(entries[3 * row + i], image_places); };
    const int pixels = row == 0 ? width : height;
    picture_[row][0] = entry(0) * u_wide * pixels;
    picture_[row][1] = entry(1) * v_wide * pixels;
    picture_[row][2] =
        (entry(0) * u_at + entry(1) * v_at + (entry(2) << bits(viewport_places))) * pixels;
  }
  picture_places_ = viewport_places + image_places;
}

ExactProjection::Vertex ExactProjection::viewed(const WholePoint& world) const {
  const Integer one = Integer(1) << bits(world.places);
  const auto along = [&](const Row& row) -> Integer {
    return row[0] * world.x + row[1] * world.y + row[2] * world.z + row[3] * one;
  };
  return {along(matrix_[0]), along(matrix_[1]), along(matrix_[2]),
          along(matrix_[3]), along(toward_),    one << bits(places_)};
}

// ---- The view volume ---------------------------------------------------------------------

ExactProjection::Limit::Limit(double value)
    : at(scaled(value, binary_places(value))), places(binary_places(value)) {}

Integer ExactProjection::Limit::exceeded_by(const Integer& coordinate, const Integer& unit) const {
  return (coordinate << bits(places)) - at * unit;
}

/// The signed distance inside, scaled: 0 on the plane, negative outside.
Integer ExactProjection::inside(Side side, const Vertex& v) const {
  switch (side) {
    case Side::back: return back_.exceeded_by(v.toward, v.unit);
    case Side::front: return -front_.exceeded_by(v.toward, v.unit);
    case Side::eye: return eye_.exceeded_by(v.w, v.unit);
    case Side::left: return v.x;
    case Side::right: return v.w - v.x;
    case Side::bottom: return v.y;
    case Side::top: return v.w - v.y;
  }
  return 0;
}

/// The point on the plane. Both weights are positive, and so is the result's unit.
ExactProjection::Vertex ExactProjection::cut(const Vertex& in, const Integer& d_in,
                                             const Vertex& out, const Integer& d_out) const {
  const auto between = [&](const Integer& a, const Integer& b) -> Integer {
    return d_in * b - d_out * a;
  };
  Vertex v{between(in.x, out.x), between(in.y, out.y),           between(in.z, out.z),
           between(in.w, out.w), between(in.toward, out.toward), between(in.unit, out.unit)};
  shorten({&v.x, &v.y, &v.z, &v.w, &v.toward, &v.unit});
  return v;
}

/// A vertex on the plane is inside: an edge is cut only from strictly inside to outside.
void ExactProjection::clip(Side side, std::vector<Vertex>& polygon) {
  distances_.clear();
  bool any_outside = false, any_inside = false;
  for (const Vertex& v : polygon) {
    distances_.push_back(inside(side, v));
    any_outside |= distances_.back() < 0;
    any_inside |= distances_.back() >= 0;
  }
  if (!any_outside) return;
  if (!any_inside) return polygon.clear();
  clipped_.clear();
  std::size_t from = polygon.size() - 1;
  for (std::size_t to = 0; to < polygon.size(); from = to++) {
    const Integer &d_from = distances_[from], &d_to = distances_[to];
    if (d_from > 0 && d_to < 0) clipped_.push_back(cut(polygon[from], d_from, polygon[to], d_to));
    if (d_from < 0 && d_to > 0) clipped_.push_back(cut(polygon[to], d_to, polygon[from], d_from));
    if (d_to >= 0) clipped_.push_back(polygon[to]);
  }
  polygon.swap(clipped_);
}

void ExactProjection::clip(std::vector<Vertex>& polygon) {
  for (const Side side : sides_) {
    if (!polygon.empty()) clip(side, polygon);
  }
  if (polygon.size() < 3) polygon.clear();
  for (const Vertex& v : polygon) {
    // Between the window's sides that is the centre of projection alone, which the front plane
    // excludes unless the matrix is out of the range of doubles.
    if (v.w <= 0) throw Error("view out of range: the centre of projection is in the view volume");
  }
}

// ---- The picture -------------------------------------------------------------------------

TruePoint ExactProjection::in_picture(const Vertex& v) const {
  const auto row = [&](std::size_t i) -> Integer {
    return picture_[i][0] * v.x + picture_[i][1] * v.y + picture_[i][2] * v.w;
  };
  TruePoint p{row(0), row(1), v.z << bits(picture_places_), v.w << bits(picture_places_)};
  shorten({&p.x, &p.y, &p.z, &p.w});
  return p;
}

namespace {

/// Twice the signed area of a triangle, times the product of the three w.
Integer doubled_area(const ExactProjection::Vertex& p, const ExactProjection::Vertex& q,
                     const ExactProjection::Vertex& r) {
  return p.x * (q.y * r.w - q.w * r.y) - p.y * (q.x * r.w - q.w * r.x) +
         p.w * (q.x * r.y - q.y * r.x);
}

}  // namespace

bool ExactProjection::faces_viewer(std::span<const Vertex> polygon) {
  bool any_left = false, any_right = false;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const int turn = sgn(doubled_area(polygon[0], polygon[i - 1], polygon[i]));
    any_left |= turn > 0;
    any_right |= turn < 0;
  }
  if (!any_left || !any_right) return any_left;
  Rational sum;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    sum += ratio(doubled_area(polygon[0], polygon[i - 1], polygon[i]),
                 polygon[i - 1].w * polygon[i].w);
  }
  return sum > 0;
}

}  // namespace displayfile
