#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/written_digits.h"
#include "displayfile/mesh/xml_tags.h"

namespace displayfile {

/// The placement of an object: a component of another object, or an item of the build.
struct ThreeMfPlacement {
  std::string part;  ///< of the file, where the object is; empty: the same
  std::string object;
  glm::dmat4 transformation{1.0};
};

struct ThreeMfTriangle {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t material;  ///< of the builder
};

struct ThreeMfObject {
  std::string name;
  std::vector<Point3> vertices;
  std::vector<ThreeMfTriangle> triangles;
  std::vector<ThreeMfPlacement> components;
  bool is_placed = false;  ///< by the build, itself or in another
};

/// A model, the content of a part of the file.
struct ThreeMfModel {
  double millimetres = 1.0;  ///< of its unit
  std::string unit;
  std::map<std::string, ThreeMfObject, std::less<>> objects;  // by their identifiers
  std::vector<ThreeMfPlacement> build;
};

/// Counts of contents that are not drawn, and the precision of coordinates.
struct ThreeMfFindings {
  std::size_t varied = 0;   ///< triangles whose corners differ in colour
  std::size_t layered = 0;  ///< triangles with several properties in layers
  std::size_t unknown = 0;  ///< triangles with a property that the file does not define
  std::map<std::string_view, std::size_t> other_geometry;  ///< by its name in words
  WrittenDigits digits;
};

/// Reads the text of a model, whose materials it adds to the builder. Throws std::runtime_error,
/// with a message to follow the file's name: the model is incomplete, a number is invalid, an index
/// is out of range, or it requires an extension that is not read.
ThreeMfModel read_three_mf_model(std::string_view text, MeshBuilder& mesh,
                                 ThreeMfFindings& findings);

}  // namespace displayfile
