#include "programs/sheet/part_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "displayfile/mesh/section.h"
#include "programs/sheet/part_lines.h"

namespace displayfile {

Point3 in_view(ViewKind view, const Point3& p) {
  switch (view) {
    case ViewKind::front: return p;
    case ViewKind::top: return {p.x, -p.z, p.y};
    case ViewKind::right: return {-p.z, p.y, p.x};
    case ViewKind::left: return {p.z, p.y, -p.x};
    case ViewKind::isometric: break;
  }
  return {(p.x - p.z) / std::sqrt(2.0), (2.0 * p.y - p.x - p.z) / std::sqrt(6.0),
          (p.x + p.y + p.z) / std::sqrt(3.0)};
}

Point3 toward_viewer(ViewKind view) {
  switch (view) {
    case ViewKind::front: return {0.0, 0.0, 1.0};
    case ViewKind::top: return {0.0, 1.0, 0.0};
    case ViewKind::right: return {1.0, 0.0, 0.0};
    case ViewKind::left: return {-1.0, 0.0, 0.0};
    case ViewKind::isometric: break;
  }
  return Point3(1.0 / std::sqrt(3.0));
}

namespace {

/// The sides of a cut face's loops, in either direction.
class SidesOfLoops {
 public:
  explicit SidesOfLoops(std::span<const std::vector<Point3>> loops) {
    for (const auto& loop : loops) {
      Point3 from = loop.back();
      for (const Point3& to : loop) sides_.push_back(side(std::exchange(from, to), to));
    }
    std::ranges::sort(sides_);
  }
  bool contains(const Point3& from, const Point3& to) const {
    return std::binary_search(sides_.begin(), sides_.end(), side(from, to));
  }

 private:
  using Side = std::array<double, 6>;

  static Side side(const Point3& from, const Point3& to) {
    const auto in_order = [](const Point3& a, const Point3& b) {
      return Side{a.x, a.y, a.z, b.x, b.y, b.z};
    };
    return std::min(in_order(from, to), in_order(to, from));
  }

