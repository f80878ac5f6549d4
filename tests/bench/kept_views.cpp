#include "tests/bench/kept_views.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "displayfile/scene_viewer.h"
#include "interp/device/raster_request.h"
#include "tests/from_eyes.h"
#include "interp/raster/software.h"
#include "programs/bench/side_by_side.h"

namespace displayfile::bench {

namespace {

using test::FromEyes;

/// As Turntable turns, in world coordinates.
glm::dmat3 turned(double degrees) {
  return glm::dmat3(
      glm::rotate(glm::dmat4(1.0), degrees * std::numbers::pi / 180.0, Point3(0.3, 0.2, 1.0)));
}

struct Views {
  const RetainedScene& scene;
  const DisplayFile& attributes;
  const Turntable& turntable;
  const RasterRequest& request;
  int views;
};

/// The seconds of some views one after the other, by three ways.
class Comparison {
 public:
  explicit Comparison(const Views& of)
      : of_(of), kept_(of.scene, of.attributes), viewer_(of.scene, of.attributes) {
    options_.width = of.request.width;
    options_.height = of.request.height;
    options_.threads = of.request.threads;
    options_.hidden = of.request.method;
  }

  void run(std::string_view what, bool eye_moves) {
    constexpr int kWarm = 3;
    for (int k = -kWarm; k < of_.views; ++k) {
      const double degrees = 360.0 * k / of_.views;
      View view = of_.turntable.at(eye_moves ? degrees : 20.0).view;
      measure(view, eye_moves ? glm::dmat3(1.0) : turned(degrees), k >= 0);
    }
    const double unit = spread(of_kept_).median;
    fmt::print(
        "{}: only memory kept {:.2f}, anew {:.2f} in units of a kept view; {} of {} pictures the "
        "same\n",
        what, spread(of_memory_).median / unit, spread(anew_).median / unit, same_, of_.views);
    if (kept_.bytes_of_casters() == 0) return;
    fmt::print(
        "  kept for shadows: {:.0f} bytes a polygon\n",
        static_cast<double>(kept_.bytes_of_casters()) / static_cast<double>(of_.scene.size()));
  }

 private:
  void measure(const View& view, const glm::dmat3& lights, bool counts) {
    const Picture* picture = nullptr;
    const double of_kept = seconds([&] { picture = &kept_.draw(view, options_, lights); });
    const PictureSize size{of_.request.width, of_.request.height};
    viewer_.view({View(), lights, size, of_.request.threads});  // forgets what it saw
    const double of_memory = seconds([&] {
      renderer_.draw(viewer_.view({view, lights, size, of_.request.threads}), of_.request);
    });
    const Picture* anew_drawn = nullptr;
    const double anew = seconds([&] {
      const DisplayFile file = viewer_.display_file(view, lights);
      anew_drawn = &renderer_of_files_.draw(file, of_.request);
    });
    if (!counts) return;
    of_kept_.push_back(of_kept);
    of_memory_.push_back(of_memory);
    anew_.push_back(anew);
    same_ += picture->pixels == anew_drawn->pixels ? 1 : 0;
  }

  Views of_;
  DrawOptions options_;
  FromEyes kept_;
  SceneViewer viewer_;
  SoftwareRenderer renderer_, renderer_of_files_;
  std::vector<double> of_kept_, of_memory_, anew_;
  int same_ = 0;
};

}  // namespace

void print_kept_views(const RetainedScene& scene, const DisplayFile& attributes,
                      const Turntable& turntable, const RasterRequest& request, int views) {
  const Views of{scene, attributes, turntable, request, views};
  Comparison(of).run("the eye moves", true);
  Comparison(of).run("the light moves", false);
}

}  // namespace displayfile::bench
