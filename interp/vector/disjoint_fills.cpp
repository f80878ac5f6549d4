#include "interp/vector/disjoint_fills.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "interp/vector/cut_loops.h"
#include "interp/vector/seams.h"
#include "interp/vector/tents.h"
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

/// Cuts loops with more vertices than a path may have.
void cut_long_loops(Figure& figure) {
  const auto is_long = [](const LatticeLoops& loops) {
    return loops.points.size() > Figure::kMostVertices;
  };
  const auto any_is_long = [&] {
    return std::ranges::any_of(figure.regions, is_long, &FigureRegion::loops) ||
           std::ranges::any_of(figure.outline, is_long);
  };
  while (any_is_long()) {
    VerticesOnSides put;
    std::vector<FigureRegion> regions;
    for (FigureRegion& region : figure.regions) {
      for (LatticeLoops& part : parts_of(region.loops, Figure::kMostVertices, put)) {
        regions.push_back({region.segment, region.pick, region.paint, std::move(part)});
      }
    }
    std::vector<LatticeLoops> outline;
    for (const LatticeLoops& loops : figure.outline) {
      std::ranges::move(parts_of(loops, Figure::kMostVertices, put), std::back_inserter(outline));
    }
    for (FigureRegion& region : regions) put_vertices(region.loops, put);
    for (LatticeLoops& loops : outline) put_vertices(loops, put);
    figure.regions = std::move(regions);
    figure.outline = std::move(outline);
  }
}

/// The triangles that close the seams between the parts of the outline.
std::vector<LatticeLoops> tents_of_outline(const Figure& figure) {
  std::vector<FigureRegion> parts;
  for (const LatticeLoops& part : figure.outline) parts.push_back({0, 0, {}, part});
  std::vector<LatticeLoops> tents;
  for (FigureTents& some : tents_of(parts, kTrapWidth / 2.0 / figure.unit)) {
    tents.push_back(std::move(some.triangles));
  }
  return tents;
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
  if (points_.size() - first < 3 || in_line(Loop(points_).subspan(first))) {
    return points_.resize(first);
  }
  pieces_.push_back({first, points_.size()});
  const auto [known, is_new] = places_.try_emplace(segment, segments_.size());
  if (is_new) segments_.push_back(segment);
  const Key key{known->second, options_.pick_ids ? pick : -1, paint};
  pieces_of_[key].push_back(pieces_.size() - 1);
}

std::vector<Loop> DisjointFills::loops_of(std::span<const std::size_t> pieces) const {
  std::vector<Loop> loops;
  loops.reserve(pieces.size());
  for (const std::size_t piece : pieces) loops.push_back(loop(piece));
  return loops;
}

Figure DisjointFills::merged() {
  Figure figure{options_.precision, {}, {}, {}, {}};
  for (const auto& [key, pieces] : pieces_of_) {
    const auto& [segment, pick, paint] = key;
    figure.regions.push_back({segments_[segment], pick, paint, boundary_of(loops_of(pieces))});
  }
  std::vector<std::size_t> all(pieces_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  figure.outline = {outline_of(loops_of(all))};
  std::vector<LatticeLoops*> together;
  for (FigureRegion& region : figure.regions) together.push_back(&region.loops);
  drop_straight_vertices(together);
  std::erase_if(figure.regions, [](const FigureRegion& r) { return r.loops.empty(); });
  cut_long_loops(figure);
  return figure;
}

Figure DisjointFills::take_figure() {
  Figure figure = merged();
  if (options_.seams == Seams::trapped && figure.regions.size() > 1) {
    figure.traps = traps_of(figure.regions);
    figure.outline_tents = tents_of_outline(figure);
  }
  *this = DisjointFills(options_);
  return figure;
}

}  // namespace displayfile
