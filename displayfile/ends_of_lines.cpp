#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "clip/transformation.h"
#include "displayfile/viewed_scene.h"
#include "hidden/exact/entered_plane.h"

// Which ends of lines are within reach of a plane (ViewedScene::places).

namespace displayfile {

namespace {

/// A polygon or a line as it was entered, put into the picture in doubles once more, to tell which
/// of its sides a line of the picture is, or was before it was clipped.
class SidesInPicture {
 public:
  SidesInPicture(const ViewedScene::EnteredItem& item, double rounding)
      : item_(item), image_(*item.image), rounding_(rounding) {}

  std::size_t sides() const { return item_.polygon.points.size(); }

  /// By how much the side that ends at vertex `to` differs from a line in the picture, the least of
  /// all sides being its own: 0 if both ends are the line's, less than 1 if one is and the line
  /// lies on the side, less than 2 if it only lies on it; infinite if it does not.
  double difference(std::size_t from, std::size_t to, const Point3& a, const Point3& b) const {
    const HomogeneousPoint p = volume_point(from), q = volume_point(to);
    const bool starts = is_at(p, a), ends = is_at(q, b);
    if (starts && ends) return 0.0;
    const double off = std::max(starts ? 0.0 : off_side(p, q, a), ends ? 0.0 : off_side(p, q, b));
    if (!(off <= kFarthest)) return std::numeric_limits<double>::infinity();
    return (starts || ends ? 0.0 : 1.0) + off / (1.0 + kFarthest);
  }

 private:
  /// In units of what viewing rounds.
  static constexpr double kSame = 4.0, kFarthest = 64.0;

  HomogeneousPoint volume_point(std::size_t k) const {
    const Point3& p = item_.polygon.points[k];
    const auto* const modelling = item_.polygon.modelling;
    const Point3 world = modelling == nullptr ? p : Point3(*modelling * glm::dvec4(p, 1.0));
    return item_.volume->transform(world);
  }
  Point3 in_picture(const HomogeneousPoint& p) const {
    return image_.apply(item_.volume->to_device(p));
  }
  bool is_in_front(const HomogeneousPoint& p) const { return p.w >= item_.volume->nearest_w(); }
  bool is_at(const HomogeneousPoint& p, const Point3& seen) const {
    if (!is_in_front(p)) return false;
    const Point3 off = glm::abs(in_picture(p) - seen);
    return std::max({off.x, off.y, off.z}) <= kSame * rounding_;
  }
  /// How far a point of the picture is from the line of a side, in units of what rounding there
  /// may be.
  double off_side(HomogeneousPoint p, HomogeneousPoint q, const Point3& seen) const {
    if (!is_in_front(p) && !is_in_front(q)) return std::numeric_limits<double>::infinity();
    if (!is_in_front(p)) p = at_the_eye(p, q);
    if (!is_in_front(q)) q = at_the_eye(q, p);
    const Point2 a(in_picture(p)), b(in_picture(q)), at(seen);
    const double length = glm::length(b - a);
    const double off = std::abs((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / length;
    const double shares = 1.0 + (glm::length(at - a) + glm::length(at - b)) / length;
    return off / (shares * rounding_);
  }
  /// The place of a side from p, which is not in front of the eye, to q where it is just so.
  HomogeneousPoint at_the_eye(const HomogeneousPoint& p, const HomogeneousPoint& q) const {
    const double share = (item_.volume->nearest_w() - p.w) / (q.w - p.w);
    return p + std::min(1.0, share * (1.0 + 0x1p-40)) * (q - p);
  }

  const ViewedScene::EnteredItem& item_;
  ImageMatrix image_;
  double rounding_;
};

}  // namespace

/// The ends of a line as entered.
struct ViewedScene::EnteredLine {
  Point3 start, end;
  const glm::dmat4x3* modelling;
};

std::optional<ViewedScene::EnteredLine> ViewedScene::entered_line(Item item,
                                                                  std::uint32_t corner) const {
  const EnteredItem entered = as_entered(item);
  const PointRow& all = entered.polygon.points;
  const PointRow seen = points(item);
  const std::size_t sides = all.size();
  if (sides < 2) return std::nullopt;
  const auto before = [](std::size_t k, std::size_t count) { return k == 0 ? count - 1 : k - 1; };
  const Point3 &a = seen[before(corner, seen.size())], &b = seen[corner];
  const SidesInPicture in_picture(entered, viewing_radius());
  const auto line = [&](std::size_t to) {
    return EnteredLine{all[before(to, sides)], all[to], entered.polygon.modelling};
  };
  if (sides == 2) return line(1);
  // What was not clipped has its vertices in the same places.
  if (seen.size() == sides &&
      in_picture.difference(before(corner, sides), corner, a, b) == 0.0) {
    return line(corner);
  }
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t to = 0; to < sides; ++to) {
    const double difference = in_picture.difference(before(to, sides), to, a, b);
    if (!(difference < least)) continue;
    least = difference;
    nearest = to;
  }
  if (least == std::numeric_limits<double>::infinity()) return std::nullopt;  // made by clipping
  return line(nearest);
}

EndsAsEntered::Places ViewedScene::places(Item item, std::uint32_t corner, Item polygon) const {
  if (!some_may_touch()) return kUnknown;
  const EnteredItem of_plane = plane_as_entered(polygon);
  if (!of_plane.is_known()) return kUnknown;
  if (look_of(item) != look_of(polygon)) return {Place::off_plane, Place::off_plane};
  const std::optional<EnteredLine> line = entered_line(item, corner);
  if (!line) return kUnknown;
  const PointRow& points = of_plane.polygon.points;
  const auto support = support_of_entered({points.data(), points.size()});
  if (!support) return kUnknown;
  const auto& [p, q, r] = *support;
  const Modelling modelling(of_plane.polygon.modelling, planes_->entered_reach);
  if (modelling.is_singular() && modelling.puts_in_line(points[p], points[q], points[r])) {
    return kUnknown;
  }
  const EnteredPlane plane({points[p], points[q], points[r]}, modelling);
  const auto place = [&](const Point3& end) {
    const bool reaches = modelling.is_of(line->modelling)
                             ? plane.reaches(end, modelling)
                             : plane.reaches(end, {line->modelling, planes_->entered_reach});
    return reaches ? Place::on_plane : Place::off_plane;
  };
  return {place(line->start), place(line->end)};
}

}  // namespace displayfile
