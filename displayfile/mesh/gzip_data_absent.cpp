#include "clip/base/error.h"
#include "displayfile/mesh/compressed_data.h"

namespace displayfile {

std::string uncompressed_gzip(const std::string& path, std::string_view) {
  throw Error(path + ": compressed by gzip: built without zlib: decompress it first");
}

}  // namespace displayfile
