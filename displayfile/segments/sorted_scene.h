#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/surfaces.h"
#include "clip/view/transformation.h"
#include "displayfile/entered/normal_plane.h"
#include "displayfile/segments/clipped_ends.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/lines/strokes_once.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// Costs of a sort of hidden surfaces.
struct SortCounts {
  std::uint64_t pieces = 0;  ///< polygons and lines in the order, cut ones once per piece
  std::uint64_t cuts = 0;    ///< one piece in two
  std::uint64_t comparisons = 0;
  std::uint32_t depth = 0;  ///< maximum depth of a tree; 0: none

  SortCounts& operator+=(const SortCounts& other) {
    pieces += other.pieces;
    cuts += other.cuts;
    comparisons += other.comparisons;
    depth = std::max(depth, other.depth);
    return *this;
  }
};

/// A scene and the order that a sort found: its pieces, back to front.
struct OrderedScene {
  std::shared_ptr<const ViewedScene> scene;
  SortedPieces pieces;    ///< of the scene's items
  SurfacePlan plan = {};  ///< by which its strokes are drawn, without progress and budget

  /// Its strokes as drawn in a picture (displayfile/segments/drawn_strokes.h). Found on first use,
  /// by any thread.
  std::span<const StrokePart> strokes_of_picture() const;

  struct StrokesOfPicture {
    std::once_flag are_found;
    std::vector<StrokePart> parts;
  };
  std::shared_ptr<StrokesOfPicture> of_picture = std::make_shared<StrokesOfPicture>();
};

/// Result of the hidden-surface check of one segment, or of several together: scenes that hide
/// nothing of each other, each in order. It is not a second display file: instructions are
/// generated from the scenes on demand.
struct SortedScene {
  std::vector<std::shared_ptr<const OrderedScene>> parts;
  ImageTransformation image;  ///< already applied to the points of a single segment
  SurfacePlan plan;           ///< the plan by which they were sorted
  SortCounts counts;
  /// The largest distance of a boundary from that of the polygons as entered, beyond the rounding
  /// of a cut's coordinates: caused by viewing, including cuts made before it. Device coordinates.
  double boundary_error = 0.0;

  /// SAVE-POLYGONS-IN-ORDER (algorithm 9.16): calls the visitor for each instruction, back to
  /// front, as Instructions::walk does; styles, pick identifiers and segments where they change,
  /// and, if the visitor has them, line_kinds(LineKinds), line_pick(int) and line_cuts(LineCuts)
  /// for the lines that follow, initially kDrawn, -1 and none, with kHiddenLine for hidden ones;
  /// and corner_cuts(span<const uint8_t>) before a polygon with a cut drawn side: 1 for each corner
  /// at a cut. A visitor that draws a picture has is_crumb(Point3, Point3), which returns whether a
  /// stroke in the line style in force is shorter than its pen is wide: it gets strokes as drawn in
  /// pictures (OrderedScene::strokes_of_picture), without crumbs. disjoint_polygons(true), if the
  /// visitor has it, precedes the polygons of a map, which do not overlap, and
  /// disjoint_polygons(false) follows them: a segment named in between has then ended. Texts come
  /// last, then annotation. A fill with known shadows has its colour in light or in shadow, and no
  /// shadow.
  template <class Visitor>
  void walk(Visitor&& visit) const;
  /// Calls the visitor as walk does, with points after an image transformation.
  template <class Visitor>
  void walk_transformed(const ImageTransformation& moved, Visitor&& visit) const {
    if (moved.is_identity()) return walk(visit);
    walk(TransformedVisitor(visit, moved));
  }

  bool has_shadows() const;   ///< some fill shows them
  std::size_t bytes() const;  ///< of the scenes' own arrays and the orders, as used
};

/// State while pieces are made into instructions.
template <class Visitor>
class PieceWriter {
 public:
  explicit PieceWriter(Visitor& visit) : visit_(visit) {}

  void save_polygons_in_order(const OrderedScene& ordered) {
    save_pieces(ordered, 0, std::min(ordered.pieces.first_stroke, ordered.pieces.pieces.size()));
  }
  /// Sends lines that are drawn after all polygons.
  void save_strokes(const OrderedScene& ordered) {
    const std::size_t first = ordered.pieces.first_stroke;
    if (!kDrawsPicture && ordered.plan.line_order == LineOrder::entry) {
      return save_pieces(ordered, first, ordered.pieces.pieces.size());
    }
    for (const StrokePart& part : ordered.strokes_of_picture()) {
      part_ = part;
      save_piece(ordered, first + part.stroke);
    }
    part_ = kWholeStroke;
  }

