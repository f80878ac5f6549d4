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
  bool has_shadows() const;      ///< some fill of a visible segment shows them
  bool has_texts() const;        ///< some visible segment has them

  /// All visible segments sorted together, back to front, points after the image
  /// transformations: drawn in place of the segments' own orders. Null if they were not, or if a
  /// segment was created, removed, renamed or asked for to be changed since.
  const std::shared_ptr<const SortedScene>& sorted() const { return sorted_; }
  void set_sorted(std::shared_ptr<const SortedScene> sorted) { sorted_ = std::move(sorted); }

 private:
  void require_new_name(int name) const;
  std::size_t place(int name) const;

  // A segment keeps its number in order of creation when others go, and is found by it. To remove
  // the oldest or the newest takes no longer where there are many.
  std::deque<Segment> segments_;
  std::deque<std::uint64_t> numbers_;
  std::uint64_t next_number_ = 0;
  std::unordered_map<int, std::uint64_t> number_of_;  // by name
  std::size_t last_found_ = 0;  // primitives are entered into one segment after another
  std::shared_ptr<const SortedScene> sorted_;
};

}  // namespace displayfile
