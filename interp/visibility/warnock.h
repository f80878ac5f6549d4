#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "interp/visibility/fill_depths.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/sample_area.h"

namespace displayfile {

/// Warnock's area subdivision: what is seen in a sample area is told at once where that is easy,
/// and otherwise of its quarters, down to a pixel (interp/visibility/warnock.md). 4 bytes a pixel,
/// 64 a fill.
class Warnock : public ImageSpaceMethod {
 public:
  using Fill = ViewedScene::Fill;

  enum class Finish {
    at_pixels,  ///< the books' algorithm
    early       ///< areas that are small, or have few polygons, are not subdivided
  };
  explicit Warnock(Finish finish = Finish::early) : finish_(finish) {}

  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override {
    draw_rows(row_begin, row_end, seen, {});
  }
  /// Every polygon is looked at for each call.
  int rows_at_a_time() const override { return 128; }

  /// A potentially visible polygon, and how it lies to the area: not disjoint.
  struct Listed {
    Fill fill;
    AreaCategory category;
    bool operator==(const Listed&) const = default;
  };
  enum class Decision {
    background,    ///< the list is empty
    surrounded,    ///< by the one polygon of the list
    one_polygon,   ///< scan-converted on the background
    pixel,         ///< the nearest of the list
    few_polygons,  ///< or a small area (Finish::early): all of the list are scan-converted
    subdivided
  };
  /// An area that has been looked at: the potentially visible polygons, in order of entry, that a
  /// surrounding one does not hide, and what that leads to.
  struct Visit {
    SampleArea area;
    std::span<const Listed> list;
    Decision decision;
  };
  /// Draws the rows, and tells of every area visited: each before its parts.
  void draw_rows(int row_begin, int row_end, const SeenRun& seen,
                 const std::function<void(const Visit&)>& watch) const;

 private:
  class Subdivision;

  Finish finish_;
  std::optional<Request> request_;
  FillDepths depths_;
  std::vector<SampleArea> extents_;  // of each fill
};

}  // namespace displayfile
