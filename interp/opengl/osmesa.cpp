#include "interp/opengl/osmesa.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <span>
#include <vector>

#include "clip/base/error.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"
#include "interp/opengl/opengl.h"
#include "interp/opengl/osmesa_context.h"
#include "interp/opengl/triangle_list.h"
#include "interp/text/seen_texts.h"
#include "interp/text/text_painter.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

namespace {

GLint integer(GLenum name) {
  GLint value = 0;
  gl().GetIntegerv(name, &value);
  return value;
}

std::string renderer() { return reinterpret_cast<const char*>(gl().GetString(GL_RENDERER)); }

int largest_side() {
  std::array<GLint, 2> viewport{};
  gl().GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  return std::min({viewport[0], viewport[1], integer(GL_MAX_RENDERBUFFER_SIZE)});
}

/// Display-file z to OpenGL depth in [0,1]: the range that occurs, and a little room at both
/// ends so that 0 is left for the background.
struct DepthMapping {
  double low = 0.0, high = 1.0;

  DepthMapping(const TriangleList& a, const TriangleList& b) {
    const double z_min = std::min(a.z_min, b.z_min), z_max = std::max(a.z_max, b.z_max);
    if (z_min > z_max) return;
    // A flat scene has no range of its own; and no range is smaller than the spacing of doubles
    // near it.
    const double size = std::max({std::abs(z_min), std::abs(z_max), 1e-300});
    const double range = std::max(z_max - z_min, size * 1e-12);
    constexpr double kRoom = 1.0 / 1024;
    low = z_min - kRoom * range;
    high = z_max + kRoom * range;
  }
  double depth(double z) const { return (z - low) / (high - low); }
  double z(double depth) const { return low + depth * (high - low); }
};

/// A vertex as it lies in a vertex buffer: x, y and z in OpenGL's normalised coordinates.
struct ResidentVertex {
  float x, y, z;
  std::uint32_t colour;
  std::int32_t id;
};

enum class Paint { colours, ids };

/// A triangle list in a vertex buffer.
class ResidentTriangles {
 public:
  void upload(const TriangleList& list, const DepthMapping& mapping) {
    batches_ = list.batches;
    shaded_ = list.shaded;
    triangles_ = list.vertices.size() / 3;
    if (triangles_ == 0) return;
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<GLsizei>::max());
    if (list.vertices.size() > kMost) {
      throw Error(fmt::format("{} triangles: OSMesa draws at most {}", triangles_, kMost / 3));
    }
    gl().GenBuffers(1, &buffer_);
    gl().BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl().BufferData(GL_ARRAY_BUFFER,
                    static_cast<GLsizeiptr>(list.vertices.size() * sizeof(ResidentVertex)), nullptr,
                    GL_STATIC_DRAW);
    require_no_gl_error("making room for the triangles");
    auto* out = static_cast<ResidentVertex*>(gl().MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY));
    if (out == nullptr) throw Error("OSMesa ran out of memory while entering the triangles");
    for (const TriangleVertex& v : list.vertices) {
      *out++ = {v.x, v.y, static_cast<float>(2.0 * mapping.depth(v.z) - 1.0), v.colour, v.id};
    }
    gl().UnmapBuffer(GL_ARRAY_BUFFER);
    require_no_gl_error("entering the triangles");
  }

  void draw(Paint paint, GLenum depth_test) const {
    if (triangles_ == 0) return;
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    gl().BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl().EnableClientState(GL_VERTEX_ARRAY);
    gl().EnableClientState(GL_COLOR_ARRAY);
    gl().VertexPointer(3, GL_FLOAT, sizeof(ResidentVertex), offset(0));
    gl().ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(ResidentVertex),
                      offset(paint == Paint::ids ? offsetof(ResidentVertex, id)
                                                 : offsetof(ResidentVertex, colour)));
    gl().ShadeModel(shaded_ && paint == Paint::colours ? GL_SMOOTH : GL_FLAT);
    gl().DepthFunc(depth_test);
    for (const TriangleBatch& batch : batches_) {
      if (batch.rule == TriangleBatch::Rule::even_odd) {
        draw_even_odd(batch, depth_test);
      } else {
        draw_arrays(batch);
      }
    }
  }

  std::size_t triangles() const { return triangles_; }

 private:
  static void draw_arrays(const TriangleBatch& batch) {
    gl().DrawArrays(GL_TRIANGLES, static_cast<GLint>(batch.first),
                    static_cast<GLsizei>(batch.count));
  }

  /// Each triangle of the fan inverts the stencil, which is then odd inside of the polygon; the
  /// fan once more paints there, and leaves the stencil clear for the next.
  static void draw_even_odd(const TriangleBatch& batch, GLenum depth_test) {
    gl().Enable(GL_STENCIL_TEST);
    gl().StencilFunc(GL_ALWAYS, 0, 0xFF);
    gl().StencilOp(GL_INVERT, GL_INVERT, GL_INVERT);
    gl().ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl().DepthMask(GL_FALSE);
    gl().DepthFunc(GL_ALWAYS);
    draw_arrays(batch);
    gl().ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl().DepthMask(GL_TRUE);
    gl().DepthFunc(depth_test);
    gl().StencilFunc(GL_NOTEQUAL, 0, 0xFF);
    gl().StencilOp(GL_ZERO, GL_ZERO, GL_ZERO);
    draw_arrays(batch);
    gl().Disable(GL_STENCIL_TEST);
  }

  GLuint buffer_ = 0;
  std::size_t triangles_ = 0;
  bool shaded_ = false;
  std::vector<TriangleBatch> batches_;
};

