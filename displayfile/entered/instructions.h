#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "clip/surfaces.h"
#include "clip/view/transformation.h"
#include "displayfile/entered/entered_polygons.h"
#include "displayfile/entered/kept_annotation.h"
#include "displayfile/looks/style.h"
#include "displayfile/looks/vertex_shading.h"
#include "hidden/surface_mark.h"

namespace displayfile {

/// Operation codes of display-file instructions. A code of 3 or more is the textbook's
/// polygon instruction: the number of sides, followed by that many moves (invisible
/// edges) and lines. The polygon starts at its last vertex, which is therefore not stored.
namespace op {
inline constexpr std::int32_t move = 1;
inline constexpr std::int32_t line = 2;
inline constexpr std::int32_t line_solid = -1;
inline constexpr std::int32_t line_dashed = -2;
inline constexpr std::int32_t line_none = -3;
/// The next code is the index of the styles of kinds of lines, in line styles that follow;
/// initially they have none.
inline constexpr std::int32_t line_kind_styles = -4;
inline constexpr std::int32_t fill_solid = -16;
inline constexpr std::int32_t fill_hollow = -17;
inline constexpr std::int32_t fill_shadowed = -18;  ///< solid, with a FillShadow
inline constexpr std::int32_t pick = -32;           ///< the next code is the pick identifier
/// The next code is the pick identifier of the polygon that follows; each later polygon has the
/// next identifier, until another is entered. So identifiers that are ordinals need no memory per
/// polygon.
inline constexpr std::int32_t pick_run = -33;
/// The next code is the pick identifier of lines that follow; initially they have none.
inline constexpr std::int32_t line_pick = -34;
inline constexpr std::int32_t intensities = -64;  ///< of the vertices of the polygon that follows
/// Line kinds of the sides of the polygon that follows; precede its intensities or normals.
inline constexpr std::int32_t side_kinds = -65;
inline constexpr std::int32_t normals = -66;  ///< of the vertices of the polygon that follows
inline constexpr std::int32_t light = -67;    ///< the light for normals from here on
inline constexpr std::int32_t text = -128;    ///< its anchor and characters are stored separately
/// The next code is the alignment; bit 2: the text is always visible.
inline constexpr std::int32_t text_style = -129;
inline constexpr std::int32_t text_always = 4;
/// True for codes that directly precede a smoothly shaded polygon.
inline constexpr bool is_of_vertices(std::int32_t code) {
  return code == intensities || code == normals;
}
}  // namespace op

/// Display-file instructions in separate arrays, in order of entry. While all points have one depth
/// only x and y are stored; z is added when first needed.
class Instructions {
 public:
  /// Styles, and before a polygon the pick identifier, are entered only when they differ from those
  /// in force; initially none are in force.
  void set_style(const FillStyle& fill);
  void set_style(const LineStyle& line);
  void set_style(const TextStyle& text);
  void set_pick(std::int32_t id) { pick_ = id; }
  void set_line_pick(std::int32_t id) { line_pick_ = id; }  ///< of lines; -1: none
  void enter_line(const Point3& from,
                  const Point3& to);  ///< preceded by a move if the pen is elsewhere
  /// At least 3 vertices; edge_visible refers to the edge that ends at the vertex: 0 if it is not
  /// drawn, otherwise its line kinds.
  void enter_polygon(std::span<const Point3> vertices, std::span<const std::uint8_t> edge_visible,
                     const VertexShading& shading = {});

  /// Also keeps the following polygons as the application entered them: the caller enters each
  /// polygon, with or without an instruction, into the returned object.
  EnteredPolygons& keep_entered(const Touching& touching, const ViewVolume& volume) {
    return as_entered_.emplace(touching, volume);
  }
  EnteredPolygons* keeping_entered() { return as_entered_ ? &*as_entered_ : nullptr; }
  /// The polygons and lines as entered; null if they are not kept for each one.
  const EnteredPolygons* as_entered() const {
    const bool is_of_each =
        as_entered_ && as_entered_->seen() == polygons_ && as_entered_->lines() == lines_;
    return is_of_each && !as_entered_->are_as_viewed() ? &*as_entered_ : nullptr;
  }

