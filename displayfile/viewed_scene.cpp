#include "displayfile/viewed_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "clip/error.h"
#include "displayfile/display_file.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

namespace {

void require_countable(std::size_t points) {
  if (points >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("too many points to find hidden surfaces: expected fewer than 2^32 - 1");
  }
}

/// What the item is drawn in: the last run that begins no later.
template <class Runs>
const auto& style_at(const Runs& runs, std::uint32_t item) {
  if (runs.size() == 1) return runs.front().style;
  const auto after =
      std::ranges::upper_bound(runs, item, {}, [](const auto& run) { return run.first; });
  return std::prev(after)->style;
}

}  // namespace

/// Enters the instructions of one segment.
struct ViewedScene::Collector {
  ViewedScene& scene;
  bool in_place;
  std::size_t points;                // seen so far
  std::size_t intensities_seen = 0;  // of these instructions
  FillStyle fill_style{};
  LineStyle style{};
  TextStyle of_texts{};
  std::int32_t pick_id = -1, line_pick_id = -1;
  std::span<const double> of_vertices{};  // of the polygon that follows

  void fill(const FillStyle& s) { fill_style = s; }
  void line_style(const LineStyle& s) { style = s; }
  void pick(std::int32_t id) { pick_id = id; }
  void line_pick(std::int32_t id) { line_pick_id = id; }
  void intensities(std::span<const double> values) { of_vertices = values; }
  void text_style(const TextStyle& s) { of_texts = s; }
  void text(const Point3& anchor, std::string_view characters) {
    const int segment = scene.segments_.empty() ? 0 : scene.segments_.back().name;
    scene.texts_.push_back({anchor, of_texts, style, std::string(characters), segment});
  }
  void move(const Point3& p) { take({&p, 1}); }
  void line(const Point3& p) {
    take({&p, 1});
    if (outlined()) save(points - 2, 2, Primitives::Kind::line);
  }
  /// SAVE-POLY-FOR-HSC (algorithm 9.7): collects one polygon.
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    const std::size_t first = points;
    take(vertices);
    const auto shading = std::exchange(of_vertices, {});
    const bool solid = fill_style.kind == FillStyle::Kind::solid;
    intensities_seen += shading.size();
    if (!solid && !outlined()) return;
    note_invisible_edges(first, sides);
    if (solid) {
      save_intensities(shading);
      save_shadow();
    }
    const SupportVertices support = support_vertices(vertices);
    if (vertices.size() > 3) save_support(support);
    save(first, vertices.size(), solid ? Primitives::Kind::solid : Primitives::Kind::hollow);
    if (solid && !support.edge_on) scene.add_fill(vertices);
  }

 private:
  bool outlined() const { return style.kind != LineStyle::Kind::none; }

  /// Counts the points, which are in place already, or else takes copies.
  void take(std::span<const Point3> more) {
    points += more.size();
    if (!in_place) scene.own_points_.insert(scene.own_points_.end(), more.begin(), more.end());
  }

  void note_invisible_edges(std::size_t first, std::span<const std::int32_t> sides) {
    const bool all = std::ranges::all_of(sides, [](std::int32_t s) { return s == op::line; });
    if (all) return;
    scene.edge_visible_.resize(first, 1);
    for (const std::int32_t side : sides) scene.edge_visible_.push_back(side == op::line ? 1 : 0);
  }

  /// The intensities belong to the item saved next, as the shadow and the support vertices do.
  void save_intensities(std::span<const double> shading) {
    if (shading.empty()) return;
    const std::size_t first =
        in_place ? intensities_seen - shading.size() : scene.own_intensities_.size();
    scene.first_intensity_.resize(scene.items_.size(), kNone);
    scene.first_intensity_.push_back(static_cast<std::uint32_t>(first));
    if (in_place) return;
    scene.own_intensities_.insert(scene.own_intensities_.end(), shading.begin(), shading.end());
  }
  void save_shadow() {
    if (!fill_style.shadow) return;
    if (scene.shadows_.empty() || scene.shadows_.back() != *fill_style.shadow) {
      scene.shadows_.push_back(*fill_style.shadow);
    }
    scene.shadow_.resize(scene.items_.size(), kNone);
    scene.shadow_.push_back(static_cast<std::uint32_t>(scene.shadows_.size() - 1));
  }
  void save_support(const SupportVertices& support) {
    scene.support_.resize(scene.items_.size(), {0, 1, 2});
    scene.support_.push_back(support.index);
  }

  void save(std::size_t first, std::size_t sides, Primitives::Kind kind) {
    const Item item = scene.items();
    if (kind == Primitives::Kind::solid &&
        (scene.colours_.empty() || scene.colours_.back().style != fill_style.colour)) {
      scene.colours_.push_back({item, fill_style.colour});
    }
    if (scene.lines_.empty() || scene.lines_.back().style != style) {
      scene.lines_.push_back({item, style});
    }
    scene.items_.push_back(
        {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(sides), kind});
    scene.pick_.push_back(kind == Primitives::Kind::line ? line_pick_id : pick_id);
    scene.has_lines_ |= outlined();
  }
};

