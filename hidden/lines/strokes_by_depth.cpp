#include "hidden/lines/strokes_by_depth.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <queue>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "hidden/lines/line_halos.h"

namespace displayfile {

namespace {

using Node = std::uint32_t;  // a part of a stroke

/// A place where a stroke is cut so that its parts can be drawn at different times. The part drawn
/// first extends over the cut by `lap`, so that no gap is visible.
struct OrderCut {
  double at, lap;
};

/// One stroke's share of an overlap.
struct Mark {
  double at;
  PartOfLine zone;
  bool is_near;
  std::uint32_t overlap;
};

/// The strokes' parts, and their drawing order.
class DepthOrder {
 public:
  DepthOrder(std::span<const DeepStroke> strokes, const StrokePicture& picture,
             std::vector<StrokeOverlap> overlaps, std::vector<std::vector<PartOfLine>> gaps)
      : strokes_(strokes),
        picture_(picture),
        overlaps_(std::move(overlaps)),
        gaps_(std::move(gaps)),
        cuts_(strokes.size()) {}

  std::vector<PartByDepth> parts() {
    constexpr int kRounds = 16;  // each cuts the remaining cycles; one round nearly always suffices
    find_parts();
    find_edges();
    for (int round = 0; round < kRounds && cut_circles(); ++round) {
      find_parts();
      find_edges();
    }
    return in_order();
  }

 private:
  struct Part {
    std::uint32_t stroke;
    double from, to;
    bool gap_before, gap_after;  // gaps at its ends, not only cuts
  };

  // ---- Parts ---------------------------------------------------------------------------------

  /// Finds the parts of each stroke between gaps and cuts, in order along it.
  void find_parts() {
    parts_.clear();
    first_.assign(1, 0);
    for (std::uint32_t s = 0; s < strokes_.size(); ++s) {
      double from = 0.0;
      bool gap_before = false;
      for (const PartOfLine& gap : gaps_[s]) {
        add_parts(s, from, gap.from, gap_before, true);
        from = gap.to;
        gap_before = true;
      }
      add_parts(s, from, 1.0, gap_before, false);
      first_.push_back(static_cast<Node>(parts_.size()));
    }
  }

  void add_parts(std::uint32_t stroke, double from, double to, bool gap_before, bool gap_after) {
    const bool is_whole = from == 0.0 && to == 1.0;
    if (!(from < to) && !is_whole) return;
    for (const OrderCut& cut : cuts_[stroke]) {
      if (!(from < cut.at && cut.at < to)) continue;
      parts_.push_back({stroke, from, cut.at, gap_before, false});
      from = cut.at;
      gap_before = false;
    }
    parts_.push_back({stroke, from, to, gap_before, gap_after});
  }

  /// Calls visit(part) for the parts of a stroke that meet the zone of an overlap.
  template <class Visit>
  void for_each_part(std::uint32_t stroke, double at, const PartOfLine& zone, const Visit& visit) {
    const auto begin = parts_.begin() + first_[stroke], end = parts_.begin() + first_[stroke + 1];
    auto part = std::lower_bound(begin, end, zone.from,
                                 [](const Part& p, double from) { return p.to < from; });
    for (; part != end && part->from <= zone.to; ++part) {
      const bool overlaps = std::max(part->from, zone.from) < std::min(part->to, zone.to);
      if (overlaps || (part->from <= at && at <= part->to)) {
        visit(static_cast<Node>(part - parts_.begin()));
      }
    }
  }

  // ---- The order of parts --------------------------------------------------------------------

  bool orders(const StrokeOverlap& o) const {
    return !o.is_tie || strokes_[o.far].look != strokes_[o.near].look;
  }

  struct Edge {
    Node before, after;
    auto operator<=>(const Edge&) const = default;
  };

  void find_edges() {
    edges_.clear();
    for (const StrokeOverlap& o : overlaps_) {
      steps_.step();
      if (!orders(o)) continue;
      for_each_part(o.far, o.at_far, o.of_far, [&](Node before) {
        for_each_part(o.near, o.at_near, o.of_near, [&](Node after) {
          edges_.push_back({before, after});
        });
      });
    }
    std::ranges::sort(edges_);
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    first_edge_.assign(parts_.size() + 1, 0);
    for (const Edge& edge : edges_) ++first_edge_[edge.before + 1];
    for (std::size_t n = 1; n < first_edge_.size(); ++n) first_edge_[n] += first_edge_[n - 1];
  }

