#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "clip/clip_pipeline.h"
#include "displayfile/gouraud.h"
#include "displayfile/retained_primitives.h"
#include "displayfile/style.h"

namespace displayfile {

/// What one view makes of whole primitives: clipped, checked for back faces and lit; in normalised
/// device coordinates. The arrays are used again for the next view.
class ViewedPrimitives {
 public:
  /// Lights are turned by `lights_turned`, a rotation.
  void view(const RetainedPrimitives& world, ClipPipeline& pipeline,
            const glm::dmat3& lights_turned);

  /// False if it is outside, or a back face that is removed.
  bool is_left(std::size_t i) const { return viewed_[i].sides > 0; }
  std::span<const Point3> points(std::size_t i) const {
    return std::span(points_).subspan(viewed_[i].first, viewed_[i].sides);
  }
  std::span<const std::uint8_t> edge_visible(std::size_t i) const {
    return std::span(edge_visible_).subspan(viewed_[i].first, viewed_[i].sides);
  }
  /// Empty unless the polygon is shaded smoothly.
  std::span<const double> intensities(std::size_t i) const {
    const auto& [first, sides, fill, shaded] = viewed_[i];
    return shaded ? std::span(intensities_).subspan(first, sides) : std::span<const double>();
  }
  const FillStyle& fill(std::size_t i) const { return viewed_[i].fill; }  ///< lit
  std::size_t points() const { return points_.size(); }                   ///< of all

 private:
  struct Viewed {
    std::size_t first = 0;
    std::size_t sides = 0;
    FillStyle fill;
    bool shaded = false;
  };
  void view_line(std::span<const Point3> world, const ClipPipeline& pipeline, Viewed& viewed);
  void view_polygon(const RetainedPrimitives& world, std::size_t i, ClipPipeline& pipeline,
                    const glm::dmat3& lights_turned, Viewed& viewed);

  std::vector<Viewed> viewed_;
  std::vector<Point3> points_;
  std::vector<std::uint8_t> edge_visible_;
  std::vector<double> intensities_;  // up to those of the last polygon that has some
  GouraudLighting lighting_;
};

}  // namespace displayfile
