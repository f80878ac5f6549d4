#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "interp/scan/scan_edge.h"
#include "interp/visibility/close_depths.h"
#include "interp/visibility/fill_depths.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

/// The lecture's edge table and active edge list (section 4) of all polygons together, row by row
/// from the bottom. Crossings are found exactly (interp/scan/scan_edge.h), by one product from an
/// edge's lower end instead of a sum along it.
class ActiveEdgeList {
 public:
  using Fill = ViewedScene::Fill;

  struct Edge {
    ScanEdge edge;
    Fill fill;
    int column;  ///< the first whose centre is at or right of the crossing
    double x;    ///< of the crossing in pixels, rounded
  };

  /// The edges that cross rows row_begin <= row < row_end.
  ActiveEdgeList(const ViewedScene& scene, const PictureSize& size, int row_begin, int row_end)
      : size_(size) {
    std::vector<ScanEdge> edges;
    for (Fill fill = ViewedScene::kBackground + 1; fill < scene.end(); ++fill) {
      edges.clear();
      append_edges(scene.vertices(fill).row(), size, row_begin, row_end, edges);
      for (const ScanEdge& edge : edges) table_.push_back({edge, fill, 0, 0.0});
    }
    std::ranges::stable_sort(table_, {}, [](const Edge& e) { return e.edge.first_row; });
  }

  /// The list's changes on the way to a row.
  struct Change {
    std::size_t entered, left;
  };
  /// Advances to a row; rows must be increasing.
  Change go_to(int row) {
    const std::size_t left =
        std::erase_if(active_, [&](const Edge& e) { return e.edge.last_row < row; });
    const std::size_t first = next_;
    while (next_ < table_.size() && table_[next_].edge.first_row <= row) {
      active_.push_back(table_[next_++]);
    }
    for (Edge& e : active_) {
      e.column = e.edge.column(row, size_);
      e.x = e.edge.x + (row + 0.5 - e.edge.y) * e.edge.dx_dy;
    }
    std::ranges::stable_sort(active_, [](const Edge& a, const Edge& b) {
      return a.column != b.column ? a.column < b.column : a.x < b.x;
    });
    return {next_ - first, left};
  }

  std::span<const Edge> edges() const { return active_; }  ///< from left to right
  std::size_t to_come() const { return table_.size() - next_; }

 private:
  PictureSize size_;
  std::vector<Edge> table_;  // by first row
  std::size_t next_ = 0;
  std::vector<Edge> active_;
};

/// The spanning scan line in the books' form, for reading, for showing step by step, and for
/// checking the fast form (interp/visibility/scan_line.md): the lecture's section 4 with its
/// crossovers, the problem book's section 10.5 with its flags IN and OUT. Depths are compared as in
/// all exact methods; with a ROUNDOFF as the textbook's SIGNOF does.
class PlainScanLine : public ImageSpaceMethod {
 public:
  using Fill = ViewedScene::Fill;

  void prepare(const Request& request, int /*threads*/) override {
    request_.emplace(request);
    depths_ = FillDepths(request.scene, request.size, request.roundoff);
  }
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override {
    Unobserved observer;
    draw_rows(row_begin, row_end, seen, observer);
  }
  /// Each call makes an edge table.
  int rows_at_a_time() const override { return 64; }