  std::span<const Edge> edges_of(Node n) const {
    return std::span(edges_).subspan(first_edge_[n], first_edge_[n + 1] - first_edge_[n]);
  }

  std::vector<std::uint32_t> edges_into() const {
    std::vector<std::uint32_t> into(parts_.size(), 0);
    for (const Edge& edge : edges_) ++into[edge.after];
    return into;
  }

  // ---- Cycles --------------------------------------------------------------------------------

  static constexpr std::uint32_t kNoCircle = 0xffffffffu;

  /// For each part the number of its cycle of parts that must follow each other, or kNoCircle.
  /// Tarjan's strongly connected components, with an explicit stack.
  std::vector<std::uint32_t> circles() const {
    struct Visit {
      Node node;
      std::size_t edge;
    };
    const auto nodes = static_cast<Node>(parts_.size());
    std::vector<std::uint32_t> number(nodes, 0), low(nodes, 0), circle(nodes, kNoCircle);
    std::vector<std::uint8_t> open(nodes, 0);
    std::vector<Node> stack;
    std::vector<Visit> way;
    std::uint32_t next = 0, found = 0;
    const auto enter = [&](Node n) {
      number[n] = low[n] = ++next;
      open[n] = 1;
      stack.push_back(n);
      way.push_back({n, first_edge_[n]});
    };
    for (Node root = 0; root < nodes; ++root) {
      if (number[root] != 0) continue;
      enter(root);
      while (!way.empty()) {
        const Node n = way.back().node;
        if (way.back().edge < first_edge_[n + 1]) {
          const Node to = edges_[way.back().edge++].after;
          if (number[to] == 0) {
            enter(to);
          } else if (open[to] != 0) {
            low[n] = std::min(low[n], number[to]);
          }
          continue;
        }
        way.pop_back();
        if (!way.empty()) low[way.back().node] = std::min(low[way.back().node], low[n]);
        if (low[n] != number[n]) continue;
        const bool alone = stack.back() == n;
        while (true) {
          const Node member = stack.back();
          stack.pop_back();
          open[member] = 0;
          if (!alone) circle[member] = found;
          if (member == n) break;
        }
        if (!alone) ++found;
      }
    }
    return circle;
  }

  /// Cuts strokes in cycles between the places where they must be drawn later than others and
  /// earlier than others, so that no part must be both. False if there is nothing to cut.
  bool cut_circles() {
    const std::vector<std::uint32_t> circle = circles();
    if (std::ranges::all_of(circle, [](std::uint32_t c) { return c == kNoCircle; })) return false;
    std::vector<std::vector<Mark>> marks(parts_.size());
    bool any = false;
    for (std::uint32_t k = 0; k < overlaps_.size(); ++k) {
      const StrokeOverlap& o = overlaps_[k];
      if (!orders(o)) continue;
      for_each_part(o.far, o.at_far, o.of_far, [&](Node before) {
        if (circle[before] == kNoCircle) return;
        for_each_part(o.near, o.at_near, o.of_near, [&](Node after) {
          if (circle[after] != circle[before]) return;
          marks[before].push_back({o.at_far, o.of_far, false, k});
          marks[after].push_back({o.at_near, o.of_near, true, k});
        });
      });
    }
    for (Node n = 0; n < parts_.size(); ++n) any = cut_between(parts_[n], marks[n]) || any;
    if (!any) return false;
    for (auto& cuts : cuts_) std::ranges::sort(cuts, {}, &OrderCut::at);
    for (StrokeOverlap& o : overlaps_) {
      keep_beside_cuts(o.far, o.at_far, o.of_far);
      keep_beside_cuts(o.near, o.at_near, o.of_near);
    }
    return true;
  }

  bool cut_between(const Part& part, std::vector<Mark>& marks) {
    bool any = false;
    std::ranges::sort(marks, [](const Mark& a, const Mark& b) {
      return std::pair(a.at, a.overlap) < std::pair(b.at, b.overlap);
    });
    for (std::size_t i = 1; i < marks.size(); ++i) {
      const Mark &a = marks[i - 1], &b = marks[i];
      if (a.is_near == b.is_near || !(a.at < b.at)) continue;
      const double room = b.zone.from - a.zone.to;
      const double at = room > 0.0 ? a.zone.to + room / 2.0 : a.at + (b.at - a.at) / 2.0;
      if (!(part.from < at && at < part.to)) continue;
      constexpr double kLap = 0.5;  // pixels
      const DeepStroke& s = strokes_[part.stroke];
      const double length = glm::length(Point2(s.to - s.from) * picture_.pixels);
      cuts_[part.stroke].push_back({at, std::min(kLap / length, std::max(room, 0.0) / 2.0)});
      any = true;
    }
    return any;
  }

