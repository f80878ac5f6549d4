#include "interp/opengl/osmesa_context.h"

#include <fmt/format.h>

#include <array>

#include "clip/base/error.h"

namespace displayfile {

namespace {

void require_osmesa() {
  try {
    gl();
  } catch (const Error& error) {
    throw Error(
        fmt::format("this system has no OSMesa: {} (Mesa 25.1 and later have none); draw "
                    "with the software device",
                    error.what()));
  }
}

}  // namespace

OsmesaContext::OsmesaContext() {
  const std::array attributes = {OSMESA_FORMAT,
                                 OSMESA_RGBA,
                                 OSMESA_DEPTH_BITS,
                                 0,
                                 OSMESA_STENCIL_BITS,
                                 0,
                                 OSMESA_ACCUM_BITS,
                                 0,
                                 OSMESA_PROFILE,
                                 OSMESA_COMPAT_PROFILE,
                                 0,
                                 0};
  require_osmesa();
  context_ = gl().CreateContextAttribs(attributes.data(), nullptr);
  if (context_ == nullptr) throw Error("OSMesa: no OpenGL context could be made");
}

OsmesaContext::Current::Current(OsmesaContext& context) {
  if (gl().MakeCurrent(context.context_, &context.own_pixel_, GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
    throw Error("OSMesa: the OpenGL context could not be made current");
  }
}

void require_no_gl_error(const char* doing) {
  const GLenum error = gl().GetError();
  if (error == GL_NO_ERROR) return;
  while (gl().GetError() != GL_NO_ERROR) {
  }
  throw Error(error == GL_OUT_OF_MEMORY
                  ? fmt::format("OSMesa ran out of memory while {}", doing)
                  : fmt::format("OSMesa reports OpenGL error 0x{:04X} while {}", error, doing));
}

int bind_framebuffer(int width, int height, int depth_bits, bool stencil) {
  const bool only_depth = depth_bits == 16 && !stencil;
  const GLenum format = only_depth         ? GL_DEPTH_COMPONENT16
                        : depth_bits == 32 ? GL_DEPTH32F_STENCIL8
                                           : GL_DEPTH24_STENCIL8;
  std::array<GLuint, 2> buffer{};
  GLuint framebuffer = 0;
  gl().GenFramebuffers(1, &framebuffer);
  gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl().GenRenderbuffers(2, buffer.data());
  gl().BindRenderbuffer(GL_RENDERBUFFER, buffer[0]);
  gl().RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer[0]);
  gl().BindRenderbuffer(GL_RENDERBUFFER, buffer[1]);
  gl().RenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  gl().FramebufferRenderbuffer(GL_FRAMEBUFFER,
                               only_depth ? GL_DEPTH_ATTACHMENT : GL_DEPTH_STENCIL_ATTACHMENT,
                               GL_RENDERBUFFER, buffer[1]);
  require_no_gl_error("making the frame buffer");
  if (gl().CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(
        fmt::format("OSMesa cannot draw into a frame buffer of {}x{} pixels with {} depth "
                    "bits",
                    width, height, depth_bits));
  }
  GLint granted = 0;
  gl().GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &granted);
  return granted;
}

}  // namespace displayfile
