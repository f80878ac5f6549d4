#include "hidden/lines/line_halos.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <tuple>

#include "clip/base/budgeted_work.h"
#include "hidden/lines/chains.h"

namespace displayfile {

JoinedStrokes::JoinedStrokes(std::span<const DeepStroke> strokes)
    : mate_(2 * strokes.size(), kNone) {
  std::vector<ChainLink> links;
  links.reserve(strokes.size());
  for (const DeepStroke& s : strokes) links.push_back({s.from, s.to, s.look});
  const Chains chains = chains_of(links);
  const auto first = [](const Chains::Place& p) { return 2 * p.piece + (p.reversed ? 1u : 0u); };
  const auto at = [&](std::uint32_t end) -> const Point3& {
    return end % 2 == 0 ? strokes[end / 2].from : strokes[end / 2].to;
  };
  for (std::size_t c = 0; c < chains.first.size(); ++c) {
    const auto places = chains.chain(c);
    for (std::size_t i = 1; i < places.size(); ++i)
      pair(first(places[i - 1]) ^ 1u, first(places[i]));
    const std::uint32_t start = first(places.front()), end = first(places.back()) ^ 1u;
    if (places.size() > 2 && at(start) == at(end)) pair(start, end);
  }
  std::vector<std::uint32_t> loose;
  for (std::uint32_t end = 0; end < mate_.size(); ++end) {
    if (mate_[end] == kNone) loose.push_back(end);
  }
  const auto place = [&](std::uint32_t end) {
    return std::tuple(strokes[end / 2].look, at(end).x, at(end).y);
  };
  std::ranges::sort(loose, [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(place(a), a) < std::tuple(place(b), b);
  });
  for (std::size_t i = 0; i + 1 < loose.size(); ++i) {
    if (place(loose[i]) != place(loose[i + 1]) || loose[i] / 2 == loose[i + 1] / 2) continue;
    pair(loose[i], loose[i + 1]);
    ++i;
  }
}

namespace {

/// The gap at one crossing: it extends from there along the farther stroke and the strokes that
/// continue it, while they are within reach of the nearer stroke and of those that continue it.
class Gap {
 public:
  Gap(std::span<const DeepStroke> strokes, const JoinedStrokes& joints, const Point2& pixels,
      std::vector<std::vector<PartOfLine>>& gaps)
      : strokes_(strokes), joints_(joints), pixels_(pixels), gaps_(gaps) {}

  void add(const StrokeOverlap& crossing, double halo) {
    reach_ = halo + strokes_[crossing.near].width / 2.0;
    find_near(crossing);
    walk(crossing, 2 * crossing.far);
    walk(crossing, 2 * crossing.far + 1);
  }

 private:
  Point2 start(std::uint32_t stroke) const { return Point2(strokes_[stroke].from) * pixels_; }
  Point2 end(std::uint32_t stroke) const { return Point2(strokes_[stroke].to) * pixels_; }
  double length(std::uint32_t stroke) const { return glm::distance(start(stroke), end(stroke)); }

  bool is_near(std::uint32_t stroke) const {
    return std::ranges::find(near_, stroke) != near_.end();
  }

  /// Finds the nearer stroke and the strokes that continue it, as far as the gap can reach.
  void find_near(const StrokeOverlap& crossing) {
    constexpr double kLeastSine = 1.0 / 64.0;
    const Point2 u = end(crossing.far) - start(crossing.far);
    const Point2 v = end(crossing.near) - start(crossing.near);
    const double sine = std::abs(u.x * v.y - u.y * v.x) / (glm::length(u) * glm::length(v));
    const double far_enough = 2.0 * reach_ / std::max(sine, kLeastSine);
    near_.assign(1, crossing.near);
    for (const bool forward : {false, true}) {
      double way = length(crossing.near) * (forward ? 1.0 - crossing.at_near : crossing.at_near);
      std::uint32_t at = 2 * crossing.near + (forward ? 1u : 0u);
      while (way < far_enough) {
        const std::uint32_t next = joints_.mate(at);
        if (next == JoinedStrokes::kNone || next / 2 == crossing.far || is_near(next / 2)) break;
        near_.push_back(next / 2);
        way += length(next / 2);
        at = next ^ 1u;
      }
    }
  }

  /// Adds the gap from the crossing toward an end of the farther stroke.
  void walk(const StrokeOverlap& crossing, std::uint32_t toward) {
    double at = crossing.at_far;
    for (std::size_t strokes = 0; strokes <= strokes_.size(); ++strokes) {
      const std::uint32_t stroke = toward / 2;
      const double last = toward % 2 == 0 ? 0.0 : 1.0;
      const double stop = reached(stroke, at, last);
      if (stop != at) gaps_[stroke].push_back({std::min(at, stop), std::max(at, stop)});
      if (stop != last) return;
      const std::uint32_t next = joints_.mate(toward);
      if (next == JoinedStrokes::kNone || next / 2 == crossing.far || is_near(next / 2)) return;
      at = next % 2 == 0 ? 0.0 : 1.0;
      toward = next ^ 1u;
    }
  }

  /// The place up to which a stroke stays within reach, going from a place toward an end.
  double reached(std::uint32_t stroke, double at, double last) {
    within_.clear();
    for (const std::uint32_t near : near_) {
      steps_.step();
      const auto part = part_within(start(stroke), end(stroke), start(near), end(near), reach_);
      if (part) within_.push_back(*part);
    }
    unite(within_);
    constexpr double kBeside = 1e-12;
    for (const PartOfLine& part : within_) {
      if (part.from > at + kBeside || part.to < at - kBeside) continue;
      return last == 0.0 ? std::min(at, part.from) : std::max(at, part.to);
    }
    return at;
  }

  std::span<const DeepStroke> strokes_;
  const JoinedStrokes& joints_;
  Point2 pixels_;
  std::vector<std::vector<PartOfLine>>& gaps_;
  double reach_ = 0.0;
  std::vector<std::uint32_t> near_;
  std::vector<PartOfLine> within_;
  WorkSteps steps_;
};

}  // namespace

std::vector<std::vector<PartOfLine>> halo_gaps(std::span<const DeepStroke> strokes,
                                               std::span<const StrokeOverlap> overlaps,
                                               const JoinedStrokes& joints, const Point2& pixels,
                                               double halo) {
  std::vector<std::vector<PartOfLine>> gaps(strokes.size());
  Gap gap(strokes, joints, pixels, gaps);
  for (const StrokeOverlap& o : overlaps) {
    if (o.crosses && !o.is_tie) gap.add(o, halo);
  }
  for (auto& of_stroke : gaps) unite(of_stroke);
  return gaps;
}

}  // namespace displayfile
