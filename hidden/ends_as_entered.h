#pragma once

#include <array>
#include <cstdint>

namespace displayfile {

/// Of a scene's items, which ends of lines are within reach of which planes (hidden/touching.h),
/// judged by the points as they were entered: viewing rounds by more than many reaches.
class EndsAsEntered {
 public:
  enum class Place : std::uint8_t {
    unknown,  ///< what was entered is not at hand
    off_plane,
    on_plane,
  };
  using Places = std::array<Place, 2>;  ///< of a line's start and of its end
  static constexpr Places kUnknown{Place::unknown, Place::unknown};

  /// Of the line that ends at that corner of an item, as Primitives names lines, and the plane that
  /// a polygon lies in. If the line was clipped, of the ends that it was entered with. Exact.
  /// May be called by several threads.
  virtual Places places(std::uint32_t item, std::uint32_t corner, std::uint32_t polygon) const = 0;

 protected:
  EndsAsEntered() = default;
  EndsAsEntered(const EndsAsEntered&) = default;
  EndsAsEntered(EndsAsEntered&&) = default;
  EndsAsEntered& operator=(const EndsAsEntered&) = default;
  EndsAsEntered& operator=(EndsAsEntered&&) = default;
  virtual ~EndsAsEntered() = default;
};

}  // namespace displayfile
