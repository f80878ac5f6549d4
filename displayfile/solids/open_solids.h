#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/looks/style.h"
#include "displayfile/looks/world_polygon.h"
#include "displayfile/solids/exact_solid.h"
#include "displayfile/solids/solid_faces.h"

namespace displayfile {

/// Nested solids being entered: each collects its contents until it ends
/// (displayfile/solids/README.md). World coordinates.
class OpenSolids {
 public:
  static constexpr std::size_t kDeepest = 32;

  bool empty() const { return levels_.empty(); }
  std::size_t depth() const { return levels_.size(); }

  /// Begins a solid, which is one part of the solid around it. Throws Error beyond kDeepest.
  void begin(SolidOperation operation);
  /// Adds a polygon to the innermost solid; `polygon` numbers the call that entered it.
  void add(const WorldPolygon& polygon, const Attributes& attributes, std::uint32_t polygon_number);
  /// Combines the parts of the innermost solid, which becomes a part of the one around it; for the
  /// outermost, returns its faces, which may be none. Throws Error, without changes, if it has no
  /// parts or a part is not a closed solid, and those of ExactSolid.
  std::optional<SolidFaces> end();
  /// Discards the innermost solid.
  void discard();

  /// The corners of all collected polygons.
  std::span<const Point3> vertices() const { return collected_.vertices; }

 private:
  /// Faces entered, or combined from others.
  struct Part {
    std::size_t first_face, end_face;
    std::optional<ExactSolid> made;
  };
  struct Level {
    SolidOperation operation;
    std::size_t loose_around;  ///< first_loose of the solid around it, before it began
    std::size_t first_face;    ///< of the solid
    std::size_t first_loose;   ///< polygons from here on are the next part
    std::vector<Part> parts;
  };

  std::vector<Part> parts_of_innermost() const;
  static std::string name_of_part(std::size_t k, std::size_t parts);
  ExactSolid exactly(const Part& part, const std::string& name) const;

  std::vector<Level> levels_;
  SolidFaces collected_;
};

}  // namespace displayfile
