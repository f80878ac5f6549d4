#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/collected_text.h"
#include "clip/base/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/mesh/followed_view.h"
#include "interp/draw/renderer.h"
#include "interp/python/interrupts.h"

namespace displayfile::python {

/// Memory of pictures whose arrays were destroyed, for reuse: of one picture at most.
class SparePictures {
 public:
  Picture take() {
    const std::lock_guard in_turn(mutex_);
    return std::exchange(spare_, Picture());
  }
  void put(std::vector<std::uint32_t> pixels) {
    const std::lock_guard in_turn(mutex_);
    spare_.pixels = std::move(pixels);
  }

 private:
  std::mutex mutex_;
  Picture spare_;
};

/// The application's system and data cached between its pictures, for several threads: their calls
/// are serialised. Waiting and long work release the interpreter's lock.
class System {
 public:
  /// A call that may take long. It may be repeated after an interrupt.
  template <class Work>
  auto work(Work&& work) {
    return without_interpreter([&] {
      const auto in_turn = turn_of(mutex_);
      return work(system_, renderer_);
    });
  }

  /// A short call that calls nothing in Python: releasing the interpreter's lock would take longer,
  /// if no other thread is working.
  template <class Call>
  auto call(Call&& call) {
    const std::unique_lock in_turn(mutex_, std::try_to_lock);
    if (in_turn.owns_lock()) return call(system_);
    return work([&](GraphicsSystem& system, Renderer&) { return call(system); });
  }

  const std::shared_ptr<SparePictures>& spare() const { return spare_; }

  /// The same for a picture of that aspect ratio, or for another use of the scene: with the view
  /// fitted to it, if the view follows the scene.
  template <class Work>
  auto viewed(std::optional<double> aspect, Work&& work) {
    return this->work([&](GraphicsSystem& system, Renderer& renderer) {
      const double before = system.aspect_ratio();
      try {
        followed_.bring_up_to_date(system, is_aspect_set_ ? std::nullopt : aspect);
        return work(system, renderer);
      } catch (...) {
        restore_aspect(system, before);
        throw;
      }
    });
  }

  /// Must be called within work() or call().
  FollowedView& followed() { return followed_; }
  /// The same: calls run(), which may set the view, and keeps the recording in the views in force
  /// before and after it (FollowedView::running).
  void running(GraphicsSystem& system, bool sets_view, const std::function<void()>& run);

  void set_aspect_ratio(double aspect);
  /// True if the view is fitted to pictures of any shape. Must be called within work() or call().
  bool fits_any_shape() const { return followed_.follows() && !is_aspect_set_; }

  /// Starts or stops recording. The recording is kept.
  void record(bool on) {
    call([&](GraphicsSystem& system) { system.set_recorder(on ? &recorder_ : nullptr); });
  }
  std::string recording() {
    return viewed(std::nullopt, [&](GraphicsSystem&, Renderer&) { return recorded(); });
  }

  /// The data of a view fitted to imported meshes that a turntable needs.
  struct Fitted {
    Point3 axis;     ///< that is up
    bool to_window;  ///< the window was fitted, not an angle of view
  };
  /// Must be called within work() or call(), as set_fitted.
  const std::optional<Fitted>& fitted() const { return fitted_; }
  void set_fitted(const Fitted& fitted) { fitted_ = fitted; }

 private:
  void restore_aspect(GraphicsSystem& system, double aspect) {
    if (system.aspect_ratio() == aspect) return;
    system.set_aspect_ratio(aspect);
    followed_.changed();
  }

  /// The recording so far, with each part in the view that was fitted to it.
  std::string recorded() const;

  CollectedText recording_;
  std::string recorded_before_;  // in views that are no longer followed
  Recorder recorder_{recording_};
  GraphicsSystem system_;
  FollowedView followed_;
  bool is_aspect_set_ = false;
  Renderer renderer_;
  std::optional<Fitted> fitted_;
  std::shared_ptr<SparePictures> spare_ = std::make_shared<SparePictures>();
  std::timed_mutex mutex_;
};

using SystemClass = pybind11::class_<System>;

/// Adds the class, with every user routine under its name, and the methods that enter meshes,
/// surfaces and files.
SystemClass add_system(pybind11::module_& module);
/// Adds the methods that draw and query the drawing.
void add_pictures(SystemClass& system);
/// Adds the views of a turntable.
void add_turntable(pybind11::module_& module, SystemClass& system);
/// The methods that enter surfaces of heights, with lines on them, in pieces.
void add_surfaces(SystemClass& system);
/// Adds the method that enters lines through points.
void add_lines(SystemClass& system);
/// Adds the methods for content beside the scene, such as a colour bar.
void add_beside(SystemClass& system);
/// Adds functions for colours of scalars, and for their triangles.
void add_scalars(pybind11::module_& module);
/// Adds the camera that follows the scene, and views of a retained scene from any eye.
void add_views(pybind11::module_& module, SystemClass& system);

/// The words of a user routine's name as Python writes them.
std::string python_name(std::string_view routine);
/// The same for every routine's name in a sentence.
std::string in_python(std::string_view sentence);

}  // namespace displayfile::python

/// Refuses a System whose __init__ was not called: its memory is allocated but uninitialised.
template <>
class pybind11::detail::type_caster<displayfile::python::System>
    : public type_caster_base<displayfile::python::System> {
 public:
  bool load(handle given, bool convert) {
    const type_info* const known = get_type_info(typeid(displayfile::python::System));
    if (known != nullptr && PyObject_TypeCheck(given.ptr(), known->type) != 0) {
      auto* const object = reinterpret_cast<instance*>(given.ptr());
      if (!object->get_value_and_holder().holder_constructed()) {
        throw displayfile::Error("System: expected its __init__ to have been called");
      }
    }
    return type_caster_base::load(given, convert);
  }
};