  /// The next polygons are a surface's cells, if all of it is inside of the view.
  void mark_surface(const SurfaceMark& mark) { surfaces_.push_back(mark); }
  std::span<const SurfaceMark> surfaces() const { return surfaces_; }

  /// A text at a point: drawable UTF-8 (displayfile/text/characters.h). The pen does not move.
  void enter_text(const Point3& anchor, std::string_view characters);
  /// Annotation is separate from the other instructions and follows them in a walk.
  void enter_annotation(KeptAnnotation annotation) {
    annotations_.push_back(std::move(annotation));
  }
  std::span<const KeptAnnotation> annotations() const { return annotations_; }

  /// Enters a planar polygon of n sides with vertices point(i); the side that ends at vertex i is
  /// drawn if is_drawn(i). Fast for successive polygons with z.
  template <class PointAt, class IsDrawn>
  void enter_next_polygon(std::uint32_t n, const PointAt& point, const IsDrawn& is_drawn) {
    if (!stores_z_) {
      std::vector<Point3> vertices(n);
      std::vector<std::uint8_t> drawn(n);
      for (std::uint32_t i = 0; i < n; ++i) {
        vertices[i] = point(i);
        drawn[i] = is_drawn(i) ? 1 : 0;
      }
      return enter_polygon(vertices, drawn);
    }
    if (stored_picks_.in_run && pick_ == stored_picks_.next) {
      last_pick_ = stored_picks_.take();
      last_pick_repeats_ = false;
    } else {
      enter_pick();
    }
    op_.push_back(static_cast<std::int32_t>(n));
    for (std::uint32_t i = 0; i < n; ++i) {
      op_.push_back(is_drawn(i) ? op::line : op::move);
      points_.push_back(point(i));
    }
    pen_ = points_.back();
    ++polygons_;
  }

  /// Calls the visitor for each instruction in order, with points as stored:
  ///   fill(FillStyle), line_style(LineStyle), pick(int), move(Point3), line(Point3),
  ///   polygon(span<const Point3> vertices, span<const int32_t> sides) - sides holds op::line
  ///   or op::move for the edge that ends at the vertex of the same index - and, if the visitor
  ///   has them, before a shaded polygon intensities(span<const double>) or
  ///   normals(span<const Point3>, const Light&), and before a polygon with known line kinds
  ///   side_kinds(span<const LineKinds>), one per side, 0 for sides that are not drawn;
  ///   all these spans stay until the walk is over; line_pick(int), of the lines
  ///   that follow, and text_style(TextStyle), text(Point3 anchor, string_view), in the colour of
  ///   the line style. A text does not move the pen. Last, annotation(const KeptAnnotation&).
  template <class Visitor>
  void walk(Visitor&& visit) const;

  /// Calls the visitor as walk does, with points after an image transformation.
  template <class Visitor>
  void walk_transformed(const ImageTransformation& image, Visitor&& visit) const;

  std::size_t polygons() const { return polygons_; }
  std::size_t lines() const { return lines_; }
  bool has_texts() const { return !texts_.empty(); }
  std::string_view characters() const { return characters_; }  ///< of all texts
  std::size_t codes() const { return op_.size(); }
  std::size_t points() const { return points_.size() + flat_points_.size(); }
  bool stores_z() const { return stores_z_; }
  /// The depth of all points, where z is not stored; 0 if there are none.
  double flat_depth() const { return flat_z_; }
  bool has_shadows() const { return has_shadows_; }  ///< a fill shows shadows
  /// All points in order of entry: for a line its end, always preceded by its start; for a polygon
  /// its vertices. Empty unless z is stored.
  std::span<const Point3> stored_points() const { return points_; }
  /// The intensities of the vertices of all shaded polygons, in order of entry.
  std::span<const double> stored_intensities() const { return intensities_; }
  /// The vertex normals of all polygons with Phong shading.
  std::span<const Point3> stored_normals() const { return normals_; }
  /// False if nothing is visible: no instructions, or all hollow with line style none. Stops at the
  /// first visible style.
  bool shows() const;
  std::size_t bytes() const;  ///< of the instruction arrays, as used
  /// Reserves capacity for more codes, points and solid fill styles.
  void reserve_more(std::size_t codes, std::size_t points, std::size_t fills);
  void free_room();  ///< after the last instruction

