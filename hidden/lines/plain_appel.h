#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "hidden/lines/hidden_parts.h"
#include "hidden/lines/line_against_polygon.h"
#include "hidden/lines/line_follower.h"
#include "hidden/lines/visible_pieces.h"

namespace displayfile {

/// Null observer of PlainAppel, with the required members. A share of a line is a place along it,
/// from 0 to 1.
struct UnobservedAppel {
  using Line = LineTable::Line;
  /// The counts at the line's start, by comparison with all polygons there.
  static void ray(const Line& /*line*/, const SideCounts& /*start*/) {}
  /// The same, from the known number of the point where the line begins or ends.
  static void carried(const Line& /*line*/, bool /*by_start*/, std::int32_t /*known*/,
                      const SideCounts& /*start*/) {}
  /// The counts up to the next change, and the change at the part's beginning.
  static void part(const Line& /*line*/, const PartOfLine& /*part*/, const SideCounts& /*counts*/,
                   const SideCounts& /*by*/) {}
  /// The line is compared with an uncounted polygon, or with all, since it is close to corners.
  static void compared(const Line& /*line*/, std::uint32_t /*polygon*/, bool /*with_all*/) {}
  /// The number at its start or end is now known.
  static void noted(const Line& /*line*/, const std::vector<double>& /*shares*/) {}
  static void seen(const Line& /*line*/, std::span<const SeenPart> /*parts*/) {}
};

/// Appel's method in its textbook form, for reading, for the step display, and as the reference of
/// the fast form (hidden/lines/appel.md): the chapter's section "Hidden-line methods". Quantitative
/// invisibility is found at one point of connected lines and carried along them, from one to the
/// next; it changes where the line passes behind a contour edge, or through a polygon
/// (LineFollower). The fast form finds all changes before it processes any line, on several
/// threads.
///
/// Faces are counted separately on the left and on the right of a line: it is hidden where there is
/// one on each side.
template <class Policy, class Observer = UnobservedAppel>
class PlainAppel {
 public:
  using Line = LineTable::Line;

  /// The arguments must outlive this.
  PlainAppel(const AppelTables& scene, const Policy& policy, Observer& observer)
      : scene_(scene),
        lines_(scene.lines.lines()),
        firsts_(scene.lines.first_lines_of_names()),
        follower_(scene, policy),
        against_(scene.lines, policy),
        pieces_(scene.lines.first_lines().size(), sizeof(SeenPart)),
        observer_(observer) {
    for (std::uint32_t polygon = 0; polygon < scene.lines.items(); ++polygon) {
      if (!scene.lines.hides(polygon)) continue;
      hiding_.push_back(polygon);
      if (scene.contours.way(polygon) == 0) not_counted_.push_back(polygon);
    }
  }

  /// The visible parts of all lines, in the order of processing. With ROUNDOFF, with which carried
  /// counts may be inconsistent, each line gets a ray.
  std::vector<SeenPart> find(const SurfacePlan& plan) {
    CountedWork work(plan.progress, scene_.lines.first_lines().size());
    find_vertices(plan.precision.exact);
    done_.assign(firsts_.size(), 0);
    for (std::uint32_t k = 0; k < firsts_.size(); ++k) {
      if (done_[k] == 0) follow_from(k, work);
    }
    for (const std::uint32_t first : scene_.lines.first_lines().subspan(firsts_.size())) {
      look_at(first);
      work.add(1);
    }
    return seen_;
  }

  /// The number of polygons in front of a vertex, without those around it, as far as known.
  const std::map<std::uint32_t, std::int32_t>& known() const { return known_; }

  /// For find_seen: the hidden parts of the current line, at one of its depths. An intersection
  /// line is not an edge of a connected part: it is compared with all polygons.
  const std::vector<PartOfLine>& hidden_parts(const Line& line) {
    parts_.clear();
    bool with_all = scene_.lines.intersection(line) != nullptr;
    if (!with_all) {
      const ChangesOfLine& of = of_depths_[static_cast<std::size_t>(&line - followed_)];
      with_all = of.is_near;
      if (!with_all) add_counted(line, std::span(changes_).subspan(of.from, of.to - of.from));
    }
    compare(line, with_all);
    return parts_.hidden();
  }

 private:
  /// The lines at each vertex over which counts are carried.
  void find_vertices(bool carry) {
    carries_.assign(scene_.vertices.joins().size(), 0);
    if (!carry) return;
    for (std::uint32_t k = 0; k < firsts_.size(); ++k) {
      const Line& line = lines_[firsts_[k]];
      for (const std::uint32_t point : {line.a, line.b}) {
        const std::uint32_t v = scene_.vertices.vertex(point);
        if (scene_.vertices.joins()[v] == 0) continue;
        const auto [of, is_new] = lines_at_.try_emplace(v);
        if (is_new) carries_[v] = follower_.carries(v) ? 1 : 0;
        if (carries_[v] != 0) of->second.push_back(k);
      }
    }
  }

