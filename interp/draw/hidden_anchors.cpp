#include "interp/draw/hidden_anchors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ranges>
#include <span>
#include <vector>

#include "displayfile/entered/instructions.h"
#include "interp/annotation/page_annotation.h"
#include "interp/text/seen_points.h"

namespace displayfile {

namespace {

constexpr double kBehindFacets = 0.01;  // of the figure's depth

bool has_leader(const KeptAnnotation& kept) {
  return kept.kind == KeptAnnotation::Kind::leader || kept.kind == KeptAnnotation::Kind::balloon;
}

/// The distance from the scene's farthest point to its nearest one.
double depth_of(const ViewedScene& scene) {
  double nearest = -std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (ViewedScene::Item item = 0; item < scene.items(); ++item) {
    for (const Point3& p : PointRow(scene.points(item))) {
      nearest = std::max(nearest, p.z);
      farthest = std::min(farthest, p.z);
    }
  }
  return std::max(0.0, nearest - farthest);
}

void add_hidden(const ViewedScene& scene, std::vector<std::string>& names) {
  if (std::ranges::none_of(scene.annotations(), has_leader)) return;
  const double toward_eye = kBehindFacets * depth_of(scene);
  std::vector<Point3> anchors;
  std::vector<const KeptAnnotation*> theirs;
  for (const KeptAnnotation& kept : scene.annotations()) {
    if (!has_leader(kept)) continue;
    anchors.push_back(kept.points[0] + Point3(0.0, 0.0, toward_eye));
    theirs.push_back(&kept);
  }
  const std::vector<std::uint8_t> seen = points_seen(scene, anchors);
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    if (seen[k] == 0) names.push_back(name_in_message(*theirs[k]));
  }
}

std::optional<std::string> sentence_on(std::span<const std::string> names) {
  if (names.empty()) return std::nullopt;
  return fmt::format(
      "annotation points at what is hidden, as if it were seen: {}: expected points that are seen, "
      "or another view",
      fmt::join(names, ", "));
}

}  // namespace

std::optional<std::string> hidden_anchors(const ViewedScene& scene) {
  std::vector<std::string> names;
  add_hidden(scene, names);
  return sentence_on(names);
}

std::optional<std::string> hidden_anchors(const DisplayFile& display_file, bool by_depth) {
  const auto has_leaders = [](const Segment* segment) {
    return std::ranges::any_of(segment->entered()->annotations(), has_leader);
  };
  const auto segments = display_file.visible_segments();
  if (std::ranges::none_of(segments, has_leaders)) return std::nullopt;
  if (by_depth || display_file.sorted() != nullptr) {
    return hidden_anchors(ViewedScene(display_file));
  }
  std::vector<std::string> names;
  for (const Segment* const segment : segments) {
    if (segment->sorted() == nullptr || !has_leaders(segment)) continue;
    add_hidden(ViewedScene(std::span(&segment, 1)), names);
  }
  return sentence_on(names);
}

}  // namespace displayfile
