#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/entered_outline.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/scan/boundary_centres.h"
#include "interp/scan/pixel_set.h"
#include "interp/scan/scan_convert.h"
#include "interp/visibility/depths_as_entered.h"
#include "interp/visibility/pair_orders.h"

namespace displayfile {

/// Largest distance of a scene polygon's boundary from the boundary as entered, along x and y, in
/// pixels, including the errors of the tests for closeness.
Point2 boundary_error(const ViewedScene& scene, std::span<const Point3> polygon,
                      const PictureSize& size);

/// Adds the centres in the set's rows that are so close to the fill's boundary. The converter is
/// working memory.
void note_boundary(const ViewedScene& scene, ViewedScene::Fill fill, const PictureSize& size,
                   ScanConverter& converter, PixelSet& noted);

/// The fills of a scene at some pixel centres, by the entered data
/// (interp/visibility/fills_as_entered.md): the centres that a fill covers, and which of two is
/// visible. Viewing rounds, so close to a boundary, or to an intersection of planes, the scene's
/// coordinates may differ. For one thread.
class FillsAsEntered {
 public:
  using Fill = ViewedScene::Fill;

  FillsAsEntered(const ViewedScene& scene, const PictureSize& size);

  /// True if viewing rounded the scene's coordinates.
  bool are_rounded() const { return scene_.viewing_radius() > 0.0; }

  /// Calls fill_span(row, first, end) for runs of covered pixels of the region. The coverage of
  /// noted centres is that as entered.
  template <class FillSpan>
  void scan(Fill fill, const ScanConverter::Region& region, const PixelSet& noted,
            FillSpan&& fill_span) {
    if (!is_close(fill, region, noted)) {
      for (const Run& run : runs_) fill_span(run.row, run.first, run.end);
    } else {
      OutlineRows(outline_, size_).scan(region.row_begin, region.row_end, fill_span);
    }
  }

  /// True if the later of two fills is visible at a centre that both cover.
  bool later_is_seen(Fill earlier, Fill later, int column, int row) {
    return orders_.later_is_seen(earlier, later, PixelCentre(column, row, size_));
  }

  /// Calls show(row, column, fill) for each of the centres, with the visible fill: one of the given
  /// fills, which are in order of entry, or the background.
  template <class Show>
  void decide(const PixelSet& centres, std::span<const Fill> fills, Show&& show);
  /// The same for all fills of the scene.
  template <class Show>
  void decide(const PixelSet& centres, Show&& show);

 private:
  struct Run {
    int row, first, end;
  };
  bool is_close(Fill fill, const ScanConverter::Region& region, const PixelSet& noted);
  bool is_close_to_vertices(std::span<const Point3> polygon, const Point2& error,
                            const PixelSet& noted) const;
  void enter(Fill fill, const PixelSet& centres, NotedCentres& noted);

  const ViewedScene& scene_;
  PictureSize size_;
  ProjectionsAsEntered views_;
  PairOrders orders_;
  ScanConverter converter_;
  std::vector<Run> runs_;
  EnteredOutline outline_;
};

template <class Show>
void FillsAsEntered::decide(const PixelSet& centres, std::span<const Fill> fills, Show&& show) {
  NotedCentres noted(centres, size_);
  for (const Fill fill : fills) enter(fill, centres, noted);
  noted.for_each([&](int row, int column, NotedCentres::Owner owner) {
    show(row, column, owner == NotedCentres::kNone ? ViewedScene::kBackground : owner);
  });
}

template <class Show>
void FillsAsEntered::decide(const PixelSet& centres, Show&& show) {
  NotedCentres noted(centres, size_);
  for (Fill fill = 1; fill < scene_.end(); ++fill) enter(fill, centres, noted);
  noted.for_each([&](int row, int column, NotedCentres::Owner owner) {
    show(row, column, owner == NotedCentres::kNone ? ViewedScene::kBackground : owner);
  });
}

}  // namespace displayfile
