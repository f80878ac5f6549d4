#include "hidden/lines/lines_in_order.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>

#include "clip/surfaces.h"
#include "hidden/exact/precision_policies.h"
#include "hidden/lines/chains.h"
#include "hidden/lines/grid_surface.h"
#include "hidden/lines/hidden_pieces.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/lines/line_ends.h"

namespace displayfile {

namespace {

/// A length in the picture: shorter parts are invisible, and do not make a line's end a cut.
constexpr double kNoLength = 1e-9;

/// Items, followed by one item per intersection line, so that these lines have names too.
class ItemsAndIntersections {
 public:
  ItemsAndIntersections(const Primitives& items, std::span<const IntersectionLine> intersections)
      : items_(items), intersections_(intersections) {
    if (intersections.empty()) return;
    points_.assign(items.points.begin(), items.points.end());
    corners_.assign(items.corners.begin(), items.corners.end());
    all_.assign(items.items.begin(), items.items.end());
    for (const IntersectionLine& line : intersections) {
      all_.push_back(
          {static_cast<std::uint32_t>(corners_.empty() ? points_.size() : corners_.size()), 2,
           Primitives::Kind::line});
      for (const Point3& end : {line.start, line.end}) {
        if (!corners_.empty()) corners_.push_back(static_cast<std::uint32_t>(points_.size()));
        points_.push_back(end);
      }
    }
  }

  /// All items, without line kinds.
  Primitives primitives() const {
    if (intersections_.empty()) return items_;
    return {points_, corners_, {}, all_};
  }
  bool is_intersection(std::uint32_t item) const { return item >= items_.items.size(); }
  /// The item to which the line belongs.
  std::uint32_t item_of(std::uint32_t item) const {
    if (!is_intersection(item)) return item;
    return intersections_[item - items_.items.size()].item_b;
  }
  LineName name(std::uint32_t intersection) const {
    return {static_cast<std::uint32_t>(items_.items.size()) + intersection, 1};
  }

 private:
  const Primitives& items_;
  std::span<const IntersectionLine> intersections_;
  std::vector<Point3> points_;
  std::vector<std::uint32_t> corners_;
  std::vector<Primitives::Item> all_;
};

/// Adds pieces in order of chains.
class ChainWriter {
 public:
  ChainWriter(const ItemsAndIntersections& items, std::span<const LineToDraw> lines,
              double least_length, std::span<const std::uint32_t> groups, SortedPieces& all)
      : items_(items),
        primitives_(items.primitives()),
        lines_(lines),
        least_length_(least_length),
        groups_(groups),
        all_(all) {}

  /// Adds pieces in order of names, except those that would be dots.
  void add(std::span<const VisiblePiece> pieces) {
    links_.clear();
    links_.reserve(pieces.size());
    drawn_.clear();
    drawn_.reserve(pieces.size());
    auto line = lines_.begin();
    for (const VisiblePiece& piece : pieces) {
      const LineName name{piece.item, piece.corner};
      const std::uint32_t item = items_.item_of(piece.item);
      Drawn drawn{item, item, kinds_of(LineKind::intersection), {}};
      if (!items_.is_intersection(piece.item)) {
        while (line->name != name) {
          ++line;
          assert(line != lines_.end());
        }
        drawn = {item, line->pick_item, line->kinds, {}};
      }
      const LineEnds ends(primitives_, name);
      const Point3 from = ends.at(piece.from), to = ends.at(piece.to);
      if (glm::distance(Point2(from), Point2(to)) <= least_length_) continue;
      drawn.cuts = {is_cut_off(ends.from, from), is_cut_off(to, ends.to)};
      const std::uint64_t group = groups_.empty() ? 0 : groups_[item];
      links_.push_back({from, to, (group << 8) | drawn.kinds});
      drawn_.push_back(drawn);
    }
    const auto make_room = [&](auto& array, std::size_t more) {
      array.reserve(std::max(array.size() + more * links_.size(), array.capacity()));
    };
    make_room(all_.pieces, 1);
    make_room(all_.points, 2);
    make_room(all_.visible, 2);
    make_room(all_.pick_items, 1);
    for (const auto& [piece, reversed] : chains_of(links_).places) {
      const auto first = static_cast<std::uint32_t>(all_.points.size());
      all_.pieces.push_back({drawn_[piece].item, first, 2});
      const ChainLink& link = links_[piece];
      all_.points.push_back(reversed ? link.to : link.from);
      all_.points.push_back(reversed ? link.from : link.to);
      const LineCuts cuts = reversed ? drawn_[piece].cuts.reversed() : drawn_[piece].cuts;
      all_.visible.insert(all_.visible.end(), {cuts.byte(), drawn_[piece].kinds});
      all_.pick_items.push_back(drawn_[piece].pick_item);
    }
    assert(all_.points.size() == 2 * all_.pieces.size());
  }

