#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "hidden/lines/line_follower.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_lines.h"

namespace displayfile {

namespace {

/// Appel's method: what changes the counts of a line is found as the system finds it
/// (hidden/lines/appel.md); the lines are then followed one after the other as the book has it,
/// where the system does that for all of them before it looks at any.
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

  AppelSteps(const StepScene& scene, StepRecord& record)
      : record_(record),
        lines_(scene, record),
        appel_(lines_.items(), lines_.lines(), 1),
        follower_(appel_, lines_.policy()) {}

  void run() {
    tell_contours();
    find_changes();
    for (std::uint32_t k = 0; k < counted_.size(); ++k) {
      if (done_[k] == 0) follow_from(k);
    }
  }

  /// For find_seen: what the counts along one of the line's depths hide.
  const std::vector<PartOfLine>& hidden_parts(const LineScene::Line& line) {
    const auto number = static_cast<std::size_t>(&line - lines_.lines().lines().data());
    const auto& [found, from, to, start, is_near] = of_lines_[number];
    parts_.clear();
    if (!is_near) tell_changes(line, std::span(changes_[found]).subspan(from, to - from));
    compare_with_others(line, is_near);
    return parts_.hidden();
  }

 private:
  void tell_contours() {
    Extent all = Extent::nothing();
    all.x_min = all.y_min = all.z_min = -std::numeric_limits<float>::infinity();
    all.x_max = all.y_max = all.z_max = std::numeric_limits<float>::infinity();
    record_.step(at("contours"), fmt::format("There are {}; behind other sides no count changes.",
                                             counted(appel_.contours.size(), "contour edge")));
    appel_.contours.any(all, [&](const ContourEdges::Edge& edge) {
      record_.mark(StepRole::front, {flat(edge.p), flat(edge.q)}, StepMark::Kind::line);
      return false;
    });
  }

  void find_changes() {
    const auto lines = lines_.lines().lines();
    const auto firsts = lines_.lines().first_lines();
    carries_.assign(appel_.vertices.joins().size(), 0);
    for (const LineScene::Line& line : lines) {
      for (const std::uint32_t point : {line.a, line.b}) {
        const std::uint32_t v = appel_.vertices.vertex(point);
        if (appel_.vertices.joins()[v] != 0) carries_[v] = follower_.carries(v) ? 1 : 0;
      }
    }
    of_lines_.resize(lines.size());
    changes_.resize(firsts.size());
    done_.assign(firsts.size(), 0);
    for (std::uint32_t k = 0; k < firsts.size(); ++k) {
      const std::size_t end = k + 1 < firsts.size() ? firsts[k + 1] : lines.size();
      const auto of_depths = std::span(of_lines_).subspan(firsts[k], end - firsts[k]);
      for (ChangesOfLine& of : of_depths) of = {k, 0, 0, k};
      counted_.push_back(follower_.follow(firsts[k], carries_, changes_[k], of_depths));
      for (const std::uint32_t v : {counted_[k].from, counted_[k].to}) {
        if (carries_[v] != 0) of_vertex_[v].push_back(k);
      }
    }
  }

  /// Follows all lines that connect with one, from vertex to vertex.
  void follow_from(std::uint32_t first) {
    std::vector<std::uint32_t> reached;
    draw(first, std::nullopt, reached);
    while (!reached.empty()) {
      const std::uint32_t v = reached.back();
      reached.pop_back();
      for (const std::uint32_t k : of_vertex_[v]) {
        if (done_[k] == 0) draw(k, v, reached);
      }
    }
  }

  /// Draws a line, whose count comes from a vertex, or from a ray; adds the vertices whose counts
  /// are known by it.
  void draw(std::uint32_t k, std::optional<std::uint32_t> vertex,
            std::vector<std::uint32_t>& reached) {
    const CountedLine& counted = counted_[k];
    const LineScene::Line& line = lines_.lines().lines()[lines_.lines().first_lines()[k]];
    const std::string of = lines_.name(line);
    done_[k] = 1;
    if (!vertex) {
      start_ = follower_.ray(line);
      record_.step(
          at("ray"),
          fmt::format("At the start of {}, {} on its left and {} on its right are before it.", of,
                      polygons(start_.left), polygons(start_.right)));
    } else {
      const std::int32_t known = known_[*vertex];
      const SideCounts around{known, known};
      const bool by_from = *vertex == counted.from;
      start_ = by_from ? around + counted.star_from : around + counted.star_to - counted.change;
      record_.step(
          at("carried"),
          fmt::format("{} of {} is known, {}: with the polygons around that point the "
                      "count begins with {} on the left and {} on the right.",
                      by_from ? "The start" : "The end", of, known, start_.left, start_.right));
    }
    lines_.mark(StepRole::root, line);
    record_.mark(StepRole::active, {lines_.at(line, vertex && *vertex == counted.to ? 1.0 : 0.0)},
                 StepMark::Kind::points);
    show_points();
    std::vector<SeenPart> seen;
    find_seen(lines_.lines().lines(), lines_.lines().first_lines()[k], *this, seen);
    note_ends(counted, line, reached);
    lines_.tell_seen(line, seen, at("seen"));
  }

  static std::string polygons(std::int32_t n) {
    return fmt::format("{} {}", n, n == 1 ? "polygon" : "polygons");
  }

