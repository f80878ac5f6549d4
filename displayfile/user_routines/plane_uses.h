#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "clip/pipeline/cutting_planes.h"

namespace displayfile {

/// A cutting plane that primitives met and that made no difference to them, or left nothing of
/// them, from when it was set until it was replaced or turned off.
struct PlaneWithoutEffect {
  int n;
  std::array<double, 4> plane;  ///< a b c d, as set
  std::int64_t order;           ///< the number of planes set up to this one, from 1
  bool leaves_nothing;          ///< all that it met lies where it cuts away
  bool is_set;                  ///< still
};

/// Cutting planes in the course of a program, and which sides of them primitives lie on.
class PlaneUses {
 public:
  static constexpr std::size_t kMostKept = 16;  ///< planes without effect that are set no more

  void set(int n, const std::array<double, 4>& plane);
  void set_off(int n);
  /// A primitive was met by these planes (bits as in CuttingPlanes::outcode): a part of it lies
  /// where those of `some` cut away, all of it where those of `all` do.
  void met(unsigned planes, unsigned some, unsigned all) {
    met_ |= planes;
    cuts_ |= planes & some;
    leaves_ |= planes & ~all;
  }
  std::int64_t planes_set() const { return set_; }
  /// In the order of setting.
  std::vector<PlaneWithoutEffect> without_effect() const;

 private:
  struct InForce {
    std::array<double, 4> plane;
    std::int64_t order;
  };
  bool has_no_effect(int n) const;
  PlaneWithoutEffect now(int n, bool is_set) const;
  void end(int n);

  std::array<InForce, CuttingPlanes::kMost> planes_{};
  unsigned on_ = 0, met_ = 0, cuts_ = 0, leaves_ = 0;
  std::int64_t set_ = 0;
  std::vector<PlaneWithoutEffect> ended_;
};

}  // namespace displayfile
