#include "interp/visibility/fill_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hidden/exact/support_plane.h"
#include "interp/picture.h"

namespace displayfile {

namespace {
constexpr std::uint32_t kWhite = 0xFFFFFFFF;
}

/// Enters one segment's instructions.
struct FillScene::Collector {
  FillScene& scene;
  FillStyle fill_style{};
  LineStyle style{};
  std::int32_t pick_id = -1;
  std::span<const double> of_vertices{};  // of the polygon that follows

  void fill(const FillStyle& s) { fill_style = s; }
  void line_style(const LineStyle& s) { style = s; }
  void pick(int id) { pick_id = id; }
  void intensities(std::span<const double> values) { of_vertices = values; }
  void move(const Point3&) {}
  void line(const Point3&) { scene.has_lines_ |= style.kind != LineStyle::Kind::none; }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t>) {
    scene.has_lines_ |= style.kind != LineStyle::Kind::none;
    const auto shading = std::exchange(of_vertices, {});
    if (fill_style.kind != FillStyle::Kind::solid) return;
    if (!scene.enter(vertices, pixel_of(fill_style.colour), pick_id)) return;
    if (!shading.empty()) {
      scene.shade_last({fill_style.colour, IntensityPlane(vertices, shading)});
    }
    if (fill_style.shadow) scene.shadow_last(*fill_style.shadow);
  }
};

FillScene::FillScene() : begin_{0, 0}, support_{{0, 0, 0}}, colour_{kWhite}, pick_{-1} {}

FillScene::FillScene(const DisplayFile& display_file) : FillScene() {
  sources_ = FillSources(display_file);
  for (const Segment* segment : display_file.visible_segments()) {
    segment->walk_entered_drawn(Collector{*this});
  }
}

bool FillScene::enter(std::span<const Point3> vertices, std::uint32_t colour, std::int32_t pick) {
  const SupportVertices support = support_vertices(vertices);
  if (support.edge_on) return false;
  const std::uint32_t first = begin_.back();
  vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
  for (const Point3& v : vertices) largest_depth_ = std::max(largest_depth_, std::abs(v.z));
  begin_.push_back(first + static_cast<std::uint32_t>(vertices.size()));
  const auto& [p, q, r] = support.index;
  support_.push_back({first + p, first + q, first + r});
  colour_.push_back(colour);
  pick_.push_back(pick);
  return true;
}

void FillScene::shade_last(const Shade& shade) {
  shade_.resize(pick_.size() - 1, kNone);
  shade_.push_back(static_cast<std::uint32_t>(shades_.size()));
  shades_.push_back(shade);
}

void FillScene::shadow_last(const FillShadow& shadow) {
  if (shadows_.empty() || shadows_.back() != shadow) shadows_.push_back(shadow);
  shadow_.resize(pick_.size() - 1, kNone);
  shadow_.push_back(static_cast<std::uint32_t>(shadows_.size() - 1));
}

}  // namespace displayfile
