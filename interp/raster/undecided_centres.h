#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/exact/plane.h"
#include "interp/output_device.h"
#include "interp/raster/pixel_shade.h"
#include "interp/scan/pixel_set.h"
#include "interp/scan/scan_convert.h"
#include "interp/visibility/close_planes.h"

namespace displayfile {

// Painting polygons back to front shows what is nearest, except at pixel centres that lie on a
// polygon's boundary, or so close to it that rounding a cut's vertices decides on which side. Those
// centres are noted while painting, and decided afterwards from the polygons as entered
// (interp/raster/undecided_centres.md).

/// How far a polygon's boundary may lie from where it would be had no vertex been rounded, along x
/// and along y; in pixels, with what the tests for closeness lose to rounding. Device coordinates.
Point2 boundary_error(std::span<const Point3> polygon, const PictureSize& size);

/// Adds the centres closer to the polygon's boundary than that in the rows of its vertices: what
/// ScanConverter::watch leaves out, since a side does not cross the rows that it only touches. If
/// the error is not small against a pixel, all centres that the polygon may cover.
void note_rows_of_vertices(std::span<const Point3> polygon, const Point2& error,
                           const PictureSize& size, PixelSet& noted);

/// What is seen at some pixel centres by the definition of truth, exactly: the polygons are
/// entered whole, in the order of entry.
class NearestAtCentres {
 public:
  struct Seen {
    Plane plane;
    FillColour colour;
    std::int32_t pick;
  };
  /// Which of the polygons that cover a centre in one layer is seen.
  enum class Layer {
    nearest,  ///< the nearest, of equally near ones the one entered later
    painted,  ///< the one entered last
  };

  /// Null: no shadows are seen.
  NearestAtCentres(const PixelSet& centres, const PictureSize& size,
                   const Shadows* shadows = nullptr);

  /// The polygons that follow, until the next layer begins, cover those before.
  void begin_layer(Layer layer);

  /// A polygon that is not edge-on, whose depth is that of the plane: its own, or that in which it
  /// lies with others as entered.
  void enter(const DrawnPolygon& polygon, const Plane& plane);

  /// Calls show(row, column, seen) for each centre; seen is null if no polygon covers it.
  template <class Show>
  void show(Show&& show) const {
    std::size_t k = 0;
    centres_.for_each([&](int row, int column) {
      const Owner owner = owner_[k++];
      show(row, column, owner == kNone ? nullptr : &owners_[owner].seen);
    });
  }

 private:
  /// A polygon that is seen at some centre, by its place in owners_.
  using Owner = std::uint32_t;
  static constexpr Owner kNone = ~Owner{0};
  struct Owned {
    Seen seen;
    std::uint32_t layer;
    std::size_t centres;  ///< that it owns; with none its place is free
  };
  struct Run {
    int row, first, end;
  };

  ScanConverter::Region rows_with_centres(std::span<const Point3> polygon) const;
  void enter_run(const Run& run, const Seen& polygon, Owner& own);
  bool is_seen(Owner other, int row, int column);
  Owner take_place(const Seen& polygon);

  const PixelSet& centres_;
  PictureSize size_;
  const Shadows* shadows_;
  std::vector<std::size_t> row_start_;  // of each row's centres in the two that follow
  std::vector<std::int32_t> column_;
  std::vector<Owner> owner_;
  std::vector<Owned> owners_;
  std::vector<Owner> free_;
  Layer layer_ = Layer::nearest;
  std::uint32_t layers_ = 0;
  ScanConverter converter_;

  ClosePlanes close_;  // the one being entered, and what it was last compared with
};

}  // namespace displayfile
