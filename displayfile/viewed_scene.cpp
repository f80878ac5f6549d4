#include "displayfile/viewed_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <mutex>
#include <numeric>
#include <utility>

#include "clip/back_face.h"
#include "clip/error.h"
#include "displayfile/display_file.h"
#include "displayfile/polygons_as_entered.h"
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
  /// That of the polygon of the next instruction.
  std::uint32_t number_entered() {
    while (!not_seen.empty() && not_seen.front() == next_entered) {
      ++next_entered;
      not_seen = not_seen.subspan(1);
    }
    return first_entered + next_entered++;
  }
  /// Counts the points, which are in place already, or else takes copies.
  void take(std::span<const Point3> more) {
    points += more.size();
    if (!in_place) scene.own_points_.insert(scene.own_points_.end(), more.begin(), more.end());
  }
};

/// The largest of all sources. That of planes is 0 if it is not small.
void ViewedScene::find_radius(Planes& planes) const {
  bool has_images = false;
  for (const Source& source : sources_) {
    const EnteredPolygons* const kept = source.instructions->as_entered();
    if (kept == nullptr) continue;
    has_images |= !source.image.is_identity();
    planes.reach =
        std::max(planes.reach, entered_reach(kept->touching(), kept->largest()) * kept->longest());
  }
  for (const Source& source : sources_) {
    const EnteredPolygons* const kept = source.instructions->as_entered();
    if (kept == nullptr) continue;
    const double radius =
        radius_in(kept->volume().matrix(), kept->largest_in_world(), planes.reach, largest_depth_);
    planes.radius_of_ends = std::max(planes.radius_of_ends, radius * longest_of(source.image));
    planes.compares_ends |= may_reach(planes.reach, kept->touching(), kept->volume());
  }
  set_radius(planes, planes.radius_of_ends, !has_images);
}

void ViewedScene::set_radius(Planes& planes, double of_planes, bool are_looked_for) const {
  constexpr double kLittle = 0x1p-40;
  planes.are_close = planes.reach == 0.0 || (of_planes > 0.0 && of_planes <= kLittle);
  planes.radius = are_looked_for ? small_radius(of_planes) : 0.0;
}

bool ViewedScene::may_reach(double reach, const Touching& touching, const ViewVolume& volume) {
  constexpr double kMostOfWindow = 0x1p-10;
  if (touching.kind != Touching::Kind::automatic) return true;
  const Rectangle& window = volume.view().window;
  const double width = std::max(window.x_max - window.x_min, window.y_max - window.y_min);
  return reach > 0.0 && reach <= kMostOfWindow * width;
}

/// Where the radius is larger, all planes are looked for at once.
double ViewedScene::small_radius(double radius) {
  constexpr double kLargest = 0x1p-37;  // fills steeper than 4096 are not certain then
  return radius <= kLargest ? radius : 0.0;
}

/// By how much an image transformation makes a coordinate's error larger, at most; at least 1.
double ViewedScene::longest_of(const ImageTransformation& image) {
  return std::max(1.0, std::abs(image.scale.x) + std::abs(image.scale.y));
}

/// With u = 2^-53: a world point is a sum of products, off by 4 u of the sum of their sizes, and so
/// is each homogeneous coordinate of a viewed one; a plane's points are off it by the reach too. W
/// is at least what it is at the nearest depth in the scene: depth is A + B / W.
double ViewedScene::radius_in(const glm::dmat4& view, double in_world, double reach,
                              double largest_depth) {
  constexpr double kU = 0x1p-53;
  constexpr double kCoarsest = 0x1p-10;  // beyond it, or without a bound, nothing can be told
  const double off = reach + 4.0 * kU * in_world;  // in the world, each coordinate
  const auto row = [&](int k) {
    return std::abs(view[0][k]) + std::abs(view[1][k]) + std::abs(view[2][k]);
  };
  const auto error = [&](int k) {
    return row(k) * (off + 4.0 * kU * in_world) + 4.0 * kU * std::abs(view[3][k]);
  };
  double least_w = 1.0;
  if (row(3) > 0.0) {  // perspective: the rows of Z and W are the same but for a factor and a sum
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (std::abs(view[k][3]) > std::abs(view[axis][3])) axis = k;
    }
    const double a = view[axis][2] / view[axis][3], b = view[3][2] - a * view[3][3];
    least_w = 0.5 * std::abs(b) / (largest_depth + std::abs(a));
  }
  const double of_row = std::max({error(0), error(1), error(2)});
  const double radius = 2.0 * (of_row + error(3) * (1.0 + largest_depth)) / least_w + 8.0 * kU;
  return radius <= kCoarsest ? radius : 0.0;
}

