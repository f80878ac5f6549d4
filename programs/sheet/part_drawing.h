#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "clip/surfaces.h"
#include "programs/sheet/part.h"

namespace displayfile {

enum class ViewKind { front, top, right, left, isometric };

/// From a part's coordinates (part.h) to those of a view: x to the right and y up on the paper, z
/// toward the viewer. All but the isometric one permute the axes, and round nothing.
Point3 in_view(ViewKind view, const Point3& p);
/// Toward the viewer.
Point3 toward_viewer(ViewKind view);

/// What a view shows, in the part's unit.
struct PartDrawing {
  struct Line {
    Point2 from, to;
    bool hidden;
    bool is_alone = false;  ///< no other ends where it does (hidden/lines/strokes_once.md)
  };
  ViewKind kind = ViewKind::front;
  Point2 low{0.0}, high{0.0};  ///< of the whole part
  std::vector<Line> lines;
  std::vector<std::vector<Point2>> cut;  ///< loops of the cut face
  std::optional<double> position;        ///< of a section, along toward_viewer
  bool closed = true;                    ///< false: the part is not, where it is cut
};

/// Finds a view's lines, including hidden ones, exactly (hidden/lines/franklin.md); in the
/// isometric view depths that rounding may have separated are equal. With a position the part is
/// cut there, and the part nearer to the viewer removed; if the part is not closed there, the cut
/// face is open.
PartDrawing view_of_part(const Part& part, ViewKind kind, const LineSelection& lines,
                         std::optional<double> position, int threads);

}  // namespace displayfile
