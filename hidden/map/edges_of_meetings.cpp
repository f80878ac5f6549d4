#include <array>

#include "clip/base/budgeted_work.h"
#include "clip/base/parallel.h"
#include "clip/base/work_budget.h"
#include "hidden/lines/intersection_lines.h"
#include "hidden/lines/visible_pieces.h"
#include "hidden/map/edges_along_line.h"
#include "hidden/map/map_edges.h"
#include "hidden/map/meeting_carrier.h"

namespace displayfile {

namespace {

/// Finds the edges on intersection lines, one line at a time.
class MeetingFinder {
  using Edges = EdgesAlongLine<MeetingCarrier>;
  using Seen = SeenAlongLine<MeetingCarrier>;

 public:
  explicit MeetingFinder(const MapTable& map) : map_(map), edges_(map) {}

  void find(const IntersectionLine& line, std::vector<MapEdge>& edges) {
    Extent box = Extent::nothing();
    box.include(line.from.near, line.from.radius);
    box.include(line.to.near, line.to.radius);
    if (map_.grid.hides(box)) return;
    edges_.line().look_at(line);
    owners_ = {line.item_a, line.item_b};
    edges_.begin(owners_, Edges::kNoSide);
    edges_.seen().begin(2);  // the two
    const bool a_is_left = edges_.line().first_is_nearer_on_left();
    edges_.seen().begin_with(Seen::kLeft, a_is_left ? line.item_a : line.item_b, false);
    edges_.seen().begin_with(Seen::kRight, a_is_left ? line.item_b : line.item_a, false);
    edges_.note_added(line.item_a);
    edges_.note_added(line.item_b);
    edges_.find(box, edges);
  }

 private:
  const MapTable& map_;
  Edges edges_;
  std::array<std::uint32_t, 2> owners_{};
};

}  // namespace

std::vector<MapEdge> edges_of_meetings(const MapTable& map, int threads) {
  constexpr std::size_t kMeetingsOfAPart = 64;
  std::vector<std::uint32_t> contested;  // nothing visible intersects an entirely visible polygon
  for (std::uint32_t i = 0; i < map.lines.items(); ++i) {
    if (map.faces[i] == SeenFaces::Seen::some) contested.push_back(i);
  }
  const std::vector<IntersectionLine> lines =
      intersection_lines(map.items, map.lines, contested, IntersectionEnds::defined, threads);
  std::vector<std::vector<MapEdge>> found((lines.size() + kMeetingsOfAPart - 1) / kMeetingsOfAPart);
  const auto make_finder = [&] { return MeetingFinder(map); };
  Finders finders(make_finder);
  PieceCount pieces(lines.size(), sizeof(MapEdge));
  in_parallel(threads, found.size(), [&](std::size_t part) {
    const std::size_t end = std::min(lines.size(), (part + 1) * kMeetingsOfAPart);
    finders.use([&](auto& finder) {
      for (std::size_t k = part * kMeetingsOfAPart; k < end; ++k)
        finder.find(lines[k], found[part]);
    });
    pieces.add(found[part].size());
  });
  std::vector<MapEdge> edges;
  for (const auto& of_part : found) edges.insert(edges.end(), of_part.begin(), of_part.end());
  return edges;
}

}  // namespace displayfile
