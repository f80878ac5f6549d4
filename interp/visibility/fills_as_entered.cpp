#include "interp/visibility/fills_as_entered.h"

#include <algorithm>
#include <cmath>

namespace displayfile {

Point2 boundary_error(const ViewedScene& scene, std::span<const Point3> polygon,
                      const PictureSize& size) {
  return boundary_error(polygon, size) + scene.boundary_error() * Point2(size.width, size.height);
}

void note_boundary(const ViewedScene& scene, ViewedScene::Fill fill, const PictureSize& size,
                   ScanConverter& converter, PixelSet& noted) {
  const PointRow row = scene.vertices(fill);
  const std::span<const Point3> polygon{row.data(), row.size()};
  const Point2 error = boundary_error(scene, polygon, size);
  note_rows_of_vertices(polygon, error, size, noted);
  const auto rows = converter.begin(polygon, {size, noted.row_begin(), noted.row_end()});
  if (rows.first == rows.end) return;
  converter.watch(error);
  converter.scan([](int, int, int) {},
                 [&](int at, int first, int end) { noted.add(at, first, end); });
}

FillsAsEntered::FillsAsEntered(const ViewedScene& scene, const PictureSize& size)
    : scene_(scene), size_(size), orders_(scene) {}

/// True if a noted centre is so close to the boundary that viewing may decide its coverage, and the
/// outline as entered is available; otherwise runs_ are the covered pixels.
bool FillsAsEntered::is_close(Fill fill, const ScanConverter::Region& region,
                              const PixelSet& noted) {
  const PointRow row = scene_.vertices(fill);
  const std::span<const Point3> polygon{row.data(), row.size()};
  runs_.clear();
  const auto rows = converter_.begin(polygon, region);
  const auto take = [&](int at, int first, int end) { runs_.push_back({at, first, end}); };
  if (!are_rounded()) {
    if (rows.first < rows.end) converter_.scan(take);
    return false;
  }
  const Point2 error = boundary_error(scene_, polygon, size_);
  bool close = is_close_to_vertices(polygon, error, noted);
  if (rows.first < rows.end) {
    converter_.watch(error);
    converter_.scan(
        take, [&](int at, int first, int end) { close = close || noted.any(at, first, end); });
  }
  if (!close) return false;
  const ViewedScene::Item item = scene_.item_of(fill);
  const auto entered = scene_.as_entered(item);
  if (!entered.is_known()) return false;
  EnteredProjection& view = views_.of(entered, scene_.look_of(item));
  return !view.are_unrounded(entered.polygon, polygon) && view.outline(entered.polygon, outline_);
}

/// True if a noted centre lies in the row of a vertex that is within `error` of the row's centres.
bool FillsAsEntered::is_close_to_vertices(std::span<const Point3> polygon, const Point2& error,
                                          const PixelSet& noted) const {
  return std::ranges::any_of(polygon, [&](const Point3& v) {
    const double y = v.y * size_.height;
    const double row = std::floor(y);
    if (!(row >= noted.row_begin() && row < noted.row_end())) return false;
    return std::abs(y - row - 0.5) <= error.y && noted.any(static_cast<int>(row), 0, size_.width);
  });
}

/// Enters a fill: it becomes the owner of the covered centres where it is nearest so far.
void FillsAsEntered::enter(Fill fill, const PixelSet& centres, NotedCentres& noted) {
  const PointRow row = scene_.vertices(fill);
  const ScanConverter::Region region = noted.rows_of({row.data(), row.size()});
  if (region.row_begin >= region.row_end) return;
  scan(fill, region, centres, [&](int at, int first, int end) {
    noted.in_run(at, first, end, [&](int column, NotedCentres::Owner& owner) {
      if (owner == NotedCentres::kNone || later_is_seen(owner, fill, column, at)) owner = fill;
    });
  });
}

}  // namespace displayfile
