#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace displayfile {

/// An array that grows at its end like a vector. Others may keep a `part` of it, whose elements
/// stay in place and unchanged whatever happens to the array. Elements are written once, before any
/// part has them; one thread may append while others read parts.
template <class T>
class GrowingArray {
 public:
  using value_type = T;
  /// The elements at the time it was taken.
  struct Part {
    std::shared_ptr<const T[]> elements;
    std::size_t size = 0;
    std::span<const T> span() const { return {elements.get(), size}; }
  };

  GrowingArray() = default;
  GrowingArray(const GrowingArray& other) { assign(other); }
  GrowingArray(GrowingArray&& other) noexcept
      : elements_(std::move(other.elements_)),
        size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  GrowingArray& operator=(const GrowingArray& other) {
    if (this != &other) *this = GrowingArray(other);
    return *this;
  }
  GrowingArray& operator=(GrowingArray&& other) noexcept {
    elements_ = std::move(other.elements_);
    size_ = std::exchange(other.size_, 0);
    capacity_ = std::exchange(other.capacity_, 0);
    return *this;
  }
  ~GrowingArray() = default;

  Part part() const { return {elements_, size_}; }

  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }
  const T* data() const { return elements_.get(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  const T& operator[](std::size_t i) const {
    assert(i < size_);
    return data()[i];
  }
  const T& back() const {
    assert(!empty());
    return data()[size_ - 1];
  }

  void push_back(const T& element) {
    if (size_ == capacity_) [[unlikely]] {
      const T copy = element;  // `element` may be in the array
      reserve(std::max<std::size_t>(8, 2 * capacity_));
      elements_.get()[size_++] = copy;
      return;
    }
    elements_.get()[size_++] = element;
  }
  /// `elements` must not be in the array.
  void append(std::span<const T> elements) {
    if (size_ + elements.size() > capacity_) {
      reserve(std::max(size_ + elements.size(), 2 * capacity_));
    }
    std::ranges::copy(elements, elements_.get() + size_);
    size_ += elements.size();
  }
  /// Reserves capacity for this many elements in total.
  void reserve(std::size_t capacity) {
    if (capacity > capacity_) move_to(capacity);
  }
  void shrink_to_fit() {
    if (capacity_ > size_) move_to(size_);
  }

 private:
  void assign(const GrowingArray& other) {
    reserve(other.size_);
    append(other.part().span());
  }
  void move_to(std::size_t capacity) {
    std::shared_ptr<T[]> moved(new T[capacity]);
    std::ranges::copy(*this, moved.get());
    elements_ = std::move(moved);
    capacity_ = capacity;
  }

  std::shared_ptr<T[]> elements_;
  std::size_t size_ = 0, capacity_ = 0;
};

/// Frees an array's spare capacity if it is large, copying the elements.
template <class Array>
void free_room(Array& array) {
  if (array.capacity() - array.size() > array.size() / 32) array.shrink_to_fit();
}

}  // namespace displayfile
