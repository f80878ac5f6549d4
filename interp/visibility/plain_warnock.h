#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interp/scan/scan_convert.h"
#include "interp/visibility/close_depths.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/sample_area.h"

namespace displayfile {

/// Warnock's area subdivision in the books' form, down to pixels, for reading, for showing step by
/// step, and for checking the form that finishes early (interp/visibility/warnock.md): the
/// textbook's chapter 9, "Warnock's algorithm", with the categories, lists and tests (a) to (d) of
/// the problem book's section 10.6. Depths are compared as in all exact methods; with a ROUNDOFF as
/// the textbook's SIGNOF does.
class PlainWarnock : public ImageSpaceMethod {
 public:
  using Fill = ViewedScene::Fill;

  void prepare(const Request& request, int /*threads*/) override {
    request_.emplace(request);
    depths_ = FillDepths(request.scene, request.size, request.roundoff);
    extents_.assign(request.scene.end(), {});
    for (Fill fill = 1; fill < request.scene.end(); ++fill) {
      extents_[fill] = extents_of(request.scene.vertices(fill), request.size);
    }
  }
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override {
    Unobserved observer;
    draw_rows(row_begin, row_end, seen, observer);
  }
  /// Each call examines every polygon.
  int rows_at_a_time() const override { return 128; }

  /// A potentially visible polygon, and its category for the area: not disjoint.
  struct Listed {
    Fill fill;
    AreaCategory category;
    bool operator==(const Listed&) const = default;
  };
  enum class Decision {
    background,   ///< (a) the list is empty
    one_polygon,  ///< (b) it does not surround the area: scan-converted on the background
    surrounded,   ///< (c) by the one polygon of the list
    pixel,        ///< (d) the nearest of the list
    subdivided
  };
  /// A visited area: the potentially visible polygons, in order of entry, that no surrounding one
  /// hides, and the resulting decision.
  struct Visit {
    SampleArea area;
    std::span<const Listed> list;
    Decision decision;
  };
  /// The interface of an observer of the algorithm; this one does nothing.
  struct Unobserved {
    /// In the area visited next, a polygon is hidden everywhere by one that surrounds the area.
    static void remove(Fill /*hidden*/, Fill /*by*/) {}
    static void visit(const Visit& /*visited*/) {}   ///< an area, before its parts
    static void part(const SampleArea& /*area*/) {}  ///< of the area visited
    /// Pixels first <= i < end of a row in which a fill becomes visible.
    static void paint(Fill /*fill*/, int /*row*/, int /*first*/, int /*end*/) {}
  };
  template <class Observer>
  void draw_rows(int row_begin, int row_end, const SeenRun& seen, Observer& observer) const {
    Subdivision<Observer> subdivision(*this, {0, request_->size.width, row_begin, row_end},
                                      observer);
    subdivision.run();
    subdivision.tell(seen);
  }

 private:
  template <class Observer>
  class Subdivision {
   public:
    Subdivision(const PlainWarnock& warnock, const SampleArea& screen, Observer& observer)
        : scene_(warnock.request_->scene),
          size_(warnock.request_->size),
          extents_(warnock.extents_),
          screen_(screen),
          depths_(scene_, warnock.depths_, size_),
          seen_(
              static_cast<std::size_t>(screen.columns()) * static_cast<std::size_t>(screen.rows()),
              ViewedScene::kBackground),
          observer_(observer) {}

    void run() {
      std::vector<Listed> all;
      for (Fill fill = 1; fill < scene_.end(); ++fill) {
        all.push_back({fill, AreaCategory::intersecting});
      }
      stack_.push_back({screen_, std::move(all)});
      while (!stack_.empty()) {
        const auto [area, of_parent] = std::move(stack_.back());
        stack_.pop_back();
        std::vector<Listed> list = list_of(area, of_parent);
        if (!is_pixel(area)) remove_hidden(area, list);
        const Decision decision = decide(area, list);
        observer_.visit({area, list, decision});
        switch (decision) {
          case Decision::background: break;
          case Decision::one_polygon: scan_convert(list[0].fill, area); break;
          case Decision::surrounded: fill(list[0].fill, area); break;
          case Decision::pixel: fill(*nearest_surrounding(area, list), area); break;
          case Decision::subdivided: subdivide(area, list); break;
        }
      }
    }

    void tell(const SeenRun& seen) const {
      for (int row = screen_.first_row; row < screen_.end_row; ++row) {
        seen(row, 0,
             std::span(seen_).subspan(place(row, 0), static_cast<std::size_t>(size_.width)));
      }
    }

   private:
    /// An area still to be visited, and the list of its parent area.
    struct Waiting {
      SampleArea area;
      std::vector<Listed> of_parent;
    };

