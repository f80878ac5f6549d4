#include "interp/visibility/polygon_z_buffer.h"

#include <vector>

#include "interp/scan/scan_convert.h"
#include "interp/visibility/z_buffer.h"

namespace displayfile {

void PolygonZBuffer::prepare(const Request& request, int /*threads*/) { request_.emplace(request); }

void PolygonZBuffer::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  request_->roundoff ? draw<double>(row_begin, row_end, seen)
                     : draw<float>(row_begin, row_end, seen);
}

template <class Depth>
void PolygonZBuffer::draw(int row_begin, int row_end, const SeenRun& seen) const {
  const auto& [scene, size, roundoff] = *request_;
  const auto width = static_cast<std::size_t>(size.width);
  const auto start = [&](int row) { return static_cast<std::size_t>(row - row_begin) * width; };
  std::vector<ZBuffer::Cell<Depth>> cells(start(row_end));
  std::vector<ViewedScene::Fill> begun;  // of the z-buffer's owners
  ZBuffer z_buffer(size, roundoff);
  ScanConverter converter;
  for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) {
    const auto vertices = scene.vertices(fill);
    const ScanConverter::Rows rows = converter.begin(vertices, {size, row_begin, row_end});
    if (rows.first == rows.end) continue;
    z_buffer.begin_polygon(vertices, scene.plane(fill));
    begun.push_back(fill);
    converter.scan([&](int row, int first, int end) {
      z_buffer.draw_span(row, first, end, cells.data() + start(row));
    });
  }
  std::vector<ViewedScene::Fill> of_row(width);
  for (int row = row_begin; row < row_end; ++row) {
    for (std::size_t i = 0; i < width; ++i) {
      const auto& cell = cells[start(row) + i];
      of_row[i] = cell.is_background() ? ViewedScene::kBackground : begun[cell.owner];
    }
    seen(row, 0, of_row);
  }
}

}  // namespace displayfile
