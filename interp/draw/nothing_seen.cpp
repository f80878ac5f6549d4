#include "interp/draw/nothing_seen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/base/round_to_nearest.h"
#include "clip/geometry/back_face.h"
#include "clip/geometry/bounds.h"
#include "clip/pipeline/clip_pipeline.h"
#include "clip/view/transformation.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/segments/polygon_stage.h"
#include "hidden/exact/support_plane.h"
#include "interp/scan/scan_convert.h"

namespace displayfile {

namespace {

enum class Reason {
  eye,
  front,
  back,
  left,
  right,
  bottom,
  top,
  corner,
  turned_away,
  style,
  sides,
  edge_on,
  small,
  moved
};
constexpr std::array<std::string_view, 14> kWords{
    "behind the eye",
    "before the front plane",
    "behind the back plane",
    "to the left of the window",
    "to the right of the window",
    "below the window",
    "above the window",
    "outside of the view volume",
    "turned away, as back faces are removed",
    "hollow, with no line style",
    "hollow, with no side that is drawn in the view volume",
    "seen edge-on, with no line style",
    "smaller or thinner than a pixel, over no sample of a pixel",
    "moved out of the picture by image transformations",
};
using Counts = std::array<std::size_t, kWords.size()>;

constexpr std::array kPlanes{
    std::pair{ClipPlane::front, Reason::front},   std::pair{ClipPlane::back, Reason::back},
    std::pair{ClipPlane::left, Reason::left},     std::pair{ClipPlane::right, Reason::right},
    std::pair{ClipPlane::bottom, Reason::bottom}, std::pair{ClipPlane::top, Reason::top}};

/// True if all vertices lie on one line, up to the rounding of their coordinates.
bool is_edge_on(std::span<const Point3> vertices) {
  constexpr double kRounding = 1e-12;
  const auto [p, q, r] = support_vertices(vertices).index;
  const std::array farthest{vertices[p], vertices[q], vertices[r]};
  Bounds bounds;
  for (const Point3& point : farthest) bounds.include(point);
  const double size = std::max(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y);
  return std::abs(newell_c(farthest)) <= kRounding * size * size;
}

/// Tests the visibility of primitives in device coordinates, after the image transformation.
class Shown {
 public:
  explicit Shown(const SeenIn& in) : pixels_(in.pixels) {}

  /// The reason why a polygon or a line is invisible; none if part of it is visible.
  std::optional<Reason> why_not(std::span<const Point3> points, bool is_filled, bool has_lines) {
    if (is_off_picture(points)) return Reason::moved;
    if (has_lines) return std::nullopt;
    if (!is_filled) return Reason::sides;
    if (pixels_ && covers_centre(points)) return std::nullopt;
    if (is_edge_on(points)) return Reason::edge_on;
    return pixels_ ? std::optional(Reason::small) : std::nullopt;
  }

 private:
  static bool is_off_picture(std::span<const Point3> points) {
    Bounds bounds;
    for (const Point3& p : points) bounds.include(p);
    return bounds.high.x < 0.0 || bounds.low.x > 1.0 || bounds.high.y < 0.0 || bounds.low.y > 1.0;
  }
  bool covers_centre(std::span<const Point3> points) {
    bool covers = false;
    converter_.scan_convert(points, {*pixels_, 0, pixels_->height},
                            [&](int, int first, int end) { covers = covers || first < end; });
    return covers;
  }

  std::optional<PictureSize> pixels_;
  ScanConverter converter_;
};

std::vector<Point3> transformed(std::span<const Point3> points, const ImageTransformation& image) {
  std::vector<Point3> moved(points.begin(), points.end());
  if (image.is_identity()) return moved;
  const ImageMatrix matrix(image);
  for (Point3& p : moved) p = matrix.apply(p);
  return moved;
}

// ---- A display file ----------------------------------------------------------------------

/// Looks at the polygons and lines of a segment's instructions, after the image transformation:
/// each that is not hollow without a line style, as a viewed scene has them.
template <class OnItem>
class StoredItems {
 public:
  /// Calls on_item(why not), as Shown::why_not has it, until it returns false.
  StoredItems(Shown& shown, const OnItem& on_item) : shown_(shown), on_item_(on_item) {}

