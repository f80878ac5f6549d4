#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace displayfile {

/// An integer times a power of two, of any size: every finite double is one, and sums, differences
/// and products of them are exact, so that the laws of integers hold: they may be added and
/// multiplied in any order, and (a - a).sign() is 0. The exact stage of the predicates. Few digits
/// are stored in place, so that no memory is allocated for coordinates of ordinary size;
/// exact_digits.h has the operations on digits.
class ExactNumber {
 public:
  ExactNumber() = default;
  /// The double itself; it must be finite.
  explicit ExactNumber(double value);
  explicit ExactNumber(std::int64_t value);
  ExactNumber(const ExactNumber& other);
  ExactNumber(ExactNumber&& other) noexcept;
  ExactNumber& operator=(const ExactNumber& other);
  ExactNumber& operator=(ExactNumber&& other) noexcept;
  ~ExactNumber() = default;

  int sign() const { return sign_; }

  /// mantissa 2^exponent, with 53 digits at most: 1/2 <= |mantissa| < 1, or it is 0. Off by less
  /// than a unit of the mantissa's last digit, toward zero.
  struct Leading {
    double mantissa;
    std::int64_t exponent;
    bool is_all;  ///< exact
  };
  Leading leading() const;

  ExactNumber operator-() const;
  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
    return sum(a, b, b.sign_);
  }
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) {
    return sum(a, b, -b.sign_);
  }
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);

  /// The double nearest to a / b, ties to an even last digit, whatever the rounding mode. Monotonic
  /// in the quotient. Throws Error if b is zero, or if the result exceeds every double.
  friend double rounded_quotient(const ExactNumber& a, const ExactNumber& b);

 private:
  static constexpr int kInPlace = 20;  ///< limbs: 1280 bits

  static ExactNumber sum(const ExactNumber& a, const ExactNumber& b, int sign_of_b);

  /// The sum of the magnitudes with these signs. Neither is zero, and the exponent of the first is
  /// at least that of the second.
  static ExactNumber sum_of(const ExactNumber& higher, int sign_of_higher, const ExactNumber& lower,
                            int sign_of_lower);
  std::uint64_t* reserve(int limbs);
  const std::uint64_t* limbs() const { return large_ ? large_.get() : in_place_.data(); }
  std::uint64_t* limbs() { return large_ ? large_.get() : in_place_.data(); }
  void set_magnitude(std::uint64_t magnitude);
  void drop_leading_zeros();
  void copy_limbs(const ExactNumber& other);

  int sign_ = 0;   ///< -1, 0, 1
  int count_ = 0;  ///< limbs in use, the highest not zero; 0 for zero
  std::int64_t exponent_ = 0;
  std::array<std::uint64_t, kInPlace> in_place_;  ///< least significant first
  std::unique_ptr<std::uint64_t[]> large_;        ///< used instead if more limbs are needed
};

inline std::uint64_t* ExactNumber::reserve(int limbs_needed) {
  large_.reset();
  if (limbs_needed > kInPlace) {
    large_ =
        std::make_unique_for_overwrite<std::uint64_t[]>(static_cast<std::size_t>(limbs_needed));
  }
  return limbs();
}

inline void ExactNumber::drop_leading_zeros() {
  const std::uint64_t* p = limbs();
  while (count_ > 0 && p[count_ - 1] == 0) --count_;
  if (count_ == 0) sign_ = 0;
}

}  // namespace displayfile
