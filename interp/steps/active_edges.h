#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "interp/scan/scan_edge.h"
#include "interp/steps/step_record.h"
#include "interp/steps/step_scene.h"

namespace displayfile {

/// The active edge list of all polygons together, row after row from the bottom, as the lecture and
/// the problem book have it. Crossings are found exactly (interp/scan/scan_edge.h), one product
/// from an edge's lower end instead of a sum along it.
class ActiveEdges {
 public:
  using Polygon = StepScene::Polygon;

  struct Edge {
    ScanEdge edge;
    Polygon polygon;
    int column;  ///< the first whose centre is at or right of the crossing
    double x;    ///< of the crossing in pixels, rounded
  };

  explicit ActiveEdges(const StepScene& scene);

  /// What became of the list on the way to a row.
  struct Change {
    std::size_t entered, left;
  };
  Change go_to(int row);

  /// From left to right.
  const std::vector<Edge>& edges() const { return active_; }
  /// Those whose first row is still to come.
  std::size_t to_come() const { return table_.size() - next_; }

  /// The list as rows of a table: polygon, x of the crossing in pixels, its change a row, last row,
  /// IN or OUT from there on.
  static constexpr std::string_view kColumns = "polygon|x|change of x|last row|flag";
  /// Those first <= k < end are marked active; of a long list those around them.
  std::vector<StepRow> rows(const StepRecord& record, std::size_t first = 0,
                            std::size_t end = 0) const;

  /// The runs of pixels in which the polygons are IN on this row, in order of entry.
  std::vector<StepRun> runs(int row) const;

 private:
  PictureSize size_;
  std::vector<Edge> table_;  // the edge table, by first row
  std::size_t next_ = 0;
  std::vector<Edge> active_;
};

/// The runs as a profile of the row.
std::vector<StepSegment> profile_of(const StepScene& scene, const std::vector<StepRun>& runs);

/// The sides of active edges over the picture, to be marked.
void mark_edges(StepRecord& record, const ActiveEdges& edges);

}  // namespace displayfile
