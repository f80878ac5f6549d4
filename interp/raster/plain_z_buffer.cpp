#include "interp/raster/plain_z_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "interp/interpreter.h"
#include "interp/raster/software.h"

namespace displayfile {

namespace {

/// The policies: what a depth is stored as, and what stands for the background.
template <class Number>
struct FloatingDepth {
  using Stored = Number;
  static constexpr Stored kFarthest = -std::numeric_limits<Number>::infinity();
  static Stored store(double z) {
    constexpr double kLargest = std::numeric_limits<Number>::max();
    return static_cast<Number>(std::clamp(z, -kLargest, kLargest));
  }
  static double z(Stored stored) { return stored; }
};

template <int kBits>
struct IntegerDepth {
  using Stored = std::int64_t;
  static constexpr Stored kFarthest = -1;  // a frame buffer's own 0 would hide what lies at 0
  static constexpr double kLargest = static_cast<double>((std::int64_t{1} << kBits) - 1);
  static Stored store(double z) {
    return static_cast<Stored>(std::clamp(z, 0.0, 1.0) * kLargest + 0.5);
  }
  static double z(Stored stored) { return static_cast<double>(stored) / kLargest; }
};

/// The lecture's edge data, section 4: the last row, and x and z where the edge crosses the
/// current row, with what they change by from row to row.
struct Edge {
  int first_row, last_row;
  double x, z, dx, dz;
};

/// The rows whose centres are above y, from this one on; no farther than the picture.
int row_above(double y, int height) {
  return static_cast<int>(std::clamp(std::floor(y - 0.5) + 1.0, 0.0, static_cast<double>(height)));
}
int column_from(double x, int width) {
  return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(width)));
}

template <class Depth>
class PlainZBuffer : public OutputDevice {
 public:
  PlainZBuffer(Picture& picture, bool ids)
      : picture_(picture), ids_(ids), depth_(picture.pixels.size(), Depth::kFarthest) {}

  void fill(const DrawnPolygon& polygon) override {
    const std::uint32_t colour = pixel_of(even_fill(polygon).colour);
    make_edge_table(polygon.vertices);
    active_.clear();
    std::size_t next = 0;
    for (int row = edges_.empty() ? 0 : edges_[0].first_row;
         next < edges_.size() || !active_.empty(); ++row) {
      update_active_edges(row, next);
      // The textbook's FILLIN, with a z for each end of the span (chapter 9, "Z buffers").
      for (std::size_t i = 0; i + 1 < active_.size(); i += 2) {
        fill_in(row, active_[i], active_[i + 1], colour, polygon.pick);
      }
    }
  }
  void edges(const DrawnPolygon&) override {}
  void line(const DrawnLine&) override {}

  /// As stored; minus infinity for the background.
  std::vector<double> depths() const {
    std::vector<double> z(depth_.size());
    std::ranges::transform(depth_, z.begin(), [](const auto& stored) {
      return stored == Depth::kFarthest ? -std::numeric_limits<double>::infinity()
                                        : Depth::z(stored);
    });
    return z;
  }

 private:
  /// The lecture's edge table, section 4: the edges by their first row, with dx and dz as in
  /// its section 3, "along a polygonal edge". Level edges and those between two rows of centres
  /// are left out.
  void make_edge_table(std::span<const Point3> vertices) {
    edges_.clear();
    Point3 from = to_pixels(vertices.back());
    for (const Point3& vertex : vertices) {
      const Point3 to = to_pixels(vertex);
      const Point3 &low = from.y < to.y ? from : to, &high = from.y < to.y ? to : from;
      const int first = row_above(low.y, picture_.height);
      const int last = row_above(high.y, picture_.height) - 1;
      if (first <= last) {
        const double dx = (high.x - low.x) / (high.y - low.y);
        const double dz = (high.z - low.z) / (high.y - low.y);
        const double rise = first + 0.5 - low.y;
        edges_.push_back({first, last, low.x + rise * dx, low.z + rise * dz, dx, dz});
      }
      from = to;
    }
    std::ranges::sort(edges_, {}, &Edge::first_row);
  }

