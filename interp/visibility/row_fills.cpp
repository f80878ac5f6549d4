#include "interp/visibility/row_fills.h"

#include <algorithm>
#include <cmath>

#include "clip/rectangle.h"
#include "hidden/convex_turning.h"
#include "hidden/exact/orientation.h"
#include "hidden/parallel.h"
#include "interp/scan/scan_edge.h"
#include "interp/visibility/fill_depths.h"

namespace displayfile {

namespace {

constexpr std::size_t kMostSides = 16;  ///< of what is drawn as a convex polygon

/// Bounds of what single precision loses, in any rounding mode; derived in
/// interp/visibility/z_buffer.md.
constexpr double kEdgeUnit = 0x1p-21, kDepthUnit = 0x1p-20, kDepthError = 0x1p-17;
constexpr double kLargestEdgeError = 0.25;

}  // namespace

int turn_if_convex(std::span<const Point3> vertices) {
  bool known = true;  // and of no corner straight
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

RowFills::RowFills(const ViewedScene& scene, const PictureSize& size, int threads)
    : fills_(scene.end()), edges_(scene.all_vertices()) {
  depth_error_ = static_cast<float>(kDepthError * std::max(1.0, scene.largest_depth()));
  constexpr std::size_t kFillsAtATime = 1024;
  in_parallel(threads, (scene.end() + kFillsAtATime - 1) / kFillsAtATime, [&](std::size_t k) {
    const auto begin = std::max<std::size_t>(1, k * kFillsAtATime);
    const auto end = std::min<std::size_t>(scene.end(), (k + 1) * kFillsAtATime);
    for (std::size_t fill = begin; fill < end; ++fill) make(scene, size, static_cast<Fill>(fill));
  });
}

static_assert(sizeof(RowFill) == 40);

void RowFills::make(const ViewedScene& scene, const PictureSize& size, Fill fill) {
  const auto vertices = scene.vertices(fill);
  RowFill& made = fills_[fill];
  const Rectangle extent = bounding_rectangle(vertices);
  const double left = extent.x_min * size.width, right = extent.x_max * size.width;
  const double width = size.width;
  // The columns of the centres between its left and its right, with what rounding can do.
  const double first = std::ceil(left - std::abs(left) * 0x1p-50 - 0.5);
  const double end = std::ceil(right + std::abs(right) * 0x1p-50 - 0.5);
  if (!(first < end && first < width && end > 0.0)) return;
  const int row_begin = first_row_above(extent.y_min, size.height);
  const int row_end = first_row_above(extent.y_max, size.height);
  if (row_begin >= row_end) return;
  made.column = static_cast<int>(std::clamp(first, 0.0, width - 1.0));
  made.column_end = static_cast<int>(std::min(end, width));
  const double columns = made.column_end - made.column;
  made.row_begin = row_begin;
  made.row_end = row_end;
  made.edges = scene.first_vertex(fill);

  const Plane plane = scene.plane(fill);
  const PixelDepth depth(plane, size.width, size.height);
  const double z = depth.at(depth.row(row_begin), made.column);
  const double largest =
      std::abs(z) + columns * std::abs(depth.dz_dx) + (row_end - row_begin) * std::abs(depth.dz_dy);
  const double error = depth_bound(vertices, plane, depth, size).error + kDepthUnit * largest;
  made.certain = error <= static_cast<double>(depth_error_);
  if (made.certain) {
    made.z = static_cast<float>(z);
    made.dz_dx = static_cast<float>(depth.dz_dx);
    made.dz_dy = static_cast<float>(depth.dz_dy);
  }

  if (vertices.size() > kMostSides) return;
  const int turn = turn_if_convex(vertices);
  if (turn != 0) make_edges(vertices, size, turn, made);
}

/// The inside is on the left of a side that runs up if the polygon runs counterclockwise.
void RowFills::make_edges(std::span<const Point3> vertices, const PictureSize& size, int turn,
                          RowFill& made) {
  const auto rows = static_cast<double>(made.row_end - made.row_begin);
  RowEdge* const edges = edges_.data() + made.edges;
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
    error = std::max(error, of_double + kEdgeUnit * (std::abs(x) + std::abs(slope) * rows));
    const bool on_right = (rise > 0.0) == (turn > 0);
    edges[on_right ? sides - ++right : left++] = {static_cast<float>(x), static_cast<float>(slope)};
  }
  if (!(error < kLargestEdgeError) || left == 0 || right == 0) return;
  std::move(edges + sides - right, edges + sides, edges + left);
  made.edge_error = static_cast<float>(error * (1.0 + 0x1p-20));
  made.left = static_cast<std::uint8_t>(left);
  made.right = static_cast<std::uint8_t>(right);
}

}  // namespace displayfile
