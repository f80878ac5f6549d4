#pragma once

#include <cstddef>
#include <string_view>

namespace displayfile {

/// The precision of a file's decimals: that of the numbers with most significant digits. Trailing
/// zeros count, as in 1.500000; leading ones, as in 0.0015, do not.
class WrittenDigits {
 public:
  void see(std::string_view number) {
    if (number.size() >= most_) look_at(number);
  }
  /// Half a unit of the last digit of the longest numbers, the largest of these. 0 if none has 6
  /// digits: such numbers are meant exactly.
  double rounding() const;

 private:
  void look_at(std::string_view number);

  static constexpr std::size_t kFewest = 6;
  std::size_t most_ = kFewest;
  bool any_ = false;
  int last_ = 0;  // power of ten of the last digit
};

}  // namespace displayfile