 private:
  template <class Visitor>
  static void visit_side_kinds(Visitor& visit, std::span<const LineKinds> of_sides) {
    if constexpr (requires { visit.side_kinds(of_sides); }) visit.side_kinds(of_sides);
  }
  template <class Visitor>
  static void visit_line_pick(Visitor& visit, std::int32_t id) {
    if constexpr (requires { visit.line_pick(id); }) visit.line_pick(id);
  }
  /// Texts' points are stored separately from the others.
  struct TextAt {
    Point3 anchor;
    std::size_t end;  ///< of its characters
  };
  template <class Visitor>
  static constexpr bool kTakesTexts = requires(Visitor& visit, const TextStyle& style) {
    visit.text_style(style);
    visit.text(Point3(), std::string_view());
  };
  /// State of pick identifiers in a walk.
  struct Picks {
    bool in_run = false;
    std::int64_t next = 0;  ///< in a run
    std::int32_t take() { return static_cast<std::int32_t>(next++); }
  };
  void enter_pick();
  void enter_points(std::span<const Point3> points);
  void add_z();

  std::vector<std::int32_t> op_;
  std::vector<Point3> points_;       // if stores_z_
  std::vector<Point2> flat_points_;  // otherwise, all at depth flat_z_
  std::vector<double> style_operands_;
  std::vector<double> intensities_;
  std::vector<Point3> normals_;
  std::vector<LineKinds> side_kinds_;  // of the polygons that have them, one after another
  std::vector<LineKindStyles> line_kind_styles_;
  std::vector<TextAt> texts_;
  std::string characters_;  // of all texts
  std::vector<KeptAnnotation> annotations_;
  std::vector<SurfaceMark> surfaces_;
  std::optional<EnteredPolygons> as_entered_;
  double flat_z_ = 0.0;
  bool stores_z_ = false;
  std::size_t polygons_ = 0, lines_ = 0;
  bool has_shadows_ = false;

