#include "interp/visibility/row_fills.h"

#include <algorithm>
#include <cmath>

#include "clip/base/parallel.h"
#include "clip/geometry/rectangle.h"
#include "hidden/exact/orientation.h"
#include "hidden/triangles/convex_turning.h"
#include "interp/scan/scan_edge.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/row_bounds.h"
#include "interp/visibility/row_triangles.h"

namespace displayfile {

namespace {

constexpr std::size_t kMostSides = 16;  ///< of what is drawn as a convex polygon

using namespace row_bounds;

/// The first column, from 0 to width, whose centre is at x or after it, in pixels.
int first_column_after(double x, int width) {
  const double from_first = x - 0.5;
  if (!(from_first > 0.0)) return 0;
  if (from_first >= width) return width;
  const int column = static_cast<int>(from_first);
  return column < from_first ? column + 1 : column;
}

/// True for a triangle whose plane is that of its corners.
bool has_own_plane(const ViewedScene& scene, ViewedScene::Fill fill) {
  if (scene.sides(fill) != 3 || scene.plane_of_bent(scene.item_of(fill)) != nullptr) return false;
  if (scene.touching_radius() > 0.0) return true;
  const ViewedScene::Item item = scene.item_of(fill);
  return scene.shared_plane(item) == nullptr && !scene.plane_is_elsewhere(item);
}

/// The plane as entered that the fill shares with others, given by the founder's points; null if
/// there is none, or it was not searched for.
const Primitives::PlanePoints* plane_of_founder(const ViewedScene& scene, ViewedScene::Fill fill) {
  const ViewedScene::Item item = scene.item_of(fill);
  if (scene.touching_radius() > 0.0 || scene.plane_is_elsewhere(item)) return nullptr;
  return scene.shared_plane(item);
}

/// Where fills are compared in their own planes: if a slope is at most kOfSlopes over the radius,
/// the rounding_error is within kOfRounding.
constexpr double kOfSlopes = 0x1p-25, kOfRounding = 0x1p-21;
bool is_no_steeper(double dz_dx, double dz_dy, const PictureSize& size, double steepest) {
  return std::abs(dz_dx) * size.width + std::abs(dz_dy) * size.height <= steepest;
}

}  // namespace

int turn_if_convex(std::span<const Point3> vertices) {
  bool known = true;  // and no corner is straight
  const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) {
    const int side =
        filtered_orientation(Point2(vertices[i]), Point2(vertices[j]), Point2(vertices[k]));
    known = known && side != 0;
    return side;
  };
  const int turning = convex_turning(vertices.size(), turn, [&](std::size_t i, std::size_t j) {
    return direction_by_x(Point2(vertices[i]), Point2(vertices[j]));
  });
  return known ? turning : 0;
}

/// Triangles collected until there are enough to be prepared together.
class RowFills::Triangles {
 public:
  Triangles(RowFills& fills, const ViewedScene& scene, const PictureSize& size)
      : fills_(fills), scene_(scene), size_(size) {}

  /// Adds any fill; fills that are not collected are prepared at once.
  void add_any(Fill fill) {
    const bool waits =
        has_own_plane(scene_, fill) || (fills_.as_entered_ && scene_.sides(fill) == 3 &&
                                        plane_of_founder(scene_, fill) != nullptr);
    waits ? add(fill) : fills_.make(scene_, size_, fill);
  }
  void add(Fill fill) {
    const auto corners = scene_.corners_of_triangle(fill);
    for (std::size_t k = 0; k < 3; ++k) {
      block_.x[k][waiting_] = corners[k]->x;
      block_.y[k][waiting_] = corners[k]->y;
      block_.z[k][waiting_] = corners[k]->z;
    }
    fill_[waiting_++] = fill;
    if (waiting_ == TriangleBlock::kMost) make();
  }
  void make() {
    make_row_triangles(block_, waiting_, size_, fills_.error_of_certain_, made_, fills_.slack_);
    for (int i = 0; i < waiting_; ++i) take(i);
    waiting_ = 0;
  }

 private:
  bool is(std::uint32_t bits, int i) const { return (bits >> i & 1) != 0; }

