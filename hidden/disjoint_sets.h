#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace displayfile {

/// Sets of numbers from 0 that are joined (union-find). A set's name is its smallest member, so it
/// depends on what was joined and not on the order. Paths are halved as they are walked: joins and
/// questions take time in proportion to the logarithm of the size, and mostly none.
class DisjointSets {
 public:
  using Member = std::uint32_t;

  explicit DisjointSets(std::size_t members = 0) { resize(members); }

  std::size_t size() const { return toward_name_.size(); }
  /// New members are alone.
  void resize(std::size_t members) {
    const auto known = static_cast<Member>(size());
    toward_name_.resize(members);
    for (Member i = known; i < members; ++i) toward_name_[i] = i;
  }
  /// Takes a member out of its set, if all others of the set are taken out too before anything
  /// else is asked.
  void make_alone(Member i) { toward_name_[i] = i; }

  /// Joins their sets. The order of the two, and of joins, changes nothing, nor does a join of what
  /// is joined.
  void join(Member i, Member j) {
    const Member a = name(i), b = name(j);
    toward_name_[std::max(a, b)] = std::min(a, b);
  }
  bool joined(Member i, Member j) { return name(i) == name(j); }

  /// The smallest member of i's set.
  Member name(Member i) {
    assert(i < size() && toward_name_[i] <= i);
    while (toward_name_[i] != i) i = toward_name_[i] = toward_name_[toward_name_[i]];
    return i;
  }

 private:
  std::vector<Member> toward_name_;  // a smaller member of the same set, or itself
};

}  // namespace displayfile
