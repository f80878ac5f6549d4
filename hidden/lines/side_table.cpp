#include "hidden/lines/side_table.h"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include "hidden/touching/vertices_within_reach.h"

namespace displayfile {

namespace {

template <class Visit>
void for_each_side(const Primitives& items, const std::vector<std::uint32_t>& same,
                   const Visit& visit) {
  for (std::uint32_t i = 0; i < items.items.size(); ++i) {
    const Primitives::Item& item = items.items[i];
    if (item.kind == Primitives::Kind::line || item.sides == 0) continue;
    std::uint32_t from = same[items.point(item.first + item.sides - 1)];
    for (std::uint32_t corner = 0; corner < item.sides; ++corner) {
      const std::uint32_t to = same[items.point(item.first + corner)];
      if (from != to) visit(std::min(from, to), std::max(from, to), LineName{i, corner});
      from = to;
    }
  }
}

}  // namespace

SideTable::SideTable(const Primitives& items, Sides which)
    : same_(first_within(items.points, 0.0)) {
  if (which == Sides::near_drawn && !items.visible.empty()) find_low_ends_of_drawn(items);
  find(items);
}

SideTable::SideTable(const Primitives& items, std::vector<std::uint32_t> vertices)
    : same_(std::move(vertices)) {
  find(items);
}

/// Counts the sides, lists them by lower point, and sorts each list. Lists are short, except at a
/// point where very many sides meet.
void SideTable::find(const Primitives& items) {
  assert(same_.size() == items.points.size());
  first_.assign(items.points.size() + 1, 0);
  const auto counts = [&](std::uint32_t low) { return is_low_.empty() || is_low_[low] != 0; };
  for_each_side(items, same_, [&](std::uint32_t low, std::uint32_t, const LineName&) {
    if (counts(low)) ++first_[low + 1];
  });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  sides_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for_each_side(items, same_, [&](std::uint32_t low, std::uint32_t high, const LineName& name) {
    if (counts(low)) sides_[next[low]++] = {high, name};
  });
  for (std::size_t low = 0; low + 1 < first_.size(); ++low) {
    std::ranges::sort(sides_.begin() + first_[low], sides_.begin() + first_[low + 1],
                      [](const Side& s, const Side& t) {
                        return std::tie(s.high, s.name) < std::tie(t.high, t.name);
                      });
  }
}

void SideTable::find_low_ends_of_drawn(const Primitives& items) {
  is_low_.assign(items.points.size(), 0);
  for_each_side(items, same_, [&](std::uint32_t low, std::uint32_t, const LineName& name) {
    if (items.is_visible(items.items[name.item].first + name.corner)) is_low_[low] = 1;
  });
}

std::span<const SideTable::Side> SideTable::sides_between(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t low = std::min(same_[a], same_[b]), high = std::max(same_[a], same_[b]);
  const auto list = std::span(sides_).subspan(first_[low], first_[low + 1] - first_[low]);
  const auto begin = std::ranges::lower_bound(list, high, {}, &Side::high);
  const auto end = std::ranges::upper_bound(list, high, {}, &Side::high);
  return {begin, end};
}

}  // namespace displayfile