  void take(int i) {
    if (is(made_.needs_more, i)) return fills_.make(scene_, size_, fill_[i]);
    RowFill& made = fills_.fills_[fill_[i]];
    if (is(made_.covers_none, i)) return void(made = {});
    made.row_begin = made_.row_begin[i];
    made.row_end = made_.row_end[i];
    made.column = made_.column[i];
    made.column_end = made_.column_end[i];
    made.turned_away = is(made_.turned_away, i);
    made.certain = is(made_.is_certain, i);
    if (fills_.are_rounded_ && made.certain) {
      made.certain = is_no_steeper(made_.dz_dx[i], made_.dz_dy[i], size_, fills_.steepest_);
    }
    made.left = made.right = 0;
    made.z = made_.z[i];  // without meaning unless it is certain
    made.dz_dx = made_.dz_dx[i];
    made.dz_dy = made_.dz_dy[i];
    if (fills_.as_entered_) {
      const auto* const shared = plane_of_founder(scene_, fill_[i]);
      if (shared != nullptr) fills_.set_depth_in_common(scene_, *shared, size_, made);
    }
    if (is(made_.has_sides, i)) take_sides(i, made);
  }
  /// Stores the two or three sides, without branches.
  void take_sides(int i, RowFill& made) {
    RowEdge on_left[4], on_right[4];
    int left = 0, right = 0;
    for (int k = 0; k < 3; ++k) {
      on_left[left] = on_right[right] = {made_.x[k][i], made_.slope[k][i]};
      const int crosses = is(made_.crosses[k], i) ? 1 : 0;
      const int is_right = is(made_.on_right[k], i) ? crosses : 0;
      right += is_right;
      left += crosses - is_right;
    }
    if (left == 0 || right == 0) return;
    made.own_edges[0] = on_left[0];
    made.own_edges[1] = left == 2 ? on_left[1] : on_right[0];
    made.own_edges[2] = left == 2 ? on_right[0] : on_right[1];
    made.edge_error = made_.edge_error[i];
    made.left = static_cast<std::uint8_t>(left);
    made.right = static_cast<std::uint8_t>(right);
  }

  RowFills& fills_;
  const ViewedScene& scene_;
  PictureSize size_;
  int waiting_ = 0;
  Fill fill_[TriangleBlock::kMost] = {};
  TriangleBlock block_{};
  RowTriangles made_{};
};

void RowFills::make(const ViewedScene& scene, const PictureSize& size, int threads, bool as_entered,
                    const std::function<void(const Batch&)>& made) {
  fills_.reserve(scene.most_fills() + 1);
  fills_.resize(scene.end());
  depth_error_ = static_cast<float>(kDepthError * std::max(1.0, scene.largest_depth()));
  find_slack(scene, size, as_entered);
  error_of_certain_ = static_cast<double>(depth_error_) - (are_rounded_ ? kOfRounding : 0.0);
  batches_ = batches_of(scene);
  edges_.resize(scene.many_sided_corners());
  in_parallel(threads, batches(), [&](std::size_t k) {
    const Batch now = batch(k);
    make(scene, size, now);
    made(now);
  });
}

/// A coordinate near a picture is at most twice its side in magnitude.
void RowFills::find_slack(const ViewedScene& scene, const PictureSize& size, bool as_entered) {
  const double viewing = as_entered ? scene.viewing_radius() : 0.0;
  const double radius = as_entered ? scene.plane_radius() : scene.touching_radius();
  as_entered_ = as_entered;
  are_rounded_ = radius > 0.0;
  steepest_ = are_rounded_ ? kOfSlopes / radius : 0.0;
  slack_ = {};
  if (viewing == 0.0) return;
  const double part = 128.0 * kUnit + scene.boundary_error();
  slack_ = {part * size.width, part * size.height};
}

/// True if a vertex is so close to a row of centres that viewing may have moved it across.
bool RowFills::is_close_to_rows(const PointRow& vertices, const PictureSize& size) const {
  constexpr double kAlways = 0.25;
  if (slack_.row == 0.0) return false;
  return slack_.row > kAlways || std::ranges::any_of(vertices, [&](const Point3& v) {
           const double y = v.y * size.height;
           return std::abs(y - std::floor(y) - 0.5) <= slack_.row;
         });
}

