#pragma once

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/parallel.h"
#include "clip/base/work_budget.h"
#include "hidden/sort/sort_tables.h"

namespace displayfile {

/// The pairs of entries of the polygon table that overlap in the projection, at least one of which
/// hides: for each entry, the others.
class Overlaps {
 public:
  using Index = PolygonTable::Index;
  using Pair = std::pair<Index, Index>;

  Overlaps(std::vector<Pair> pairs, std::size_t entries);

  std::span<const Index> with(Index entry) const {
    assert(entry < entries());
    return std::span(others_).subspan(first_[entry], first_[entry + 1] - first_[entry]);
  }
  std::size_t entries() const { return first_.size() - 1; }
  std::size_t pairs() const { return others_.size() / 2; }

 private:
  std::vector<std::size_t> first_;
  std::vector<Index> others_;
};

/// Runs work(from, to) over the parts of a range, on that many threads.
template <class Work>
void in_parts(std::uint32_t size, std::uint32_t part, int threads, const Work& work) {
  const std::uint32_t parts = (size + part - 1) / part;
  const auto run = [&](std::size_t n) {
    const auto k = static_cast<std::uint32_t>(n);
    work(k, k * part, std::min(size, (k + 1) * part));
  };
  in_parallel(threads, parts, run);
}

/// The extents of all entries, and the pairs that overlap.
struct OverlappingPairs {
  std::vector<Extent> extents;
  /// Nothing if they exceed the limit, which would take too much memory.
  std::optional<std::vector<Overlaps::Pair>> pairs;
};

template <class Policy>
OverlappingPairs overlapping_pairs(const SortTables<Policy>& scene, std::size_t most, int threads) {
  using Index = PolygonTable::Index;
  const Index entries = scene.table.free();
  OverlappingPairs result{std::vector<Extent>(entries), {}};
  constexpr std::uint32_t kPart = 2048;
  in_parts(entries, kPart, threads, [&](std::uint32_t, Index from, Index to) {
    for (Index i = from; i < to; ++i) result.extents[i] = scene.extent(i);
  });
  const ExtentTree tree = extent_tree(result.extents, threads);
  const auto order = tree.order();
  // Compared entries are adjacent in memory.
  std::vector<EnteredTriangle> triangles(entries);
  std::vector<std::int8_t> turning(entries);
  enum class Kind : std::uint8_t { nothing, drawn, hides };
  std::vector<Kind> kinds(entries, Kind::nothing);
  in_parts(entries, kPart, threads, [&](std::uint32_t, std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t p = from; p < to; ++p) {
      if (scene.table[order[p]].sides == 0) continue;
      kinds[p] = scene.hides(order[p]) ? Kind::hides : Kind::drawn;
      const Outline outline = scene.outline(order[p]);
      turning[p] = static_cast<std::int8_t>(outline.turning);
      triangles[p] = entered_triangle(scene.vertices, outline);
    }
  });
  // Outlines with many sides are compared with many others: data for comparisons are computed once.
  std::vector<std::uint32_t> place_of_many(entries);  // its place in `many`, from 1; 0 for others
  std::vector<ComparedOutline> many;
  for (std::uint32_t p = 0; p < entries; ++p) {
    const auto vertices = scene.table.vertices(order[p]);
    if (kinds[p] == Kind::nothing || vertices.size() < OutermostVertices::kFew) continue;
    many.emplace_back(scene.vertices, Outline{vertices, turning[p]});
    place_of_many[p] = static_cast<std::uint32_t>(many.size());
  }
  in_parts(static_cast<std::uint32_t>(many.size()), 16, threads,
           [&](std::uint32_t, std::uint32_t from, std::uint32_t to) {
             for (std::uint32_t k = from; k < to; ++k) {
               const Outline& outline = many[k].outline();
               if (outline.turning == 0 && most_turns(outline, {}) <= kMostTurns) {
                 many[k].find_hull_sides(scene.vertices);
               }
             }
           });
  const auto compared = [&](std::uint32_t p) -> const ComparedOutline& {
    return many[place_of_many[p] - 1];
  };
  const auto few = [&](std::uint32_t p) {
    return ComparedOutline(scene.vertices, {scene.table.vertices(order[p]), turning[p]});
  };
  constexpr std::size_t kTurnsOfAStep = 256;  // orientation tests of two polygons with many sides
  const auto overlap = [&](std::uint32_t p, std::uint32_t q, WorkSteps& steps) {
    if (triangles[p].turning != 0 && triangles[q].turning != 0) {
      steps.step();
      return overlap_in_projection(scene.vertices, triangles[p], triangles[q]);
    }
    const bool many_p = place_of_many[p] != 0, many_q = place_of_many[q] != 0;
    const auto compare = [&](const ComparedOutline& a, const ComparedOutline& b) {
      steps.step(1 + std::min(most_turns(a.outline(), b.outline()), kMostTurns) / kTurnsOfAStep);
      return overlap_in_projection(scene.vertices, a, b);
    };
    if (many_p && many_q) return compare(compared(p), compared(q));
    if (many_p) return compare(compared(p), few(q));
    if (many_q) return compare(few(p), compared(q));
    return compare(few(p), few(q));
  };
  constexpr std::uint32_t kLeaves = 128;
  std::vector<std::vector<Overlaps::Pair>> found((tree.leaves() + kLeaves - 1) / kLeaves);
  std::atomic<std::size_t> count = 0;
  in_parts(tree.leaves(), kLeaves, threads,
           [&](std::uint32_t part, std::uint32_t from, std::uint32_t to) {
             auto& here = found[part];
             WorkSteps steps;
             for (std::uint32_t leaf = from; leaf < to && count <= most; ++leaf) {
               const std::size_t before = here.size();
               tree.pairs(leaf, leaf + 1, [&](std::uint32_t p, std::uint32_t q) {
                 // Unbounded entries meet empty ones, too.
                 if (kinds[p] == Kind::nothing || kinds[q] == Kind::nothing) return;
                 if (kinds[p] != Kind::hides && kinds[q] != Kind::hides) return;
                 if (here.size() - before > most) return;
                 if (overlap(p, q, steps)) here.push_back(std::minmax({order[p], order[q]}));
               });
               count += here.size() - before;
             }
           });
  if (count > most) return result;
  auto& all = result.pairs.emplace();
  all.reserve(count);
  for (auto& here : found) {
    all.insert(all.end(), here.begin(), here.end());
    std::vector<Overlaps::Pair>().swap(here);
  }
  return result;
}

}  // namespace displayfile
