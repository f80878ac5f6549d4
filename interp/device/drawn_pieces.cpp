#include "interp/device/output_device.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/round_to_nearest.h"
#include "clip/geometry/corners.h"
#include "clip/surfaces.h"
#include "displayfile/entered/normal_plane.h"
#include "displayfile/entered/styled_sides.h"
#include "displayfile/looks/lighting.h"
#include "displayfile/looks/vertex_shading.h"
#include "displayfile/segments/display_file.h"

namespace displayfile {

namespace {

using Kind = DrawnPieces::Kind;

/// Gathers pieces from instructions in order, with the attributes in force.
class PieceGatherer {
 public:
  explicit PieceGatherer(DrawnPieces& pieces) : pieces_(pieces) {}

  void segment(int name) { segment_ = name; }
  void fill(const FillStyle& style) { fill_ = style; }
  void line_style(const LineStyle& style) { line_ = style; }
  void pick(int id) { pick_ = id; }
  void line_pick(int id) { line_pick_ = id; }
  void line_kinds(LineKinds kinds) { of_lines_ = kinds; }
  void line_cuts(LineCuts cuts) { cuts_of_lines_ = cuts; }
  void corner_cuts(std::span<const std::uint8_t> cuts) { of_corners_ = cuts; }
  void side_kinds(std::span<const LineKinds> kinds) { of_sides_ = kinds; }
  void intensities(std::span<const double> values) { of_vertices_ = {.intensities = values}; }
  void normals(std::span<const Point3> values, const Light& light) {
    of_vertices_ = {.normals = values, .light = &light};
  }
  void move(const Point3& p) { pen_ = p; }
  void line(const Point3& p) {
    if (line_.kind != LineStyle::Kind::none) {
      pieces_.points.insert(pieces_.points.end(), {pen_, p});
      pieces_.sides.insert(pieces_.sides.end(), {std::uint8_t{0}, of_lines_});
      const auto [at_start, at_end] = cuts_of_lines_;
      pieces_.cuts.insert(pieces_.cuts.end(), {std::uint8_t{at_start}, std::uint8_t{at_end}});
      end_piece(Kind::line, line_.colour, line_pick_);
    }
    pen_ = p;
  }
  void polygon(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    const bool has_lines = line_.kind != LineStyle::Kind::none;
    if (!has_lines || line_.of_kinds.empty()) {
      polygon_piece(vertices, sides);
    } else {
      polygon_and_sides(vertices, sides);
    }
    of_sides_ = {};
    of_corners_ = {};
    of_vertices_ = {};
    pen_ = vertices.back();
  }

 private:
  void polygon_piece(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    const bool solid = fill_.kind == FillStyle::Kind::solid;
    const bool has_lines = line_.kind != LineStyle::Kind::none;
    if (!solid && !has_lines) return;
    pieces_.points.insert(pieces_.points.end(), vertices.begin(), vertices.end());
    for (std::size_t i = 0; i < sides.size(); ++i) {
      pieces_.sides.push_back(has_lines && sides[i] == op::line ? kinds_of_side(i) : LineKinds{0});
      pieces_.cuts.push_back(has_lines && is_cut(i) ? 1 : 0);
    }
    end_piece(solid ? Kind::solid : Kind::hollow, even_colour(), pick_);
  }
  /// Sides whose styles differ from the polygon's become lines after it.
  void polygon_and_sides(std::span<const Point3> vertices, std::span<const std::int32_t> sides) {
    own_.assign(sides.size(), op::move);
    styled_.for_each(line_, of_sides_, sides, [&](const LineStyle& style, const auto& of_style) {
      if (style == line_) own_.assign(of_style.begin(), of_style.end());
    });
    const bool has_own = std::ranges::find(own_, op::line) != own_.end();
    if (fill_.kind == FillStyle::Kind::solid || has_own) polygon_piece(vertices, own_);
    styled_.for_each(line_, of_sides_, sides, [&](const LineStyle& style, const auto& of_style) {
      if (style == line_) return;
      for (std::size_t i = 0; i < of_style.size(); ++i) {
        if (of_style[i] == op::line) side_piece(vertices, i, style);
      }
    });
  }
  void side_piece(std::span<const Point3> vertices, std::size_t side, const LineStyle& style) {
    const std::size_t before = previous_corner(side, vertices.size());
    pieces_.points.insert(pieces_.points.end(), {vertices[before], vertices[side]});
    pieces_.sides.insert(pieces_.sides.end(), {std::uint8_t{0}, kinds_of_side(side)});
    pieces_.cuts.insert(pieces_.cuts.end(),
                        {std::uint8_t{is_cut(before)}, std::uint8_t{is_cut(side)}});
    steps_.step();
    pieces_.end_piece({Kind::line, style.colour, style, pick_, segment_});
  }
  LineKinds kinds_of_side(std::size_t i) const { return of_sides_.empty() ? kDrawn : of_sides_[i]; }
  bool is_cut(std::size_t i) const { return !of_corners_.empty() && of_corners_[i] != 0; }
  Colour even_colour() {
    const auto shades = vertex_intensities(of_vertices_, intensities_);
    return (shades.empty() ? fill_ : lit(fill_, mean_intensity(shades))).colour;
  }
  void end_piece(Kind kind, const Colour& fill, std::int32_t pick) {
    steps_.step();
    pieces_.end_piece({kind, fill, line_, pick, segment_});
  }