bool has_even_odd(const TriangleList& list) {
  return std::ranges::any_of(list.batches, [](const TriangleBatch& batch) {
    return batch.rule == TriangleBatch::Rule::even_odd;
  });
}

/// Reports a lack of memory as an Error.
template <class Work>
auto within_memory(const RasterRequest& request, Work&& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Error(fmt::format("not enough memory to draw {}x{} pixels with OSMesa", request.width,
                            request.height));
  }
}

}  // namespace

/// A scene in its context. With the z-buffer the fills are drawn before the lines; without it all
/// are drawn in order, and the fills are kept separately only if they are to be measured.
class OsmesaBuffers::Drawing {
 public:
  Drawing(const DisplayFile& display_file, const RasterRequest& request, int depth_bits)
      : request_(request), mapping_({}, {}) {
    require_picture_size(request.width, request.height);
    if (depth_bits != 16 && depth_bits != 24 && depth_bits != 32) {
      throw Error(fmt::format("{} depth bits: expected 16, 24 or 32", depth_bits));
    }
    const OsmesaContext::Current current(context_);
    if (std::max(request.width, request.height) > largest_side()) {
      throw Error(fmt::format("picture size {}x{}: OSMesa ({}) draws at most {}x{} pixels",
                              request.width, request.height, renderer(), largest_side(),
                              largest_side()));
    }
    const Order order = is_image_space(request.surfaces.method) ? Order::entered : Order::drawn;
    const auto list = [&](Pass pass) {
      return triangle_list(display_file, pass, order, request.width, request.height,
                           request.line_scale);
    };
    TriangleList fills, others;
    if (is_image_space(request.surfaces.method) || request.ids || request.depth)
      fills = list(Pass::fills);
    others = list(is_image_space(request.surfaces.method) ? Pass::lines : Pass::everything);
    mapping_ = DepthMapping(fills, others);
    depth_bits_ = bind_framebuffer(request.width, request.height, depth_bits,
                                   has_even_odd(fills) || has_even_odd(others));
    fills_.upload(fills, mapping_);
    others_.upload(others, mapping_);
    set_state();
  }

  void draw() {
    const OsmesaContext::Current current(context_);
    draw_colours();
    gl().Finish();
  }

  Picture picture() {
    const OsmesaContext::Current current(context_);
    Picture picture;
    picture.width = request_.width;
    picture.height = request_.height;
    if (request_.ids || request_.depth) measure(picture);
    draw_colours();
    read(picture, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels);
    require_no_gl_error("drawing");
    return picture;
  }

  std::size_t triangles() const {
    return others_.triangles() +
           (is_image_space(request_.surfaces.method) ? fills_.triangles() : 0);
  }
  int depth_bits() const { return depth_bits_; }
  const RasterRequest& request() const { return request_; }

