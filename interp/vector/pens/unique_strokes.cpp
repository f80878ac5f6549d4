#include "interp/vector/pens/unique_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"

namespace displayfile {

namespace {

double length_of(const Stroke& s) {
  return std::sqrt(static_cast<double>(squared_distance(s.from, s.to)));
}

/// Square cells over the strokes, with the numbers of the strokes that pass through or close to
/// each. They are so large that the number of entries is little more than that of strokes.
class StrokeCells {
 public:
  explicit StrokeCells(std::span<const Stroke> strokes) {
    low_ = high_ = strokes.front().from;
    double length = 0.0;
    for (const Stroke& s : strokes) {
      for (const SheetPoint& p : {s.from, s.to}) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
      }
      length += length_of(s);
    }
    const auto n = static_cast<double>(strokes.size());
    const double width = high_.x - low_.x + 1.0, height = high_.y - low_.y + 1.0;
    side_ = std::max({16.0, std::sqrt(width * height / n), length / (4.0 * n),
                      std::max(width, height) / (4.0 * n)});
    columns_ = static_cast<std::size_t>(width / side_) + 1;
    rows_ = static_cast<std::size_t>(height / side_) + 1;
    first_.assign(columns_ * rows_ + 1, 0);
    for (const Stroke& s : strokes) for_each_cell(s, [&](std::size_t c) { ++first_[c + 1]; });
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    strokes_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t k = 0; k < strokes.size(); ++k) {
      for_each_cell(strokes[k], [&](std::size_t c) { strokes_[next[c]++] = k; });
    }
  }

  /// The strokes of a cell, in order.
  std::span<const std::uint32_t> in(std::size_t cell) const {
    return std::span(strokes_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }

  /// Visits the cells that a stroke passes through, or passes within reach of points on it.
  template <class Visit>
  void for_each_cell(const Stroke& s, const Visit& visit) const {
    constexpr double kAround = 2.0 * kOnStroke;
    const SheetPoint &left = std::min(s.from, s.to), &right = std::max(s.from, s.to);  // by x
    const double dx = right.x - left.x, dy = right.y - left.y;
    const auto index = [&](double at, std::int32_t low, std::size_t count) {
      const double cell = std::floor((at - low) / side_);
      return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
    };
    const std::size_t first = index(left.x - kAround, low_.x, columns_);
    const std::size_t last = index(right.x + kAround, low_.x, columns_);
    for (std::size_t column = first; column <= last; ++column) {
      const double from = low_.x + side_ * static_cast<double>(column) - kAround;
      const double to = from + side_ + 2.0 * kAround;
      const auto share = [&](double x) { return std::clamp((x - left.x) / dx, 0.0, 1.0); };
      double y0 = left.y + (dx > 0.0 ? dy * share(from) : 0.0);
      double y1 = left.y + (dx > 0.0 ? dy * share(to) : dy);
      if (y0 > y1) std::swap(y0, y1);
      const std::size_t top = index(y0 - kAround, low_.y, rows_);
      const std::size_t bottom = index(y1 + kAround, low_.y, rows_);
      for (std::size_t row = top; row <= bottom; ++row) visit(row * columns_ + column);
    }
  }

 private:
  SheetPoint low_{}, high_{};
  double side_ = 1.0;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;    // of each cell
  std::vector<std::uint32_t> strokes_;  // of the cells, one after the other
};

/// True if the point is within kOnStroke of the stroke.
bool lies_on(const SheetPoint& p, const Stroke& s) {
  const std::int64_t along = dot(s.from, s.to, s.from, p);
  const std::int64_t squared = squared_distance(s.from, s.to);
  constexpr double kReach = kOnStroke * kOnStroke;
  if (along <= 0) return static_cast<double>(squared_distance(s.from, p)) <= kReach;
  if (along >= squared) return static_cast<double>(squared_distance(s.to, p)) <= kReach;
  const auto away = static_cast<double>(cross(s.from, s.to, s.from, p));
  return away * away <= kReach * static_cast<double>(squared);
}

class Uniqueness {
 public:
  explicit Uniqueness(std::span<const Stroke> by_length)
      : strokes_(by_length), cells_(by_length), looked_at_(by_length.size(), 0xffffffffu) {
    first_kept_.reserve(strokes_.size() + 1);
    first_kept_.push_back(0);
  }

