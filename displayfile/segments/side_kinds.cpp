#include "displayfile/segments/side_kinds.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <compare>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>
#include <utility>

#include "clip/geometry/back_face.h"
#include "clip/geometry/corners.h"
#include "clip/geometry/crease_angle.h"
#include "clip/point.h"
#include "displayfile/segments/side_tiling.h"
#include "hidden/disjoint_sets.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/support_plane.h"
#include "hidden/lines/side_table.h"
#include "hidden/touching/needle.h"
#include "hidden/touching/vertices_within_reach.h"

namespace displayfile {

namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr LineKinds kAnyKind = 0xff;
constexpr std::uint32_t kNoStretch = 0xffffffffu;

/// A vector of length 1, or 0. Scaled first, as squares of large numbers overflow.
Point3 direction_of(const Point3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0.0 ? glm::normalize(v / largest) : Point3(0.0);
}

/// True if the polygon's light face is toward the eye; false if it is edge-on or has no area.
bool faces(const Eye& eye, const PointRow& polygon) {
  if (polygon.size() == 3) return side_of_plane(eye, polygon[0], polygon[1], polygon[2]) > 0;
  const SupportVertices support = spread_vertices(polygon);
  if (support.edge_on) return false;
  const auto& [p, q, r] = support.index;
  const Plane plane(polygon[p], polygon[q], polygon[r]);
  const bool turned =
      glm::dot(direction_of(plane.normal), direction_of(newell_normal(polygon))) < 0.0;
  return side_of_plane(eye, plane) * (turned ? -1 : 1) > 0;
}

/// The segment's own primitives, corners and points, in the form that sorts use.
struct OwnPrimitives {
  OwnPrimitives(const RetainedScene& scene, const RetainedScene::Segment& segment) {
    const std::uint32_t first_corner = scene.first_corner(segment);
    for (std::uint32_t i = segment.first; i < segment.end; ++i) {
      const RetainedScene::Primitive& primitive = scene[i];
      items.push_back({primitive.first - first_corner, primitive.sides,
                       primitive.is_line() ? Primitives::Kind::line : Primitives::Kind::hollow});
      if (!scene.has_shared()) continue;
      for (const std::uint32_t point : scene.corners(i)) {
        corners.push_back(point - segment.first_point);
      }
    }
    primitives = {scene.points(segment), corners, {}, items};
  }
  std::vector<Primitives::Item> items;
  std::vector<std::uint32_t> corners;
  Primitives primitives;
};

}  // namespace

/// Examines each set of sides that have the same ends.
class SideKinds::Finder {
 public:
  Finder(const RetainedScene& scene, const RetainedScene::Segment& segment,
         const LineSelection& wanted, SideKinds& found)
      : scene_(scene),
        segment_(segment),
        wanted_(wanted),
        crease_(wanted.crease_degrees),
        found_(found),
        own_(scene, segment) {}

  void find() {
    draw_all();
    if (wanted_.is_all_alone()) return;
    found_.wants_outlines_ = wants(LineKind::outline);
    if (wants(LineKind::crease)) find_normals();
    const double reach = scene_.reach_in_world(segment_);
    vertices_ = first_within(own_.primitives.points, reach);
    find_needles(reach);
    SideTable(own_.primitives, vertices_).for_each_set([&](std::span<const SideTable::Side> set) {
      if (set.size() > 1 && have_the_same_ends(set) && !has_needle(set)) return look_at(set);
      some_share_ends_ = some_share_ends_ || set.size() > 1;
      for (const SideTable::Side& side : set) lone_.push_back(side.name);
    });
    part(reach);
  }

 private:
  bool wants(LineKind kind) const { return contains(wanted_.kinds, kind); }
  std::uint32_t corner_of(const LineName& side) const {
    return own_.items[side.item].first + side.corner;
  }
  std::uint32_t primitive_of(const LineName& side) const { return segment_.first + side.item; }
  bool is_visible(const LineName& side) const {
    return scene_.edge_visible(primitive_of(side), side.corner);
  }
  /// The point numbers of the side's start and end.
  SideOfPoints ends_of(const LineName& side) const {
    const Primitives& all = own_.primitives;
    const Primitives::Item& polygon = all.items[side.item];
    return {all.point(polygon.first + previous_corner(side.corner, polygon.sides)),
            all.point(polygon.first + side.corner)};
  }
  SideOfPoints vertices_of(const LineName& side) const {
    const auto [from, to] = ends_of(side);
    return {vertices_[from], vertices_[to]};
  }
  const Point3& point(std::uint32_t number) const { return own_.primitives.points[number]; }

