#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "clip/base/error.h"
#include "interp/draw/turntable_renderer.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"
#include "interp/python/interrupts.h"
#include "interp/python/pictures.h"
#include "interp/python/system.h"

namespace displayfile::python {

namespace py = pybind11;

namespace {

/// Views of a system's retained scene as it was at construction, independent of later changes to
/// the system. Several threads may call it: calls are serialised.
class Turntable {
 public:
  Turntable(System& system, const TurntableViews& views, const DrawOptions& options)
      : spare_(system.spare()) {
    system.viewed(aspect_of(options), [&](GraphicsSystem& of, Renderer&) {
      if (of.retained() == nullptr) {
        throw Error(
            "a turntable needs world coordinates: expected System(retain=True) before the scene is "
            "entered");
      }
      if (const auto open = of.open_segment_name()) {
        throw Error(
            fmt::format("segment {} is open: expected close_segment before a turntable", *open));
      }
      display_file_ = of.display_file();
      scene_ = of.retained()->visible_in(display_file_);
      renderer_.emplace(of, scene_, display_file_, views, options);
    });
  }
  Turntable(const Turntable&) = delete;
  Turntable& operator=(const Turntable&) = delete;

  template <class Work>
  auto work(Work&& work) {
    return without_interpreter([&] {
      const auto in_turn = turn_of(mutex_);
      return work(*renderer_);
    });
  }

  int views() const { return renderer_->views(); }
  const DrawOptions& options() const { return renderer_->options(); }
  const std::shared_ptr<SparePictures>& spare() const { return spare_; }

 private:
  DisplayFile display_file_;
  RetainedScene scene_;
  std::optional<TurntableRenderer> renderer_;  // of both
  std::shared_ptr<SparePictures> spare_;
  std::timed_mutex mutex_;
};

Point3 axis_in(py::handle value, std::string_view what) {
  const std::vector<double> axis = numbers_in(value, what);
  if (axis.size() != 3) {
    throw Error(fmt::format("{}: expected x, y and z, not {} numbers", what, axis.size()));
  }
  const Point3 direction{axis[0], axis[1], axis[2]};
  if (direction == Point3(0.0)) throw Error(fmt::format("{}: expected a length above 0", what));
  return direction;
}

/// Parameters of the views that the keywords do not set are those fitted to imported meshes.
TurntableViews views_in(System& system, py::handle number, py::handle axis, py::handle fit) {
  TurntableViews views{whole_number_in(number, "views")};
  require_turntable_views(views.number);
  const auto followed = system.call([&](GraphicsSystem&) { return system.followed().camera(); });
  if (followed) {
    views.axis = std::get<Upright>(followed->upright).up;
    views.fit_window = followed->fit && !followed->angle_of_view;
  } else if (const auto fitted = system.call([&](GraphicsSystem&) { return system.fitted(); })) {
    views.axis = fitted->axis;
    views.fit_window = fitted->to_window;
  }
  if (!axis.is_none()) views.axis = axis_in(axis, "axis");
  if (!fit.is_none()) views.fit_window = switch_in(fit, "fit");
  return views;
}

std::unique_ptr<Turntable> turntable(System& system, py::handle views, py::handle size,
                                     py::handle axis, py::handle fit, const py::kwargs& keywords) {
  const DrawOptions options = draw_options_in(size, keywords);
  return std::make_unique<Turntable>(system, views_in(system, views, axis, fit), options);
}

/// Throws the Errors of turntable that do not depend on the scene.
void require_turned(System& system, py::handle views, py::handle size, py::handle axis,
                    py::handle fit, const py::kwargs& keywords) {
  require_turntable_method(draw_options_in(size, keywords));
  views_in(system, views, axis, fit);
}

py::tuple draw(Turntable& self, py::handle which) {
  const int view = whole_number_in(which, "view");
  Picture picture = self.work([&](TurntableRenderer& renderer) {
    renderer.give_back(self.spare()->take());
    return renderer.draw(view);
  });
  return arrays_of(std::move(picture), self.options(), self.spare());
}

void save(Turntable& self, py::handle which, py::handle to) {
  const int view = whole_number_in(which, "view");
  const std::string path = path_in(to, "path");
  self.work([&](TurntableRenderer& renderer) { renderer.draw_numbered(view, path); });
}

py::str numbered_path(py::handle path, int number, int all) {
  const std::string name = numbered(path_in(path, "path"), number, all).string();
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeFSDefault(name.c_str()));
}

void require_drawable(Turntable& self, py::handle first, py::handle end, py::handle to) {
  const TurntableViews views{self.views(), whole_number_in(first, "views"),
                             whole_number_in(end, "views")};
  const std::string path = path_in(to, "path");
  if (views.first < 0 || views.end <= views.first || views.end > views.number) {
    throw Error(fmt::format("views {} up to {}: expected some of the turntable's {}", views.first,
                            views.end, views.number));
  }
  self.work([&](TurntableRenderer& renderer) {
    require_views_drawable(views, path, renderer.options());
  });
}

}  // namespace

void add_turntable(py::module_& module, SystemClass& system) {
  py::class_<Turntable> views(module, "Turntable", "The views of a scene that turns.");
  views.def("_draw", draw);
  views.def("_save", save);
  views.def("_require_drawable", require_drawable);
  views.def("_views", &Turntable::views);
  module.def("_numbered", numbered_path);
  system.def("_turntable", turntable);
  system.def("_require_turned", require_turned);
}

}  // namespace displayfile::python
