#pragma once

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "hidden/sort_scene.h"

namespace displayfile {

/// Which entries of the polygon table overlap in the projection, and at least one of them hides
/// something: for each of the entries, the others.
class Overlaps {
 public:
  using Index = PolygonTable::Index;
  using Pair = ExtentIndex::Pair;

  Overlaps(std::vector<Pair> pairs, std::size_t entries);

  std::span<const Index> with(Index entry) const {
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
  const auto run = [&](std::uint32_t k) { work(k, k * part, std::min(size, (k + 1) * part)); };
  if (threads <= 1 || parts <= 1) {
    for (std::uint32_t k = 0; k < parts; ++k) run(k);
    return;
  }
  tbb::task_arena(threads).execute([&] { tbb::parallel_for(std::uint32_t{0}, parts, run); });
}

/// The pairs that overlap; nothing if they are more than `most`, which would take too much memory.
template <class Policy>
std::optional<std::vector<Overlaps::Pair>> overlapping_pairs(const SortScene<Policy>& scene,
                                                             std::size_t most, int threads) {
  using Index = PolygonTable::Index;
  const Index entries = scene.table.free();
  std::vector<Extent> extents(entries);
  std::vector<std::int8_t> turning(entries);
  constexpr std::uint32_t kPart = 2048;
  in_parts(entries, kPart, threads, [&](std::uint32_t, Index from, Index to) {
    for (Index i = from; i < to; ++i) {
      extents[i] = scene.extent(i);
      turning[i] =
          static_cast<std::int8_t>(scene.table[i].sides == 0 ? 0 : scene.outline(i).turning);
    }
  });
  const ExtentIndex index(extents);
  constexpr std::uint32_t kLeaves = 256;
  std::vector<std::vector<Overlaps::Pair>> found((index.leaves() + kLeaves - 1) / kLeaves);
  std::atomic<std::size_t> count = 0;
  in_parts(index.leaves(), kLeaves, threads,
           [&](std::uint32_t part, std::uint32_t from, std::uint32_t to) {
             auto& here = found[part];
             for (std::uint32_t leaf = from; leaf < to && count <= most; ++leaf) {
               const std::size_t before = here.size();
               index.pairs(leaf, leaf + 1, [&](Index i, Index j) {
                 if (!scene.hides(i) && !scene.hides(j)) return;
                 if (here.size() - before > most) return;
                 const Outline a{scene.table.vertices(i), turning[i]},
                     b{scene.table.vertices(j), turning[j]};
                 if (overlap_in_projection(scene.vertices, a, b)) here.emplace_back(i, j);
               });
               count += here.size() - before;
             }
           });
  if (count > most) return std::nullopt;
  std::vector<Overlaps::Pair> all;
  all.reserve(count);
  for (auto& here : found) {
    all.insert(all.end(), here.begin(), here.end());
    std::vector<Overlaps::Pair>().swap(here);
  }
  return all;
}

}  // namespace displayfile
