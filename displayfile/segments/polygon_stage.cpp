#include "displayfile/segments/polygon_stage.h"

#include <algorithm>
#include <array>

#include "clip/geometry/back_face.h"

namespace displayfile {

StagedPolygon PolygonStage::view_polygon(const WorldPolygon& polygon,
                                         const Attributes& attributes) {
  const ClippedPolygon clipped =
      polygon.vertex_normals.empty()
          ? pipeline_.clip_polygon(polygon.vertices, polygon.edge_visible)
          : clip_smooth(polygon, attributes);
  return view_clipped(clipped, polygon, attributes);
}

/// Clips a polygon with the values interpolated over it. Equal normals, whatever their length, need
/// no interpolation.
ClippedPolygon PolygonStage::clip_smooth(const WorldPolygon& polygon,
                                         const Attributes& attributes) {
  const auto& vertices = polygon.vertices;
  const auto& edge_visible = polygon.edge_visible;
  const auto& normals = polygon.vertex_normals;
  if (attributes.shading != Shading::phong) {
    return gouraud_.clip(pipeline_, vertices, edge_visible, normals, *attributes.light);
  }
  if (!differ(normals)) return pipeline_.clip_polygon(vertices, edge_visible);
  return phong_.clip(pipeline_, vertices, edge_visible, normals);
}

namespace {

const PointRow& as_entered(const WorldPolygon& polygon) {
  return polygon.modelling == nullptr ? polygon.vertices : polygon.entered;
}

/// Keeps the polygon as the application entered it, with or without an instruction.
void keep_entered(const WorldPolygon& polygon, bool is_seen, Segment& segment) {
  EnteredPolygons* const kept = segment.keeping_entered();
  if (kept == nullptr) return;
  for (const Point3& p : as_entered(polygon)) kept->include(p);
  kept->enter(as_entered(polygon), polygon.modelling);
  if (polygon.is_cut && polygon.modelling != nullptr) kept->note_cut();
  if (!is_seen) kept->note_not_seen();
}

}  // namespace

bool PolygonStage::enter_polygon(const WorldPolygon& polygon, const Attributes& attributes,
                                 Segment& segment) {
  const bool is_seen = enter(view_polygon(polygon, attributes), attributes, polygon.pick, segment);
  keep_entered(polygon, is_seen, segment);
  return is_seen;
}

void PolygonStage::note_entered(std::span<const Point3> vertices, const glm::dmat4x3* modelling,
                                Segment& segment) {
  EnteredPolygons* const kept = segment.keeping_entered();
  if (kept == nullptr) return;
  kept->begin_shared(vertices.size());
  entered_shared_ = vertices;
  modelling_of_shared_ = modelling;
}

void PolygonStage::keep_shared(std::span<const std::uint32_t> corners, bool is_seen,
                               Segment& segment) const {
  EnteredPolygons* const kept = segment.keeping_entered();
  if (kept == nullptr) return;
  for (const std::uint32_t corner : corners) kept->include(entered_shared_[corner]);
  kept->enter_shared(entered_shared_, corners, modelling_of_shared_);
  if (!is_seen) kept->note_not_seen();
}

void PolygonStage::view_vertices(std::span<const Point3> world, std::uint32_t first) {
  first_shared_ = first;
  entered_shared_ = {};
  shared_.clear();
  shared_.reserve(world.size());
  for (const Point3& p : world) met_ |= shared_.emplace_back(pipeline_.view(p)).outcode;
}

PolygonStage::Outcodes PolygonStage::outcodes(std::span<const std::uint32_t> corners) const {
  Outcodes codes{0, ~0u};
  for (const std::uint32_t corner : corners) {
    codes.any |= viewed(corner).outcode;
    codes.all &= viewed(corner).outcode;
  }
  return codes;
}

std::optional<bool> PolygonStage::enter_triangle(std::span<const Point3> world,
                                                 const SharedTriangle& triangle,
                                                 const Attributes& attributes, Segment& segment) {
  const auto& corners = triangle.corners;
  const auto is_not_seen = [&] {
    keep_shared(corners, false, segment);
    return false;
  };
  const Outcodes codes = outcodes(corners);
  if (codes.all != 0) return is_not_seen();  // wholly outside of one plane
  const bool needs_more = (attributes.light && attributes.shadows) || attributes.dark_line;
  if (codes.any != 0 || needs_more) return std::nullopt;
  const std::array device{viewed(corners[0]).device, viewed(corners[1]).device,
                          viewed(corners[2]).device};
  const bool turns = attributes.back_face_removal || attributes.light;
  const double c = turns ? newell_c(device) : 0.0;
  if (attributes.back_face_removal && c <= 0.0) return is_not_seen();
  if (attributes.light) {
    const std::array own{world[corners[0]], world[corners[1]], world[corners[2]]};
    enter_styles(lit(attributes.fill, *attributes.light, newell_normal(own), c < 0.0),
                 attributes.line, attributes, segment);
  } else {
    enter_styles(attributes.fill, attributes.line, attributes, segment);
  }
  segment.set_pick(triangle.pick);
  segment.enter_next_polygon(
      3, [&](std::uint32_t i) { return device[i]; },
      [&](std::uint32_t i) { return triangle.edge_visible[i] != 0; });
  keep_shared(corners, true, segment);
  return true;
}

bool PolygonStage::enter_shared(std::span<const std::uint32_t> corners, const WorldPolygon& polygon,
                                const Attributes& attributes, Segment& segment) {
  const auto keep = [&](bool is_seen) {
    if (entered_shared_.empty()) {
      keep_entered(polygon, is_seen, segment);
    } else {
      keep_shared(corners, is_seen, segment);
    }
    return is_seen;
  };
  const bool all_drawn = polygon.edge_visible.empty();
  const Outcodes codes = outcodes(corners);
  if (codes.all != 0) return keep(false);
  if (codes.any != 0 || !polygon.vertex_normals.empty()) {
    return enter_polygon(polygon, attributes, segment);
  }
  device_.clear();
  for (const std::uint32_t corner : corners) device_.push_back(viewed(corner).device);
  if (all_edges_.size() < corners.size()) all_edges_.resize(corners.size(), 1);
  const ClippedPolygon whole{
      device_, all_drawn ? std::span(all_edges_).first(corners.size()) : polygon.edge_visible};
  const StagedPolygon drawn = view_clipped(whole, polygon, attributes);
  return keep(enter(drawn, attributes, polygon.pick, segment));
}

/// BACK-FACE-CHECK (algorithm 9.3) and the light.
StagedPolygon PolygonStage::view_clipped(ClippedPolygon clipped, const WorldPolygon& polygon,
                                         const Attributes& attributes) {
  if (clipped.vertices.size() < 3) return {};
  if (attributes.back_face_removal && is_back_face(clipped.vertices)) return {};
  const LineStyle* const line = &line_of(attributes, clipped);
  if (!attributes.light) return {clipped, &attributes.fill, line};
  lit_ = lit_fill(polygon, attributes, clipped);
  return {clipped, &lit_, line, &*attributes.light};
}

/// A hollow polygon that draws none of its sides in this view is kept, with invisible sides: the
/// contents of a scene do not depend on the view.
const LineStyle& PolygonStage::line_of(const Attributes& attributes, ClippedPolygon& clipped) {
  if (!attributes.dark_line) return attributes.line;
  const bool dark = newell_c(clipped.vertices) < 0.0;
  const LineStyle& line = attributes.line_of(dark);
  const bool is_left_out =
      line.kind == LineStyle::Kind::none && attributes.fill.kind != FillStyle::Kind::solid;
  if (!is_left_out || !attributes.is_outlined()) return line;
  no_edges_.resize(std::max(no_edges_.size(), clipped.vertices.size()), 0);
  clipped.edge_visible = std::span(no_edges_).first(clipped.vertices.size());
  return attributes.line_of(!dark);
}

bool PolygonStage::enter(const StagedPolygon& viewed, const Attributes& attributes,
                         std::int32_t pick, Segment& segment) {
  const ClippedPolygon& polygon = viewed.polygon;
  if (viewed.fill == nullptr || viewed.line == nullptr) return false;  // nothing of it is drawn
  enter_styles(*viewed.fill, *viewed.line, attributes, segment);
  segment.set_pick(pick);
  segment.enter_polygon(polygon.vertices, polygon.edge_visible, viewed.shading());
  return true;
}

void PolygonStage::enter_styles(const FillStyle& fill, const LineStyle& line,
                                const Attributes& attributes, Segment& segment) {
  if (!fill_entered_) segment.set_style(fill);
  if (!line_entered_) segment.set_style(line);
  fill_entered_ = !attributes.light;
  line_entered_ = !attributes.dark_line;
}

/// Returns the lit fill. If the polygon is evenly lit after all, removes its intensities or
/// normals.
FillStyle PolygonStage::lit_fill(const WorldPolygon& polygon, const Attributes& attributes,
                                 ClippedPolygon& clipped) const {
  const Light& light = *attributes.light;
  const auto of_normal = [&](const Point3& normal) {
    const bool turned_away = !attributes.back_face_removal && newell_c(clipped.vertices) < 0.0;
    return lit(attributes.fill, light, normal, turned_away);
  };
  FillStyle fill = polygon.vertex_normals.empty() ? of_normal(polygon.normal)
                   : !clipped.intensities.empty() ? shaded_fill(attributes.fill, clipped)
                   : !clipped.normals.empty()     ? phong_fill(attributes.fill, light, clipped)
                                                  : of_normal(polygon.vertex_normals[0]);
  if (attributes.shadows) {
    fill.shadow = shadow_on(fill, attributes.fill, light, pipeline_.volume());
  }
  return fill;
}

bool PolygonStage::enter_line(const Point3& from, const Point3& to, const LineStyle& style,
                              Segment& segment) {
  EnteredPolygons* const kept = segment.keeping_entered();
  if (kept != nullptr) {
    for (const Point3& end : {from, to}) kept->include(end);
  }
  Point3 a, b;
  if (!pipeline_.clip_line(from, to, a, b)) return false;
  if (kept != nullptr) kept->enter_line(from, to);
  segment.set_style(style);
  segment.enter_line(a, b);
  return true;
}

bool PolygonStage::enter_text(const Point3& anchor, std::string_view characters,
                              const Attributes& attributes, Segment& segment) {
  const PipelineVertex viewed = pipeline_.view(anchor);
  met_ |= viewed.outcode;
  if (viewed.outcode != 0) return false;
  segment.set_style(attributes.line);
  segment.set_style(attributes.text);
  segment.enter_text(viewed.device, characters);
  return true;
}

bool PolygonStage::enter_annotation(const KeptAnnotation& annotation, Segment& segment) {
  met_ |= pipeline_.volume().active();
  std::optional<KeptAnnotation> in_view = displayfile::viewed(annotation, pipeline_.volume());
  if (!in_view) return false;
  segment.enter_annotation(*std::move(in_view));
  return true;
}

}  // namespace displayfile
