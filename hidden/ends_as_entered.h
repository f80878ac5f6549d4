#pragma once

#include <array>
#include <cstdint>

namespace displayfile {

/// Tells of a scene where ends of lines are to the planes that polygons lie in, by the points as
/// they were entered: viewing rounds by many times what they may be apart.
class EndsAsEntered {
 public:
  enum class Place : std::uint8_t {
    unknown,    ///< what was entered is not at hand
    on_plane,   ///< within reach (clip/surfaces.h)
    before,     ///< nearer to the viewer than the plane
    behind,     ///< farther
    off_plane,  ///< one of both
  };
  using Places = std::array<Place, 2>;  ///< of a line's start and of its end
  static constexpr Places kUnknown{Place::unknown, Place::unknown};

  /// The ends of the line that ends at that corner of an item, as Primitives names lines, against
  /// the plane that a polygon lies in. A line that was clipped has the ends that it was entered
  /// with. Exact. May be called by several threads.
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
