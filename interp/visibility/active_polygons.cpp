#include "interp/visibility/active_polygons.h"
#include "interp/scan/sort_stably.h"

namespace displayfile {

namespace {

/// The rows that a polygon crosses; none if last < first.
struct Rows {
  int first, last;
};
Rows rows_of(std::span<const Point3> vertices, int height) {
  double low = vertices[0].y, high = low;
  for (const Point3& v : vertices) {
    low = std::min(low, v.y);
    high = std::max(high, v.y);
  }
  return {first_row_above(low, height), first_row_above(high, height) - 1};
}

double x_in(const ScanEdge& side, int row) { return side.x + (row + 0.5 - side.y) * side.dx_dy; }

/// True if one side certainly lies left of the other in this row.
bool lies_left(const ScanEdge& side, const ScanEdge& other, int row) {
  return x_in(other, row) - x_in(side, row) > 2.0 * (side.error + other.error);
}

/// Rests shorter than this cost more than examining the polygon again.
constexpr int kShortestRest = 4;

}  // namespace

PolygonList::PolygonList(const ViewedScene& scene, int height)
    : begin_(static_cast<std::size_t>(height) + 1, 0) {
  std::vector<Rows> rows(scene.end());
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    rows[fill] = rows_of(scene.vertices(fill), height);
    if (rows[fill].first <= rows[fill].last) ++begin_[static_cast<std::size_t>(rows[fill].first)];
  }
  // One bucket per row: begin_ first holds the buckets' ends, and filling them from the back turns
  // these into their beginnings.
  std::uint32_t end = 0;
  for (std::uint32_t& begin : begin_) begin = end += begin;
  entries_.resize(end);
  for (Fill fill = scene.end() - 1; fill > 0; --fill) {
    if (rows[fill].first > rows[fill].last) continue;
    entries_[--begin_[static_cast<std::size_t>(rows[fill].first)]] = {fill, rows[fill].last};
  }
}

ActivePolygons::ActivePolygons(const ViewedScene& scene, const FillDepths& depths,
                               const PictureSize& size, const PolygonList& list, int row_begin)
    : scene_(&scene),
      depths_(&depths),
      list_(&list),
      size_(size),
      row_(row_begin - 1),
      row_begin_(row_begin),
      wakes_(static_cast<std::size_t>(size.height - row_begin), kNone) {}

void ActivePolygons::enter_polygons() {
  if (row_ == row_begin_) {
    for (const auto& entry : list_->first_below(row_)) {
      if (entry.last_row >= row_) enter(entry);
    }
  } else {
    for (std::uint32_t k = wakes_[static_cast<std::size_t>(row_ - 1 - row_begin_)]; k != kNone;
         k = resting_[k].next) {
      enter(resting_[k].entry);
    }
  }
  for (const auto& entry : list_->first_in(row_)) enter(entry);
}

void ActivePolygons::enter(const PolygonList::Entry& entry) {
  if (sides_left_ > sides_.size() / 2 + 64) compact_sides();
  const auto first = static_cast<std::uint32_t>(sides_.size());
  make_edge_table(entry.fill);
  polygons_.push_back({depths_->depth(entry.fill), depths_->error(entry.fill), entry.fill,
                       entry.last_row, row_ - 1, row_ - 1, row_, row_, first, first,
                       static_cast<std::uint32_t>(sides_.size())});
}

/// The sides that cross this row or one above it, by their first row.
void ActivePolygons::make_edge_table(Fill fill) {
  const auto vertices = scene_->vertices(fill);
  const std::size_t table = sides_.size();
  Point2 from(vertices.back());
  int from_row = first_row_above(from.y, size_.height);
  for (const Point3& vertex : vertices) {
    const Point2 to(vertex);
    const int to_row = first_row_above(to.y, size_.height);
    const int first = std::min(from_row, to_row), last = std::max(from_row, to_row) - 1;
    if (first <= last && last >= row_) {
      const bool up = from_row < to_row;
      sides_.emplace_back(up ? from : to, up ? to : from, first, last, size_);
    }
    from = to;
    from_row = to_row;
  }
  sort_stably(std::span(sides_).subspan(table), &ScanEdge::first_row);
}

