#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

#include "clip/base/watched.h"
#include "displayfile/segments/segment.h"

namespace displayfile {

/// The display file: the segments, in order of creation. Copies share the instructions of closed
/// segments.
class DisplayFile : public Watched<DisplayFile> {
 public:
  /// Throws Error if the name is not positive or in use.
  Segment& create(int name);
  /// Throws Error if there is no such segment.
  void remove(int name);
  void remove_all();
  /// Throws Error if there is no `from`, or `to` is not positive or in use.
  void rename(int from, int to);

  /// Throws Error if there is no such segment.
  Segment& segment(int name);
  const Segment& segment(int name) const;
  bool contains(int name) const { return number_of_.contains(name); }

  const std::deque<Segment>& segments() const { return segments_; }
  /// The visible segments in order of creation; valid until a segment is created or removed.
  std::vector<const Segment*> visible_segments() const;
  std::size_t polygons() const;  ///< as entered
  std::size_t bytes() const;     ///< of the instruction arrays, as used
  bool has_shadows() const;      ///< a fill of a visible segment shows shadows
  bool has_texts() const;        ///< a visible segment has texts
  bool has_annotations() const;  ///< or annotation

  /// All visible segments sorted together, back to front, points after the image transformations;
  /// drawn instead of the segments' own orders. Null if they were not sorted, or if a segment was
  /// created, removed, renamed or accessed for changes since.
  const std::shared_ptr<const SortedScene>& sorted() const { return sorted_; }
  void set_sorted(std::shared_ptr<const SortedScene> sorted) { sorted_ = std::move(sorted); }

 private:
  void require_new_name(int name) const;
  std::size_t place(int name) const;

  // A segment keeps its number, by which it is found, when others are removed. Removing the oldest
  // or newest takes constant time.
  std::deque<Segment> segments_;
  std::deque<std::uint64_t> numbers_;
  std::uint64_t next_number_ = 0;
  std::unordered_map<int, std::uint64_t> number_of_;  // by name
  std::size_t last_found_ = 0;                        // one segment is usually used repeatedly
  std::shared_ptr<const SortedScene> sorted_;
};

}  // namespace displayfile
