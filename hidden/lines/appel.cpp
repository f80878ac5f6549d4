#include "hidden/lines/line_methods.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/parallel.h"
#include "hidden/lines/line_follower.h"
#include "hidden/lines/plain_appel.h"
#include "hidden/lines/visible_pieces.h"

namespace displayfile {

namespace {

constexpr std::size_t kLinesAtATime = 512;

/// The first line of each name, in order of their polygons' positions in the tree: neighbouring
/// lines are processed together while the polygons around them are in the cache.
std::vector<std::uint32_t> lines_by_place(const AppelTables& scene) {
  const auto lines = scene.lines.lines();
  const auto firsts = scene.lines.first_lines_of_names();
  const std::uint32_t items = scene.lines.items();
  std::vector<std::uint32_t> place(items), next(items + 2, 0);
  for (std::uint32_t at = 0; at < items; ++at) place[scene.counted.order()[at]] = at;
  const auto place_of = [&](std::uint32_t first) {
    const std::uint32_t own = lines[first].own;
    return own == LineTable::kNone ? items : place[own];
  };
  for (const std::uint32_t first : firsts) ++next[place_of(first) + 1];
  for (std::size_t at = 1; at < next.size(); ++at) next[at] += next[at - 1];
  std::vector<std::uint32_t> order(firsts.size());
  for (const std::uint32_t first : firsts) order[next[place_of(first)]++] = first;
  return order;
}

/// The counts of all lines after their starts, and the changes along them.
struct CountsOfLines {
  std::vector<ChangesOfLine> of_lines;  // per line of the scene
  std::vector<std::vector<CountChange>> changes;
  std::vector<SideCounts> start;
};

/// Finds the hidden parts of lines one by one.
template <class Policy>
class Appel {
 public:
  Appel(const AppelTables& scene, const CountsOfLines& counts, const Policy& policy)
      : scene_(scene), counts_(counts), line_(scene.lines, policy) {}

  const std::vector<PartOfLine>& hidden_parts(const LineTable::Line& line) {
    parts_.clear();
    if (scene_.lines.intersection(line) != nullptr) {
      compare_with_all(line);
      return parts_.hidden();
    }
    const auto number = static_cast<std::size_t>(&line - scene_.lines.lines().data());
    const auto& [found, from, to, start, is_near] = counts_.of_lines[number];
    if (is_near) {
      compare_with_all(line);
      return parts_.hidden();
    }
    add_hidden(counts_.start[start], std::span(counts_.changes[found]).subspan(from, to - from));
    compare(line);
    return parts_.hidden();
  }

 private:
  /// Adds the covered parts of the line. `changes` are in order.
  void add_hidden(SideCounts counts, std::span<const CountChange> changes) {
    double at = 0.0;
    for (std::size_t i = 0; at < 1.0;) {
      for (; i < changes.size() && changes[i].at <= at; ++i) counts += changes[i].by;
      const PartOfLine part{at, i < changes.size() ? changes[i].at : 1.0};
      if (counts.left > 0 && counts.right > 0) {
        parts_.add_both(part);
      } else if (counts.left > 0) {
        parts_.add_left(part);
      } else if (counts.right > 0) {
        parts_.add_right(part);
      }
      at = part.to;
    }
  }

  /// An intersection line is not an edge of a connected part: it is compared with all polygons.
  void compare_with_all(const LineTable::Line& line) {
    const Extent box = scene_.lines.extent(line);
    Extent before = box;
    before.z_max = std::numeric_limits<float>::infinity();
    line_.look_at(line);
    scene_.any_counted(before, [&](std::uint32_t polygon) {
      line_.hide(polygon, parts_);
      return false;
    });
    compare(line);
  }

  /// Adds the parts hidden by uncounted polygons.
  void compare(const LineTable::Line& line) {
    const Extent box = scene_.lines.extent(line);
    bool looked = false;
    const auto meets = [flat = FlatBox::of(box)](const FlatBoxes& b) { return b.meets(flat); };
    scene_.compared.any(meets, [&](ExtentTree::Position position) {
      const std::uint32_t polygon = scene_.compared.order()[position];
      if (!looked) line_.look_at(line);
      looked = true;
      line_.hide(polygon, parts_);
      return false;
    });
  }

