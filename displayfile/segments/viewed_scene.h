#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "clip/geometry/point_row.h"
#include "clip/view/view_volume.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/entered/vertex_values.h"
#include "displayfile/looks/style.h"
#include "displayfile/looks/vertex_shading.h"
#include "hidden/boxes/extents.h"
#include "hidden/exact/entered_polygon.h"
#include "hidden/exact/plane.h"
#include "hidden/primitives.h"
#include "hidden/touching/touching_planes.h"

namespace displayfile {

class DisplayFile;
class Segment;

/// A text of a viewed scene.
struct DeviceText {
  Point3 anchor;
  TextStyle style;
  LineStyle line;  ///< its colour is the text's
  std::string characters;
  int segment;        ///< name; 0: none
  double turn = 0.0;  ///< degrees counterclockwise, about the anchor
};

/// The scene that every method and device reads (displayfile/scenes.md): the polygons and lines of
/// a display file's visible segments, or of a retained scene in a new view
/// (displayfile/views/scene_viewer.h), in order of entry and in device coordinates after the image
/// transformations, with their styles, segments, pick identifiers and planes.
///
/// An item is a polygon or a line. Invisible items, hollow polygons and lines with line style none,
/// are omitted. Points are not copied for a single closed segment whose points are those of the
/// picture; those of a retained scene are shared.
///
/// A fill is a solid polygon that is not edge-on, since that would cover nothing. Fill 0 is the
/// background; others count from 1 in order of entry, so that of two fills the one entered later
/// has the larger number.
///
/// Texts hide nothing and are drawn after all else: they are no items.
///
/// Polygons that are coplanar as entered (hidden/touching/touching_planes.md) are coplanar here:
/// the plane of one of them is used for all.
class ViewedScene : public EndsAsEntered {
 public:
  using Item = std::uint32_t;
  using Fill = std::uint32_t;
  static constexpr Fill kBackground = 0;

  ViewedScene() = default;
  /// The visible segments in their present state. Here and below, coordinates are up to
  /// kCoordinateLimit; throws Error for more than 2^32 - 2 points.
  explicit ViewedScene(const DisplayFile& display_file);
  /// The segments in that order, visible or not.
  explicit ViewedScene(std::span<const Segment* const> segments);
  /// The instructions of one segment, which must not grow during the scene's lifetime. The scene
  /// then names no segments.
  ViewedScene(std::shared_ptr<const Instructions> entered, const ImageTransformation& image);

  ViewedScene(ViewedScene&&) = default;
  ViewedScene& operator=(ViewedScene&&) = default;
  ViewedScene(const ViewedScene&) = delete;
  ViewedScene& operator=(const ViewedScene&) = delete;

  /// True while the display file's visible segments are those of the scene.
  bool is_of(const DisplayFile& display_file) const;
  /// Scenes with the same number, not 0, are of one SceneViewer and differ only in colours, shading
  /// and shadows: items, points and fills are the same, at the same addresses.
  std::uint64_t geometry() const { return geometry_; }

  // ---- Items -----------------------------------------------------------------------------

