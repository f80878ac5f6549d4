#include "hidden/lines/strokes_once.h"

#include <cmath>
#include <cstddef>

#include "hidden/lines/uppermost_parts.h"
#include "hidden/touching/vertices_within_reach.h"

namespace displayfile {

namespace {

/// The drawn parts of strokes with a length; dots are kept as entered.
std::vector<DrawnPart> parts_of(std::span<const StrokeOfPicture> strokes, double apart) {
  std::vector<LineOfPicture> lines;
  std::vector<RankedPiece> pieces;
  lines.reserve(strokes.size());
  pieces.reserve(strokes.size());
  for (std::uint32_t k = 0; k < strokes.size(); ++k) {
    const StrokeOfPicture& stroke = strokes[k];
    lines.push_back(stroke.line);
    pieces.push_back({k, 0.0, 1.0, stroke.rank, stroke.group, true});
  }
  return uppermost_parts(lines, pieces, apart);
}

Point2 at(const LineOfPicture& line, double share) {
  if (share == 0.0) return line.from;
  return share == 1.0 ? line.to : line.from + share * (line.to - line.from);
}

/// Marks the parts that share no end with another.
void find_alone(std::span<const StrokeOfPicture> strokes, double apart,
                std::vector<StrokePart>& parts) {
  std::vector<Point3> ends;
  ends.reserve(2 * parts.size());
  for (const StrokePart& part : parts) {
    const LineOfPicture& line = strokes[part.stroke].line;
    ends.emplace_back(at(line, part.from), 0.0);
    ends.emplace_back(at(line, part.to), 0.0);
  }
  const std::vector<std::uint32_t> first = first_within(ends, apart);
  std::vector<std::uint32_t> met(ends.size(), 0);
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (!strokes[parts[k / 2].stroke].is_hidden) ++met[first[k]];
  }
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const StrokeOfPicture& stroke = strokes[parts[k].stroke];
    const std::uint32_t from = first[2 * k], to = first[2 * k + 1];
    const std::uint32_t own = from == to ? 2 : 1;
    const bool may_be = !stroke.is_entered && !stroke.is_hidden;
    parts[k].is_alone = may_be && met[from] == own && met[to] == own;
  }
}

}  // namespace

std::vector<StrokePart> strokes_once(std::span<const StrokeOfPicture> strokes, double apart) {
  std::vector<StrokePart> parts;
  if (strokes.empty()) return parts;
  parts.reserve(strokes.size());
  for (const DrawnPart& part : parts_of(strokes, apart)) {
    parts.push_back({part.piece, part.from, part.to, false});
  }
  find_alone(strokes, apart, parts);
  return parts;
}

bool is_shorter_than_wide(const Point2& from, const Point2& to, const Point2& pixels,
                          double width) {
  const Point2 way = (to - from) * pixels;
  return pixels.x > 0.0 && std::hypot(way.x, way.y) < width;
}

}  // namespace displayfile