void RowFills::make(const ViewedScene& scene, const PictureSize& size, const Batch& batch) {
  constexpr Fill kAhead = 16;
  Triangles triangles(*this, scene, size);
  for (Fill fill = batch.begin; fill < batch.end; ++fill) {
    if (fill + kAhead < batch.end && scene.sides(fill + kAhead) == 3) {
      for (const Point3* corner : scene.corners_of_triangle(fill + kAhead)) {
        __builtin_prefetch(corner);
      }
    }
    triangles.add_any(fill);
  }
  triangles.make();
}

static_assert(sizeof(RowFill) == 64);

void RowFills::make(const ViewedScene& scene, const PictureSize& size, Fill fill) {
  RowFill& made = fills_[fill];
  made = {};
  const auto vertices = scene.vertices(fill);
  const bool is_close = is_close_to_rows(vertices, size);
  if (!is_close && has_own_plane(scene, fill) && make_triangle(scene, size, fill)) return;
  const Rectangle extent = bounding_rectangle(vertices);
  const double left = extent.x_min * size.width, right = extent.x_max * size.width;
  const double width = size.width;
  // The columns of the centres between its left and its right, with a margin for rounding.
  const double first = std::ceil(left - std::abs(left) * 0x1p-50 - slack_.column - 0.5);
  const double end = std::ceil(right + std::abs(right) * 0x1p-50 + slack_.column - 0.5);
  if (!(first < end && first < width && end > 0.0)) return;
  // If it is close to a row, its sides are examined one by one there, and in the adjacent rows.
  const int beside = is_close ? 1 : 0;
  const int row_begin = std::max(first_row_above(extent.y_min, size.height) - beside, 0);
  const int row_end = std::min(first_row_above(extent.y_max, size.height) + beside, size.height);
  if (row_begin >= row_end) return;
  made.column = static_cast<int>(std::clamp(first, 0.0, width - 1.0));
  made.column_end = static_cast<int>(std::min(end, width));
  const double columns = made.column_end - made.column;
  made.row_begin = row_begin;
  made.row_end = row_end;

  const auto* const shared = as_entered_ ? plane_of_founder(scene, fill) : nullptr;
  if (shared != nullptr) {
    set_depth_in_common(scene, *shared, size, made);
  } else {
    const Plane plane = scene.plane(fill);
    const PixelDepth depth(plane, size.width, size.height);
    const double z = depth.at(depth.row(row_begin), made.column);
    const double largest = std::abs(z) + columns * std::abs(depth.dz_dx) +
                           (row_end - row_begin) * std::abs(depth.dz_dy);
    const double error = depth_bound(vertices, plane, depth, size).error + kDepthUnit * largest +
                         rounding_error(scene, fill, depth, size);
    set_depth(z, depth.dz_dx, depth.dz_dy, {largest, error}, size, made);
  }

  if (vertices.size() > kMostSides || is_close) return;
  if (vertices.size() > 3) made.edges = scene.many_sided_corners_before(fill);
  const int turn = turn_if_convex(vertices);
  if (turn != 0) make_edges(vertices, size, turn, made);
}

/// Sets the depths, if they are accurate enough and fit into floats.
void RowFills::set_depth(double z, double dz_dx, double dz_dy, const DepthRange& range,
                         const PictureSize& size, RowFill& made) const {
  made.certain = range.error <= error_of_certain_ && range.largest <= kLargestDepth &&
                 (!are_rounded_ || is_no_steeper(dz_dx, dz_dy, size, steepest_));
  if (!made.certain) return;
  made.z = static_cast<float>(z);
  made.dz_dx = static_cast<float>(dz_dx);
  made.dz_dy = static_cast<float>(dz_dy);
}