ViewedScene::ViewedScene(const DisplayFile& display_file) {
  collect(display_file.visible_segments());
}

ViewedScene::ViewedScene(std::span<const Segment* const> segments) { collect(segments); }

ViewedScene::ViewedScene(std::shared_ptr<const Instructions> entered,
                         const ImageTransformation& image) {
  const bool in_place = entered->stores_z() && image.is_identity();
  collect(entered, image, in_place);
  finish(in_place);
}

void ViewedScene::collect(std::span<const Segment* const> segments) {
  std::size_t points = 0, items = 0;
  for (const Segment* segment : segments) {
    points += segment->entered()->points();
    items += segment->polygons() + segment->lines();
  }
  require_countable(points);
  const bool in_place = segments.size() == 1 && segments[0]->is_closed() &&
                        segments[0]->stores_z() && segments[0]->image.is_identity();
  items_.reserve(items);
  pick_.reserve(items);
  if (!in_place) own_points_.reserve(points);
  for (const Segment* segment : segments) {
    segments_.push_back({segment->name(), this->items()});
    collect(segment->entered(), segment->image, in_place);
  }
  finish(in_place);
}

void ViewedScene::collect(const std::shared_ptr<const Instructions>& entered,
                          const ImageTransformation& image, bool in_place) {
  require_countable(own_points_.size() + entered->points());
  sources_.push_back({entered, image, entered->codes()});
  const std::size_t items = items_.size() + entered->polygons() + entered->lines();
  items_.reserve(items);
  pick_.reserve(items);
  entered->walk_transformed(image, Collector{*this, in_place, own_points_.size()});
}

/// The arrays have their final places.
void ViewedScene::finish(bool in_place) {
  points_ = in_place ? sources_.front().instructions->stored_points() : own_points_;
  intensities_ = in_place ? sources_.front().instructions->stored_intensities() : own_intensities_;
  if (!edge_visible_.empty()) edge_visible_.resize(points_.size(), 1);
}

/// The item saved last.
void ViewedScene::add_fill(std::span<const Point3> vertices) {
  const Item item = items() - 1;
  if (fill_item_.empty() && item != fills_) {
    fill_item_.resize(fills_);
    std::iota(fill_item_.begin(), fill_item_.end(), Item{0});
  }
  if (item != fills_) fill_item_.push_back(item);
  ++fills_;
  for (const Point3& v : vertices) largest_depth_ = std::max(largest_depth_, std::abs(v.z));
}

bool ViewedScene::is_of(const DisplayFile& display_file) const {
  std::size_t k = 0;
  for (const Segment& segment : display_file.segments()) {
    if (!segment.visible) continue;
    if (k == sources_.size()) return false;
    if (k < segments_.size() && segments_[k].name != segment.name()) return false;
    const Source& source = sources_[k++];
    if (source.instructions != segment.entered() || !(source.image == segment.image) ||
        source.codes != segment.entered()->codes()) {
      return false;
    }
  }
  return k == sources_.size();
}

FillStyle ViewedScene::fill_style(Item item) const {
  if (kind(item) != Primitives::Kind::solid) return {FillStyle::Kind::hollow};
  FillStyle style{FillStyle::Kind::solid, fill_colour(item)};
  if (const FillShadow* of_item = shadow_of_item(item)) style.shadow = *of_item;
  return style;
}

const Colour& ViewedScene::fill_colour(Item item) const { return style_at(colours_, item); }

const LineStyle& ViewedScene::line_style(Item item) const { return style_at(lines_, item); }

int ViewedScene::segment_name(Item item) const {
  const auto after = std::ranges::upper_bound(segments_, item, {}, &SegmentStart::first);
  return std::prev(after)->name;
}

std::size_t ViewedScene::bytes() const {
  const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
  std::size_t characters = 0;
  for (const ViewedText& text : texts_) characters += text.characters.size();
  return characters + size(texts_) + size(own_points_) + size(edge_visible_) + size(items_) +
         size(pick_) + size(colours_) + size(lines_) + size(segments_) + size(support_) +
         size(fill_item_) + size(own_intensities_) + size(first_intensity_) + size(shadow_) +
         size(shadows_);
}

}  // namespace displayfile
