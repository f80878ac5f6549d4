#include "displayfile/segments/retained_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "clip/base/error.h"
#include "clip/base/growing_array.h"
#include "clip/geometry/back_face.h"
#include "clip/geometry/bounds.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/side_kinds.h"
#include "hidden/exact/plane.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

namespace {

constexpr Point3 kNoDirection(0.0);
constexpr std::uint32_t kNotKept = std::numeric_limits<std::uint32_t>::max();

/// True if both are equal except for the fill colour.
bool equal_but_for_colour(const Attributes& a, const Attributes& b) {
  return a.fill.kind == b.fill.kind && a.fill.shadow == b.fill.shadow && a.line == b.line &&
         a.dark_line == b.dark_line && a.text == b.text && a.light == b.light &&
         a.back_face_removal == b.back_face_removal && a.shadows == b.shadows &&
         a.shading == b.shading;
}

}  // namespace

const RetainedScene::ModellingMatrix& RetainedScene::modelling_matrix(std::uint32_t i) const {
  static constexpr ModellingMatrix kIdentity(1.0);
  const std::uint32_t first = primitives_[i].first;
  const std::uint32_t point = corners_.empty() ? first : corners_[first];
  const ModellingMatrix* const matrix = modellings_.at(point);
  return matrix == nullptr ? kIdentity : *matrix;
}

std::uint32_t RetainedScene::primitive_of_corner(std::uint32_t first) const {
  const auto found = std::ranges::lower_bound(primitives_, first, {}, &Primitive::first);
  return static_cast<std::uint32_t>(found - primitives_.begin());
}

RetainedPolygons RetainedScene::entered_polygons(const Segment& segment) const {
  return {primitives_.part(), entered_.empty() ? points_.part() : entered_.part(), corners_.part(),
          segment.first, segment.end - segment.first};
}

double RetainedScene::reach_in_world(const Segment& segment) const {
  const std::span<const Point3> entered = entered_.empty() ? points_ : entered_;
  const double largest = largest_coordinate(
      entered.subspan(segment.first_point, segment.end_point - segment.first_point));
  return entered_reach(segment.touching, largest) * modellings_.longest_column();
}

double RetainedScene::largest_in_world() const {
  return modellings_.largest_in_world(largest_coordinate(entered_.empty() ? points_ : entered_));
}

const RetainedScene::Segment& RetainedScene::segment_of(std::uint32_t primitive) const {
  return *std::ranges::upper_bound(segments_, primitive, {}, &Segment::end);
}

WorldPolygon RetainedScene::polygon(std::uint32_t i) const {
  const auto normals = is_smooth(i) ? of(vertex_normals_, i) : std::span<const Point3>();
  if (modellings_.empty())
    return {points(i), of(edge_visible_, i), normal(i), normals, primitives_[i].pick};
  return {points(i),           of(edge_visible_, i), normal(i),           normals,
          primitives_[i].pick, entered_points(i),    &modelling_matrix(i)};
}

Point3 RetainedScene::normal(std::uint32_t i) const {
  if (i < normals_.size() && normals_[i] != kNoDirection) return normals_[i];
  const bool has_one = !primitives_[i].is_line() && shared_attributes(i).light;
  return has_one ? newell_normal(points(i)) : kNoDirection;
}

bool RetainedScene::is_smooth(std::uint32_t i) const {
  const Primitive& primitive = primitives_[i];
  const std::size_t end = primitive.first + std::size_t{primitive.sides};
  return end <= vertex_normals_.size() && vertex_normals_[primitive.first] != kNoDirection;
}

Attributes RetainedScene::attributes(std::uint32_t i) const {
  Attributes attributes = shared_attributes(i);
  attributes.fill.colour = fill_colour(i);
  return attributes;
}

bool RetainedScene::draws(std::uint32_t i) const {
  const Attributes& attributes = shared_attributes(i);
  return primitives_[i].is_line() || attributes.fill.kind == FillStyle::Kind::solid ||
         attributes.is_outlined();
}

double RetainedScene::off_plane(std::uint32_t i) const {
  const PointRow polygon = points(i);
  if (polygon.size() <= 3) return 0.0;
  const SupportVertices support = spread_vertices(polygon);
  if (support.edge_on) return 0.0;
  const auto& [p, q, r] = support.index;
  return off_plane(i, Plane(polygon[p], polygon[q], polygon[r]));
}

