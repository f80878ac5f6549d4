#include "interp/visibility/ray_cast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "interp/scan/scan_convert.h"
#include "interp/visibility/ray_packet.h"

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

/// Polygons with more sides are scan-converted once for a band of packets.
constexpr std::size_t kFewSides = 8;

/// The least float that is not less than z.
float rounded_up(double z) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (!(z < kLargest)) return kInfinity;
  return std::nextafter(static_cast<float>(std::max(z, -kLargest)), kInfinity);
}

/// An upper bound of all depths there, true or rounded: a fill's plane is nearest at a corner of
/// the box of centres that it may cover; a triangle is nowhere nearer than its vertices.
float nearest(std::span<const Point3> polygon, const PixelBox& pixels, const PixelDepth& depth,
              double error) {
  double z = -std::numeric_limits<double>::infinity();
  for (const int row : {pixels.first_row, pixels.end_row - 1}) {
    const double row_depth = depth.row(row);
    for (const int column : {pixels.first_column, pixels.end_column - 1}) {
      z = std::max(z, depth.at(row_depth, column));
    }
  }
  if (polygon.size() == 3) {
    z = std::min(z, std::max({polygon[0].z, polygon[1].z, polygon[2].z}));
  }
  return rounded_up(z + 4.0 * error);
}

}  // namespace

void RayCast::enter_edges(Target& target) {
  const auto polygon = request_->scene.vertices(target.fill);
  if (polygon.size() > kFewSides) {
    target.many_sided = many_sided_++;
    return;
  }
  const PictureSize& size = request_->size;
  target.first_edge = static_cast<std::uint32_t>(edges_.size());
  Point2 from(polygon.back());
  int from_row = first_row_above(from.y, size.height);
  for (const Point3& vertex : polygon) {
    const Point2 to(vertex);
    const int to_row = first_row_above(to.y, size.height);
    if (from_row < to_row) edges_.emplace_back(from, to, from_row, to_row - 1, size);
    if (to_row < from_row) edges_.emplace_back(to, from, to_row, from_row - 1, size);
    from = to;
    from_row = to_row;
  }
  target.end_edge = static_cast<std::uint32_t>(edges_.size());
}

/// Fills that lie between the centres are omitted.
void RayCast::find_targets(int threads) {
  const auto& [scene, size, roundoff] = *request_;
  std::vector<DeepPixelBox> boxes;
  boxes.reserve(scene.end());
  targets_.reserve(scene.end());
  edges_.reserve(std::size_t{3} * scene.end());
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    const auto polygon = scene.vertices(fill);
    Target target{fill, 0, 0, kFewSided, extents_of(polygon, size)};
    if (target.pixels.empty()) continue;
    enter_edges(target);
    targets_.push_back(target);
    const PixelDepth& depth = depths_.depth(fill);
    const double error =
        roundoff ? depth_bound(polygon, scene.plane(fill), depth, size).error : depths_.error(fill);
    boxes.push_back({target.pixels, nearest(polygon, target.pixels, depth, error)});
  }
  tree_.build(boxes, threads);
  // Targets visited in succession are stored close together.
  std::vector<Target> ordered;
  ordered.reserve(targets_.size());
  for (const PixelTree::Item item : tree_.order()) ordered.push_back(targets_[item]);
  targets_ = std::move(ordered);
}

void RayCast::prepare(const Request& request, int threads) {
  request_.emplace(request);
  depths_ = FillDepths(request.scene, request.size, request.roundoff);
  targets_.clear();
  edges_.clear();
  many_sided_ = 0;
  find_targets(threads);
}

/// Casts the rays of some rows, for one thread.
class RayCast::Caster {
 public:
  Caster(const RayCast& method, int row_begin, int row_end)
      : method_(method), row_begin_(row_begin), row_end_(row_end), spans_(method.many_sided_) {}

  void cast(RayPacket& packet) {
    front_to_back(
        method_.tree_, packet.rays(),
        [&](float nearest) { return packet.hides_all_beyond(nearest); },
        [&](PixelTree::Position position) {
          const Target& target = method_.targets_[position];
          packet.begin_fill(target.fill);
          target.many_sided == kFewSided ? intersect_few_sided(target, packet)
                                         : intersect_many_sided(target, packet);
          packet.end_fill();
        });
  }