  std::vector<Side> sides_;
};

/// The part behind the plane. Sides along the plane are not lines of it where they are sides of the
/// cut face.
Part part_behind(const Part& part, Section& cut) {
  Part behind;
  behind.mesh = std::move(cut.behind);
  behind.is_closed = part.is_closed;
  behind.part_of = part.part_of;
  behind.fills = part.fills;
  for (const std::size_t face : cut.face_of) {
    behind.fill_of_face.push_back(part.fill_of_face[face]);
  }
  const SidesOfLoops cut_sides(cut.loops);
  std::size_t corner = 0;
  for (std::size_t i = 0; i < behind.mesh.faces(); ++i) {
    const auto face = behind.mesh.face(i);
    Point3 from = behind.mesh.vertices[face.back()];
    for (const std::uint32_t v : face) {
      const Point3& to = behind.mesh.vertices[v];
      const std::size_t side = cut.side_of[corner++];
      const bool visible = side == Section::kInPlane  ? !cut_sides.contains(from, to)
                           : side == Section::kNoSide ? false
                                                      : part.side_visible[side] != 0;
      behind.side_visible.push_back(visible ? 1 : 0);
      from = to;
    }
  }
  return behind;
}

/// The faces of those objects for which the function returns true; all objects stay.
template <class IsKept>
Part objects_of(const Part& part, const IsKept& is_kept) {
  Part some;
  some.is_closed = part.is_closed;
  some.part_of = part.part_of;
  some.fills = part.fills;
  some.mesh.vertices = part.mesh.vertices;
  some.mesh.rounding = part.mesh.rounding;
  some.mesh.first_corner.push_back(0);
  for (std::size_t k = 0; k < part.mesh.objects.size(); ++k) {
    const Mesh::Object& object = part.mesh.objects[k];
    const std::size_t first = some.mesh.faces();
    for (std::size_t i = 0; is_kept(k) && i < object.faces; ++i) {
      const std::size_t face = object.first_face + i;
      const auto corners = part.mesh.face(face);
      const auto visible =
          part.side_visible.begin() + static_cast<std::ptrdiff_t>(part.mesh.first_corner[face]);
      some.mesh.corners.insert(some.mesh.corners.end(), corners.begin(), corners.end());
      some.side_visible.insert(some.side_visible.end(), visible,
                               visible + static_cast<std::ptrdiff_t>(corners.size()));
      some.mesh.first_corner.push_back(some.mesh.corners.size());
      some.fill_of_face.push_back(part.fill_of_face[face]);
    }
    some.mesh.objects.push_back({"", first, some.mesh.faces() - first});
  }
  return some;
}

/// Adds the objects of another part of the same fills, which are not empty.
void append(const Part& other, Part& part) {
  const std::size_t first_face = part.mesh.faces();
  const auto first_vertex = static_cast<std::uint32_t>(part.mesh.vertices.size());
  const std::size_t first_corner = part.mesh.corners.size();
  part.mesh.vertices.insert(part.mesh.vertices.end(), other.mesh.vertices.begin(),
                            other.mesh.vertices.end());
  for (const std::uint32_t v : other.mesh.corners) part.mesh.corners.push_back(first_vertex + v);
  for (std::size_t i = 1; i < other.mesh.first_corner.size(); ++i) {
    part.mesh.first_corner.push_back(first_corner + other.mesh.first_corner[i]);
  }
  part.side_visible.insert(part.side_visible.end(), other.side_visible.begin(),
                           other.side_visible.end());
  part.fill_of_face.insert(part.fill_of_face.end(), other.fill_of_face.begin(),
                           other.fill_of_face.end());
  for (std::size_t k = 0; k < other.mesh.objects.size(); ++k) {
    const Mesh::Object& object = other.mesh.objects[k];
    if (object.faces == 0) continue;
    part.mesh.objects.push_back({"", first_face + object.first_face, object.faces});
    part.is_closed.push_back(other.is_closed[k]);
    part.part_of.push_back(other.part_of[k]);
  }
}

/// The parts of the faces before the plane, as polygons on the paper, all counterclockwise.
std::vector<std::vector<Point2>> faces_before(const Mesh& mesh, double position) {
  const Section cut = section(mesh, {{0.0, 0.0, -1.0}, -position});
  std::vector<std::vector<Point2>> polygons;
  for (std::size_t i = 0; i < cut.behind.faces(); ++i) {
    auto& polygon = polygons.emplace_back();
    for (const std::uint32_t v : cut.behind.face(i)) polygon.emplace_back(cut.behind.vertices[v]);
    double twice_area = 0.0;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      const Point2 a = polygon[k - 1] - polygon[0], b = polygon[k] - polygon[0];
      twice_area += a.x * b.y - a.y * b.x;
    }
    if (twice_area < 0.0) std::ranges::reverse(polygon);
  }
  return polygons;
}

void add_cut_loops(const Section& cut, const Part& part, PartDrawing& view) {
  for (std::size_t i = 0; i < cut.loops.size(); ++i) {
    const std::size_t body = cut.object_of[i];
    auto& loop = view.cut.emplace_back();
    loop.body = static_cast<std::uint32_t>(body);
    loop.part = body < part.part_of.size() ? part.part_of[body] : 0;
    for (const Point3& p : cut.loops[i]) loop.points.emplace_back(p);
  }
}

/// The largest z of a shape turned about an axis, which is given in the view: its point nearest to
/// the viewer.
double nearest_of(const CentreAxis& axis, const Point3& from, const Point3& to) {
  const double length = glm::distance(from, to), rises = std::abs(to.z - from.z);
  const double across =
      length > 0.0 ? std::sqrt(std::max(0.0, 1.0 - (rises / length) * (rises / length))) : 1.0;
  return std::max(from.z, to.z) + across * axis.radius;
}

/// Takes the axes that have not been cut off with the geometry in front of the plane.
void add_centre_lines_of(std::span<const CentreAxis> axes, PartDrawing& view) {
  constexpr double kAlong = 1e-9;
  for (const CentreAxis& axis : axes) {
    const Point3 from = in_view(view.kind, axis.from), to = in_view(view.kind, axis.to);
    const double reach = axis.radius + std::abs(to.z - from.z);
    if (view.position && std::min(from.z, to.z) > *view.position + kAlong * reach) continue;
    const bool is_behind =
        view.position && nearest_of(axis, from, to) < *view.position - kAlong * reach;
    const Point2 along = Point2(to) - Point2(from);
    if (std::max(std::abs(along.x), std::abs(along.y)) > kAlong * reach) {
      view.centre_lines.push_back({Point2(from), Point2(to), is_behind});
      continue;
    }
    for (const Point2& arm : {Point2(axis.radius, 0.0), Point2(0.0, axis.radius)}) {
      view.centre_lines.push_back({Point2(from) - arm, Point2(from) + arm, is_behind});
    }
  }
}

/// The view of the part behind a plane across the line of sight, and of the cut faces.
void cut_view(const Part& part, const ViewWanted& wanted, const LinesWanted& lines,
              PartDrawing& view) {
  const SectionPlane plane{{0.0, 0.0, 1.0}, *wanted.position};
  const auto is_whole = [&](std::size_t object) {
    return !wanted.uncut.empty() && wanted.uncut[part.part_of[object]] != 0 &&
           goes_through(part, object, ViewKind::front, plane.distance);
  };
  const Part whole = objects_of(part, is_whole);
  const Part others = objects_of(part, [&](std::size_t object) { return !is_whole(object); });
  Section cut = section(others.mesh, plane);
  turn_bodies_out(cut, plane);
  view.closed = cut.closed;
  view.has_outlines = whole.mesh.faces() > 0;
  CutFacesOfPart faces{cap_polygons(cut, plane), {}};
  if (view.has_outlines) {
    faces.outlines = cut.loops;
    view.before = faces_before(whole.mesh, plane.distance);
  }
  add_cut_loops(cut, others, view);
  Part behind = part_behind(others, cut);
  append(whole, behind);
  Bounds box = bounds_of_used(behind.mesh);
  for (const auto& loop : cut.loops) {
    for (const Point3& p : loop) box.include(p);
  }
  if (!box.empty()) {
    view.low = Point2(box.low);
    view.high = Point2(box.high);
  }
  view.lines = lines_of_part(behind, faces, lines);
}

}  // namespace

