#include "interp/raster/lines_over_fills.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "displayfile/hidden_surface_check.h"

namespace displayfile {

namespace {

/// The others that are wanted, each a stroke of its own.
void take_strokes(LinesOverFills::Group& group, int threads) {
  SortOptions options;
  options.precision = group.wanted.precision;
  options.threads = threads;
  options.hidden_lines = group.wanted.hidden;
  options.intersections = group.wanted.intersections;
  const SortedPieces order = lines_in_order(*group.scene, HiddenMethod::franklin, options);
  for (std::size_t k = 0; k < order.pieces.size(); ++k) {
    const SortedPiece& piece = order.pieces[k];
    const Point3 &from = order.points[piece.first], &to = order.points[piece.first + 1];
    const LineStyle& style = group.scene->line_style(piece.item);
    if (order.is_hidden(k)) {
      group.hidden.push_back({from, to, hidden_line_style(style)});
    } else if (order.is_intersection(piece)) {
      group.intersections.push_back({from, to, style});
    }
  }
}

std::vector<VisiblePiece> visible_pieces_of(const ViewedScene& scene, const Precision& precision,
                                            int threads) {
  const std::vector<std::uint8_t> drawn = scene.drawn_sides();
  Primitives outlined = scene.primitives();
  outlined.visible = drawn;
  return visible_lines(scene.primitives(), drawn_lines(outlined), HiddenMethod::franklin,
                       {.precision = precision, .threads = threads})
      .pieces;
}

LinesOverFills::Group lines_of(std::shared_ptr<const ViewedScene> scene,
                               const LinesOverFills::Wanted& wanted, int threads) {
  LinesOverFills::Group group{std::move(scene), wanted, {}, {}, {}};
  if (!group.scene->has_lines()) return group;
  group.pieces = visible_pieces_of(*group.scene, wanted.precision, threads);
  if (wanted.hidden != HiddenLines::none || wanted.intersections) take_strokes(group, threads);
  return group;
}

bool is_sorted_in_order(const Segment& segment) {
  return segment.visible && segment.sorted() != nullptr && !finds_lines(segment.sorted()->method);
}

}  // namespace

void LinesOverFills::clear() {
  all_.reset();
  of_segments_.clear();
}

void LinesOverFills::take(const std::shared_ptr<const ViewedScene>& scene, const Wanted& wanted,
                          int threads) {
  of_segments_.clear();
  if (all_ && all_->wanted == wanted) {
    all_->scene = scene;
    return;
  }
  all_.reset();  // unless it succeeds
  all_ = lines_of(scene, wanted, threads);
}

void LinesOverFills::take_sorted_segments(const DisplayFile& display_file, const Wanted& asked,
                                          int threads) {
  all_.reset();
  auto before = std::exchange(of_segments_, {});
  for (const Segment& segment : display_file.segments()) {
    if (!is_sorted_in_order(segment)) continue;
    const auto kept = before.find(segment.name());
    Wanted wanted = asked;
    wanted.precision = segment.sorted()->precision;
    const auto will_do = [&](const OfSegment& old) {
      return old.entered == segment.entered() && old.image == segment.image &&
             old.group.wanted == wanted;
    };
    of_segments_.emplace(segment.name(), kept != before.end() && will_do(kept->second)
                                             ? std::move(kept->second)
                                             : OfSegment{segment.entered(), segment.image,
                                                         group_of(segment, wanted, threads)});
  }
}

LinesOverFills::Group LinesOverFills::group_of(const Segment& segment, const Wanted& wanted,
                                               int threads) {
  const SortedScene& sorted = *segment.sorted();
  if (segment.sorted_as_drawn() && sorted.parts.size() == 1) {
    return lines_of(sorted.parts.front()->scene, wanted, threads);
  }
  const Segment* const one = &segment;
  return lines_of(std::make_shared<const ViewedScene>(std::span(&one, 1)), wanted, threads);
}

const LinesOverFills::Group* LinesOverFills::of_segment(int name) const {
  const auto found = of_segments_.find(name);
  return found == of_segments_.end() ? nullptr : &found->second.group;
}

}  // namespace displayfile
