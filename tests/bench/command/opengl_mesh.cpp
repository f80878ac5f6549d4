#include "tests/bench/command/opengl_mesh.h"

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "interp/opengl/osmesa_context.h"
#include "tests/bench/command/side_by_side.h"

namespace displayfile::bench {

class OpenGlMesh::Drawing {
 public:
  using Vertex = IndexedTriangles::Vertex;

  Drawing(const IndexedTriangles& triangles, const Options& options)
      : triangles_(triangles), options_(options) {
    const OsmesaContext::Current current(context_);
    bind_framebuffer(options.size.width, options.size.height, options.depth_bits, false);
    set_state();
    gl().GenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    gl().BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    gl().BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    gl().BufferData(GL_ELEMENT_ARRAY_BUFFER,
                    static_cast<GLsizeiptr>(triangles_.indices.size() * sizeof(std::uint32_t)),
                    triangles_.indices.data(), GL_STATIC_DRAW);
    gl().EnableClientState(GL_VERTEX_ARRAY);
    gl().EnableClientState(GL_COLOR_ARRAY);
    point_to_vertices();
    require_no_gl_error("making room for the triangles");
  }

  void set_matrix(const glm::dmat4& matrix) {
    const OsmesaContext::Current current(context_);
    gl().LoadMatrixd(glm::value_ptr(matrix));
  }

  void draw_with_new_vertices() {
    const OsmesaContext::Current current(context_);
    hand_over(GL_STREAM_DRAW);
    clear();
    draw_elements();
    gl().Finish();
  }

  void make_resident() {
    {
      const OsmesaContext::Current current(context_);
      hand_over(GL_STATIC_DRAW);
      list_ = gl().GenLists(1);
      gl().NewList(list_, GL_COMPILE);
      draw_elements();
      gl().EndList();
      require_no_gl_error("compiling a display list");
    }
    const auto draw_from = [this](bool list) {
      return [this, list] {
        from_list_ = list;
        draw();
      };
    };
    constexpr int kRounds = 3;
    from_list_ = times_faster(kRounds, draw_from(true), draw_from(false)).median > 1.0;
  }
  bool from_list() const { return from_list_; }

  void draw() {
    const OsmesaContext::Current current(context_);
    clear();
    if (from_list_) {
      gl().CallList(list_);
    } else {
      draw_elements();
    }
    gl().Finish();
  }

  Picture picture() {
    const OsmesaContext::Current current(context_);
    Picture picture;
    picture.width = options_.size.width;
    picture.height = options_.size.height;
    picture.pixels.resize(static_cast<std::size_t>(picture.width) *
                          static_cast<std::size_t>(picture.height));
    gl().ReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE,
                    picture.pixels.data());
    require_no_gl_error("reading the picture back");
    return picture;
  }

 private:
  void set_state() const {
    gl().Viewport(0, 0, options_.size.width, options_.size.height);
    gl().ShadeModel(GL_FLAT);
    gl().Enable(GL_DEPTH_TEST);
    gl().Enable(GL_DEPTH_CLAMP);
    gl().DepthFunc(GL_GEQUAL);
    gl().ClearDepth(0.0);
    gl().Disable(GL_DITHER);
    gl().Disable(GL_MULTISAMPLE);
    if (options_.back_faces_removed) {
      gl().Enable(GL_CULL_FACE);
      gl().CullFace(GL_BACK);
      gl().FrontFace(GL_CW);  // y runs downward
    }
    const auto part = [&](int shift) {
      return static_cast<float>(options_.background >> shift & 0xFF) / 255.0F;
    };
    gl().ClearColor(part(0), part(8), part(16), part(24));
    gl().PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl().MatrixMode(GL_MODELVIEW);
  }

  void hand_over(GLenum usage) const {
    gl().BufferData(GL_ARRAY_BUFFER,
                    static_cast<GLsizeiptr>(triangles_.vertices.size() * sizeof(Vertex)),
                    triangles_.vertices.data(), usage);
  }

  static const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

  static void point_to_vertices() {
    gl().VertexPointer(3, GL_FLOAT, sizeof(Vertex), offset(0));
    gl().ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), offset(offsetof(Vertex, colour)));
  }

  static void clear() { gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }

  void draw_elements() const {
    gl().DrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles_.indices.size()),
                      GL_UNSIGNED_INT, offset(0));
  }

  const IndexedTriangles& triangles_;
  Options options_;
  OsmesaContext context_;
  std::array<GLuint, 2> buffers_{};
  GLuint list_ = 0;
  bool from_list_ = false;
};

OpenGlMesh::OpenGlMesh(const IndexedTriangles& triangles, const Options& options)
    : drawing_(std::make_unique<Drawing>(triangles, options)) {}
OpenGlMesh::~OpenGlMesh() = default;
void OpenGlMesh::set_matrix(const glm::dmat4& matrix) { drawing_->set_matrix(matrix); }
void OpenGlMesh::draw_with_new_vertices() { drawing_->draw_with_new_vertices(); }
void OpenGlMesh::make_resident() { drawing_->make_resident(); }
std::string_view OpenGlMesh::resident_in() const {
  return drawing_->from_list() ? "display list" : "buffers";
}
void OpenGlMesh::draw() { drawing_->draw(); }
Picture OpenGlMesh::picture() { return drawing_->picture(); }

}  // namespace displayfile::bench
