#include "programs/sheet/blanked_lines.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "interp/annotation/page_shapes.h"

namespace displayfile {

namespace {

constexpr double kLeastPart = 1e-9;  // of a line, in parts of its length

/// Returns the part of a line inside a convex polygon: from and to, as fractions of its length.
std::optional<std::pair<double, double>> in_polygon(const Point2& from, const Point2& to,
                                                    std::span<const Point2> polygon) {
  double enters = 0.0, leaves = 1.0;
  Point2 before = polygon.back();
  for (const Point2& corner : polygon) {
    const Point2 side = corner - before;
    const auto inward = [&](const Point2& p) {
      return side.x * (p.y - before.y) - side.y * (p.x - before.x);
    };
    const double a = inward(from), b = inward(to);
    before = corner;
    if (a <= 0.0 && b <= 0.0) return std::nullopt;
    if (a < 0.0) enters = std::max(enters, a / (a - b));
    if (b < 0.0) leaves = std::min(leaves, a / (a - b));
  }
  if (leaves - enters < kLeastPart) return std::nullopt;
  return std::pair(enters, leaves);
}

/// Returns the pieces of a line outside a convex polygon; nothing if all of it is outside.
std::optional<std::vector<DrawingSheet::Line>> outside(const DrawingSheet::Line& line,
                                                       std::span<const Point2> polygon) {
  std::vector<Point2> points = line.points;
  if (line.closed) points.push_back(points.front());
  std::vector<DrawingSheet::Line> pieces;
  std::vector<Point2> piece{points.front()};
  bool is_cut = false;
  const auto end_piece = [&](std::vector<Point2> next) {
    if (piece.size() > 1) pieces.push_back({line.layer, std::move(piece), false});
    piece = std::move(next);
    is_cut = true;
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point2 &from = points[i], &to = points[i + 1];
    if (const auto inside = in_polygon(from, to, polygon)) {
      const auto [enters, leaves] = *inside;
      if (enters > 0.0) piece.push_back(from + enters * (to - from));
      end_piece({leaves < 1.0 ? from + leaves * (to - from) : to});
      if (leaves == 1.0) continue;
    }
    piece.push_back(to);
  }
  if (!is_cut) return std::nullopt;
  end_piece({});
  return pieces;
}

}  // namespace

void remove_lines_within(std::span<const Point2> polygon, DrawingSheet& sheet) {
  const Rectangle box = rectangle_of(polygon);
  std::vector<DrawingSheet::Line> left;
  std::erase_if(sheet.lines, [&](const DrawingSheet::Line& line) {
    if (are_apart(rectangle_of(line.points), box, 0.0)) return false;
    auto pieces = outside(line, polygon);
    if (!pieces) return false;
    std::ranges::move(*pieces, std::back_inserter(left));
    return true;
  });
  std::ranges::move(left, std::back_inserter(sheet.lines));
}

}  // namespace displayfile
