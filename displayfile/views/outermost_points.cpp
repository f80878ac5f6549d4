#include "displayfile/views/turntable.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <iterator>

#include "clip/geometry/unit.h"
#include "clip/view/view_volume.h"

namespace displayfile {

namespace {

/// Bound on the effect of rounding, as a fraction of the largest intermediate number. The effect is
/// about 1e-15; where view up is too near to the normal, it is so much larger that no bound is
/// known.
constexpr double kRounding = 1e-9;
constexpr double kSteepestUp = 1e-3;  // the sine of the angle

/// A number that depends on the turn t as mean + cosine cos t + sine sin t, up to rounding.
struct Swing {
  double mean, cosine, sine, rounding;

  bool is_always_negative() const { return mean + std::hypot(cosine, sine) + rounding < 0.0; }
  bool is_always_positive() const { return mean - std::hypot(cosine, sine) - rounding > 0.0; }
};

Swing operator-(const Swing& a, const Swing& b) {
  return {a.mean - b.mean, a.cosine - b.cosine, a.sine - b.sine, a.rounding + b.rounding};
}

Swing operator*(double factor, const Swing& a) {
  return {factor * a.mean, factor * a.cosine, factor * a.sine, std::abs(factor) * a.rounding};
}

/// A row of the matrix into the view volume: one of the homogeneous coordinates.
class Row {
 public:
  Row(const glm::dmat4& matrix, int row)
      : linear_(matrix[0][row], matrix[1][row], matrix[2][row]), constant_(matrix[3][row]) {}

  /// The swing of a point that rotates about `centre` through two directions; `reach` bounds the
  /// distance from the origin of everything its position is calculated from.
  Swing swing(const Point3& centre, const Point3& out, const Point3& along, double reach) const {
    return {glm::dot(linear_, centre) + constant_, glm::dot(linear_, out), glm::dot(linear_, along),
            kRounding * (std::abs(constant_) + glm::length(linear_) * reach)};
  }

 private:
  Point3 linear_;
  double constant_;
};

}  // namespace

std::vector<Point3> points_beyond(const TurningPoints& scene, const View& view,
                                  const Bounds& seen) {
  const double steepness = glm::length(glm::cross(unit(view.up), unit(view.plane_normal)));
  if (!(steepness > kSteepestUp)) return {scene.points.begin(), scene.points.end()};
  const ViewVolume volume(view);
  const glm::dmat4& matrix = volume.matrix();
  const Row x(matrix, 0), y(matrix, 1), w(matrix, 3);
  // The bounds in the volume's coordinates, which run from 0 to 1 over the window.
  const Rectangle& window = view.window;
  const double width = window.x_max - window.x_min, height = window.y_max - window.y_min;
  const double left = (seen.low.x - window.x_min) / width;
  const double right = (seen.high.x - window.x_min) / width;
  const double bottom = (seen.low.y - window.y_min) / height;
  const double top = (seen.high.y - window.y_min) / height;
  double reach =
      glm::length(scene.middle) + glm::length(view.reference_point) + std::abs(view.distance);
  if (view.projection == View::Projection::perspective) {
    reach += glm::length(view.centre_of_projection);
  }

  const auto is_within = [&](const Point3& p) {
    const Point3 from_middle = p - scene.middle;
    const Point3 up = scene.axis * glm::dot(scene.axis, from_middle);
    const Point3 out = from_middle - up, along = glm::cross(scene.axis, from_middle);
    const double far = reach + glm::length(from_middle);
    const Point3 centre = scene.middle + up;
    const Swing x_p = x.swing(centre, out, along, far), y_p = y.swing(centre, out, along, far);
    const Swing w_p = w.swing(centre, out, along, far);
    // Comparisons with NaN are false.
    return w_p.is_always_positive() && (x_p - right * w_p).is_always_negative() &&
           (x_p - left * w_p).is_always_positive() && (y_p - top * w_p).is_always_negative() &&
           (y_p - bottom * w_p).is_always_positive();
  };
  std::vector<Point3> beyond;
  std::ranges::copy_if(scene.points, std::back_inserter(beyond),
                       [&](const Point3& p) { return !is_within(p); });
  return beyond;
}

}  // namespace displayfile
