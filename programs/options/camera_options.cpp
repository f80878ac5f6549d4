#include "programs/options/camera_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <ostream>

#include "clip/base/error.h"
#include "displayfile/segments/display_file.h"
#include "interp/draw/picture_checks.h"
#include "programs/options/number_list.h"
#include "programs/options/option_groups.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

[[noreturn]] void refuse(const char* option, const std::string& word, const char* expected) {
  throw Error(fmt::format("{} {}: expected {}", option, word, expected));
}

Point3 point(const char* option, const std::string& word) {
  const auto values = number_list(word);
  if (!values || values->size() != 3) refuse(option, word, "X,Y,Z in world coordinates");
  return {(*values)[0], (*values)[1], (*values)[2]};
}

std::variant<EyeDirection, Point3> eye_of(const std::string& word) {
  const auto values = number_list(word);
  if (values && values->size() == 3) return point("--eye", word);
  if (!values || values->size() != 2 || !(std::abs((*values)[1]) <= 90.0)) {
    refuse("--eye", word,
           "AZIMUTH,ELEVATION in degrees, the elevation -90 to 90, or X,Y,Z in world coordinates");
  }
  return EyeDirection{(*values)[0], (*values)[1]};
}

Upright upright_or_refuse(const std::string& word, const char* expected) {
  try {
    return upright(word);
  } catch (const Error&) {
    refuse("--up", word, expected);
  }
}

std::variant<UprightBy, Upright> upright_of(const std::string& word) {
  if (word == "auto") return UprightBy::convention;
  return upright_or_refuse(word, "x, y, z, -x, -y, -z or auto");
}

double angle_of_view(const std::string& word) {
  const auto values = number_list(word);
  if (!values || values->size() != 1 || !((*values)[0] > 0.0 && (*values)[0] < 180.0)) {
    refuse("--fov", word, "degrees, more than 0 and less than 180");
  }
  return values->front();
}

}  // namespace

Upright upright_of_option(const std::string& word) {
  return upright_or_refuse(word, "x, y, z, -x, -y or -z");
}

void CameraWords::add_to(CLI::App& command, const UsualCamera& usual) {
  const auto option = [&](const char* name, std::string& word, const char* value,
                          const std::string& what) {
    return command.add_option(name, word, what)->type_name(value)->group(kCameraOptions);
  };
  option("--eye", eye, "AZIMUTH,ELEVATION|X,Y,Z",
         fmt::format("viewpoint for {}: AZIMUTH,ELEVATION in degrees, 0,0 from the front, 90,0 "
                     "from the right, 0,90 from above; or X,Y,Z, the eye's position [{}]",
                     usual.what, usual.eye));
  option("--look-at", look_at, "X,Y,Z",
         "point in the middle of the picture; by default the middle of what is visible");
  option("--up", up, "x|y|z|-x|-y|-z|auto",
         fmt::format("up axis; auto: by the format's convention if the file does not state it [{}]",
                     usual.up));
  auto* const angle = option(
      "--fov", fov, "DEGREES",
      "vertical angle of view in degrees; by default the eye is four times the mesh's radius away");
  command.add_flag("--parallel", parallel, "use parallel instead of perspective projection")
      ->excludes(angle)
      ->group(kCameraOptions);
  if (usual.many) {
    option("--fit", fit_to, "each|all",
           "inputs to which the camera and the window are fitted: those of each picture, or of all "
           "pictures together, so that parts have one scale [each]; each, where it is given, also "
           "fits the window to drawing programs that set none");
    command
        .add_flag("!--no-fit", fit,
                  "do not fit the window, or the eye's distance for --fov: show a ball of radius 1 "
                  "at the origin, or at --look-at")
        ->group(kCameraOptions);
  } else {
    command
        .add_flag("--fit,!--no-fit", fit,
                  "fit the window, or the eye's distance for --fov, to show the whole mesh; "
                  "otherwise to a ball of radius 1 at the origin, or at --look-at")
        ->default_str("true")
        ->group(kCameraOptions);
  }
  command
      .add_flag("--widen", widen,
                "also widen windows set by programs to the picture's aspect ratio; otherwise they "
                "are stretched, with a warning")
      ->group(kCameraOptions);
}

Camera CameraWords::camera() const {
  Camera camera;
  if (!eye.empty()) camera.eye = eye_of(eye);
  if (!look_at.empty()) camera.look_at = point("--look-at", look_at);
  if (!up.empty()) camera.upright = upright_of(up);
  if (!fov.empty()) camera.angle_of_view = angle_of_view(fov);
  camera.parallel = parallel;
  camera.fit = fit;
  camera.turning = turning;
  return camera;
}

std::vector<std::string> CameraWords::given() const {
  std::vector<std::string> names;
  const auto add = [&](bool is_given, const char* name) {
    if (is_given) names.emplace_back(name);
  };
  add(!eye.empty(), "--eye");
  add(!look_at.empty(), "--look-at");
  add(!up.empty(), "--up");
  add(!fov.empty(), "--fov");
  add(parallel, "--parallel");
  add(!fit, "--no-fit");
  return names;
}

bool CameraWords::fits_all() const {
  if (fit_to == "all") {
    if (!fit) throw Error("--fit all --no-fit: expected one of them");
    return true;
  }
  if (fit_to.empty() || fit_to == "each") return false;
  throw Error(fmt::format("--fit {}: expected each or all", fit_to));
}

void CameraWords::require_fitted(bool fitted) const {
  const auto names = given();
  if (fitted || names.empty()) return;
  throw Error(fmt::format("{}: expected a mesh before which no program sets the camera",
                          fmt::join(names, " ")));
}

void CameraWords::start(GraphicsSystem& system, double aspect) const {
  system.set_aspect_ratio(aspect);
  if (widen) system.set_window_fit(WindowFit::widen);
}

void warn_of_turned_images(const GraphicsSystem& system, const std::string& picture, int width,
                           int height) {
  const Segment* turned = distorted_by_turning(system.display_file(), width, height);
  if (turned == nullptr) return;
  warnings() << fmt::format(
      "{}: segment {}: set-image-rotation distorts in {} x {} pixels: use --size to set as many in "
      "width as in height, such as 512x512, or a modelling transformation\n",
      picture, turned->name(), width, height);
}

void warn_of_scaled_images(const GraphicsSystem& system, const std::string& picture,
                           const std::string& scale) {
  std::vector<int> scaled;
  for (const Segment& segment : system.display_file().segments()) {
    if (segment.visible && segment.image.scale != Point2(1.0)) scaled.push_back(segment.name());
  }
  if (scaled.empty()) return;
  warnings() << fmt::format(
      "{}: --scale {}: not that of segment {}, which set-image-scale changes\n", picture, scale,
      fmt::join(scaled, ", "));
}

void warn_of_stretched_window(const GraphicsSystem& system, const std::string& picture, int width,
                              int height) {
  const auto stretched = system.counts().stretched_window;
  if (!stretched) return;
  const double factor = stretched->window / stretched->viewport;
  const double pixels = std::max(factor, 1.0 / factor) - 1.0;
  if (pixels * std::max(width, height) < 1.0) return;
  warnings() << fmt::format(
      "{}: segment {}: a window {:.4g} times as wide as high is stretched to a viewport {:.4g} "
      "times as wide as high in {} x {} pixels: use --widen to widen it, or set-window-fit stretch "
      "if this is intended\n",
      picture, stretched->segment, stretched->window, stretched->viewport, width, height);
}

}  // namespace displayfile
