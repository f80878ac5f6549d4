#pragma once

#include <cstddef>
#include <memory>
#include <streambuf>

namespace displayfile {

/// Writes a stream's output to a descriptor in whole blocks, whatever the lengths of its pieces.
/// Few large writes take half the time of many that end within pages, and so does dropping the
/// file.
class BlockBuffer : public std::streambuf {
 public:
  static constexpr std::size_t kBlock = std::size_t{1} << 18;

  /// The caller owns the descriptor, and flushes the rest before closing it.
  explicit BlockBuffer(int descriptor);

  /// The errno of a failed write; 0 if all was written.
  int reason() const { return reason_; }

 protected:
  int_type overflow(int_type next) override;
  int sync() override;

 private:
  bool write_block();

  int descriptor_, reason_ = 0;
  std::unique_ptr<char[]> block_;
};

}  // namespace displayfile
