#include "displayfile/segments/viewed_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "clip/base/error.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/polygons_as_entered.h"
#include "hidden/exact/support_plane.h"

namespace displayfile {

namespace {

void require_countable(std::size_t points) {
  if (points >= std::numeric_limits<std::uint32_t>::max()) {
    throw Error("too many points to find hidden surfaces: expected fewer than 2^32 - 1");
  }
}

/// The item's style: that of the last run that begins no later.
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
  std::size_t points;  // seen so far
  FillStyle fill_style{};
  LineStyle style{};
  TextStyle of_texts{};
  std::int32_t pick_id = -1, line_pick_id = -1;
  VertexShading of_vertices{};         // of the polygon that follows
  std::span<const LineKinds> kinds{};  // of its sides
  // Items of these styles were added, and none of others since.
  bool fill_added = false, line_added = false;
  const EnteredPolygons* entered = nullptr;   // the polygons, if they are kept as they were entered
  std::uint32_t first_entered = 0;            // their first number, among those of all segments
  std::uint32_t next_entered = 0;             // of theirs
  std::span<const std::uint32_t> not_seen{};  // from there on
  std::uint32_t first_line = 0, next_line = 0;

  void fill(const FillStyle& s) {
    fill_style = s;
    fill_added = false;
  }
  void line_style(const LineStyle& s) {
    style = s;
    line_added = false;
  }
  void pick(std::int32_t id) { pick_id = id; }
  void line_pick(std::int32_t id) { line_pick_id = id; }
  void intensities(std::span<const double> values) { of_vertices = {.intensities = values}; }
  void normals(std::span<const Point3> values, const Light& light) {
    of_vertices = {.normals = values, .light = &light};
  }
  void side_kinds(std::span<const LineKinds> values) { kinds = values; }
  void text_style(const TextStyle& s) { of_texts = s; }
  void text(const Point3& anchor, std::string_view characters) {
    const int segment = scene.segments_.empty() ? 0 : scene.segments_.back().name;
    scene.texts_.push_back({anchor, of_texts, style, std::string(characters), segment});
  }
  void annotation(const KeptAnnotation& kept) {
    scene.annotations_.push_back(kept);
    if (!scene.segments_.empty()) scene.annotations_.back().segment = scene.segments_.back().name;
  }
  void move(const Point3& p) { take({&p, 1}); }
  void line(const Point3& p) {
    take({&p, 1});
    const std::uint32_t number = first_line + next_line++;
    const Look look{fill_style, style, line_pick_id, kNone, fill_added, line_added};
    if (!look.is_outlined()) return;
    scene.add_item({static_cast<std::uint32_t>(points - 2), 2, Primitives::Kind::line}, look);
    line_added = true;
    if (entered != nullptr) scene.entered_of_item_.push_back(number);
  }
  /// SAVE-POLY-FOR-HSC (algorithm 9.7): collects one polygon.
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    const std::size_t first = points;
    const std::uint32_t number = number_entered();
    take(vertices);
    const auto shading = std::exchange(of_vertices, {});
    const auto of_sides = std::exchange(kinds, {});
    const Look look{fill_style, style, pick_id, kNone, fill_added, line_added};
    if (!look.shows()) return;
    if (!of_sides.empty()) {
      scene.note_edges(first, of_sides);
    } else if (!std::ranges::all_of(sides, [](std::int32_t s) { return s == op::line; })) {
      scene.note_sides(first, sides);
    }
    scene.add_polygon(static_cast<std::uint32_t>(first), vertices, look, shading);
    if (entered != nullptr) scene.entered_of_item_.push_back(number);
    fill_added = fill_style.kind == FillStyle::Kind::solid;
    line_added = true;
  }

  void begin_entered(const EnteredPolygons& polygons, std::uint32_t first_number) {
    entered = &polygons;
    first_entered = first_number;
    first_line = first_number + static_cast<std::uint32_t>(polygons.size());
    not_seen = polygons.not_seen();
  }

