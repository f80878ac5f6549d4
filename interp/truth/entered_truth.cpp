#include "interp/truth/entered_truth.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "displayfile/entered/entered_polygons.h"
#include "interp/truth/exact_projection.h"
#include "interp/truth/retained_picture.h"
#include "interp/truth/true_planes.h"

namespace displayfile {

namespace {

/// Enters the polygons of one segment into the picture.
class SegmentAsEntered {
 public:
  SegmentAsEntered(const RetainedScene& retained, const TruePlanes& planes, ExactProjection view,
                   TruePicture& picture)
      : retained_(retained), planes_(planes), exact_(std::move(view)), picture_(picture) {}

  void enter(std::uint32_t primitive);

 private:
  using Support = std::array<TruePoint, 3>;
  std::optional<Support> support_of(std::uint32_t primitive) const;

  const RetainedScene& retained_;
  const TruePlanes& planes_;
  ExactProjection exact_;
  TruePicture& picture_;
  std::vector<ExactProjection::Vertex> viewed_;  // of the polygon on its way
  std::vector<TruePoint> points_;
};

void SegmentAsEntered::enter(std::uint32_t primitive) {
  viewed_.clear();
  for (std::size_t k = 0; k < retained_[primitive].sides; ++k) {
    viewed_.push_back(exact_.viewed(planes_.vertex(primitive, k)));
  }
  exact_.clip(viewed_);
  if (viewed_.empty()) return;
  // An image transformation may turn polygons over: that does not count.
  if (retained_.shared_attributes(primitive).back_face_removal &&
      !ExactProjection::faces_viewer(viewed_))
    return;
  std::optional<Support> support = support_of(planes_.plane_of(primitive));
  if (!support) support = support_of(primitive);
  if (!support) return;
  points_.clear();
  for (const ExactProjection::Vertex& v : viewed_) points_.push_back(exact_.in_picture(v));
  const auto& [p, q, r] = *support;
  picture_.enter(points_, {&p, &q, &r}, retained_[primitive].pick);
}

/// The support in the picture; none if the polygon has no plane, or is seen edge-on.
std::optional<SegmentAsEntered::Support> SegmentAsEntered::support_of(
    std::uint32_t primitive) const {
  const auto plane = planes_.own_plane(primitive);
  if (!plane) return std::nullopt;
  const auto seen = [&](const WholePoint& p) { return exact_.in_picture(exact_.viewed(p)); };
  const auto& [p, q, r] = *plane;
  Support support{seen(p), seen(q), seen(r)};
  if (ExactDepth(support[0], support[1], support[2]).edge_on()) return std::nullopt;
  return support;
}

}  // namespace

EnteredTruth entered_truth(const RetainedScene& retained, const DisplayFile& display_file,
                           int width, int height, bool depth,
                           const std::optional<Touching>& touching, const WorkProgress& progress,
                           DepthTies* ties) {
  require_picture_size(width, height);
  const NamedWork named({"the truth from what was entered", "a smaller picture"});
  const RetainedScene visible = retained.visible_in(display_file);
  const TruePlanes planes(visible, touching);
  const auto view_of = [&](const RetainedScene::Segment& part, const Segment& segment,
                           TruePicture& picture) {
    return SegmentAsEntered(visible, planes,
                            ExactProjection(part.view, segment.image, width, height), picture);
  };
  return {retained_picture(visible, display_file, width, height, depth, progress, view_of, ties),
          planes.touching()};
}

namespace {

/// Enters a segment's polygons, with their entered data, into a retained scene.
struct PolygonsRetained {
  const EnteredPolygons& kept;
  RetainedScene& scene;
  Attributes attributes{};
  std::int32_t pick_id = -1;
  std::uint32_t next = 0;
  std::span<const std::uint32_t> not_seen = kept.not_seen();  // from there on

  void fill(const FillStyle& style) { attributes.fill = style; }
  void line_style(const LineStyle&) {}
  void pick(int id) { pick_id = id; }
  void move(const Point3&) {}
  void line(const Point3&) {}
  void polygon(std::span<const Point3>, std::span<const std::int32_t>) {
    enter_not_seen();
    enter(next++, attributes, pick_id);
  }
  /// Enters the invisible ones before the next instruction's: others may lie in their planes.
  void enter_not_seen() {
    Attributes hollow;
    hollow.fill.kind = FillStyle::Kind::hollow;
    for (; !not_seen.empty() && not_seen.front() == next; not_seen = not_seen.subspan(1)) {
      enter(next++, hollow, -1);
    }
  }

 private:
  void enter(std::uint32_t number, const Attributes& as, std::int32_t pick) {
    const PointRow entered = kept.points(number);
    const glm::dmat4x3* const modelling = kept.modelling(number);
    std::vector<Point3> world(entered.begin(), entered.end());
    if (modelling != nullptr) {
      for (Point3& p : world) p = Point3(*modelling * glm::dvec4(p, 1.0));
    }
    const std::span<const Point3> as_entered(entered.data(), entered.size());
    scene.enter_polygon({world, {}, Point3(0.0), {}, pick, as_entered, modelling}, as);
  }
};

/// The entered primitives that the visible segments keep; none if one of them keeps none.
std::optional<RetainedScene> scene_as_entered(const DisplayFile& display_file) {
  RetainedScene scene;
  for (const Segment* segment : display_file.visible_segments()) {
    const EnteredPolygons* const kept = segment->entered()->as_entered();
    if (kept == nullptr) return std::nullopt;
    scene.open_segment(segment->name(), kept->volume().view(), kept->touching());
    PolygonsRetained polygons{*kept, scene};
    segment->entered()->walk(polygons);
    polygons.enter_not_seen();
    scene.close_segment({});
  }
  return scene;
}

}  // namespace

Picture truth_as_entered(const DisplayFile& display_file, int width, int height, bool depth,
                         const WorkProgress& progress, DepthTies* ties) {
  const std::optional<RetainedScene> scene = scene_as_entered(display_file);
  if (!scene) return truth(display_file, width, height, depth, progress, ties);
  return entered_truth(*scene, display_file, width, height, depth, std::nullopt, progress, ties)
      .picture;
}

}  // namespace displayfile