double RetainedScene::off_plane(std::uint32_t i, const Plane& plane) const {
  double most = 0.0;
  for (const Point3& v : points(i)) most = std::max(most, std::abs(plane_value(v, plane).value));
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
                      : shared_attributes(i).fill.kind == FillStyle::Kind::solid
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

namespace {

bool is_by_back_face(LineKinds kinds) { return (kinds & SideKinds::kByBackFace) != 0; }

}  // namespace

bool RetainedScene::removes_back_faces(const Segment& segment) const {
  for (std::uint32_t i = segment.first; i < segment.end; ++i) {
    if (shared_attributes(i).back_face_removal) return true;
  }
  return false;
}

/// A removed back face may leave a side if a line is drawn by that side alone: the polygon is then
/// hollow.
void RetainedScene::enter_viewed(const Segment& part, const Eye& eye, PolygonStage& stage,
                                 const glm::dmat3& lights_turned, displayfile::Segment& segment,
                                 const std::function<void(std::uint32_t)>& is_item) const {
  segment.keep_entered(part.touching, stage.pipeline().volume());
  segment.keeping_entered()->begin_retained(entered_polygons(part));
  std::optional<std::uint32_t> in_force;
  Attributes attributes;
  std::vector<LineKinds> selected;
  if (part.sides != nullptr) {
    selected.resize(part.sides->corners());
    using TurnedAway = SideKinds::TurnedAway;
    part.sides->in_view(*this, part, eye, selected,
                        removes_back_faces(part) ? TurnedAway::stays : TurnedAway::kept);
  }
  const std::uint32_t first_corner = this->first_corner(part);
  const auto sides_of = [&](std::uint32_t i) {
    if (selected.empty()) return of(edge_visible_, i);
    const auto [first, sides, look, pick] = primitives_[i];
    return std::span<const LineKinds>(selected).subspan(first - first_corner, sides);
  };
  if (has_shared()) stage.view_vertices(points(part), part.first_point);
  for (const auto& [upward, x_points, y_points] : part.surfaces) {
    segment.mark_surface({stage.pipeline().volume().infinitely_far(upward), x_points, y_points});
  }
  std::vector<LineKinds> alone;
  const auto enter_sides_alone = [&](std::uint32_t i) {
    Attributes of_sides = attributes;
    alone.clear();
    for (const LineKinds kinds : sides_of(i)) {
      const bool stays = is_by_back_face(kinds) || !of_sides.back_face_removal;
      alone.push_back(stays ? static_cast<LineKinds>(kinds & ~SideKinds::kByBackFace)
                            : LineKinds{0});
    }
    if (of_sides.back_face_removal) {
      of_sides.fill.kind = FillStyle::Kind::hollow;
      of_sides.back_face_removal = false;
      stage.attributes_changed();
      in_force.reset();
    }
    if (enter_viewed(i, of_sides, alone, stage, segment)) is_item(i);
  };
  const auto enter_primitive = [&](std::uint32_t i) {
    if (in_force != primitives_[i].look) {
      in_force = primitives_[i].look;
      attributes = this->attributes(i);
      if (attributes.light) attributes.light->toward = lights_turned * attributes.light->toward;
      stage.attributes_changed();
    }
    if (std::ranges::any_of(sides_of(i), is_by_back_face)) return enter_sides_alone(i);
    if (enter_viewed(i, attributes, sides_of(i), stage, segment) && draws(i)) is_item(i);
  };
  in_order_of_entry(part, enter_primitive, [&](const Text& text) {
    stage.enter_text(text.anchor, text.characters, attributes_[text.attributes], segment);
  });
  for (const KeptAnnotation& annotation : part.annotations) {
    stage.enter_annotation(annotation, segment);
  }
}

/// False if no part of it is visible.
bool RetainedScene::enter_viewed(std::uint32_t i, const Attributes& attributes,
                                 std::span<const LineKinds> sides, PolygonStage& stage,
                                 displayfile::Segment& segment) const {
  if (primitives_[i].is_line()) {
    const PointRow ends = points(i);
    segment.set_line_pick(primitives_[i].pick);
    return stage.enter_line(ends[0], ends[1], attributes.line, segment);
  }
  WorldPolygon world = polygon(i);
  world.edge_visible = sides;
  if (has_shared()) return stage.enter_shared(corners(i), world, attributes, segment);
  return stage.enter_polygon(world, attributes, segment);
}

/// Appends the points of a segment of another scene, with the same points as entered.
void RetainedScene::append_points(const RetainedScene& other, const Segment& segment) {
  const auto points = other.points(segment);
  if (other.modellings_.empty()) {
    begin_modelling(nullptr);
    points_.append(points);
    if (!modellings_.empty()) entered_.append(points);
    return;
  }
  const auto& runs = other.modellings_.runs();
  auto next = std::ranges::upper_bound(runs, segment.first_point, {}, &ModellingRuns::Run::first);
  const ModellingMatrix identity(1.0);
  begin_modelling(next == runs.begin() ? &identity : &std::prev(next)->matrix);
  for (std::uint32_t k = segment.first_point; k < segment.end_point; ++k) {
    if (next != runs.end() && next->first == k) begin_modelling(&next++->matrix);
    enter_point(other.points_[k], other.entered_[k]);
  }
}

/// Appends a segment of another scene with all its primitives; points shared there are shared here.
void RetainedScene::append(const RetainedScene& other, const Segment& segment) {
  opened_ = segment.opened;  // a segment keeps its number
  open_segment(segment.name, segment.view, segment.touching);
  const auto moved_by = static_cast<std::uint32_t>(points_.size()) - segment.first_point;
  append_points(other, segment);
  has_cuts_ = has_cuts_ || other.has_cuts_;
  const auto append_primitive = [&](std::uint32_t i) {
    const Primitive& primitive = other.primitives_[i];
    begin_primitive(primitive.sides, other.attributes(i), primitive.pick);
    if (other.has_shared()) {
      for (const std::uint32_t corner : other.corners(i)) corners_.push_back(corner + moved_by);
    }
    finish_primitive(other.polygon(i));
  };
  other.in_order_of_entry(segment, append_primitive, [&](const Text& text) {
    enter_text(text.anchor, text.characters, other.attributes_[text.attributes]);
  });
  for (const KeptAnnotation& annotation : segment.annotations) enter_annotation(annotation);
  segments_.back().sides = segment.sides;
  segments_.back().intersections = segment.intersections;
  segments_.back().surfaces = segment.surfaces;
}

void RetainedScene::open_segment(int name, const View& view, const Touching& touching) {
  const auto points = static_cast<std::uint32_t>(points_.size());
  const auto texts = static_cast<std::uint32_t>(texts_.size());
  segments_.push_back({name, view, size(), size(), points, points, texts, texts, opened_++});
  segments_.back().touching = touching;
}

/// Frees spare capacity. As this copies the arrays, only if the segment for which they grew is a
/// large part of the scene.
void RetainedScene::free_room(const Segment& segment) {
  if (segment.end - segment.first <= size() / 8) return;
  displayfile::free_room(primitives_);
  displayfile::free_room(points_);
  displayfile::free_room(entered_);
  displayfile::free_room(corners_);
  displayfile::free_room(edge_visible_);
}

void RetainedScene::close_segment(const LineSelection& lines) {
  Segment& segment = segments_.back();
  free_room(segment);
  segment.intersections = contains(lines.kinds, LineKind::intersection);
  segment.sides =
      lines.is_all_alone() ? nullptr : std::make_shared<const SideKinds>(*this, segment, lines);
  edited();
}

void RetainedScene::reopen_segment() {
  segments_.back().intersections = false;
  segments_.back().sides = nullptr;
  edited();
}

bool RetainedScene::has_intersections() const {
  return std::ranges::any_of(segments_, &Segment::intersections);
}

bool RetainedScene::selects_lines() const {
  return std::ranges::any_of(segments_,
                             [](const Segment& segment) { return segment.sides != nullptr; });
}

void RetainedScene::sides_in_view(const Eye& eye, std::vector<LineKinds>& of_corners) const {
  of_corners.assign(edge_visible_.begin(), edge_visible_.end());
  for (const Segment& segment : segments_) {
    if (segment.sides == nullptr) continue;
    const auto own = std::span(of_corners).subspan(first_corner(segment), segment.sides->corners());
    using TurnedAway = SideKinds::TurnedAway;
    segment.sides->in_view(*this, segment, eye, own,
                           removes_back_faces(segment) ? TurnedAway::removed : TurnedAway::kept);
  }
}

std::vector<LineKinds> RetainedScene::sides_in_any_view() const {
  std::vector<LineKinds> of_corners = edge_visible_;
  for (const Segment& segment : segments_) {
    if (segment.sides == nullptr) continue;
    segment.sides->in_any_view(
        std::span(of_corners).subspan(first_corner(segment), segment.sides->corners()));
  }
  return of_corners;
}

void RetainedScene::remove(int name) {
  const std::uint32_t opened = opened_;
  *this = selected([&](const Segment& segment) { return segment.name != name; });
  opened_ = opened;
}

void RetainedScene::remove_all() {
  const std::uint32_t opened = opened_;
  *this = RetainedScene();
  opened_ = opened;
}

void RetainedScene::rename(int from, int to) {
  const auto segment = std::ranges::find(segments_, from, &Segment::name);
  if (segment != segments_.end()) segment->name = to;
  edited();
}

void RetainedScene::set_view(std::uint32_t opened, const View& view) {
  for (Segment& segment : segments_) {
    if (segment.opened == opened) segment.view = view;
  }
  edited();
}

void RetainedScene::replace_light(const Light& light, const Light& other) {
  for (Attributes& attributes : attributes_) {
    if (attributes.light == light) attributes.light = other;
  }
  edited();
}

void RetainedScene::enter_polygon(const WorldPolygon& polygon, const Attributes& attributes) {
  if (segments_.empty()) return;  // opened before the scene was retained
  begin_primitive(polygon.vertices.size(), attributes, polygon.pick);
  begin_modelling(polygon.modelling);
  has_cuts_ = has_cuts_ || (polygon.is_cut && polygon.modelling != nullptr);
  const std::span<const Point3> world = polygon.vertices;
  enter_corners(world,
                polygon.modelling != nullptr ? std::span<const Point3>(polygon.entered) : world);
  finish_primitive(polygon);
}

void RetainedScene::enter_line(const Point3& from, const Point3& to, const Attributes& attributes,
                               std::int32_t pick) {
  if (segments_.empty()) return;
  begin_primitive(2, attributes, pick);
  const std::array ends{from, to};
  begin_modelling(nullptr);
  enter_corners(ends, ends);
  finish_primitive({.vertices = ends,
                    .edge_visible = {},
                    .normal = kNoDirection,
                    .vertex_normals = {},
                    .pick = -1});
}

void RetainedScene::begin_shared(std::size_t vertices, std::size_t polygons, std::size_t corners) {
  number_of_shared_.assign(vertices, kNotKept);
  const auto make_room = [](auto& values, std::size_t more) {
    // At least doubles the size, so that many calls of few polygons do not copy everything each
    // time.
    const std::size_t size = values.size() + more;
    if (size > values.capacity()) values.reserve(std::max(size, 2 * values.size()));
  };
  make_room(primitives_, polygons);
  make_room(corners_, corners);
  make_room(edge_visible_, corners);
  make_room(points_, std::min(vertices, corners));
}

/// Enters a corner of the current polygon: its vertex is stored if no polygon had it before.
void RetainedScene::enter_shared_corner(std::uint32_t corner, const Point3& world,
                                        const Point3& entered) {
  std::uint32_t& number = number_of_shared_[corner];
  if (number == kNotKept) {
    number = static_cast<std::uint32_t>(points_.size());
    enter_point(world, entered);
  }
  corners_.push_back(number);
}

void RetainedScene::enter_shared(std::span<const std::uint32_t> corners,
                                 const WorldPolygon& polygon, const Attributes& attributes) {
  if (segments_.empty()) return;
  begin_primitive(corners.size(), attributes, polygon.pick);
  begin_modelling(polygon.modelling);
  name_points();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point3& world = polygon.vertices[k];
    enter_shared_corner(corners[k], world,
                        polygon.modelling != nullptr ? polygon.entered[k] : world);
  }
  finish_primitive(polygon);
}