  DrawnPieces& pieces_;
  FillStyle fill_;
  LineStyle line_;
  int segment_ = 0;
  std::int32_t pick_ = -1, line_pick_ = -1;
  LineKinds of_lines_ = kDrawn;
  LineCuts cuts_of_lines_;
  std::span<const LineKinds> of_sides_{};       // of the polygon that follows
  std::span<const std::uint8_t> of_corners_{};  // likewise
  VertexShading of_vertices_{};                 // likewise
  std::vector<double> intensities_;
  StyledSides styled_;
  std::vector<std::int32_t> own_;  // sides in the polygon's style
  Point3 pen_{0.0};
  WorkSteps steps_;
};

}  // namespace

DrawnPieces::Looks DrawnPieces::looks(std::size_t k) const {
  assert(k < size());
  const LineStyle line{static_cast<LineStyle::Kind>(line_kinds[k]), line_colours[k], line_widths[k],
                       line_dashes[k], line_gaps[k]};
  return {kinds[k], fills[k], line, picks[k], segments[k]};
}

void DrawnPieces::end_piece(const Looks& looks) {
  static_assert(static_cast<int>(Line::solid) == static_cast<int>(LineStyle::Kind::solid) &&
                static_cast<int>(Line::dashed) == static_cast<int>(LineStyle::Kind::dashed) &&
                static_cast<int>(Line::none) == static_cast<int>(LineStyle::Kind::none));
  assert(first.back() < points.size());
  assert(sides.size() == points.size() && cuts.size() == points.size());
  kinds.push_back(looks.kind);
  first.push_back(static_cast<std::uint32_t>(points.size()));
  fills.push_back(looks.fill);
  const LineStyle::Kind kind = looks.line.kind;  // a constant where lines are left out
  line_kinds.push_back(static_cast<Line>(kind));
  line_colours.push_back(looks.line.colour);
  line_widths.push_back(looks.line.width);
  line_dashes.push_back(looks.line.dash);
  line_gaps.push_back(looks.line.gap);
  picks.push_back(looks.pick);
  segments.push_back(looks.segment);
}

DrawnPieces drawn_pieces(const DisplayFile& display_file) {
  const RoundToNearest nearest;
  DrawnPieces pieces;
  if (display_file.sorted() != nullptr) {
    display_file.sorted()->walk(PieceGatherer(pieces));
    return pieces;
  }
  for (const Segment& segment : display_file.segments()) {
    if (!segment.visible) continue;
    PieceGatherer gatherer(pieces);
    gatherer.segment(segment.name());
    segment.walk_drawn(gatherer);
  }
  return pieces;
}

}  // namespace displayfile
