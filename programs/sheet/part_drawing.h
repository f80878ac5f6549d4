#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "clip/surfaces.h"
#include "programs/sheet/part.h"

namespace displayfile {

enum class ViewKind { front, top, right, left, isometric };

/// Transforms a part's coordinates (part.h) to those of a view: x to the right and y up on the
/// paper, z toward the viewer. All but the isometric one permute the axes, and round nothing.
Point3 in_view(ViewKind view, const Point3& p);
/// Toward the viewer.
Point3 toward_viewer(ViewKind view);

/// The visible and hidden lines of a view, its cut faces and centre lines, in the part's unit.
struct PartDrawing {
  struct Line {
    Point2 from, to;
    bool hidden;
    bool is_alone = false;  ///< no other ends where it does (hidden/lines/strokes_once.md)
  };
  /// An outline of a cut face: counterclockwise around the material.
  struct CutLoop {
    std::vector<Point2> points;
    std::uint32_t body = 0;  ///< index of an object of the part; their number: all of them
    std::uint32_t part = 0;  ///< of which it is, in Part::parts
  };
  /// The axis of a turned shape, or a line across it where it is seen along the axis.
  struct CentreLine {
    Point2 from, to;
    bool is_behind = false;  ///< all of the turned shape lies behind the plane of the section
  };
  ViewKind kind = ViewKind::front;
  Point2 low{0.0}, high{0.0};  ///< of the part behind the plane
  std::vector<Line> lines;
  std::vector<CutLoop> cut;
  bool has_outlines = false;                ///< lines has the visible parts of the cut loops too
  std::vector<std::vector<Point2>> before;  ///< polygons, together all that hides the cut faces
  std::vector<CentreLine> centre_lines;
  std::optional<double> position;  ///< of a section, along toward_viewer
  bool closed = true;              ///< false: the part is not, where it is cut
};

/// The specification of a view.
struct ViewWanted {
  ViewKind kind = ViewKind::front;
  std::optional<double> position{};  ///< of a section, along toward_viewer
  bool hidden_lines = true, centre_lines = true;
  /// For each part, as in Part::parts: true if its objects that the plane goes through are not cut.
  std::vector<std::uint8_t> uncut{};
};

/// True if the plane at a position of a view goes through an object of the part.
bool goes_through(const Part& part, std::size_t object, ViewKind view, double position);

/// Finds a view's lines exactly (hidden/lines/franklin.md); in the isometric view depths that
/// rounding may have separated are equal. With a position the part is cut there, and the part
/// nearer to the viewer removed, but not objects that stay whole; if the part is not closed there,
/// the cut face is open.
PartDrawing view_of_part(const Part& part, const ViewWanted& wanted, const LineSelection& lines,
                         int threads);

}  // namespace displayfile
