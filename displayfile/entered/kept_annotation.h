#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "clip/view/transformation.h"
#include "clip/view/view_volume.h"
#include "displayfile/looks/style.h"

namespace displayfile {

/// Annotation as a segment keeps it (displayfile/looks/style.h), with its measure as text. Points
/// are in world coordinates in a retained scene, otherwise in normalised device coordinates.
struct KeptAnnotation {
  enum class Kind : std::uint8_t { leader, balloon, linear, diameter, radius, angle, title, list };
  Kind kind;
  AnnotationStyle style;
  Colour colour;
  /// For leaders and balloons: from the point to the end of the line beside the text, or to the
  /// circle's centre, in the style's unit. For a list: the signs of its corner, from the picture's
  /// middle.
  Point2 offset;
  /// First the points of the model, then those of the drawing:
  ///   leader, balloon: the point;
  ///   linear: the two measured points, then the ends of the dimension line, in their order;
  ///   diameter: two points of the circle; radius: the centre, then a point of the circle;
  ///   angle: the vertex, then the two other points, and the arc from the first to the second.
  std::vector<Point3> points;
  std::string characters;  ///< also of a balloon's number
  std::string name;        ///< of a balloon's part
  int segment = 0;         ///< name, in a viewed scene; otherwise 0

  /// The number of points of the model.
  std::size_t anchors() const {
    switch (kind) {
      case Kind::leader:
      case Kind::balloon:
      case Kind::angle: return 1;
      case Kind::linear:
      case Kind::diameter:
      case Kind::radius: return 2;
      case Kind::title:
      case Kind::list: break;
    }
    return 0;
  }
  bool operator==(const KeptAnnotation&) const = default;
};

std::string_view name_of(KeptAnnotation::Kind kind);  ///< in dumps

/// Annotation from world coordinates to normalised device coordinates. None if a point of the model
/// is outside of the view volume, or another one not in front of the eye.
std::optional<KeptAnnotation> viewed(const KeptAnnotation& annotation, const ViewVolume& volume);

/// Annotation after an image transformation, which moves its points only.
KeptAnnotation transformed(KeptAnnotation annotation, const ImageTransformation& image);

}  // namespace displayfile
