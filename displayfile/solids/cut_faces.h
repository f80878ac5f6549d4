#pragma once

#include <optional>
#include <string_view>

namespace displayfile {

/// What becomes of the faces where cutting planes cut solids that are entered whole
/// (displayfile/solids/cut_solid.md).
struct CutFaces {
  enum class Kind {
    open,     ///< there are none: the inside is seen
    closed,   ///< polygons, in the styles in force
    hatched,  ///< the same, and lines on them
  };
  Kind kind = Kind::open;
  /// Between hatching lines, in world units; none: a twenty-fourth of the longest side of the box
  /// around the solid.
  std::optional<double> spacing{};
  /// The angle of hatching lines, in degrees, counterclockwise from where the plane is level, seen
  /// from the side that is cut away.
  double angle = 45.0;
};

/// The word for a spacing that is not given.
inline constexpr std::string_view kUsualSpacing = "usual";

/// Reads `open`, `closed` or `hatched`; throws Error for anything else.
CutFaces::Kind cut_faces_kind(std::string_view text);
std::string_view name_of(CutFaces::Kind kind);

}  // namespace displayfile