  std::vector<Stroke> kept() {
    for (std::uint32_t k = 0; k < strokes_.size(); ++k) {
      parts_.assign(1, strokes_[k]);
      cells_.for_each_cell(strokes_[k], [&](std::size_t cell) {
        for (const std::uint32_t longer : cells_.in(cell)) {
          if (longer >= k || parts_.empty()) break;
          if (std::exchange(looked_at_[longer], k) != k) subtract_kept_of(longer);
        }
      });
      kept_.insert(kept_.end(), parts_.begin(), parts_.end());
      first_kept_.push_back(kept_.size());
    }
    return std::move(kept_);
  }

 private:
  void subtract_kept_of(std::uint32_t longer) {
    for (std::size_t i = first_kept_[longer]; i < first_kept_[longer + 1]; ++i) {
      steps_.step();
      rest_.clear();
      for (const Stroke& part : parts_) subtract(part, kept_[i]);
      std::swap(parts_, rest_);
    }
  }

  /// Adds the remainder of a part after removing the stroke already drawn.
  void subtract(const Stroke& part, const Stroke& drawn) {
    if (part.is_dot()) {
      if (!lies_on(part.from, drawn)) rest_.push_back(part);
      return;
    }
    if (drawn.is_dot()) return rest_.push_back(part);
    const double length = length_of(part), length_drawn = length_of(drawn);
    // Along the part, from its start.
    double low = static_cast<double>(dot(part.from, part.to, part.from, drawn.from)) / length;
    double high = static_cast<double>(dot(part.from, part.to, part.from, drawn.to)) / length;
    SheetPoint low_end = drawn.from, high_end = drawn.to;
    if (low > high) {
      std::swap(low, high);
      std::swap(low_end, high_end);
    }
    const double from = std::max(low, 0.0), to = std::min(high, length);
    // If the overlap is shorter than that, they meet end to end.
    if (to - from < std::min(2.0 * kOnStroke, length)) return rest_.push_back(part);
    const auto away = [&](double along) {  // of the part's point there from the other's line
      const auto of_start = static_cast<double>(cross(drawn.from, drawn.to, drawn.from, part.from));
      const auto turn = static_cast<double>(cross(drawn.from, drawn.to, part.from, part.to));
      return std::abs(of_start + turn * (along / length)) / length_drawn;
    };
    if (away(from) > kOnStroke || away(to) > kOnStroke) return rest_.push_back(part);
    const auto add = [&](const SheetPoint& a, const SheetPoint& b) {
      constexpr double kReach = kOnStroke * kOnStroke;
      if (static_cast<double>(squared_distance(a, b)) > kReach) rest_.push_back({a, b});
    };
    if (low > 0.0) add(part.from, low_end);
    if (high < length) add(high_end, part.to);
  }

  std::span<const Stroke> strokes_;
  StrokeCells cells_;
  std::vector<std::uint32_t> looked_at_;  // for which stroke last
  WorkSteps steps_;
  std::vector<Stroke> kept_;
  std::vector<std::size_t> first_kept_;  // of each stroke, and where the last one's end
  std::vector<Stroke> parts_, rest_;
};

}  // namespace

std::vector<Stroke> unique_strokes(std::vector<Stroke> strokes) {
  for (Stroke& s : strokes) {
    if (s.to < s.from) std::swap(s.from, s.to);
  }
  std::ranges::sort(strokes);
  strokes.erase(std::unique(strokes.begin(), strokes.end()), strokes.end());
  if (strokes.empty()) return strokes;
  std::ranges::stable_sort(strokes, std::ranges::greater(),
                           [](const Stroke& s) { return squared_distance(s.from, s.to); });
  return Uniqueness(strokes).kept();
}

}  // namespace displayfile
