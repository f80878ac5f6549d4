#include "interp/visibility/scan_line_z.h"

#include <algorithm>
#include <tuple>

#include "interp/scan/scan_edge.h"
#include "interp/visibility/depth_row.h"

namespace displayfile {

namespace {

/// The number of polygons of the table that are skipped together if none of them reaches a row.
constexpr std::size_t kBlock = 64;

/// The number of edges for which there is always room.
constexpr std::size_t kFewEdges = 64;

}  // namespace

void ScanLineZ::prepare(const Request& request, int /*threads*/) {
  request_.emplace(request);
  const ViewedScene& scene = request.scene;
  table_.clear();
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const auto [lowest, highest] = std::ranges::minmax(scene.vertices(fill), {}, &Point3::y);
    const int first = first_row_above(lowest.y, request.size.height);
    const int end = first_row_above(highest.y, request.size.height);
    if (first < end) table_.push_back({fill, first, end});
  }
  std::ranges::sort(table_, {}, [](const Polygon& p) { return std::tuple(p.first_row, p.fill); });
  block_end_row_.assign((table_.size() + kBlock - 1) / kBlock, 0);
  for (std::size_t i = 0; i < table_.size(); ++i) {
    block_end_row_[i / kBlock] = std::max(block_end_row_[i / kBlock], table_[i].end_row);
  }
}

/// The sweep over the rows from row_begin to row_end, from the bottom. Its active edge list is not
/// ActivePolygons, which keeps polygons unordered and an entry for each row of the picture: here
/// the spans of a row are drawn in order of entry, and no memory depends on the picture's height.
class ScanLineZ::Sweep {
 public:
  Sweep(const ScanLineZ& method, int row_begin, int row_end)
      : method_(method),
        scene_(method.request_->scene),
        size_(method.request_->size),
        row_end_(row_end),
        row_(scene_, size_, method.request_->roundoff) {
    find_active_below(row_begin);
  }

  void draw_row(int row, const SeenRun& seen) {
    std::erase_if(active_, [&](const ActivePolygon& p) { return p.end_row <= row; });
    enter_polygons(row);
    row_.begin(row);
    for (ActivePolygon& polygon : active_) {
      if (row == polygon.edges_hold_until) update_edges(polygon, row);
      fill_between_edges(polygon, row);
    }
    seen(row, 0, row_.seen());
  }

 private:
  /// A polygon that reaches the row. Of its edges, ordered by first row, those before `active` have
  /// ended and those from `next` on have not begun.
  struct ActivePolygon {
    Fill fill;
    int end_row;
    int edges_hold_until;  ///< the next row at which an edge begins or ends
    std::uint32_t active, next, end;
    FillDepth depth;
  };

  void find_active_below(int row);
  void enter_polygons(int row);
  void enter(const Polygon& polygon, int row);
  void update_edges(ActivePolygon& polygon, int row);
  void fill_between_edges(const ActivePolygon& polygon, int row);
  void drop_ended_edges(std::size_t to_come);

  const ScanLineZ& method_;
  const ViewedScene& scene_;
  const PictureSize size_;
  const int row_end_;
  DepthRow row_;
  std::size_t next_ = 0;               // in the polygon table
  std::vector<ActivePolygon> active_;  // by fill
  std::vector<ScanEdge> edges_;
  std::vector<int> columns_;
};

/// Enters the polygons that cross the row and begin below it.
void ScanLineZ::Sweep::find_active_below(int row) {
  const auto& table = method_.table_;
  const auto begun = std::ranges::lower_bound(table, row, {}, &Polygon::first_row);
  next_ = static_cast<std::size_t>(begun - table.begin());
  for (std::size_t i = 0; i < next_; ++i) {
    if (i % kBlock == 0 && method_.block_end_row_[i / kBlock] <= row) {
      i += kBlock - 1;
      continue;
    }
    if (table[i].end_row > row) enter(table[i], row);
  }
  std::ranges::sort(active_, {}, &ActivePolygon::fill);
}

/// Enters the polygons that begin in this row. Spans are drawn in order of entry, so that of equal
/// depths the later one is visible.
void ScanLineZ::Sweep::enter_polygons(int row) {
  const auto& table = method_.table_;
  const auto before = static_cast<std::ptrdiff_t>(active_.size());
  for (; next_ < table.size() && table[next_].first_row == row; ++next_) enter(table[next_], row);
  std::inplace_merge(
      active_.begin(), active_.begin() + before, active_.end(),
      [](const ActivePolygon& a, const ActivePolygon& b) { return a.fill < b.fill; });
}

void ScanLineZ::Sweep::enter(const Polygon& polygon, int row) {
  const auto vertices = scene_.vertices(polygon.fill);
  if (edges_.size() + vertices.size() > edges_.capacity()) drop_ended_edges(vertices.size());
  const auto start = static_cast<std::uint32_t>(edges_.size());
  append_edges(vertices, size_, row, row_end_, edges_);
  const auto end = static_cast<std::uint32_t>(edges_.size());
  active_.push_back({polygon.fill, polygon.end_row, row, start, start, end,
                     FillDepth(scene_, polygon.fill, size_, method_.request_->roundoff)});
}

/// The edges of ended polygons are kept until they may be a third of all: constant cost per edge.
void ScanLineZ::Sweep::drop_ended_edges(std::size_t to_come) {
  std::size_t living = to_come;
  for (const ActivePolygon& polygon : active_) living += polygon.end - polygon.active;
  std::vector<ScanEdge> kept;
  kept.reserve(living + living / 2 + kFewEdges);
  for (ActivePolygon& polygon : active_) {
    const auto start = static_cast<std::uint32_t>(kept.size());
    kept.insert(kept.end(), edges_.begin() + polygon.active, edges_.begin() + polygon.end);
    polygon.next = start + polygon.next - polygon.active;
    polygon.end = start + polygon.end - polygon.active;
    polygon.active = start;
  }
  edges_ = std::move(kept);
}

void ScanLineZ::Sweep::update_edges(ActivePolygon& polygon, int row) {
  for (std::uint32_t k = polygon.active; k < polygon.next; ++k) {
    if (edges_[k].last_row < row) std::swap(edges_[k], edges_[polygon.active++]);
  }
  while (polygon.next < polygon.end && edges_[polygon.next].first_row <= row) ++polygon.next;
  int until = polygon.next < polygon.end ? edges_[polygon.next].first_row : polygon.end_row;
  for (std::uint32_t k = polygon.active; k < polygon.next; ++k) {
    until = std::min(until, edges_[k].last_row + 1);
  }
  polygon.edges_hold_until = until;
}

/// Pairs the edges of one polygon, whatever lies between them: even-odd.
void ScanLineZ::Sweep::fill_between_edges(const ActivePolygon& polygon, int row) {
  row_.begin_fill(polygon.fill, polygon.depth);
  if (polygon.next - polygon.active == 2) {
    const int a = edges_[polygon.active].column(row, size_);
    const int b = edges_[polygon.active + 1].column(row, size_);
    row_.draw_span(std::min(a, b), std::max(a, b));
    return;
  }
  columns_.clear();
  for (std::uint32_t k = polygon.active; k < polygon.next; ++k) {
    columns_.push_back(edges_[k].column(row, size_));
  }
  std::ranges::sort(columns_);
  for (std::size_t k = 0; k + 1 < columns_.size(); k += 2) {
    row_.draw_span(columns_[k], columns_[k + 1]);
  }
}

void ScanLineZ::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  Sweep sweep(*this, row_begin, row_end);
  for (int row = row_begin; row < row_end; ++row) sweep.draw_row(row, seen);
}

}  // namespace displayfile
