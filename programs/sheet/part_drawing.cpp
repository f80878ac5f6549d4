#include "programs/sheet/part_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "displayfile/mesh/cap_polygons.h"
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

/// What is left of a part behind the plane. Sides along the plane are no lines of it where they are
/// sides of the cut face.
Part part_behind(const Part& part, Section& cut) {
  Part behind;
  behind.mesh = std::move(cut.behind);
  behind.is_closed = part.is_closed;
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

}  // namespace

PartDrawing view_of_part(const Part& part, ViewKind kind, const LineSelection& lines,
                         std::optional<double> position, int threads) {
  PartDrawing view;
  view.kind = kind;
  view.position = position;
  Part turned = part;
  for (Point3& p : turned.mesh.vertices) p = in_view(kind, p);
  const Bounds box = bounds_of_used(turned.mesh);
  view.low = Point2(box.low);
  view.high = Point2(box.high);
  const LinesWanted wanted{lines, threads};
  if (!position) {
    view.lines = lines_of_part(turned, {}, wanted);
    return view;
  }
  const SectionPlane plane{{0.0, 0.0, 1.0}, *position};
  Section cut = section(turned.mesh, plane);
  turn_bodies_out(cut, plane);
  const auto caps = cap_polygons(cut, plane);
  view.closed = cut.closed;
  view.lines = lines_of_part(part_behind(turned, cut), caps, wanted);
  for (const auto& loop : cut.loops) {
    auto& flat = view.cut.emplace_back();
    for (const Point3& p : loop) flat.emplace_back(p);
  }
  return view;
}

}  // namespace displayfile
