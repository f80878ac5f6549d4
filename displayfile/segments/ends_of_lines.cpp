#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "clip/geometry/corners.h"
#include "clip/view/transformation.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/entered_plane.h"
#include "hidden/exact/eye.h"

// Finds which ends of lines are within reach of a plane (ViewedScene::places).

namespace displayfile {

namespace {

/// A polygon or a line as entered, projected into the picture in doubles again, to find which of
/// its sides a line of the picture is, or was before clipping.
class SidesInPicture {
 public:
  /// `longest`: the largest factor by which the item's image transformation increases an error.
  SidesInPicture(const ViewedScene::EnteredItem& item, double longest)
      : item_(item), image_(*item.image), longest_(longest) {}

  /// How well a line of the picture matches the side between two vertices.
  struct Likeness {
    bool starts = false, ends = false;                     ///< at the same point
    double off = std::numeric_limits<double>::infinity();  ///< of the other ends, in roundings
    bool is_same() const { return starts && ends; }
    bool operator>(const Likeness& o) const {
      const int own = starts + ends, others = o.starts + o.ends;
      return own != others ? own > others : off < o.off;
    }
  };
  Likeness likeness(std::size_t from, std::size_t to, const Point3& a, const Point3& b) const {
    if (is_exactly_at(from, a) && is_exactly_at(to, b)) return {true, true, 0.0};
    const Vertex p = vertex(from), q = vertex(to);
    Likeness like{is_at(p, a), is_at(q, b), 0.0};
    if (!like.starts) like.off = std::max(like.off, off_side(p, q, a));
    if (!like.ends) like.off = std::max(like.off, off_side(p, q, b));
    return like;
  }
  static constexpr double kFarthest = 64.0;  ///< in roundings: farther off it is another side

 private:
  static constexpr double kRounding = 0x1p-53;
  /// In the homogeneous unit cube; the error of each coordinate is at most `error`.
  struct Vertex {
    HomogeneousPoint at;
    double error;
  };