  /// A run of pixels of one row that shows one fill, or the background.
  struct Span {
    int row, first, end;
    Fill seen;
    std::span<const Fill> in;           ///< the polygons that are IN, in order of entry
    std::size_t first_edge, end_edge;   ///< those active edges at which it begins
    std::optional<Fill> passed;         ///< it begins where `seen` passes this one
    std::optional<Fill> passes_at_end;  ///< it ends where this one passes `seen`
  };
  /// The interface of an observer of the algorithm; this one does nothing.
  struct Unobserved {
    static void table(const ActiveEdgeList& /*edges*/) {}
    static void begin_row(int /*row*/, const ActiveEdgeList& /*edges*/,
                          const ActiveEdgeList::Change& /*change*/) {}
    static void paint(const Span& /*span*/) {}
    static void end_row(int /*row*/) {}
  };
  template <class Observer>
  void draw_rows(int row_begin, int row_end, const SeenRun& seen, Observer& observer) const {
    ActiveEdgeList edges(request_->scene, request_->size, row_begin, row_end);
    Row<Observer> line{*request_, CloseDepths(request_->scene, depths_, request_->size), observer};
    observer.table(edges);
    for (int row = row_begin; row < row_end; ++row) {
      const ActiveEdgeList::Change change = edges.go_to(row);
      observer.begin_row(row, edges, change);
      seen(row, 0, line.sweep(row, edges.edges()));
      observer.end_row(row);
    }
  }

 private:
  /// The sweep along a row.
  template <class Observer>
  class Row {
   public:
    Row(const Request& request, CloseDepths depths, Observer& observer)
        : depths_(std::move(depths)),
          observer_(observer),
          seen_(static_cast<std::size_t>(request.size.width)) {}

    std::span<const Fill> sweep(int row, std::span<const ActiveEdgeList::Edge> edges) {
      const int width = static_cast<int>(seen_.size());
      std::ranges::fill(seen_, ViewedScene::kBackground);
      row_ = row;
      in_.clear();
      for (std::size_t k = 0; k < edges.size();) {
        const int column = edges[k].column;
        const std::size_t first = k;
        for (; k < edges.size() && edges[k].column == column; ++k) turn(edges[k].fill);
        const int end = k < edges.size() ? edges[k].column : width;
        if (column < end) paint(column, end, first, k);
      }
      return seen_;
    }

   private:
    /// Toggles a polygon's flag, IN or OUT.
    void turn(Fill fill) {
      const auto place = std::ranges::lower_bound(in_, fill);
      if (place != in_.end() && *place == fill) {
        in_.erase(place);
      } else {
        in_.insert(place, fill);
      }
    }

    /// Paints from some active edges to the next: the background if no polygon is IN, the polygon
    /// if one is, and of several the nearest, up to where another passes it.
    void paint(int column, int end, std::size_t first_edge, std::size_t end_edge) {
      Span span{row_, column, end, ViewedScene::kBackground, in_, first_edge, end_edge, {}, {}};
      if (in_.empty()) return observer_.paint(span);
      for (; span.first < end; span.first = span.end) {
        if (span.first > column) span.passed = span.seen;
        span.seen = nearest_at(span.first);
        span.end = end;
        span.passes_at_end.reset();
        for (const Fill other : in_) {
          const int crossover = passes(other, span.seen, span.first, end);
          if (crossover >= span.end) continue;
          span.end = crossover;
          span.passes_at_end = other;
        }
        std::fill(seen_.begin() + span.first, seen_.begin() + span.end, span.seen);
        observer_.paint(span);
      }
    }

    Fill nearest_at(int column) {
      Fill nearest = in_.front();
      for (const Fill fill : in_) {
        if (fill != nearest && depths_.hides(fill, nearest, column, row_)) nearest = fill;
      }
      return nearest;
    }

    /// The first column after `column` at which the other hides the visible one; the end if there
    /// is none. The lecture divides the difference of the depths by that of their slopes. Along a
    /// row a plane passes another at most once, so bisection finds the same column, without
    /// rounding.
    int passes(Fill other, Fill seen, int column, int end) {
      int hides = end - 1, hides_not = column;
      if (other == seen || hides == column || !depths_.hides(other, seen, hides, row_)) return end;
      while (hides - hides_not > 1) {
        const int middle = (hides + hides_not) / 2;
        (depths_.hides(other, seen, middle, row_) ? hides : hides_not) = middle;
      }
      return hides;
    }

    CloseDepths depths_;
    Observer& observer_;
    int row_ = 0;
    std::vector<Fill> in_;
    std::vector<Fill> seen_;
  };

  std::optional<Request> request_;
  FillDepths depths_;
};

}  // namespace displayfile