/// The same for the plane as entered in which the fill lies, by its representative points. These
/// are off by the radius in each coordinate, and a point's depth is a combination of theirs.
void RowFills::set_depth_in_common(const ViewedScene& scene, const Primitives::PlanePoints& shared,
                                   const PictureSize& size, RowFill& made) const {
  constexpr double kOfThreePoints = 8.0;
  const Plane plane = scene.plane_through(shared);
  const PixelDepth depth(plane, size.width, size.height);
  const double dz_dx = std::abs(depth.dz_dx), dz_dy = std::abs(depth.dz_dy);
  const double z = depth.at(depth.row(made.row_begin), made.column);
  const double largest = std::abs(z) + (made.column_end - made.column) * dz_dx +
                         (made.row_end - made.row_begin) * dz_dy;
  double weights = 0.0, dx = 0.0, dy = 0.0;
  for (const int column : {made.column, made.column_end}) {
    for (const int row : {made.row_begin, made.row_end}) {
      const Point2 at(column / static_cast<double>(size.width),
                      row / static_cast<double>(size.height));
      weights = std::max(weights, sum_of_weights(plane, at));
      dx = std::max(dx, std::abs(column - depth.x0) + 1.0);
      dy = std::max(dy, std::abs(row - depth.y0) + 1.0);
    }
  }
  const double slopes = dz_dx * size.width + dz_dy * size.height;
  const double of_viewing = kOfThreePoints * scene.plane_radius() * weights * (1.0 + slopes);
  const double error =
      depth.error(plane, size.width, size.height, dx, dy) + of_viewing + kDepthUnit * largest;
  set_depth(z, depth.dz_dx, depth.dz_dy, {largest, error}, size, made);
}

/// The result of make in less time: a triangle needs no test for convexity, and its plane is that
/// of its corners. False if the full form is needed.
bool RowFills::make_triangle(const ViewedScene& scene, const PictureSize& size, Fill fill) {
  RowFill& made = fills_[fill];
  const auto [p, q, r] = scene.corners_of_triangle(fill);
  const double width = size.width, height = size.height;
  const double x[3] = {p->x * width, q->x * width, r->x * width};
  const double y[3] = {p->y * height, q->y * height, r->y * height};
  // Far from the picture other bounds hold.
  const auto [left, right] = std::minmax({x[0], x[1], x[2]});
  const auto [bottom, top] = std::minmax({y[0], y[1], y[2]});
  if (!(left >= -width && right <= 2.0 * width && bottom >= -height && top <= 2.0 * height)) {
    return false;
  }
  const int first =
      first_column_after(left - std::abs(left) * kColumnError - slack_.column, size.width);
  const int end =
      first_column_after(right + std::abs(right) * kColumnError + slack_.column, size.width);
  if (first == end) return true;
  const int rows[3] = {first_row_above(p->y, size.height), first_row_above(q->y, size.height),
                       first_row_above(r->y, size.height)};
  const int row_begin = std::min({rows[0], rows[1], rows[2]});
  const int row_end = std::max({rows[0], rows[1], rows[2]});
  if (row_begin == row_end) return true;

  const double px = x[1] - x[0], py = y[1] - y[0], pz = q->z - p->z;
  const double qx = x[2] - x[0], qy = y[2] - y[0], qz = r->z - p->z;
  const double area = px * qy - py * qx, per_area = 1.0 / area;
  const double across = std::max(right - left, top - bottom);
  const double coordinates = kOfCoordinates * (3.0 * (width + height) + across);
  const double area_error = coordinates * across;
  if (!(std::abs(area) > 2.0 * area_error)) return false;
  const double dz_dx = (pz * qy - qz * py) * per_area, dz_dy = (qz * px - pz * qx) * per_area;
  const double slopes = std::abs(dz_dx) + std::abs(dz_dy);
  const double deep = std::abs(pz) + std::abs(qz);
  const double slope_error =
      2.0 * std::abs(per_area) * (4.0 * coordinates * deep + slopes * area_error);
  const double reach = across + 2.0;
  const double z = p->z + (row_begin + 0.5 - y[0]) * dz_dy + (first + 0.5 - x[0]) * dz_dx;
  const double largest =
      std::abs(z) + (end - first) * std::abs(dz_dx) + (row_end - row_begin) * std::abs(dz_dy);
  const double error = 2.0 * reach * slope_error + slopes * coordinates +
                       kOfCoordinates * (std::abs(p->z) + reach * slopes) + kDepthUnit * largest;
  made.row_begin = row_begin;
  made.row_end = row_end;
  made.column = first;
  made.column_end = end;
  made.turned_away = area < 0.0;
  set_depth(z, dz_dx, dz_dy, {largest, error}, size, made);
  make_edges_of_triangle(x, y, rows, area > 0.0, made);
  return true;
}

/// The largest displacement of a crossing by viewing.
double RowFills::of_viewing(double slope) const {
  return slack_.column + 2.0 * std::abs(slope) * slack_.row;
}