  Primitives primitives() const {
    near_planes();
    return {points_,
            corners_,
            edge_visible_,
            items_,
            planes_where_they_coincide(),
            plane_rests(),
            surfaces_,
            touching_of_ends(),
            viewing_radius(),
            some_may_touch() ? this : nullptr};
  }
  /// Items in different views have no ends on each other's planes: they are compared in the
  /// picture.
  Places places(Item item, std::uint32_t corner, Item polygon) const override;
  /// As Primitives::planes. Found on first use, by any thread.
  std::span<const Primitives::PlanePoints> planes() const;
  /// As Primitives::plane_rests, for planes as entered so close to another that the rounding of
  /// viewing would decide where they intersect. Found on first use.
  std::span<const Point3> plane_rests() const;
  std::uint32_t items() const { return static_cast<std::uint32_t>(items_.size()); }
  Primitives::Kind kind(Item item) const { return items_[item].kind; }
  PointRow points(Item item) const {
    const auto [first, sides, kind] = items_[item];
    if (corners_.empty()) return points_.subspan(first, sides);
    return {points_, std::span(corners_).subspan(first, sides)};
  }
  /// True if the side that ends at this vertex of the item is drawn.
  bool edge_visible(Item item, std::size_t vertex) const { return side_kinds(item, vertex) != 0; }
  /// Its kinds; 0 if it is not drawn.
  LineKinds side_kinds(Item item, std::size_t vertex) const {
    return edge_visible_.empty() ? kDrawn : edge_visible_[items_[item].first + vertex];
  }
  /// Vertex data of a smoothly shaded polygon; empty for others.
  VertexShading shading(Item item) const {
    const std::uint32_t sides = items_[item].sides;
    const auto normals = normals_.of(item, sides);
    return {intensities_.of(item, sides), normals, normals.empty() ? nullptr : &light(item)};
  }
  /// As Primitives::visible: the drawn sides, visible ones of items with a line style.
  std::vector<std::uint8_t> drawn_sides() const;
  FillStyle fill_style(Item item) const;
  const Colour& fill_colour(Item item) const;  ///< of the fill of a solid polygon
  const LineStyle& line_style(Item item) const;
  /// The style of items from `first` on.
  template <class Style>
  struct Run {
    Item first;
    Style style;
  };
  /// The colour numbers of all fills, for sequential access.
  std::span<const Run<std::uint32_t>> fill_colours() const { return colours_; }
  /// Colours with smaller numbers are the same in every scene with the same palette.
  std::uint32_t palette_colours() const { return static_cast<std::uint32_t>(palette_.size()); }
  std::uint64_t palette() const { return palette_number_; }  ///< 0: none
  const Colour& colour(std::uint32_t number) const {
    return number < palette_.size() ? palette_[number] : own_colours_[number - palette_.size()];
  }
  /// The line styles of all items, in order; the first of them begins at item 0.
  std::span<const Run<LineStyle>> line_styles() const { return lines_; }
  std::span<const std::int32_t> picks() const { return pick_; }       ///< of the items
  std::int32_t pick_of_item(Item item) const { return pick_[item]; }  ///< -1: a line without one

  /// Segment names and first items. None if the scene names no segments.
  struct SegmentStart {
    int name;
    Item first;
  };
  std::span<const SegmentStart> segments() const { return segments_; }
  int segment_name(Item item) const;  ///< if the scene names segments

  // ---- Fills -----------------------------------------------------------------------------

