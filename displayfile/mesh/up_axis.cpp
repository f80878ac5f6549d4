#include "displayfile/mesh/up_axis.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <variant>

#include "clip/base/words.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

namespace {

/// The next two words in quotation marks.
std::array<std::string_view, 2> quoted_words(std::string_view text) {
  std::array<std::string_view, 2> words;
  for (std::string_view& word : words) {
    const auto begin = text.find('"');
    if (begin == text.npos) break;
    text.remove_prefix(begin + 1);
    word = text.substr(0, text.find('"'));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
  }
  return words;
}

/// The up axis of OpenGEX: `Metric (key = "up") {string {"y"}}`; z if missing.
Upright upright_in_opengex(std::string_view text) {
  constexpr std::string_view kMetric = "Metric";
  for (auto at = text.find(kMetric); at != text.npos; at = text.find(kMetric, at + 1)) {
    const auto [key, value] = quoted_words(text.substr(at));
    if (key == "up") return upright(value == "y" ? "y" : "z");
  }
  return upright("z");
}

/// One line per format whose up axis differs from the y up of the import library's others.
struct FormatUpright {
  std::string_view extension;
  std::string_view axis;
  bool laid_down;  ///< else a convention, which some files follow
  Upright (*read)(std::string_view text) = nullptr;
};
constexpr FormatUpright kUprightFormats[] = {
    {".3mf", "z", true},    // core specification: z away from the plate that is printed on
    {".blend", "z", true},  // Blender's world
    {".cob", "z", true},    // trueSpace's world
    {".hmp", "z", true},    // 3D GameStudio: heights of a terrain
    {".ogex", "z", true, upright_in_opengex},
    {".scn", "z", true},   // trueSpace
    {".smd", "z", true},   // Valve's engines
    {".stl", "z", true},   // Burns, "Automated Fabrication", 6.5: z away from the printer's plate
    {".amf", "z", false},  // printed, as STL
    {".iges", "z", false},
    {".q3o", "z", false},  // Quick3D
    {".q3s", "z", false},
    {".step", "z", false},  // most CAD programs draw upon the plane of x and y
};

const FormatUpright* format_named(std::string_view extension) {
  const auto* found = std::ranges::find(kUprightFormats, extension, &FormatUpright::extension);
  return found == std::end(kUprightFormats) ? nullptr : found;
}

}  // namespace

Upright nearest_upright(const Point3& direction) {
  Upright nearest;
  for (const char* axis : {"x", "-x", "y", "-y", "z", "-z"}) {
    const Upright other = upright(axis);
    if (glm::dot(other.up, direction) > glm::dot(nearest.up, direction)) nearest = other;
  }
  return nearest;
}

bool text_says_upright(std::string_view extension) {
  const FormatUpright* format = format_named(extension);
  return format != nullptr && format->read != nullptr;
}

void set_upright_of_format(Mesh& mesh, std::string_view extension, std::string_view text) {
  const FormatUpright* format = format_named(extension);
  if (format == nullptr) return;
  const Upright of_format = format->read != nullptr ? format->read(text) : upright(format->axis);
  (format->laid_down ? mesh.upright : mesh.usual_upright) = of_format;
}

void CommonUpright::add(const Mesh& mesh, const ModellingTransformation& modelling) {
  const auto* by = std::get_if<UprightBy>(&camera_.upright);
  if (by == nullptr) return;
  std::optional<Upright> in_mesh = mesh.upright;
  if (!in_mesh && *by == UprightBy::convention) in_mesh = mesh.usual_upright;
  if (!in_mesh) return;
  const Upright in_world = nearest_upright(modelling.apply_to_difference(in_mesh->up));
  differ_ |= of_meshes_ && *of_meshes_ != in_world;
  of_meshes_ = in_world;
}

Upright CommonUpright::upright() const {
  if (const auto* axis = std::get_if<Upright>(&camera_.upright)) return *axis;
  return differ_ ? Upright{} : of_meshes_.value_or(Upright{});
}

Camera CommonUpright::camera() const {
  Camera camera = camera_;
  camera.upright = upright();
  return camera;
}

namespace {

constexpr Point3 kX(1.0, 0.0, 0.0), kY(0.0, 1.0, 0.0), kZ(0.0, 0.0, 1.0);
constexpr Point3 kMinusX(-1.0, 0.0, 0.0), kMinusY(0.0, -1.0, 0.0), kMinusZ(0.0, 0.0, -1.0);
constexpr Word<Upright> kUprights[] = {
    {{kMinusY, kX, kZ}, "x"},       {{kX, kY, kZ}, "y"},
    {{kX, kZ, kMinusY}, "z"},       {{kY, kMinusX, kZ}, "-x"},
    {{kMinusX, kMinusY, kZ}, "-y"}, {{kX, kMinusZ, kY}, "-z"},
};

}  // namespace

Upright upright(std::string_view axis) { return value_of(kUprights, axis, "up is"); }

}  // namespace displayfile
