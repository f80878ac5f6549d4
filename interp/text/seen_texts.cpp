#include "interp/text/seen_texts.h"

#include <cstdint>
#include <span>

#include "interp/text/seen_points.h"

namespace displayfile {

std::vector<DeviceText> seen_texts(const ViewedScene& scene) {
  std::vector<Point3> anchors;
  for (const DeviceText& text : scene.texts()) {
    if (!text.style.always) anchors.push_back(text.anchor);
  }
  const std::vector<std::uint8_t> seen = points_seen(scene, anchors);
  std::vector<DeviceText> texts;
  auto next = seen.begin();
  for (const DeviceText& text : scene.texts()) {
    if (text.style.always || *next++ != 0) texts.push_back(text);
  }
  return texts;
}

std::vector<DeviceText> seen_texts(const DisplayFile& display_file, bool by_depth) {
  if (!display_file.has_texts()) return {};
  if (by_depth || display_file.sorted() != nullptr) {
    const SortedScene* sorted = display_file.sorted().get();
    if (sorted != nullptr && sorted->parts.size() == 1) {
      const ViewedScene& scene = *sorted->parts[0]->scene;
      if (scene.is_of(display_file)) return seen_texts(scene);
    }
    return seen_texts(ViewedScene(display_file));
  }
  std::vector<DeviceText> texts;
  for (const Segment* segment : display_file.visible_segments()) {
    if (!segment->has_texts()) continue;
    const ViewedScene scene(std::span(&segment, 1));
    const auto more = segment->sorted() != nullptr ? seen_texts(scene) : scene.texts();
    texts.insert(texts.end(), more.begin(), more.end());
  }
  return texts;
}

}  // namespace displayfile
