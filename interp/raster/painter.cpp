#include "interp/raster/painter.h"

#include <optional>

#include "hidden/exact/support_plane.h"
#include "interp/raster/pixel_shade.h"
#include "interp/scan/pixel_depth.h"

namespace displayfile {

void Painter::fill(const DrawnPolygon& polygon) {
  const ScanConverter::Rows rows = converter_.begin(polygon.vertices, band_.region);
  if (rows.first == rows.end) return;
  painted_.add(static_cast<std::size_t>(rows.end - rows.first));
  const SupportVertices support = support_vertices(polygon.vertices);
  if (support.edge_on) return;
  const FillColour colour(polygon, band_.size(), band_.shadows);
  std::vector<double>& depths = band_.picture.depth;
  std::optional<PixelDepth> depth;
  if (!depths.empty()) {
    depth.emplace(polygon.vertices, support, band_.size().width, band_.size().height);
  }
  converter_.scan([&](int row, int first, int end) {
    band_.paint(row, first, end, colour, polygon.pick);
    if (!depth) return;
    const std::size_t start = band_.index(row, 0);
    const double row_depth = depth->row(row);
    for (int i = first; i < end; ++i) {
      depths[start + static_cast<std::size_t>(i)] = depth->at(row_depth, i);
    }
  });
}

}  // namespace displayfile
