#include <fmt/format.h>
#include <zstd.h>

#include <memory>
#include <new>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/shared_library.h"
#include "displayfile/mesh/compressed_data.h"

namespace displayfile {

namespace {

struct Zstd {
  SharedLibrary library{"libzstd.so.1"};
  DISPLAYFILE_LIBRARY_FUNCTION(library, ZSTD_, createDStream);
  DISPLAYFILE_LIBRARY_FUNCTION(library, ZSTD_, freeDStream);
  DISPLAYFILE_LIBRARY_FUNCTION(library, ZSTD_, decompressStream);
  DISPLAYFILE_LIBRARY_FUNCTION(library, ZSTD_, isError);

  static const Zstd& get() {
    static const Zstd loaded;
    return loaded;
  }
};

const Zstd& zstd_for(const std::string& path) {
  try {
    return Zstd::get();
  } catch (const Error& e) {
    throw Error(
        fmt::format("{}: a file compressed by Zstandard, which is read by libzstd, which "
                    "cannot be loaded: {}",
                    path, e.what()));
  }
}

}  // namespace

std::string uncompressed_zstd(const std::string& path, std::string_view data) {
  const Zstd& zstd = zstd_for(path);
  const std::unique_ptr<ZSTD_DStream, decltype(zstd.freeDStream)> stream(zstd.createDStream(),
                                                                         zstd.freeDStream);
  if (stream == nullptr) throw std::bad_alloc();
  ExpandedData content(path, data.size());
  ZSTD_inBuffer in{data.data(), data.size(), 0};
  for (;;) {
    const ExpandedData::Room room = content.room();
    ZSTD_outBuffer out{room.data, room.bytes, 0};
    const std::size_t expected = zstd.decompressStream(stream.get(), &out, &in);
    if (zstd.isError(expected) != 0) content.fail("Zstandard", "damaged");
    content.keep(out.pos);
    const bool is_all_read = in.pos == in.size;
    if (is_all_read && expected == 0) return std::move(content).take();
    if (is_all_read && out.pos == 0) content.fail("Zstandard", "cut off");
  }
}

}  // namespace displayfile
