#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "interp/steps/active_edges.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_record.h"

namespace displayfile {

namespace {

/// The spanning scan line, with the problem book's IN and OUT flags and the lecture's crossovers.
/// The lecture divides the depths' difference by that of their slopes to find a crossover; here the
/// same column is found by comparing the planes, so that no rounding decides.
class ScanLineSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"table", 0, "put the edges of all polygons into an edge table, by their lowest row"},
      {"row", 0, "for each row, from the bottom up:"},
      {"", 1, "strike off the edges that end below it, link in those that begin"},
      {"", 1, "find where each crosses the row, and order them from left to right"},
      {"", 1, "for each active edge, in this order:"},
      {"", 2, "turn its polygon's flag, IN or OUT"},
      {"none", 2, "no polygon is IN: the background up to the next edge"},
      {"one", 2, "one is IN: it is seen up to the next edge"},
      {"nearest", 2, "more are IN: the nearest here is seen, up to the next edge"},
      {"crossover", 3, "or up to where another passes it: change over there"},
      {"done", 1, "the row is done; no pixel was painted twice"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"edges", "Active edge list", PanelEntry::Kind::table, ActiveEdges::kColumns},
      {"in", "Polygons that are IN", PanelEntry::Kind::list},
      {"depths", "The row from above: up is toward the viewer", PanelEntry::Kind::profile},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  ScanLineSteps(const StepScene& scene, StepRecord& record)
      : scene_(scene), record_(record), edges_(scene) {}

  void run() {
    record_.step(at("table"),
                 fmt::format("The edge table has {}.", counted(edges_.to_come(), "edge")));
    for (int row = 0; row < scene_.size().height; ++row) {
      const auto [entered, left] = edges_.go_to(row);
      if (edges_.edges().empty() && left == 0) continue;
      begin_row(row, entered, left);
      sweep(row);
      record_.step(at("done"), fmt::format("Row {} is done.", row));
      record_.mark(StepRole::active, PixelBox{0, scene_.size().width, row, row + 1});
      record_.show(panel("in"), {});
    }
  }

 private:
  using Polygon = StepScene::Polygon;

  void begin_row(int row, std::size_t entered, std::size_t left) {
    record_.step(at("row"), fmt::format("Row {}: {} linked in, {} struck off, {} active.", row,
                                        counted(entered, "edge"), left, edges_.edges().size()));
    record_.mark(StepRole::active, PixelBox{0, scene_.size().width, row, row + 1});
    mark_edges(record_, edges_);
    record_.show(panel("edges"), edges_.rows(record_));
    record_.show(panel("in"), {});
    runs_ = edges_.runs(row);
    record_.show_segments(panel("depths"), profile_of(scene_, runs_));
  }

  void sweep(int row) {
    in_.clear();
    const auto& edges = edges_.edges();
    for (std::size_t k = 0; k < edges.size();) {
      const int column = edges[k].column;
      const std::size_t first = k;
      for (; k < edges.size() && edges[k].column == column; ++k) turn(edges[k].polygon);
      const int end = k < edges.size() ? edges[k].column : scene_.size().width;
      if (column < end) paint_span(row, column, end, first, k);
    }
  }

  void turn(Polygon polygon) {
    const auto place = std::ranges::lower_bound(in_, polygon);
    if (place != in_.end() && *place == polygon) {
      in_.erase(place);
    } else {
      in_.insert(place, polygon);
    }
  }

  /// What is seen from the edges first <= k < last of the list to the next one.
  void paint_span(int row, int column, int end, std::size_t first, std::size_t last) {
    if (in_.empty()) {
      if (end == scene_.size().width) return;
      record_.step(at("none"),
                   fmt::format("Columns {} to {}: no polygon is IN, the background is seen.",
                               column, end - 1));
      mark_span(row, column, end, StepRecord::kBackground, first, last);
      return;
    }
    for (Polygon before = StepRecord::kBackground; column < end;) {
      const Polygon nearest = nearest_at(column, row);
      const auto crossover = passed_by(nearest, column, end, row);
      const int until = crossover ? crossover->column : end;
      const std::string seen =
          fmt::format("{} is seen in columns {} to {}", record_.name(nearest), column, until - 1);
      if (before != StepRecord::kBackground) {
        record_.step(at("crossover"),
                     fmt::format("Crossover: {} passes {}. From there on {}.",
                                 record_.name(nearest), record_.name(before), seen));
      } else if (in_.size() == 1) {
        record_.step(at("one"), fmt::format("Only {} is IN: {}.", record_.name(nearest), seen));
      } else {
        record_.step(at("nearest"),
                     fmt::format("{} are IN, and {} is the nearest at column {}: {}{}.",
                                 record_.names(in_), record_.name(nearest), column, seen,
                                 crossover ? fmt::format(", where {} passes it",
                                                         record_.name(crossover->polygon))
                                           : ""));
      }
      record_.paint_nearer({row, column, until, nearest});
      mark_span(row, column, until, nearest, first, last);
      before = nearest;
      column = until;
    }
  }

  Polygon nearest_at(int column, int row) const {
    Polygon nearest = in_.front();
    for (const Polygon polygon : in_) {
      if (scene_.hides(polygon, nearest, column, row)) nearest = polygon;
    }
    return nearest;
  }

  struct Crossover {
    int column;
    Polygon polygon;
  };
  /// The first column before the end at which another polygon that is IN hides this one. Along a
  /// row a plane passes another once at most, so that the column is found by halving.
  std::optional<Crossover> passed_by(Polygon seen, int column, int end, int row) const {
    std::optional<Crossover> first;
    for (const Polygon other : in_) {
      if (other == seen || !scene_.hides(other, seen, end - 1, row)) continue;
      int hides_not = column, hides = end - 1;
      while (hides - hides_not > 1) {
        const int middle = (hides + hides_not) / 2;
        (scene_.hides(other, seen, middle, row) ? hides : hides_not) = middle;
      }
      if (!first || hides < first->column) first = Crossover{hides, other};
    }
    return first;
  }

  void mark_span(int row, int column, int end, Polygon seen, std::size_t first, std::size_t last) {
    const bool none = seen == StepRecord::kBackground;
    for (const Polygon polygon : in_) {
      record_.mark(polygon == seen ? StepRole::seen : StepRole::hidden, polygon);
    }
    record_.mark(none ? StepRole::hidden : StepRole::seen, PixelBox{column, end, row, row + 1});
    record_.show(panel("in"), StepRecord::rows(in_, [&](Polygon polygon) {
                   return record_.row(polygon, polygon == seen ? StepRole::seen : StepRole::hidden);
                 }));
    record_.show(panel("edges"), edges_.rows(record_, first, last));
    std::vector<StepSegment> profile = profile_of(scene_, runs_);
    if (!none) {
      for (StepSegment segment : profile_of(scene_, {{row, column, end, seen}})) {
        segment.role = StepRole::seen;
        profile.push_back(segment);
      }
    }
    record_.show_segments(panel("depths"), std::move(profile));
  }

  const StepScene& scene_;
  StepRecord& record_;
  ActiveEdges edges_;
  std::vector<Polygon> in_;  // in order of entry
  std::vector<StepRun> runs_;
};

}  // namespace

const SteppedAlgorithm kScanLineSteps{
    HiddenMethod::scan_line,
    "Spanning scan line",
    "The lecture's section 4, with the flags of the problem book's 10.5",
    ScanLineSteps::kListing,
    ScanLineSteps::kPanels,
    [](const StepScene& scene, StepRecord& record) { ScanLineSteps(scene, record).run(); }};

}  // namespace displayfile
