#include "hidden/lines/side_table.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

#include "clip/secret_hash.h"

namespace displayfile {

namespace {

/// For each point, the first that is equal to it.
std::vector<std::uint32_t> first_equal_points(std::span<const Point3> points) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  const SecretHash hash;
  const std::size_t places = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::uint32_t> table(places, kNone), same(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::size_t at = hash(points[i]) & (places - 1);
    while (table[at] != kNone && points[table[at]] != points[i]) at = (at + 1) & (places - 1);
    if (table[at] == kNone) table[at] = i;
    same[i] = table[at];
  }
  return same;
}

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

/// Counted, then put in the lists, and each list in order: no list is long but of a point where
/// very many sides meet.
SideTable::SideTable(const Primitives& items, Sides which)
    : same_(first_equal_points(items.points)), first_(items.points.size() + 1, 0) {
  if (which == Sides::near_drawn && !items.visible.empty()) find_low_ends_of_drawn(items);
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
