#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "hidden/lines/plain_appel.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_lines.h"

namespace displayfile {

namespace {

/// Observer of the plain form (hidden/lines/plain_appel.h).
class AppelSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"contours", 0,
       "find the contour edges: sides with more polygons on one side than on the other"},
      {"", 0, "for each set of lines that connect:"},
      {"ray", 1, "at the start of one, count the polygons that are before it there"},
      {"", 1, "follow the lines that connect with it:"},
      {"carried", 2, "begin with the count of the point where it meets one that is done"},
      {"edge", 2, "where it passes behind a contour edge, or through a polygon, the count changes"},
      {"other", 2, "polygons that meet themselves are not counted: hold the line against each"},
      {"end", 2, "note the count at its end, for the lines that go on from there"},
      {"seen", 2, "draw it where the count is 0 on the left or on the right of it"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"graph", "Quantitative invisibility along the line", PanelEntry::Kind::graph},
      {"counts", "Counts along the line", PanelEntry::Kind::table,
       "from|to|on the left|on the right"},
      {"points", "Counts that are known at points", PanelEntry::Kind::list},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  AppelSteps(const StepItems& scene, StepRecord& record)
      : record_(record),
        lines_(scene, record),
        scene_(lines_.items(), lines_.lines(), 1),
        appel_(scene_, lines_.policy(), *this) {}

  void run() {
    tell_contours();
    appel_.find({});
  }

  using Line = LineTable::Line;

  void ray(const Line& line, const SideCounts& start) {
    record_.step(
        at("ray"),
        fmt::format("At the start of {}, {} on its left and {} on its right are before it.",
                    lines_.name(line), polygons(start.left), polygons(start.right)));
    mark_start(line, 0.0);
  }

  void carried(const Line& line, bool by_start, std::int32_t known, const SideCounts& start) {
    record_.step(at("carried"),
                 fmt::format("{} of {} is known, {}: with the polygons around that point the "
                             "count begins with {} on the left and {} on the right.",
                             by_start ? "The start" : "The end", lines_.name(line), known,
                             start.left, start.right));
    mark_start(line, by_start ? 0.0 : 1.0);
  }

  void part(const Line& line, const PartOfLine& part, const SideCounts& counts,
            const SideCounts& by) {
    const auto& [from, to] = part;
    if (from == 0.0) {
      rows_.clear();
      graph_.clear();
    }
    const bool hidden = counts.left > 0 && counts.right > 0;
    const StepRole role = hidden ? StepRole::hidden : StepRole::seen;
    rows_.push_back({{fmt::format("{:.3g}", from), fmt::format("{:.3g}", to),
                      std::to_string(counts.left), std::to_string(counts.right)},
                     StepRow::kNoPiece,
                     role});
    const double height = std::min(counts.left, counts.right);
    if (!graph_.empty()) {
      graph_.push_back({from, graph_.back().z1, from, height, StepRow::kNoPiece});
    }
    graph_.push_back({from, height, to, height, StepRow::kNoPiece, role});
    if (!(by == SideCounts{})) {
      record_.step(at("edge"), fmt::format("At {:.3g} of its length the count changes by {:+} on "
                                           "the left and {:+} on the right, to {} and {}.",
                                           from, by.left, by.right, counts.left, counts.right));
      record_.mark(StepRole::cut, {lines_.at(line, from)}, StepMark::Kind::points);
      lines_.mark(StepRole::root, line);
    }
    record_.show(panel("counts"), rows_);
    record_.show_segments(panel("graph"), graph_);
  }

  void compared(const Line& line, std::uint32_t polygon, bool with_all) {
    const auto covered = lines_.covered_by(polygon, line);
    if (covered.empty()) return;
    record_.step(at("other"), fmt::format("{} {}: it hides {} of the line.", record_.name(polygon),
                                          with_all ? "is compared, as the line is close to corners"
                                                   : "meets itself, and is not counted",
                                          counted(covered.size(), "part")));
    record_.mark(StepRole::front, polygon);
    lines_.mark(StepRole::root, line);
    for (const auto& [part, sides] : covered) lines_.mark(StepRole::hidden, line, part);
  }

  void noted(const Line& line, const std::vector<double>& shares) {
    std::vector<Point2> points;
    points.reserve(shares.size());
    for (const double share : shares) points.push_back(lines_.at(line, share));
    record_.step(at("end"),
                 fmt::format("The count is noted at {} of {}, without the polygons around it.",
                             points.size() == 2 ? "both ends" : "an end", lines_.name(line)));
    lines_.mark(StepRole::root, line);
    record_.mark(StepRole::seen, points, StepMark::Kind::points);
    show_points();
  }

  void seen(const Line& line, std::span<const SeenPart> parts) {
    lines_.tell_seen(line, parts, at("seen"));
  }

 private:
  void tell_contours() {
    Extent all = Extent::nothing();
    all.x_min = all.y_min = all.z_min = -std::numeric_limits<float>::infinity();
    all.x_max = all.y_max = all.z_max = std::numeric_limits<float>::infinity();
    record_.step(at("contours"), fmt::format("There are {}; behind other sides no count changes.",
                                             counted(scene_.contours.size(), "contour edge")));
    scene_.contours.any(all, [&](const ContourEdges::Edge& edge) {
      record_.mark(StepRole::front, {flat(edge.p), flat(edge.q)}, StepMark::Kind::line);
      return false;
    });
  }

  static std::string polygons(std::int32_t n) {
    return fmt::format("{} {}", n, n == 1 ? "polygon" : "polygons");
  }

  void mark_start(const Line& line, double share) {
    lines_.mark(StepRole::root, line);
    record_.mark(StepRole::active, {lines_.at(line, share)}, StepMark::Kind::points);
    show_points();
  }

  void show_points() {
    record_.show(panel("points"), StepRecord::rows(appel_.known(), [&](const auto& known) {
                   const Point3& p = lines_.lines().point(known.first);
                   return StepRow{{fmt::format("{:.2f},{:.2f}: {}", p.x, p.y, known.second)}};
                 }));
  }

  StepRecord& record_;
  StepLines lines_;
  AppelTables scene_;
  PlainAppel<ExactLines, AppelSteps> appel_;
  std::vector<StepRow> rows_;       // of the counts along the line,
  std::vector<StepSegment> graph_;  // and their graph
};

}  // namespace

const SteppedAlgorithm kAppelSteps{
    HiddenMethod::appel,
    "Appel's quantitative invisibility",
    "Appel 1967; the chapter's section \"Hidden-line methods\"",
    "hidden/lines/plain_appel.h",
    AppelSteps::kListing,
    AppelSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { AppelSteps(scene, record).run(); }};

}  // namespace displayfile
