#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/visibility/row_triangles.h"

namespace displayfile {

/// A side of a convex polygon in the form by which the fast z-buffer finds crossings: in row j of
/// the polygon's own rows the first centre at or right of it is in column ceil(x + j slope),
/// columns counted from the polygon's first.
struct RowEdge {
  float x, slope;
};

/// A fill prepared for the rows of a picture: the rows whose centres it may cover, its depth there
/// and, if it is convex, its sides. Single precision, with bounds; undecided cases are decided
/// exactly from the fill itself (interp/visibility/z_buffer.md).
struct alignas(64) RowFill {
  std::int32_t row_begin = 0, row_end = 0;
  std::int32_t column = 0;                     ///< no centre of a column before it is covered,
  std::int32_t column_end = 0;                 ///< nor of this column or any after it
  float z = 0.0F, dz_dx = 0.0F, dz_dy = 0.0F;  ///< at that column's centre in row_begin; slopes
  float edge_error = 0.0F;                     ///< bounds that of the sides' crossings
  std::uint8_t left = 0, right = 0;  ///< numbers of sides; 0: not convex, or too inaccurate
  bool certain = false;      ///< the error of its depths is no more than RowFills::depth_error()
  bool turned_away = false;  ///< a clockwise triangle, as a rule hidden by its body
  std::uint32_t edges = 0;   ///< where they are stored, if there are more than kOwnEdges
  static constexpr int kOwnEdges = 3;
  RowEdge own_edges[kOwnEdges] = {};

  /// Its depth at a centre; NaN, for which every comparison is false, if it is not known
  /// accurately.
  float at(int picture_row, int picture_column) const {
    if (!certain) return std::numeric_limits<float>::quiet_NaN();
    const auto down = static_cast<float>(picture_row - row_begin);
    const auto right_of = static_cast<float>(picture_column - column);
    return z + down * dz_dy + right_of * dz_dx;
  }
};

/// All fills of a scene, prepared for pictures of one size.
class RowFills {
 public:
  using Fill = ViewedScene::Fill;

  /// Consecutive fills that one thread prepares.
  struct Batch {
    std::size_t number;
    Fill begin, end;
  };
  /// Prepares the fills, replacing earlier ones, on up to `threads` threads. `made` is called for
  /// each finished batch, by the thread that prepared it. `as_entered`: the picture is that of the
  /// scene as entered, so that viewing's rounding counts as an error.
  void make(const ViewedScene& scene, const PictureSize& size, int threads, bool as_entered,
            const std::function<void(const Batch&)>& made);
  std::size_t batches() const { return batches_; }
  Batch batch(std::size_t number) const {
    const auto size = static_cast<Fill>(size_of_batch(end()));
    const auto begin = static_cast<Fill>(1 + number * size);
    return {number, begin, std::min(end(), begin + size)};
  }
  static std::size_t batches_of(const ViewedScene& scene) {
    const std::size_t size = size_of_batch(scene.end());
    return (scene.end() - 1 + size - 1) / size;
  }

  Fill end() const { return static_cast<Fill>(fills_.size()); }
  const RowFill& operator[](Fill fill) const { return fills_[fill]; }
  /// Its sides: those on the left first.
  const RowEdge* edges_of(const RowFill& fill) const {
    return fill.left + fill.right <= RowFill::kOwnEdges ? fill.own_edges
                                                        : edges_.data() + fill.edges;
  }
  /// Bounds the errors of all certain fills' depths.
  float depth_error() const { return depth_error_; }

 private:
  static std::size_t size_of_batch(std::size_t fills) {
    constexpr std::size_t kLeast = 1024, kMostBatches = 256;
    return std::max(kLeast, fills / kMostBatches + 1);
  }
  class Triangles;
  void make(const ViewedScene& scene, const PictureSize& size, const Batch& batch);
  void make(const ViewedScene& scene, const PictureSize& size, Fill fill);
  /// The largest magnitude of depths in the rows and columns, and bounds of their errors.
  struct DepthRange {
    double largest, error;
  };
  void set_depth(double z, double dz_dx, double dz_dy, const DepthRange& range,
                 const PictureSize& size, RowFill& made) const;
  void set_depth_in_common(const ViewedScene& scene, const Primitives::PlanePoints& shared,
                           const PictureSize& size, RowFill& made) const;
  void find_slack(const ViewedScene& scene, const PictureSize& size, bool as_entered);
  bool is_close_to_rows(const PointRow& vertices, const PictureSize& size) const;
  bool make_triangle(const ViewedScene& scene, const PictureSize& size, Fill fill);
  void make_edges_of_triangle(const double (&x)[3], const double (&y)[3], const int (&rows)[3],
                              bool counterclockwise, RowFill& made) const;
  double of_viewing(double slope) const;
  void make_edges(std::span<const Point3> vertices, const PictureSize& size, int turn,
                  RowFill& made);

  std::vector<RowFill> fills_;
  std::vector<RowEdge> edges_;  // a place for each side of polygons of more than three
  std::size_t batches_ = 0;
  float depth_error_ = 0.0F;
  double error_of_certain_ = 0.0;  // no more than depth_error_
  /// Fills are compared in their own planes, and the depths of some may be off by earlier rounding:
  /// by little where their slopes are at most `steepest_`.
  bool are_rounded_ = false;
  double steepest_ = 0.0;
  bool as_entered_ = false;
  RowSlack slack_;
};

/// 1 or -1 if the polygon goes once around and turns one way only, counterclockwise or clockwise; 0
/// if not, or if rounding leaves that undecided. Device coordinates.
int turn_if_convex(std::span<const Point3> vertices);

}  // namespace displayfile
