#include <fmt/format.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "interp/steps/active_edges.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_record.h"
#include "interp/visibility/plain_scan_line.h"

namespace displayfile {

namespace {

/// Observer of the plain scan line (interp/visibility/plain_scan_line.h).
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
      {"edges", "Active edge list", PanelEntry::Kind::table, kEdgeColumns},
      {"in", "Polygons that are IN", PanelEntry::Kind::list},
      {"depths", "The row from above: up is toward the viewer", PanelEntry::Kind::profile},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  ScanLineSteps(const StepItems& scene, StepRecord& record) : scene_(scene), record_(record) {}

  void run() {
    PlainScanLine scan_line;
    scan_line.prepare({scene_.viewed(), scene_.size(), {}}, 1);
    scan_line.draw_rows(
        0, scene_.size().height, [](int, int, std::span<const Fill>) {}, *this);
  }

  void table(const ActiveEdgeList& edges) {
    record_.step(at("table"),
                 fmt::format("The edge table has {}.", counted(edges.to_come(), "edge")));
  }

  void begin_row(int row, const ActiveEdgeList& edges, const ActiveEdgeList::Change& change) {
    edges_ = edges.edges();
    is_empty_ = edges_.empty() && change.left == 0;
    if (is_empty_) return;
    record_.step(at("row"),
                 fmt::format("Row {}: {} linked in, {} struck off, {} active.", row,
                             counted(change.entered, "edge"), change.left, edges_.size()));
    mark_row(row);
    mark_edges(record_, edges_);
    record_.show(panel("edges"), rows_of(scene_, record_, edges_));
    record_.show(panel("in"), {});
    runs_ = runs_of(scene_, edges_, row);
    record_.show_segments(panel("depths"), profile_of(scene_, runs_));
  }

  void paint(const PlainScanLine::Span& span) {
    if (span.in.empty()) {
      if (span.end == scene_.size().width) return;
      record_.step(at("none"),
                   fmt::format("Columns {} to {}: no polygon is IN, the background is seen.",
                               span.first, span.end - 1));
      return mark_span(span);
    }
    const std::string& name = record_.name(polygon(span.seen));
    const std::string seen =
        fmt::format("{} is seen in columns {} to {}", name, span.first, span.end - 1);
    if (span.passed) {
      record_.step(at("crossover"), fmt::format("Crossover: {} passes {}. From there on {}.", name,
                                                record_.name(polygon(*span.passed)), seen));
    } else if (span.in.size() == 1) {
      record_.step(at("one"), fmt::format("Only {} is IN: {}.", name, seen));
    } else {
      std::vector<Polygon> in;
      for (const Fill fill : span.in) in.push_back(polygon(fill));
      record_.step(
          at("nearest"),
          fmt::format("{} are IN, and {} is the nearest at column {}: {}{}.", record_.names(in),
                      name, span.first, seen,
                      span.passes_at_end ? fmt::format(", where {} passes it",
                                                       record_.name(polygon(*span.passes_at_end)))
                                         : ""));
    }
    record_.paint_nearer({span.row, span.first, span.end, polygon(span.seen)});
    mark_span(span);
  }

  void end_row(int row) {
    if (is_empty_) return;
    record_.step(at("done"), fmt::format("Row {} is done.", row));
    mark_row(row);
    record_.show(panel("in"), {});
  }

 private:
  using Polygon = StepItems::Polygon;
  using Fill = ViewedScene::Fill;

  Polygon polygon(Fill fill) const { return scene_.viewed().item_of(fill); }

  void mark_row(int row) {
    record_.mark(StepRole::active, PixelBox{0, scene_.size().width, row, row + 1});
  }

  void mark_span(const PlainScanLine::Span& span) {
    const bool none = span.seen == ViewedScene::kBackground;
    const auto role = [&](Fill fill) {
      return fill == span.seen ? StepRole::seen : StepRole::hidden;
    };
    for (const Fill fill : span.in) record_.mark(role(fill), polygon(fill));
    record_.mark(none ? StepRole::hidden : StepRole::seen,
                 PixelBox{span.first, span.end, span.row, span.row + 1});
    record_.show(panel("in"), StepRecord::rows(span.in, [&](Fill fill) {
                   return record_.row(polygon(fill), role(fill));
                 }));
    record_.show(panel("edges"), rows_of(scene_, record_, edges_, span.first_edge, span.end_edge));
    std::vector<StepSegment> profile = profile_of(scene_, runs_);
    if (!none) {
      for (StepSegment segment :
           profile_of(scene_, {{span.row, span.first, span.end, polygon(span.seen)}})) {
        segment.role = StepRole::seen;
        profile.push_back(segment);
      }
    }
    record_.show_segments(panel("depths"), std::move(profile));
  }

  const StepItems& scene_;
  StepRecord& record_;
  std::span<const ActiveEdgeList::Edge> edges_;
  bool is_empty_ = true;  // the row, which has no steps then
  std::vector<StepRun> runs_;
};

}  // namespace

const SteppedAlgorithm kScanLineSteps{
    HiddenMethod::scan_line,
    "Spanning scan line",
    "The lecture's section 4, with the flags of the problem book's 10.5",
    "interp/visibility/plain_scan_line.h",
    ScanLineSteps::kListing,
    ScanLineSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { ScanLineSteps(scene, record).run(); }};

}  // namespace displayfile