 private:
  /// The number of the polygon of the next instruction.
  std::uint32_t number_entered() {
    while (!not_seen.empty() && not_seen.front() == next_entered) {
      ++next_entered;
      not_seen = not_seen.subspan(1);
    }
    return first_entered + next_entered++;
  }
  /// Counts the points, and copies them unless they are in place already.
  void take(std::span<const Point3> more) {
    points += more.size();
    if (!in_place) scene.own_points_.insert(scene.own_points_.end(), more.begin(), more.end());
  }
};

std::uint32_t ViewedScene::look_of(Item item) const {
  return looks_.size() < 2 ? 0 : style_at(looks_, item);
}

void ViewedScene::note_edges(std::size_t first, std::span<const std::uint8_t> visible) {
  edge_visible_.resize(first, 1);
  edge_visible_.insert(edge_visible_.end(), visible.begin(), visible.end());
}

void ViewedScene::note_sides(std::size_t first, std::span<const std::int32_t> codes) {
  edge_visible_.resize(first + codes.size(), 1);
  for (std::size_t k = 0; k < codes.size(); ++k) {
    edge_visible_[first + k] = codes[k] == op::line ? 1 : 0;
  }
}

void ViewedScene::add_polygon(std::uint32_t first, std::span<const Point3> vertices,
                              const Look& look, const VertexShading& shading) {
  const bool solid = look.fill.kind == FillStyle::Kind::solid;
  if (solid && !shading.empty()) add_shading(shading);
  if (solid && look.fill.shadow) {
    if (shadows_.empty() || shadows_.back() != *look.fill.shadow) {
      shadows_.push_back(*look.fill.shadow);
    }
    shadow_.resize(items_.size(), kNone);
    shadow_.push_back(static_cast<std::uint32_t>(shadows_.size() - 1));
  }
  const SupportVertices support = support_vertices(vertices);
  if (vertices.size() > 3) {
    many_sided_.add(items());
    of_many_sided_.push_back({support.index, many_sided_corners_});
    many_sided_corners_ += static_cast<std::uint32_t>(vertices.size());
  }
  add_item({first, static_cast<std::uint32_t>(vertices.size()),
            solid ? Primitives::Kind::solid : Primitives::Kind::hollow},
           look);
  if (!solid || support.edge_on) return;
  add_fill();
  for (const Point3& v : vertices) largest_depth_ = std::max(largest_depth_, std::abs(v.z));
}

void ViewedScene::add_shading(const VertexShading& shading) {
  if (shading.normals.empty()) return intensities_.add(items(), shading.intensities);
  normals_.add(items(), shading.normals);
  if (lights_.empty() || lights_.back().style != *shading.light) {
    lights_.push_back({items(), *shading.light});
  }
}

const Light& ViewedScene::light(Item item) const { return style_at(lights_, item); }

void ViewedScene::clear() {
  edge_visible_.clear();
  items_.clear();
  pick_.clear();
  colours_.clear();
  own_colours_.clear();
  lines_.clear();
  segments_.clear();
  texts_.clear();
  annotations_.clear();
  surfaces_.clear();
  many_sided_.clear();
  of_many_sided_.clear();
  many_sided_corners_ = 0;
  fills_ = 0;
  fill_item_.clear();
  intensities_.clear();
  normals_.clear();
  lights_.clear();
  shadow_.clear();
  shadows_.clear();
  has_lines_ = false;
  largest_depth_ = 0.0;
  entered_of_item_.clear();
  looks_.clear();
}