 private:
  struct Drawn {
    std::uint32_t item, pick_item;
    LineKinds kinds;
    LineCuts cuts;
  };
  /// True if the missing part of a line is long enough to be visible.
  bool is_cut_off(const Point3& from, const Point3& to) const {
    return glm::distance(Point2(from), Point2(to)) > std::max(kNoLength, least_length_);
  }

  const ItemsAndIntersections& items_;
  Primitives primitives_;
  std::span<const LineToDraw> lines_;
  double least_length_;
  std::span<const std::uint32_t> groups_;
  SortedPieces& all_;
  std::vector<ChainLink> links_;
  std::vector<Drawn> drawn_;
};

std::vector<LineName> names_of(std::span<const LineToDraw> lines) {
  std::vector<LineName> names;
  names.reserve(lines.size());
  for (const LineToDraw& line : lines) names.push_back(line.name);
  return names;
}

/// The visible pieces of the intersections, named by their items.
std::vector<VisiblePiece> seen_intersections(const ItemsAndIntersections& all,
                                             const SeenLines& seen) {
  std::vector<VisiblePiece> pieces;
  pieces.reserve(seen.intersections.size());
  for (const auto& [line, from, to] : seen.intersections) {
    const LineName name = all.name(line);
    pieces.push_back({name.item, name.corner, from, to});
  }
  return pieces;
}

/// The hidden, uncovered pieces of lines and intersections.
std::vector<HiddenPiece> uncovered_pieces_of(const FoundLines& found,
                                             const ItemsAndIntersections& all,
                                             std::span<const VisiblePiece> intersections) {
  std::vector<LineName> names = names_of(found.lines);
  for (std::uint32_t k = 0; k < found.intersections.size(); ++k) names.push_back(all.name(k));
  SeenLines seen{found.seen.pieces, {}};
  seen.pieces.insert(seen.pieces.end(), intersections.begin(), intersections.end());
  return uncovered_pieces(all.primitives(), seen, hidden_pieces(names, seen));
}

/// `seen` are the lines' own visible pieces, or empty. Intersections follow them, and no chain
/// mixes both.
SortedPieces pieces_in_order(const Primitives& items, std::span<const std::uint32_t> groups,
                             const FoundLines& found, HiddenLines hidden_lines,
                             std::span<const VisiblePiece> seen) {
  const ItemsAndIntersections all(items, found.intersections);
  const std::vector<VisiblePiece> intersections = seen_intersections(all, found.seen);
  SortedPieces pieces;
  pieces.first_stroke = 0;
  ChainWriter writer(all, found.lines, found.least_length, groups, pieces);
  if (hidden_lines == HiddenLines::dashed) {
    writer.add(uncovered_pieces_of(found, all, intersections));
    pieces.hidden.assign(pieces.pieces.size(), 1);
  }
  writer.add(seen);
  writer.add(intersections);
  if (!pieces.hidden.empty()) pieces.hidden.resize(pieces.pieces.size(), 0);
  return pieces;
}

}  // namespace

FoundLines find_lines(const Primitives& items, std::span<const std::int32_t> picks,
                      const SurfacePlan& plan) {
  FoundLines found;
  const std::optional<GridSurface> surface = GridSurface::of(items);
  const GridSurface* const known = surface ? &*surface : nullptr;
  found.lines = lines_to_draw(items, picks, known);
  if (plan.intersections) found.intersections = intersection_lines(items, plan.threads);
  found.seen = visible_lines(items, names_of(found.lines), plan, found.intersections, known);
  if (!plan.precision.exact) {
    found.least_length = Roundoff::relative({items.points, {}}, plan.precision.roundoff).roundoff();
  }
  return found;
}

SortedPieces lines_in_order(const Primitives& items, std::span<const std::uint32_t> groups,
                            const FoundLines& found, HiddenLines hidden_lines) {
  return pieces_in_order(items, groups, found, hidden_lines, found.seen.pieces);
}

SortedPieces lines_beside_sides(const Primitives& items, std::span<const std::uint32_t> groups,
                                const FoundLines& found, HiddenLines hidden_lines) {
  return pieces_in_order(items, groups, found, hidden_lines, {});
}

}  // namespace displayfile
