#include "interp/visibility/box_tree.h"

#include <algorithm>
#include <optional>

#include "hidden/parallel.h"

namespace displayfile {

namespace {

/// The rays come in packets of about so many columns and rows: a box is met by packets in
/// proportion to its size and theirs together.
constexpr double kPacket = 8.0;
/// The chance that what lies behind must be visited too, once the front half has been.
constexpr double kBehind = 0.5;
constexpr int kBins = 16;
/// So few items are halved, without asking what splits cost.
constexpr std::size_t kFew = 64;
/// The smaller part of a split has at least one in so many, so that no input makes a deep tree.
constexpr std::size_t kLeastPart = 8;
/// Of fewer items a tree is made sooner than threads are woken.
constexpr std::size_t kWorthThreads = 2000;

using Box = BoxTree::Box;

constexpr Box kNothing{
    {std::numeric_limits<std::int32_t>::max(), 0, std::numeric_limits<std::int32_t>::max(), 0},
    -std::numeric_limits<float>::infinity()};

Box together(const Box& a, const Box& b) {
  return {{std::min(a.pixels.first_column, b.pixels.first_column),
           std::max(a.pixels.end_column, b.pixels.end_column),
           std::min(a.pixels.first_row, b.pixels.first_row),
           std::max(a.pixels.end_row, b.pixels.end_row)},
          std::max(a.nearest, b.nearest)};
}

/// What the cost needs of a box: the least of first column and row, and of the ends taken
/// negative, so that one operation on four numbers unites two. Rounded beyond 2^24, as only costs
/// may be.
struct WideBox {
  std::array<float, 4> least;

  explicit WideBox(const PixelBox& p)
      : least{static_cast<float>(p.first_column), static_cast<float>(p.first_row),
              -static_cast<float>(p.end_column), -static_cast<float>(p.end_row)} {}
  static WideBox nothing() { return WideBox(kNothing.pixels); }

  void unite(const WideBox& other) {
    for (std::size_t k = 0; k < 4; ++k) {
      least[k] = other.least[k] < least[k] ? other.least[k] : least[k];
    }
  }
  /// In proportion to the packets that meet it.
  double packets() const {
    const double columns = -static_cast<double>(least[2]) - least[0];
    const double rows = -static_cast<double>(least[3]) - least[1];
    return columns > 0.0 ? (columns + kPacket) * (rows + kPacket) : 0.0;
  }
};

enum Axis { kColumn, kRow, kDepth, kAxes };

/// Where a box lies along an axis: twice its middle, or its nearest depth.
double position(const Box& box, int axis) {
  constexpr float kMost = std::numeric_limits<float>::max();
  switch (axis) {
    case kColumn: return static_cast<double>(box.pixels.first_column) + box.pixels.end_column;
    case kRow: return static_cast<double>(box.pixels.first_row) + box.pixels.end_row;
    default: return std::clamp(box.nearest, -kMost, kMost);
  }
}

/// The items of a branch, as a part of the builder's entries, and the box of them all.
struct Part {
  std::size_t begin, end;
  Box box;
  std::size_t size() const { return end - begin; }
};

/// The bins of one axis.
struct Bins {
  double low = std::numeric_limits<double>::infinity(), high = -low, scale = 0.0;
  std::array<WideBox, kBins> box;
  std::array<std::size_t, kBins> count{};

  Bins() : box(nothing()) {}
  std::size_t bin(double at) const {
    return static_cast<std::size_t>(std::min((at - low) * scale, kBins - 1.0));
  }

 private:
  static std::array<WideBox, kBins> nothing() {
    const WideBox r = WideBox::nothing();
    return {r, r, r, r, r, r, r, r, r, r, r, r, r, r, r, r};
  }
};

struct Split {
  int axis;
  std::size_t first_above;  // the first bin of the upper part
  double cost;
};

/// The cheapest split between two bins of an axis, if one leaves both parts large enough.
std::optional<Split> cheapest(const Bins& bins, int axis, std::size_t items) {
  std::array<double, kBins> below{};  // of the bins before each
  std::array<std::size_t, kBins> count{};
  WideBox box = WideBox::nothing();
  for (std::size_t b = 1; b < kBins; ++b) {
    box.unite(bins.box[b - 1]);
    count[b] = count[b - 1] + bins.count[b - 1];
    below[b] = box.packets() * static_cast<double>(count[b]);
  }
  std::optional<Split> best;
  box = WideBox::nothing();
  for (std::size_t b = kBins - 1; b > 0; --b) {
    box.unite(bins.box[b]);
    const std::size_t above = items - count[b];
    if (kLeastPart * std::min(above, count[b]) < items) continue;
    const double cost =
        box.packets() * static_cast<double>(above) + below[b] * (axis == kDepth ? kBehind : 1.0);
    if (!best || cost < best->cost) best = Split{axis, b, cost};
  }
  return best;
}

}  // namespace

struct BoxTree::Builder {
  /// Moved about together, so that a part's boxes lie one after the other.
  struct Entry {
    Box box;
    Item item;
  };
  std::vector<Entry> entries{};

  /// A node to be made, and what becomes of it.
  struct Work {
    std::uint32_t node;
    Part part;
    std::vector<Part> branches{};
  };

  Part part(std::size_t begin, std::size_t end) const {
    Part p{begin, end, kNothing};
    for (std::size_t k = begin; k < end; ++k) p.box = together(p.box, entries[k].box);
    return p;
  }

