#pragma once

#include <cstddef>
#include <memory>
#include <streambuf>

namespace displayfile {

/// Writes what a stream is given to a descriptor in whole blocks, however short or long the pieces
/// are: the system takes few large writes in half the time of many that end within its pages, and
/// drops a file that was written so in half the time too.
class BlockBuffer : public std::streambuf {
 public:
  static constexpr std::size_t kBlock = std::size_t{1} << 18;

  /// The descriptor stays the caller's, who flushes what is left before closing it.
  explicit BlockBuffer(int descriptor);

  /// Why something could not be written, as errno has it; 0 if all was.
  int reason() const { return reason_; }

 protected:
  int_type overflow(int_type next) override;
  int sync() override;

 private:
  bool write_block();

  int descriptor_, reason_ = 0;
  std::unique_ptr<char[]> block_;
};

/// False, with the reason in errno, if not all could be written.
bool write_all(int descriptor, const char* bytes, std::size_t count);

}  // namespace displayfile
