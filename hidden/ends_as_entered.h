#pragma once

#include <array>
#include <cstdint>

namespace displayfile {

/// Locates a scene's line ends relative to polygons' planes by the points as entered, since viewing
/// rounds by many times their possible distance.
class EndsAsEntered {
 public:
  enum class Place : std::uint8_t {
    unknown,    ///< the entered points are unavailable
    on_plane,   ///< within reach (clip/surfaces.h)
    before,     ///< nearer to the viewer than the plane
    behind,     ///< farther
    off_plane,  ///< before or behind
  };
  using Places = std::array<Place, 2>;  ///< of a line's start and of its end
  static constexpr Places kUnknown{Place::unknown, Place::unknown};

  /// The two ends of a line, named by item and corner as in Primitives, relative to the plane of a
  /// polygon. A clipped line has its ends as entered. Exact. Several threads may call it.
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