  /// True if the sides have the same ends bit for bit: methods of lines then treat them as one line
  /// too.
  bool have_the_same_ends(std::span<const SideTable::Side> set) const {
    return std::ranges::all_of(set, [&](const SideTable::Side& side) {
      const auto [from, to] = ends_of(side.name);
      return point(from) == point(vertices_[from]) && point(to) == point(vertices_[to]);
    });
  }

  void find_needles(double reach) {
    is_needle_.assign(own_.items.size(), 0);
    if (!(reach > 0.0)) return;
    for (std::uint32_t i = 0; i < own_.items.size(); ++i) {
      const RetainedScene::Primitive& primitive = scene_[segment_.first + i];
      if (primitive.is_line()) continue;
      is_needle_[i] = is_within_reach_of_line(scene_.points(segment_.first + i), reach) ? 1 : 0;
    }
  }
  bool is_needle(const LineName& side) const { return is_needle_[side.item] != 0; }
  bool has_needle(std::span<const SideTable::Side> set) const {
    return std::ranges::any_of(set,
                               [&](const SideTable::Side& side) { return is_needle(side.name); });
  }

  /// A polygon's side, or a stretch of it, and its direction there: up is from the vertex with the
  /// lower number.
  struct RunningSide {
    LineName name;
    bool runs_up;
  };

  void look_at(std::span<const SideTable::Side> set) {
    around_side_.clear();
    for (const SideTable::Side& side : set) {
      const auto [from, to] = vertices_of(side.name);
      around_side_.push_back({side.name, from < to});
    }
    add_fixed(fixed_kinds(around_side_));
    if (!wants(LineKind::outline)) return;
    for (const SideTable::Side& side : set) {
      found_.shared_.push_back({side.name.item, corner_of(side.name)});
    }
    found_.ends_.push_back(static_cast<std::uint32_t>(found_.shared_.size()));
  }
  /// Adds kinds to the visible ones of the sides in around_side_.
  void add_fixed(LineKinds kinds) {
    for (const RunningSide& side : around_side_) {
      LineKinds& of_side = found_.fixed_[corner_of(side.name)];
      if (is_visible(side.name)) of_side = static_cast<LineKinds>(of_side | kinds);
    }
  }

  /// The view-independent kinds of the sides that share a side or a stretch.
  LineKinds fixed_kinds(std::span<const RunningSide> sides) {
    LineKinds kinds = 0;
    const auto add = [&](LineKind kind, bool is_one) {
      if (is_one) kinds = static_cast<LineKinds>(kinds | kinds_of(kind));
    };
    if (wants(LineKind::boundary)) add(LineKind::boundary, sides.size() == 1);
    if (wants(LineKind::crease)) add(LineKind::crease, is_crease(sides));
    if (wants(LineKind::material)) add(LineKind::material, fills_differ(sides));
    return kinds;
  }

  /// A part of a side between two successive vertices along it.
  struct StretchOfSide {
    std::uint32_t low, high, side;  ///< index in lone_
    bool runs_up;
    auto operator<=>(const StretchOfSide&) const = default;
  };

  /// Divides sides that share their ends with no other: they may have the ends of others along
  /// them.
  void part(double reach) {
    std::vector<SideOfPoints> sides;
    sides.reserve(lone_.size());
    for (const LineName& side : lone_) sides.push_back(vertices_of(side));
    const PartedSides parted(own_.primitives.points, sides, reach);
    if (!parted.any() && !some_share_ends_) {
      for (const LineName& side : lone_) look_at_whole(side);
      return;
    }
    const std::vector<StretchOfSide> stretches = stretches_along(sides, parted);
    std::vector<SharedStretch> shared;
    for (auto first = stretches.cbegin(); first != stretches.cend();) {
      const auto end = std::find_if(first, stretches.cend(), [&](const StretchOfSide& s) {
        return s.low != first->low || s.high != first->high;
      });
      const std::span<const StretchOfSide> same(&*first, static_cast<std::size_t>(end - first));
      const auto& [from, to] = sides[first->side];
      const bool is_whole =
          same.size() == 1 && first->low == std::min(from, to) && first->high == std::max(from, to);
      if (is_whole) {
        look_at_whole(lone_[first->side]);
      } else {
        shared.push_back({same});
      }
      first = end;
    }
    if (!shared.empty()) add_parted(std::move(shared));
  }

