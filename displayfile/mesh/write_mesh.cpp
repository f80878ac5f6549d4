#include "displayfile/mesh/write_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <ostream>
#include <utility>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/text/output_file.h"

namespace displayfile {

namespace {

struct WrittenFormat {
  std::string_view extension;
  void (*write)(const SolidTriangles&, const std::string&);
};
constexpr std::array kWrittenFormats{
    WrittenFormat{".stl", write_stl}, WrittenFormat{".obj", write_obj},
    WrittenFormat{".ply", write_ply}, WrittenFormat{".3mf", write_3mf}};

const WrittenFormat& written_format(const std::string& file) {
  const std::string extension = extension_of(file);
  const auto* const found =
      std::ranges::find(kWrittenFormats, extension, &WrittenFormat::extension);
  if (found != kWrittenFormats.end()) return *found;
  throw Error(fmt::format("{}: unknown format of solids '{}': expected one of {}", file, extension,
                          fmt::join(written_mesh_formats(), " ")));
}

template <class Number>
void append_binary(std::string& out, Number value) {
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if (std::endian::native != std::endian::little) std::reverse(raw.begin(), raw.end());
  for (const char byte : raw) out.push_back(byte);
}

std::uint32_t count_for(const std::string& file, std::size_t count, std::size_t most,
                        std::string_view what) {
  if (count <= most) return static_cast<std::uint32_t>(count);
  throw Error(fmt::format("{}: {} {}: expected at most {}", file, count, what, most));
}

constexpr std::size_t kMostIndices = std::numeric_limits<std::int32_t>::max();

}  // namespace

int part_of_255(double component) {
  return static_cast<int>(std::lround(std::clamp(component, 0.0, 1.0) * 255.0));
}

std::vector<std::string_view> written_mesh_formats() {
  std::vector<std::string_view> names;
  names.reserve(std::size(kWrittenFormats));
  for (const WrittenFormat& format : kWrittenFormats) names.push_back(format.extension);
  return names;
}

std::vector<std::string> files_of_mesh(const std::string& file) {
  const WrittenFormat& format = written_format(file);
  std::vector<std::string> files{file};
  if (format.write == write_3mf) require_3mf(file);
  if (format.write == write_obj) {
    files.push_back(std::filesystem::path(file).replace_extension(".mtl").string());
  }
  return files;
}

void write_mesh(const SolidTriangles& solid, const std::string& file) {
  written_format(file).write(solid, file);
}

/// Writes a header that does not begin with "solid", which would mark a text file.
void write_stl(const SolidTriangles& solid, const std::string& file) {
  constexpr std::size_t kBytesOfHeader = 80;
  OutputFile output(file);
  std::string out = "binary STL by Display File";
  out.resize(kBytesOfHeader, ' ');
  append_binary(out, count_for(file, solid.triangles(), std::numeric_limits<std::uint32_t>::max(),
                               "triangles"));
  output.stream() << out;
  for (const SolidTriangles::Object& object : solid.objects) {
    for (const SolidTriangles::Triangle& t : object.triangles) {
      const Point3 &a = object.vertices[t[0]], &b = object.vertices[t[1]],
                   &c = object.vertices[t[2]];
      const Point3 normal = glm::cross(b - a, c - a);
      const double length = glm::length(normal);
      const bool has_one = length > 0.0 && std::isfinite(length);
      out.clear();
      for (const Point3& p : {has_one ? normal / length : Point3(0.0), a, b, c}) {
        for (int axis = 0; axis < 3; ++axis) append_binary(out, static_cast<float>(p[axis]));
      }
      append_binary(out, std::uint16_t{0});
      output.stream() << out;
    }
  }
  output.commit();
}

namespace {

/// In OBJ, an object's name is the rest of a line: without control characters, without blanks
/// around it, which readers drop, and without a `\` at its end, which would join the next line.
std::string in_one_line(std::string_view name) {
  std::string line(name);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  const std::size_t first = line.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  line = line.substr(first, line.find_last_not_of(' ') + 1 - first);
  for (std::size_t k = line.size(); k > 0 && line[k - 1] == '\\'; --k) line[k - 1] = '/';
  return line;
}

/// The objects' names, each once: readers join objects of one name.
std::vector<std::string> names_in_obj(const SolidTriangles& solid) {
  std::vector<std::string> names;
  std::map<std::string, std::size_t> last;  // the last number tried behind each name
  for (std::size_t k = 0; k < solid.objects.size(); ++k) {
    std::string name = in_one_line(solid.objects[k].name);
    if (name.empty()) name = fmt::format("object {}", k + 1);
    last.try_emplace(name, 0);
    names.push_back(std::move(name));
  }
  for (std::string& name : names) {
    std::size_t& number = last.at(name);
    if (++number == 1) continue;
    const std::string base = name;
    while (!last.try_emplace(name = fmt::format("{} ({})", base, number), 1).second) ++number;
  }
  return names;
}

void write_materials(const SolidTriangles& solid, std::ostream& out) {
  for (std::size_t k = 0; k < solid.colours.size(); ++k) {
    const Colour& c = solid.colours[k];
    out << fmt::format("newmtl colour-{}\nKd {} {} {}\n", k + 1, c.r, c.g, c.b);
  }
}

void write_object(const SolidTriangles::Object& object, std::size_t vertices_before,
                  std::ostream& out) {
  for (const Point3& p : object.vertices) out << fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  std::uint32_t colour = SolidTriangles::kNoColour;
  for (std::size_t i = 0; i < object.triangles.size(); ++i) {
    if (object.colours[i] != colour) {
      colour = object.colours[i];
      if (colour != SolidTriangles::kNoColour) out << fmt::format("usemtl colour-{}\n", colour + 1);
    }
    const auto& [a, b, c] = object.triangles[i];
    const std::size_t first = vertices_before + 1;
    out << fmt::format("f {} {} {}\n", first + a, first + b, first + c);
  }
}

}  // namespace

void write_obj(const SolidTriangles& solid, const std::string& file) {
  OutputFile output(file);
  std::optional<OutputFile> materials;
  if (!solid.colours.empty()) {
    const std::filesystem::path beside = std::filesystem::path(file).replace_extension(".mtl");
    materials.emplace(beside.string());
    write_materials(solid, materials->stream());
    output.stream() << fmt::format("mtllib {}\n", beside.filename().string());
  }
  std::size_t vertices = 0;
  const std::vector<std::string> names = names_in_obj(solid);
  for (std::size_t k = 0; k < solid.objects.size(); ++k) {
    const SolidTriangles::Object& object = solid.objects[k];
    output.stream() << fmt::format("o {}\n", names[k]);
    write_object(object, vertices, output.stream());
    vertices += object.vertices.size();
  }
  output.finish();
  if (materials) materials->commit();
  output.commit();
}

void write_ply(const SolidTriangles& solid, const std::string& file) {
  OutputFile output(file);
  std::size_t vertices = 0;
  for (const SolidTriangles::Object& object : solid.objects) vertices += object.vertices.size();
  count_for(file, vertices, kMostIndices, "vertices");
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment by Display File\nelement vertex {}\n"
      "property double x\nproperty double y\nproperty double z\nelement face {}\n"
      "property list uchar int vertex_indices\n",
      vertices, solid.triangles());
  if (!solid.colours.empty()) {
    out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  }
  out += "end_header\n";
  for (const SolidTriangles::Object& object : solid.objects) {
    for (const Point3& p : object.vertices) {
      for (int axis = 0; axis < 3; ++axis) append_binary(out, p[axis]);
    }
  }
  std::size_t before = 0;
  for (const SolidTriangles::Object& object : solid.objects) {
    for (std::size_t i = 0; i < object.triangles.size(); ++i) {
      append_binary(out, std::uint8_t{3});
      for (const std::uint32_t v : object.triangles[i]) {
        append_binary(out, static_cast<std::int32_t>(before + v));
      }
      if (solid.colours.empty()) continue;
      const std::uint32_t colour = object.colours[i];
      const Colour c = colour == SolidTriangles::kNoColour ? Colour(1.0) : solid.colours[colour];
      for (int k = 0; k < 3; ++k) append_binary(out, static_cast<std::uint8_t>(part_of_255(c[k])));
    }
    before += object.vertices.size();
  }
  output.stream() << out;
  output.commit();
}

}  // namespace displayfile
