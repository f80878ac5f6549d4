#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/exact/plane.h"
#include "interp/device/output_device.h"
#include "interp/raster/pixel_shade.h"
#include "interp/scan/boundary_centres.h"
#include "interp/scan/pixel_set.h"
#include "interp/scan/scan_convert.h"
#include "interp/visibility/fills_as_entered.h"

namespace displayfile {

// Painting polygons back to front shows the nearest, except at pixel centres on a polygon's
// boundary, or so close to it that rounding a cut's vertices decides the side. These centres are
// recorded while painting, and decided afterwards from the polygons as entered
// (interp/raster/undecided_centres.md).

/// The fill visible at some pixel centres by the definition of truth, exactly: the polygons are
/// entered whole, in order of entry.
class NearestAtCentres {
 public:
  struct Seen {
    Plane plane;
    FillColour colour;
    std::int32_t pick;
  };
  /// The rule for the visible one of a layer's polygons that cover a centre.
  enum class Layer {
    nearest,  ///< the nearest, of equally near ones the one entered later
    painted,  ///< the one entered last
  };

  /// The set and the fills must outlive this. `shadows` may be null: none.
  NearestAtCentres(const PixelSet& centres, const PictureSize& size, FillsAsEntered& fills,
                   const Shadows* shadows = nullptr);

  /// The polygons entered until the next layer begins cover the earlier ones.
  void begin_layer(Layer layer);

  /// Enters a polygon that is a fill of the scene, whose depth is shown as that of the plane: its
  /// own, or the one that it shares with others as entered.
  void enter(const DrawnPolygon& polygon, FillsAsEntered::Fill fill, const Plane& plane);

  /// Calls show(row, column, seen) for each centre; seen is null if no polygon covers it.
  template <class Show>
  void show(Show&& show) const {
    centres_.for_each([&](int row, int column, Owner owner) {
      show(row, column, owner == kNone ? nullptr : &owners_[owner].seen);
    });
  }

 private:
  /// A polygon visible at some centre, by its index in owners_.
  using Owner = NotedCentres::Owner;
  static constexpr Owner kNone = NotedCentres::kNone;
  struct Owned {
    Seen seen;
    FillsAsEntered::Fill fill;
    std::uint32_t layer;
    std::size_t centres;  ///< that it owns; with none its place is free
  };
  struct Run {
    int row, first, end;
  };

  void enter_run(const Run& run, const Seen& polygon, FillsAsEntered::Fill fill, Owner& own);
  bool is_seen(Owner other, FillsAsEntered::Fill fill, int row, int column);
  Owner take_place(const Seen& polygon, FillsAsEntered::Fill fill);

  const PixelSet& set_;
  PictureSize size_;
  FillsAsEntered& fills_;
  const Shadows* shadows_;
  NotedCentres centres_;
  std::vector<Owned> owners_;
  std::vector<Owner> free_;
  Layer layer_ = Layer::nearest;
  std::uint32_t layers_ = 0;
};

}  // namespace displayfile