  const AppelTables& scene_;
  const CountsOfLines& counts_;
  LineAgainstPolygon<Policy> line_;
  HiddenParts parts_;
};

/// Calls work(follower, k) for each k, on several threads.
template <class Policy, class Work>
void follow_in_parts(const AppelTables& scene, const Policy& policy, std::size_t size, int threads,
                     const Work& work) {
  const auto make = [&] { return LineFollower(scene, policy); };
  Finders followers(make);
  in_parallel(threads, (size + kLinesAtATime - 1) / kLinesAtATime, [&](std::size_t part) {
    followers.use([&](LineFollower<Policy>& follower) {
      const std::size_t end = std::min(size, (part + 1) * kLinesAtATime);
      for (std::size_t k = part * kLinesAtATime; k < end; ++k) work(follower, k);
    });
  });
}

/// For each vertex 1 if the counts are carried over it.
template <class Policy>
std::vector<std::uint8_t> vertices_that_carry(const AppelTables& scene, const Policy& policy,
                                              std::span<const std::uint32_t> order, int threads) {
  std::vector<std::uint8_t> carries(scene.vertices.joins().size(), 0);
  std::vector<std::uint32_t> vertices;  // in the order in which lines reach them
  for (const std::uint32_t first : order) {
    const LineTable::Line& line = scene.lines.lines()[first];
    for (const std::uint32_t point : {line.a, line.b}) {
      const std::uint32_t v = scene.vertices.vertex(point);
      if (scene.vertices.joins()[v] == 0 || carries[v] != 0) continue;
      carries[v] = 1;
      vertices.push_back(v);
    }
  }
  follow_in_parts(scene, policy, vertices.size(), threads,
                  [&](const auto& follower, std::size_t k) {
                    carries[vertices[k]] = follower.carries(vertices[k]) ? 1 : 0;
                  });
  return carries;
}

template <class Policy>
CountsOfLines count_along_lines(const AppelTables& scene, const Policy& policy,
                                std::span<const std::uint32_t> order, int threads,
                                AppelCounts* work) {
  const std::vector<std::uint8_t> carries = vertices_that_carry(scene, policy, order, threads);
  const auto lines = scene.lines.lines();
  CountsOfLines counts;
  counts.of_lines.resize(lines.size());
  counts.changes.resize((order.size() + kLinesAtATime - 1) / kLinesAtATime);
  std::vector<CountedLine> counted(order.size());
  follow_in_parts(scene, policy, order.size(), threads, [&](auto& follower, std::size_t k) {
    const std::size_t first = order[k];
    std::size_t end = first + 1;
    while (end < lines.size() && lines[end].name == lines[first].name) ++end;
    const auto of_depths = std::span(counts.of_lines).subspan(first, end - first);
    const auto found = static_cast<std::uint32_t>(k / kLinesAtATime);
    for (ChangesOfLine& of : of_depths) of = {found, 0, 0, static_cast<std::uint32_t>(k), false};
    counted[k] = follower.follow(first, carries, counts.changes[found], of_depths);
  });
  const auto make = [&] { return LineFollower(scene, policy); };
  Finders followers(make);
  const auto ray = [&](std::uint32_t k) {
    SideCounts after_start;
    followers.use([&](auto& follower) { after_start = follower.ray(lines[order[k]]); });
    return after_start;
  };
  CarriedCounts carried(counted, carries, ray, threads);
  if (work != nullptr) *work = {carried.rays, carried.carried, scene.contours.size()};
  counts.start = std::move(carried.start);
  return counts;
}

}  // namespace

SeenLines visible_lines_by_appel(const Primitives& items, const LineTable& scene,
                                 const SurfacePlan& plan, AppelCounts* counts) {
  const AppelTables all(items, scene, plan.threads);
  const std::vector<std::uint32_t> order = lines_by_place(all);
  std::vector<std::uint32_t> with_intersections = order;
  const auto intersections = scene.first_lines().subspan(scene.first_lines_of_names().size());
  with_intersections.insert(with_intersections.end(), intersections.begin(), intersections.end());
  const auto find = [&](const auto& policy) {
    const CountsOfLines found = count_along_lines(all, policy, order, plan.threads, counts);
    return visible_pieces(scene, with_intersections, plan,
                          [&] { return Appel(all, found, policy); });
  };
  const Definitions points{items.points, {}};
  if (plan.precision.exact) return find(ExactLines(points));
  return find(RoundoffLines(points, plan.precision.roundoff));
}

SeenLines visible_lines_by_plain_appel(const Primitives& items, const LineTable& scene,
                                       const SurfacePlan& plan) {
  const AppelTables all(items, scene, plan.threads);
  const auto find = [&](const auto& policy) {
    UnobservedAppel observer;
    const std::array seen{PlainAppel(all, policy, observer).find(plan)};
    return by_names(scene, seen);
  };
  const Definitions points{items.points, {}};
  if (plan.precision.exact) return find(ExactLines(points));
  return find(RoundoffLines(points, plan.precision.roundoff));
}

}  // namespace displayfile
