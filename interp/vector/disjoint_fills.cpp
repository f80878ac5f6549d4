#include "interp/vector/disjoint_fills.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interp/vector/traps.h"

namespace displayfile {

namespace {

using Loop = std::span<const LatticePoint>;

bool in_line(Loop loop) {
  return std::ranges::all_of(loop, [&](const LatticePoint& p) {
    return (std::int64_t{loop[1].x} - loop[0].x) * (std::int64_t{p.y} - loop[0].y) ==
           (std::int64_t{loop[1].y} - loop[0].y) * (std::int64_t{p.x} - loop[0].x);
  });
}

/// Cuts a set of pieces in two about equal ones along its longer extent.
template <class LoopOf>
std::pair<std::vector<std::size_t>, std::vector<std::size_t>> halves(
    std::vector<std::size_t> pieces, const LoopOf& loop_of) {
  const auto first_vertex = [&](std::size_t piece) { return loop_of(piece)[0]; };
  LatticePoint low = first_vertex(pieces[0]), high = low;
  for (const std::size_t piece : pieces) {
    const LatticePoint p = first_vertex(piece);
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const bool wide = std::int64_t{high.x} - low.x >= std::int64_t{high.y} - low.y;
  std::ranges::stable_sort(pieces, {}, [&](std::size_t piece) {
    const LatticePoint p = first_vertex(piece);
    return wide ? p.x : p.y;
  });
  const auto middle = pieces.begin() + static_cast<std::ptrdiff_t>(pieces.size() / 2);
  return {{pieces.begin(), middle}, {middle, pieces.end()}};
}

}  // namespace

void DisjointFills::add(std::span<const Point2> loop, const FillPaint& paint, int segment,
                        std::int32_t pick) {
  const std::size_t first = points_.size();
  for (const Point2& p : loop) {
    const LatticePoint rounded{static_cast<std::int32_t>(std::llround(p.x / options_.precision)),
                               static_cast<std::int32_t>(std::llround(p.y / options_.precision))};
    if (points_.size() == first || points_.back() != rounded) points_.push_back(rounded);
  }
  while (points_.size() > first + 1 && points_.back() == points_[first]) points_.pop_back();
  if (points_.size() - first < 3) return points_.resize(first);
  pieces_.push_back({first, points_.size()});
  // It covers nothing, but neighbours on either side of it may have other vertices.
  if (in_line(Loop(points_).subspan(first))) return;
  const auto known = std::ranges::find(segments_, segment);
  const Key key{known - segments_.begin(), options_.pick_ids ? pick : -1, paint};
  if (known == segments_.end()) segments_.push_back(segment);
  pieces_of_[key].push_back(pieces_.size() - 1);
}

/// One, unless it would have too many vertices.
void DisjointFills::add_regions(Figure& figure, const FigureRegion& like,
                                std::vector<std::size_t> pieces) const {
  const auto loop_of = [&](std::size_t piece) { return loop(piece); };
  std::vector<Loop> loops;
  loops.reserve(pieces.size());
  for (const std::size_t piece : pieces) loops.push_back(loop(piece));
  FigureRegion region = like;
  region.loops = boundary_of(loops);
  if (region.loops.points.size() <= Figure::kMostVertices || pieces.size() == 1) {
    if (!region.loops.empty()) figure.regions.push_back(std::move(region));
    return;
  }
  auto [low, high] = halves(std::move(pieces), loop_of);
  add_regions(figure, like, std::move(low));
  add_regions(figure, like, std::move(high));
}

Figure DisjointFills::merged() {
  Figure figure{options_.precision, {}, {}, {}};
  for (auto& [key, pieces] : pieces_of_) {
    const auto& [segment, pick, paint] = key;
    add_regions(figure, {segments_[segment], pick, paint, {}}, std::move(pieces));
  }
  std::vector<Loop> all;
  all.reserve(pieces_.size());
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) all.push_back(loop(piece));
  figure.outline = boundary_of(all);
  LatticeLoops* const alone = &figure.outline;
  drop_straight_vertices(std::span(&alone, 1));  // nobody shares the sides of a mask
  std::vector<LatticeLoops*> together;
  for (FigureRegion& region : figure.regions) together.push_back(&region.loops);
  drop_straight_vertices(together);
  std::erase_if(figure.regions, [](const FigureRegion& r) { return r.loops.empty(); });
  return figure;
}

Figure DisjointFills::take_figure() {
  Figure figure = merged();
  if (options_.seams == Seams::trapped && figure.regions.size() > 1) {
    figure.traps = traps_of(figure.regions);
  }
  *this = DisjointFills(options_);
  return figure;
}

}  // namespace displayfile
