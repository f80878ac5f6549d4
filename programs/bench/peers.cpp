#include "programs/bench/peers.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "interp/raster/fill_paints.h"
#include "interp/raster/raster_band.h"
#include "interp/raster/software.h"
#include "interp/scan/pixel_depth.h"
#include "programs/bench/embree_rays.h"
#include "programs/bench/gl2ps_sort.h"

namespace displayfile::bench {

namespace {

using Fill = ViewedScene::Fill;

PictureSize size_of(const Frame& frame) { return {frame.width, frame.height}; }

/// Rows from the top, as a picture's, of rows from the bottom.
template <class From, class To>
void turn_over(const std::vector<From>& rows, int width, std::vector<To>& picture,
               const auto& pixel) {
  picture.resize(rows.size());
  const auto row = static_cast<std::ptrdiff_t>(width);
  auto to = picture.end();
  for (auto from = rows.begin(); from != rows.end(); from += row) {
    to -= row;
    std::transform(from, from + row, to, pixel);
  }
}

/// A ray for each pixel, on one thread. The committed scene is what is kept.
class EmbreeDrawing : public Drawing {
 public:
  EmbreeDrawing(const DisplayFile& file, const Frame& frame)
      : file_(file), size_(size_of(frame)), hits_(size_, false) {}
  void draw_anew() override {
    scene_ = ViewedScene(file_);
    paints_ = FillPaints(scene_);
    rays_.reset();
    rays_ = std::make_unique<EmbreeRays>(in_triangles(scene_), size_, 1);
    draw_again();
  }
  void draw_again() override {
    rays_->cast(0, size_.height, hits_);
    picture_.width = size_.width;
    picture_.height = size_.height;
    turn_over(hits_.fills, size_.width, picture_.pixels,
              [&](Fill fill) { return paints_.pixel(fill); });
  }
  Picture judged() override {
    EmbreeRays::Hits hits(size_, true);
    rays_->cast(0, size_.height, hits);
    Picture picture = picture_;
    turn_over(hits.fills, size_.width, picture.ids, [&](Fill fill) { return scene_.pick(fill); });
    turn_over(hits.depths, size_.width, picture.depth, std::identity());
    return picture;
  }

 private:
  const DisplayFile& file_;
  PictureSize size_;
  ViewedScene scene_;
  FillPaints paints_;
  std::unique_ptr<EmbreeRays> rays_;
  EmbreeRays::Hits hits_;
  Picture picture_;
};

/// The sort alone; it makes no pixels. What is judged is the pieces that it writes, painted in its
/// order.
class Gl2psDrawing : public Drawing {
 public:
  Gl2psDrawing(const DisplayFile& file, const Frame& frame) : file_(file), size_(size_of(frame)) {}
  void draw_anew() override {
    scene_ = ViewedScene(file_);
    paints_ = FillPaints(scene_);
    triangles_ = in_triangles(scene_);
    const Gl2psSort gl2ps{triangles_.corners, size_};
    if (!tried_ && !gl2ps.ends()) throw CannotDraw{"gl2ps's sort does not come to an end"};
    tried_ = true;
    gl2ps.sort();
  }
  Picture judged() override {
    const auto pieces = Gl2psSort{triangles_.corners, size_}.pieces();
    count_ = pieces.size();
    RasterRequest request;
    request.width = size_.width;
    request.height = size_.height;
    request.ids = true;
    return with_ids_and_depth(draw_with_software(painted(pieces), request));
  }
  std::optional<std::uint64_t> pieces() const override { return count_; }

 private:
  /// The fills' numbers in place of their items.
  DisplayFile painted(const std::vector<Gl2psSort::Piece>& pieces) const {
    DisplayFile file;
    Segment& segment = file.create(1);
    segment.set_style(LineStyle{LineStyle::Kind::none});
    segment.set_style(FillStyle{FillStyle::Kind::solid});
    for (const Gl2psSort::Piece& piece : pieces) {
      std::vector<Point3> corners;
      for (const Point2& p : piece.corners) corners.emplace_back(p, 0.0);
      segment.set_pick(static_cast<std::int32_t>(triangles_.fills[piece.triangle]));
      segment.enter_polygon(corners, std::vector<std::uint8_t>(corners.size(), 1));
    }
    return file;
  }
  /// Depths are those of the fills' planes.
  Picture with_ids_and_depth(Picture picture) const {
    picture.depth.assign(picture.ids.size(), -std::numeric_limits<double>::infinity());
    for (std::size_t at = 0; at < picture.ids.size(); ++at) {
      if (picture.ids[at] < 0) continue;
      const auto fill = static_cast<Fill>(picture.ids[at]);
      const auto place = static_cast<int>(at);
      const int row = size_.height - 1 - place / size_.width, column = place % size_.width;
      const PixelDepth depth(scene_.plane(fill), size_.width, size_.height);
      picture.depth[at] = depth.at(depth.row(row), column);
      picture.ids[at] = scene_.pick(fill);
      picture.pixels[at] = paints_.pixel(fill);
    }
    return picture;
  }

  const DisplayFile& file_;
  PictureSize size_;
  ViewedScene scene_;
  FillPaints paints_;
  Triangles triangles_;
  std::optional<std::uint64_t> count_;
  bool tried_ = false;
};

template <class Peer>
Contender peer(std::string method, std::string precision) {
  return {std::move(method),
          std::move(precision),
          false,
          false,
          false,
          [](const DisplayFile& file, const Frame& frame) {
            return std::make_unique<Peer>(file, frame);
          }};
}

}  // namespace

std::vector<Contender> peers() {
  std::vector<Contender> all;
  if (EmbreeRays::version()) all.push_back(peer<EmbreeDrawing>("embree", "single"));
  if (Gl2psSort::version()) all.push_back(peer<Gl2psDrawing>("gl2ps", "bsp"));
  return all;
}

}  // namespace displayfile::bench
