#include "interp/truth/world_truth.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "clip/pipeline/clip_pipeline.h"
#include "clip/view/transformation.h"
#include "interp/truth/exact_projection.h"
#include "interp/truth/retained_picture.h"
#include "interp/truth/true_picture.h"

namespace displayfile {

namespace {

using Indices = std::array<std::size_t, 3>;

/// The definition's choice of support vertices with unrounded distances, in device coordinates of a
/// picture of that size. The first vertex is at p.
Indices exact_support_of(std::span<const TruePoint> polygon, int width, int height) {
  struct Place {
    Rational x, y;
  };
  std::vector<Place> from_p;
  for (const TruePoint& v : polygon) {
    from_p.push_back({ratio(v.x, v.w * width), ratio(v.y, v.w * height)});
  }
  const Place p = from_p[0];
  for (Place& v : from_p) v = {v.x - p.x, v.y - p.y};
  const auto farthest = [&](auto&& value) {
    std::size_t best = 0;
    Rational largest = 0;
    for (std::size_t i = 1; i < from_p.size(); ++i) {
      const Rational here = value(from_p[i]);
      if (here <= largest) continue;
      largest = here;
      best = i;
    }
    return best;
  };
  const std::size_t q = farthest([](const Place& v) -> Rational { return v.x * v.x + v.y * v.y; });
  const std::size_t r = farthest(
      [&](const Place& v) -> Rational { return abs(from_p[q].x * v.y - from_p[q].y * v.x); });
  return {0, q, r};
}

/// Enters the polygons of one segment into the picture.
class SegmentPolygons {
 public:
  SegmentPolygons(const RetainedScene& retained, const View& view, const ImageTransformation& image,
                  int width, int height, TruePicture& picture)
      : retained_(retained),
        exact_(view, image, width, height),
        width_(width),
        height_(height),
        pipeline_(ViewVolume(view)),
        image_(image),
        is_moved_(!image.is_identity()),
        picture_(picture) {}

  void enter(std::uint32_t primitive);

 private:
  std::optional<Indices> support_in_display_file(std::span<const Point3> world);

  const RetainedScene& retained_;
  ExactProjection exact_;
  int width_, height_;
  ClipPipeline pipeline_;
  ImageMatrix image_;
  bool is_moved_;
  TruePicture& picture_;
  // The polygon on its way:
  std::vector<ExactProjection::Vertex> viewed_;
  std::vector<TruePoint> whole_, points_;
  std::vector<Point3> device_;
};

void SegmentPolygons::enter(std::uint32_t primitive) {
  const PointRow world = retained_.points(primitive);
  viewed_.clear();
  for (const Point3& p : world) viewed_.push_back(exact_.viewed(whole(p)));
  const bool is_triangle = viewed_.size() == 3;
  const auto in_picture = [&](std::vector<TruePoint>& points) {
    points.clear();
    for (const ExactProjection::Vertex& v : viewed_) points.push_back(exact_.in_picture(v));
  };
  if (is_triangle) in_picture(whole_);
  exact_.clip(viewed_);
  if (viewed_.empty()) return;
  in_picture(points_);
  // An image transformation may turn polygons over: that does not count.
  if (retained_.shared_attributes(primitive).back_face_removal &&
      !ExactProjection::faces_viewer(viewed_))
    return;
  const std::int32_t pick = retained_[primitive].pick;
  // All that clipping leaves of a triangle is in its plane.
  if (is_triangle) return picture_.enter(points_, {whole_.data(), &whole_[1], &whole_[2]}, pick);
  std::optional<Indices> support = support_in_display_file(world);
  if (!support) support = exact_support_of(points_, width_, height_);
  const auto& [p, q, r] = *support;
  picture_.enter(points_, {&points_[p], &points_[q], &points_[r]}, pick);
}

/// The vertices that the definition chooses from the display file's form of the polygon. None if it
/// has no such form, is edge-on there, or has other vertices: rounding decided the clipping.
std::optional<Indices> SegmentPolygons::support_in_display_file(std::span<const Point3> world) {
  const auto clipped = pipeline_.clip_polygon(world).vertices;
  if (clipped.size() != points_.size()) return std::nullopt;
  device_.assign(clipped.begin(), clipped.end());
  if (is_moved_) {
    for (Point3& p : device_) p = image_.apply(p);
  }
  return support_of(device_);
}

}  // namespace

Picture world_truth(const RetainedScene& retained, const DisplayFile& display_file, int width,
                    int height, bool depth, const WorkProgress& progress) {
  require_picture_size(width, height);
  const NamedWork named({"the truth from world coordinates", "a smaller picture"});
  const auto view_of = [&](const RetainedScene::Segment& part, const Segment& segment,
                           TruePicture& picture) {
    return SegmentPolygons(retained, part.view, segment.image, width, height, picture);
  };
  return retained_picture(retained, display_file, width, height, depth, progress, view_of);
}

std::size_t different_pixels(const Picture& a, const Picture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.ids.size(); ++i) count += a.ids[i] != b.ids[i] ? 1 : 0;
  return count;
}

}  // namespace displayfile
