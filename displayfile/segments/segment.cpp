#include "displayfile/segments/segment.h"

namespace displayfile {

/// More may still be entered into an open segment, so its copy has instructions of its own.
Segment::Segment(const Segment& other)
    : visible(other.visible),
      image(other.image),
      put_off(other.put_off),
      name_(other.name_),
      title_(other.title_),
      entered_(other.closed_ ? other.entered_ : std::make_shared<Instructions>(*other.entered_)),
      closed_(other.closed_),
      sorted_(other.sorted_) {}

Segment& Segment::operator=(const Segment& other) {
  if (this != &other) *this = Segment(other);
  return *this;
}

void Segment::make_writable() {
  if (closed_) {
    entered_ = std::make_shared<Instructions>(*entered_);
    closed_ = false;
  }
  sorted_.reset();
}

std::size_t Segment::bytes() const {
  return entered_->bytes() + (sorted_ != nullptr ? sorted_->bytes() : 0);
}

}  // namespace displayfile