  /// Cuts off the upper half along rows or columns, where the middles spread farther; or in depth,
  /// if they are all within a packet. The lower half fills whole nodes.
  std::size_t halve(const Part& p, const std::array<Bins, kAxes>& bins) {
    const double columns = bins[kColumn].high - bins[kColumn].low;
    const double rows = bins[kRow].high - bins[kRow].low;
    const int axis = std::max(columns, rows) < kPacket ? kDepth : columns >= rows ? kColumn : kRow;
    const std::size_t whole = (p.size() / 2 + kBranches - 1) / kBranches * kBranches;
    const std::size_t middle = p.begin + (whole < p.size() ? whole : p.size() / 2);
    const auto at = [&](std::size_t k) { return entries.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(p.begin), at(middle), at(p.end), [&](const Entry& a, const Entry& b) {
      const double pa = position(a.box, axis), pb = position(b.box, axis);
      return pa != pb ? pa < pb : a.item < b.item;
    });
    return middle;
  }

  /// Reorders the part's items so that the two parts lie one after the other; where the second
  /// begins.
  std::size_t split(const Part& p) {
    std::array<Bins, kAxes> bins;
    for (std::size_t k = p.begin; k < p.end; ++k) {
      for (int axis = 0; axis < kAxes; ++axis) {
        Bins& of = bins[static_cast<std::size_t>(axis)];
        const double at = position(entries[k].box, axis);
        of.low = std::min(of.low, at);
        of.high = std::max(of.high, at);
      }
    }
    if (p.size() <= kFew) return halve(p, bins);
    for (Bins& of : bins) {
      of.scale = of.high > of.low ? kBins / (of.high - of.low) : 0.0;
    }
    for (std::size_t k = p.begin; k < p.end; ++k) {
      const Box& box = entries[k].box;
      const WideBox rectangle(box.pixels);
      for (int axis = 0; axis < kAxes; ++axis) {
        Bins& of = bins[static_cast<std::size_t>(axis)];
        const std::size_t bin = of.bin(position(box, axis));
        of.box[bin].unite(rectangle);
        ++of.count[bin];
      }
    }
    std::optional<Split> best;
    for (int axis = 0; axis < kAxes; ++axis) {
      const auto of_axis = cheapest(bins[static_cast<std::size_t>(axis)], axis, p.size());
      if (of_axis && (!best || of_axis->cost < best->cost)) best = of_axis;
    }
    if (!best) return halve(p, bins);
    const Bins& of = bins[static_cast<std::size_t>(best->axis)];
    const auto at = [&](std::size_t k) { return entries.begin() + static_cast<std::ptrdiff_t>(k); };
    const auto second = std::partition(at(p.begin), at(p.end), [&](const Entry& entry) {
      return of.bin(position(entry.box, best->axis)) < best->first_above;
    });
    return static_cast<std::size_t>(second - entries.begin());
  }

  /// Splits what costs most until there are as many branches as a node has.
  void branch(Work& work) {
    std::vector<Part>& branches = work.branches;
    branches.push_back(work.part);
    if (work.part.size() <= kBranches) {
      branches.clear();
      for (std::size_t k = work.part.begin; k < work.part.end; ++k) {
        branches.push_back({k, k + 1, entries[k].box});
      }
      return;
    }
    while (branches.size() < kBranches) {
      const auto cost = [](const Part& p) {
        return p.size() > kBranches
                   ? WideBox(p.box.pixels).packets() * static_cast<double>(p.size())
                   : 0.0;
      };
      const auto most =
          std::max_element(branches.begin(), branches.end(),
                           [&](const Part& a, const Part& b) { return cost(a) < cost(b); });
      const Part whole = *most;
      if (whole.size() <= kBranches) break;
      const std::size_t second = split(whole);
      *most = part(whole.begin, second);
      branches.push_back(part(second, whole.end));
    }
  }
};

/// Level by level, so that a level's nodes can be made side by side and numbered in order.
void BoxTree::build(std::span<const Box> boxes, int threads) {
  nodes_.clear();
  if (boxes.empty()) return;
  Builder builder;
  builder.entries.reserve(boxes.size());
  for (const Box& box : boxes) {
    builder.entries.push_back({box, static_cast<Item>(builder.entries.size())});
  }
  std::vector<Builder::Work> level{{0, builder.part(0, boxes.size())}};
  nodes_.emplace_back();
  if (boxes.size() < kWorthThreads) threads = 1;
  while (!level.empty()) {
    in_parallel(threads, level.size(), [&](std::size_t k) { builder.branch(level[k]); });
    std::vector<Builder::Work> next;
    for (const Builder::Work& work : level) {
      Node node;
      for (std::size_t k = 0; k < kBranches; ++k) {
        const bool none = k >= work.branches.size();
        const Box& box = none ? kNothing : work.branches[k].box;
        node.first_column[k] = box.pixels.first_column;
        node.end_column[k] = box.pixels.end_column;
        node.first_row[k] = box.pixels.first_row;
        node.end_row[k] = box.pixels.end_row;
        node.nearest[k] = box.nearest;
        node.branch[k] = 0;
        if (none) continue;
        const Part& part = work.branches[k];
        if (part.size() == 1) {
          node.branch[k] = kItem | builder.entries[part.begin].item;
        } else {
          node.branch[k] = static_cast<std::uint32_t>(nodes_.size());
          next.push_back({node.branch[k], part});
          nodes_.emplace_back();
        }
      }
      nodes_[work.node] = node;
    }
    level = std::move(next);
  }
}

}  // namespace displayfile
