#pragma once

#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace displayfile {

// The truth's integers in a web page, by JavaScript's BigInt: the interface of integer_gmp.h, with
// the same meaning. The methods use Boost's.

// interp/web/bigint_library.js: a BigInt is stored under a handle, a number from 1 up, until it is
// released.
extern "C" {
int displayfile_bigint_of(double whole);
int displayfile_bigint_copy(int n);
void displayfile_bigint_let_go(int n);
void displayfile_bigint_set(int to, int n);
void displayfile_bigint_negate(int to, int n);
void displayfile_bigint_add(int to, int a, int b);
void displayfile_bigint_subtract(int to, int a, int b);
void displayfile_bigint_multiply(int to, int a, int b);
void displayfile_bigint_divide(int a, int b, int quotient, int rest);
void displayfile_bigint_shift_left(int to, int n, double places);
void displayfile_bigint_shift_right(int to, int n, double places);
int displayfile_bigint_compare(int a, int b);
int displayfile_bigint_sign(int n);
double displayfile_bigint_digits(int n);
double displayfile_bigint_zeros(int n);
void displayfile_bigint_magnitude(int n, std::uint32_t* low, std::uint32_t* high);
}

class Integer {
 public:
  Integer() : Integer(0.0) {}
  Integer(int n) : Integer(static_cast<double>(n)) {}
  explicit Integer(double whole) : n_(displayfile_bigint_of(whole)) {}
  Integer(const Integer& other) : n_(displayfile_bigint_copy(other.n_)) {}
  Integer(Integer&& other) noexcept : n_(other.n_) { other.n_ = 0; }
  Integer& operator=(const Integer& other) {
    if (n_ == 0) {
      n_ = displayfile_bigint_copy(other.n_);
    } else {
      displayfile_bigint_set(n_, other.n_);
    }
    return *this;
  }
  Integer& operator=(Integer&& other) noexcept {
    const int n = n_;
    n_ = other.n_;
    other.n_ = n;
    return *this;
  }
  ~Integer() {
    if (n_ != 0) displayfile_bigint_let_go(n_);
  }

  Integer& operator+=(const Integer& b) { return result(displayfile_bigint_add, b); }
  Integer& operator-=(const Integer& b) { return result(displayfile_bigint_subtract, b); }
  Integer& operator*=(const Integer& b) { return result(displayfile_bigint_multiply, b); }
  Integer& operator<<=(std::size_t places) {
    displayfile_bigint_shift_left(n_, n_, static_cast<double>(places));
    return *this;
  }
  Integer& operator>>=(std::size_t places) {
    displayfile_bigint_shift_right(n_, n_, static_cast<double>(places));
    return *this;
  }
  friend Integer operator+(Integer a, const Integer& b) {
    a += b;
    return a;
  }
  friend Integer operator-(Integer a, const Integer& b) {
    a -= b;
    return a;
  }
  friend Integer operator*(Integer a, const Integer& b) {
    a *= b;
    return a;
  }
  friend Integer operator<<(Integer a, std::size_t places) {
    a <<= places;
    return a;
  }
  friend Integer operator>>(Integer a, std::size_t places) {
    a >>= places;
    return a;
  }
  Integer operator-() const {
    Integer negative;
    displayfile_bigint_negate(negative.n_, n_);
    return negative;
  }

  friend bool operator==(const Integer& a, const Integer& b) {
    return displayfile_bigint_compare(a.n_, b.n_) == 0;
  }
  friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
    return displayfile_bigint_compare(a.n_, b.n_) <=> 0;
  }
  // Comparisons of signs are the most frequent.
  friend bool operator==(const Integer& a, std::same_as<int> auto b) {
    return b == 0 ? displayfile_bigint_sign(a.n_) == 0 : a == Integer(b);
  }
  friend std::strong_ordering operator<=>(const Integer& a, std::same_as<int> auto b) {
    return b == 0 ? displayfile_bigint_sign(a.n_) <=> 0 : a <=> Integer(b);
  }

  int number() const { return n_; }  ///< its handle

 private:
  Integer& result(void (*operation)(int to, int a, int b), const Integer& b) {
    operation(n_, n_, b.n_);
    return *this;
  }

  int n_;
};

inline int sgn(const Integer& n) { return displayfile_bigint_sign(n.number()); }
inline Integer abs(const Integer& n) { return sgn(n) < 0 ? -n : n; }

/// A quotient, not in lowest terms; the denominator is positive.
class Rational {
 public:
  Rational(int n = 0) : over_(n), under_(1) {}
  Rational(const Integer& over, const Integer& under)
      : over_(sgn(under) < 0 ? -over : over), under_(abs(under)) {}
  friend Rational operator+(const Rational& a, const Rational& b) {
    return {a.over_ * b.under_ + b.over_ * a.under_, a.under_ * b.under_};
  }
  friend Rational operator-(const Rational& a, const Rational& b) {
    return {a.over_ * b.under_ - b.over_ * a.under_, a.under_ * b.under_};
  }
  friend Rational operator*(const Rational& a, const Rational& b) {
    return {a.over_ * b.over_, a.under_ * b.under_};
  }
  Rational& operator+=(const Rational& b) { return *this = *this + b; }
  friend bool operator==(const Rational& a, const Rational& b) {
    return a.over_ * b.under_ == b.over_ * a.under_;
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return a.over_ * b.under_ <=> b.over_ * a.under_;
  }
  friend Rational abs(const Rational& q) { return {abs(q.over_), q.under_}; }
  friend int sgn(const Rational& q) { return sgn(q.over_); }

 private:
  Integer over_, under_;
};

inline Rational ratio(const Integer& over, const Integer& under) { return {over, under}; }

inline void add_product(Integer& to, const Integer& a, unsigned b) {
  to += a * Integer(static_cast<double>(b));
}
inline void set_shifted_left(Integer& to, const Integer& n, std::size_t places) {
  displayfile_bigint_shift_left(to.number(), n.number(), static_cast<double>(places));
}
inline void divide(const Integer& a, const Integer& b, Integer& quotient, Integer& rest) {
  displayfile_bigint_divide(a.number(), b.number(), quotient.number(), rest.number());
}
inline void divide_up(const Integer& a, const Integer& b, Integer& quotient) {
  Integer rest;
  divide(a, b, quotient, rest);
  if (sgn(rest) == sgn(b)) quotient += 1;
}
inline int digits_of(const Integer& n) {
  return static_cast<int>(displayfile_bigint_digits(n.number()));
}
inline std::size_t zeros_at_end(const Integer& n) {
  return static_cast<std::size_t>(displayfile_bigint_zeros(n.number()));
}
inline std::uint64_t magnitude(const Integer& n) {
  std::uint32_t low = 0, high = 0;
  displayfile_bigint_magnitude(n.number(), &low, &high);
  return std::uint64_t{high} << 32 | low;
}

}  // namespace displayfile
