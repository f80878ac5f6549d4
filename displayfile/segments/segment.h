#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "clip/surfaces.h"
#include "clip/view/transformation.h"
#include "displayfile/entered/instructions.h"
#include "displayfile/looks/style.h"
#include "displayfile/segments/sorted_scene.h"

namespace displayfile {

/// One segment: a name, attributes, and its own instruction arrays, so that it is edited or deleted
/// without touching another segment's storage.
///
/// It keeps its instructions as entered and, if its hidden surfaces were sorted, also back to
/// front. The sorted order is drawn, if there is one; the truth and the z-buffers, which need whole
/// polygons in order of entry, use the entered one.
///
/// Points are normalised device coordinates before the image transformation. Copies of a closed
/// segment share their instructions.
class Segment {
 public:
  explicit Segment(int name) : name_(name), entered_(std::make_shared<Instructions>()) {}
  Segment(const Segment& other);
  Segment& operator=(const Segment& other);
  Segment(Segment&&) = default;
  Segment& operator=(Segment&&) = default;

  int name() const { return name_; }
  void rename(int name) { name_ = name; }
  /// Characters that can be drawn; empty: none.
  const std::string& title() const { return title_; }
  void set_title(std::string_view title) { title_ = title; }

  bool visible = true;
  ImageTransformation image;
  /// The sort that close-segment postponed because all segments were to be sorted together, in case
  /// they are not.
  std::optional<SurfacePlan> put_off;

  // Entering instructions (displayfile/entered/instructions.h) drops a sorted order.
  void set_style(const FillStyle& fill) { writable().set_style(fill); }
  void set_style(const LineStyle& line) { writable().set_style(line); }
  void set_style(const TextStyle& text) { writable().set_style(text); }
  void set_pick(std::int32_t id) { writable().set_pick(id); }
  void set_line_pick(std::int32_t id) { writable().set_line_pick(id); }
  void enter_line(const Point3& from, const Point3& to) { writable().enter_line(from, to); }
  void enter_polygon(std::span<const Point3> vertices, std::span<const std::uint8_t> edge_visible,
                     const VertexShading& shading = {}) {
    writable().enter_polygon(vertices, edge_visible, shading);
  }
  void enter_text(const Point3& anchor, std::string_view characters) {
    writable().enter_text(anchor, characters);
  }
  void enter_annotation(KeptAnnotation annotation) {
    writable().enter_annotation(std::move(annotation));
  }
  void mark_surface(const SurfaceMark& mark) { writable().mark_surface(mark); }
  template <class PointAt, class IsDrawn>
  void enter_next_polygon(std::uint32_t n, const PointAt& point, const IsDrawn& is_drawn) {
    writable().enter_next_polygon(n, point, is_drawn);
  }
  /// Also keeps the polygons entered from now on as the application entered them
  /// (displayfile/entered/entered_polygons.h). Must be called before the first.
  void keep_entered(const Touching& touching, const ViewVolume& volume) {
    writable().keep_entered(touching, volume);
  }
  /// Must be called after each polygon; null if they are not kept.
  EnteredPolygons* keeping_entered() { return entered_->keeping_entered(); }
  /// The same; null also if the instructions are shared, as others may be reading them.
  EnteredPolygons* entered_alone() {
    return entered_.use_count() == 1 ? entered_->keeping_entered() : nullptr;
  }
  /// Reserves capacity for polygons, corners and fill styles in total.
  void reserve_polygons(std::size_t polygons, std::size_t corners, std::size_t fills) {
    constexpr std::size_t kOtherCodes = 3;  // the polygon's own, and a pick identifier
    writable().reserve_more(corners + kOtherCodes * polygons, corners, fills);
    if (EnteredPolygons* const kept = keeping_entered()) kept->reserve_more(polygons, corners);
  }
  /// Replaces all instructions by those of another segment.
  void take_instructions(Segment&& other) {
    entered_ = std::move(other.entered_);
    sorted_.reset();
  }
  /// Frees the capacity for more instructions.
  void free_room() { writable().free_room(); }
  /// After the last instruction: copies may share them from now on.
  void close() { closed_ = true; }
  bool is_closed() const { return closed_; }

  /// Closed segments with equal pointers have the same instructions.
  std::shared_ptr<const Instructions> entered() const { return entered_; }
  /// Null if the hidden surfaces were not sorted.
  const std::shared_ptr<const SortedScene>& sorted() const { return sorted_; }
  void set_sorted(std::shared_ptr<const SortedScene> sorted) { sorted_ = std::move(sorted); }
  /// True if it was sorted with its present image transformation.
  bool sorted_as_drawn() const { return sorted_ != nullptr && sorted_->image == image; }

  /// Calls the visitor for each instruction in drawing order, with points after the image
  /// transformation, as for drawing and dumps. An order found before an image transformation was
  /// set is kept; one found with another is not.
  template <class Visitor>
  void walk_drawn(Visitor&& visit) const {
    if (sorted_as_drawn()) return sorted_->walk(visit);
    if (sorted_ != nullptr && sorted_->image.is_identity()) {
      return sorted_->walk_transformed(image, visit);
    }
    entered_->walk_transformed(image, visit);
  }
  /// Walks the instructions in order of entry, with points as stored.
  template <class Visitor>
  void walk_entered(Visitor&& visit) const {
    entered_->walk(visit);
  }
  /// Walks the instructions in order of entry, with points after the image transformation, as for
  /// the truth.
  template <class Visitor>
  void walk_entered_drawn(Visitor&& visit) const {
    entered_->walk_transformed(image, visit);
  }

  // Contents of the entered instructions.
  std::size_t polygons() const { return entered_->polygons(); }
  std::size_t lines() const { return entered_->lines(); }
  bool stores_z() const { return entered_->stores_z(); }
  bool has_shadows() const { return entered_->has_shadows(); }
  bool shows() const { return entered_->shows(); }
  bool has_texts() const { return entered_->has_texts(); }
  bool has_annotations() const { return !entered_->annotations().empty(); }
  std::size_t bytes() const;  ///< of the instruction arrays of both orders, as used

 private:
  /// The instructions, copied if shared.
  Instructions& writable() {
    if (closed_ || sorted_ != nullptr) [[unlikely]]
      make_writable();
    return *entered_;
  }
  void make_writable();

  int name_;
  std::string title_;
  std::shared_ptr<Instructions> entered_;
  bool closed_ = false;
  std::shared_ptr<const SortedScene> sorted_;
};

}  // namespace displayfile
