#pragma once

#include "clip/point.h"

namespace displayfile {

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
struct SineCosine {
  double sine, cosine;
};
SineCosine sine_cosine_of_degrees(double degrees);

/// The current modelling transformation: object coordinates to world coordinates.
/// Each routine acts after those called before it, as in the textbook's chapter 8:
/// translate, then rotate, moves a point first and then turns it about the origin.
class ModellingTransformation {
 public:
  void create();  ///< Starts anew with the identity (CREATE-TRANSFORMATION-3).
  void translate(const Point3& t);
  void scale(const Point3& s);
  void rotate_x(double degrees);  ///< Counterclockwise, seen from the positive axis.
  void rotate_y(double degrees);
  void rotate_z(double degrees);

  bool is_identity() const { return identity_; }
  Point3 apply(const Point3& p) const {
    return identity_ ? p : Point3(matrix_ * HomogeneousPoint(p, 1.0));
  }
  /// A normal as Newell's sums of the transformed polygon would turn and scale it, but for a common
  /// factor: by the cofactors of the matrix. Zero if the transformation leaves no normal.
  Point3 apply_to_normal(const Point3& n) const;

 private:
  void then(const glm::dmat4& step);

  glm::dmat4 matrix_{1.0};
  bool identity_ = true;
};

/// A segment's image transformation, in normalised device coordinates: scaled about
/// the origin, then rotated about it, then translated (Harrington, chapter 5).
struct ImageTransformation {
  Point2 scale{1.0, 1.0};
  double rotation = 0.0;  ///< degrees, counterclockwise
  Point2 translation{0.0, 0.0};

  bool is_identity() const {
    return scale == Point2(1.0, 1.0) && rotation == 0.0 && translation == Point2(0.0, 0.0);
  }
  bool operator==(const ImageTransformation&) const = default;
};

/// An image transformation made ready to apply to many points.
class ImageMatrix {
 public:
  explicit ImageMatrix(const ImageTransformation& t);
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
