#include "displayfile/view_stage.h"

#include "clip/back_face.h"

namespace displayfile {

std::span<const Point3> ViewStage::enter_polygon(const WorldPolygon& polygon,
                                                 const Attributes& attributes, Segment& segment) {
  ClippedPolygon clipped = polygon.vertex_normals.empty()
                               ? pipeline_.clip_polygon(polygon.vertices, polygon.edge_visible)
                               : lighting_.clip(pipeline_, polygon.vertices, polygon.edge_visible,
                                                polygon.vertex_normals, *attributes.light);
  if (clipped.vertices.size() < 3) return {};
  if (attributes.back_face_removal && is_back_face(clipped.vertices)) return {};
  if (attributes.light) {
    segment.set_style(lit_fill(polygon, attributes, clipped));
    segment.set_style(attributes.line);
  } else if (!styles_entered_) {
    segment.set_style(attributes.fill);
    segment.set_style(attributes.line);
    styles_entered_ = true;
  }
  segment.set_pick(polygon.pick);
  segment.enter_polygon(clipped.vertices, clipped.edge_visible, clipped.intensities);
  return clipped.vertices;
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

}  // namespace displayfile
