#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// A side of a convex polygon as the fast z-buffer crosses rows with it: in row j of the polygon's
/// own rows the first centre at or right of it is that of column ceil(x + j slope), columns counted
/// from the polygon's first.
struct RowEdge {
  float x, slope;
};

/// A fill made ready for the rows of a picture: the rows whose centres it may cover, its depth
/// there and, if it is convex, its sides. Single precision, with bounds; what they leave undecided
/// is decided exactly from the fill itself (interp/visibility/z_buffer.md).
struct RowFill {
  std::int32_t row_begin = 0, row_end = 0;
  std::int32_t column = 0;                     ///< no centre of a column before it is covered,
  std::int32_t column_end = 0;                 ///< nor of this one or any after it
  float z = 0.0F, dz_dx = 0.0F, dz_dy = 0.0F;  ///< at that column's centre in row_begin; slopes
  float edge_error = 0.0F;                     ///< bounds that of the sides' crossings
  std::uint32_t edges = 0;                     ///< the first of its sides; those on the left first
  std::uint8_t left = 0, right = 0;            ///< how many; none: not convex, or not known well
  bool certain = false;      ///< the error of its depths is no more than RowFills::depth_error()
  bool turned_away = false;  ///< a triangle that runs clockwise, which bodies hide as a rule
};

/// All fills of a scene, made ready for pictures of one size.
class RowFills {
 public:
  using Fill = ViewedScene::Fill;

  /// Makes them ready, in place of those before, on up to so many threads.
  void make(const ViewedScene& scene, const PictureSize& size, int threads);

  Fill end() const { return static_cast<Fill>(fills_.size()); }
  const RowFill& operator[](Fill fill) const { return fills_[fill]; }
  const RowEdge* edges_of(const RowFill& fill) const { return edges_.data() + fill.edges; }
  /// Bounds the errors of all certain fills' depths.
  float depth_error() const { return depth_error_; }

 private:
  class Triangles;
  void make(const ViewedScene& scene, const PictureSize& size, Fill fill);
  bool make_triangle(const ViewedScene& scene, const PictureSize& size, Fill fill);
  void make_edges_of_triangle(const double (&x)[3], const double (&y)[3], const int (&rows)[3],
                              bool counterclockwise, RowFill& made);
  void make_edges(std::span<const Point3> vertices, const PictureSize& size, int turn,
                  RowFill& made);

  std::vector<RowFill> fills_;
  std::vector<RowEdge> edges_;
  std::vector<std::uint32_t> first_edges_;  // of the fills that are made ready at a time
  float depth_error_ = 0.0F;
};

/// 1 or -1 if the polygon goes once around and turns one way only, counterclockwise or clockwise; 0
/// if it does not, or rounding leaves that undecided. Device coordinates.
int turn_if_convex(std::span<const Point3> vertices);

}  // namespace displayfile
