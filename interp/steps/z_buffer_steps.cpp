#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "interp/steps/algorithms.h"
#include "interp/steps/step_record.h"

namespace displayfile {

namespace {

/// The z-buffer polygon by polygon and row by row. The books compare stored depths; here the planes
/// of the polygon and of the visible fill are compared, so that no rounding decides.
class ZBufferSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"clear", 0, "set all pixels to the background, and all depths to the farthest"},
      {"polygon", 0, "for each polygon, in order of entry:"},
      {"row", 1, "for each row that it crosses:"},
      {"", 2, "for each run of pixels between a pair of its edges:"},
      {"", 3, "find the polygon's depth at the centre of each pixel"},
      {"nearer", 3, "nearer than the z-buffer's, or the same: the pixel shows the polygon,"},
      {"", 4, "and the z-buffer takes its depth"},
      {"hidden", 3, "farther: both stay"},
      {"end", 0, "what the pixels show is the picture"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"depths", "Z-buffer, the nearer the lighter", PanelEntry::Kind::depths},
      {"row", "Depths on the row", PanelEntry::Kind::profile},
      {"polygons", "Polygons, the last first", PanelEntry::Kind::table,
       "polygon|pixels covered|gained so far"},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  ZBufferSteps(const StepItems& scene, StepRecord& record) : scene_(scene), record_(record) {}

  void run() {
    record_.step(at("clear"), "The picture is all background, and as far away as can be.");
    show_polygons(StepRecord::kBackground);
    for (const auto polygon : scene_.fills()) draw(polygon);
    record_.step(at("end"), "All polygons are drawn: this is the picture.");
    record_.show_segments(panel("row"), {});
  }

 private:
  using Polygon = StepItems::Polygon;
  using Runs = std::vector<StepRun>;

  void draw(Polygon polygon) {
    const Runs runs = scene_.coverage(polygon);
    std::size_t pixels = 0;
    for (const StepRun& run : runs) pixels += static_cast<std::size_t>(run.end - run.first);
    rows_.push_back({{record_.name(polygon), std::to_string(pixels), "0"}, polygon});
    record_.step(at("polygon"), fmt::format("{} is next: it covers {}.", record_.name(polygon),
                                            counted(pixels, "pixel")));
    record_.mark(StepRole::active, polygon);
    show_polygons(polygon);
    for (auto begin = runs.begin(); begin != runs.end();) {
      const auto end = std::find_if(begin, runs.end(),
                                    [&](const StepRun& run) { return run.row != begin->row; });
      draw_row(polygon, {begin, end});
      begin = end;
    }
  }

  void draw_row(Polygon polygon, const Runs& runs) {
    const int row = runs.front().row;
    std::vector<StepSegment> profile = what_is_seen(row);
    Step& step = record_.step(at("nearer"), "");
    std::size_t covered = 0, gained = 0;
    for (const StepRun& run : runs) {
      covered += static_cast<std::size_t>(run.end - run.first);
      gained += static_cast<std::size_t>(record_.paint_nearer(run));
    }
    if (gained == 0) step.line = at("hidden");
    step.sentence = fmt::format("Row {}: of the {} that {} covers it is the nearest so far in {}.",
                                row, counted(covered, "pixel"), record_.name(polygon),
                                gained == 0         ? "none"
                                : gained == covered ? "all"
                                                    : std::to_string(gained));
    record_.mark(StepRole::active, polygon);
    for (const StepRun& run : runs) {
      record_.mark(gained > 0 ? StepRole::seen : StepRole::hidden,
                   PixelBox{run.first, run.end, row, row + 1});
      profile.push_back(segment(polygon, run.first, run.end, row, StepRole::seen));
    }
    record_.show_segments(panel("row"), std::move(profile));
    auto& cell = rows_.back().cells.back();
    cell = std::to_string(std::stoul(cell) + gained);
    show_polygons(polygon);
  }

  /// The depths that the z-buffer holds along a row.
  std::vector<StepSegment> what_is_seen(int row) const {
    std::vector<StepSegment> segments;
    for (int first = 0; first < scene_.size().width;) {
      const Polygon polygon = record_.seen(first, row);
      int end = first + 1;
      while (end < scene_.size().width && record_.seen(end, row) == polygon) ++end;
      if (polygon != StepRecord::kBackground) {
        segments.push_back(segment(polygon, first, end, row, StepRole::none));
      }
      first = end;
    }
    return segments;
  }
  StepSegment segment(Polygon polygon, int first, int end, int row, StepRole role) const {
    const double width = scene_.size().width;
    return {first / width, scene_.depth(polygon, first, row),
            end / width,   scene_.depth(polygon, end - 1, row),
            polygon,       role};
  }

  void show_polygons(Polygon active) {
    const auto shown = static_cast<std::ptrdiff_t>(std::min(rows_.size(), StepRecord::kMostRows));
    std::vector<StepRow> last_first(rows_.rbegin(), rows_.rbegin() + shown);
    for (StepRow& row : last_first) {
      if (row.piece == active) row.role = StepRole::active;
    }
    record_.show(panel("polygons"), std::move(last_first));
  }

  const StepItems& scene_;
  StepRecord& record_;
  std::vector<StepRow> rows_;
};

}  // namespace

const SteppedAlgorithm kZBufferSteps{
    HiddenMethod::z_buffer,
    "Z-buffer",
    "Catmull 1974; the chapter's section \"Z buffers\", the lecture's section 3, the problem "
    "book's "
    "10.2",
    "interp/steps/z_buffer_steps.cpp",
    ZBufferSteps::kListing,
    ZBufferSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { ZBufferSteps(scene, record).run(); }};

}  // namespace displayfile
