#pragma once

#include <cstdint>

#include "interp/opengl/opengl.h"

namespace displayfile {

/// An OpenGL context of OSMesa, current during the lifetime of a Current. It draws into a
/// framebuffer object: unlike OSMesa's own buffers that has the requested depth of 16, 24 or 32
/// bits, and is not copied for each finished picture. All objects are destroyed with the context.
class OsmesaContext {
 public:
  /// Throws Error if this system has no OSMesa, or if it cannot create a context.
  OsmesaContext();
  ~OsmesaContext() { gl().DestroyContext(context_); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  class Current {
   public:
    /// Throws Error if it could not be made current.
    explicit Current(OsmesaContext& context);
    ~Current() { gl().MakeCurrent(nullptr, nullptr, 0, 0, 0); }
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;
  };

 private:
  OSMesaContext context_ = nullptr;
  std::uint32_t own_pixel_ = 0;  // OSMesa wants a buffer of its own, however small
};

// The functions below act on the context that is current.

/// Creates a framebuffer object and binds it; returns its depth bits. Throws Error if OSMesa cannot
/// draw into it.
int bind_framebuffer(int width, int height, int depth_bits, bool stencil);

/// Throws Error, with `doing`, if OpenGL reports an error.
void require_no_gl_error(const char* doing);

}  // namespace displayfile
