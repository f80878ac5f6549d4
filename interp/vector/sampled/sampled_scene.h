#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/vertex_shading.h"
#include "displayfile/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/output_device.h"
#include "interp/scan/pixel_depth.h"

namespace displayfile {

/// A scene and what the sampled way adds to it for one picture size: the depths of its fills over
/// the pixels, and the list of the lines that are drawn. Points, styles and segments stay in the
/// scene.
struct SampledScene {
  using Item = ViewedScene::Item;
  using Fill = ViewedScene::Fill;

  struct Depths {
    PixelDepth plane;
    double nearest = 0.0, farthest = 0.0;  ///< z of the vertices
  };
  /// A line, or a drawn side of a polygon.
  struct LineEntry {
    Item item;
    std::uint32_t to;     ///< which of the item's points it ends at; it begins at the one before
    Fill fill;            ///< whose side it is; ViewedScene::kBackground if it is no fill's
    double from_z, to_z;  ///< on the polygon's plane
    double dash_start;    ///< pixels drawn of the line that it continues
  };
  /// The same with its ends in device coordinates.
  struct Line {
    Point3 from, to;
    Fill fill;
    const LineStyle& style;
    LineKinds kinds;
  };

  SampledScene(const DisplayFile& display_file, const PictureSize& size);

  Line line(std::uint32_t index) const;
  /// Calls draw(const DrawnPolygon&).
  template <class Draw>
  void draw_polygon(Item item, Draw&& draw) const;

  Point3 to_pixels(const Point3& device) const {
    return {device.x * size.width, device.y * size.height, device.z};
  }
  /// True if the point (pixel coordinates) belongs to the fill, by the even-odd rule and the rule
  /// for centres on an edge.
  bool covers(Fill fill, double x, double y) const;

  ViewedScene scene;
  PictureSize size;
  std::vector<Depths> depths;    ///< of the fills; those of the background mean nothing
  std::vector<LineEntry> lines;  ///< in order of entry

 private:
  void add_lines_of(Item first, Item end, Fill& next_fill);
  void add_sides(Item item, Fill fill);
  Depths depths_of(std::span<const Point3> vertices, const Plane& plane) const;
  double length(const Point3& a, const Point3& b) const;  ///< in pixels
};

template <class Draw>
void SampledScene::draw_polygon(Item item, Draw&& draw) const {
  const auto vertices = scene.points(item);
  std::vector<std::int32_t> sides(vertices.size());
  std::vector<LineKinds> kinds(vertices.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    kinds[i] = scene.side_kinds(item, i);
    sides[i] = kinds[i] != 0 ? op::line : op::move;
  }
  const FillStyle fill = scene.fill_style(item);
  std::vector<double> of_normals;
  draw(DrawnPolygon{vertices, sides, fill, scene.line_style(item), scene.pick_of_item(item),
                    vertex_intensities(scene.shading(item), of_normals), kinds});
}

}  // namespace displayfile
