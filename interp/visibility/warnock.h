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
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;
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
  /// What is told of a subdivision while it goes on; whatever is set. Where nothing is asked for,
  /// nothing of it is compiled.
  struct Observer {
    std::function<void(const Visit&)> visit = {};  ///< an area, before its parts
    /// A polygon is hidden all over the area that is visited next, by one that surrounds it.
    std::function<void(Fill hidden, Fill by)> remove = {};
    std::function<void(const SampleArea&)> part =
        {};  ///< one that the area visited is divided into
    /// Pixels first <= i < end of a row that come to show a fill.
    std::function<void(Fill fill, int row, int first, int end)> paint = {};
  };
  void draw_rows(int row_begin, int row_end, const SeenRun& seen, const Observer& observer) const;

 private:
  struct Unobserved {
    static void visit(const Visit& /*visited*/) {}
    static void remove(Fill /*hidden*/, Fill /*by*/) {}
    static void part(const SampleArea& /*area*/) {}
    static void paint(Fill /*fill*/, int /*row*/, int /*first*/, int /*end*/) {}
  };
  struct Told;
  template <class Watch>
  class Subdivision;
  template <class Watch>
  void subdivide(int row_begin, int row_end, const SeenRun& seen, const Watch& watch) const;

  Finish finish_;
  std::optional<Request> request_;
  FillDepths depths_;
  std::vector<SampleArea> extents_;  // of each fill
};

}  // namespace displayfile
