#include <fmt/format.h>

#include <glm/mat3x3.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/round_to_nearest.h"
#include "clip/view/view_volume.h"
#include "displayfile/looks/letters.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/followed_view.h"
#include "displayfile/views/scene_in_one_view.h"
#include "interp/draw/renderer.h"
#include "interp/draw/turntable_renderer.h"
#include "interp/python/arguments.h"
#include "interp/python/camera.h"
#include "interp/python/interrupts.h"
#include "interp/python/pictures.h"
#include "interp/python/system.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

/// The camera for arrays: z is up, unless the camera has another axis.
Camera camera_of_arrays(const py::kwargs& keywords, const Camera& otherwise) {
  Camera camera = camera_in(keywords, otherwise);
  if (std::holds_alternative<UprightBy>(camera.upright)) camera.upright = upright("z");
  return camera;
}

/// The viewer's right, up and back axes in world coordinates, as rows.
glm::dmat3 axes_of(const View& view) { return glm::dmat3(ViewVolume(view).view_plane()); }

/// A system's retained scene as it was at construction, seen from any eye, independent of later
/// changes to the system. Several threads may call it: calls are serialised.
class Views {
 public:
  Views(System& system, const DrawOptions& options) : spare_(system.spare()) {
    system.viewed(aspect_of(options), [&](GraphicsSystem& of, Renderer&) {
      if (of.retained() == nullptr) {
        throw Error(
            "views need world coordinates: expected look(), or System(retain=True), before the "
            "scene is entered");
      }
      if (const auto open = of.open_segment_name()) {
        throw Error(fmt::format("segment {} is open: expected close_segment before views", *open));
      }
      options_ = options_of_views(of, options);
      display_file_ = of.display_file();
      const FollowedView& followed = system.followed();
      scene_ = of.retained()->selected([&](const RetainedScene::Segment& segment) {
        const bool is_visible = display_file_.segment(segment.name).visible;
        leaves_out_ = leaves_out_ || (is_visible && followed.is_beside(segment));
        return is_visible && !followed.is_beside(segment);
      });
      SceneInOneView in_one = scene_in_one_view(scene_, display_file_, of.view());
      as_drawn_ = in_one.view;
      points_ = std::move(in_one.points);
      texts_ = std::move(in_one.texts);
      camera_ = system.followed().camera().value_or(Camera{});
      lights_follow_ = !of.explicit_settings().contains(Setting::light);
      shape_.set_aspect_ratio(of.aspect_ratio());
      shape_.set_viewport(as_drawn_.viewport.x_min, as_drawn_.viewport.x_max,
                          as_drawn_.viewport.y_min, as_drawn_.viewport.y_max);
    });
  }
  Views(const Views&) = delete;
  Views& operator=(const Views&) = delete;

  const Camera& camera() const { return camera_; }
  bool leaves_out() const { return leaves_out_; }  ///< what stands beside the scene
  const DrawOptions& options() const { return options_; }
  const std::shared_ptr<SparePictures>& spare() const { return spare_; }

  Picture draw(const Camera& camera) {
    return without_interpreter([&] {
      const auto in_turn = turn_of(mutex_);
      renderer_.give_back(spare_->take());
      renderer_.draw(from(camera), options_);
      return renderer_.take_picture();
    });
  }
  void draw(const Camera& camera, const Destination& to, const DrawOptions& options) {
    without_interpreter([&] {
      const auto in_turn = turn_of(mutex_);
      renderer_.draw(from(camera), to, options);
    });
  }

 private:
  InView from(const Camera& camera) {
    const RoundToNearest nearest;
    View view = as_drawn_;
    if (!points_.empty()) {
      view = *fitted_view(points_, shape_, camera, {shape_.view(), shape_.explicit_settings()},
                          texts_);
      view.viewport = as_drawn_.viewport;
      view.front_clipping = as_drawn_.front_clipping;
      view.back_clipping = as_drawn_.back_clipping;
    }
    turned_ = glm::transpose(axes_of(view)) * axes_of(as_drawn_);
    return {scene_, display_file_, view, lights_follow_ ? &turned_ : nullptr};
  }

  DisplayFile display_file_;
  RetainedScene scene_;
  View as_drawn_;
  std::vector<Point3> points_;
  std::vector<PlacedText> texts_;
  Camera camera_;
  bool lights_follow_ = false, leaves_out_ = false;
  GraphicsSystem shape_;  // of the pictures
  DrawOptions options_;
  Renderer renderer_;
  glm::dmat3 turned_{1.0};
  std::shared_ptr<SparePictures> spare_;
  std::timed_mutex mutex_;
};

void look(System& self, const py::kwargs& keywords) {
  const Camera camera = camera_of_arrays(keywords, {});
  self.work([&](GraphicsSystem& system, Renderer&) { self.followed().look(system, camera); });
}

py::tuple draw(Views& self, const py::kwargs& keywords) {
  const Camera camera = camera_of_arrays(keywords, self.camera());
  return arrays_of(self.draw(camera), self.options(), self.spare());
}

void save(Views& self, py::handle to, py::handle format, const py::kwargs& keywords) {
  const Camera camera = camera_of_arrays(keywords, self.camera());
  DrawOptions options = self.options();
  if (!format.is_none()) options.format = word_in(format, "format");
  self.draw(camera, path_in(to, "path"), options);
}

}  // namespace

void add_views(py::module_& module, SystemClass& system) {
  py::class_<Views> views(module, "Views", "A scene from any eye.");
  views.def("_draw", draw);
  views.def("_save", save);
  views.def("_leaves_out", &Views::leaves_out);
  system.def("_look", look);
  system.def("_follows", [](System& of) {
    return of.call([&](GraphicsSystem&) { return of.followed().follows(); });
  });
  system.def("_is_view_set", [](System& of) {
    return of.call([](GraphicsSystem& entered) { return FollowedView::is_view_set(entered); });
  });
  system.def("_views", [](System& of, py::handle size, const py::kwargs& keywords) {
    return std::make_unique<Views>(of, draw_options_in(size, keywords));
  });
}

}  // namespace displayfile::python
