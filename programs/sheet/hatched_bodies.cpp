#include "programs/sheet/hatched_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "displayfile/solids/hatched_loops.h"
#include "hidden/disjoint_sets.h"

namespace displayfile {

namespace {

using Loops = std::vector<std::vector<Point2>>;
using Pair = std::pair<std::uint32_t, std::uint32_t>;  // the smaller first

Pair pair_of(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

/// A part of a hatching line; the line passes the origin at `line` times the spacing.
struct Stretch {
  std::int64_t line;
  double from, to;
  std::uint32_t body = 0;
  double length() const { return to - from; }
  bool operator<(const Stretch& o) const {
    return std::tuple(line, from, body) < std::tuple(o.line, o.from, o.body);
  }
};

std::vector<Stretch> stretches_within(const Loops& loops, double spacing, const Point2& direction,
                                      std::uint32_t body = 0) {
  std::vector<Stretch> all;
  for (const auto& [from, to] : hatched_loops(loops, WithinLoops::wound, spacing, direction)) {
    const double across = (from.y * direction.x - from.x * direction.y) / spacing;
    all.push_back({std::llround(across), glm::dot(from, direction), glm::dot(to, direction), body});
  }
  return all;
}

double twice_area(const Loops& loops) {
  double sum = 0.0;
  for (const auto& loop : loops) {
    for (std::size_t k = 2; k < loop.size(); ++k) {
      const Point2 a = loop[k - 1] - loop[0], b = loop[k] - loop[0];
      sum += a.x * b.y - a.y * b.x;
    }
  }
  return sum;
}

/// The cut faces of one view, on paper, of each body or group that is cut there.
using FacesOfBodies = std::map<std::uint32_t, Loops>;

FacesOfBodies cut_faces(const PartDrawing& view, double mm) {
  FacesOfBodies faces;
  for (const PartDrawing::CutLoop& loop : view.cut) {
    auto& points = faces[loop.body].emplace_back(loop.points);
    for (Point2& p : points) p *= mm;
  }
  return faces;
}

/// The length of test lines that the faces of a view share, in pairs; a face paired with itself has
/// its own.
class SharedLengths {
 public:
  SharedLengths(const FacesOfBodies& faces, double spacing) {
    std::vector<Stretch> all;
    for (const auto& [body, loops] : faces) {
      const auto own = stretches_within(loops, spacing, kHatchingDirection, body);
      all.insert(all.end(), own.begin(), own.end());
    }
    std::sort(all.begin(), all.end());
    std::vector<Stretch> open;  // that continue where the next begins
    for (const Stretch& next : all) {
      std::erase_if(open,
                    [&](const Stretch& o) { return o.line != next.line || o.to <= next.from; });
      open.push_back(next);
      for (const Stretch& o : open) {
        lengths_[pair_of(o.body, next.body)] += std::min(o.to, next.to) - next.from;
      }
    }
  }
  double of(std::uint32_t a, std::uint32_t b) const {
    const auto found = lengths_.find(pair_of(a, b));
    return found == lengths_.end() ? 0.0 : found->second;
  }
  const std::map<Pair, double>& all() const { return lengths_; }

 private:
  std::map<Pair, double> lengths_;
};

constexpr double kTestLines = 0.25;  // apart, in parts of the spacing

/// A cavity is hatched with the smallest body around it.
void join_cavities(const FacesOfBodies& faces, double spacing, DisjointSets& groups) {
  std::vector<std::uint32_t> cavities;
  for (const auto& [body, loops] : faces) {
    if (twice_area(loops) < 0.0) cavities.push_back(body);
  }
  if (cavities.empty()) return;
  const SharedLengths shared(faces, kTestLines * spacing);
  for (const std::uint32_t cavity : cavities) {
    std::optional<std::uint32_t> around;
    for (const auto& [body, loops] : faces) {
      if (twice_area(loops) < 0.0) continue;
      const bool is_around = shared.of(body, cavity) > 0.5 * shared.of(cavity, cavity);
      if (is_around && (!around || shared.of(body, body) < shared.of(*around, *around))) {
        around = body;
      }
    }
    if (around) groups.join(*around, cavity);
  }
}

FacesOfBodies grouped(const FacesOfBodies& faces, DisjointSets& groups) {
  FacesOfBodies of_groups;
  for (const auto& [body, loops] : faces) {
    Loops& all = of_groups[groups.name(body)];
    all.insert(all.end(), loops.begin(), loops.end());
  }
  return of_groups;
}

/// The intersection of bodies counts as material of both.
void join_overlapping(const FacesOfBodies& faces, double spacing, DisjointSets& groups) {
  constexpr double kOverlap = 0.01;
  if (faces.size() < 2) return;
  const SharedLengths shared(faces, kTestLines * spacing);
  for (const auto& [pair, length] : shared.all()) {
    const auto [a, b] = pair;
    const double smaller = std::min(shared.of(a, a), shared.of(b, b));
    if (a != b && length > kOverlap * smaller) groups.join(a, b);
  }
}

struct Side {
  Point2 from, to;
  std::uint32_t body;
};

double distance(const Point2& p, const Side& side) {
  const Point2 along = side.to - side.from;
  const double length = glm::dot(along, along);
  const double t =
      length > 0.0 ? std::clamp(glm::dot(p - side.from, along) / length, 0.0, 1.0) : 0.0;
  return glm::distance(p, side.from + t * along);
}

/// For sides that do not cross: sides that do belong to bodies that overlap or nearly touch.
double distance(const Side& a, const Side& b) {
  return std::min({distance(a.from, b), distance(a.to, b), distance(b.from, a), distance(b.to, a)});
}

/// Finds the faces of a view that are nearer than `reach`, by squares of that size.
class Neighbours {
 public:
  Neighbours(const FacesOfBodies& faces, double reach, std::set<Pair>& found)
      : reach_(reach), found_(found) {
    for (const auto& [body, loops] : faces) {
      for (const auto& loop : loops) {
        Point2 from = loop.back();
        for (const Point2& to : loop) add({std::exchange(from, to), to, body});
      }
    }
    for (auto& [square, sides] : squares_) {
      for (const auto& [x, y] :
           {Square{0, 0}, Square{1, 0}, Square{0, 1}, Square{1, 1}, Square{1, -1}}) {
        const auto other = squares_.find({square.first + x, square.second + y});
        if (other != squares_.end()) compare(sides, other->second);
      }
    }
  }

 private:
  using Square = std::pair<std::int64_t, std::int64_t>;

  void add(const Side& side) {
    const auto index = static_cast<std::uint32_t>(sides_.size());
    sides_.push_back(side);
    const double length = glm::distance(side.from, side.to);
    const auto steps = static_cast<std::int64_t>(std::ceil(2.0 * length / reach_)) + 1;
    for (std::int64_t k = 0; k <= steps; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(steps);
      const Point2 p = glm::floor((side.from + t * (side.to - side.from)) / reach_);
      auto& here = squares_[{std::llround(p.x), std::llround(p.y)}];
      if (here.empty() || here.back() != index) here.push_back(index);
    }
  }
  void compare(const std::vector<std::uint32_t>& here, const std::vector<std::uint32_t>& there) {
    for (const std::uint32_t i : here) {
      for (const std::uint32_t k : there) {
        const Side &a = sides_[i], &b = sides_[k];
        if (a.body == b.body || found_.contains(pair_of(a.body, b.body))) continue;
        if (distance(a, b) < reach_) found_.insert(pair_of(a.body, b.body));
      }
    }
  }

  double reach_;
  std::set<Pair>& found_;
  std::vector<Side> sides_;
  std::map<Square, std::vector<std::uint32_t>> squares_;
};

/// The kinds of hatching in order: both directions at each spacing, each half as much wider again.
BodyHatching kind_of_hatching(std::size_t kind, double spacing) {
  constexpr std::array kDirections{kHatchingDirection,
                                   Point2(-kHatchingDirection.x, kHatchingDirection.y)};
  return {kDirections[kind % 2], spacing * (1.0 + 0.5 * static_cast<double>(kind / 2)), 0};
}

/// The first kind that no neighbour has; preferably that of an earlier group of the same part.
std::size_t kind_for(const std::set<std::size_t>& taken, std::optional<std::size_t> of_part) {
  if (of_part && !taken.contains(*of_part)) return *of_part;
  std::size_t kind = 0;
  while (taken.contains(kind)) ++kind;
  return kind;
}

}  // namespace

std::vector<BodyHatching> hatching_of_bodies(std::span<const PartDrawing> views, double mm,
                                             double spacing) {
  std::size_t bodies = 0;
  std::map<std::uint32_t, std::uint32_t> part_of;  // of bodies
  for (const PartDrawing& view : views) {
    for (const PartDrawing::CutLoop& loop : view.cut) {
      bodies = std::max<std::size_t>(bodies, loop.body + 1);
      part_of.emplace(loop.body, loop.part);
    }
  }
  DisjointSets groups(bodies);
  for (const PartDrawing& view : views) join_cavities(cut_faces(view, mm), spacing, groups);
  for (const PartDrawing& view : views) {
    join_overlapping(grouped(cut_faces(view, mm), groups), spacing, groups);
  }
  std::set<Pair> near;
  for (const PartDrawing& view : views) {
    Neighbours(grouped(cut_faces(view, mm), groups), 2.0 * spacing, near);
  }
  std::map<std::uint32_t, std::size_t> kind_of_group, kind_of_part;
  std::vector<BodyHatching> all(bodies);
  for (const auto& [body, part] : part_of) {
    const std::uint32_t group = groups.name(body);
    if (!kind_of_group.contains(group)) {
      std::set<std::size_t> taken;
      for (const auto& [other, kind] : kind_of_group) {
        if (near.contains(pair_of(group, other))) taken.insert(kind);
      }
      const auto before = kind_of_part.find(part);
      const std::size_t kind = kind_for(
          taken, before == kind_of_part.end() ? std::nullopt : std::optional(before->second));
      kind_of_group[group] = kind;
      kind_of_part.emplace(part, kind);
    }
    all[body] = kind_of_hatching(kind_of_group[group], spacing);
    all[body].group = group;
  }
  return all;
}

std::vector<std::pair<Point2, Point2>> hatching_lines(
    const std::vector<std::vector<Point2>>& loops, const std::vector<std::vector<Point2>>& before,
    const BodyHatching& hatching) {
  const Point2& along = hatching.direction;
  if (before.empty()) {
    return hatched_loops(loops, WithinLoops::wound, hatching.spacing, along);
  }
  const auto hidden = stretches_within(before, hatching.spacing, along);
  std::vector<std::pair<Point2, Point2>> lines;
  const auto add = [&](const Stretch& part) {
    const double across = static_cast<double>(part.line) * hatching.spacing;
    const Point2 foot(-across * along.y, across * along.x);
    if (part.from < part.to) lines.emplace_back(foot + part.from * along, foot + part.to * along);
  };
  auto next = hidden.begin();
  for (Stretch rest : stretches_within(loops, hatching.spacing, along)) {
    const auto is_behind = [&](const Stretch& h) {
      return std::tuple(h.line, h.to) <= std::tuple(rest.line, rest.from);
    };
    while (next != hidden.end() && is_behind(*next)) ++next;
    for (auto h = next; h != hidden.end() && h->line == rest.line && h->from < rest.to; ++h) {
      add({rest.line, rest.from, std::min(h->from, rest.to)});
      rest.from = std::max(rest.from, h->to);
    }
    add(rest);
  }
  return lines;
}

}  // namespace displayfile