void ViewedScene::append(const ViewedScene& part, std::size_t corners, std::size_t points) {
  const Item first_item = items();
  const auto moved_by = static_cast<std::uint32_t>(own_points_.size() - points);
  const auto append_all = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  // Per-item numbers of data stored separately, up to the last item that has some.
  const auto append_numbers = [&](auto& to, const auto& from, std::size_t stored) {
    if (from.empty()) return;
    to.resize(first_item, kNone);
    for (const std::uint32_t number : from) {
      to.push_back(number == kNone ? kNone : number + static_cast<std::uint32_t>(stored));
    }
  };
  const auto append_runs = [&](auto& to,
                               const auto& from) {  // each has another style than the last
    if (from.empty()) return;
    const bool goes_on = !to.empty() && to.back().style == from.front().style;
    const auto end = static_cast<std::ptrdiff_t>(to.size());
    to.insert(to.end(), from.begin() + (goes_on ? 1 : 0), from.end());
    std::for_each(to.begin() + end, to.end(), [&](auto& run) { run.first += first_item; });
  };
  if (!part.edge_visible_.empty()) {
    edge_visible_.resize(corners + moved_by, 1);
    append_all(edge_visible_, part.edge_visible_);
  }
  append_all(own_points_, part.own_points_);
  intensities_.append(part.intensities_, first_item);
  normals_.append(part.normals_, first_item);
  append_runs(lights_, part.lights_);
  append_numbers(shadow_, part.shadow_, shadows_.size());
  append_all(shadows_, part.shadows_);
  append_colours(part, first_item);
  append_runs(lines_, part.lines_);
  part.many_sided_.for_each([&](Item item) { many_sided_.add(first_item + item); });
  for (const auto& [support, corners_before] : part.of_many_sided_) {
    of_many_sided_.push_back({support, many_sided_corners_ + corners_before});
  }
  many_sided_corners_ += part.many_sided_corners_;
  if (part.fills_ > 0 && (first_item != fills_ || part.items() != part.fills_)) {
    number_fills();
    for (Fill fill = 1; fill <= part.fills_; ++fill) {
      fill_item_.push_back(first_item + part.item_of(fill));
    }
  }
  fills_ += part.fills_;
  append_all(entered_of_item_, part.entered_of_item_);
  const std::size_t end = items_.size();
  append_all(items_, part.items_);
  append_all(pick_, part.pick_);
  for (Primitives::Item& item : std::span(items_).subspan(end)) {
    if (item.first >= corners) item.first += moved_by;
  }
  has_lines_ |= part.has_lines_;
  largest_depth_ = std::max(largest_depth_, part.largest_depth_);
}

/// Appends the colours of another scene with the same palette, whose items begin at first_item
/// here.
void ViewedScene::append_colours(const ViewedScene& part, Item first_item) {
  const auto shared = static_cast<std::uint32_t>(palette_.size());
  const auto moved_by = static_cast<std::uint32_t>(own_colours_.size());
  for (const auto& [first, number] : part.colours_) {
    const std::uint32_t here = number < shared ? number : number + moved_by;
    if (colours_.empty() || colours_.back().style != here) {
      colours_.push_back({first_item + first, here});
    }
  }
  own_colours_.insert(own_colours_.end(), part.own_colours_.begin(), part.own_colours_.end());
}

void ViewedScene::add_item(const Primitives::Item& item, const Look& look) {
  if (item.kind == Primitives::Kind::solid && !look.same_fill) {
    begin_colour(look.colour != kNone ? look.colour : number_of(look.fill.colour));
  }
  const bool same_line = look.same_line || (!lines_.empty() && lines_.back().style == look.line);
  if (!same_line) lines_.push_back({items(), look.line});
  items_.push_back(item);
  pick_.push_back(look.pick);
  has_lines_ |= look.is_outlined();
}

void ViewedScene::number_fills() {
  if (!fill_item_.empty()) return;
  fill_item_.resize(fills_);
  std::iota(fill_item_.begin(), fill_item_.end(), Item{0});
}

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
  if (in_place) {
    intensities_.lie_in(entered->stored_intensities());
    normals_.lie_in(entered->stored_normals());
  }
  for (SurfaceMark mark : entered->surfaces()) {
    mark.upward = ImageMatrix(image).apply(mark.upward);
    surfaces_.push_back(mark);
  }
  Collector collector{*this, in_place, own_points_.size()};
  if (const EnteredPolygons* const kept = entered->as_entered(); kept != nullptr) {
    entered_of_item_.resize(items_.size(), kNotEntered);
    looks_.push_back({this->items(), look_of_source(*kept, image)});
    collector.begin_entered(*kept, entered_polygons_);
    entered_polygons_ += static_cast<std::uint32_t>(kept->size() + kept->lines());
  }
  entered->walk_transformed(image, collector);
}

