#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "displayfile/mesh/mesh.h"
#include "tests/error_of.h"
#include "tests/mesh_files.h"

// The colours of a mesh's faces, and the reports on them.

namespace displayfile::test {

using Colours = std::vector<std::optional<Colour>>;

/// Face by face.
inline Colours colours_of(const Mesh& mesh) {
  Colours colours;
  for (std::size_t i = 0; i < mesh.faces(); ++i) colours.push_back(mesh.colour(i));
  return colours;
}

inline std::string text_of(const Colours& colours) {
  std::string text;
  for (const auto& c : colours) text += c ? fmt::format("({} {} {})", c->r, c->g, c->b) : "(none)";
  return text;
}

class MeshColours : public MeshFiles {
 protected:
  void expect_colours(const Mesh& mesh, const Colours& expected) const {
    EXPECT_EQ(text_of(colours_of(mesh)), text_of(expected));
  }

  void expect_refused(const std::string& path, const std::string& expected) const {
    expect_error([&] { read_mesh(path); }, expected);
  }
};

inline constexpr const char* kFourFaces[] = {"f 1 3 2\n", "f 1 2 4\n", "f 1 4 3\n", "f 2 3 4\n"};

/// The reports of reading beside faces: one line each.
inline std::string said_of(const Mesh& mesh) {
  std::string text = fmt::format("{} textured, {} transparent\n", mesh.skipped.textured_faces,
                                 mesh.skipped.transparent_faces);
  for (const std::string& warning : mesh.skipped.warnings) text += warning + "\n";
  return text;
}

}  // namespace displayfile::test