    /// A polygon that surrounds the parent area surrounds this one too; the others are classified
    /// again.
    std::vector<Listed> list_of(const SampleArea& area, std::span<const Listed> of_parent) const {
      std::vector<Listed> list;
      for (auto [fill, category] : of_parent) {
        if (category != AreaCategory::surrounding) {
          category = category_of(scene_.vertices(fill), extents_[fill], area, size_);
        }
        if (category != AreaCategory::disjoint) list.push_back({fill, category});
      }
      return list;
    }

    /// The polygon visible in the middle of the area, among those that surround it.
    std::optional<Fill> nearest_surrounding(const SampleArea& area, std::span<const Listed> list) {
      const int column = area.first_column + area.columns() / 2;
      const int row = area.first_row + area.rows() / 2;
      std::optional<Fill> nearest;
      for (const auto& [fill, category] : list) {
        if (category != AreaCategory::surrounding) continue;
        if (!nearest || depths_.hides(fill, *nearest, column, row)) nearest = fill;
      }
      return nearest;
    }

    void remove_hidden(const SampleArea& area, std::vector<Listed>& list) {
      const std::optional<Fill> nearest = nearest_surrounding(area, list);
      if (!nearest) return;
      std::erase_if(list, [&](const Listed& listed) {
        const bool hidden =
            listed.fill != *nearest &&
            hides_over(*nearest, listed.fill, intersection(area, extents_[listed.fill]));
        if (hidden) observer_.remove(listed.fill, *nearest);
        return hidden;
      });
    }

    /// The difference of two planes' depths is linear: its sign at the corners holds between them.
    bool hides_over(Fill a, Fill b, const SampleArea& area) {
      const int left = area.first_column, right = area.end_column - 1;
      const int bottom = area.first_row, top = area.end_row - 1;
      return depths_.hides(a, b, left, bottom) && depths_.hides(a, b, right, bottom) &&
             depths_.hides(a, b, left, top) && depths_.hides(a, b, right, top);
    }

    /// The problem book's tests.
    static Decision decide(const SampleArea& area, std::span<const Listed> list) {
      if (list.empty()) return Decision::background;
      if (list.size() == 1) {
        return list[0].category == AreaCategory::surrounding ? Decision::surrounded
                                                             : Decision::one_polygon;
      }
      return is_pixel(area) ? Decision::pixel : Decision::subdivided;
    }

    /// Divides an area into quarters, or into halves if it is more than twice as long as wide, so
    /// that areas approach squares. The quarter at the bottom left comes first.
    void subdivide(const SampleArea& area, const std::vector<Listed>& list) {
      const auto [left, right, bottom, top] = area;
      const long long columns = area.columns(), rows = area.rows();
      const int column = columns > 1 && 2 * columns >= rows ? left + area.columns() / 2 : right;
      const int row = rows > 1 && 2 * rows >= columns ? bottom + area.rows() / 2 : top;
      for (const SampleArea& part :
           {SampleArea{column, right, row, top}, SampleArea{left, column, row, top},
            SampleArea{column, right, bottom, row}, SampleArea{left, column, bottom, row}}) {
        if (part.empty()) continue;
        stack_.push_back({part, list});
        observer_.part(part);
      }
    }

    void scan_convert(Fill fill, const SampleArea& area) {
      converter_.scan_convert(scene_.vertices(fill), {size_, area.first_row, area.end_row},
                              [&](int row, int first, int end) {
                                paint(fill, row, std::max(first, area.first_column),
                                      std::min(end, area.end_column));
                              });
    }
    void fill(Fill fill, const SampleArea& area) {
      for (int row = area.first_row; row < area.end_row; ++row) {
        paint(fill, row, area.first_column, area.end_column);
      }
    }
    void paint(Fill fill, int row, int first, int end) {
      if (first >= end) return;
      std::fill_n(seen_.begin() + static_cast<std::ptrdiff_t>(place(row, first)), end - first,
                  fill);
      observer_.paint(fill, row, first, end);
    }
    std::size_t place(int row, int column) const {
      return static_cast<std::size_t>(row - screen_.first_row) *
                 static_cast<std::size_t>(size_.width) +
             static_cast<std::size_t>(column);
    }

    const ViewedScene& scene_;
    PictureSize size_;
    std::span<const SampleArea> extents_;
    SampleArea screen_;  // all that is drawn
    CloseDepths depths_;
    std::vector<Waiting> stack_;
    std::vector<Fill> seen_;  // of the screen's pixels, row by row
    ScanConverter converter_;
    Observer& observer_;
  };

  std::optional<Request> request_;
  FillDepths depths_;
  std::vector<SampleArea> extents_;  // of each fill
};

}  // namespace displayfile