  void fill(const FillStyle& style) { is_filled_ = style.kind == FillStyle::Kind::solid; }
  void line_style(const LineStyle& style) { is_outlined_ = style.kind != LineStyle::Kind::none; }
  void pick(std::int32_t) {}
  void side_kinds(std::span<const LineKinds> kinds) { kinds_ = kinds; }
  void move(const Point3& p) { pen_ = p; }
  void line(const Point3& p) {
    const std::array ends{std::exchange(pen_, p), p};
    if (is_wanted_ && is_outlined_) is_wanted_ = on_item_(shown_.why_not(ends, false, true));
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    pen_ = vertices.back();
    const auto kinds = std::exchange(kinds_, {});
    if (!is_wanted_ || !(is_filled_ || is_outlined_)) return;
    const bool is_drawn =
        kinds.empty() ? std::ranges::any_of(sides, [](auto side) { return side == op::line; })
                      : std::ranges::any_of(kinds, [](LineKinds of_side) { return of_side != 0; });
    is_wanted_ = on_item_(shown_.why_not(vertices, is_filled_, is_outlined_ && is_drawn));
  }

 private:
  Shown& shown_;
  const OnItem& on_item_;
  bool is_filled_ = true, is_outlined_ = true, is_wanted_ = true;
  Point3 pen_{};
  std::span<const LineKinds> kinds_{};
};

template <class OnItem>
void visit_items(const Segment& segment, Shown& shown, const OnItem& on_item) {
  segment.entered()->walk_transformed(segment.image, StoredItems<OnItem>(shown, on_item));
}

bool shows(const Segment& segment, Shown& shown) {
  if (!segment.visible) return false;
  if (segment.has_texts() || segment.has_annotations()) return true;
  if (!segment.shows()) return false;
  bool is_seen = false;
  visit_items(segment, shown, [&](std::optional<Reason> why_not) {
    is_seen = !why_not;
    return !is_seen;
  });
  return is_seen;
}

// ---- A retained scene --------------------------------------------------------------------

/// A segment in the view in which it is seen.
struct SegmentSeen {
  const RetainedScene& scene;
  PolygonStage stage;
  ImageTransformation image;
  Shown& shown;
};

std::optional<Reason> why_not(SegmentSeen& at, std::uint32_t i) {
  const RetainedScene& scene = at.scene;
  if (!scene.draws(i)) return Reason::style;
  if (scene[i].is_line()) {
    std::array<Point3, 2> ends;
    const PointRow line = scene.points(i);
    if (!at.stage.pipeline().clip_line(line[0], line[1], ends[0], ends[1])) return Reason::corner;
    return at.shown.why_not(transformed(ends, at.image), false, true);
  }
  const Attributes& attributes = scene.shared_attributes(i);
  const StagedPolygon viewed = at.stage.view_polygon(scene.polygon(i), attributes);
  const ClippedPolygon& polygon = viewed.polygon;
  if (polygon.vertices.empty()) return Reason::corner;
  const bool has_lines =
      attributes.is_outlined() &&
      std::ranges::any_of(polygon.edge_visible, [](LineKinds kinds) { return kinds != 0; });
  return at.shown.why_not(transformed(polygon.vertices, at.image),
                          attributes.fill.kind == FillStyle::Kind::solid, has_lines);
}

/// The same, and for a primitive that is in no view, its position relative to the view volume.
Reason reason_of(SegmentSeen& at, std::uint32_t i) {
  const RetainedScene& scene = at.scene;
  ClipPipeline& pipeline = at.stage.pipeline();
  Outcode all = ~0u;
  bool behind_eye = true;
  for (const Point3& p : scene.points(i)) {
    const HomogeneousPoint in_volume = pipeline.volume().transform(p);
    all &= pipeline.volume().outcode(in_volume);
    behind_eye = behind_eye && !(in_volume.w > 0.0);
  }
  const bool before_front = (all & bit_of(ClipPlane::front)) != 0;
  const bool before_eye = (all & bit_of(ClipPlane::eye)) != 0;
  if (behind_eye || (before_eye && !before_front)) return Reason::eye;
  for (const auto& [plane, reason] : kPlanes) {
    if ((all & bit_of(plane)) != 0) return reason;
  }
  if (!scene.draws(i)) return Reason::style;
  if (!scene[i].is_line()) {
    const ClippedPolygon clipped = pipeline.clip_polygon(scene.points(i));
    const bool removed = clipped.vertices.size() >= 3 &&
                         scene.shared_attributes(i).back_face_removal &&
                         is_back_face(clipped.vertices);
    if (removed) return is_edge_on(clipped.vertices) ? Reason::edge_on : Reason::turned_away;
  }
  return why_not(at, i).value_or(Reason::corner);
}

View view_of(const RetainedScene::Segment& segment, const SeenIn& in) {
  return in.view.value_or(segment.view);
}

// ---- In words ----------------------------------------------------------------------------

constexpr std::string_view kEntered, kInView = " in the view volume";

std::string in_words(const Counts& counts, std::size_t all, std::string_view which) {
  const auto whole = std::ranges::find(counts, all);
  if (whole != counts.end()) {
    const std::string_view words = kWords[static_cast<std::size_t>(whole - counts.begin())];
    return all == 1 ? fmt::format("the only polygon or line{} is {}", which, words)
                    : fmt::format("all {} polygons and lines{} are {}", all, which, words);
  }
  std::string text;
  for (std::size_t r = 0; r < counts.size(); ++r) {
    if (counts[r] == 0) continue;
    text += text.empty() ? fmt::format("of {} polygons and lines{} ", all, which) : ", ";
    text += fmt::format("{} {} {}", counts[r], counts[r] == 1 ? "is" : "are", kWords[r]);
  }
  return text;
}

}  // namespace

SeenIn seen_in(const PicturePlan& plan) {
  if (plan.kind() == PictureKind::vector) return {};
  const auto& [width, height] = std::tie(plan.options.width, plan.options.height);
  return {.pixels = PictureSize{width * plan.samples, height * plan.samples}};
}

bool nothing_is_seen(const DisplayFile& display_file, const SeenIn& in) {
  const RoundToNearest nearest;
  Shown shown(in);
  return std::ranges::none_of(display_file.segments(),
                              [&](const Segment& segment) { return shows(segment, shown); });
}

bool nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file,
                     const SeenIn& in) {
  const RoundToNearest nearest;
  Shown shown(in);
  for (const RetainedScene::Segment& segment : scene.segments()) {
    const Segment& now = display_file.segment(segment.name);
    if (!now.visible) continue;
    SegmentSeen at{scene, PolygonStage(ViewVolume(view_of(segment, in))), now.image, shown};
    for (std::uint32_t i = segment.first; i < segment.end; ++i) {
      if (!why_not(at, i)) return false;
    }
    for (const RetainedScene::Text& text : scene.texts(segment)) {
      if (at.stage.pipeline().view(text.anchor).outcode == 0) return false;
    }
    for (const KeptAnnotation& annotation : segment.annotations) {
      if (viewed(annotation, at.stage.pipeline().volume())) return false;
    }
  }
  return true;
}

