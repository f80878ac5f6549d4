#include <fmt/format.h>

#include <utility>

#include "interp/steps/active_edges.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_record.h"

namespace displayfile {

namespace {

/// The scan-line z-buffer: one row of depths, cleared for each row of the picture.
class ScanLineZSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"table", 0, "put the edges of all polygons into an edge table, by their lowest row"},
      {"row", 0, "for each row, from the bottom up:"},
      {"", 1, "strike off the edges that end below it, link in those that begin"},
      {"", 1, "find where each active edge crosses the row"},
      {"clear", 1, "set the row's depths to the farthest"},
      {"polygon", 1, "for each polygon with active edges, in order of entry:"},
      {"", 2, "for each run of pixels between a pair of its crossings:"},
      {"nearer", 3, "nearer than the row's depth, or the same: the pixel shows it"},
      {"hidden", 3, "farther: the pixel stays"},
      {"done", 1, "the row is done, and its depths are not needed any more"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"edges", "Active edge list", PanelEntry::Kind::table, kEdgeColumns},
      {"depths", "The row's z-buffer, and the depths compared with it", PanelEntry::Kind::profile},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  ScanLineZSteps(const StepItems& scene, StepRecord& record)
      : scene_(scene),
        record_(record),
        edges_(scene.viewed(), scene.size(), 0, scene.size().height) {}

  void run() {
    record_.step(at("table"),
                 fmt::format("The edge table has {}.", counted(edges_.to_come(), "edge")));
    for (int row = 0; row < scene_.size().height; ++row) {
      const auto [entered, left] = edges_.go_to(row);
      if (edges_.edges().empty() && left == 0) continue;
      draw(row, entered, left);
    }
  }

 private:
  PixelBox whole_row(int row) const { return {0, scene_.size().width, row, row + 1}; }

  void draw(int row, std::size_t entered, std::size_t left) {
    record_.step(at("row"), fmt::format("Row {}: {} linked in, {} struck off, {} active.", row,
                                        counted(entered, "edge"), left, edges_.edges().size()));
    record_.mark(StepRole::active, whole_row(row));
    mark_edges(record_, edges_.edges());
    record_.show(panel("edges"), rows_of(scene_, record_, edges_.edges()));
    record_.show_segments(panel("depths"), {});
    std::vector<StepSegment> kept;
    for (const StepRun& run : runs_of(scene_, edges_.edges(), row)) {
      Step& step = record_.step(at("nearer"), "");
      const int gained = record_.paint_nearer(run);
      if (gained == 0) step.line = at("hidden");
      step.sentence = fmt::format("{} runs from column {} to {}: it is nearest so far in {} of {}.",
                                  record_.name(run.polygon), run.first, run.end - 1, gained,
                                  counted(static_cast<std::size_t>(run.end - run.first), "pixel"));
      record_.mark(StepRole::active, run.polygon);
      record_.mark(gained > 0 ? StepRole::seen : StepRole::hidden,
                   PixelBox{run.first, run.end, row, row + 1});
      auto profile = kept;
      for (StepSegment segment : profile_of(scene_, {run})) {
        kept.push_back(segment);
        segment.role = gained > 0 ? StepRole::seen : StepRole::hidden;
        profile.push_back(segment);
      }
      record_.show_segments(panel("depths"), std::move(profile));
    }
    record_.step(at("done"), fmt::format("Row {} is done.", row));
    record_.mark(StepRole::active, whole_row(row));
  }

  const StepItems& scene_;
  StepRecord& record_;
  ActiveEdgeList edges_;
};

}  // namespace

const SteppedAlgorithm kScanLineZSteps{
    HiddenMethod::scan_line_z,
    "Scan line with a z-buffer of one row",
    "Carpenter 1976; the chapter's section \"Scan-line algorithms\"",
    "interp/steps/scan_line_z_steps.cpp",
    ScanLineZSteps::kListing,
    ScanLineZSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { ScanLineZSteps(scene, record).run(); }};

}  // namespace displayfile
