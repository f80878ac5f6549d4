#include "displayfile/views/scene_viewer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "clip/base/parallel.h"
#include "clip/geometry/equal_points.h"
#include "clip/view/view_volume.h"
#include "displayfile/segments/polygon_stage.h"
#include "displayfile/views/scene_viewer_part.h"

namespace displayfile {

namespace {

constexpr std::uint32_t kPrimitivesOfAPart = 8192;
constexpr std::uint32_t kPointsOfABlock = 8192;

/// A number that no scene has had for its geometry or its palette.
std::uint64_t new_number() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

bool is_solid(const Attributes& attributes) {
  return attributes.fill.kind == FillStyle::Kind::solid;
}

}  // namespace

SceneViewer::SceneViewer(const RetainedScene& scene, const DisplayFile& attributes)
    : taken_(scene, attributes) {
  bring_up_to_date();
}

bool SceneViewer::bring_up_to_date() {
  if (scene_ != &taken_.scene()) leave_what_was_entered();
  scene_ = &taken_.scene();
  attributes_ = &taken_.attributes();
  if (taken_.has_same_scene()) {
    if (scene_->has_shared()) points_ = scene_->primitives({}).points;  // room was made for more
    return false;
  }
  take_up_scene();
  taken_.take();
  return true;
}

/// Rebuilds all cached data.
void SceneViewer::take_up_scene() {
  const RetainedScene& scene = *scene_;
  const Primitives all = scene.primitives({});
  palette_ = new_number();
  viewed_ = {};
  last_.reset();
  welded_.clear();
  sides_.clear();
  looks_.clear();
  segments_.clear();
  blocks_.clear();
  parts_.clear();
  shows_shadows_ = shows_lines_ = is_lit_ = false;
  begin_entered();
  corners_ = all.all_corners();
  selects_lines_ = scene.selects_lines();
  all_edges_drawn_ = !selects_lines_ && std::ranges::find(all.visible, 0) == all.visible.end();
  if (scene.has_shared()) {
    points_ = all.points;
    viewed_.corners_.assign(all.corners.begin(), all.corners.end());
    for (const RetainedScene::Segment& segment : scene.segments()) {
      segments_.push_back({segment.first_point, segment.end_point});
    }
  } else {
    share_equal_vertices();
  }
  const auto segments = static_cast<std::uint32_t>(scene.segments().size());
  for (std::uint32_t k = 0; k < segments; ++k) {
    const RetainedScene::Segment& segment = scene.segments()[k];
    for_each_run(segments_[k].first_point, segments_[k].end_point, kPointsOfABlock,
                 [&](std::uint32_t first, std::uint32_t end) {
                   blocks_.push_back({k, first, end, 0.0});
                 });
    for_each_run(segment.first, segment.end, kPrimitivesOfAPart,
                 [&](std::uint32_t first, std::uint32_t end) {
                   parts_.push_back(std::make_unique<Part>(k, first, end));
                 });
  }
  for (const Attributes& look : scene.all_attributes()) {
    looks_.push_back(look_of(look));
    shows_shadows_ = shows_shadows_ || look.shadows;
    is_lit_ = is_lit_ || look.light;
  }
  for (std::uint32_t i = 0; i < scene.size(); ++i) {
    if (scene[i].is_line() || scene.shared_attributes(i).is_outlined()) shows_lines_ = true;
  }
  for (const RetainedScene::Segment& segment : scene.segments()) {
    if (!scene.texts(segment).empty() || !segment.annotations.empty()) shows_lines_ = true;
  }
  for (const auto& part : parts_) part->find_rows(*this);
}

SceneViewer::Look SceneViewer::look_of(const Attributes& attributes) {
  const bool lit = attributes.light.has_value();
  const bool outlined = attributes.is_outlined();
  return {.is_nothing = !is_solid(attributes) && !outlined,
          .is_plain = is_solid(attributes) && !outlined && !(lit && attributes.shadows),
          .is_lit = lit,
          .removes_back_faces = attributes.back_face_removal};
}

SceneViewer::~SceneViewer() = default;
SceneViewer::SceneViewer(SceneViewer&&) noexcept = default;
SceneViewer& SceneViewer::operator=(SceneViewer&&) noexcept = default;

/// Merges equal vertices; segments share none with each other.
void SceneViewer::share_equal_vertices() {
  const std::span<const Point3> points = scene_->primitives({}).points;
  EqualPoints equal(welded_, points.size());
  viewed_.corners_.reserve(points.size());
  for (const RetainedScene::Segment& segment : scene_->segments()) {
    equal.forget();
    const auto first = static_cast<std::uint32_t>(welded_.size());
    for (const Point3& p : scene_->points(segment)) viewed_.corners_.push_back(equal.number_of(p));
    segments_.push_back({first, static_cast<std::uint32_t>(welded_.size())});
  }
  welded_.shrink_to_fit();
  points_ = welded_;
}

/// True if the segments have the same visibility and image transformation as in the last view.
/// Shared planes are those of visible polygons: if others are visible now, planes are found again.
bool SceneViewer::take_segments() {
  bool same = true, shows_same = true;
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    const Segment& now = attributes_->segment(scene_->segments()[k].name);
    shows_same = shows_same && segments_[k].visible == now.visible;
    same = same && shows_same && segments_[k].image == now.image;
    segments_[k].visible = now.visible;
    segments_[k].image = now.image;
  }
  if (!shows_same) {
    leave_what_was_entered();
    begin_entered();
  }
  return same;
}

