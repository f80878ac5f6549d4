#include "clip/base/block_buffer.h"

#include <cerrno>

#include "clip/system/descriptors.h"

namespace displayfile {

BlockBuffer::BlockBuffer(int descriptor)
    : descriptor_(descriptor), block_(std::make_unique_for_overwrite<char[]>(kBlock)) {
  setp(block_.get(), block_.get() + kBlock);
}

/// After a failed write nothing more is written.
bool BlockBuffer::write_block() {
  if (reason_ == 0 &&
      !write_all(descriptor_, pbase(), static_cast<std::size_t>(pptr() - pbase()))) {
    reason_ = errno;
  }
  setp(block_.get(), block_.get() + kBlock);
  return reason_ == 0;
}

BlockBuffer::int_type BlockBuffer::overflow(int_type next) {
  if (!write_block()) return traits_type::eof();
  if (traits_type::eq_int_type(next, traits_type::eof())) return traits_type::not_eof(next);
  return sputc(traits_type::to_char_type(next));
}

int BlockBuffer::sync() { return write_block() ? 0 : -1; }

}  // namespace displayfile