  /// The stretches of sides, sorted by their vertices. A vertex of the side's own polygon along the
  /// side folds back and divides nothing.
  std::vector<StretchOfSide> stretches_along(std::span<const SideOfPoints> sides,
                                             const PartedSides& parted) const {
    std::vector<StretchOfSide> stretches;
    for (std::uint32_t k = 0; k < sides.size(); ++k) {
      std::uint32_t from = sides[k].from;
      const auto add = [&](std::uint32_t to) {
        stretches.push_back({std::min(from, to), std::max(from, to), k, from < to});
        from = to;
      };
      for (const std::uint32_t vertex : parted.along(k)) {
        if (is_needle(lone_[k]) || !has_vertex(lone_[k].item, vertex)) add(vertex);
      }
      add(sides[k].to);
    }
    std::ranges::sort(stretches);
    return stretches;
  }
  bool has_vertex(std::uint32_t item, std::uint32_t vertex) const {
    const auto& [first, sides, kind] = own_.items[item];
    for (std::uint32_t k = first; k < first + sides; ++k) {
      if (vertices_[own_.primitives.point(k)] == vertex) return true;
    }
    return false;
  }

  void look_at_whole(const LineName& side) {
    around_side_.assign(1, {side, true});
    add_fixed(fixed_kinds(around_side_));
  }

  /// The sides with a stretch between the same two vertices, and its position: the line, and the
  /// start along it.
  struct SharedStretch {
    std::span<const StretchOfSide> sides;
    std::uint32_t line = 0;
    double start = 0.0;
  };

  /// Adds stretches and the sides that contain them. Sides with a common stretch belong to one
  /// line.
  void add_parted(std::vector<SharedStretch> shared) {
    place_on_lines(shared);
    std::ranges::stable_sort(shared, [](const SharedStretch& a, const SharedStretch& b) {
      return std::tie(a.line, a.start) < std::tie(b.line, b.start);
    });
    std::vector<PartedSide> of_lone(lone_.size(), {0, 0, kNoStretch, 0, 0});
    for (std::uint32_t k = 0; k < shared.size(); ++k) {
      add_around(shared[k].sides);
      for (const StretchOfSide& s : shared[k].sides) {
        PartedSide& side = of_lone[s.side];
        side.first = std::min(side.first, k);
        side.end = k + 1;
      }
      const bool begins_line = k == 0 || shared[k - 1].line != shared[k].line;
      found_.stretches_.push_back({fixed_kinds(around_side_), begins_line,
                                   static_cast<std::uint32_t>(found_.faces_.size())});
    }
    for (std::uint32_t k = 0; k < lone_.size(); ++k) {
      PartedSide& side = of_lone[k];
      if (side.first == kNoStretch) continue;
      side.corner = corner_of(lone_[k]);
      side.face = lone_[k].item;
      if (scene_.shared_attributes(primitive_of(lone_[k])).is_outlined()) {
        side.drawn = is_visible(lone_[k]) ? kAnyKind : kinds_of(LineKind::outline);
      }
      found_.parted_.push_back(side);
    }
    std::ranges::sort(found_.parted_, [](const PartedSide& a, const PartedSide& b) {
      return std::tie(a.first, b.end, a.corner) < std::tie(b.first, a.end, b.corner);
    });
  }

  /// Adds the polygons around a stretch. Needles are drawn, but have no orientation; if there is
  /// nothing else, one of them represents all.
  void add_around(std::span<const StretchOfSide> sides) {
    around_side_.clear();
    for (const StretchOfSide& s : sides) {
      if (!is_needle(lone_[s.side])) around_side_.push_back({lone_[s.side], s.runs_up});
    }
    if (around_side_.empty()) around_side_.push_back({lone_[sides[0].side], sides[0].runs_up});
    for (const RunningSide& side : around_side_) found_.faces_.push_back(side.name.item);
  }

