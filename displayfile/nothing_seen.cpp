#include "displayfile/nothing_seen.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "clip/back_face.h"
#include "clip/clip_pipeline.h"

namespace displayfile {

namespace {

enum class Reason { eye, front, back, left, right, bottom, top, corner, turned_away, style };
constexpr std::array<std::string_view, 10> kWords{
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
};

constexpr std::array kPlanes{
    std::pair{ClipPlane::front, Reason::front},   std::pair{ClipPlane::back, Reason::back},
    std::pair{ClipPlane::left, Reason::left},     std::pair{ClipPlane::right, Reason::right},
    std::pair{ClipPlane::bottom, Reason::bottom}, std::pair{ClipPlane::top, Reason::top}};

/// Why nothing was entered of a primitive, or nothing is drawn of it.
Reason reason_of(const RetainedScene& scene, std::uint32_t i, ClipPipeline& pipeline) {
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
  if (scene[i].is_line()) return Reason::corner;
  const ClippedPolygon clipped = pipeline.clip_polygon(scene.points(i));
  const bool back_face = clipped.vertices.size() >= 3 && is_back_face(clipped.vertices);
  return back_face && scene.shared_attributes(i).back_face_removal ? Reason::turned_away
                                                                   : Reason::corner;
}

std::string in_words(const std::array<std::size_t, kWords.size()>& counts, std::size_t all) {
  const auto whole = std::ranges::find(counts, all);
  if (whole != counts.end()) {
    const std::string_view words = kWords[static_cast<std::size_t>(whole - counts.begin())];
    return all == 1 ? fmt::format("the only polygon or line is {}", words)
                    : fmt::format("all {} polygons and lines are {}", all, words);
  }
  std::string text;
  for (std::size_t r = 0; r < counts.size(); ++r) {
    if (counts[r] == 0) continue;
    text += fmt::format("{}{} {} {}",
                        text.empty() ? fmt::format("of {} polygons and lines ", all) : ", ",
                        counts[r], counts[r] == 1 ? "is" : "are", kWords[r]);
  }
  return text;
}

}  // namespace

bool nothing_is_seen(const DisplayFile& display_file) {
  return std::ranges::none_of(display_file.segments(), [](const Segment& segment) {
    return segment.visible && segment.shows();
  });
}

bool nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file) {
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!display_file.segment(segment.name).visible) continue;
    ViewStage stage{ViewVolume(segment.view)};
    Point3 a, b;
    for (std::uint32_t i = segment.first; i < segment.end; ++i) {
      if (!scene.draws(i)) continue;
      const bool is_in_view =
          scene[i].is_line()
              ? stage.pipeline().clip_line(scene.points(i)[0], scene.points(i)[1], a, b)
              : !stage.view_polygon(scene.polygon(i), scene.shared_attributes(i))
                     .polygon.vertices.empty();
      if (is_in_view) return false;
    }
    for (const RetainedScene::Text& text : scene.texts(segment)) {
      if (stage.pipeline().view(text.anchor).outcode == 0) return false;
    }
  }
  return true;
}

std::string why_nothing_is_seen(const RetainedScene& scene, const DisplayFile& display_file) {
  if (scene.size() == 0) {
    const bool texts = std::ranges::any_of(
        scene.segments(), [&](const auto& segment) { return !scene.texts(segment).empty(); });
    return texts ? "no polygon or line was entered, and no text is in the view volume"
                 : "no polygon or line was entered";
  }
  std::array<std::size_t, kWords.size()> counts{};
  std::size_t all = 0;
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!display_file.segment(segment.name).visible) continue;
    ClipPipeline pipeline{ViewVolume(segment.view)};
    for (std::uint32_t i = segment.first; i < segment.end; ++i, ++all) {
      ++counts[static_cast<std::size_t>(reason_of(scene, i, pipeline))];
    }
  }
  return all == 0 ? "what was entered is in segments that are not visible" : in_words(counts, all);
}

}  // namespace displayfile