  std::optional<FillStyle> fill_;
  std::optional<LineStyle> line_;
  std::optional<TextStyle> text_style_;
  std::optional<Light> light_;
  std::optional<std::int32_t> pick_;  // of the next polygon
  std::optional<std::int32_t> last_pick_;
  bool last_pick_repeats_ = false;                     // the last two polygons have it
  Picks stored_picks_;                                 // a walk's state after the last polygon
  std::int32_t line_pick_ = -1, last_line_pick_ = -1;  // of the next line, and in force
  std::optional<Point3> pen_;                          // always the point entered last
};

template <class Visitor>
void Instructions::walk(Visitor&& visit) const {
  std::vector<Point3> with_z;  // of one polygon of a flat segment
  const Point3* next_point = points_.data();
  const Point2* next_flat = flat_points_.data();
  const double* operand = style_operands_.data();
  const double* next_intensity = intensities_.data();
  const Point3* next_normal = normals_.data();
  Light light{};
  const LineKinds* next_kinds = side_kinds_.data();
  LineKindStyles of_kinds;
  std::size_t next_text = 0;
  Picks picks;
  const auto take = [&](std::size_t n) -> std::span<const Point3> {
    if (stores_z_) {
      next_point += n;
      return {next_point - n, n};
    }
    with_z.clear();
    for (std::size_t i = 0; i < n; ++i) with_z.emplace_back(next_flat[i], flat_z_);
    next_flat += n;
    return with_z;
  };
  const auto take_colour = [&] {
    operand += 3;
    return Colour(operand[-3], operand[-2], operand[-1]);
  };
  for (std::size_t i = 0; i < op_.size(); ++i) {
    switch (op_[i]) {
      case op::move: visit.move(take(1)[0]); break;
      case op::line: visit.line(take(1)[0]); break;
      case op::line_solid:
      case op::line_dashed: {
        LineStyle style{op_[i] == op::line_solid ? LineStyle::Kind::solid : LineStyle::Kind::dashed,
                        take_colour(), *operand++};
        if (style.kind == LineStyle::Kind::dashed) {
          style.dash = *operand++;
          style.gap = *operand++;
        }
        style.of_kinds = of_kinds;
        visit.line_style(style);
        break;
      }
      case op::line_kind_styles:
        of_kinds = line_kind_styles_[static_cast<std::size_t>(op_[++i])];
        break;
      case op::line_none: visit.line_style(LineStyle{LineStyle::Kind::none}); break;
      case op::fill_solid: visit.fill(FillStyle{FillStyle::Kind::solid, take_colour()}); break;
      case op::fill_shadowed: {
        FillStyle style{FillStyle::Kind::solid, take_colour()};
        style.shadow = {take_colour(), {operand[0], operand[1], operand[2], operand[3]}};
        operand += 4;
        visit.fill(style);
        break;
      }
      case op::fill_hollow: visit.fill(FillStyle{FillStyle::Kind::hollow}); break;
      case op::pick: {
        const bool repeats = picks.in_run && op_[i + 1] == picks.next - 1;
        picks.in_run = false;
        if (!repeats) visit.pick(op_[i + 1]);
        ++i;
        break;
      }
      case op::pick_run: picks = {true, op_[++i]}; break;
      case op::line_pick: visit_line_pick(visit, op_[++i]); break;
      case op::intensities: {
        const auto sides = static_cast<std::size_t>(op_[i + 1]);
        if (picks.in_run) visit.pick(picks.take());
        visit_shading(visit, {.intensities = {next_intensity, sides}});
        next_intensity += sides;
        break;
      }
      case op::light: {
        light = {{operand[0], operand[1], operand[2]}, operand[3]};
        operand += 4;
        break;
      }
      case op::normals: {
        const auto sides = static_cast<std::size_t>(op_[i + 1]);
        if (picks.in_run) visit.pick(picks.take());
        visit_shading(visit, {.normals = {next_normal, sides}, .light = &light});
        next_normal += sides;
        break;
      }
      case op::side_kinds: {
        const std::size_t polygon = op::is_of_vertices(op_[i + 1]) ? i + 2 : i + 1;
        const auto sides = static_cast<std::size_t>(op_[polygon]);
        visit_side_kinds(visit, {next_kinds, sides});
        next_kinds += sides;
        break;
      }
      case op::text_style: {
        const std::int32_t code = op_[++i];
        const TextStyle style{*operand++, TextStyle::Alignment(code % op::text_always),
                              code >= op::text_always};
        if constexpr (kTakesTexts<std::remove_reference_t<Visitor>>) visit.text_style(style);
        break;
      }
      case op::text: {
        const std::size_t start = next_text > 0 ? texts_[next_text - 1].end : 0;
        const auto& [anchor, end] = texts_[next_text++];
        if constexpr (kTakesTexts<std::remove_reference_t<Visitor>>) {
          visit.text(anchor, std::string_view(characters_).substr(start, end - start));
        }
        break;
      }
      default: {
        const auto sides = static_cast<std::size_t>(op_[i]);
        if (picks.in_run && !op::is_of_vertices(op_[i - 1])) visit.pick(picks.take());
        visit.polygon(take(sides), std::span<const std::int32_t>(&op_[i + 1], sides));
        i += sides;
      }
    }
  }
  if constexpr (requires { visit.annotation(annotations_[0]); }) {
    for (const KeptAnnotation& annotation : annotations_) visit.annotation(annotation);
  }
}

/// Passes instructions to a visitor, with points and lights of shadows after an image
/// transformation.
template <class Visitor>
class TransformedVisitor {
 public:
  TransformedVisitor(Visitor& visit, const ImageTransformation& image)
      : visit_(visit), image_(image), matrix_(image) {}

