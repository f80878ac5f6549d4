#pragma once

#include <cstdint>

#include "interp/opengl/opengl.h"

namespace displayfile {

/// An OpenGL context of OSMesa, current for as long as a Current lives. What it draws into is
/// a framebuffer object: unlike OSMesa's own buffers that has a depth of 16, 24 or 32 bits as
/// asked for, and is not copied each time a picture is finished. All objects go with the context.
class OsmesaContext {
 public:
  /// Throws Error if this system has no OSMesa, or if it gives none.
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

/// Makes a framebuffer object and binds it; returns the depth bits that it has. Throws Error if
/// OSMesa cannot draw into such a one.
int bind_framebuffer(int width, int height, int depth_bits, bool stencil);

/// Throws Error, with what was being done, if OpenGL has an error to report.
void require_no_gl_error(const char* doing);

}  // namespace displayfile