/// As make_edges. A side that crosses no row of centres is no bound in any.
void RowFills::make_edges_of_triangle(const double (&x)[3], const double (&y)[3],
                                      const int (&rows)[3], bool counterclockwise,
                                      RowFill& made) const {
  RowEdge* const edges = made.own_edges;
  const double all_rows = made.row_end - made.row_begin;
  RowEdge on_right[2];
  int left = 0, right = 0;
  double error = 0.0;
  for (int k = 0, from = 2; k < 3; from = k++) {
    if (rows[from] == rows[k]) continue;
    const double rise = y[k] - y[from], slope = (x[k] - x[from]) / rise;
    const double heights = std::abs(y[from]) + std::abs(y[k]);
    if (!(std::abs(rise) > 8.0 * kUnit * heights)) return;
    const double at = x[from] + (made.row_begin + 0.5 - y[from]) * slope - 0.5 - made.column;
    const double of_double = 16.0 * kUnit *
                             (std::abs(x[from]) + std::abs(x[k]) + std::abs(slope) * heights) *
                             (2.0 + all_rows / std::abs(rise));
    const double of_single = kEdgeUnit * (std::abs(at) + std::abs(slope) * all_rows);
    error = std::max(error, of_double + of_single + of_viewing(slope));
    const RowEdge edge{static_cast<float>(at), static_cast<float>(slope)};
    if ((rise > 0.0) == counterclockwise) {
      on_right[right++ & 1] = edge;
    } else {
      edges[left++] = edge;
    }
  }
  if (!(error < kLargestEdgeError) || left == 0 || right == 0 || right > 2) return;
  std::copy_n(on_right, right, edges + left);
  made.edge_error = static_cast<float>(error * (1.0 + 0x1p-20));
  made.left = static_cast<std::uint8_t>(left);
  made.right = static_cast<std::uint8_t>(right);
}

/// The inside is on the left of an ascending side if the polygon runs counterclockwise.
void RowFills::make_edges(std::span<const Point3> vertices, const PictureSize& size, int turn,
                          RowFill& made) {
  const auto rows = static_cast<double>(made.row_end - made.row_begin);
  RowEdge* const edges =
      vertices.size() <= RowFill::kOwnEdges ? made.own_edges : edges_.data() + made.edges;
  int left = 0, right = 0;
  const int sides = static_cast<int>(vertices.size());
  double error = 0.0;
  const Point3* from = &vertices.back();
  for (const Point3& vertex : vertices) {
    const Point3* const a = from;
    from = &vertex;
    const double ax = a->x * size.width, ay = a->y * size.height;
    const double bx = vertex.x * size.width, by = vertex.y * size.height;
    // Sides that cross no row do not matter, unless rounding leaves that open.
    const double low = std::min(ay, by), high = std::max(ay, by);
    if (std::floor(high + 0.5 + 1e-9) == std::floor(low + 0.5 - 1e-9) || a->y == vertex.y) continue;
    const double rise = by - ay, slope = (bx - ax) / rise;
    const double heights = std::abs(ay) + std::abs(by);
    if (!(std::abs(rise) > 8.0 * kUnit * heights)) return;
    const double x = ax + (made.row_begin + 0.5 - ay) * slope - 0.5 - made.column;
    const double of_double = 16.0 * kUnit *
                             (std::abs(ax) + std::abs(bx) + std::abs(slope) * heights) *
                             (2.0 + rows / std::abs(rise));
    const double of_single = kEdgeUnit * (std::abs(x) + std::abs(slope) * rows);
    error = std::max(error, of_double + of_single + of_viewing(slope));
    const bool on_right = (rise > 0.0) == (turn > 0);
    edges[on_right ? sides - ++right : left++] = {static_cast<float>(x), static_cast<float>(slope)};
  }
  if (!(error < kLargestEdgeError) || left == 0 || right == 0) return;
  std::move(edges + sides - right, edges + sides, edges + left);
  if (left + right <= RowFill::kOwnEdges) {
    std::copy_n(edges, left + right, made.own_edges);
  }
  made.edge_error = static_cast<float>(error * (1.0 + 0x1p-20));
  made.left = static_cast<std::uint8_t>(left);
  made.right = static_cast<std::uint8_t>(right);
}

}  // namespace displayfile
