#include "interp/truth/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/memory.h"
#include "clip/base/work_budget.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/primitives.h"
#include "interp/truth/true_picture.h"

namespace displayfile {

namespace {

/// The planes that polygons share with others as entered, for the solid polygons in order.
class SharedPlanes {
 public:
  explicit SharedPlanes(const DisplayFile& display_file) : scene_(display_file) {}

  /// Three points of the next polygon's plane; none if it shares none.
  std::optional<std::array<Point3, 3>> next() {
    while (scene_.kind(item_) != Primitives::Kind::solid) ++item_;
    const Primitives::PlanePoints* const plane = scene_.shared_plane(item_++);
    if (plane == nullptr) return std::nullopt;
    const auto points = scene_.primitives().points;
    return std::array{points[(*plane)[0]], points[(*plane)[1]], points[(*plane)[2]]};
  }

 private:
  ViewedScene scene_;
  ViewedScene::Item item_ = 0;
};

/// Passes a segment's solid polygons to the picture.
struct SegmentWalk {
  TruePicture& picture;
  SharedPlanes& shared;
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
      enter(vertices, shared.next());
    }
    ++done;
    if (progress) progress(done, polygons);
  }

  void enter(std::span<const Point3> vertices, const std::optional<std::array<Point3, 3>>& plane) {
    const auto support = support_of(vertices);
    if (!support) return;
    points.resize(vertices.size());
    std::ranges::transform(vertices, points.begin(),
                           [&](const Point3& v) { return picture.point(v); });
    if (plane) {
      const auto& [p, q, r] = *plane;
      const TruePoint on_p = picture.point(p), on_q = picture.point(q), on_r = picture.point(r);
      return picture.enter(points, {&on_p, &on_q, &on_r}, pick_id);
    }
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
              const WorkProgress& progress, DepthTies* ties) {
  require_picture_size(width, height);
  const NamedWork named({"the truth", "a smaller picture, or a method that decides exactly"});
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return with_memory(
      TruePicture::kBytesOfPixel * pixels,
      [&] { return fmt::format("the truth of {} x {} pixels", width, height); },
      [&] {
        TruePicture picture(width, height, ties);
        SharedPlanes shared(display_file);
        std::size_t done = 0, polygons = 0;
        for (const Segment& segment : display_file.segments()) {
          if (segment.visible) polygons += segment.polygons();
        }
        for (const Segment& segment : display_file.segments()) {
          if (!segment.visible) continue;
          segment.walk_entered_drawn(
              SegmentWalk{picture, shared, segment.name(), progress, done, polygons});
        }
        return picture.take(depth);
      });
}

}  // namespace displayfile
