#include "displayfile/retained_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "clip/error.h"
#include "displayfile/display_file.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

namespace {

constexpr Point3 kNone(0.0);

/// The value of that index, of those that are stored up to the last that is not zero.
Point3 stored(const std::vector<Point3>& values, std::uint32_t i) {
  return i < values.size() ? values[i] : kNone;
}

}  // namespace

const RetainedScene::Segment& RetainedScene::segment_of(std::uint32_t primitive) const {
  return *std::ranges::upper_bound(segments_, primitive, {}, &Segment::end);
}

WorldPolygon RetainedScene::polygon(std::uint32_t i) const {
  const Primitive& primitive = primitives_[i];
  const std::size_t end = primitive.first + std::size_t{primitive.sides};
  const bool smooth = end <= vertex_normals_.size() && vertex_normals_[primitive.first] != kNone;
  return {points(i), of(edge_visible_, i), stored(normals_, i),
          smooth ? of(vertex_normals_, i) : std::span<const Point3>(), primitive.pick};
}

bool RetainedScene::draws(std::uint32_t i) const {
  return primitives_[i].is_line() || attributes(i).fill.kind == FillStyle::Kind::solid ||
         attributes(i).line.kind != LineStyle::Kind::none;
}

double RetainedScene::off_plane(std::uint32_t i) const {
  const auto polygon = points(i);
  if (polygon.size() <= 3) return 0.0;
  const SupportVertices support = spread_vertices(polygon);
  if (support.edge_on) return 0.0;
  const auto& [p, q, r] = support.index;
  const Plane plane(polygon[p], polygon[q], polygon[r]);
  double most = 0.0;
  for (const Point3& v : polygon) most = std::max(most, std::abs(plane_value(v, plane).value));
  return most / glm::length(plane.normal);
}

std::vector<Primitives::Item> RetainedScene::items(std::vector<std::uint32_t>& primitive_of) const {
  std::vector<Primitives::Item> items;
  items.reserve(size());
  primitive_of.clear();
  primitive_of.reserve(size());
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (!draws(i)) continue;
    const auto kind = primitives_[i].is_line() ? Primitives::Kind::line
                      : attributes(i).fill.kind == FillStyle::Kind::solid
                          ? Primitives::Kind::solid
                          : Primitives::Kind::hollow;
    items.push_back({primitives_[i].first, primitives_[i].sides, kind});
    primitive_of.push_back(i);
  }
  return items;
}

RetainedScene RetainedScene::selected(
    const std::function<bool(const Segment&)>& is_selected) const {
  RetainedScene scene;
  for (const Segment& segment : segments_) {
    if (is_selected(segment)) scene.append(*this, segment);
  }
  return scene;
}

RetainedScene RetainedScene::visible_in(const DisplayFile& display_file) const {
  return selected(
      [&](const Segment& segment) { return display_file.segment(segment.name).visible; });
}

template <class OnPrimitive, class OnText>
void RetainedScene::in_order_of_entry(const Segment& segment, OnPrimitive&& on_primitive,
                                      OnText&& on_text) const {
  auto texts = this->texts(segment);
  for (std::uint32_t i = segment.first;; ++i) {
    for (; !texts.empty() && texts.front().next == i; texts = texts.subspan(1)) {
      on_text(texts.front());
    }
    if (i == segment.end) return;
    on_primitive(i);
  }
}

void RetainedScene::enter_viewed(const Segment& part, ViewStage& stage,
                                 const glm::dmat3& lights_turned, displayfile::Segment& segment,
                                 const std::function<void(std::uint32_t)>& is_item) const {
  std::optional<std::uint32_t> in_force;
  Attributes attributes;
  const auto enter_primitive = [&](std::uint32_t i) {
    if (in_force != primitives_[i].attributes) {
      in_force = primitives_[i].attributes;
      attributes = attributes_[*in_force];
      if (attributes.light) attributes.light->toward = lights_turned * attributes.light->toward;
      stage.attributes_changed();
    }
    if (enter_viewed(i, attributes, stage, segment) && draws(i)) is_item(i);
  };
  in_order_of_entry(part, enter_primitive, [&](const Text& text) {
    stage.enter_text(text.anchor, text.characters, attributes_[text.attributes], segment);
  });
}