std::string why_nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file,
                                const SeenIn& in) {
  const RoundToNearest nearest;
  if (scene.size() == 0) {
    const bool texts = std::ranges::any_of(
        scene.segments(), [&](const auto& segment) { return !scene.texts(segment).empty(); });
    return texts ? "no polygon or line was entered, and no text is in the view volume"
                 : "no polygon or line was entered";
  }
  Shown shown(in);
  Counts counts{};
  std::size_t all = 0;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    const Segment& now = display_file.segment(segment.name);
    if (!now.visible) continue;
    SegmentSeen at{scene, PolygonStage(ViewVolume(view_of(segment, in))), now.image, shown};
    for (std::uint32_t i = segment.first; i < segment.end; ++i, ++all) {
      ++counts[static_cast<std::size_t>(reason_of(at, i))];
    }
  }
  return all == 0 ? "what was entered is in segments that are not visible"
                  : in_words(counts, all, kEntered);
}

std::string why_nothing_is_seen(const DisplayFile& display_file, const SeenIn& in) {
  const RoundToNearest nearest;
  if (display_file.segments().empty()) return "no polygon or line was entered";
  Shown shown(in);
  Counts counts{};
  std::size_t all = 0, stored = 0;
  for (const Segment& segment : display_file.segments()) {
    const std::size_t own = segment.polygons() + segment.lines();
    stored += own;
    if (!segment.visible || own == 0) continue;
    all += own;
    std::size_t items = 0;
    visit_items(segment, shown, [&](std::optional<Reason> why_not) {
      ++counts[static_cast<std::size_t>(why_not.value_or(Reason::corner))];
      ++items;
      return true;
    });
    counts[static_cast<std::size_t>(Reason::style)] += own - items;
  }
  if (all > 0) return in_words(counts, all, kInView);
  return stored > 0 ? "what was entered is in segments that are not visible"
                    : "nothing that was entered is inside of the view volume and turned to the "
                      "viewer";
}

}  // namespace displayfile