void RetainedScene::enter_shared_triangles(const SharedVertices& vertices,
                                           std::span<const std::uint32_t> corners,
                                           const Attributes& attributes, std::int32_t pick,
                                           std::int32_t step) {
  if (segments_.empty() || corners.empty()) return;
  require_room(corners.size());
  begin_modelling(vertices.modelling);
  name_points();
  const std::span world = vertices.world;
  const std::span entered = vertices.modelling != nullptr ? vertices.entered : world;
  const std::uint32_t look = look_of(attributes);
  auto first = static_cast<std::uint32_t>(all_corners());
  for (std::size_t k = 0; k < corners.size(); k += 3, first += 3) {
    const auto triangle = corners.subspan(k, 3);
    primitives_.push_back({first, 3, look, pick});
    for (const std::uint32_t corner : triangle) {
      enter_shared_corner(corner, world[corner], entered[corner]);
    }
    pick = pick_of_ordinal(std::int64_t{pick} + step);
  }
  edge_visible_.resize(first, 1);
  segments_.back().end = size();
  segments_.back().end_point = static_cast<std::uint32_t>(points_.size());
}

/// Stores an index for each point; from here on corners may share points.
void RetainedScene::name_points() {
  if (!corners_.empty()) return;
  for (std::uint32_t point = 0; point < points_.size(); ++point) corners_.push_back(point);
}

