#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hidden/sort/sort_tables.h"
#include "interp/steps/step_items.h"
#include "interp/steps/step_record.h"

namespace displayfile {

/// The scene's fills as entries of the polygon table, cut by COMPARE-POLYS (algorithm 9.10), each
/// with the pixels that it covers: the data in the steps of the object-space sorts.
class PieceTable {
 public:
  using Index = PolygonTable::Index;

  PieceTable(const StepItems& scene, StepRecord& record);
  PieceTable(const PieceTable&) = delete;
  PieceTable& operator=(const PieceTable&) = delete;

  std::vector<Index> all() const;  ///< before any is cut: in order of entry
  const PolygonTable::Entry& entry(Index i) const { return sort_.table[i]; }
  const SortTables<Exact>& sorted() const { return sort_; }
  SortTables<Exact>& to_sort() { return sort_; }
  std::uint32_t piece(Index i) const { return pieces_[i]; }
  StepItems::Polygon polygon(Index i) const { return scene_.fills()[entry(i).item]; }
  /// The pixels whose centres it covers. A centre exactly on a cut belongs to the front half.
  const std::vector<StepRun>& runs(Index i) const { return runs_[i]; }

  /// The entry's vertices by their side of a plane, in the projection.
  struct Sides {
    std::vector<Point2> front, on, back;
  };
  Sides sides_of(Index test, std::uint32_t plane) const;

  /// The placement of a cut's points: the end of each side, and whether the cut made it.
  using Put = std::vector<std::pair<Point3, bool>>;
  struct Cut {
    Index front, back;
    Put in_e, in_d;
    std::size_t crossings;  ///< points that the cut made
  };
  /// Cuts an entry, which lies on both sides of the plane; each half is a new piece.
  Cut cut(Index test, std::uint32_t plane);

  /// COMPARE-POLYS over the table, for callers that cut entries themselves. They call note_cut
  /// after each cut of the entry `test`, which is one of the halves from then on.
  struct Observer {
    std::vector<std::pair<bool, SideBuffer::Side>>* told;
    void put(bool in_e, const SideBuffer::Side& side) const { told->emplace_back(in_e, side); }
  };
  using Comparing = ComparePolys<Exact, Observer>;
  Comparing& comparing() { return comparing_; }
  Cut note_cut(Index test, std::uint32_t plane, const Comparing::Halves& halves);

  /// The plane through a side of a polygon and the viewer, its front to the right of the side; the
  /// same on every call.
  std::uint32_t upright_plane(StepItems::Polygon polygon, std::uint32_t corner);

 private:
  struct Upright {
    StepItems::Polygon polygon;
    std::uint32_t corner, plane;
    Point2 from, to;
  };

  static std::vector<Primitives::Item> items_of(const StepItems& scene);
  static std::vector<Point3> points_of(const StepItems& scene);
  int side_of_centre(Index of, std::uint32_t plane, int column, int row) const;
  std::uint32_t add_piece(Index i, std::uint32_t of);

  const StepItems& scene_;
  StepRecord& record_;
  std::vector<Point3> points_;
  std::vector<Primitives::Item> items_;
  Primitives primitives_;
  SortTables<Exact> sort_;
  std::vector<std::pair<bool, SideBuffer::Side>> told_;
  std::size_t made_;  // points, up to the cut noted last
  Comparing comparing_;
  std::vector<std::uint32_t> pieces_;       // by entry
  std::vector<std::vector<StepRun>> runs_;  // by entry
  std::vector<Upright> upright_;
};

}  // namespace displayfile