 private:
  /// Covered centres of a row.
  struct Span {
    int row, first, end;
  };
  struct Spans {
    bool known = false;
    std::vector<Span> spans;  // row by row, left to right
  };

  /// The rays of a row that hit the fill lie between its crossings, pair by pair.
  void intersect_few_sided(const Target& target, RayPacket& packet) const {
    const PixelBox& rays = packet.rays();
    const ScanEdge* const first_edge = method_.edges_.data() + target.first_edge;
    const ScanEdge* const end_edge = method_.edges_.data() + target.end_edge;
    const int end_row = std::min(rays.end_row, target.pixels.end_row);
    for (int row = std::max(rays.first_row, target.pixels.first_row); row < end_row; ++row) {
      std::array<int, kFewSides> columns;
      std::size_t crossings = 0;
      for (const ScanEdge* edge = first_edge; edge != end_edge; ++edge) {
        if (row < edge->first_row || row > edge->last_row) continue;
        const int column = std::clamp(edge->column(row, method_.request_->size), rays.first_column,
                                      rays.end_column);
        std::size_t at = crossings++;  // left to right
        for (; at > 0 && columns[at - 1] > column; --at) columns[at] = columns[at - 1];
        columns[at] = column;
      }
      for (std::size_t k = 0; k + 1 < crossings; k += 2) {
        packet.hit(row, columns[k], columns[k + 1]);
      }
    }
  }

  void intersect_many_sided(const Target& target, RayPacket& packet) {
    const PixelBox& rays = packet.rays();
    const std::vector<Span>& spans = spans_of(target);
    for (int row = rays.first_row; row < rays.end_row; ++row) {
      // The first span that ends right of the rays' first column.
      auto span = std::partition_point(spans.begin(), spans.end(), [&](const Span& s) {
        return s.row < row || (s.row == row && s.end <= rays.first_column);
      });
      for (; span != spans.end() && span->row == row && span->first < rays.end_column; ++span) {
        packet.hit(row, std::max(span->first, rays.first_column),
                   std::min(span->end, rays.end_column));
      }
    }
  }

  /// Computed once for all packets of the band.
  const std::vector<Span>& spans_of(const Target& target) {
    Spans& of = spans_[target.many_sided];
    if (!of.known) {
      of.known = true;
      converter_.scan_convert(method_.request_->scene.vertices(target.fill),
                              {method_.request_->size, row_begin_, row_end_},
                              [&](int row, int first, int end) {
                                of.spans.push_back({row, first, end});
                              });
    }
    return of.spans;
  }

  const RayCast& method_;
  int row_begin_, row_end_;
  std::vector<Spans> spans_;
  ScanConverter converter_;
};

void RayCast::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  const PictureSize& size = request_->size;
  const auto width = static_cast<std::size_t>(size.width);
  std::vector<Fill> band(width * RayPacket::kSide);
  RayPacket packet(request_->scene, depths_, size);
  for (int first = row_begin; first < row_end; first += RayPacket::kSide) {
    const int end = std::min(first + RayPacket::kSide, row_end);
    Caster caster(*this, first, end);
    for (int column = 0; column < size.width; column += RayPacket::kSide) {
      packet.begin({column, std::min(column + RayPacket::kSide, size.width), first, end});
      do caster.cast(packet);
      while (packet.begin_next_cast());
      for (int row = first; row < end; ++row) {
        const auto of_row = static_cast<std::size_t>(row - first) * width;
        std::ranges::copy(
            packet.seen(row),
            band.begin() + static_cast<std::ptrdiff_t>(of_row + static_cast<std::size_t>(column)));
      }
    }
    for (int row = first; row < end; ++row) {
      seen(row, 0, std::span(band).subspan(static_cast<std::size_t>(row - first) * width, width));
    }
  }
}

ViewedScene::Fill RayCast::seen_at(int column, int row) const {
  RayPacket packet(request_->scene, depths_, request_->size);
  packet.begin({column, column + 1, row, row + 1});
  Caster caster(*this, row, row + 1);
  do caster.cast(packet);
  while (packet.begin_next_cast());
  return packet.seen(row).front();
}

}  // namespace displayfile
