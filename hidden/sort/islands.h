#pragma once

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hidden/disjoint_sets.h"
#include "hidden/sort/overlaps.h"

namespace displayfile {

/// Islands of the polygons being sorted: sets that do not overlap each other in the projection, so
/// that they need not be compared. Overlaps are found once, for the polygons as entered; a piece
/// counts as overlapping whatever its polygon did, until their extents are apart.
template <class Policy>
class Islands {
 public:
  using Index = PolygonTable::Index;

  /// The islands among all entries of the scene's table; nothing if too many overlap to be listed.
  static std::optional<Islands> find(const SortTables<Policy>& scene, int threads) {
    const std::size_t most = 64 * std::size_t{scene.table.free()} + 4096;
    auto [extents, pairs] = overlapping_pairs(scene, most, threads);
    if (!pairs) return std::nullopt;
    return Islands(scene, std::move(extents), std::move(*pairs));
  }

  const Extent& extent(Index entry) const {
    assert(entry < extents_.size());
    return extents_[entry];
  }

  /// Must be called after an entry was cut in two, one of them new.
  void add_cut(Index entry, Index front, Index back) {
    origin_of_.push_back(origin_of_[entry]);
    extents_.resize(scene_->table.free());
    assert(origin_of_.size() == extents_.size());
    extents_[front] = scene_->extent(front);
    extents_[back] = scene_->extent(back);
  }
  /// Must be called after a node without a polygon was added to the table.
  void add_node() {
    origin_of_.push_back(0);
    extents_.push_back(Extent::nothing());
    assert(origin_of_.size() == scene_->table.free() && extents_.size() == origin_of_.size());
  }

  /// Divides a list's members into islands and singletons; false if all are one island.
  bool separate(std::span<const Index> members) {
    ++list_;
    for (const Index i : members) {
      const Index a = origin_of_[i];
      origins_[a] = {list_, i, origins_[a].list == list_, false};
      sets_.make_alone(a);
    }
    for (const Index i : members) {
      const Index a = origin_of_[i];
      for (const Index b : overlaps_.with(a)) {
        if (b < a || !still_overlaps(i, b)) continue;  // each pair once
        origins_[a].has_company = origins_[b].has_company = true;
        sets_.join(a, b);
      }
    }
    by_island_.clear();
    alone_.clear();
    for (const Index i : members) {
      if (has_company(i)) {
        by_island_.emplace_back(sets_.name(origin_of_[i]), i);
      } else {
        alone_.push_back(i);
      }
    }
    std::ranges::sort(by_island_);
    const bool one_island =
        !by_island_.empty() && by_island_.front().first == by_island_.back().first;
    return !(one_island && alone_.empty() && by_island_.size() > 1);
  }
  std::span<const Index> alone() const { return alone_; }
  /// Calls act(members) for each island, by its first polygon; a member is the second of a pair.
  template <class Act>
  void for_each(Act&& act) const {
    for (std::size_t first = 0; first < by_island_.size();) {
      std::size_t end = first;
      while (end < by_island_.size() && by_island_[end].first == by_island_[first].first) ++end;
      act(std::span(by_island_).subspan(first, end - first));
      first = end;
    }
  }

  /// A member of the list last separated that overlaps this one; itself if none does.
  Index one_that_overlaps(Index i) const {
    const auto others = overlaps_.with(origin_of_[i]);
    const auto other = std::ranges::find_if(others, [&](Index b) { return still_overlaps(i, b); });
    return other == others.end() ? i : origins_[*other].member;
  }

 private:
  Islands(const SortTables<Policy>& scene, std::vector<Extent> extents,
          std::vector<Overlaps::Pair> pairs)
      : scene_(&scene),
        overlaps_(std::move(pairs), extents.size()),
        extents_(std::move(extents)),
        origin_of_(extents_.size()),
        origins_(extents_.size()),
        sets_(extents_.size()) {
    for (Index i = 0; i < origin_of_.size(); ++i) origin_of_[i] = i;
  }

  bool has_company(Index i) const {
    const Origin& origin = origins_[origin_of_[i]];
    if (!origin.has_company || !origin.several) return origin.has_company;
    const auto others = overlaps_.with(origin_of_[i]);
    return std::ranges::any_of(others, [&](Index b) { return still_overlaps(i, b); });
  }
  /// True if a member still overlaps the pieces in the list of an origin that overlapped its own.
  bool still_overlaps(Index i, Index origin) const {
    const Origin& its = origins_[origin];
    if (its.list != list_) return false;
    const PolygonTable& table = scene_->table;
    if (its.several || (table[i].whole && table[its.member].whole)) return true;
    return extents_[i].meets_in_projection(extents_[its.member]);
  }

  const SortTables<Policy>* scene_;
  Overlaps overlaps_;
  std::vector<Extent> extents_;
  std::vector<Index> origin_of_;  // the entry that a piece was cut from
  struct Origin {
    std::uint32_t list = 0;  // list of its last occurrence
    Index member = 0;        // a piece of it in the list
    bool several = false;    // there are several pieces
    bool has_company = false;
  };
  std::vector<Origin> origins_;
  DisjointSets sets_;  // of origins
  std::uint32_t list_ = 0;
  std::vector<std::pair<Index, Index>> by_island_;  // the island's name, a member
  std::vector<Index> alone_;
};

}  // namespace displayfile
