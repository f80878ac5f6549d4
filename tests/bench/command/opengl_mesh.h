#pragma once

#include <glm/mat4x4.hpp>
#include <memory>
#include <string_view>

#include "hidden/exact/pixel_centre.h"
#include "interp/device/picture.h"
#include "tests/bench/command/indexed_triangles.h"

namespace displayfile::bench {

/// Triangles drawn by OSMesa as an OpenGL application draws them: a context that is made once,
/// vertices shared and indexed, flat colours, a depth buffer, and nothing read back. For one
/// thread at a time. Every call throws Error where this build or system has no OSMesa.
class OpenGlMesh {
 public:
  struct Options {
    PictureSize size;
    int depth_bits = 24;
    bool back_faces_removed = false;  ///< of triangles that turn counterclockwise if seen
    std::uint32_t background = 0;     ///< as a pixel
  };
  /// Makes a context, and a frame buffer in it; the triangles must live on.
  OpenGlMesh(const IndexedTriangles& triangles, const Options& options);
  ~OpenGlMesh();
  OpenGlMesh(const OpenGlMesh&) = delete;
  OpenGlMesh& operator=(const OpenGlMesh&) = delete;

  /// From the vertices' coordinates to OpenGL's clip coordinates except that y runs downward, so
  /// that the picture's top row comes first; z larger where it is nearer.
  void set_matrix(const glm::dmat4& matrix);

  /// Hands the vertices over anew, clears, draws and waits until all is drawn (glFinish).
  void draw_with_new_vertices();
  /// Keeps the triangles in vertex and index buffers and in a display list, draws from both, and
  /// draws from the faster one from now on.
  void make_resident();
  /// "buffers" or "display list".
  std::string_view resident_in() const;
  /// Clears, draws the resident triangles and waits until they are drawn.
  void draw();
  /// The colours drawn last.
  Picture picture();

 private:
  class Drawing;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace displayfile::bench