void RetainedScene::require_room(std::size_t corners) const {
  if (all_corners() + corners >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("too many points to retain: expected fewer than 2^32 - 1");
  }
}

/// Makes sure that there is room for the primitive's corners before anything is changed.
void RetainedScene::begin_primitive(std::size_t sides, const Attributes& attributes,
                                    std::int32_t pick) {
  require_room(sides);
  primitives_.push_back({static_cast<std::uint32_t>(all_corners()),
                         static_cast<std::uint32_t>(sides), look_of(attributes), pick});
  segments_.back().end = size();
}

/// Enters corners with points of their own.
void RetainedScene::enter_corners(std::span<const Point3> points, std::span<const Point3> entered) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (has_shared()) corners_.push_back(static_cast<std::uint32_t>(points_.size()));
    enter_point(points[k], entered[k]);
  }
}

void RetainedScene::enter_point(const Point3& world, const Point3& entered) {
  points_.push_back(world);
  if (!modellings_.empty()) entered_.push_back(entered);
}

/// Sets the matrix of the points entered next; null: the identity.
void RetainedScene::begin_modelling(const ModellingMatrix* matrix) {
  if (matrix != nullptr && modellings_.empty()) entered_ = points_;
  modellings_.begin(points_.size(), matrix);
}

/// Adds the primitive's data other than its corners, which have been entered.
void RetainedScene::finish_primitive(const WorldPolygon& polygon) {
  segments_.back().end_point = static_cast<std::uint32_t>(points_.size());
  const std::size_t corners = all_corners() + polygon.vertices.size();
  edge_visible_.insert(edge_visible_.end(), polygon.edge_visible.begin(),
                       polygon.edge_visible.end());
  edge_visible_.resize(corners, 1);
  if (polygon.normal != kNoDirection && polygon.normal != newell_normal(polygon.vertices)) {
    normals_.resize(primitives_.size() - 1, kNoDirection);
    normals_.push_back(polygon.normal);
  }
  if (!polygon.vertex_normals.empty()) {
    vertex_normals_.resize(primitives_.back().first, kNoDirection);
    vertex_normals_.insert(vertex_normals_.end(), polygon.vertex_normals.begin(),
                           polygon.vertex_normals.end());
  }
}

void RetainedScene::enter_text(const Point3& anchor, std::string_view characters,
                               const Attributes& attributes) {
  if (segments_.empty()) return;
  const std::uint32_t in_force = attributes_of_look(look_of(attributes));
  texts_.push_back({anchor, size(), in_force, std::string(characters)});
  segments_.back().end_text = static_cast<std::uint32_t>(texts_.size());
}

void RetainedScene::enter_annotation(KeptAnnotation annotation) {
  if (segments_.empty()) return;
  segments_.back().annotations.push_back(std::move(annotation));
  ++annotations_;
}

/// Returns the number of the look; a new number whenever the attributes differ from the last ones.
std::uint32_t RetainedScene::look_of(const Attributes& attributes) {
  const bool others = attributes_.empty() || !equal_but_for_colour(attributes_.back(), attributes);
  if (others) attributes_.push_back(attributes);
  if (others || colours_.back() != attributes.fill.colour) {
    attributes_of_look_.push_back(static_cast<std::uint32_t>(attributes_.size() - 1));
    colours_.push_back(attributes.fill.colour);
  }
  return static_cast<std::uint32_t>(colours_.size() - 1);
}

}  // namespace displayfile