bool SceneViewer::has_images() const {
  return std::ranges::any_of(segments_, [](const SegmentNow& segment) {
    return segment.visible && !segment.image.is_identity();
  });
}

const ViewedScene& SceneViewer::view(const Wanted& wanted) {
  const ViewVolume volume(wanted.view);
  bring_up_to_date();
  const auto last = std::exchange(last_, std::nullopt);
  const bool same_segments = take_segments();
  if (!same_segments || !last || !(last->view == wanted.view) ||
      last->centres_of != wanted.centres_of) {
    view_points(wanted, volume);
    if (selects_lines_) scene_->sides_in_view(Eye::of(wanted.view), sides_);
    viewed_.geometry_ = new_number();
    begin_planes();
  }
  const bool by_centres = wanted.centres_of && !shows_shadows_ && !shows_lines_;
  const Part::InView in_view{*this, wanted, volume, by_centres};
  if (wanted.threads == 1) {
    take_parts([&](Part& part) {
      part.view(in_view, segments_[part.segment()].image, viewed_, {points_.size(), corners_},
                primitive_of_items_);
    });
  } else {
    in_parallel(wanted.threads, parts_.size(), [&](std::size_t k) {
      const SegmentNow& segment = segments_[parts_[k]->segment()];
      if (segment.visible) parts_[k]->view(in_view, segment.image);
    });
    take_parts([&](const Part& part) {
      viewed_.append(part.seen(), corners_, points_.size());
      primitive_of_items_.insert(primitive_of_items_.end(), part.primitives().begin(),
                                 part.primitives().end());
    });
  }
  view_texts(volume);
  find_entered(volume);
  find_radius(volume);
  last_ = wanted;
  return viewed_;
}

void SceneViewer::view_points(const Wanted& wanted, const ViewVolume& volume) {
  outcodes_.resize(points_.size());
  if (wanted.centres_of) places_.resize(points_.size());
  viewed_.own_points_.resize(points_.size());
  in_parallel(wanted.threads, blocks_.size(), [&](std::size_t k) {
    Block& block = blocks_[k];
    block.largest_depth = 0.0;
    if (!segments_[block.segment].visible) return;
    const auto in_block = [&](auto& array) {
      return std::span(array).subspan(block.first, block.end - block.first);
    };
    const std::span<Point3> device = in_block(viewed_.own_points_);
    const std::span<std::uint8_t> outcodes = in_block(outcodes_);
    displayfile::view_points(volume, in_block(points_), device, outcodes);
    if (wanted.centres_of) {
      block.largest_depth = find_places(device, outcodes, *wanted.centres_of, in_block(places_));
    } else {
      for (const Point3& p : device) {
        block.largest_depth = std::max(block.largest_depth, std::abs(p.z));
      }
    }
  });
}

