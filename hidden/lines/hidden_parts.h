#pragma once

#include <algorithm>
#include <cassert>
#include <vector>

namespace displayfile {

/// A part of a line, by parameters along it, from < to.
struct PartOfLine {
  double from, to;
};

/// True if the parts are sorted and do not touch.
[[maybe_unused]] inline bool are_united(const std::vector<PartOfLine>& parts) {
  const auto touch = [](const PartOfLine& p, const PartOfLine& q) { return !(p.to < q.from); };
  return std::ranges::adjacent_find(parts, touch) == parts.end();
}

/// Sorts the parts and merges overlapping or touching ones. Idempotent.
inline void unite(std::vector<PartOfLine>& parts) {
  if (parts.size() < 2) return;
  std::ranges::sort(parts, {}, &PartOfLine::from);
  std::size_t last = 0;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].from <= parts[last].to) {
      parts[last].to = std::max(parts[last].to, parts[i].to);
    } else {
      parts[++last] = parts[i];
    }
  }
  parts.resize(last + 1);
}

/// Adds the intersection of both, which are united, to `common`. Symmetric.
inline void intersect(const std::vector<PartOfLine>& one, const std::vector<PartOfLine>& other,
                      std::vector<PartOfLine>& common) {
  assert(are_united(one) && are_united(other));
  for (std::size_t i = 0, j = 0; i < one.size() && j < other.size();) {
    const double from = std::max(one[i].from, other[j].from);
    const double to = std::min(one[i].to, other[j].to);
    if (from < to) common.push_back({from, to});
    ++(one[i].to < other[j].to ? i : j);
  }
}

/// The parts of a line covered by nearer polygons: on its left, on its right, and on both sides at
/// once. A point is hidden where both sides are covered, by the same polygon or not.
class HiddenParts {
 public:
  void clear() {
    both_.clear();
    left_.clear();
    right_.clear();
    reaches_ = 0.0;
  }
  void add_both(const PartOfLine& part) {
    both_.push_back(part);
    if (part.from <= reaches_) reaches_ = std::max(reaches_, part.to);
  }
  void add_left(const PartOfLine& part) { left_.push_back(part); }
  void add_right(const PartOfLine& part) { right_.push_back(part); }

  /// True if the part is known to be hidden by covers of both sides.
  bool hides(const PartOfLine& part) const {
    if (reaches_ >= part.to) return true;
    double from = std::max(part.from, reaches_);
    // Follows parts added in any order as far as they connect.
    for (bool further = true; further && from < part.to;) {
      further = false;
      for (const PartOfLine& hidden : both_) {
        if (hidden.from <= from && hidden.to > from) {
          from = hidden.to;
          further = true;
        }
      }
    }
    return from >= part.to;
  }

  /// The hidden parts in order; none touch. Valid until something changes.
  const std::vector<PartOfLine>& hidden() {
    if (!left_.empty() && !right_.empty()) {
      unite(left_);
      unite(right_);
      intersect(left_, right_, both_);
    }
    left_.clear();
    right_.clear();
    unite(both_);
    return both_;
  }

 private:
  std::vector<PartOfLine> both_, left_, right_;
  double reaches_ = 0.0;  // all is hidden from 0 to this
};

}  // namespace displayfile
