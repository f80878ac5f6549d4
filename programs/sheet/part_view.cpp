#include "programs/sheet/part_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "displayfile/mesh/cap_polygons.h"
#include "displayfile/sorted_display_file.h"

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

struct SeenBox {
  Point3 low{HUGE_VAL}, high{-HUGE_VAL};
  void include(const Point3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

SeenBox box_of_used(const Mesh& mesh) {
  SeenBox box;
  for (const std::uint32_t corner : mesh.corners) box.include(mesh.vertices[corner]);
  return box;
}

/// Collects lines of the display file, in the square window that it was drawn in.
struct LineCollector {
  Point2 corner;
  double side;
  std::vector<PartView::Line>& lines;
  std::optional<double> cap;  ///< the depth of a cut face: lines in it are its loops
  bool hidden = false;
  Point3 pen{0.0};

  Point2 on_paper(const Point3& p) const { return corner + side * Point2(p); }
  void fill(const FillStyle&) {}
  void line_style(const LineStyle& style) { hidden = style.kind == LineStyle::Kind::dashed; }
  void pick(int) {}
  void move(const Point3& p) { pen = p; }
  void line(const Point3& p) {
    constexpr double kSame = 1e-12;
    const bool in_cap = cap && std::abs(pen.z - *cap) < kSame && std::abs(p.z - *cap) < kSame;
    if (!in_cap) lines.push_back({on_paper(pen), on_paper(p), hidden});
    pen = p;
  }
  void polygon(std::span<const Point3>, std::span<const std::int32_t>) {}
};

/// Middle and half the side of a window around all that is seen.
struct SquareWindow {
  Point3 middle;
  double half;
};

/// Its side is a power of 2, and its middle a multiple of a part of that: coordinates of few digits
/// are the window's without rounding, so that what is in line on paper stays so, and a face that is
/// seen edge-on is.
SquareWindow exact_window(const SeenBox& box) {
  constexpr double kSteps = 1024.0, kMargin = 1.02;
  const Point3 extent = box.high - box.low;
  const double size = std::max({extent.x, extent.y, extent.z});
  const double half = size > 0.0 ? std::exp2(std::ceil(std::log2(0.5 * kMargin * size))) : 1.0;
  const double step = half / kSteps;
  return {step * glm::round(0.5 * (box.low + box.high) / step), half};
}

/// Which depths are the same. The isometric view's coordinates are rounded: of solids that touch,
/// the edges of one would be before or behind the face of the other as it comes. The other views'
/// are not.
Precision precision_of(ViewKind kind) {
  constexpr double kRounding = 1e-12;
  if (kind == ViewKind::isometric) return {.exact = false, .roundoff = kRounding};
  return {};
}

void find_lines(const Mesh& mesh, const Section* cut, const SectionPlane& plane,
                const LineSelection& selection, int threads, PartView& view) {
  if (mesh.faces() == 0 && (cut == nullptr || cut->loops.empty())) return;
  SeenBox box = box_of_used(mesh);
  if (cut != nullptr) {
    for (const auto& loop : cut->loops) {
      for (const Point3& p : loop) box.include(p);
    }
  }
  const auto [middle, half] = exact_window(box);
  GraphicsSystem system;
  system.set_threads(threads);
  system.set_window(middle.x - half, middle.x + half, middle.y - half, middle.y + half);
  system.set_view_depth(-(middle.z + half), -(middle.z - half));
  system.set_hidden_line_removal(true);
  system.set_back_face_removal(false);
  system.set_hidden_method(HiddenMethod::franklin);
  system.set_hidden_scope(HiddenScope::all);
  system.set_hidden_lines(HiddenLines::dashed);
  system.set_lines(selection);
  system.set_fill_style({});
  system.set_line_style({});
  system.open_segment(1);
  std::vector<std::uint32_t> sides;
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    sides.push_back(static_cast<std::uint32_t>(mesh.face(i).size()));
  }
  if (!sides.empty()) system.polygons_abs_3(mesh.vertices, mesh.corners, sides);
  std::optional<double> cap;
  if (cut != nullptr && !cut->loops.empty()) {
    system.set_line_style({LineStyle::Kind::none});
    for (const auto& polygon : cap_polygons(*cut, plane)) system.polygon_abs_3(polygon);
    cap = system.to_device(cut->loops[0][0])->z;
  }
  system.close_segment();
  SortedDisplayFile sorted;
  HiddenSurfaceOptions options;
  options.method = HiddenMethod::franklin;
  options.scope = HiddenScope::all;
  options.threads = threads;
  options.hidden_lines = HiddenLines::dashed;
  options.precision = precision_of(view.kind);
  const DisplayFile& file = sorted.update(system, HiddenMethod::franklin, options);
  LineCollector collector{{middle.x - half, middle.y - half}, 2.0 * half, view.lines, cap};
  if (file.sorted()) {
    file.sorted()->walk(collector);
  } else {
    for (const Segment& segment : file.segments()) segment.walk_drawn(collector);
  }
}

}  // namespace

PartView view_of_part(const Mesh& part, ViewKind kind, const LineSelection& lines,
                      std::optional<double> position, bool hatched, int threads) {
  PartView view;
  view.kind = kind;
  view.position = position;
  Mesh turned = part;
  for (Point3& p : turned.vertices) p = in_view(kind, p);
  const SeenBox box = box_of_used(turned);
  view.low = Point2(box.low);
  view.high = Point2(box.high);
  if (!position) {
    find_lines(turned, nullptr, {}, lines, threads, view);
    return view;
  }
  const SectionPlane plane{{0.0, 0.0, 1.0}, *position};
  Section cut = section(turned, plane);
  if (!hatched) cut.loops.clear();
  find_lines(cut.behind, &cut, plane, lines, threads, view);
  for (const auto& loop : cut.loops) {
    auto& flat = view.cut.emplace_back();
    for (const Point3& p : loop) flat.emplace_back(p);
  }
  return view;
}

}  // namespace displayfile
