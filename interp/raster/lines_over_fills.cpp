#include "interp/raster/lines_over_fills.h"

#include <cstddef>
#include <span>
#include <utility>

#include "displayfile/segments/clipped_ends.h"
#include "displayfile/segments/drawn_strokes.h"
#include "displayfile/segments/hidden_surface_check.h"
#include "displayfile/segments/scene_lines.h"
#include "displayfile/segments/sorted_scene.h"

namespace displayfile {

namespace {

/// Takes the other requested lines, each as a stroke of its own.
void take_strokes(LinesOverFills::Group& group, const FoundLines& found) {
  const SortedPieces order =
      lines_beside_sides(*group.scene, found, group.wanted.plan.hidden_lines);
  for (std::size_t k = 0; k < order.pieces.size(); ++k) {
    const SortedPiece& piece = order.pieces[k];
    const Point3 &from = order.points[piece.first], &to = order.points[piece.first + 1];
    const LineStyle style =
        style_of_stroke(*group.scene, piece.item, order.visible[piece.first + 1]);
    const LineCuts cuts =
        with_clipped_ends(*group.scene, piece.item, from, to, order.stroke_cuts(piece));
    if (order.is_hidden(k)) {
      group.hidden.push_back({from, to, hidden_line_style(style), cuts});
    } else {
      group.intersections.push_back({from, to, style, cuts});
    }
  }
}

/// Takes all lines, in order of depth, without crumbs.
void take_by_depth(LinesOverFills::Group& group, const FoundLines& found) {
  const ViewedScene& scene = *group.scene;
  const SurfacePlan& plan = group.wanted.plan;
  const OrderedScene ordered{group.scene, lines_in_order(scene, found, plan.hidden_lines),
                             plan.kept()};
  const SortedPieces& lines = ordered.pieces;
  for (const StrokePart& part : ordered.strokes_of_picture()) {
    const std::size_t k = lines.first_stroke + part.stroke;
    const SortedPiece& piece = lines.pieces[k];
    const Point3 &from = lines.points[piece.first], &to = lines.points[piece.first + 1];
    LineStyle style = style_of_stroke(scene, piece.item, lines.visible[piece.first + 1]);
    if (lines.is_hidden(k)) style = hidden_line_style(style);
    const Point2 start(part.at(from, to, part.from)), end(part.at(from, to, part.to));
    const bool is_crumb = is_shorter_than_wide(start, end, group.wanted.pixels, style.width);
    if (part.is_alone && is_crumb) continue;
    const LineCuts of_stroke =
        with_clipped_ends(scene, piece.item, from, to, lines.stroke_cuts(piece));
    const LineCuts cuts{of_stroke.at_start || part.cuts.at_start,
                        of_stroke.at_end || part.cuts.at_end};
    group.by_depth.push_back(
        {{from, to, style, cuts}, part.from, part.to, lines.pick_item(piece), lines.is_hidden(k)});
  }
}

LinesOverFills::Group lines_of(std::shared_ptr<const ViewedScene> scene,
                               const LinesOverFills::Wanted& wanted) {
  LinesOverFills::Group group{std::move(scene), wanted, {}, {}, {}, {}};
  if (!group.scene->has_lines()) return group;
  const SurfacePlan& plan = wanted.plan;
  const FoundLines found = find_lines(*group.scene, plan);
  if (plan.line_order == LineOrder::depth) {
    take_by_depth(group, found);
    return group;
  }
  if (plan.hidden_lines != HiddenLines::none || plan.intersections) take_strokes(group, found);
  group.pieces = pieces_of_picture(*group.scene, found, wanted.pixels);
  return group;
}

bool is_sorted_in_order(const Segment& segment) {
  return segment.visible && segment.sorted() != nullptr &&
         !finds_lines(segment.sorted()->plan.method);
}

}  // namespace

LinesOverFills::Wanted LinesOverFills::Wanted::beside(const SurfacePlan& fills,
                                                      const Point2& pixels) {
  return {{.method = HiddenMethod::franklin,
           .precision = fills.precision,
           .hidden_lines = fills.hidden_lines,
           .line_order = fills.line_order,
           .line_halo = fills.line_halo,
           .width = fills.width,
           .height = fills.height,
           .intersections = fills.intersections,
           .threads = fills.threads,
           .most_pieces = most_pieces_in_force()},
          pixels};
}

void LinesOverFills::clear() {
  all_.reset();
  of_segments_.clear();
}

void LinesOverFills::take(const std::shared_ptr<const ViewedScene>& scene, const Wanted& wanted) {
  of_segments_.clear();
  if (all_ && wanted.are_as(all_->wanted)) {
    all_->scene = scene;
    return;
  }
  all_.reset();  // unless it succeeds
  all_ = lines_of(scene, wanted);
}

void LinesOverFills::take_sorted_segments(const DisplayFile& display_file, const Point2& pixels,
                                          int threads) {
  all_.reset();
  auto before = std::exchange(of_segments_, {});
  for (const Segment& segment : display_file.segments()) {
    if (!is_sorted_in_order(segment)) continue;
    const auto kept = before.find(segment.name());
    Wanted wanted = Wanted::beside(segment.sorted()->plan, pixels);
    wanted.plan.threads = threads;
    const auto will_do = [&](const OfSegment& old) {
      return old.entered == segment.entered() && old.image == segment.image &&
             wanted.are_as(old.group.wanted);
    };
    of_segments_.emplace(segment.name(), kept != before.end() && will_do(kept->second)
                                             ? std::move(kept->second)
                                             : OfSegment{segment.entered(), segment.image,
                                                         group_of(segment, wanted)});
  }
}

LinesOverFills::Group LinesOverFills::group_of(const Segment& segment, const Wanted& wanted) {
  const SortedScene& sorted = *segment.sorted();
  if (segment.sorted_as_drawn() && sorted.parts.size() == 1) {
    return lines_of(sorted.parts.front()->scene, wanted);
  }
  const Segment* const one = &segment;
  return lines_of(std::make_shared<const ViewedScene>(std::span(&one, 1)), wanted);
}

const LinesOverFills::Group* LinesOverFills::of_segment(int name) const {
  const auto found = of_segments_.find(name);
  return found == of_segments_.end() ? nullptr : &found->second.group;
}

}  // namespace displayfile
