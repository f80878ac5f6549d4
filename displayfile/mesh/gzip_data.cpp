#include <fmt/format.h>
#define ZLIB_CONST
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/shared_library.h"
#include "displayfile/mesh/compressed_data.h"

namespace displayfile {

namespace {

struct Zlib {
  SharedLibrary library{"libz.so.1"};
  DISPLAYFILE_LIBRARY_FUNCTION(library, inflate, Init2_);
  decltype(&::inflate) inflate = library.function<decltype(&::inflate)>("inflate");
  DISPLAYFILE_LIBRARY_FUNCTION(library, inflate, Reset);
  DISPLAYFILE_LIBRARY_FUNCTION(library, inflate, End);

  static const Zlib& get() {
    static const Zlib loaded;
    return loaded;
  }
};

const Zlib& zlib_for(const std::string& path) {
  try {
    return Zlib::get();
  } catch (const Error& e) {
    throw Error(fmt::format(
        "{}: a file compressed by gzip, which is read by zlib, which cannot be loaded: {}", path,
        e.what()));
  }
}

uInt as_much_as_fits(std::size_t bytes) {
  return static_cast<uInt>(std::min<std::size_t>(bytes, std::numeric_limits<uInt>::max()));
}

class Inflater {
 public:
  Inflater(const Zlib& zlib, std::string_view data) : zlib_(zlib), rest_(data) {
    constexpr int kGzipOnly = 16;
    if (zlib_.Init2_(&stream_, MAX_WBITS + kGzipOnly, ZLIB_VERSION, sizeof stream_) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { zlib_.End(&stream_); }

  bool is_at_end() const { return rest_.empty(); }
  /// True if only zeros follow, as after the last part on tapes.
  bool only_zeros_follow() const { return rest_.find_first_not_of('\0') == rest_.npos; }
  void begin_part() { zlib_.Reset(&stream_); }

  /// Returns zlib's status.
  int fill(ExpandedData& content) {
    const ExpandedData::Room room = content.room();
    stream_.next_in = reinterpret_cast<const Bytef*>(rest_.data());
    stream_.avail_in = as_much_as_fits(rest_.size());
    stream_.next_out = reinterpret_cast<Bytef*>(room.data);
    stream_.avail_out = as_much_as_fits(room.bytes);
    const uInt in = stream_.avail_in, out = stream_.avail_out;
    const int status = zlib_.inflate(&stream_, Z_NO_FLUSH);
    rest_.remove_prefix(in - stream_.avail_in);
    content.keep(out - stream_.avail_out);
    return status;
  }

 private:
  const Zlib& zlib_;
  std::string_view rest_;
  z_stream stream_{};
};

}  // namespace

std::string uncompressed_gzip(const std::string& path, std::string_view data) {
  ExpandedData content(path, data.size());
  Inflater inflater(zlib_for(path), data);
  for (;;) {
    const int status = inflater.fill(content);
    if (status == Z_STREAM_END) {
      if (inflater.only_zeros_follow()) return std::move(content).take();
      inflater.begin_part();
    } else if (status == Z_MEM_ERROR) {
      throw std::bad_alloc();
    } else if (status == Z_BUF_ERROR && inflater.is_at_end()) {
      content.fail("gzip", "cut off");
    } else if (status != Z_OK && status != Z_BUF_ERROR) {
      content.fail("gzip", "damaged");
    }
  }
}

}  // namespace displayfile
