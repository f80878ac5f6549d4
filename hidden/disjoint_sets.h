#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace displayfile {

/// Disjoint sets of numbers from 0 (union-find). A set's name is its smallest member, so it does
/// not depend on the order of joins. With path halving, operations take logarithmic time at most,
/// and mostly constant time.
class DisjointSets {
 public:
  using Member = std::uint32_t;

  explicit DisjointSets(std::size_t members = 0) { resize(members); }

  std::size_t size() const { return toward_name_.size(); }
  /// New members are singletons.
  void resize(std::size_t members) {
    const auto known = static_cast<Member>(size());
    toward_name_.resize(members);
    for (Member i = known; i < members; ++i) toward_name_[i] = i;
  }
  /// Makes a member a singleton; all others of its set must be made singletons too before any other
  /// call.
  void make_alone(Member i) { toward_name_[i] = i; }

  /// Joins their sets. Independent of the order of the two and of joins; idempotent.
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
