#include "clip/base/error.h"
#include "displayfile/mesh/compressed_data.h"

namespace displayfile {

std::string uncompressed_zstd(const std::string& path, std::string_view) {
  throw Error(path + ": compressed by Zstandard: built without libzstd: decompress it first");
}

}  // namespace displayfile
