#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace displayfile {

/// Base of an object that others observe (displayfile/views/taken_scene.h): they learn its address
/// and its number of edits. An unobserved object has one null pointer more and allocates nothing.
template <class Object>
class Watched {
 public:
  struct Place {
    const Object* object;     ///< current address; null after destruction
    std::uint64_t edits = 0;  ///< other than additions
  };
  /// Several threads may call it at a time, while none changes the object.
  std::shared_ptr<const Place> place() const {
    static std::mutex making;
    const std::lock_guard in_turn(making);
    if (place_ == nullptr) place_ = std::make_shared<Place>(Place{self()});
    return place_;
  }

 protected:
  Watched() = default;
  Watched(const Watched&) {}
  Watched(Watched&& other) noexcept : place_(std::move(other.place_)) {
    if (place_ == nullptr) return;
    place_->object = self();
    edited();
  }
  Watched& operator=(const Watched& other) {
    if (this != &other) edited();
    return *this;
  }
  Watched& operator=(Watched&& other) noexcept {
    edited();
    if (this != &other) other.leave();
    return *this;
  }
  ~Watched() { leave(); }

  void edited() {
    if (place_ != nullptr) ++place_->edits;
  }

 private:
  const Object* self() const { return static_cast<const Object*>(this); }
  /// Detaches all observers.
  void leave() {
    if (place_ != nullptr) place_->object = nullptr;
    place_.reset();
  }

  mutable std::shared_ptr<Place> place_;
};

}  // namespace displayfile
