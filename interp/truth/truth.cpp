#include "interp/truth/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/error.h"
#include "clip/memory.h"
#include "clip/work_budget.h"
#include "interp/truth/true_picture.h"

namespace displayfile {

namespace {

/// Hands a segment's solid polygons to the picture.
struct SegmentWalk {
  TruePicture& picture;
  int segment;
  const WorkProgress& progress;
  std::size_t& done;
  std::size_t polygons;
  bool solid = true;
  std::int32_t pick_id = -1;
  std::vector<TruePoint> points{};  // of a polygon

  void fill(const FillStyle& style) { solid = style.kind == FillStyle::Kind::solid; }
  void line_style(const LineStyle&) {}
  void pick(std::int32_t id) { pick_id = id; }
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    ask_budget();
    if (solid) {
      require_finite(vertices);
      enter(vertices);
    }
    ++done;
    if (progress) progress(done, polygons);
  }

  void enter(std::span<const Point3> vertices) {
    const auto support = support_of(vertices);
    if (!support) return;
    points.resize(vertices.size());
    std::ranges::transform(vertices, points.begin(),
                           [&](const Point3& v) { return picture.point(v); });
    const auto& [p, q, r] = *support;
    picture.enter(points, {&points[p], &points[q], &points[r]}, pick_id);
  }

  void require_finite(std::span<const Point3> vertices) const {
    for (const Point3& v : vertices) {
      if (std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)) continue;
      throw Error(
          fmt::format("segment {}: a polygon with a vertex {} {} {}: expected finite numbers",
                      segment, v.x, v.y, v.z));
    }
  }
};

}  // namespace

Picture truth(const DisplayFile& display_file, int width, int height, bool depth,
              const WorkProgress& progress) {
  require_picture_size(width, height);
  const NamedWork named({"the truth", "a smaller picture, or a method that decides exactly"});
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return with_memory(
      TruePicture::kBytesOfPixel * pixels,
      [&] { return fmt::format("the truth of {} x {} pixels", width, height); },
      [&] {
        TruePicture picture(width, height);
        std::size_t done = 0, polygons = 0;
        for (const Segment& segment : display_file.segments()) {
          if (segment.visible) polygons += segment.polygons();
        }
        for (const Segment& segment : display_file.segments()) {
          if (!segment.visible) continue;
          segment.walk_entered_drawn(
              SegmentWalk{picture, segment.name(), progress, done, polygons});
        }
        return picture.take(depth);
      });
}

}  // namespace displayfile