  void fill(FillStyle s) {
    if (s.shadow) s.shadow->light = matrix_.apply(s.shadow->light);
    visit_.fill(s);
  }
  void line_style(const LineStyle& s) { visit_.line_style(s); }
  void pick(std::int32_t id) { visit_.pick(id); }
  void segment(int name) {
    if constexpr (requires { visit_.segment(name); }) visit_.segment(name);
  }
  void intensities(std::span<const double> values) {
    if constexpr (requires { visit_.intensities(values); }) visit_.intensities(values);
  }
  /// In world coordinates, which an image transformation does not change.
  void normals(std::span<const Point3> values, const Light& light) {
    if constexpr (requires { visit_.normals(values, light); }) visit_.normals(values, light);
  }
  void side_kinds(std::span<const LineKinds> kinds) {
    if constexpr (requires { visit_.side_kinds(kinds); }) visit_.side_kinds(kinds);
  }
  void disjoint_polygons(bool begin) {
    if constexpr (requires { visit_.disjoint_polygons(begin); }) visit_.disjoint_polygons(begin);
  }
  void line_kinds(LineKinds kinds) {
    if constexpr (requires { visit_.line_kinds(kinds); }) visit_.line_kinds(kinds);
  }
  void line_pick(std::int32_t id) {
    if constexpr (requires { visit_.line_pick(id); }) visit_.line_pick(id);
  }
  void line_cuts(LineCuts cuts) {
    if constexpr (requires { visit_.line_cuts(cuts); }) visit_.line_cuts(cuts);
  }
  void corner_cuts(std::span<const std::uint8_t> cuts) {
    if constexpr (requires { visit_.corner_cuts(cuts); }) visit_.corner_cuts(cuts);
  }
  bool is_crumb(const Point3& from, const Point3& to) const requires requires(const Visitor& v) {
    v.is_crumb(from, to);
  }
  { return visit_.is_crumb(matrix_.apply(from), matrix_.apply(to)); }
  void text_style(const TextStyle& s) {
    if constexpr (requires { visit_.text_style(s); }) visit_.text_style(s);
  }
  /// Only the anchor is transformed: letters keep their size and stay upright.
  void text(const Point3& anchor, std::string_view characters) {
    if constexpr (requires { visit_.text(anchor, characters); }) {
      visit_.text(matrix_.apply(anchor), characters);
    }
  }
  void annotation(const KeptAnnotation& annotation) {
    if constexpr (requires { visit_.annotation(annotation); }) {
      visit_.annotation(transformed(annotation, image_));
    }
  }
  void move(const Point3& p) { visit_.move(matrix_.apply(p)); }
  void line(const Point3& p) { visit_.line(matrix_.apply(p)); }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    moved_.clear();
    for (const Point3& p : vertices) moved_.push_back(matrix_.apply(p));
    visit_.polygon(moved_, sides);
  }

 private:
  Visitor& visit_;
  ImageTransformation image_;
  ImageMatrix matrix_;
  std::vector<Point3> moved_;
};

template <class Visitor>
void Instructions::walk_transformed(const ImageTransformation& image, Visitor&& visit) const {
  if (image.is_identity()) return walk(visit);
  walk(TransformedVisitor(visit, image));
}

/// The pick identifier of the polygon with this ordinal, from 0; it wraps to 0 after the largest
/// one.
constexpr std::int32_t pick_of_ordinal(std::int64_t ordinal) {
  return static_cast<std::int32_t>(ordinal & std::numeric_limits<std::int32_t>::max());
}

}  // namespace displayfile