  Vertex vertex(std::size_t k) const {
    const Point3& p = item_.polygon.points[k];
    Point3 world = p, size = glm::abs(p);
    if (const auto* const modelling = item_.polygon.modelling) {
      const glm::dmat4x3& m = *modelling;
      world = m * glm::dvec4(p, 1.0);
      size = glm::abs(m[0] * p.x) + glm::abs(m[1] * p.y) + glm::abs(m[2] * p.z) + glm::abs(m[3]);
    }
    const auto& m = item_.volume->matrix();
    const glm::dvec4 sums = glm::abs(m[0]) * size.x + glm::abs(m[1]) * size.y +
                            glm::abs(m[2]) * size.z + glm::abs(m[3]);
    const double largest = std::max({sums.x, sums.y, sums.z, sums.w});
    return {item_.volume->transform(world), 16.0 * kRounding * largest};
  }
  Point3 in_picture(const HomogeneousPoint& p) const {
    return image_.apply(item_.volume->to_device(p));
  }
  /// The largest error of a coordinate in the picture.
  double error_in_picture(const Vertex& v, const Point3& at) const {
    const double largest = 1.0 + std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    return (v.error / v.at.w + 16.0 * kRounding) * largest * longest_;
  }
  /// True if the vertex, viewed as unclipped points are, is at that point bit for bit.
  bool is_exactly_at(std::size_t k, const Point3& seen) const {
    const HomogeneousPoint at = item_.volume->transform(item_.polygon.in_world(k));
    return at.w >= item_.volume->nearest_w() && in_picture(at) == seen;
  }
  bool is_in_front(const Vertex& v) const { return v.at.w >= item_.volume->nearest_w(); }
  bool is_at(const Vertex& v, const Point3& seen) const {
    if (!is_in_front(v)) return false;
    const Point3 at = in_picture(v.at), off = glm::abs(at - seen);
    return std::max({off.x, off.y, off.z}) <= error_in_picture(v, at);
  }
  /// The distance of a point of the picture from the line of a side, in units of the possible
  /// rounding error.
  double off_side(Vertex p, Vertex q, const Point3& seen) const {
    if (!is_in_front(p) && !is_in_front(q)) return std::numeric_limits<double>::infinity();
    if (!is_in_front(p)) p.at = at_the_eye(p.at, q.at);
    if (!is_in_front(q)) q.at = at_the_eye(q.at, p.at);
    const Point3 start = in_picture(p.at), end = in_picture(q.at);
    const Point2 a(start), b(end), at(seen);
    const double length = glm::length(b - a);
    const double off = std::abs((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / length;
    const double shares = 1.0 + (glm::length(at - a) + glm::length(at - b)) / length;
    return off / (shares * (error_in_picture(p, start) + error_in_picture(q, end)));
  }
  /// The first point in front of the eye on the side from p, which is not in front, to q.
  HomogeneousPoint at_the_eye(const HomogeneousPoint& p, const HomogeneousPoint& q) const {
    const double share = (item_.volume->nearest_w() - p.w) / (q.w - p.w);
    return p + std::min(1.0, share * (1.0 + 0x1p-40)) * (q - p);
  }

  const ViewedScene::EnteredItem& item_;
  ImageMatrix image_;
  double longest_;
};

/// The side of the plane through that world point on which the viewer is: 1 where its normal
/// points, -1 for the other, or 0 if the plane is too nearly edge-on to decide. The error of the
/// normal is at most `normal_error`.
int side_of_viewer(const ViewVolume& volume, const Point3& normal, double normal_error,
                   const Point3& at) {
  constexpr double kSure = 0x1p-36;  // far more than is rounded here
  if (!(normal_error < kSure)) return 0;
  const Eye eye = Eye::of(volume.view());
  const Point3 to_eye = eye.at_infinity ? eye.place : eye.place - at;
  double size = glm::length(to_eye);
  if (!eye.at_infinity) size += glm::length(eye.place) + glm::length(at);
  const double off = glm::dot(normal, to_eye);
  return std::abs(off) > kSure * size ? (off > 0.0 ? 1 : -1) : 0;
}

/// A plane through three points in doubles, which decides most ends before an EnteredPlane is made.
class RoughPlane {
 public:
  explicit RoughPlane(const EnteredPlane::Corners& corners) : through_(corners[0]) {
    const Point3 u = corners[1] - corners[0], v = corners[2] - corners[0];
    const Point3 across = glm::cross(u, v);
    const double length = glm::length(across);
    if (!(length > 0x1p-450 && length < 0x1p450)) return;
    normal_ = across / length;
    error_ = kRounded * (1.0 + glm::length(u) * glm::length(v) / length);
  }
  const Point3& normal() const { return normal_; }  ///< of length 1
  /// Infinite if unknown.
  double normal_error() const { return error_; }
  /// 1 where the normal points or -1, beyond the reach; kOnPlane within it; nothing if doubles do
  /// not decide.
  std::optional<int> side(const Point3& point, const Reach& reach) const {
    const Point3 off = point - through_;
    const double distance = glm::dot(normal_, off), error = error_ * glm::length(off);
    if (std::abs(distance) - error > reach.high) return distance > 0.0 ? 1 : -1;
    if (std::abs(distance) + error < reach.low) return kOnPlane;
    return std::nullopt;
  }
  static constexpr int kOnPlane = 2;

 private:
  static constexpr double kRounded = 0x1p-48;  // 32 roundings: a cross product's, a sum's
  Point3 through_, normal_{0.0};
  double error_ = std::numeric_limits<double>::infinity();
};

}  // namespace

/// The ends of a line as entered.
struct ViewedScene::EnteredLine {
  Point3 start, end;
  const glm::dmat4x3* modelling;
  bool start_is_seen, end_is_seen;  ///< not clipped away
};

std::optional<ViewedScene::EnteredLine> ViewedScene::entered_line(Item item,
                                                                  std::uint32_t corner) const {
  const EnteredItem entered = in_view_of(entered_number(item), item);
  const PointRow& all = entered.polygon.points;
  const PointRow seen = points(item);
  const std::size_t sides = all.size();
  if (sides < 2) return std::nullopt;
  const Point3 &a = seen[previous_corner<std::size_t>(corner, seen.size())], &b = seen[corner];
  const SidesInPicture in_picture(entered, longest_of(*entered.image));
  const auto likeness = [&](std::size_t to) {
    return in_picture.likeness(previous_corner(to, sides), to, a, b);
  };
  // An unclipped item has its vertices at the same indices.
  SidesInPicture::Likeness most;
  std::size_t side = 1;
  if (sides == 2 || seen.size() == sides) {
    side = corner;
    most = likeness(side);
  }
  for (std::size_t to = 0; sides > 2 && !most.is_same() && to < sides; ++to) {
    const SidesInPicture::Likeness like = likeness(to);
    if (!(like > most)) continue;
    most = like;
    side = to;
  }
  if (!(most.off <= SidesInPicture::kFarthest)) return std::nullopt;  // made by clipping
  return EnteredLine{all[previous_corner(side, sides)], all[side], entered.polygon.modelling,
                     most.starts, most.ends};
}

EndsAsEntered::Places ViewedScene::places(Item item, std::uint32_t corner, Item polygon) const {
  if (!some_may_touch()) return kUnknown;
  const EnteredItem of_plane = in_view_of(entered_plane(polygon), polygon);
  if (!of_plane.is_known()) return kUnknown;
  if (look_of(item) != look_of(polygon)) return {Place::off_plane, Place::off_plane};
  const std::optional<EnteredLine> line = entered_line(item, corner);
  if (!line) return kUnknown;
  const PointRow& points = of_plane.polygon.points;
  const auto support = support_of_entered({points.data(), points.size()});
  if (!support) return kUnknown;
  const auto& [p, q, r] = *support;
  // If its polygon's plane is not that of its ends, that plane decides which are in front of the
  // other.
  const bool is_moved = plane_of_bent(item) != nullptr || is_off_its_plane(item);
  const auto place = [&](int side, int of_eye, bool is_seen) {
    if (of_eye == 0 || is_moved || !is_seen) return Place::off_plane;
    return side == of_eye ? Place::before : Place::behind;
  };
  const Modelling modelling(of_plane.polygon.modelling, planes_->entered_reach);
  const EnteredPlane::Corners corners{points[p], points[q], points[r]};
  if (modelling.is_identity() && modelling.is_of(line->modelling)) {
    const RoughPlane rough(corners);
    const auto start = rough.side(line->start, modelling.reach()),
               end = rough.side(line->end, modelling.reach());
    if (start && end) {
      const int of_eye =
          side_of_viewer(*of_plane.volume, rough.normal(), rough.normal_error(), corners[0]);
      const auto place_of = [&](int side, bool is_seen) {
        return side == RoughPlane::kOnPlane ? Place::on_plane : place(side, of_eye, is_seen);
      };
      return {place_of(*start, line->start_is_seen), place_of(*end, line->end_is_seen)};
    }
  }
  if (modelling.is_singular() && modelling.puts_in_line(corners[0], corners[1], corners[2])) {
    return kUnknown;
  }
  const EnteredPlane plane(corners, modelling);
  const int of_eye = side_of_viewer(*of_plane.volume, plane.normal(), plane.normal_error(),
                                    modelling.apply(corners[0]));
  const auto exact_place = [&](const Point3& end, bool is_seen, const Modelling& of_end) {
    if (plane.reaches(end, of_end)) return Place::on_plane;
    return place(plane.side(end, of_end), of_eye, is_seen);
  };
  const auto places = [&](const Modelling& of_line) {
    return Places{exact_place(line->start, line->start_is_seen, of_line),
                  exact_place(line->end, line->end_is_seen, of_line)};
  };
  if (modelling.is_of(line->modelling)) return places(modelling);
  return places({line->modelling, planes_->entered_reach});
}

}  // namespace displayfile
