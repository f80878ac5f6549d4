#include "clip/base/error.h"
#include "interp/device/raster_request.h"
#include "interp/opengl/osmesa.h"

namespace displayfile {

namespace {

[[noreturn]] void refuse_osmesa() {
  throw Error(
      "this build has no OSMesa: it was left out, or GL/osmesa.h was not found, when it was "
      "configured (Mesa 25.1 and later have none); draw with the software device");
}

}  // namespace

class OsmesaBuffers::Drawing {};

bool osmesa_available() { return false; }

std::string osmesa_description(int) { return "none: this build has no OSMesa"; }

Picture draw_with_osmesa(const DisplayFile&, const RasterRequest&, int) { refuse_osmesa(); }

OsmesaBuffers::OsmesaBuffers(const DisplayFile&, const RasterRequest&, int) { refuse_osmesa(); }
OsmesaBuffers::~OsmesaBuffers() = default;
void OsmesaBuffers::draw() { refuse_osmesa(); }
Picture OsmesaBuffers::picture() { refuse_osmesa(); }
std::size_t OsmesaBuffers::triangles() const { refuse_osmesa(); }
int OsmesaBuffers::depth_bits() const { refuse_osmesa(); }

}  // namespace displayfile