 private:
  void set_state() const {
    gl().Viewport(0, 0, request_.width, request_.height);
    gl().Enable(GL_DEPTH_TEST);
    gl().Enable(GL_DEPTH_CLAMP);  // line offsets may exceed the room at the front
    gl().Disable(GL_DITHER);
    gl().Disable(GL_BLEND);
    gl().Disable(GL_CULL_FACE);
    gl().Disable(GL_MULTISAMPLE);
    // A line on a polygon has the polygon's depth up to the renderer's rounding, which grows with
    // the slope: moved toward the viewer by that much, it wins at equal depth. The fills are not
    // moved, so their order does not change.
    gl().PolygonOffset(1.0f / 64, 8.0f);
    gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl().ClearDepth(0.0);
    gl().ClearStencil(0);
  }

  /// Clears to a pixel's bytes, R, G, B, A.
  static void clear(std::uint32_t pixel) {
    const auto part = [&](int shift) { return static_cast<float>(pixel >> shift & 0xFF) / 255.0f; };
    gl().ClearColor(part(0), part(8), part(16), part(24));
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }

  void draw_colours() const {
    clear(pixel_of(request_.background));
    if (!is_image_space(request_.surfaces.method)) return others_.draw(Paint::colours, GL_ALWAYS);
    fills_.draw(Paint::colours, GL_GEQUAL);
    gl().Enable(GL_POLYGON_OFFSET_FILL);
    others_.draw(Paint::colours, GL_GEQUAL);
    gl().Disable(GL_POLYGON_OFFSET_FILL);
  }

  /// The 32 bits of a pixel are the pick identifier itself; all ones, white, is the background's
  /// -1.
  void measure(Picture& picture) const {
    clear(0xFFFFFFFF);
    fills_.draw(Paint::ids, is_image_space(request_.surfaces.method) ? GL_GEQUAL : GL_ALWAYS);
    if (request_.ids) read(picture, GL_RGBA, GL_UNSIGNED_BYTE, picture.ids);
    if (!request_.depth) return;
    std::vector<float> depth;
    read(picture, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    picture.depth.resize(depth.size());
    std::ranges::transform(depth, picture.depth.begin(), [&](float d) {
      return d == 0.0f ? -std::numeric_limits<double>::infinity() : mapping_.z(d);
    });
  }

  template <class T>
  static void read(const Picture& picture, GLenum format, GLenum type, std::vector<T>& into) {
    into.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    gl().ReadPixels(0, 0, picture.width, picture.height, format, type, into.data());
    require_no_gl_error("reading the picture back");
  }

  RasterRequest request_;
  OsmesaContext context_;
  DepthMapping mapping_;
  int depth_bits_ = 0;
  ResidentTriangles fills_, others_;
};

bool osmesa_available() {
  try {
    gl();
    return true;
  } catch (const Error&) {
    return false;
  }
}

std::string osmesa_description(int depth_bits) {
  if (!osmesa_available()) return "none: this system has no OSMesa";
  OsmesaContext context;
  const OsmesaContext::Current current(context);
  const int granted = bind_framebuffer(1, 1, depth_bits, false);
  return fmt::format("{}, {}, {} depth bits, at most {}x{} pixels", renderer(),
                     reinterpret_cast<const char*>(gl().GetString(GL_VERSION)), granted,
                     largest_side(), largest_side());
}

Picture draw_with_osmesa(const DisplayFile& display_file, const RasterRequest& request,
                         int depth_bits) {
  Picture picture = OsmesaBuffers(display_file, request, depth_bits).picture();
  if (request.texts) {
    paint_texts(seen_texts(display_file, is_image_space(request.surfaces.method)),
                {request.lettering, request.line_scale}, {request.width, request.height}, 0,
                request.height, picture);
    paint_annotation(annotation_marks(display_file, annotation_page(request)), request.background,
                     {request.lettering, request.line_scale}, {request.width, request.height}, 0,
                     request.height, picture);
  }
  return picture;
}

OsmesaBuffers::OsmesaBuffers(const DisplayFile& display_file, const RasterRequest& request,
                             int depth_bits)
    : drawing_(within_memory(
          request, [&] { return std::make_unique<Drawing>(display_file, request, depth_bits); })) {}
OsmesaBuffers::~OsmesaBuffers() = default;
void OsmesaBuffers::draw() { drawing_->draw(); }
Picture OsmesaBuffers::picture() {
  return within_memory(drawing_->request(), [&] { return drawing_->picture(); });
}
std::size_t OsmesaBuffers::triangles() const { return drawing_->triangles(); }
int OsmesaBuffers::depth_bits() const { return drawing_->depth_bits(); }

}  // namespace displayfile