void ActivePolygons::update_active_edges(Polygon& polygon) {
  for (std::uint32_t k = polygon.live; k < polygon.next; ++k) {
    if (sides_[k].last_row >= row_) continue;
    std::swap(sides_[k], sides_[polygon.live++]);
    ++sides_left_;
  }
  polygon.stands_from = polygon.may_rest_from = row_;
  while (polygon.next < polygon.end && sides_[polygon.next].first_row <= row_) ++polygon.next;
  polygon.stands_until =
      polygon.next < polygon.end ? sides_[polygon.next].first_row - 1 : polygon.last_row;
  for (std::uint32_t k = polygon.live; k < polygon.next; ++k) {
    polygon.stands_until = std::min(polygon.stands_until, sides_[k].last_row);
  }
}

/// True if the polygon is not active in this row, and has been removed.
bool ActivePolygons::let_go_or_rest(Index k) {
  Polygon& polygon = polygons_[k];
  if (polygon.last_row < row_) {
    remove(k);
    return true;
  }
  if (polygon.rests_until >= row_) {
    if (polygon.rests_until < polygon.last_row) {
      std::uint32_t& wakes = wakes_[static_cast<std::size_t>(polygon.rests_until - row_begin_)];
      resting_.push_back({{polygon.fill, polygon.last_row}, wakes});
      wakes = static_cast<std::uint32_t>(resting_.size() - 1);
    }
    remove(k);
    return true;
  }
  update_active_edges(polygon);
  return false;
}

void ActivePolygons::remove(Index k) {
  sides_left_ += polygons_[k].end - polygons_[k].live;
  polygons_[k] = polygons_.back();
  polygons_.pop_back();
}

/// Moves fewer sides than were removed since the last time.
void ActivePolygons::compact_sides() {
  std::vector<ScanEdge> sides;
  for (Polygon& polygon : polygons_) {
    const auto first = static_cast<std::uint32_t>(sides.size());
    sides.insert(sides.end(), sides_.begin() + polygon.live, sides_.begin() + polygon.end);
    polygon.next = first + (polygon.next - polygon.live);
    polygon.end = first + (polygon.end - polygon.live);
    polygon.live = first;
  }
  sides_.swap(sides);
  sides_left_ = 0;
}

/// The two sides of a polygon that has no others up to a later row, and does not cross itself; none
/// for other polygons.
std::optional<ActivePolygons::Sides> ActivePolygons::sides_until(const Polygon& polygon,
                                                                 int last) const {
  if (polygon.next - polygon.live != 2) return std::nullopt;
  Sides sides{&sides_[polygon.live], &sides_[polygon.live + 1]};
  if (x_in(*sides.left, row_) > x_in(*sides.right, row_)) std::swap(sides.left, sides.right);
  const bool apart =
      lies_left(*sides.left, *sides.right, row_) && lies_left(*sides.left, *sides.right, last);
  return apart ? std::optional(sides) : std::nullopt;
}

/// Sides are straight: an order that holds in both rows holds between them.
std::optional<std::array<ActivePolygons::Width, 2>> ActivePolygons::stays_within(
    Index inside, Index other) const {
  const int last = std::min(polygons_[inside].stands_until, polygons_[other].stands_until);
  if (last - row_ < kShortestRest && last < polygons_[inside].last_row) return std::nullopt;
  const auto a = sides_until(polygons_[inside], last), b = sides_until(polygons_[other], last);
  if (!a || !b) return std::nullopt;
  const auto not_left = [&](const ScanEdge& side, const ScanEdge& of_other) {
    return (side.low == of_other.low && side.high == of_other.high) ||
           (lies_left(of_other, side, row_) && lies_left(of_other, side, last));
  };
  if (!not_left(*a->left, *b->left) || !not_left(*b->right, *a->right)) return std::nullopt;
  const auto width_in = [&](int row) {
    return Width{row, x_in(*a->left, row), x_in(*a->right, row), a->left->error + a->right->error};
  };
  const std::array widths{width_in(row_), width_in(last)};
  for (const Width& width : widths) {
    if (width.left < -0.5 || width.right > size_.width + 0.5) return std::nullopt;
  }
  return widths;
}

}  // namespace displayfile