  /// One past the last fill.
  Fill end() const { return fills_ + 1; }
  Item item_of(Fill fill) const { return fill_item_.empty() ? fill - 1 : fill_item_[fill - 1]; }
  PointRow vertices(Fill fill) const { return points(item_of(fill)); }
  /// The corners of a fill with three sides.
  std::array<const Point3*, 3> corners_of_triangle(Fill fill) const {
    const std::uint32_t first = items_[item_of(fill)].first;
    return {&point(first), &point(first + 1), &point(first + 2)};
  }
  std::uint32_t sides(Fill fill) const { return items_[item_of(fill)].sides; }
  /// Upper bound on the fills, and their corners, in any view of the same retained scene, for
  /// reserving capacity.
  std::size_t most_fills() const { return items_.capacity(); }
  /// The largest |z| of the fills' vertices.
  double largest_depth() const { return largest_depth_; }
  /// Bound, per coordinate, on the distance in the scene of points of one plane as entered, where
  /// polygons may touch. Coplanar fills are searched for where two are this close. 0 if nothing
  /// touches, or the planes are found.
  double touching_radius() const { return planes_ == nullptr ? 0.0 : planes_->radius; }
  /// Bound on the rounding of viewing, per coordinate except depth. 0 if the coordinates are as
  /// entered, if the entered ones are not kept (a dump), or if nothing is known from them.
  double viewing_radius() const { return as_entered_ == nullptr ? 0.0 : as_entered_->radius; }
  /// Largest distance of boundaries from those as entered, along x and y: a vertex is off by
  /// viewing_radius, and a clipped one lies close to its side.
  double boundary_error() const { return 8.0 * viewing_radius(); }
  /// An item's polygon as entered, and its view.
  struct EnteredItem {
    EnteredPolygon polygon;
    const ViewVolume* volume = nullptr;
    const ImageTransformation* image = nullptr;
    bool is_known() const { return polygon.points.size() >= 3; }
  };
  /// Without points if unknown: in scenes without viewing_radius. Lines have two.
  EnteredItem as_entered(Item item) const;
  /// The polygon in whose plane the item's lies as entered: its own if it shares none.
  EnteredItem plane_as_entered(Item item) const;
  /// A number of the item's view, equal for items in the same view.
  std::uint32_t look_of(Item item) const;
  /// The viewport to which the item was clipped, with the window's borders; the whole picture if
  /// unknown, as after an image transformation.
  Rectangle viewport_of(Item item) const;
  /// Primitives::touching.
  double touching_of_ends() const { return planes_ == nullptr ? 0.0 : planes_->radius_of_ends; }
  /// Bound, per coordinate, on the distance of points of a fill's plane as entered from the fill's
  /// own plane, if small; planes farther away are plane_is_elsewhere.
  double plane_radius() const {
    const bool has_little = planes_ != nullptr && planes_->are_close;
    return std::max({viewing_radius(), touching_radius(), has_little ? touching_of_ends() : 0.0});
  }
  /// True if the item's polygon lies in another's plane as entered, and neither its own plane nor
  /// shared_plane is close to that one.
  bool plane_is_elsewhere(Item item) const {
    if (planes_ == nullptr || planes_->are_close) return false;
    planes();
    return !planes_->elsewhere.empty() && planes_->elsewhere[item] != 0;
  }
  /// True if the item's polygon lies in another's plane as entered and may be far from it, because
  /// the reach is not small compared with the picture.
  bool is_off_its_plane(Item item) const {
    if (planes_ == nullptr || planes_->are_close) return false;
    planes();
    return !planes_->founders.empty() && planes_->founders[item] != kNotEntered;
  }
  /// The rests of the points' depths are rounded.
  Plane plane_through(const Primitives::PlanePoints& plane) const {
    const Point3 &p = points_[plane[0]], &q = points_[plane[1]], &r = points_[plane[2]];
    const Point3* const rest = rest_of_bent(plane);
    if (rest == nullptr) return {p, q, r};
    return {p + Point3(0, 0, rest->x), q + Point3(0, 0, rest->y), r + Point3(0, 0, rest->z)};
  }
  /// The plane that the fill shares with others as entered, equal for all of these, or its own
  /// plane.
  Plane plane_in_common(Fill fill) const {
    const auto* const shared = shared_plane(item_of(fill));
    return shared != nullptr ? plane_through(*shared) : plane(fill);
  }
  /// The plane through the support vertices, which are not collinear: those of the item
  /// (interp/truth/truth.md), or of the polygon as entered if that is bent.
  Plane plane(Fill fill) const {
    const Item item = item_of(fill);
    if (const auto* const of_bent = plane_of_bent(item)) return plane_through(*of_bent);
    const std::uint32_t first = items_[item].first;
    if (items_[item].sides == 3) return {point(first), point(first + 1), point(first + 2)};
    const auto& [p, q, r] = of_many_sided_[many_sided_[item]].support;
    return {point(first + p), point(first + q), point(first + r)};
  }
  /// The plane that the item's polygon shares with others as entered; null: none.
  const Primitives::PlanePoints* shared_plane(Item item) const {
    const auto all = planes();
    return all.empty() || all[item][0] == Primitives::kOwnPlane ? nullptr : &all[item];
  }
  /// The plane of an item whose polygon is not planar as entered (hidden/exact/entered_plane.h),
  /// which may be far from that of other vertices; null for all others.
  const Primitives::PlanePoints* plane_of_bent(Item item) const {
    if (bent_.empty()) [[likely]]
      return nullptr;
    const auto at = std::ranges::lower_bound(bent_, item, {}, &Bent::item);
    return at != bent_.end() && at->item == item ? &at->plane : nullptr;
  }
  /// True if they are coplanar as entered.
  bool are_in_one_plane(Fill a, Fill b) const {
    if (planes_ == nullptr || is_certainly_apart(item_of(a), item_of(b))) return false;
    const auto *of_a = shared_plane(item_of(a)), *of_b = shared_plane(item_of(b));
    return of_a != nullptr && of_b != nullptr && *of_a == *of_b;
  }
  /// The total number of corners of polygons with more than three sides; and of those before such a
  /// fill.
  std::uint32_t many_sided_corners() const { return many_sided_corners_; }
  std::uint32_t many_sided_corners_before(Fill fill) const {
    return of_many_sided_[many_sided_[item_of(fill)]].corners_before;
  }
  std::int32_t pick(Fill fill) const {  ///< -1: the background
    return fill == kBackground ? -1 : pick_[item_of(fill)];
  }
  bool has_shades() const {
    return !intensities_.empty() || !normals_.empty();
  }                                                       ///< a polygon is shaded
  bool has_shadows() const { return !shadows_.empty(); }  ///< a fill shows shadows
  /// The shadow of a fill other than the background; null if it shows none.
  const FillShadow* shadow(Fill fill) const { return shadow_of_item(item_of(fill)); }
  /// Null if the item's fill shows no shadow.
  const FillShadow* shadow_of_item(Item item) const {
    return item >= shadow_.size() || shadow_[item] == kNone ? nullptr : &shadows_[shadow_[item]];
  }

