#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"

namespace displayfile {

/// OSMesa: OpenGL drawn in memory by Mesa's software renderer (llvmpipe), as a second opinion
/// on our own scan conversion and as a peer in benchmarks. It left Mesa in version 25.1; in a
/// build without its headers, and on a system without its library, osmesa_available() is false and
/// the rest throws Error. The library is loaded at the first call (interp/opengl/opengl.h).
///
/// It draws a TriangleList (interp/opengl/triangle_list.h), in flat colours, without antialiasing,
/// dithering or blending. The renderer rounds vertices to 1/256 pixel, so no edge moves by more
/// than that. Depth, larger nearer, spans the range of z in the picture; of equal depths the one
/// entered later is visible.
///
/// llvmpipe's number of threads comes from the environment variable LP_NUM_THREADS, which it
/// reads once, when the process makes its first OpenGL context (0: everything in the calling
/// thread; n: n more that draw). RasterRequest::threads has no effect here.
bool osmesa_available();

/// Renderer, Mesa version, depth bits granted for this request (16, 24 or 32), and the largest
/// picture: for reports. Without OSMesa it states that there is none.
std::string osmesa_description(int depth_bits = 24);

/// Draws the display file, on the background. Throws Error for a size outside of 1 to the
/// renderer's limit (16384 pixels for llvmpipe), for depth bits other than 16, 24 and 32, for a
/// coordinate that triangle_list refuses, and when memory runs out.
Picture draw_with_osmesa(const DisplayFile& display_file, const RasterRequest& request,
                         int depth_bits = 24);

/// Draws as draw_with_osmesa does, but in steps, so that drawing is timed alone: the triangles of a
/// display file, resident in vertex buffers, to be drawn any number of times. To be used by one
/// thread at a time; no OSMesa context is current after a call.
class OsmesaBuffers {
 public:
  /// Throws as draw_with_osmesa does.
  OsmesaBuffers(const DisplayFile& display_file, const RasterRequest& request, int depth_bits = 24);
  ~OsmesaBuffers();
  OsmesaBuffers(const OsmesaBuffers&) = delete;
  OsmesaBuffers& operator=(const OsmesaBuffers&) = delete;

  /// Clears, draws and waits until all is drawn (glFinish); nothing is read back.
  void draw();
  /// Draws and reads back the requested data. The item buffer and the depth are drawn separately,
  /// with the fills only.
  Picture picture();

  std::size_t triangles() const;  ///< that draw() draws
  int depth_bits() const;         ///< granted: 16 becomes 24 where a polygon is not convex

 private:
  class Drawing;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace displayfile
