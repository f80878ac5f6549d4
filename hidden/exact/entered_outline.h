#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/point.h"
#include "clip/view/transformation.h"
#include "clip/view/view_volume.h"
#include "hidden/exact/entered_polygon.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/exact_vector.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane_in_picture.h"

namespace displayfile {

/// A polygon's outline in the picture, in exact numbers: vertices in order, each (x / w, y / w) in
/// device coordinates. Empty if nothing of it is inside of the view volume.
struct EnteredOutline {
  struct Vertex {
    ExactNumber x, y, w;  ///< w is positive
    Point2 near;          ///< the nearest doubles
  };
  std::vector<Vertex> vertices;
};

/// The projection of a segment's polygons from the points as entered, as defined in
/// interp/truth/entered_truth.md: modelling matrix, view, viewport and image transformation are
/// taken as their doubles, and products and clipping are exact. The doubles of a display file are
/// the same, rounded.
class EnteredProjection {
 public:
  EnteredProjection(const ViewVolume& volume, const ImageTransformation& image);

  /// Computes a polygon's outline. False, without an outline, if a part inside of the window is not
  /// in front of the eye, which no view volume with a matrix in range allows.
  bool outline(const EnteredPolygon& polygon, EnteredOutline& outline);

  /// True if these are the polygon's points in the picture without any rounding: the outline then
  /// equals them. Not always detected.
  bool are_unrounded(const EnteredPolygon& polygon, std::span<const Point3> device) const;

  /// The polygon's support plane; none if its vertices are collinear.
  std::optional<PlaneInPicture> plane(const EnteredPolygon& polygon) const;

 private:
  /// A vertex in the homogeneous unit cube, with its view-plane z and 1 scaled by the same factor.
  struct Vertex {
    ExactNumber x, y, w, view_z, unit;
  };
  enum class Side : std::uint8_t { back, front, eye, left, right, bottom, top };

  static std::array<ExactNumber, 3> in_world(const Point3& entered, const glm::dmat4x3* modelling);
  static ExactNumber along(const std::array<ExactNumber, 4>& row,
                           const std::array<ExactNumber, 3>& world);
  Vertex viewed(const Point3& entered, const glm::dmat4x3* modelling) const;
  ExactNumber inside(Side side, const Vertex& v) const;
  void clip(Side side);

  ViewVolume volume_;
  bool has_image_;
  std::array<std::array<ExactNumber, 4>, 4> matrix_;      // rows of X, Y, W and view-plane z
  std::array<ExactNumber, 4> of_z_;                       // the row of Z
  std::array<std::array<ExactNumber, 3>, 2> to_picture_;  // of X, Y, W to device x and y
  ExactNumber front_z_, back_z_, nearest_w_;
  std::vector<Side> sides_;  // clipping planes
  std::vector<Vertex> polygon_, clipped_;
  std::vector<ExactNumber> distances_;
};

/// Scan conversion of outlines by the rule of interp/scan/scan_convert.h, every decision exact.
class OutlineRows {
 public:
  OutlineRows(const EnteredOutline& outline, const PictureSize& size);

  /// Calls fill_span(row, first, end) for each run of covered pixels in the rows row_begin <= row <
  /// row_end, row by row from the bottom, left to right.
  template <class FillSpan>
  void scan(int row_begin, int row_end, FillSpan&& fill_span) {
    for (int row = row_begin; row < row_end; ++row) {
      find_columns(row);
      for (std::size_t k = 0; k + 1 < columns_.size(); k += 2) {
        if (columns_[k] < columns_[k + 1]) fill_span(row, columns_[k], columns_[k + 1]);
      }
    }
  }

 private:
  /// A side that crosses the rows first_row <= row < end_row.
  struct Side {
    std::int32_t first_row, end_row;
    double x, y, dx_dy, error;  ///< in pixels: a crossing's coordinates and its change per row
    ExactVector line;           ///< through both ends; positive on the left of going up
  };
  std::int32_t first_row_above(const EnteredOutline::Vertex& v) const;
  void add_side(const EnteredOutline::Vertex& low, const EnteredOutline::Vertex& high,
                std::int32_t first_row, std::int32_t end_row);
  void find_columns(int row);
  std::int32_t column(const Side& side, int row) const;

  PictureSize size_;
  std::vector<Side> sides_;
  std::vector<std::int32_t> columns_;
};

}  // namespace displayfile
