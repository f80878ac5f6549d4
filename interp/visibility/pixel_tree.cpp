#include "interp/visibility/pixel_tree.h"

#include <algorithm>
#include <optional>

#include "hidden/boxes/build_box_tree.h"

namespace displayfile {

namespace {

/// The columns and rows of a typical packet of rays: the number of packets that meet a box is
/// proportional to the sum of its size and theirs.
constexpr double kPacket = 8.0;
/// The probability that the back half must be visited too after the front half.
constexpr double kBehind = 0.5;
constexpr int kBins = 16;
/// Up to this number, items are halved without evaluating the costs of splits.
constexpr std::size_t kFewFills = 64;
/// The smaller part of a split has at least this fraction of the items, as BoxTree requires.
constexpr std::size_t kLeastPart = 8;

using Entry = BoxEntry<DeepPixelBox>;
using Spread = MiddlesSpread<DeepPixelBox>;
constexpr std::size_t kColumn = DeepPixelBox::kColumn, kRow = DeepPixelBox::kRow;
constexpr std::size_t kDepth = DeepPixelBox::kDepth, kAxes = DeepPixelBox::kAxes;

/// The data of a box in the cost: the minima of first column and row and of the negated ends, so
/// that one operation on four numbers forms the union of two boxes. Rounded beyond 2^24, as is
/// acceptable for costs.
struct WideBox {
  std::array<float, 4> least;

  explicit WideBox(const PixelBox& p)
      : least{static_cast<float>(p.first_column), static_cast<float>(p.first_row),
              -static_cast<float>(p.end_column), -static_cast<float>(p.end_row)} {}
  static WideBox nothing() { return WideBox(DeepPixelBox::nothing().pixels); }

  void unite(const WideBox& other) {
    for (std::size_t k = 0; k < 4; ++k) {
      least[k] = other.least[k] < least[k] ? other.least[k] : least[k];
    }
  }
  /// Proportional to the number of packets that meet the box.
  double packets() const {
    const double columns = -static_cast<double>(least[2]) - least[0];
    const double rows = -static_cast<double>(least[3]) - least[1];
    return columns > 0.0 ? (columns + kPacket) * (rows + kPacket) : 0.0;
  }
};

/// The bins of one axis.
struct Bins {
  double low, scale;
  std::array<WideBox, kBins> box;
  std::array<std::size_t, kBins> count{};

  Bins(double low_, double high)
      : low(low_), scale(high > low_ ? kBins / (high - low_) : 0.0), box(nothing()) {}
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
  std::size_t axis;
  std::size_t first_above;  // the first bin of the upper part
  double cost;
};

/// The cheapest split between two bins of an axis, if one leaves both parts large enough.
std::optional<Split> cheapest(const Bins& bins, std::size_t axis, std::size_t items) {
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

/// The splitting rule with the fewest visits of packets: the surface area heuristic with two
/// dimensions, for rays along z.
struct FewestVisits {
  static double cost(const DeepPixelBox& box, std::size_t items) {
    return WideBox(box.pixels).packets() * static_cast<double>(items);
  }

  static std::size_t divide(std::span<Entry> entries) {
    const Spread spread(entries);
    if (entries.size() <= kFewFills) return halve(entries, axis_to_halve(spread));
    std::array<Bins, kAxes> bins{Bins(spread.low[kColumn], spread.high[kColumn]),
                                 Bins(spread.low[kRow], spread.high[kRow]),
                                 Bins(spread.low[kDepth], spread.high[kDepth])};
    for (const Entry& entry : entries) {
      const WideBox rectangle(entry.box.pixels);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const std::size_t bin = bins[axis].bin(entry.box.position(axis));
        bins[axis].box[bin].unite(rectangle);
        ++bins[axis].count[bin];
      }
    }
    std::optional<Split> best;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto of_axis = cheapest(bins[axis], axis, entries.size());
      if (of_axis && (!best || of_axis->cost < best->cost)) best = of_axis;
    }
    if (!best) return halve(entries, axis_to_halve(spread));
    const Bins& of = bins[best->axis];
    const auto second = std::partition(entries.begin(), entries.end(), [&](const Entry& entry) {
      return of.bin(entry.box.position(best->axis)) < best->first_above;
    });
    return static_cast<std::size_t>(second - entries.begin());
  }

 private:
  /// Rows or columns, where the centres are spread most; depth, if all are within a packet.
  static std::size_t axis_to_halve(const Spread& spread) {
    const double columns = spread.along(kColumn), rows = spread.along(kRow);
    return std::max(columns, rows) < kPacket ? kDepth : columns >= rows ? kColumn : kRow;
  }
};

}  // namespace

template <>
void PixelTree::build(std::size_t items, const std::function<DeepPixelBox(Item)>& box_of,
                      int threads) {
  build_by<FewestVisits>(items, box_of, threads);
}

}  // namespace displayfile
