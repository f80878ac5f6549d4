#include "programs/sheet/chained_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <map>
#include <utility>

namespace displayfile {

namespace {

constexpr double kSamePoint = 1e-5;  // mm: ends this near are one point

/// The lines of one kind, by the points at which they end.
class LineChains {
 public:
  explicit LineChains(std::vector<PartDrawing::Line> lines) : lines_(std::move(lines)) {
    for (std::uint32_t i = 0; i < lines_.size(); ++i) {
      at_[key(lines_[i].from)].push_back(i);
      at_[key(lines_[i].to)].push_back(i);
    }
    taken_.assign(lines_.size(), false);
  }

  /// Chains that begin somewhere, and then those that go round.
  template <class Visit>
  void for_each(const Visit& visit) {
    for (const bool round : {false, true}) {
      for (std::uint32_t i = 0; i < lines_.size(); ++i) {
        if (taken_[i]) continue;
        if (round || begins_at(lines_[i].from)) {
          visit(follow(i, false));
        } else if (begins_at(lines_[i].to)) {
          visit(follow(i, true));
        }
      }
    }
  }

 private:
  using Key = std::pair<std::int64_t, std::int64_t>;
  static Key key(const Point2& p) {
    return {std::llround(p.x / kSamePoint), std::llround(p.y / kSamePoint)};
  }
  bool begins_at(const Point2& p) const { return at_.at(key(p)).size() != 2; }

  std::vector<Point2> follow(std::uint32_t line, bool reverse) {
    std::vector<Point2> points{reverse ? lines_[line].to : lines_[line].from};
    while (true) {
      taken_[line] = true;
      points.push_back(reverse ? lines_[line].from : lines_[line].to);
      const Key end = key(points.back());
      const auto& here = at_.at(end);
      if (here.size() != 2) return points;
      const std::uint32_t next = here[0] == line ? here[1] : here[0];
      if (taken_[next]) return points;
      line = next;
      reverse = key(lines_[line].from) != end;
    }
  }

  std::vector<PartDrawing::Line> lines_;
  std::map<Key, std::vector<std::uint32_t>> at_;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<DrawingSheet::Line> chained_lines(const std::vector<PartDrawing::Line>& lines) {
  std::vector<DrawingSheet::Line> out;
  for (const bool hidden : {true, false}) {
    std::vector<PartDrawing::Line> kind;
    std::ranges::copy_if(lines, std::back_inserter(kind),
                         [&](const PartDrawing::Line& line) { return line.hidden == hidden; });
    LineChains(std::move(kind)).for_each([&](std::vector<Point2> points) {
      const SheetLayer layer = hidden ? SheetLayer::hidden : SheetLayer::visible;
      const Point2 gap = glm::abs(points.front() - points.back());
      const bool closed = points.size() > 3 && std::max(gap.x, gap.y) < kSamePoint;
      if (closed) points.pop_back();
      out.push_back({layer, std::move(points), closed});
    });
  }
  return out;
}

}  // namespace displayfile