namespace {

/// Twice the area of a polygon as entered, along its normal, and what that may be off by where its
/// vertices are within a reach of a plane.
struct Normal {
  Point3 along{0.0};
  double error = 0.0;
};
Normal normal_of(const EnteredPolygon& polygon, double reach) {
  const auto world = [&](const Point3& p) {
    return polygon.modelling == nullptr ? p : Point3(*polygon.modelling * glm::dvec4(p, 1.0));
  };
  const std::size_t sides = polygon.points.size();
  if (sides < 3) return {Point3(0.0), std::numeric_limits<double>::infinity()};
  const Point3 first = world(polygon.points[0]);
  Normal normal;
  double size = 0.0, largest = glm::length(first);
  Point3 before(0.0);
  for (std::size_t k = 1; k < sides; ++k) {
    const Point3 p = world(polygon.points[k]), here = p - first;
    normal.along += glm::cross(before, here);
    size = std::max(size, glm::length(here));
    largest = std::max(largest, glm::length(p));
    before = here;
  }
  if (polygon.modelling != nullptr) largest += 4.0 * glm::length((*polygon.modelling)[3]);
  const double off = reach + 0x1p-47 * largest;
  normal.error = static_cast<double>(sides) * size * (2.0 * off + 0x1p-48 * size);
  return normal;
}

}  // namespace

/// In one plane of normal n they have normals A n + E and B n + F, with E and F no larger than
/// their errors, so that the cross product of these is no larger than the sum below. True only if
/// there is a radius, and the planes were not looked for yet.
bool ViewedScene::is_certainly_apart(Item a, Item b) const {
  if (!(planes_->radius > 0.0) || planes_->are_found.load(std::memory_order_acquire)) return false;
  const auto polygon = [this](Item item) {
    return planes_->polygon_of_item ? planes_->polygon_of_item(items_[item].first)
                                    : entered_of_item_[item];
  };
  const std::uint32_t of_a = polygon(a), of_b = polygon(b);
  if (of_a == kNotEntered || of_b == kNotEntered) return !planes_->polygon_of_item;
  const Normal n = normal_of(planes_->polygon_of(of_a), planes_->reach);
  const Normal m = normal_of(planes_->polygon_of(of_b), planes_->reach);
  const double n_size = glm::length(n.along), m_size = glm::length(m.along);
  const double most = (n_size + n.error) * m.error + (m_size + m.error) * n.error +
                      n.error * m.error + 0x1p-45 * n_size * m_size;
  return glm::length(glm::cross(n.along, m.along)) > most;
}

std::span<const Primitives::PlanePoints> ViewedScene::planes() const {
  if (planes_ == nullptr) return {};
  if (!planes_->are_found.load(std::memory_order_acquire)) {
    const std::lock_guard in_turn(planes_->in_turn);
    if (!planes_->are_found.load(std::memory_order_relaxed)) {
      find_planes(*planes_);
      planes_->are_found.store(true, std::memory_order_release);
    }
  }
  return planes_->of_items;
}

bool ViewedScene::is_edge_on(Item item) const {
  const PointRow vertices = points(item);
  return support_vertices({vertices.data(), vertices.size()}).edge_on;
}

