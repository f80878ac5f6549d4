#include "interp/steps/piece_table.h"

#include <algorithm>
#include <utility>

#include "hidden/exact/depth_order.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

std::vector<Primitives::Item> PieceTable::items_of(const StepItems& scene) {
  std::vector<Primitives::Item> items;
  std::uint32_t first = 0;
  for (const StepItems::Polygon polygon : scene.fills()) {
    const auto sides = static_cast<std::uint32_t>(scene.viewed().points(polygon).size());
    items.push_back({first, sides, Primitives::Kind::solid});
    first += sides;
  }
  return items;
}

std::vector<Point3> PieceTable::points_of(const StepItems& scene) {
  std::vector<Point3> points;
  for (const StepItems::Polygon polygon : scene.fills()) {
    for (const Point3& p : scene.vertices(polygon)) points.push_back(p);
  }
  return points;
}

PieceTable::PieceTable(const StepItems& scene, StepRecord& record)
    : scene_(scene),
      record_(record),
      points_(points_of(scene)),
      items_(items_of(scene)),
      primitives_{points_, {}, {}, items_},
      sort_(primitives_, Exact({})),
      made_(sort_.vertices.made()),
      comparing_(sort_.table, sort_.vertices, Observer{&told_}) {
  for (const StepItems::Polygon polygon : scene.fills()) {
    pieces_.push_back(polygon);
    runs_.push_back(scene.coverage(polygon));
  }
}

std::vector<PieceTable::Index> PieceTable::all() const {
  std::vector<Index> all;
  for (Index i = 0; i < pieces_.size(); ++i) all.push_back(i);
  return all;
}

PieceTable::Sides PieceTable::sides_of(Index test, std::uint32_t plane) const {
  Sides sides;
  const bool in_plane = sort_.vertices.in_one_plane(entry(test).plane, plane);
  for (const std::uint32_t v : sort_.table.vertices(test)) {
    const int side = in_plane ? 0 : sort_.vertices.side(v, plane);
    auto& points = side > 0 ? sides.front : side < 0 ? sides.back : sides.on;
    points.push_back(flat(sort_.vertices.coordinates(v)));
  }
  return sides;
}

int PieceTable::side_of_centre(Index of, std::uint32_t plane, int column, int row) const {
  const PixelCentre centre(column, row, scene_.size());
  const auto upright = std::ranges::find(upright_, plane, &Upright::plane);
  if (upright == upright_.end()) {
    return depth_order(sort_.vertices.plane(entry(of).plane), sort_.vertices.plane(plane), centre);
  }
  const auto& [polygon, corner, number, from, to] = *upright;
  if (from.y == to.y) {
    const int above = -compare_with_centres(from.y, scene_.size().height, row);
    return from.x < to.x ? -above : above;
  }
  const int left = crossing(from, to, centre);
  return from.y < to.y ? -left : left;
}

std::uint32_t PieceTable::add_piece(Index i, std::uint32_t of) {
  std::vector<Point3> points;
  for (const std::uint32_t v : sort_.table.vertices(i)) {
    points.push_back(sort_.vertices.coordinates(v));
  }
  return record_.add_piece(of, std::move(points));
}

PieceTable::Cut PieceTable::cut(Index test, std::uint32_t plane) {
  comparing_.compare(test, plane);
  return note_cut(test, plane, comparing_.split(test, plane));
}

PieceTable::Cut PieceTable::note_cut(Index test, std::uint32_t plane,
                                     const Comparing::Halves& halves) {
  const std::uint32_t whole = pieces_[test];
  std::vector<StepRun> front, back;
  for (const StepRun& run : runs_[test]) {
    for (int i = run.first; i < run.end; ++i) {
      auto& runs = side_of_centre(test, plane, i, run.row) >= 0 ? front : back;
      if (!runs.empty() && runs.back().row == run.row && runs.back().end == i) {
        ++runs.back().end;
      } else {
        runs.push_back({run.row, i, i + 1, run.polygon});
      }
    }
  }
  const std::size_t made_before = std::exchange(made_, sort_.vertices.made());
  Cut cut{halves.front, halves.back, {}, {}, made_ - made_before};
  for (const auto& [in_e, side] : told_) {
    const bool made = !sort_.vertices.is_entered(side.vertex) &&
                      sort_.vertices.number_made(side.vertex) >= made_before;
    (in_e ? cut.in_e : cut.in_d).emplace_back(sort_.vertices.coordinates(side.vertex), made);
  }
  told_.clear();
  pieces_.resize(sort_.table.entries.size());
  runs_.resize(sort_.table.entries.size());
  pieces_[cut.front] = add_piece(cut.front, whole);
  pieces_[cut.back] = add_piece(cut.back, whole);
  runs_[cut.front] = std::move(front);
  runs_[cut.back] = std::move(back);
  return cut;
}

std::uint32_t PieceTable::upright_plane(StepItems::Polygon polygon, std::uint32_t corner) {
  const auto known = std::ranges::find_if(
      upright_, [&](const Upright& u) { return u.polygon == polygon && u.corner == corner; });
  if (known != upright_.end()) return known->plane;
  const auto vertices = scene_.vertices(polygon);
  const Point3 from =
      vertices[previous_corner(corner, static_cast<std::uint32_t>(vertices.size()))];
  const Point3 to = vertices[corner];
  const std::uint32_t plane =
      sort_.vertices.add_plane(Plane(from, to, Point3(from.x, from.y, from.z + 1.0)));
  upright_.push_back({polygon, corner, plane, flat(from), flat(to)});
  return plane;
}

}  // namespace displayfile