/// False if nothing of it is seen.
bool RetainedScene::enter_viewed(std::uint32_t i, const Attributes& attributes, ViewStage& stage,
                                 displayfile::Segment& segment) const {
  if (primitives_[i].is_line()) {
    const auto ends = points(i);
    return stage.enter_line(ends[0], ends[1], attributes.line, segment);
  }
  return !stage.enter_polygon(polygon(i), attributes, segment).empty();
}

/// A segment of another scene, with all its primitives.
void RetainedScene::append(const RetainedScene& other, const Segment& segment) {
  open_segment(segment.name, segment.view);
  const auto append_primitive = [&](std::uint32_t i) {
    if (other.primitives_[i].is_line()) {
      enter_line(other.points(i)[0], other.points(i)[1], other.attributes(i));
    } else {
      enter_polygon(other.polygon(i), other.attributes(i));
    }
  };
  other.in_order_of_entry(segment, append_primitive, [&](const Text& text) {
    enter_text(text.anchor, text.characters, other.attributes_[text.attributes]);
  });
}

void RetainedScene::open_segment(int name, const View& view) {
  const auto points = static_cast<std::uint32_t>(points_.size());
  const auto texts = static_cast<std::uint32_t>(texts_.size());
  segments_.push_back({name, view, size(), size(), points, points, texts, texts});
}

void RetainedScene::remove(int name) {
  *this = selected([&](const Segment& segment) { return segment.name != name; });
}

void RetainedScene::remove_all() { *this = RetainedScene(); }

void RetainedScene::rename(int from, int to) {
  const auto segment = std::ranges::find(segments_, from, &Segment::name);
  if (segment != segments_.end()) segment->name = to;
}

void RetainedScene::enter_polygon(const WorldPolygon& polygon, const Attributes& attributes) {
  if (segments_.empty()) return;  // opened before the scene was retained
  enter(polygon.vertices, attributes, polygon.pick);
  edge_visible_.insert(edge_visible_.end(), polygon.edge_visible.begin(),
                       polygon.edge_visible.end());
  edge_visible_.resize(points_.size(), 1);
  if (polygon.normal != kNone) {
    normals_.resize(primitives_.size() - 1, kNone);
    normals_.push_back(polygon.normal);
  }
  if (!polygon.vertex_normals.empty()) {
    vertex_normals_.resize(primitives_.back().first, kNone);
    vertex_normals_.insert(vertex_normals_.end(), polygon.vertex_normals.begin(),
                           polygon.vertex_normals.end());
  }
}

void RetainedScene::enter_line(const Point3& from, const Point3& to, const Attributes& attributes) {
  if (segments_.empty()) return;
  enter(std::array{from, to}, attributes, -1);
  edge_visible_.resize(points_.size(), 1);
}

void RetainedScene::enter_text(const Point3& anchor, std::string_view characters,
                               const Attributes& attributes) {
  if (segments_.empty()) return;
  texts_.push_back({anchor, size(), number_of(attributes), std::string(characters)});
  segments_.back().end_text = static_cast<std::uint32_t>(texts_.size());
}

/// They are numbered anew wherever they change.
std::uint32_t RetainedScene::number_of(const Attributes& attributes) {
  if (attributes_.empty() || attributes_.back() != attributes) attributes_.push_back(attributes);
  return static_cast<std::uint32_t>(attributes_.size() - 1);
}

void RetainedScene::enter(std::span<const Point3> points, const Attributes& attributes,
                          std::int32_t pick) {
  if (points_.size() + points.size() >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("too many points to retain: expected fewer than 2^32 - 1");
  }
  primitives_.push_back({static_cast<std::uint32_t>(points_.size()),
                         static_cast<std::uint32_t>(points.size()), number_of(attributes), pick});
  points_.insert(points_.end(), points.begin(), points.end());
  segments_.back().end = size();
  segments_.back().end_point = static_cast<std::uint32_t>(points_.size());
}

}  // namespace displayfile
