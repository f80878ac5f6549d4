#pragma once

#include <cmath>
#include <cstddef>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <vector>

#include "clip/point.h"

namespace displayfile {

/// Sine and cosine of an angle in degrees, exact at multiples of 90. The sine is odd; both have
/// period 360 where d + 360 is not rounded.
struct SineCosine {
  double sine, cosine;
};
SineCosine sine_cosine_of_degrees(double degrees);

/// The current modelling transformation: object coordinates to world coordinates.
/// Each routine acts after those called before it, as in the textbook's chapter 8:
/// translate, then rotate, moves a point first and then turns it about the origin.
///
/// A saved transformation acts last, on the result of later calls until it is restored. So a part
/// is placed in the coordinates of its parent, and a chain is written from the outside in: PHIGS's
/// global and local modelling transformations.
class ModellingTransformation {
 public:
  /// Starts anew with the identity (CREATE-TRANSFORMATION-3): in the coordinates saved last.
  void create();
  void save();     ///< No effect on points; later calls act before it.
  void restore();  ///< Pops the last saved one; there must be one.
  std::size_t saved() const { return saved_.size(); }
  void translate(const Point3& t);
  void scale(const Point3& s);
  void rotate_x(double degrees);  ///< Counterclockwise, seen from the positive axis.
  void rotate_y(double degrees);
  void rotate_z(double degrees);
  /// Moves everything by this in world coordinates, after all calls and whatever is saved, in place
  /// of an earlier move.
  void place(const Point3& move);

  bool is_identity() const { return identity_; }
  /// Its last row is 0 0 0 1.
  const glm::dmat4& matrix() const { return matrix_; }
  /// The matrix without that row: x' = column 0 x + column 1 y + column 2 z + column 3.
  const glm::dmat4x3& affine() const { return affine_; }
  /// True if it reverses orientation: counterclockwise becomes clockwise.
  bool mirrors() const;
  Point3 apply(const Point3& p) const {
    return identity_ ? p : Point3(matrix_ * HomogeneousPoint(p, 1.0));
  }
  /// Transforms the difference of two points, without translation.
  Point3 apply_to_difference(const Point3& d) const {
    return identity_ ? d : Point3(matrix_ * HomogeneousPoint(d, 0.0));
  }
  /// Transforms a normal by the cofactors of the matrix: Newell's sums of the transformed polygon,
  /// up to a common factor. Zero if the transformation leaves no normal.
  Point3 apply_to_normal(const Point3& n) const;

 private:
  void then(const glm::dmat4& step);
  void compose();
  glm::dmat4 without_place() const;

  /// The transformation when it was saved, and the calls since the previous save.
  struct Saved {
    glm::dmat4 matrix, called;
  };
  glm::dmat4 called_{1.0};  // since it was saved last, in order
  std::vector<Saved> saved_;
  Point3 place_{0.0};
  glm::dmat4 matrix_{1.0};    // all of it
  glm::dmat4x3 affine_{1.0};  // the same
  bool identity_ = true;
};

/// A segment's image transformation, in normalised device coordinates: scaled about
/// the centre, then rotated about it, then translated (Harrington, chapter 5, where the centre is
/// the origin).
struct ImageTransformation {
  Point2 scale{1.0, 1.0};
  double rotation = 0.0;  ///< degrees, counterclockwise
  Point2 translation{0.0, 0.0};
  Point2 centre{0.0, 0.0};

  bool is_identity() const {
    return scale == Point2(1.0, 1.0) && std::remainder(rotation, 360.0) == 0.0 &&
           translation == Point2(0.0, 0.0);
  }
  bool operator==(const ImageTransformation&) const = default;
};

/// An image transformation made ready to apply to many points.
class ImageMatrix {
 public:
  explicit ImageMatrix(const ImageTransformation& t);
  bool operator==(const ImageMatrix&) const = default;
  Point3 apply(const Point3& p) const {
    return {xx_ * p.x + xy_ * p.y + tx_, yx_ * p.x + yy_ * p.y + ty_, p.z};
  }
  HomogeneousPoint apply(const HomogeneousPoint& p) const {
    return {xx_ * p.x + xy_ * p.y + tx_ * p.w, yx_ * p.x + yy_ * p.y + ty_ * p.w, p.z, p.w};
  }

 private:
  double xx_, xy_, yx_, yy_, tx_, ty_;
};

}  // namespace displayfile