  /// An overlap only orders the part on its own side of a cut.
  void keep_beside_cuts(std::uint32_t stroke, double at, PartOfLine& zone) const {
    for (const OrderCut& cut : cuts_[stroke]) {
      if (at < cut.at) {
        zone.to = std::min(zone.to, cut.at);
      } else {
        zone.from = std::max(zone.from, cut.at);
      }
    }
  }

  // ---- The order -----------------------------------------------------------------------------

  /// Orders the parts so that each comes after those that it must follow: among free parts, the
  /// first in the given order of strokes. In a cycle that could not be cut, the first goes first.
  std::vector<PartByDepth> in_order() {
    std::vector<std::uint32_t> into = edges_into();
    std::priority_queue<Node, std::vector<Node>, std::greater<>> free;
    std::vector<std::uint8_t> drawn(parts_.size(), 0);
    std::vector<PartByDepth> all;
    all.reserve(parts_.size());
    for (Node n = 0; n < parts_.size(); ++n) {
      if (into[n] == 0) free.push(n);
    }
    Node after = 0, first_left = 0;
    while (all.size() < parts_.size()) {
      Node next = after;
      if (!(next < parts_.size() && drawn[next] == 0 && into[next] == 0)) {
        while (!free.empty() && drawn[free.top()] != 0) free.pop();
        while (first_left < parts_.size() && drawn[first_left] != 0) ++first_left;
        next = free.empty() ? first_left : free.top();
      }
      drawn[next] = 1;
      after = next + 1;
      all.push_back(lapped(next, drawn));
      for (const Edge& edge : edges_of(next)) {
        if (--into[edge.after] == 0) free.push(edge.after);
      }
    }
    return all;
  }

  PartByDepth lapped(Node n, const std::vector<std::uint8_t>& drawn) const {
    const Part& whole = parts_[n];
    PartByDepth part{whole.stroke,
                     whole.from,
                     whole.to,
                     {whole.from > 0.0, whole.to < 1.0},
                     whole.gap_before && whole.gap_after};
    const auto lap_at = [&](double at) {
      const auto& cuts = cuts_[whole.stroke];
      const auto cut = std::ranges::find(cuts, at, &OrderCut::at);
      return cut == cuts.end() ? 0.0 : cut->lap;
    };
    if (whole.from > 0.0 && !whole.gap_before && drawn[n - 1] == 0) {
      part.from = std::max(0.0, whole.from - lap_at(whole.from));
    }
    if (whole.to < 1.0 && !whole.gap_after && drawn[n + 1] == 0) {
      part.to = std::min(1.0, whole.to + lap_at(whole.to));
    }
    return part;
  }

  std::span<const DeepStroke> strokes_;
  const StrokePicture& picture_;
  std::vector<StrokeOverlap> overlaps_;
  std::vector<std::vector<PartOfLine>> gaps_;
  std::vector<std::vector<OrderCut>> cuts_;  // per stroke, in order along it
  std::vector<Part> parts_;
  std::vector<Node> first_;  // per stroke, among the parts; and the end
  std::vector<Edge> edges_;
  std::vector<std::size_t> first_edge_;  // per part; and the end
  WorkSteps steps_;
};

/// Extends gaps that begin or end at a stroke's end except for rounding to that end.
void close_at_ends(std::vector<PartOfLine>& gaps) {
  constexpr double kBesideEnd = 1e-9;
  for (PartOfLine& gap : gaps) {
    if (gap.from < kBesideEnd) gap.from = 0.0;
    if (gap.to > 1.0 - kBesideEnd) gap.to = 1.0;
  }
}

}  // namespace

std::vector<PartByDepth> strokes_by_depth(std::span<const DeepStroke> strokes,
                                          const StrokePicture& picture, double halo, int threads) {
  std::vector<StrokeOverlap> overlaps = stroke_overlaps(strokes, picture, threads);
  const JoinedStrokes joined(strokes);
  std::erase_if(overlaps, [&](const StrokeOverlap& o) { return joined.join(o.far, o.near); });
  std::vector<std::vector<PartOfLine>> gaps(strokes.size());
  if (halo > 0.0) gaps = halo_gaps(strokes, overlaps, joined, picture.pixels, halo);
  for (auto& of_stroke : gaps) close_at_ends(of_stroke);
  return DepthOrder(strokes, picture, std::move(overlaps), std::move(gaps)).parts();
}

}  // namespace displayfile
