#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "tests/archive.h"

namespace displayfile::test {

/// A tetrahedron, with attributes of its triangles.
inline std::string tetrahedron(const std::vector<std::string>& triangles = {"", "", "", ""},
                               const std::string& more = "") {
  return fmt::format(
      "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
      "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices><triangles>"
      "<triangle v1=\"0\" v2=\"2\" v3=\"1\" {}/><triangle v1=\"0\" v2=\"1\" v3=\"3\" {}/>"
      "<triangle v1=\"0\" v2=\"3\" v3=\"2\" {}/><triangle v1=\"1\" v2=\"2\" v3=\"3\" {}/>"
      "</triangles>{}</mesh>",
      triangles[0], triangles[1], triangles[2], triangles[3], more);
}

inline constexpr const char* kItem = "<item objectid=\"9\"/>";
inline constexpr const char* kMaterials =
    "<basematerials id=\"1\"><base name=\"r\" displaycolor=\"#FF0000\"/>"
    "<base name=\"b\" displaycolor=\"#0000FF\"/></basematerials>"
    "<m:colorgroup id=\"2\"><m:color color=\"#00FF00\"/><m:color "
    "color=\"#FF0000\"/></m:colorgroup>";

inline std::string object(const std::string& content, const std::string& attributes = "",
                          int id = 9) {
  return fmt::format("<object id=\"{}\" type=\"model\" {}>{}</object>", id, attributes, content);
}

inline std::string model_of(const std::string& objects, const std::string& attributes = "",
                            const std::string& items = kItem) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
      "xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06' "
      "xmlns:b=\"http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02\" {}>"
      "<resources>{}{}</resources><build>{}</build></model>",
      attributes, kMaterials, objects, items);
}

}  // namespace displayfile::test
