#include "interp/visibility/plain_z_buffer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "interp/device/interpreter.h"
#include "interp/device/raster_request.h"
#include "interp/scan/sort_stably.h"

namespace displayfile {

namespace {

/// Storage policies: the type of stored depths, and the value for the background.
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
  static constexpr Stored kFarthest = -1;  // a frame buffer's own 0 would hide polygons at 0
  static constexpr double kLargest = static_cast<double>((std::int64_t{1} << kBits) - 1);
  static Stored store(double z) {
    return static_cast<Stored>(std::clamp(z, 0.0, 1.0) * kLargest + 0.5);
  }
  static double z(Stored stored) { return static_cast<double>(stored) / kLargest; }
};

/// The lecture's edge data, section 4: the last row, x and z where the edge crosses the current
/// row, and their changes from row to row.
struct Edge {
  int first_row, last_row;
  double x, z, dx, dz;
};

/// The first row whose centres are above y, clamped to the picture.
int row_above(double y, int height) {
  return static_cast<int>(std::clamp(std::floor(y - 0.5) + 1.0, 0.0, static_cast<double>(height)));
}
int column_from(double x, int width) {
  return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(width)));
}

/// The z-buffer itself: a stored depth and the number of the visible fill for every pixel, top row
/// first.
template <class Depth>
class PlainZBuffer {
 public:
  using Number = ViewedScene::Fill;

  explicit PlainZBuffer(const PictureSize& size)
      : size_(size),
        depth_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
               Depth::kFarthest),
        seen_(depth_.size(), ViewedScene::kBackground) {}

  /// Draws a polygon in display-file coordinates.
  void fill(std::span<const Point3> vertices, Number number) {
    make_edge_table(vertices);
    active_.clear();
    std::size_t next = 0;
    for (int row = edges_.empty() ? 0 : edges_[0].first_row;
         next < edges_.size() || !active_.empty(); ++row) {
      update_active_edges(row, next);
      // The textbook's FILLIN, with a z for each end of the span (chapter 9, "Z buffers").
      for (std::size_t i = 0; i + 1 < active_.size(); i += 2) {
        fill_in(row, active_[i], active_[i + 1], number);
      }
    }
  }

  const std::vector<Number>& seen() const { return seen_; }
  std::span<const Number> row_seen(int row) const {
    return std::span(seen_).subspan(start_of(row), static_cast<std::size_t>(size_.width));
  }

  /// The depths as stored; minus infinity for the background.
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
      const int first = row_above(low.y, size_.height);
      const int last = row_above(high.y, size_.height) - 1;
      if (first <= last) {
        const double dx = (high.x - low.x) / (high.y - low.y);
        const double dz = (high.z - low.z) / (high.y - low.y);
        const double rise = first + 0.5 - low.y;
        edges_.push_back({first, last, low.x + rise * dx, low.z + rise * dz, dx, dz});
      }
      from = to;
    }
    sort_stably(edges_, &Edge::first_row);
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
    sort_stably(active_, &Edge::x);
  }

  /// The lecture's section 3, "along a scan line": z_new = z_old + dz.
  void fill_in(int row, const Edge& left, const Edge& right, Number number) {
    const int first = column_from(left.x, size_.width);
    const int end = column_from(right.x, size_.width);
    if (first >= end) return;
    const double dz = (right.z - left.z) / (right.x - left.x);
    double z = left.z + (first + 0.5 - left.x) * dz;
    const std::size_t start = start_of(row);
    for (std::size_t i = start + static_cast<std::size_t>(first);
         i < start + static_cast<std::size_t>(end); ++i, z += dz) {
      // The textbook: larger is nearer. At equal depth the polygon entered later is visible.
      const typename Depth::Stored stored = Depth::store(z);
      if (stored < depth_[i]) continue;
      depth_[i] = stored;
      seen_[i] = number;
    }
  }

  std::size_t start_of(int row) const {
    return static_cast<std::size_t>(size_.height - 1 - row) * static_cast<std::size_t>(size_.width);
  }
  Point3 to_pixels(const Point3& device) const {
    return {device.x * size_.width, device.y * size_.height, device.z};
  }

  PictureSize size_;
  std::vector<typename Depth::Stored> depth_;
  std::vector<Number> seen_;
  std::vector<Edge> edges_, active_;
};