  void note_ends(const CountedLine& counted, const LineScene::Line& line,
                 std::vector<std::uint32_t>& reached) {
    const SideCounts at_start = start_ - counted.star_from;
    const SideCounts at_end = start_ + counted.change - counted.star_to;
    std::vector<Point2> points;
    for (const auto& [v, count, share] :
         {std::tuple{counted.from, at_start.left, 0.0}, std::tuple{counted.to, at_end.left, 1.0}}) {
      if (carries_[v] == 0 || known_.contains(v)) continue;
      known_[v] = count;
      reached.push_back(v);
      points.push_back(lines_.at(line, share));
    }
    if (points.empty()) return;
    record_.step(at("end"),
                 fmt::format("The count is noted at {} of {}, without the polygons around it.",
                             points.size() == 2 ? "both ends" : "an end", lines_.name(line)));
    lines_.mark(StepRole::root, line);
    record_.mark(StepRole::seen, points, StepMark::Kind::points);
    show_points();
  }

  void show_points() {
    record_.show(panel("points"), StepRecord::rows(known_, [&](const auto& known) {
                   const Point3& p = lines_.lines().point(known.first);
                   return StepRow{{fmt::format("{:.2f},{:.2f}: {}", p.x, p.y, known.second)}};
                 }));
  }

  /// The counts in order along the line, a step for each place at which they change.
  void tell_changes(const LineScene::Line& line, std::span<const CountChange> changes) {
    SideCounts counts = start_;
    std::vector<StepRow> rows;
    std::vector<StepSegment> graph;
    double from = 0.0;
    for (std::size_t i = 0; from < 1.0;) {
      SideCounts by{};
      const double here = from;
      for (; i < changes.size() && changes[i].at <= from; ++i) by += changes[i].by;
      counts += by;
      const double to = i < changes.size() ? std::min(changes[i].at, 1.0) : 1.0;
      const PartOfLine part{from, to};
      if (counts.left > 0 && counts.right > 0) {
        parts_.add_both(part);
      } else if (counts.left > 0) {
        parts_.add_left(part);
      } else if (counts.right > 0) {
        parts_.add_right(part);
      }
      const bool hidden = counts.left > 0 && counts.right > 0;
      const StepRole role = hidden ? StepRole::hidden : StepRole::seen;
      rows.push_back({{fmt::format("{:.3g}", from), fmt::format("{:.3g}", to),
                       std::to_string(counts.left), std::to_string(counts.right)},
                      StepRow::kNoPiece,
                      role});
      const double height = std::min(counts.left, counts.right);
      if (!graph.empty()) graph.push_back({from, graph.back().z1, from, height, StepRow::kNoPiece});
      graph.push_back({from, height, to, height, StepRow::kNoPiece, role});
      if (!(by == SideCounts{})) {
        record_.step(at("edge"), fmt::format("At {:.3g} of its length the count changes by {:+} on "
                                             "the left and {:+} on the right, to {} and {}.",
                                             here, by.left, by.right, counts.left, counts.right));
        record_.mark(StepRole::cut, {lines_.at(line, here)}, StepMark::Kind::points);
        lines_.mark(StepRole::root, line);
      }
      record_.show(panel("counts"), rows);
      record_.show_segments(panel("graph"), graph);
      from = to;
    }
  }

  void compare_with_others(const LineScene::Line& line, bool with_all) {
    for (std::uint32_t polygon = 0; polygon < lines_.lines().items(); ++polygon) {
      const bool is_counted = !with_all && appel_.contours.way(polygon) != 0;
      if (!lines_.lines().hides(polygon) || is_counted) continue;
      const auto covered = lines_.covered_by(polygon, line);
      if (covered.empty()) continue;
      record_.step(at("other"),
                   fmt::format("{} {}: it hides {} of the line.", record_.name(polygon),
                               with_all ? "is compared, as the line is close to corners"
                                        : "meets itself, and is not counted",
                               counted(covered.size(), "part")));
      record_.mark(StepRole::front, polygon);
      lines_.mark(StepRole::root, line);
      for (const auto& [part, sides] : covered) {
        lines_.mark(StepRole::hidden, line, part);
        if (sides == StepLines::kBoth) {
          parts_.add_both(part);
        } else if (sides == StepLines::kLeft) {
          parts_.add_left(part);
        } else {
          parts_.add_right(part);
        }
      }
    }
  }

  StepRecord& record_;
  StepLines lines_;
  AppelScene appel_;
  LineFollower<ExactLines> follower_;
  std::vector<std::uint8_t> carries_;                              // of vertices
  std::map<std::uint32_t, std::vector<std::uint32_t>> of_vertex_;  // the lines
  std::map<std::uint32_t, std::int32_t> known_;                    // counts at vertices
  std::vector<ChangesOfLine> of_lines_;
  std::vector<std::vector<CountChange>> changes_;  // of each name
  std::vector<CountedLine> counted_;
  std::vector<std::uint8_t> done_;
  SideCounts start_;
  HiddenParts parts_;
};

}  // namespace

const SteppedAlgorithm kAppelSteps{
    HiddenMethod::appel,
    "Appel's quantitative invisibility",
    "Appel 1967; the chapter's section \"Hidden-line methods\"",
    AppelSteps::kListing,
    AppelSteps::kPanels,
    [](const StepScene& scene, StepRecord& record) { AppelSteps(scene, record).run(); }};

}  // namespace displayfile
