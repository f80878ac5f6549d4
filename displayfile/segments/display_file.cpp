#include "displayfile/segments/display_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "clip/base/error.h"

namespace displayfile {

void DisplayFile::require_new_name(int name) const {
  if (name < 1) throw Error(fmt::format("invalid segment name {}: expected 1 or more", name));
  if (!contains(name)) return;
  int largest = name;
  for (const Segment& segment : segments_) largest = std::max(largest, segment.name());
  const bool has_next = largest < std::numeric_limits<int>::max();
  throw Error(fmt::format("segment name {} in use: expected one that is not{}", name,
                          has_next ? fmt::format(", such as {}", largest + 1) : ""));
}

Segment& DisplayFile::create(int name) {
  require_new_name(name);
  sorted_.reset();
  segments_.emplace_back(name);
  numbers_.push_back(next_number_);
  number_of_[name] = next_number_++;
  return segments_.back();
}

void DisplayFile::remove(int name) {
  const auto gap = static_cast<std::ptrdiff_t>(place(name));
  sorted_.reset();
  segments_.erase(segments_.begin() + gap);
  numbers_.erase(numbers_.begin() + gap);
  number_of_.erase(name);
}

void DisplayFile::remove_all() {
  sorted_.reset();
  segments_.clear();
  numbers_.clear();
  number_of_.clear();
}

void DisplayFile::rename(int from, int to) {
  Segment& segment = this->segment(from);
  require_new_name(to);
  number_of_[to] = number_of_[from];
  number_of_.erase(from);
  segment.rename(to);
}

Segment& DisplayFile::segment(int name) {
  if (last_found_ >= segments_.size() || segments_[last_found_].name() != name) {
    last_found_ = place(name);
  }
  sorted_.reset();
  return segments_[last_found_];
}

const Segment& DisplayFile::segment(int name) const { return segments_[place(name)]; }

std::size_t DisplayFile::place(int name) const {
  const auto found = number_of_.find(name);
  if (found == number_of_.end()) throw Error(fmt::format("no segment named {}", name));
  return static_cast<std::size_t>(std::ranges::lower_bound(numbers_, found->second) -
                                  numbers_.begin());
}

std::vector<const Segment*> DisplayFile::visible_segments() const {
  std::vector<const Segment*> visible;
  for (const Segment& segment : segments_) {
    if (segment.visible) visible.push_back(&segment);
  }
  return visible;
}

std::size_t DisplayFile::polygons() const {
  std::size_t n = 0;
  for (const Segment& s : segments_) n += s.polygons();
  return n;
}

std::size_t DisplayFile::bytes() const {
  std::size_t n = 0;
  for (const Segment& s : segments_) n += s.bytes();
  return sorted_ != nullptr ? n + sorted_->bytes() : n;
}

bool DisplayFile::has_shadows() const {
  return std::ranges::any_of(
      segments_, [](const Segment& segment) { return segment.visible && segment.has_shadows(); });
}

bool DisplayFile::has_annotations() const {
  return std::ranges::any_of(segments_, [](const Segment& segment) {
    return segment.visible && segment.has_annotations();
  });
}

bool DisplayFile::has_texts() const {
  return std::ranges::any_of(
      segments_, [](const Segment& segment) { return segment.visible && segment.has_texts(); });
}

}  // namespace displayfile
