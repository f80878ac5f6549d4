#include "clip/base/error.h"
#include "tests/bench/command/opengl_mesh.h"

namespace displayfile::bench {

namespace {

[[noreturn]] void refuse() { throw Error("this build has no OSMesa"); }

}  // namespace

class OpenGlMesh::Drawing {};

OpenGlMesh::OpenGlMesh(const IndexedTriangles&, const Options&) { refuse(); }
OpenGlMesh::~OpenGlMesh() = default;
void OpenGlMesh::set_matrix(const glm::dmat4&) { refuse(); }
void OpenGlMesh::draw_with_new_vertices() { refuse(); }
void OpenGlMesh::make_resident() { refuse(); }
std::string_view OpenGlMesh::resident_in() const { refuse(); }
void OpenGlMesh::draw() { refuse(); }
Picture OpenGlMesh::picture() { refuse(); }

}  // namespace displayfile::bench