  void place_on_lines(std::vector<SharedStretch>& shared) const {
    DisjointSets lines(lone_.size());  // of sides
    for (const SharedStretch& stretch : shared) {
      for (const StretchOfSide& s : stretch.sides) lines.join(s.side, stretch.sides[0].side);
    }
    std::vector<Point3> along(lone_.size(), Point3(0.0));  // the longest side of a line
    for (const SharedStretch& stretch : shared) {
      for (const StretchOfSide& s : stretch.sides) {
        const auto [from, to] = ends_of(lone_[s.side]);
        const Point3 way = point(to) - point(from);
        Point3& longest = along[lines.name(s.side)];
        if (glm::length(way) > glm::length(longest)) longest = way;
      }
    }
    for (SharedStretch& stretch : shared) {
      const StretchOfSide& s = stretch.sides[0];
      stretch.line = lines.name(s.side);
      const Point3 unit = direction_of(along[stretch.line]);
      stretch.start = std::min(glm::dot(unit, point(s.low)), glm::dot(unit, point(s.high)));
    }
  }

  /// Draws lines, and all sides if these are selected.
  void draw_all() {
    for (std::uint32_t i = segment_.first; i < segment_.end; ++i) {
      for (std::uint32_t k = 0; k < scene_[i].sides; ++k) {
        const bool wanted = wants(LineKind::all) && scene_.edge_visible(i, k);
        const LineKinds of_side = wanted ? kinds_of(LineKind::all) : LineKinds{0};
        found_.fixed_.push_back(scene_[i].is_line() ? kDrawn : of_side);
      }
    }
  }

  bool fills_differ(std::span<const RunningSide> sides) const {
    const auto look = [&](const RunningSide& side) {
      const std::uint32_t i = primitive_of(side.name);
      const FillStyle::Kind kind = scene_.shared_attributes(i).fill.kind;
      const bool solid = kind == FillStyle::Kind::solid;
      return FillStyle{kind, solid ? scene_.fill_colour(i) : Colour(0.0)};
    };
    const FillStyle first = look(sides[0]);
    return std::ranges::any_of(sides.subspan(1),
                               [&](const auto& side) { return !(look(side) == first); });
  }

  void find_normals() {
    normals_.reserve(segment_.end - segment_.first);
    for (std::uint32_t i = segment_.first; i < segment_.end; ++i) {
      normals_.push_back(scene_[i].is_line() ? Point3(0.0)
                                             : direction_of(newell_normal(scene_.points(i))));
    }
  }

  /// A polygon's normal, reversed unless the side runs up: coplanar polygons of one surface, which
  /// run through the side in opposite directions, then have opposite normals.
  Point3 turned_normal(const RunningSide& side) const {
    const Point3& normal = normals_[side.name.item];
    return side.runs_up ? normal : -normal;
  }

  /// Two polygons that run through the side in opposite directions meet at the angle between their
  /// normals: with normals reversed as above, half a turn less the angle between these. Of more
  /// than two, the smallest angle between them counts, which is between neighbours around the side.
  bool is_crease(std::span<const RunningSide> sides) {
    around_.clear();
    for (const RunningSide& side : sides) {
      const Point3 normal = turned_normal(side);
      if (normal != Point3(0.0)) around_.push_back(normal);
    }
    if (around_.size() < 2) return false;
    if (around_.size() == 2) return crease_.exceeded(around_[0], around_[1]);
    return crease_.exceeded(smallest_angle_around());
  }

  /// Normals of polygons that share a side are all perpendicular to it: directions around a circle.
  /// Polygons that lie on each other, such as where two bodies touch, count once.
  double smallest_angle_around() {
    const Point3 right = around_[0];
    Point3 axis(0.0);
    for (const Point3& v : around_) {
      const Point3 across = glm::cross(right, v);
      if (glm::length(across) > glm::length(axis)) axis = across;
    }
    if (axis == Point3(0.0)) axis = Point3(1.0);  // all are in line
    const Point3 up = glm::cross(axis / glm::length(axis), right);
    angles_.clear();
    for (const Point3& v : around_)
      angles_.push_back(std::atan2(glm::dot(v, up), glm::dot(v, right)));
    std::ranges::sort(angles_);
    constexpr double kOnEachOther = 0.01;  // radians: each body is rounded by itself
    const auto are_on_each_other = [](double a, double b) { return b - a <= kOnEachOther; };
    angles_.erase(std::unique(angles_.begin(), angles_.end(), are_on_each_other), angles_.end());
    if (angles_.size() > 1 && angles_.front() + 2.0 * kHalfTurn - angles_.back() <= kOnEachOther) {
      angles_.pop_back();
    }
    if (angles_.size() < 2) return 0.0;  // folded back
    double least = angles_.front() + 2.0 * kHalfTurn - angles_.back();
    for (std::size_t k = 1; k < angles_.size(); ++k) {
      least = std::min(least, angles_[k] - angles_[k - 1]);
    }
    return std::min(least, kHalfTurn);
  }

