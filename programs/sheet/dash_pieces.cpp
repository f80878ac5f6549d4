#include "programs/sheet/dash_pieces.h"

#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

namespace displayfile {

std::vector<std::vector<Point2>> dash_pieces(const std::vector<Point2>& points, bool closed,
                                             const std::vector<double>& dashes) {
  std::vector<std::vector<Point2>> pieces;
  std::size_t dash = 0;
  double left = dashes[0];  // of the dash, or of the gap
  std::vector<Point2> piece{points.front()};
  const auto is_drawn = [&] { return dash % 2 == 0; };
  const std::size_t sides = points.size() - (closed ? 0 : 1);
  for (std::size_t k = 0; k < sides; ++k) {
    const Point2 from = points[k], to = points[(k + 1) % points.size()];
    const double length = glm::distance(from, to);
    double at = 0.0;
    while (length - at > left) {
      at += left;
      const Point2 end = from + (at / length) * (to - from);
      if (is_drawn()) {
        piece.push_back(end);
        pieces.push_back(std::exchange(piece, {}));
      } else {
        piece = {end};
      }
      dash = (dash + 1) % dashes.size();
      left = dashes[dash];
    }
    left -= length - at;
    if (is_drawn()) piece.push_back(to);
  }
  if (piece.size() > 1) pieces.push_back(std::move(piece));
  return pieces;
}

}  // namespace displayfile
