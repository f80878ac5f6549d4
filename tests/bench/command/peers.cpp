#include "tests/bench/command/peers.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "clip/base/error.h"
#include "interp/device/raster_request.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/fill_paints.h"
#include "interp/raster/raster_band.h"
#include "interp/raster/software.h"
#include "interp/scan/pixel_depth.h"
#include "tests/bench/command/embree_rays.h"
#include "tests/bench/command/gl2ps_sort.h"
#include "tests/bench/command/indexed_triangles.h"
#include "tests/bench/command/opengl_mesh.h"

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

/// The display file's triangles by OpenGL: anew, the vertices are passed and drawn in an existing
/// context; again, they are resident. The judged picture is our own OSMesa device's, which also
/// draws scenes with lines, from its buffers.
class OsmesaDrawing : public Drawing {
 public:
  OsmesaDrawing(const DisplayFile& file, const Frame& frame, int depth_bits)
      : file_(file), frame_(frame), depth_bits_(depth_bits) {
    const ViewedScene scene(file);
    if (scene.has_lines() || scene.end() == 1) {
      device_ = std::make_unique<OsmesaBuffers>(file, request(), depth_bits);
      return;
    }
    triangles_ = indexed_triangles(scene);
    mesh_ = std::make_unique<OpenGlMesh>(
        triangles_, OpenGlMesh::Options{size_of(frame), depth_bits, false, pixel_of(Background{})});
    mesh_->set_matrix(glm::dmat4(1.0));
  }
  void draw_anew() override {
    resident_ = false;
    device_ ? device_->draw() : mesh_->draw_with_new_vertices();
  }
  void draw_again() override {
    if (device_) return device_->draw();
    if (!resident_) mesh_->make_resident();
    resident_ = true;
    mesh_->draw();
  }
  Picture judged() override {
    RasterRequest judged = request();
    judged.ids = judged.depth = true;
    return OsmesaBuffers(file_, judged, depth_bits_).picture();
  }

 private:
  RasterRequest request() const {
    RasterRequest request;
    request.width = frame_.width;
    request.height = frame_.height;
    request.surfaces.method = HiddenMethod::z_buffer;
    return request;
  }

  const DisplayFile& file_;
  Frame frame_;
  int depth_bits_;
  IndexedTriangles triangles_;
  std::unique_ptr<OpenGlMesh> mesh_;
  std::unique_ptr<OsmesaBuffers> device_;
  bool resident_ = false;
};

/// A ray for each pixel, on one thread: anew, the tree is built and the rays are cast; again, they
/// are cast. The triangles are already in Embree's form.
class EmbreeDrawing : public Drawing {
 public:
  EmbreeDrawing(const DisplayFile& file, const Frame& frame)
      : size_(size_of(frame)),
        scene_(file),
        paints_(scene_),
        input_(in_triangles(scene_), size_),
        hits_(size_, false) {}
  void draw_anew() override {
    rays_.reset();
    rays_ = std::make_unique<EmbreeRays>(input_, 1);
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
  PictureSize size_;
  ViewedScene scene_;
  FillPaints paints_;
  EmbreeRays::Input input_;
  std::unique_ptr<EmbreeRays> rays_;
  EmbreeRays::Hits hits_;
  Picture picture_;
};

/// The sort alone, passing the triangles included; it makes no pixels. The judged picture is its
/// pieces, painted in its order.
class Gl2psDrawing : public Drawing {
 public:
  Gl2psDrawing(const DisplayFile& file, const Frame& frame, const Gl2psSort::Options& options)
      : size_(size_of(frame)),
        options_(options),
        scene_(file),
        paints_(scene_),
        triangles_(in_triangles(scene_)) {}
  void draw_anew() override {
    if (!tried_ && !gl2ps().ends()) throw CannotDraw{"gl2ps's sort does not come to an end"};
    tried_ = true;
    gl2ps().sort();
  }
  Picture judged() override {
    const auto pieces = pieces_or_reason();
    count_ = pieces.size();
    RasterRequest request;
    request.width = size_.width;
    request.height = size_.height;
    request.ids = true;
    return with_ids_and_depth(draw_with_software(painted(pieces), request));
  }
  std::optional<Pieces> pieces() const override { return Pieces{triangles_.size(), count_}; }

 private:
  Gl2psSort gl2ps() const { return {triangles_.corners, size_, options_}; }
  std::vector<Gl2psSort::Piece> pieces_or_reason() const {
    try {
      return gl2ps().pieces();
    } catch (const Error& reason) {
      throw CannotDraw{reason.what()};
    }
  }
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

  PictureSize size_;
  Gl2psSort::Options options_;
  ViewedScene scene_;
  FillPaints paints_;
  Triangles triangles_;
  std::uint64_t count_ = 0;
  bool tried_ = false;
};

template <class Peer>
Contender peer(std::string method, std::string precision, auto... options) {
  return {std::move(method),
          std::move(precision),
          false,
          false,
          false,
          [=](const DisplayFile& file, const Frame& frame) {
            return std::make_unique<Peer>(file, frame, options...);
          }};
}

}  // namespace

std::vector<Contender> peers() {
  std::vector<Contender> all;
  if (osmesa_available()) {
    for (const int bits : {32, 24, 16}) {
      all.push_back(peer<OsmesaDrawing>("osmesa", fmt::format("{} bits", bits), bits));
    }
  }
  if (EmbreeRays::version()) all.push_back(peer<EmbreeDrawing>("embree", "single"));
  if (Gl2psSort::version()) {
    for (const Gl2psSort::Options& options : Gl2psSort::kOptions) {
      all.push_back(peer<Gl2psDrawing>("gl2ps", fmt::format("bsp{}", options.name), options));
    }
  }
  return all;
}

}  // namespace displayfile::bench