void ViewedScene::find_planes(Planes& found) const {
  found.of_items.clear();
  found.founders.clear();
  found.elsewhere.clear();
  const bool none_is_near = found.near_is_found.load(std::memory_order_acquire) &&
                            found.near != nullptr && found.near->touching() == 0;
  if (none_is_near) return;
  const std::shared_ptr<const TouchingPlanes> touching = found.find_touching();
  if (touching->touching() == 0) return;
  if (found.polygons_of_items) {
    found.polygons_of_items(*this, found.polygons);
  } else {
    found.polygons = entered_of_item_;
  }
  found.item_of.clear();
  for (Item item = 0; item < items(); ++item) {
    const std::uint32_t polygon = found.polygons[item];
    if (polygon == kNotEntered) continue;
    if (polygon >= found.item_of.size()) found.item_of.resize(std::size_t{polygon} + 1, kNone);
    found.item_of[polygon] = item;
  }
  const auto look = [this](Item item) { return look_of(item); };
  const bool are_fills = fill_item_.empty() && fills_ == items();  // none is edge-on
  for (std::size_t k = 0; k < touching->shared_planes(); ++k) {
    const auto members = touching->members(k);
    found.in_plane.clear();
    for (const std::uint32_t polygon : members) {
      if (polygon >= found.item_of.size() || found.item_of[polygon] == kNone) continue;
      const Item item = found.item_of[polygon];
      if (are_fills || !is_edge_on(item)) found.in_plane.push_back(item);
    }
    if (found.in_plane.empty()) continue;
    found.founders.resize(items(), kNotEntered);
    found.elsewhere.resize(items(), 0);
    for (const Item item : found.in_plane) {
      found.founders[item] = members.front();
      found.elsewhere[item] = found.polygons[item] == members.front() ? 0 : 1;
    }
    if (looks_.size() > 1) std::ranges::stable_sort(found.in_plane, {}, look);
    const std::uint32_t founder =
        members.front() < found.item_of.size() ? found.item_of[members.front()] : kNone;
    for (std::size_t first = 0, end = 0; first < found.in_plane.size(); first = end) {
      while (end < found.in_plane.size() &&
             look(found.in_plane[end]) == look(found.in_plane[first])) {
        ++end;
      }
      share_plane(std::span(found.in_plane).subspan(first, end - first), founder, found);
    }
  }
}

namespace {

/// Where a plane is so steep rounding decides how it lies; far from the polygon that it was taken
/// from it would be anywhere.
bool is_nearly_edge_on(const Plane& plane) {
  constexpr double kSteepest = 0x1p20;
  const Point3 normal = glm::abs(plane.normal);
  return !(std::max(normal.x, normal.y) <= kSteepest * normal.z);
}

}  // namespace

/// Several polygons of a plane are viewed alike, none of them edge-on: the one whose plane it is as
/// entered stands for it; or else, if that is not in the scene or little of it, from which the
/// plane would be known badly elsewhere, the one that is seen largest.
void ViewedScene::share_plane(std::span<const std::uint32_t> in_plane, std::uint32_t founder,
                              Planes& found) const {
  if (in_plane.size() < 2) return;
  const auto area = [&](Item item) {
    constexpr double kOfFounder = 16.0;
    return std::abs(newell_c(points(item))) * (item == founder ? kOfFounder : 1.0);
  };
  Item largest = in_plane.front();
  double most = area(largest);
  for (const Item item : in_plane.subspan(1)) {
    const double here = area(item);
    if (!(here > most)) continue;
    largest = item;
    most = here;
  }
  const PointRow vertices = points(largest);
  const auto index = support_vertices({vertices.data(), vertices.size()}).index;
  Primitives::PlanePoints plane;
  for (std::size_t k = 0; k < 3; ++k) plane[k] = point_number(items_[largest].first + index[k]);
  if (is_nearly_edge_on({points_[plane[0]], points_[plane[1]], points_[plane[2]]})) return;
  if (found.of_items.empty()) found.of_items.resize(items(), {Primitives::kOwnPlane, 0, 0});
  for (const Item item : in_plane) {
    found.of_items[item] = plane;
    if (largest == founder) found.elsewhere[item] = 0;
  }
}

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
  // Numbers that items have of what is stored apart, up to the last item that has one.
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

