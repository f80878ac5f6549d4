#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "interp/raster/world_casters.h"

namespace displayfile {

/// For visible polygons of a retained scene while the lights are fixed: the polygons that may hide
/// their light (WorldCasters::find_casters_on), found on first use and kept. Several threads may
/// call it at a time.
class CasterLists {
 public:
  using Primitive = WorldCasters::Primitive;
  /// The length above which a list is no faster than the tree of all casters.
  static constexpr std::size_t kLongest = 24;

  /// For a scene with this many primitives; the casters must outlive this.
  CasterLists(const WorldCasters& casters, std::size_t primitives);

  /// Clears all lists, keeping the memory, for other lights. Must not be called during use by
  /// others.
  void clear();
  /// The list of a polygon whose light comes from that unit direction, the same until cleared; none
  /// if there are too many casters.
  std::optional<std::span<const Primitive>> of(Primitive receiver, const Point3& toward);

  std::size_t made() const { return made_; }  ///< since the beginning
  std::size_t bytes() const;

 private:
  /// The number of casters, or kTooMany; the casters follow it.
  using List = const Primitive*;
  static constexpr Primitive kTooMany = ~Primitive{0};
  static constexpr std::size_t kRoom = 1 << 14;  // of a block
  List enter(Primitive receiver, std::span<const Primitive> list, bool too_many);

  const WorldCasters* casters_;
  std::size_t primitives_;
  std::unique_ptr<std::atomic<List>[]> list_of_;
  std::mutex entering_;
  std::vector<std::unique_ptr<Primitive[]>> blocks_;
  std::size_t blocks_used_ = 0, room_left_ = 0;
  std::size_t made_ = 0;
};

}  // namespace displayfile
