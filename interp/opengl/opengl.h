#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <string>

#include "clip/base/error.h"
#include "clip/base/shared_library.h"

namespace displayfile {

/// OSMesa's library and the functions used, loaded on first use: it depends on LLVM, which takes
/// longer to load than most pictures to draw.
class OpenGl {
  SharedLibrary library_{"libOSMesa.so.8"};

 public:
#define DISPLAYFILE_OSMESA(name) DISPLAYFILE_LIBRARY_FUNCTION(library_, OSMesa, name)
  DISPLAYFILE_OSMESA(CreateContextAttribs);
  DISPLAYFILE_OSMESA(DestroyContext);
  DISPLAYFILE_OSMESA(GetProcAddress);
  DISPLAYFILE_OSMESA(MakeCurrent);
#undef DISPLAYFILE_OSMESA

#define DISPLAYFILE_OPENGL(name) \
  decltype(&::gl##name) name = function<decltype(&::gl##name)>("gl" #name)
  DISPLAYFILE_OPENGL(BindBuffer);
  DISPLAYFILE_OPENGL(BindFramebuffer);
  DISPLAYFILE_OPENGL(BindRenderbuffer);
  DISPLAYFILE_OPENGL(BufferData);
  DISPLAYFILE_OPENGL(CallList);
  DISPLAYFILE_OPENGL(CheckFramebufferStatus);
  DISPLAYFILE_OPENGL(Clear);
  DISPLAYFILE_OPENGL(ClearColor);
  DISPLAYFILE_OPENGL(ClearDepth);
  DISPLAYFILE_OPENGL(ClearStencil);
  DISPLAYFILE_OPENGL(ColorMask);
  DISPLAYFILE_OPENGL(ColorPointer);
  DISPLAYFILE_OPENGL(CullFace);
  DISPLAYFILE_OPENGL(DepthFunc);
  DISPLAYFILE_OPENGL(DepthMask);
  DISPLAYFILE_OPENGL(Disable);
  DISPLAYFILE_OPENGL(DrawArrays);
  DISPLAYFILE_OPENGL(DrawElements);
  DISPLAYFILE_OPENGL(Enable);
  DISPLAYFILE_OPENGL(EnableClientState);
  DISPLAYFILE_OPENGL(EndList);
  DISPLAYFILE_OPENGL(Finish);
  DISPLAYFILE_OPENGL(FramebufferRenderbuffer);
  DISPLAYFILE_OPENGL(FrontFace);
  DISPLAYFILE_OPENGL(GenBuffers);
  DISPLAYFILE_OPENGL(GenFramebuffers);
  DISPLAYFILE_OPENGL(GenLists);
  DISPLAYFILE_OPENGL(GenRenderbuffers);
  DISPLAYFILE_OPENGL(GetError);
  DISPLAYFILE_OPENGL(GetIntegerv);
  DISPLAYFILE_OPENGL(GetRenderbufferParameteriv);
  DISPLAYFILE_OPENGL(GetString);
  DISPLAYFILE_OPENGL(LoadMatrixd);
  DISPLAYFILE_OPENGL(MapBuffer);
  DISPLAYFILE_OPENGL(MatrixMode);
  DISPLAYFILE_OPENGL(NewList);
  DISPLAYFILE_OPENGL(PixelStorei);
  DISPLAYFILE_OPENGL(PolygonOffset);
  DISPLAYFILE_OPENGL(ReadPixels);
  DISPLAYFILE_OPENGL(RenderbufferStorage);
  DISPLAYFILE_OPENGL(ShadeModel);
  DISPLAYFILE_OPENGL(StencilFunc);
  DISPLAYFILE_OPENGL(StencilOp);
  DISPLAYFILE_OPENGL(UnmapBuffer);
  DISPLAYFILE_OPENGL(VertexPointer);
  DISPLAYFILE_OPENGL(Viewport);
#undef DISPLAYFILE_OPENGL

 private:
  template <class Function>
  Function function(const char* name) const {
    const OSMESAproc found = GetProcAddress(name);
    if (found == nullptr) throw Error(std::string("OSMesa has no function ") + name);
    return reinterpret_cast<Function>(found);
  }
};

/// Throws Error, at each call, if this system has none.
inline const OpenGl& gl() {
  static const OpenGl library;
  return library;
}

}  // namespace displayfile
