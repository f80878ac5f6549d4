#include "interp/python/camera.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/error.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

std::variant<EyeDirection, Point3> eye_in(py::handle value) {
  const std::vector<double> eye = numbers_in(value, "eye");
  if (eye.size() == 3) return Point3(eye[0], eye[1], eye[2]);
  if (eye.size() == 2 && std::abs(eye[1]) <= 90.0) return EyeDirection{eye[0], eye[1]};
  throw Error(
      "eye: expected azimuth and elevation in degrees, the elevation -90 to 90, or x, y and z in "
      "world coordinates");
}

Point3 look_at_in(py::handle value) {
  const std::vector<double> at = numbers_in(value, "look_at");
  if (at.size() == 3) return {at[0], at[1], at[2]};
  throw Error(fmt::format("look_at: expected x, y and z, not {} numbers", at.size()));
}

std::variant<UprightBy, Upright> upright_in(py::handle value) {
  const std::string word = word_in(value, "up");
  if (word == "auto") return UprightBy::convention;
  try {
    return upright(word);
  } catch (const Error&) {
    throw Error(fmt::format("up '{}': expected x, y, z, -x, -y, -z or auto", word));
  }
}

double angle_of_view_in(py::handle value) {
  const double degrees = number_in(value, "fov");
  if (degrees > 0.0 && degrees < 180.0) return degrees;
  throw Error(fmt::format("fov: {}: expected degrees, more than 0 and less than 180", degrees));
}

using Read = void (*)(py::handle value, Camera& camera);

/// The readers of the camera's arguments, by name.
const std::map<std::string_view, Read>& readers() {
  static const std::map<std::string_view, Read> all{
      {"eye", [](py::handle v, Camera& c) { c.eye = eye_in(v); }},
      {"look_at", [](py::handle v, Camera& c) { c.look_at = look_at_in(v); }},
      {"up", [](py::handle v, Camera& c) { c.upright = upright_in(v); }},
      {"fov", [](py::handle v, Camera& c) { c.angle_of_view = angle_of_view_in(v); }},
      {"parallel", [](py::handle v, Camera& c) { c.parallel = switch_in(v, "parallel"); }},
      {"fit", [](py::handle v, Camera& c) { c.fit = switch_in(v, "fit"); }},
      {"turning", [](py::handle v, Camera& c) { c.turning = switch_in(v, "turning"); }}};
  return all;
}

}  // namespace

Camera camera_in(const py::kwargs& keywords, const Camera& otherwise) {
  Camera camera = otherwise;
  camera.parallel = false;
  camera.angle_of_view.reset();
  for (const auto& [key, value] : keywords) {
    if (value.is_none()) continue;
    const std::string name = word_in(key, "option");
    const auto reader = readers().find(name);
    if (reader == readers().end()) throw Error(fmt::format("unknown option {}", name));
    reader->second(value, camera);
  }
  if (camera.parallel && camera.angle_of_view) {
    throw Error("parallel and fov: expected one of them");
  }
  const bool has_projection = keywords.contains("parallel") && !keywords["parallel"].is_none();
  if (!has_projection && !camera.angle_of_view) {
    camera.parallel = otherwise.parallel;
    camera.angle_of_view = otherwise.angle_of_view;
  }
  return camera;
}

}  // namespace displayfile::python
