#include "interp/draw/cropped_figure.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "clip/base/round_to_nearest.h"
#include "clip/view/view_volume.h"

namespace displayfile {

namespace {

/// True if a point is beyond a side of the window, or behind the eye.
bool is_beyond(const ViewVolume& volume, const Point3& point) {
  constexpr double kRounding = 1e-9;  // of the window
  const HomogeneousPoint p = volume.transform(point);
  const double slack = kRounding * p.w;
  return !(p.w > 0.0 && p.x >= -slack && p.x <= p.w + slack && p.y >= -slack && p.y <= p.w + slack);
}

}  // namespace

CroppedFigure cropped_figure(const RetainedScene& scene, const DisplayFile& display_file) {
  const RoundToNearest nearest;
  CroppedFigure figure;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!display_file.segment(segment.name).visible) continue;
    const ViewVolume volume(segment.view);
    const auto add = [&](const auto& points) {
      ++figure.all;
      const bool beyond = std::ranges::any_of(
          points, [&](const Point3& point) { return is_beyond(volume, point); });
      figure.beyond += beyond ? 1 : 0;
    };
    for (std::uint32_t i = segment.first; i < segment.end; ++i) add(scene.points(i));
    for (const RetainedScene::Text& text : scene.texts(segment)) add(std::array{text.anchor});
    for (const KeptAnnotation& annotation : segment.annotations) add(annotation.points);
  }
  return figure;
}

}  // namespace displayfile