/// The number of the first source with the same view.
std::uint32_t ViewedScene::look_of_source(const EnteredPolygons& kept,
                                          const ImageTransformation& image) const {
  std::uint32_t number = 0;
  for (const Source& source : sources_) {
    const EnteredPolygons* const other = source.instructions->as_entered();
    const bool is_alike = other != nullptr && other->is_viewed_like(kept) &&
                          ImageMatrix(source.image) == ImageMatrix(image);
    if (is_alike) break;
    ++number;
  }
  return number;
}

/// Called when the arrays have their final places.
void ViewedScene::finish(bool in_place) {
  points_ = in_place ? sources_.front().instructions->stored_points() : own_points_;
  if (!entered_of_item_.empty()) {
    entered_of_item_.resize(items_.size(), kNotEntered);
    PolygonsAsEntered polygons;
    for (const Source& source : sources_) {
      if (const auto* kept = source.instructions->as_entered()) polygons.add(*kept);
    }
    const auto polygon_of = [polygons](std::uint32_t number) { return polygons.polygon(number); };
    find_entered(polygon_of);
    find_bent(polygons.bent());
    planes_ = std::make_shared<Planes>();
    planes_->polygon_of = polygon_of;
    planes_->entered_reach = polygons.reach();
    planes_->find_touching = [polygons] {
      TouchingPlanes planes = polygons.planes();
      planes.keep_members_alone();
      return std::make_shared<const TouchingPlanes>(std::move(planes));
    };
    planes_->find_near = [polygons](const TouchingPlanes& touching) {
      return polygons.near_planes(touching);
    };
    find_radius(*planes_);
  }
  if (!edge_visible_.empty()) edge_visible_.resize(points_.size(), 1);
}

bool ViewedScene::is_of(const DisplayFile& display_file) const {
  if (geometry_ != 0) return false;  // of a retained scene
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

std::vector<std::uint8_t> ViewedScene::drawn_sides() const {
  std::vector<std::uint8_t> drawn(corners_.empty() ? points_.size() : corners_.size(), 0);
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    if (lines_[k].style.kind == LineStyle::Kind::none) continue;
    const Item end = k + 1 < lines_.size() ? lines_[k + 1].first : items();
    for (Item item = lines_[k].first; item < end; ++item) {
      const auto [first, sides, kind] = items_[item];
      for (std::uint32_t i = 0; i < sides; ++i) drawn[first + i] = side_kinds(item, i);
    }
  }
  return drawn;
}

FillStyle ViewedScene::fill_style(Item item) const {
  if (kind(item) != Primitives::Kind::solid) return {FillStyle::Kind::hollow};
  FillStyle style{FillStyle::Kind::solid, fill_colour(item)};
  if (const FillShadow* of_item = shadow_of_item(item)) style.shadow = *of_item;
  return style;
}

const Colour& ViewedScene::fill_colour(Item item) const { return colour(style_at(colours_, item)); }

const LineStyle& ViewedScene::line_style(Item item) const { return style_at(lines_, item); }

int ViewedScene::segment_name(Item item) const {
  const auto after = std::ranges::upper_bound(segments_, item, {}, &SegmentStart::first);
  return std::prev(after)->name;
}

std::size_t ViewedScene::bytes() const {
  const auto size = [](const auto& array) { return array.size() * sizeof(array[0]); };
  std::size_t characters = 0;
  for (const DeviceText& text : texts_) characters += text.characters.size();
  return characters + size(texts_) + size(annotations_) + size(own_points_) + size(corners_) +
         size(edge_visible_) + size(items_) + size(pick_) + size(colours_) + size(own_colours_) +
         size(lines_) + size(segments_) + many_sided_.bytes() + size(of_many_sided_) +
         size(fill_item_) + intensities_.bytes() + normals_.bytes() + size(lights_) +
         size(shadow_) + size(shadows_);
}

}  // namespace displayfile