  /// Follows all lines that connect with one, from vertex to vertex.
  void follow_from(std::uint32_t first, CountedWork& work) {
    follow(first, std::nullopt);
    work.add(1);
    while (!reached_.empty()) {
      const std::uint32_t v = reached_.back();
      reached_.pop_back();
      for (const std::uint32_t k : lines_at_[v]) {
        if (done_[k] != 0) continue;
        follow(k, v);
        work.add(1);
      }
    }
  }

  /// Follows a line, whose counts come from a vertex, or from a ray.
  void follow(std::uint32_t k, std::optional<std::uint32_t> vertex) {
    done_[k] = 1;
    const std::size_t first = firsts_[k];
    std::size_t end = first + 1;
    while (end < lines_.size() && lines_[end].name == lines_[first].name) ++end;
    followed_ = &lines_[first];
    const Line& line = *followed_;
    changes_.clear();
    of_depths_.assign(end - first, {});
    const CountedLine counted = follower_.follow(first, carries_, changes_, of_depths_);
    if (!vertex) {
      start_ = follower_.ray(line);
      observer_.ray(line, start_);
    } else {
      const std::int32_t known = known_.at(*vertex);
      const SideCounts around{known, known};
      const bool by_start = *vertex == counted.from;
      start_ = by_start ? around + counted.star_from : around + counted.star_to - counted.change;
      observer_.carried(line, by_start, known, start_);
    }
    const std::span<const SeenPart> seen = look_at(first);
    note_ends(line, counted);
    observer_.seen(line, seen);
  }

  /// Finds the visible parts of a line, at all of its depths.
  std::span<const SeenPart> look_at(std::size_t first) {
    const std::size_t before = seen_.size();
    find_seen(lines_, first, *this, seen_);
    pieces_.add(seen_.size() - before);
    return std::span(seen_).subspan(before);
  }

  /// Records the numbers at the line's ends, for the connected lines.
  void note_ends(const Line& line, const CountedLine& counted) {
    const SideCounts at_start = start_ - counted.star_from;
    const SideCounts at_end = start_ + counted.change - counted.star_to;
    std::vector<double> noted;
    for (const auto& [v, number, share] :
         {std::tuple{counted.from, at_start.left, 0.0}, std::tuple{counted.to, at_end.left, 1.0}}) {
      if (carries_[v] == 0 || !known_.try_emplace(v, number).second) continue;
      reached_.push_back(v);
      noted.push_back(share);
    }
    if (!noted.empty()) observer_.noted(line, noted);
  }

  /// Adds the parts covered by counted polygons. The changes are in order along the line.
  void add_counted(const Line& line, std::span<const CountChange> changes) {
    SideCounts counts = start_;
    std::size_t next = 0;
    for (PartOfLine part{0.0, 0.0}; part.from < 1.0; part.from = part.to) {
      SideCounts by;
      for (; next < changes.size() && changes[next].at <= part.from; ++next) by += changes[next].by;
      counts += by;
      part.to = next < changes.size() ? std::min(changes[next].at, 1.0) : 1.0;
      if (counts.left > 0) parts_.add_left(part);
      if (counts.right > 0) parts_.add_right(part);
      observer_.part(line, part, counts, by);
    }
  }

  /// Adds the parts hidden by uncounted polygons, or by all.
  void compare(const Line& line, bool with_all) {
    against_.look_at(line);
    for (const std::uint32_t polygon : with_all ? hiding_ : not_counted_) {
      against_.hide(polygon, parts_);
      observer_.compared(line, polygon, with_all);
    }
  }

  const AppelTables& scene_;
  std::span<const Line> lines_;
  std::span<const std::uint32_t> firsts_;  // of the names, the first line
  LineFollower<Policy> follower_;
  LineAgainstPolygon<Policy> against_;
  PieceCount pieces_;
  Observer& observer_;

  std::vector<std::uint32_t> hiding_, not_counted_;  // polygons; of those that hide, the second
  std::vector<std::uint8_t> carries_;                // of vertices
  std::map<std::uint32_t, std::vector<std::uint32_t>> lines_at_;  // those that do
  std::map<std::uint32_t, std::int32_t> known_;
  std::vector<std::uint32_t> reached_;  // vertices, known of late
  std::vector<std::uint8_t> done_;      // of the names
  std::vector<SeenPart> seen_;

  // The current line.
  const Line* followed_ = nullptr;
  SideCounts start_;
  std::vector<CountChange> changes_;
  std::vector<ChangesOfLine> of_depths_;
  HiddenParts parts_;
};

}  // namespace displayfile