  const std::vector<DeviceText>& texts() const { return texts_; }  ///< in order of entry
  const std::vector<KeptAnnotation>& annotations() const { return annotations_; }  ///< likewise

  bool has_lines() const { return has_lines_; }  ///< or polygons with visible edges
  std::size_t bytes() const;                     ///< of the scene's own arrays, as used

 private:
  friend class SceneViewer;
  struct Collector;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  /// The attributes with which an item is drawn.
  struct Look {
    const FillStyle& fill;
    const LineStyle& line;
    std::int32_t pick;
    std::uint32_t colour = kNone;  ///< the fill colour's number, if in the palette
    bool same_fill = false;        ///< as the fill added last
    bool same_line = false;        ///< as the item added last
    bool is_outlined() const { return line.kind != LineStyle::Kind::none; }
    bool shows() const { return fill.kind == FillStyle::Kind::solid || is_outlined(); }
  };
  /// The segments of which the scene was made.
  struct Source {
    std::shared_ptr<const Instructions> instructions;
    ImageTransformation image;
    std::size_t codes;
  };

  static constexpr std::uint32_t kNotEntered = kNone;
  /// The planes of the items, found on first use.
  struct Planes {
    std::function<std::shared_ptr<const TouchingPlanes>()> find_touching;
    /// As PolygonsAsEntered::near_planes.
    std::function<std::shared_ptr<const TouchingPlanes>(const TouchingPlanes&)> find_near;
    /// Writes the index of each item's polygon among those entered; if empty they are
    /// entered_of_item_.
    std::function<void(const ViewedScene&, std::vector<std::uint32_t>&)> polygons_of_items;
    /// A polygon as entered, by index; empty if unavailable.
    TouchingPlanes::PolygonOf polygon_of;
    /// The index of the polygon with this first corner, or kNotEntered if unavailable; if empty
    /// they are entered_of_item_.
    std::function<std::uint32_t(std::uint32_t)> polygon_of_item;
    double entered_reach = 0.0;  ///< before modelling transformations, the largest
    double reach = 0.0;          ///< in world coordinates, the largest
    double radius = 0.0;         ///< touching_radius
    double radius_of_ends = 0.0;
    bool compares_ends = false;  ///< may_reach in a view
    bool are_close =
        false;  ///< a polygon in another's plane is little off it: radius_of_ends, or 0
    std::mutex in_turn;
    std::atomic<bool> are_found = false;
    std::mutex near_in_turn;
    std::atomic<bool> near_is_found = false;
    std::shared_ptr<const TouchingPlanes> touching;  ///< members only, once found
    std::shared_ptr<const TouchingPlanes> near;
    std::mutex coincident_in_turn;
    std::atomic<bool> coincident_are_found = false;
    std::vector<Primitives::PlanePoints> coincident;  ///< as of_items, if some are bent
    std::mutex rests_in_turn;
    std::atomic<bool> rests_are_found = false;
    std::vector<Point3> rests;                      ///< empty: none
    std::vector<Primitives::PlanePoints> of_items;  ///< empty: none are coplanar
    /// For each item the polygon, as entered, in whose plane it lies; kNotEntered if it shares
    /// none. Empty if all are so.
    std::vector<std::uint32_t> founders;
    std::vector<std::uint8_t> elsewhere;     ///< per item: that polygon's plane is not used
    std::vector<std::uint8_t> are_founders;  ///< per item: their planes' points are its own
    std::vector<std::uint32_t> polygons, item_of, in_plane;  // memory of find_planes
  };
  /// The entered data of all items.
  struct AsEntered {
    double radius = 0.0;  ///< viewing_radius
    std::function<EnteredPolygon(std::uint32_t)> polygon_of;
    /// As in Planes.
    std::function<void(const ViewedScene&, std::vector<std::uint32_t>&)> polygons_of_items;
    /// By look; a single volume is that of all.
    std::vector<const ViewVolume*> volumes;
    std::vector<const ImageTransformation*> images;
    std::optional<ViewVolume> own_volume;
    std::mutex in_turn;
    std::atomic<bool> are_found = false;
    std::vector<std::uint32_t> polygons;  // of the items, once polygons_of_items was called
  };
  bool is_certainly_apart(Item a, Item b) const;
  /// Bounds the error of world coordinates: the largest sum of the products that make one, and the
  /// error in units of 2^-53 of it.
  struct InWorld {
    double largest = 0.0, roundings = kRoundingsInWorld;
  };
  static InWorld in_world(const EnteredPolygons& kept);
  /// The largest error of a plane's points per coordinate, as entered within the reach and viewed;
  /// from the view's matrix and bounds of world coordinates and the reach.
  static double radius_in(const glm::dmat4& view, const InWorld& in_world, double reach,
                          double largest_depth);
  static double small_radius(double radius);
  /// True if ends of lines may lie on planes: not if coordinates are so large that everything in
  /// the window would touch, unless that length was set.
  static bool may_reach(double reach, const Touching& touching, const ViewVolume& volume);
  void set_radius(Planes& planes, double of_planes, bool are_looked_for) const;
  static double longest_of(const ImageTransformation& image);
  void find_radius(Planes& planes) const;
  EnteredItem in_view_of(std::uint32_t polygon, Item item) const;
  bool some_may_touch() const {
    return planes_ != nullptr && as_entered_ != nullptr && planes_->compares_ends;
  }
  std::uint32_t entered_number(Item item) const;
  std::uint32_t entered_plane(Item item) const;
  /// An item whose polygon is not planar as entered.
  struct Bent {
    Item item;
    Primitives::PlanePoints plane;
  };
  struct EnteredLine;
  std::optional<EnteredLine> entered_line(Item item, std::uint32_t corner) const;
  void find_entered(const std::function<EnteredPolygon(std::uint32_t)>& polygon_of);
  bool is_edge_on(Item item) const;
  bool is_certainly_seen(Item item) const;
  bool is_plane_edge_on(Item item) const;
  void find_bent(std::span<const std::uint32_t> polygons);
  std::optional<Bent> bent_item(Item item, std::uint32_t polygon);
  const Point3* rest_of_bent(const Primitives::PlanePoints& plane) const {
    if (rests_of_bent_.empty()) [[likely]]
      return nullptr;
    const auto at = rests_of_bent_.find(plane);
    return at == rests_of_bent_.end() ? nullptr : &at->second;
  }
  void find_planes(Planes& found) const;
  void find_shared_planes(Planes& found) const;
  const TouchingPlanes* near_planes() const;
  /// A polygon of a group near one plane.
  struct Together {
    Item item;
    std::uint32_t plane;  ///< the polygon whose plane it is
    Extent box;
  };
  template <class Visit>
  void visit_near_planes(const Visit& visit) const;
  bool lie_over_each_other(const Together& a, const Together& b) const;
  std::vector<std::uint8_t> find_close_planes() const;
  std::span<const Primitives::PlanePoints> planes_where_they_coincide() const;
  void unite_coincident(std::vector<Primitives::PlanePoints>& planes) const;
  bool do_planes_coincide(std::uint32_t a, std::uint32_t b) const;
  std::optional<Primitives::PlanePoints> plane_points(Item item) const;
  std::optional<Primitives::PlanePoints> own_plane_points(Item item) const;
  std::vector<Point3> find_rests() const;
  void share_plane(std::span<const std::uint32_t> in_plane, std::uint32_t founder,
                   Planes& found) const;
  std::uint32_t look_of_source(const EnteredPolygons& kept, const ImageTransformation& image) const;
  void collect(std::span<const Segment* const> segments);
  void collect(const std::shared_ptr<const Instructions>& entered, const ImageTransformation& image,
               bool in_place);
  std::uint32_t point_number(std::uint32_t corner) const {
    return corners_.empty() ? corner : corners_[corner];
  }
  const Point3& point(std::uint32_t corner) const { return points_[point_number(corner)]; }
  void finish(bool in_place);
  void add_item(const Primitives::Item& item, const Look& look);
  /// Adds a polygon that may be visible, with its first corner and vertices.
  void add_polygon(std::uint32_t first, std::span<const Point3> vertices, const Look& look,
                   const VertexShading& shading = {});
  void add_shading(const VertexShading& shading);  ///< for the next item
  const Light& light(Item item) const;             ///< for its normals
  /// The item added last is a fill.
  void add_fill() {
    const Item item = items() - 1;
    if (item != fills_) {
      number_fills();
      fill_item_.push_back(item);
    }
    ++fills_;
  }
  /// Sets the colour of items from the next one on.
  void begin_colour(std::uint32_t number) {
    if (colours_.empty() || colours_.back().style != number) colours_.push_back({items(), number});
  }
  /// The number of a colour outside of the palette.
  std::uint32_t number_of(const Colour& colour) {
    if (own_colours_.empty() || own_colours_.back() != colour) own_colours_.push_back(colour);
    return static_cast<std::uint32_t>(palette_.size() + own_colours_.size() - 1);
  }
  void number_fills();  ///< before the first item that is not a fill
  /// A solid triangle without drawn sides that is not edge-on; the caller updates largest_depth_.
  struct Triangle {
    std::uint32_t first;   ///< corner
    std::uint32_t colour;  ///< its number
    std::int32_t pick;
  };
  void add_triangle(const Triangle& triangle) {
    begin_colour(triangle.colour);
    draw_no_lines();
    items_.push_back({triangle.first, 3, Primitives::Kind::solid});
    pick_.push_back(triangle.pick);
    add_fill();
  }
  /// The same for several, triangle(k) for each bit k, in less time.
  template <class TriangleOf>
  void add_triangles(std::uint64_t bits, TriangleOf&& triangle) {
    if (bits == 0) return;
    draw_no_lines();
    Item item = items();
    const bool numbered = item != fills_ || !fill_item_.empty();
    const auto more = static_cast<std::size_t>(std::popcount(bits));
    items_.resize(item + more);
    pick_.resize(item + more);
    for (; bits != 0; bits &= bits - 1, ++item) {
      const Triangle next = triangle(std::countr_zero(bits));
      if (colours_.empty() || colours_.back().style != next.colour) {
        colours_.push_back({item, next.colour});
      }
      items_[item] = {next.first, 3, Primitives::Kind::solid};
      pick_[item] = next.pick;
    }
    if (numbered) {
      number_fills();
      for (Item k = item - static_cast<Item>(more); k < item; ++k) fill_item_.push_back(k);
    }
    fills_ += static_cast<Fill>(more);
  }
  void draw_no_lines() {  ///< for the items that follow
    if (lines_.empty() || lines_.back().style.kind != LineStyle::Kind::none) {
      lines_.push_back({items(), {LineStyle::Kind::none}});
    }
  }
  void clear();  ///< except points and corners
  /// Appends the items of another scene. Its items' corners up to `corners` are those of this
  /// scene, later ones are its own points in order; these are appended to the own points here, the
  /// first `points` of which belong to those corners.
  void append(const ViewedScene& part, std::size_t corners, std::size_t points);
  void append_colours(const ViewedScene& part, Item first_item);
  /// Sets the sides of the next polygon, with this first corner; by default all are drawn.
  void note_edges(std::size_t first, std::span<const std::uint8_t> visible);
  /// The same by codes: op::line for drawn sides.
  void note_sides(std::size_t first, std::span<const std::int32_t> codes);