  void save_pieces(const OrderedScene& ordered, std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) save_piece(ordered, k);
  }

  /// Makes the next instruction name its segment.
  void name_segment_again() { segment_ = 0; }

  /// For a visitor that takes annotation.
  void save_annotations(const ViewedScene& scene) {
    for (const KeptAnnotation& annotation : scene.annotations()) {
      if (annotation.segment != 0) check_segment(annotation.segment);
      visit_.annotation(annotation);
    }
  }
  /// For a visitor that takes texts.
  void save_texts(const ViewedScene& scene) {
    for (const DeviceText& text : scene.texts()) {
      if (text.segment != 0) check_segment(text.segment);
      check_line_style(text.line);
      if (!text_style_known_ || text_style_ != text.style) {
        text_style_known_ = true;
        text_style_ = text.style;
        visit_.text_style(text.style);
      }
      visit_.text(text.anchor, text.characters);
    }
  }

 private:
  using Lit = SortedPieces::Lit;
  static constexpr bool kDrawsPicture = requires(const Visitor& v) {
    v.is_crumb(Point3(), Point3());
  };
  static constexpr StrokePart kWholeStroke{0, 0.0, 1.0, false};

  void save_piece(const OrderedScene& ordered, std::size_t k) {
    ordered_ = &ordered;
    const SortedPiece& piece = ordered.pieces.pieces[k];
    is_hidden_ = ordered.pieces.is_hidden(k);
    is_stroke_ = ordered.pieces.is_stroke(k);
    light_ = ordered.pieces.light(k);
    if (!scene().segments().empty()) check_segment(scene().segment_name(piece.item));
    send_to_df(piece);
  }

  /// The item whose fill style is in force, and its light.
  struct StyledItem {
    const ViewedScene* scene = nullptr;
    ViewedScene::Item item = 0;
    Lit light = Lit::unknown;
    FillStyle style() const {
      FillStyle style = scene->fill_style(item);
      if (light == Lit::unknown || !style.shadow) return style;
      if (light == Lit::in_shadow) style.colour = style.shadow->colour;
      style.shadow = std::nullopt;
      return style;
    }
  };

  const ViewedScene& scene() const { return *ordered_->scene; }

  void check_segment(int name) {
    if (name == segment_) return;
    segment_ = name;
    pen_known_ = false;
    if constexpr (requires { visit_.segment(name); }) visit_.segment(name);
  }

  /// SEND-TO-DF (algorithm 9.17).
  void send_to_df(const SortedPiece& piece) {
    const auto points = points_of(piece);
    const bool is_line = scene().kind(piece.item) == Primitives::Kind::line;
    if (is_line || is_stroke_) {
      assert(points.size() == 2);
      const LineKinds kinds = is_line ? kDrawn : ordered_->pieces.visible[piece.first + 1];
      check_stroke_style(piece.item, kinds);
      if (!is_line) check_pick(ordered_->pieces.pick_item(piece));
      check_line_kinds(is_hidden_ ? static_cast<LineKinds>(kinds | kHiddenLine) : kinds);
      check_line_pick(is_line ? piece.item : ordered_->pieces.pick_item(piece));
      if constexpr (kDrawsPicture) {
        if (part_.is_alone && visit_.is_crumb(points[0], points[1])) return;
      }
      check_line_cuts(piece, points);
      if (!pen_known_ || pen_ != points[0]) visit_.move(points[0]);
      visit_.line(points[1]);
    } else {
      check_fill_style(piece.item);
      check_line_style(scene().line_style(piece.item));
      send_polygon(piece, points);
    }
    pen_known_ = true;
    pen_ = points.back();
  }

  /// CHECK-STYLE (algorithm 9.18): a style is sent only where it changes.
  void check_fill_style(std::uint32_t item) {
    const StyledItem now{&scene(), item, light_};
    const FillStyle style = now.style();
    const bool same = fill_of_.scene != nullptr && fill_of_.style() == style;
    fill_of_ = now;
    if (!same) visit_.fill(style);
  }
  void check_line_style(const LineStyle& style) {
    if (line_known_ && line_ == style) return;
    line_known_ = true;
    line_ = style;
    visit_.line_style(style);
  }

  /// A line's, or that of a polygon's side of these kinds.
  void check_stroke_style(std::uint32_t item, LineKinds kinds) {
    const LineStyle& line = scene().line_style(item);
    const bool is_line = scene().kind(item) == Primitives::Kind::line;
    if (!is_hidden_ && (is_line || line.of_kinds.empty())) return check_line_style(line);
    const LineStyle visible = is_line ? line : side_line_style(line, kinds);
    check_line_style(is_hidden_ ? hidden_line_style(visible) : visible);
  }

  void check_line_kinds(LineKinds kinds) {
    if (line_kinds_ == kinds) return;
    line_kinds_ = kinds;
    if constexpr (requires { visit_.line_kinds(kinds); }) visit_.line_kinds(kinds);
  }

  void check_pick(std::uint32_t item) {
    const std::int32_t pick = scene().pick_of_item(item);
    if (pick_known_ && pick_ == pick) return;
    pick_known_ = true;
    pick_ = pick;
    visit_.pick(pick);
  }

  void check_line_pick(std::uint32_t item) {
    if constexpr (requires { visit_.line_pick(std::int32_t{}); }) {
      const std::int32_t pick = scene().pick_of_item(item);
      if (pick != line_pick_) visit_.line_pick(pick);
      line_pick_ = pick;
    }
  }

  void check_line_cuts(const SortedPiece& piece, std::span<const Point3> points) {
    if constexpr (requires { visit_.line_cuts(LineCuts()); }) {
      const LineCuts cuts = cuts_of_line(piece, points);
      if (cuts != line_cuts_) visit_.line_cuts(cuts);
      line_cuts_ = cuts;
    }
  }

  LineCuts cuts_of_line(const SortedPiece& piece, std::span<const Point3> part) const {
    LineCuts cuts;
    if (is_stroke_) {
      cuts = ordered_->pieces.stroke_cuts(piece);
      cuts = {part_.cuts.at_start || (cuts.at_start && part_.from == 0.0),
              part_.cuts.at_end || (cuts.at_end && part_.to == 1.0)};
    } else {
      const PointRow ends = scene().points(piece.item);
      cuts = {part[0] != ends[0], part[1] != ends[1]};
    }
    return with_clipped_ends(scene(), piece.item, part[0], part[1], cuts);
  }

  /// Finds the corners at which a drawn side ends and the next is not drawn, or the reverse, that
  /// are not vertices of the whole polygon, or are clipped.
  void check_corner_cuts(const SortedPiece& piece, std::span<const Point3> points) {
    const PointRow own = scene().points(piece.item);
    cut_corners_.assign(std::max<std::size_t>(points.size(), 3), 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((kinds_[i] != 0) == (kinds_[(i + 1) % points.size()] != 0)) continue;
      const bool is_own =
          piece.first == SortedPiece::kWhole || std::ranges::find(own, points[i]) != own.end();
      cut_corners_[i] = !is_own || is_clipped(scene(), piece.item, points[i]) ? 1 : 0;
    }
    if (std::ranges::find(cut_corners_, 1) == cut_corners_.end()) return;
    visit_.corner_cuts(std::span<const std::uint8_t>(cut_corners_));
  }

  PointRow points_of(const SortedPiece& piece) {
    if (piece.first == SortedPiece::kWhole) return scene().points(piece.item);
    const auto points = std::span(ordered_->pieces.points).subspan(piece.first, piece.sides);
    if (part_.is_whole()) return points;
    part_points_ = {part_.at(points[0], points[1], part_.from),
                    part_.at(points[0], points[1], part_.to)};
    return std::span<const Point3>(part_points_);
  }

  /// A piece of an edge-on polygon may be a single side; polygon instructions have at least three.
  void send_polygon(const SortedPiece& piece, std::span<const Point3> points) {
    sides_.clear();
    kinds_.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      kinds_.push_back(piece.first == SortedPiece::kWhole
                           ? scene().side_kinds(piece.item, i)
                           : ordered_->pieces.visible[piece.first + i]);
      sides_.push_back(kinds_.back() != 0 ? op::line : op::move);
    }
    VertexShading shading = shading_of(piece, points);
    if constexpr (requires { visit_.corner_cuts(std::span<const std::uint8_t>()); }) {
      check_corner_cuts(piece, points);
    }
    if (points.size() < 3) {
      padded_.assign(points.begin(), points.end());
      padded_.resize(3, points.back());
      sides_.resize(3, op::move);
      kinds_.resize(3, 0);
      shading.intensities = padded(shading.intensities, intensities_);
      shading.normals = padded(shading.normals, normals_);
      points = padded_;
    }
    check_pick(piece.item);
    if constexpr (requires { visit_.side_kinds(std::span<const LineKinds>(kinds_)); }) {
      if (std::ranges::any_of(kinds_, has_kind)) {
        visit_.side_kinds(std::span<const LineKinds>(kinds_));
      }
    }
    visit_shading(visit_, shading);
    visit_.polygon(points, std::span<const std::int32_t>(sides_));
  }

  /// Interpolates a piece's shading from that of the whole polygon.
  VertexShading shading_of(const SortedPiece& piece, std::span<const Point3> points) {
    if (light_ == Lit::in_shadow) return {};
    const VertexShading whole = scene().shading(piece.item);
    if (whole.empty() || piece.first == SortedPiece::kWhole) return whole;
    const PointRow vertices = scene().points(piece.item);
    const auto values_at_points = [&](const auto& plane, auto& values) {
      values.clear();
      for (const Point3& p : points) values.push_back(plane.at(p));
    };
    if (whole.normals.empty()) {
      values_at_points(IntensityPlane(vertices, whole.intensities), intensities_);
      return {.intensities = intensities_};
    }
    values_at_points(NormalPlane(vertices, whole.normals), normals_);
    return {.normals = normals_, .light = whole.light};
  }

  /// Extends one or two values to three; none stay none.
  template <class Value>
  static std::span<const Value> padded(std::span<const Value> values, std::vector<Value>& room) {
    if (values.empty()) return {};
    if (values.data() != room.data()) room.assign(values.begin(), values.end());
    room.resize(3, room.back());
    return room;
  }

  Visitor& visit_;
  const OrderedScene* ordered_ = nullptr;
  bool is_hidden_ = false, is_stroke_ = false;  // the piece that is sent
  StrokePart part_ = kWholeStroke;              // likewise, of a stroke
  std::array<Point3, 2> part_points_;
  Lit light_ = Lit::unknown;  // likewise
  StyledItem fill_of_;
  bool line_known_ = false, pick_known_ = false, pen_known_ = false;
  LineStyle line_;
  bool text_style_known_ = false;
  TextStyle text_style_;
  std::int32_t pick_ = 0, line_pick_ = -1;
  Point3 pen_{0.0};
  int segment_ = 0;  // names are 1 or more
  std::vector<std::int32_t> sides_;
  std::vector<LineKinds> kinds_;  // of the sides
  LineKinds line_kinds_ = kDrawn;
  LineCuts line_cuts_;
  std::vector<std::uint8_t> cut_corners_;
  std::vector<Point3> padded_;
  std::vector<double> intensities_;  // of one piece
  std::vector<Point3> normals_;      // likewise
};

template <class Visitor>
void SortedScene::walk(Visitor&& visit) const {
  PieceWriter<std::remove_reference_t<Visitor>> writer(visit);
  const bool are_disjoint = plan.method == HiddenMethod::map;
  if constexpr (requires { visit.disjoint_polygons(true); }) {
    if (are_disjoint) visit.disjoint_polygons(true);
  }
  for (const auto& part : parts) writer.save_polygons_in_order(*part);
  if constexpr (requires { visit.disjoint_polygons(true); }) {
    if (are_disjoint) {
      visit.disjoint_polygons(false);
      writer.name_segment_again();
    }
  }
  for (const auto& part : parts) writer.save_strokes(*part);
  if constexpr (requires { visit.text(Point3(), std::string_view()); }) {
    for (const auto& part : parts) writer.save_texts(*part->scene);
  }
  if constexpr (requires(const KeptAnnotation& annotation) { visit.annotation(annotation); }) {
    for (const auto& part : parts) writer.save_annotations(*part->scene);
  }
}

}  // namespace displayfile