/// Collects the parts one after another, in order of entry, in the scene.
template <class Take>
void SceneViewer::take_parts(Take&& take) {
  viewed_.clear();
  viewed_.palette_ = scene_->fill_colours();
  viewed_.palette_number_ = palette_;
  viewed_.own_points_.resize(points_.size());
  primitive_of_items_.clear();
  viewed_.items_.reserve(scene_->size());
  viewed_.pick_.reserve(scene_->size());
  if (!all_edges_drawn_) {
    const auto drawn =
        selects_lines_ ? std::span<const LineKinds>(sides_) : scene_->primitives({}).visible;
    viewed_.edge_visible_.assign(drawn.begin(), drawn.end());
  }
  for (const Block& block : blocks_) {
    viewed_.largest_depth_ = std::max(viewed_.largest_depth_, block.largest_depth);
  }
  std::size_t k = 0;
  for (std::uint32_t segment = 0; segment < segments_.size(); ++segment) {
    if (!segments_[segment].visible) continue;
    viewed_.segments_.push_back({scene_->segments()[segment].name, viewed_.items()});
    const auto same_image = std::ranges::find_if(segments_, [&](const SegmentNow& other) {
      return other.visible && ImageMatrix(other.image) == ImageMatrix(segments_[segment].image);
    });
    viewed_.looks_.push_back(
        {viewed_.items(), static_cast<std::uint32_t>(same_image - segments_.begin())});
    while (k < parts_.size() && parts_[k]->segment() < segment) ++k;
    for (; k < parts_.size() && parts_[k]->segment() == segment; ++k) {
      take(*parts_[k]);
    }
  }
  viewed_.points_ = viewed_.own_points_;
  number_own_corners();
  if (!viewed_.edge_visible_.empty()) viewed_.edge_visible_.resize(viewed_.corners_.size(), 1);
}

/// Numbers the corners of the scene's own points, which follow those of the retained scene.
void SceneViewer::number_own_corners() {
  std::vector<std::uint32_t>& corners = viewed_.corners_;
  const std::size_t own = viewed_.own_points_.size() - points_.size();
  while (corners.size() < corners_ + own) {
    corners.push_back(static_cast<std::uint32_t>(points_.size() + corners.size() - corners_));
  }
}

void SceneViewer::view_texts(const ViewVolume& volume) {
  const ClipPipeline pipeline(volume);
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    if (!segments_[k].visible) continue;
    const RetainedScene::Segment& segment = scene_->segments()[k];
    for (const RetainedScene::Text& text : scene_->texts(segment)) {
      const auto [device, outcode] = pipeline.view(text.anchor);
      if (outcode != 0) continue;
      const Attributes& look = scene_->attributes(text);
      const Point3 anchor =
          segments_[k].image.is_identity() ? device : ImageMatrix(segments_[k].image).apply(device);
      viewed_.texts_.push_back({anchor, look.text, look.line, text.characters, segment.name});
    }
    for (const KeptAnnotation& kept : segment.annotations) {
      const std::optional<KeptAnnotation> in_view = viewed(kept, volume);
      if (!in_view) continue;
      viewed_.annotations_.push_back(transformed(*in_view, segments_[k].image));
      viewed_.annotations_.back().segment = segment.name;
    }
  }
}

DisplayFile SceneViewer::display_file(const View& view, const glm::dmat3& lights_turned) const {
  DisplayFile file;
  const ViewVolume volume(view);
  PolygonStage stage(volume);
  for (const RetainedScene::Segment& part : scene().segments()) {
    const Segment& now = taken_.attributes().segment(part.name);
    if (!now.visible) continue;
    Segment& segment = file.create(part.name);
    segment.image = now.image;
    segment.set_title(now.title());
    scene().enter_viewed(part, Eye::of(view), stage, lights_turned, segment, [](std::uint32_t) {});
    segment.close();
  }
  return file;
}

std::size_t SceneViewer::bytes() const {
  const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
  std::size_t sum = size(welded_) + size(sides_) + size(outcodes_) + size(places_) +
                    viewed_.bytes() + size(primitive_of_items_);
  for (const auto& part : parts_) sum += part->bytes();
  return sum;
}

}  // namespace displayfile