/// Those of another scene, of the same palette, whose items are to come from that one on.
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

/// That of the first source that is viewed like it.
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

/// The arrays have their final places.
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
    planes_ = std::make_shared<Planes>();
    planes_->polygon_of = polygon_of;
    planes_->entered_reach = polygons.reach();
    planes_->find_touching = [polygons] {
      return std::make_shared<const TouchingPlanes>(polygons.planes());
    };
    planes_->find_near = [polygons] { return polygons.near_planes(); };
    find_radius(*planes_);
  }
  if (!edge_visible_.empty()) edge_visible_.resize(points_.size(), 1);
}

void ViewedScene::find_entered(const std::function<EnteredPolygon(std::uint32_t)>& polygon_of) {
  as_entered_ = std::make_shared<AsEntered>();
  as_entered_->polygon_of = polygon_of;
  for (const Source& source : sources_) {
    const EnteredPolygons* const kept = source.instructions->as_entered();
    as_entered_->volumes.push_back(kept == nullptr ? nullptr : &kept->volume());
    as_entered_->images.push_back(&source.image);
    if (kept == nullptr) continue;
    const double radius =
        radius_in(kept->volume().matrix(), kept->largest_in_world(), 0.0, largest_depth_);
    as_entered_->radius = std::max(as_entered_->radius, radius * longest_of(source.image));
  }
}

/// The number of the item's polygon among those entered, or kNotEntered.
std::uint32_t ViewedScene::entered_number(Item item) const {
  if (!as_entered_->polygons_of_items) return entered_of_item_[item];
  if (!as_entered_->are_found.load(std::memory_order_acquire)) {
    const std::lock_guard in_turn(as_entered_->in_turn);
    if (!as_entered_->are_found.load(std::memory_order_relaxed)) {
      as_entered_->polygons_of_items(*this, as_entered_->polygons);
      as_entered_->are_found.store(true, std::memory_order_release);
    }
  }
  return as_entered_->polygons[item];
}

/// That of the polygon whose plane the item's lies in.
std::uint32_t ViewedScene::entered_plane(Item item) const {
  planes();
  const bool shares =
      planes_ != nullptr && !planes_->founders.empty() && planes_->founders[item] != kNotEntered;
  return shares ? planes_->founders[item] : entered_number(item);
}

ViewedScene::EnteredItem ViewedScene::as_entered(Item item) const {
  if (viewing_radius() == 0.0) return {{std::span<const Point3>()}};
  return in_view_of(entered_number(item), item);
}

ViewedScene::EnteredItem ViewedScene::plane_as_entered(Item item) const {
  if (viewing_radius() == 0.0) return {{std::span<const Point3>()}};
  return in_view_of(entered_plane(item), item);
}

ViewedScene::EnteredItem ViewedScene::in_view_of(std::uint32_t number, Item item) const {
  if (number == kNotEntered) return {{std::span<const Point3>()}};
  const std::uint32_t look = look_of(item);
  const AsEntered& all = *as_entered_;
  return {all.polygon_of(number), all.own_volume ? &*all.own_volume : all.volumes[look],
          all.images[look]};
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
  for (const ViewedText& text : texts_) characters += text.characters.size();
  return characters + size(texts_) + size(own_points_) + size(corners_) + size(edge_visible_) +
         size(items_) + size(pick_) + size(colours_) + size(own_colours_) + size(lines_) +
         size(segments_) + many_sided_.bytes() + size(of_many_sided_) + size(fill_item_) +
         intensities_.bytes() + normals_.bytes() + size(lights_) + size(shadow_) + size(shadows_);
}

}  // namespace displayfile