  const RetainedScene& scene_;
  const RetainedScene::Segment& segment_;
  const LineSelection wanted_;
  const CreaseAngle crease_;
  SideKinds& found_;
  OwnPrimitives own_;
  std::vector<std::uint32_t> vertices_;  // of the points
  std::vector<std::uint8_t> is_needle_;  // of the primitives: within reach of a line
  std::vector<LineName> lone_;           // sides that share their ends with no other, bit for bit
  bool some_share_ends_ = false;         // of these, within reach
  std::vector<RunningSide> around_side_;
  std::vector<Point3> normals_;  // of the primitives, of length 1; or 0
  std::vector<Point3> around_;   // of length 1
  std::vector<double> angles_;
};

SideKinds::SideKinds(const RetainedScene& scene, const RetainedScene::Segment& segment,
                     const LineSelection& wanted) {
  Finder(scene, segment, wanted, *this).find();
}

/// The primitives that have the stretch.
std::span<const std::uint32_t> SideKinds::faces_of(std::uint32_t stretch) const {
  assert(stretch < stretches_.size());
  const std::uint32_t first = stretch == 0 ? 0 : stretches_[stretch - 1].end_face;
  return std::span(faces_).subspan(first, stretches_[stretch].end_face - first);
}

LineKinds SideKinds::kinds_of_stretch(std::uint32_t stretch,
                                      std::span<const std::uint8_t> is_facing) const {
  const auto faces = faces_of(stretch);
  const bool is_outline = wants_outlines_ && std::ranges::any_of(faces, [&](std::uint32_t face) {
                            return is_facing[face] != is_facing[faces[0]];
                          });
  const LineKinds fixed = stretches_[stretch].fixed;
  return is_outline ? static_cast<LineKinds>(fixed | kinds_of(LineKind::outline)) : fixed;
}

void SideKinds::in_view(const RetainedScene& scene, const RetainedScene::Segment& segment,
                        const Eye& eye, std::span<LineKinds> of_corners,
                        TurnedAway turned_away) const {
  assert(of_corners.size() >= fixed_.size());
  std::ranges::copy(fixed_, of_corners.begin());
  if (ends_.empty() && parted_.empty()) return;
  std::vector<std::uint8_t> is_facing(segment.end - segment.first, 0);
  const bool counts = wants_outlines_ || !parted_.empty();
  for (std::uint32_t i = segment.first; counts && i < segment.end; ++i) {
    if (!scene[i].is_line() && faces(eye, scene.points(i))) is_facing[i - segment.first] = 1;
  }
  std::uint32_t first = 0;
  for (const std::uint32_t end : ends_) {
    const auto sides = std::span(shared_).subspan(first, end - first);
    first = end;
    const auto faces_eye = [&](const SharedSide& side) { return is_facing[side.primitive]; };
    const bool is_outline = std::ranges::any_of(
        sides, [&](const SharedSide& side) { return faces_eye(side) != faces_eye(sides[0]); });
    if (!is_outline) continue;
    for (const SharedSide& side : sides) {
      LineKinds& of_side = of_corners[side.corner];
      of_side = static_cast<LineKinds>(of_side | kinds_of(LineKind::outline));
    }
  }
  if (parted_.empty()) return;
  std::vector<LineKinds> of_stretches;
  for (std::uint32_t k = 0; k < stretches_.size(); ++k) {
    of_stretches.push_back(kinds_of_stretch(k, is_facing));
  }
  Tiling(*this, of_stretches, is_facing, turned_away, of_corners);
}

void SideKinds::in_any_view(std::span<LineKinds> of_corners) const {
  std::ranges::copy(fixed_, of_corners.begin());
  for (const SharedSide& side : shared_) {
    LineKinds& of_side = of_corners[side.corner];
    of_side = static_cast<LineKinds>(of_side | kinds_of(LineKind::outline));
  }
  for (const PartedSide& side : parted_) {
    LineKinds kinds = wants_outlines_ ? kinds_of(LineKind::outline) : LineKinds{0};
    for (std::uint32_t k = side.first; k < side.end; ++k) {
      kinds = static_cast<LineKinds>(kinds | stretches_[k].fixed);
    }
    LineKinds& of_side = of_corners[side.corner];
    of_side = static_cast<LineKinds>(of_side | (kinds & side.drawn));
  }
}

}  // namespace displayfile
