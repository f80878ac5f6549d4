#pragma once

/// Drawings for programs that draw by their own means: passed to a device of theirs, polygon by
/// polygon and line by line, or as arrays of pieces.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "clip/surfaces.h"
#include "displayfile/looks/style.h"

namespace displayfile {

class DisplayFile;

// Devices.

/// A polygon in normalised device coordinates (x, y in [0,1] over the picture, y up; larger z is
/// nearer) after the image transformation. sides[i] is kDrawnSide if the edge that ends at vertex i
/// is drawn, another number if not. The arrays and styles are valid during the device's call only.
struct DrawnPolygon {
  static constexpr std::int32_t kDrawnSide = 2;

  std::span<const Point3> vertices;
  std::span<const std::int32_t> sides;
  const FillStyle& fill;
  const LineStyle& line;
  std::int32_t pick;
  /// Vertex intensities of a shaded polygon, which was cut from one triangle: the fill colour is
  /// multiplied by the intensity, interpolated linearly in the picture. Empty if the polygon is
  /// flat.
  std::span<const double> intensities = {};
  /// Kinds of the sides as lines, 0 for sides not drawn. Empty if they were not determined.
  std::span<const LineKinds> kinds = {};
  /// With Phong shading (displayfile/looks/phong.md): vertex normals and the light, for a device
  /// that lights each pixel. Other devices use the intensities.
  std::span<const Point3> normals = {};
  const Light* light = nullptr;
  /// 1 for each vertex at which a drawn side was cut because something may hide its rest. Empty if
  /// no side was cut.
  std::span<const std::uint8_t> cuts = {};
};

/// The fill style of a polygon filled with one colour: a shaded one gets the mean of its
/// intensities.
FillStyle even_fill(const DrawnPolygon& polygon);

/// A line; its style is never none.
struct DrawnLine {
  Point3 from, to;
  const LineStyle& style;
  LineKinds kinds = kDrawn;
  LineCuts cuts = {};
};

/// The interface of every output device, including an application's own (interp/device/README.md).
class OutputDevice {
 public:
  virtual ~OutputDevice() = default;
  /// The picture's size in pixels, or in the unit of line widths. Strokes that are shorter than
  /// they are wide and join no other are omitted (hidden/lines/strokes_once.md); 0: all strokes are
  /// drawn.
  virtual Point2 pixels() const { return Point2(0.0); }
  /// Begins the instructions of a segment, up to end_segment.
  virtual void begin_segment(int /*name*/) {}
  virtual void end_segment() {}
  /// Begins fills that do not overlap but tile the visible picture, up to end_disjoint_fills. Sides
  /// of neighbours are the same, bit for bit, in opposite directions, and a vertex on a neighbour's
  /// side is a vertex of the neighbour too. Segments may begin and end in between; there are no
  /// lines.
  virtual void begin_disjoint_fills() {}
  virtual void end_disjoint_fills() {}
  virtual void fill(const DrawnPolygon& polygon) = 0;   ///< the interior, in the fill style
  virtual void edges(const DrawnPolygon& polygon) = 0;  ///< the visible edges, in the line style
  virtual void line(const DrawnLine& line) = 0;
};

/// Which instructions to interpret. A device with a depth buffer draws all fills before any line,
/// so that lines are compared with the final depths (and win ties); other devices draw everything
/// in order.
enum class Pass { everything, fills, lines };

/// The order of instructions: of drawing, back to front where hidden surfaces were sorted; or of
/// entry, with every polygon whole, for methods that find hidden surfaces themselves.
enum class Order { drawn, entered };

/// Interprets the visible segments in order of creation: applies their image transformations and
/// passes each instruction to the device. Where all visible segments were sorted together, a
/// segment may begin and end several times. Line widths and dashes, which are in pixels, are
/// multiplied by line_scale, for pixels with several samples across.
void interpret(const DisplayFile& display_file, OutputDevice& device, Pass pass = Pass::everything,
               Order order = Order::drawn, double line_scale = 1.0);

// Pieces.

/// All output of a display file's visible segments as arrays, in drawing order, for programs that
/// draw by other means. Of a display file whose hidden surfaces were sorted (sorted_display_file.h)
/// they are
///  - by bsp or depth_sort all polygons from back to front, also those that others hide,
///  - by map, and by automatic, the visible pieces only,
/// Otherwise they are all polygons and lines in order of entry.
struct DrawnPieces {
  enum class Kind : std::uint8_t {
    solid,   ///< a filled polygon
    hollow,  ///< only a polygon's sides
    line,    ///< from the first of its two points to the second
  };

  std::vector<Kind> kinds;
  /// Start of each piece in points: piece k is [first[k], first[k + 1]). One extra entry at the
  /// end.
  std::vector<std::uint32_t> first{0};
  /// Device coordinates: x and y in [0,1] over the picture, y up, larger z nearer to the viewer.
  std::vector<Point3> points;
  /// For each point 1, or the kinds of line (clip/surfaces.h), if the side that ends at it is
  /// drawn; 0 if not, as for sides made by cuts. kHiddenLine is added for a line that is drawn
  /// although it is hidden. Sides of a kind with a style of its own are lines after their polygon.
  std::vector<std::uint8_t> sides;
  /// For each point 1 if a line, or a drawn side, is cut there: it continues, but its rest may be
  /// hidden. A thick line has no cap there.
  std::vector<std::uint8_t> cuts;
  /// Per piece: the fill colour of a solid polygon, for a shaded one the mean of its shades; then
  /// the style of its sides or the line.
  std::vector<Colour> fills;
  enum class Line : std::uint8_t { solid, dashed, none };
  std::vector<Line> line_kinds;
  std::vector<Colour> line_colours;
  std::vector<double> line_widths, line_dashes, line_gaps;  ///< in pixels
  std::vector<std::int32_t> picks;     ///< pick identifiers; -1: a line without one
  std::vector<std::int32_t> segments;  ///< names

  std::size_t size() const { return kinds.size(); }
  /// Attributes of piece k.
  struct Looks {
    Kind kind;
    Colour fill;
    LineStyle line;
    std::int32_t pick, segment;
  };
  Looks looks(std::size_t k) const;
  /// Ends a piece, made of the points added since the last one.
  void end_piece(const Looks& looks);
};

DrawnPieces drawn_pieces(const DisplayFile& display_file);

}  // namespace displayfile