/// The plain z-buffer as an image-space method.
template <class Depth>
class PlainMethod : public ImageSpaceMethod {
 public:
  void prepare(const Request& request, int) override {
    z_buffer_.emplace(request.size);
    for (Fill fill = ViewedScene::kBackground + 1; fill < request.scene.end(); ++fill) {
      z_buffer_->fill(request.scene.vertices(fill), fill);
    }
  }
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override {
    for (int row = row_begin; row < row_end; ++row) seen(row, 0, z_buffer_->row_seen(row));
  }

 private:
  using Fill = ViewedScene::Fill;
  std::optional<PlainZBuffer<Depth>> z_buffer_;
};

/// The plain z-buffer used separately: numbers the fills from the interpreter.
template <class Depth>
class PlainPicture : public OutputDevice {
 public:
  PlainPicture(const PictureSize& size, const Background& background)
      : z_buffer_(size), colours_{pixel_of(background)} {}

  void fill(const DrawnPolygon& polygon) override {
    colours_.push_back(pixel_of(even_fill(polygon).colour));
    picks_.push_back(polygon.pick);
    z_buffer_.fill(polygon.vertices, static_cast<ViewedScene::Fill>(colours_.size() - 1));
  }
  void edges(const DrawnPolygon&) override {}
  void line(const DrawnLine&) override {}

  Picture picture(const RasterRequest& request) const {
    Picture picture;
    picture.width = request.width;
    picture.height = request.height;
    picture.pixels = of_seen(colours_);
    if (request.ids) picture.ids = of_seen(picks_);
    if (request.depth) picture.depth = z_buffer_.depths();
    return picture;
  }

 private:
  /// Maps the visible numbers to their values.
  template <class T>
  std::vector<T> of_seen(const std::vector<T>& by_number) const {
    std::vector<T> values(z_buffer_.seen().size());
    std::ranges::transform(z_buffer_.seen(), values.begin(),
                           [&](auto number) { return by_number[number]; });
    return values;
  }

  PlainZBuffer<Depth> z_buffer_;
  std::vector<std::uint32_t> colours_;  // by number, the background's first
  std::vector<std::int32_t> picks_{-1};
};

/// Calls work(policy) with the format's policy.
template <class Work>
auto with_depth(DepthFormat format, Work&& work) {
  switch (format) {
    case DepthFormat::float_32: return work(FloatingDepth<float>{});
    case DepthFormat::float_64: break;
    case DepthFormat::integer_16: return work(IntegerDepth<16>{});
    case DepthFormat::integer_24: return work(IntegerDepth<24>{});
    case DepthFormat::integer_32: return work(IntegerDepth<32>{});
  }
  return work(FloatingDepth<double>{});
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

std::unique_ptr<ImageSpaceMethod> make_plain_z_buffer(DepthFormat format) {
  return with_depth(format, [](auto depth) -> std::unique_ptr<ImageSpaceMethod> {
    return std::make_unique<PlainMethod<decltype(depth)>>();
  });
}

Picture draw_with_plain_z_buffer(const DisplayFile& display_file, const RasterRequest& request,
                                 DepthFormat format) {
  require_picture_size(request.width, request.height);
  return with_depth(format, [&](auto depth) {
    PlainPicture<decltype(depth)> drawing(PictureSize{request.width, request.height},
                                          request.background);
    interpret(display_file, drawing, Pass::fills, Order::entered);
    return drawing.picture(request);
  });
}

}  // namespace displayfile
