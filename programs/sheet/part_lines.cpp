#include "programs/sheet/part_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <span>
#include <utility>

#include "clip/geometry/planarity.h"
#include "clip/surfaces.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/polygon_stage.h"
#include "displayfile/segments/retained_scene.h"
#include "displayfile/segments/sorted_display_file.h"
#include "hidden/triangles/triangulation.h"

namespace displayfile {

Bounds bounds_of_used(const Mesh& mesh) {
  Bounds bounds;
  for (const std::uint32_t corner : mesh.corners) bounds.include(mesh.vertices[corner]);
  return bounds;
}

namespace {

/// Middle and half the side of a window around all that is seen.
struct SquareWindow {
  Point3 middle;
  double half;

  View view() const {
    View view;
    view.set_window({middle.x - half, middle.x + half, middle.y - half, middle.y + half});
    view.set_depth(-(middle.z + half), -(middle.z - half));
    return view;
  }
};

/// Its side is a power of 2 and its middle a multiple of a fraction of that: coordinates of few
/// digits are exact in the window, so that aligned points stay aligned on paper and edge-on faces
/// stay edge-on.
SquareWindow exact_window(const Bounds& box) {
  constexpr double kSteps = 1024.0, kMargin = 1.02;
  const Point3 extent = box.high - box.low;
  const double size = std::max({extent.x, extent.y, extent.z});
  const double half = size > 0.0 ? std::exp2(std::ceil(std::log2(0.5 * kMargin * size))) : 1.0;
  const double step = half / kSteps;
  return {step * glm::round(0.5 * (box.low + box.high) / step), half};
}

/// Enters the faces of a part into a scene.
class PartEntry {
 public:
  PartEntry(const Part& part, RetainedScene& scene) : part_(part), scene_(scene) {}

  void enter_object(const Mesh::Object& object) {
    for (std::size_t i = 0; i < object.faces; ++i) enter_face(object.first_face + i);
  }

 private:
  void enter_face(std::size_t face) {
    const Mesh& mesh = part_.mesh;
    attributes_.fill = part_.fills[part_.fill_of_face[face]];
    points_.clear();
    for (const std::uint32_t corner : mesh.face(face)) points_.push_back(mesh.vertices[corner]);
    const auto visible =
        std::span(part_.side_visible).subspan(mesh.first_corner[face], points_.size());
    if (points_.size() == 3 || is_flat(points_)) return enter(points_, visible);
    for (const auto& [vertex, edge_visible] : triangulation_.triangulate(points_)) {
      std::array<Point3, 3> corners;
      std::array<std::uint8_t, 3> drawn{};
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = points_[vertex[k]];
        drawn[k] = edge_visible[k] != 0 ? visible[vertex[k]] : std::uint8_t{0};
      }
      enter(corners, drawn);
    }
  }
  void enter(std::span<const Point3> corners, std::span<const std::uint8_t> visible) {
    scene_.enter_polygon({corners, visible, Point3(0.0), {}, 0}, attributes_);
  }

  const Part& part_;
  RetainedScene& scene_;
  Attributes attributes_;
  std::vector<Point3> points_;
  Triangulation triangulation_;
};

/// Closed objects are in segments of their own: touching objects have no sides in common. All
/// others together, since they may be parts of one surface.
RetainedScene scene_of(const Part& part, const CutFacesOfPart& cut, const LineSelection& selection,
                       const View& view) {
  RetainedScene scene;
  PartEntry entry(part, scene);
  int name = 0;
  const auto segment = [&](const auto& enter) {
    scene.open_segment(++name, view, {Touching::Kind::length, entered_reach(part.mesh)});
    enter();
    scene.close_segment(selection);
  };
  const auto objects = std::span(part.mesh.objects);
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (part.is_closed[k] == 0 || objects[k].faces == 0) continue;
    segment([&] { entry.enter_object(objects[k]); });
  }
  segment([&] {
    for (std::size_t k = 0; k < objects.size(); ++k) {
      if (part.is_closed[k] == 0) entry.enter_object(objects[k]);
    }
  });
  segment([&] {
    Attributes plain;
    plain.line.kind = LineStyle::Kind::none;
    for (const auto& cap : cut.caps) scene.enter_polygon({cap, {}, Point3(0.0), {}, 0}, plain);
    for (const auto& loop : cut.outlines) {
      Point3 from = loop.back();
      for (const Point3& to : loop) scene.enter_line(std::exchange(from, to), to, Attributes(), 0);
    }
  });
  return scene;
}

/// As the application would have drawn it in the view.
DisplayFile in_view(const RetainedScene& scene, const View& view) {
  DisplayFile file;
  PolygonStage stage{ViewVolume(view)};
  for (const RetainedScene::Segment& part : scene.segments()) {
    Segment& segment = file.create(part.name);
    scene.enter_viewed(part, Eye::of(view), stage, glm::dmat3(1.0), segment, [](std::uint32_t) {});
    segment.close();
  }
  return file;
}

/// Collects lines of the display file, in the square window that it was drawn in.
struct LineCollector {
  Point2 corner;
  double side;
  std::vector<PartDrawing::Line> lines{};
  bool hidden = false;
  mutable bool next_is_alone = false;
  Point2 pen{0.0};

  Point2 on_paper(const Point3& p) const { return corner + side * Point2(p); }
  void fill(const FillStyle&) {}
  void line_style(const LineStyle&) {}
  void line_kinds(LineKinds kinds) { hidden = is_hidden_line(kinds); }
  void pick(int) {}
  /// Which lines are shorter than their pen is wide is known where the scale is.
  bool is_crumb(const Point3&, const Point3&) const {
    next_is_alone = true;
    return false;
  }
  void move(const Point3& p) { pen = on_paper(p); }
  void line(const Point3& p) {
    const Point2 from = pen;
    move(p);
    lines.push_back({from, pen, hidden, std::exchange(next_is_alone, false)});
  }
  void polygon(std::span<const Point3>, std::span<const std::int32_t>) {}
};

}  // namespace

std::vector<PartDrawing::Line> lines_of_part(const Part& part, const CutFacesOfPart& cut,
                                             const LinesWanted& wanted) {
  Bounds box = bounds_of_used(part.mesh);
  for (const auto& cap : cut.caps) {
    for (const Point3& p : cap) box.include(p);
  }
  if (box.empty()) return {};
  const SquareWindow window = exact_window(box);
  const View view = window.view();
  const RetainedScene scene = scene_of(part, cut, wanted.selection, view);
  const SurfacePlan plan{.method = HiddenMethod::franklin,
                         .hidden_lines = wanted.hidden ? HiddenLines::dashed : HiddenLines::none,
                         .intersections = contains(wanted.selection.kinds, LineKind::intersection),
                         .scope = HiddenScope::all,
                         .threads = wanted.threads};
  SortedDisplayFile sorted;
  const DisplayFile& file = sorted.update(in_view(scene, view), plan);
  LineCollector collector{Point2(window.middle) - window.half, 2.0 * window.half};
  if (file.sorted()) {
    file.sorted()->walk(collector);
  } else {
    for (const Segment& segment : file.segments()) segment.walk_drawn(collector);
  }
  return std::move(collector.lines);
}

}  // namespace displayfile
