#include "hidden/lines/carried_counts.h"

#include <algorithm>
#include <limits>

#include "clip/base/parallel.h"

namespace displayfile {

LineVertices::LineVertices(const LineTable& scene, const Primitives& items, const SideTable& sides,
                           const ContourEdges& contours)
    : sides_(sides), joins_(items.points.size(), 0), first_(items.points.size() + 1, 0) {
  for (const std::uint32_t n : scene.first_lines_of_names()) {
    for (const std::uint32_t point : {scene.lines()[n].a, scene.lines()[n].b}) {
      std::uint8_t& ends = joins_[vertex(point)];
      ends = static_cast<std::uint8_t>(std::min(ends + 1, 2));
    }
  }
  for (std::uint8_t& ends : joins_) ends = ends == 2 ? 1 : 0;
  const auto for_each_corner = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < items.items.size(); ++i) {
      if (contours.way(i) == 0) continue;
      for (std::uint32_t k = 0; k < items.items[i].sides; ++k) {
        const std::uint32_t v = vertex(items.point(items.items[i].first + k));
        if (joins_[v] != 0) visit(v, LineName{i, k});
      }
    }
  };
  for_each_corner([&](std::uint32_t v, const LineName&) { ++first_[v + 1]; });
  for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  corners_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for_each_corner([&](std::uint32_t v, const LineName& corner) { corners_[next[v]++] = corner; });
}

namespace {

constexpr std::uint32_t kNoPart = std::numeric_limits<std::uint32_t>::max();

/// A set of connected lines. Each vertex's count is known relative to that of the first vertex.
struct Part {
  std::uint32_t line;  ///< a line at the first vertex
  std::uint32_t first;
  bool adds_up = true;
  std::int32_t base = 0;  ///< the count at the first vertex
};

/// The counts at the vertices that carry, relative to those of their parts' first vertices.
class Parts {
 public:
  Parts(std::span<const CountedLine> lines, std::span<const std::uint8_t> carries)
      : lines_(lines),
        carries_(carries),
        first_line_(carries.size() + 1, 0),
        part_(carries.size(), kNoPart),
        base_(carries.size(), 0) {
    list_lines();
    for (std::uint32_t v = 0; v < carries.size(); ++v) {
      if (carries_[v] != 0 && part_[v] == kNoPart && first_line_[v] < first_line_[v + 1]) follow(v);
    }
  }

  std::vector<Part>& parts() { return part_list_; }
  /// The part of a line, or kNoPart.
  std::uint32_t part_of(const CountedLine& line) const {
    return part_[line.from] != kNoPart ? part_[line.from] : part_[line.to];
  }
  /// The counts at the line's start, derived from its vertex's count.
  SideCounts start(const CountedLine& line) const {
    const bool by_from = part_[line.from] != kNoPart;
    const std::uint32_t v = by_from ? line.from : line.to;
    const std::int32_t base = part_list_[part_[v]].base + base_[v];
    const SideCounts around{base, base};
    return by_from ? around + line.star_from : around + line.star_to - line.change;
  }

 private:
  void list_lines() {
    const auto for_each_end = [&](const auto& visit) {
      for (std::uint32_t n = 0; n < lines_.size(); ++n) {
        if (carries_[lines_[n].from] != 0) visit(lines_[n].from, n);
        if (carries_[lines_[n].to] != 0) visit(lines_[n].to, n);
      }
    };
    for_each_end([&](std::uint32_t v, std::uint32_t) { ++first_line_[v + 1]; });
    for (std::size_t v = 1; v < first_line_.size(); ++v) first_line_[v] += first_line_[v - 1];
    of_vertex_.resize(first_line_.back());
    std::vector<std::uint32_t> next(first_line_.begin(), first_line_.end() - 1);
    for_each_end([&](std::uint32_t v, std::uint32_t n) { of_vertex_[next[v]++] = n; });
  }

  /// Follows lines from vertex to vertex, starting at one.
  void follow(std::uint32_t first) {
    const auto number = static_cast<std::uint32_t>(part_list_.size());
    part_list_.push_back({of_vertex_[first_line_[first]], first});
    part_[first] = number;
    reached_.assign(1, first);
    while (!reached_.empty()) {
      const std::uint32_t v = reached_.back();
      reached_.pop_back();
      for (std::uint32_t i = first_line_[v]; i < first_line_[v + 1]; ++i) {
        const CountedLine& line = lines_[of_vertex_[i]];
        const SideCounts gain = line.star_from + line.change - line.star_to;
        const std::uint32_t w = line.from == v ? line.to : line.from;
        if (carries_[w] == 0) continue;
        const std::int32_t base = line.from == v ? base_[v] + gain.left : base_[v] - gain.left;
        if (part_[w] == kNoPart) {
          part_[w] = number;
          base_[w] = base;
          reached_.push_back(w);
        }
        if (base_[w] != base || gain.left != gain.right) part_list_[number].adds_up = false;
      }
    }
  }

  std::span<const CountedLine> lines_;
  std::span<const std::uint8_t> carries_;
  std::vector<std::uint32_t> first_line_, of_vertex_;  // the lines of each vertex that carries
  std::vector<std::uint32_t> part_;                    // per vertex
  std::vector<std::int32_t> base_;                     // per vertex, relative to its part's
  std::vector<Part> part_list_;
  std::vector<std::uint32_t> reached_;
};

template <class Work>
void for_each_ray(std::size_t size, int threads, const Work& work) {
  constexpr std::size_t kRaysAtATime = 32;
  in_parallel(threads, (size + kRaysAtATime - 1) / kRaysAtATime, [&](std::size_t part) {
    const std::size_t end = std::min(size, (part + 1) * kRaysAtATime);
    for (std::size_t k = part * kRaysAtATime; k < end; ++k) work(k);
  });
}

}  // namespace

CarriedCounts::CarriedCounts(std::span<const CountedLine> lines,
                             std::span<const std::uint8_t> carries, const Ray& ray, int threads)
    : start(lines.size()) {
  Parts parts(lines, carries);
  for_each_ray(parts.parts().size(), threads, [&](std::size_t k) {
    Part& part = parts.parts()[k];
    if (!part.adds_up) return;
    const CountedLine& line = lines[part.line];
    const SideCounts after_start = ray(part.line);
    const SideCounts around = line.from == part.first ? after_start - line.star_from
                                                      : after_start + line.change - line.star_to;
    part.base = around.left;
    part.adds_up = around.left == around.right;
  });
  std::vector<std::uint32_t> alone;
  for (std::uint32_t n = 0; n < lines.size(); ++n) {
    const std::uint32_t part = parts.part_of(lines[n]);
    if (part != kNoPart && parts.parts()[part].adds_up) {
      start[n] = parts.start(lines[n]);
    } else {
      alone.push_back(n);
    }
  }
  for_each_ray(alone.size(), threads, [&](std::size_t k) { start[alone[k]] = ray(alone[k]); });
  rays =
      alone.size() + static_cast<std::size_t>(std::ranges::count_if(parts.parts(), &Part::adds_up));
  carried = lines.size() - rays;
}

}  // namespace displayfile
