#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "clip/geometry/clip_to_rectangle.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/visibility/drawn_layers.h"
#include "interp/visibility/pixel_tree.h"

namespace displayfile {

/// Finds visible lines of a scene, and visible drawn sides of its polygons, near a point of a
/// picture: by the rule of lines (interp/truth/truth.md). The side of a line on which a vertex
/// lies, and whether a line's end is behind a fill, are decided exactly; positions of changes along
/// the line are rounded (interp/visibility/ray_cast.md).
class LinePicker {
 public:
  using Item = ViewedScene::Item;
  using Fill = ViewedScene::Fill;

  /// The scene must live as long as the picker. Where the layers require it, a line is hidden by
  /// the fills drawn over it instead of nearer ones.
  LinePicker(const ViewedScene& scene, const PictureSize& size, int threads,
             DrawnLayers layers = {});

  const DrawnLayers& layers() const { return layers_; }

  struct Found {
    Item item;
    bool is_edge;     ///< of a polygon
    double distance;  ///< pixels from the point to the line's axis
    double depth;     ///< there
  };
  /// The line with a visible point nearest to a point (pixels, y up), within `reach` pixels or half
  /// the line's width. Of several that have this nearest point in common: the one drawn over the
  /// others, or else a side of the fill visible there, or else the one nearer to the viewer, or
  /// else the one entered later. A line seen end-on is not found.
  std::optional<Found> nearest(const Point2& at, double reach, Fill seen_there) const;

 private:
  /// A line, or the side of a polygon that ends at a vertex.
  struct Entry {
    Item item;
    std::uint32_t to;  ///< index of the item's point at which it ends
    Fill fill;         ///< the fill whose side it is, if any
  };
  struct Line;
  struct Hider;

  void enter_lines(int threads);
  void enter_fills(int threads);
  PixelBox box_of(const Point2& low, const Point2& high, double margin) const;
  Line line_of(const Entry& entry) const;
  double half_width(const Entry& entry) const;
  Point2 pixel(const Point3& device) const {
    return {device.x * size_.width, device.y * size_.height};
  }
  std::optional<LinePart> stretch_within(const Line& line, const Point2& at, double reach) const;
  std::vector<Hider> hiders_of(const Line& line, const LinePart& stretch) const;
  std::optional<LinePart> part_before(const Line& line, Fill fill) const;
  std::optional<Hider> hider(const Line& line, Fill fill) const;
  std::vector<LinePart> seen_parts(const Line& line, const LinePart& part) const;

  const ViewedScene& scene_;
  PictureSize size_;
  DrawnLayers layers_;
  std::vector<Entry> entries_;
  PixelTree lines_, fills_;
};

}  // namespace displayfile