  std::vector<Source> sources_;
  /// The index of each item's polygon or line among those entered, or kNotEntered; for a scene in a
  /// new view only for items with own points.
  std::vector<std::uint32_t> entered_of_item_;
  std::uint32_t entered_polygons_ = 0;  // and lines, of all sources
  /// Numbers of the items' views, viewports and images.
  std::vector<Run<std::uint32_t>> looks_;
  std::shared_ptr<Planes> planes_;  // null: nothing touches
  std::shared_ptr<AsEntered> as_entered_;
  std::span<const Point3> points_;  // the source's own, or else own_points_
  std::vector<Point3> own_points_;
  std::vector<std::uint32_t> corners_;      // their points; empty: the points in order
  std::vector<std::uint8_t> edge_visible_;  // kinds, or 0; empty: all are kDrawn
  std::vector<Primitives::Item> items_;
  std::vector<std::int32_t> pick_;  // of the items
  // Colour numbers begin with the palette, which a retained scene has for all its views.
  std::vector<Run<std::uint32_t>> colours_;  // of the items' fills
  std::span<const Colour> palette_;
  std::uint64_t palette_number_ = 0;
  std::vector<Colour> own_colours_;
  std::vector<Run<LineStyle>> lines_;  // of the items' lines or edges
  std::vector<SegmentStart> segments_;
  std::vector<DeviceText> texts_;
  std::vector<KeptAnnotation> annotations_;
  std::vector<SurfaceMark> surfaces_;  // of the segments, as viewed
  ItemRanks many_sided_;               // polygons of more than three sides
  struct ManySided {
    std::array<std::uint32_t, 3> support;
    std::uint32_t corners_before;  // of those before it
  };
  std::vector<ManySided> of_many_sided_;
  std::uint32_t many_sided_corners_ = 0;                     // of all of them
  std::vector<Bent> bent_;                                   // rising
  std::map<Primitives::PlanePoints, Point3> rests_of_bent_;  // rests of their planes
  std::uint32_t fills_ = 0;
  std::vector<Item> fill_item_;  // empty while every item is a fill
  VertexValues<double> intensities_;
  VertexValues<Point3> normals_;
  std::vector<Run<Light>> lights_;     // of the items that have normals
  std::vector<std::uint32_t> shadow_;  // per item, an index into shadows_ or kNone
  std::vector<FillShadow> shadows_;
  bool has_lines_ = false;
  double largest_depth_ = 0.0;
  std::uint64_t geometry_ = 0;
};

}  // namespace displayfile