  /// The lecture's "updating the active edge list", section 4; the additions are the
  /// textbook's UPDATE-X-VALUES (algorithm 3.15) for x and for z.
  void update_active_edges(int row, std::size_t& next) {
    std::erase_if(active_, [&](const Edge& edge) { return row > edge.last_row; });
    for (Edge& edge : active_) {
      edge.x += edge.dx;
      edge.z += edge.dz;
    }
    while (next < edges_.size() && edges_[next].first_row == row) active_.push_back(edges_[next++]);
    std::ranges::sort(active_, {}, &Edge::x);
  }

  /// The lecture's section 3, "along a scan line": z_new = z_old + dz.
  void fill_in(int row, const Edge& left, const Edge& right, std::uint32_t colour,
               std::int32_t pick) {
    const int first = column_from(left.x, picture_.width);
    const int end = column_from(right.x, picture_.width);
    if (first >= end) return;
    const double dz = (right.z - left.z) / (right.x - left.x);
    double z = left.z + (first + 0.5 - left.x) * dz;
    const std::size_t start = static_cast<std::size_t>(picture_.height - 1 - row) *
                              static_cast<std::size_t>(picture_.width);
    for (std::size_t i = start + static_cast<std::size_t>(first);
         i < start + static_cast<std::size_t>(end); ++i, z += dz) {
      // The textbook: larger is nearer. At equal depth the polygon entered later is seen.
      const typename Depth::Stored stored = Depth::store(z);
      if (stored < depth_[i]) continue;
      depth_[i] = stored;
      picture_.pixels[i] = colour;
      if (ids_) picture_.ids[i] = pick;
    }
  }

  Point3 to_pixels(const Point3& device) const {
    return {device.x * picture_.width, device.y * picture_.height, device.z};
  }

  Picture& picture_;
  bool ids_;
  std::vector<typename Depth::Stored> depth_;
  std::vector<Edge> edges_, active_;
};

template <class Depth>
Picture draw(const DisplayFile& display_file, const RasterRequest& request) {
  require_picture_size(request.width, request.height);
  const auto size =
      static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
  Picture picture;
  picture.width = request.width;
  picture.height = request.height;
  picture.pixels.assign(size, 0xFFFFFFFF);
  picture.ids.assign(request.ids ? size : 0, -1);
  PlainZBuffer<Depth> z_buffer(picture, request.ids);
  interpret(display_file, z_buffer, Pass::fills, Order::entered);
  if (request.depth) picture.depth = z_buffer.depths();
  return picture;
}

constexpr std::array kDepthFormats{
    DepthFormatEntry{DepthFormat::float_32, "float"},
    DepthFormatEntry{DepthFormat::float_64, "double"},
    DepthFormatEntry{DepthFormat::integer_16, "16 bits"},
    DepthFormatEntry{DepthFormat::integer_24, "24 bits"},
    DepthFormatEntry{DepthFormat::integer_32, "32 bits"},
};

}  // namespace

std::span<const DepthFormatEntry> depth_formats() { return kDepthFormats; }

Picture draw_with_plain_z_buffer(const DisplayFile& display_file, const RasterRequest& request,
                                 DepthFormat format) {
  switch (format) {
    case DepthFormat::float_32: return draw<FloatingDepth<float>>(display_file, request);
    case DepthFormat::float_64: break;
    case DepthFormat::integer_16: return draw<IntegerDepth<16>>(display_file, request);
    case DepthFormat::integer_24: return draw<IntegerDepth<24>>(display_file, request);
    case DepthFormat::integer_32: return draw<IntegerDepth<32>>(display_file, request);
  }
  return draw<FloatingDepth<double>>(display_file, request);
}

}  // namespace displayfile
