#include "displayfile/view_stage.h"

#include "clip/back_face.h"

namespace displayfile {

ViewedPolygon ViewStage::view_polygon(const WorldPolygon& polygon, const Attributes& attributes) {
  const ClippedPolygon clipped =
      polygon.vertex_normals.empty()
          ? pipeline_.clip_polygon(polygon.vertices, polygon.edge_visible)
          : lighting_.clip(pipeline_, polygon.vertices, polygon.edge_visible,
                           polygon.vertex_normals, *attributes.light);
  return view_clipped(clipped, polygon, attributes);
}

std::span<const Point3> ViewStage::enter_polygon(const WorldPolygon& polygon,
                                                 const Attributes& attributes, Segment& segment) {
  return enter(view_polygon(polygon, attributes), attributes, polygon.pick, segment);
}

void ViewStage::view_vertices(std::span<const Point3> world, std::uint32_t first) {
  first_shared_ = first;
  shared_.clear();
  shared_.reserve(world.size());
  for (const Point3& p : world) shared_.push_back(pipeline_.view(p));
}

ViewStage::Outcodes ViewStage::outcodes(std::span<const std::uint32_t> corners) const {
  Outcodes codes{0, ~0u};
  for (const std::uint32_t corner : corners) {
    codes.any |= viewed(corner).outcode;
    codes.all &= viewed(corner).outcode;
  }
  return codes;
}

std::optional<bool> ViewStage::enter_plain(std::span<const std::uint32_t> corners,
                                           std::int32_t pick, const Attributes& attributes,
                                           Segment& segment) {
  if (!styles_entered_ || attributes.light || attributes.back_face_removal) return std::nullopt;
  const Outcodes codes = outcodes(corners);
  if (codes.all != 0) return false;  // wholly outside of one plane
  if (codes.any != 0) return std::nullopt;
  segment.set_pick(pick);
  segment.enter_next_polygon(static_cast<std::uint32_t>(corners.size()),
                             [&](std::uint32_t i) { return viewed(corners[i]).device; });
  return true;
}

bool ViewStage::enter_shared(std::span<const std::uint32_t> corners, const WorldPolygon& polygon,
                             const Attributes& attributes, Segment& segment) {
  const bool all_drawn = polygon.edge_visible.empty();
  if (all_drawn && polygon.vertex_normals.empty()) {
    const auto entered = enter_plain(corners, polygon.pick, attributes, segment);
    if (entered) return *entered;
  }
  const Outcodes codes = outcodes(corners);
  if (codes.all != 0) return false;
  if (codes.any != 0 || !polygon.vertex_normals.empty()) {
    return !enter_polygon(polygon, attributes, segment).empty();
  }
  device_.clear();
  for (const std::uint32_t corner : corners) device_.push_back(viewed(corner).device);
  if (all_edges_.size() < corners.size()) all_edges_.resize(corners.size(), 1);
  const ClippedPolygon whole{
      device_, all_drawn ? std::span(all_edges_).first(corners.size()) : polygon.edge_visible};
  const ViewedPolygon drawn = view_clipped(whole, polygon, attributes);
  return !enter(drawn, attributes, polygon.pick, segment).empty();
}

/// BACK-FACE-CHECK (algorithm 9.3) and the light.
ViewedPolygon ViewStage::view_clipped(ClippedPolygon clipped, const WorldPolygon& polygon,
                                      const Attributes& attributes) {
  if (clipped.vertices.size() < 3) return {};
  if (attributes.back_face_removal && is_back_face(clipped.vertices)) return {};
  if (!attributes.light) return {clipped, &attributes.fill};
  lit_ = lit_fill(polygon, attributes, clipped);
  return {clipped, &lit_};
}

std::span<const Point3> ViewStage::enter(const ViewedPolygon& viewed, const Attributes& attributes,
                                         std::int32_t pick, Segment& segment) {
  const ClippedPolygon& polygon = viewed.polygon;
  if (polygon.vertices.empty()) return {};
  if (attributes.light || !styles_entered_) {
    segment.set_style(*viewed.fill);
    segment.set_style(attributes.line);
    styles_entered_ = !attributes.light;
  }
  segment.set_pick(pick);
  segment.enter_polygon(polygon.vertices, polygon.edge_visible, polygon.intensities);
  return polygon.vertices;
}

/// The intensities of a polygon that is lit evenly after all are taken away.
FillStyle ViewStage::lit_fill(const WorldPolygon& polygon, const Attributes& attributes,
                              ClippedPolygon& clipped) const {
  const Light& light = *attributes.light;
  const bool turned_away = !attributes.back_face_removal && newell_c(clipped.vertices) < 0.0;
  FillStyle fill = polygon.vertex_normals.empty()
                       ? lit(attributes.fill, light, polygon.normal, turned_away)
                       : shaded_fill(attributes.fill, clipped);
  if (attributes.shadows) {
    fill.shadow = shadow_on(fill, attributes.fill, light, pipeline_.volume());
  }
  return fill;
}

bool ViewStage::enter_line(const Point3& from, const Point3& to, const LineStyle& style,
                           Segment& segment) {
  Point3 a, b;
  if (!pipeline_.clip_line(from, to, a, b)) return false;
  segment.set_style(style);
  segment.enter_line(a, b);
  return true;
}

bool ViewStage::enter_text(const Point3& anchor, std::string_view characters,
                           const Attributes& attributes, Segment& segment) {
  const ViewedVertex viewed = pipeline_.view(anchor);
  if (viewed.outcode != 0) return false;
  segment.set_style(attributes.line);
  segment.set_style(attributes.text);
  segment.enter_text(viewed.device, characters);
  return true;
}

}  // namespace displayfile