bool goes_through(const Part& part, std::size_t object, ViewKind view, double position) {
  bool has_before = false, has_behind = false;
  const Mesh::Object& faces = part.mesh.objects[object];
  for (std::size_t i = 0; i < faces.faces; ++i) {
    for (const std::uint32_t corner : part.mesh.face(faces.first_face + i)) {
      const double along = in_view(view, part.mesh.vertices[corner]).z;
      has_before = has_before || along > position;
      has_behind = has_behind || along < position;
    }
  }
  return has_before && has_behind;
}

PartDrawing view_of_part(const Part& part, const ViewWanted& wanted, const LineSelection& lines,
                         int threads) {
  PartDrawing view;
  view.kind = wanted.kind;
  view.position = wanted.position;
  Part turned = part;
  for (Point3& p : turned.mesh.vertices) p = in_view(view.kind, p);
  const Bounds box = bounds_of_used(turned.mesh);
  view.low = Point2(box.low);
  view.high = Point2(box.high);
  if (wanted.centre_lines) add_centre_lines_of(part.axes, view);
  const LinesWanted lines_wanted{lines, wanted.hidden_lines, threads};
  if (wanted.position) {
    cut_view(turned, wanted, lines_wanted, view);
  } else {
    view.lines = lines_of_part(turned, {}, lines_wanted);
  }
  return view;
}

}  // namespace displayfile
