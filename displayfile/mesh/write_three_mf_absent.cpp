// A build without the headers of minizip, which cannot write 3MF.

#include "clip/base/error.h"
#include "displayfile/mesh/write_mesh.h"

namespace displayfile {

void require_3mf(const std::string& file) {
  throw Error(
      file +
      ": 3MF is written by minizip, with which Assimp comes and this build was made without "
      "(Debian: libassimp-dev): expected another format");
}

void write_3mf(const SolidTriangles&, const std::string& file) { require_3mf(file); }

}  // namespace displayfile
