#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <utility>

#include "hidden/lines/perimeter_method.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_lines.h"

namespace displayfile {

namespace {

/// The perimeters as shown: their heights at some columns, rounded. Visibility is decided by the
/// polylines themselves (hidden/lines/perimeter.md).
class ShownHorizon {
 public:
  ShownHorizon(const GridSurface& surface, const Verticals& verticals)
      : surface_(surface), verticals_(verticals) {}

  void extend(std::uint32_t from, std::uint32_t to) {
    Point2 p = verticals_.in_columns(from), q = verticals_.in_columns(to);
    std::uint32_t left = from, right = to;
    if (p.x > q.x) {
      std::swap(p, q);
      std::swap(left, right);
    }
    for (std::size_t k = 0; k < kColumns; ++k) {
      const double x = column(k);
      if (x < p.x || x > q.x || p.x == q.x) continue;
      const double height = p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
      const Point2 a = flat(surface_.point(left)), b = flat(surface_.point(right));
      const Point2 seen = a + verticals_.part_at_column(a, b, x) * (b - a);
      Column& at = columns_[k];
      if (!at.any || height > at.high) {
        at.high = height;
        at.upper = seen;
      }
      if (!at.any || height < at.low) {
        at.low = height;
        at.lower = seen;
      }
      at.any = true;
    }
  }

  /// Marks chains of the columns reached.
  void mark(StepRecord& record) const {
    std::vector<Point2> upper, lower;
    for (std::size_t k = 0; k <= kColumns; ++k) {
      if (k < kColumns && columns_[k].any) {
        upper.push_back(columns_[k].upper);
        lower.push_back(columns_[k].lower);
      } else if (!upper.empty()) {
        record.mark(StepRole::upper, std::exchange(upper, {}), StepMark::Kind::line);
        record.mark(StepRole::lower, std::exchange(lower, {}), StepMark::Kind::line);
      }
    }
  }

  /// The minima and maxima of the columns, as a chart.
  std::vector<StepSegment> chart() const {
    const auto& [x_min, x_max, y_min, y_max] = verticals_.box();
    const double high = y_max > y_min ? y_max - y_min : 1.0, low = y_min;
    std::vector<StepSegment> segments;
    for (std::size_t k = 0; k < kColumns; ++k) {
      const Column& at = columns_[k];
      if (!at.any) continue;
      const double x = (static_cast<double>(k) + 0.5) / kColumns;
      segments.push_back({x, (at.low - low) / high, x, (at.high - low) / high, StepRow::kNoPiece,
                          StepRole::active});
    }
    return segments;
  }

 private:
  static constexpr std::size_t kColumns = 48;
  struct Column {
    bool any = false;
    double low = 0.0, high = 0.0;
    Point2 lower{0.0}, upper{0.0};
  };
  double column(std::size_t k) const {
    const Rectangle& box = verticals_.box();
    return box.x_min + (static_cast<double>(k) + 0.5) / kColumns * (box.x_max - box.x_min);
  }

  const GridSurface& surface_;
  const Verticals& verticals_;
  std::array<Column, kColumns> columns_;
};

/// Observer of the system's form of the perimeter method (hidden/lines/perimeter.md): records the
/// cells, the hidden parts of their sides, and how the horizon grows.
class PerimeterSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"begin", 0, "begin at the cell that is nearest to the viewer; the perimeters are empty"},
      {"cell", 0, "for each cell of the grid, the nearest first, for each of its two triangles:"},
      {"", 1, "for each side that no triangle before it has:"},
      {"hidden", 2, "it is between the lower and the upper perimeter: it is hidden"},
      {"part", 2, "it goes through a perimeter: it is seen up to there, or from there on"},
      {"seen", 2, "it is on or outside of them: it is seen"},
      {"grow", 1, "then move the perimeters out to these sides: the horizon grows"},
      {"others", 0,
       "sides that run along verticals or lie on others in the picture are found by cells"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"array", "Least and greatest height drawn, column by column", PanelEntry::Kind::graph},
      {"cells", "Cells", PanelEntry::Kind::table, "what|number"},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  PerimeterSteps(const StepItems& scene, StepRecord& record)
      : record_(record), lines_(scene, record), surface_(lines_.items()), verticals_(surface_) {}

  void run() {
    if (verticals_.are_points() || !verticals_.make_columns()) {
      return find_others(lines_.names());
    }
    const NamedSides named(surface_, verticals_, lines_.names(), lines_.items());
    const SurfaceColumns columns(surface_, verticals_, lines_.items().touching);
    const SurfaceColumns::Range all{0, columns.size()};
    horizon_.emplace(surface_, verticals_);
    SeenParts seen(lines_.names().size());
    PerimeterMethod method(surface_, named, lines_.names(),
                           PerimeterPolylines(surface_, verticals_, columns, all), seen,
                           Observer{this});
    record_.step(at("begin"),
                 fmt::format("The grid has {} by {} cells.", surface_.columns(), surface_.rows()));
    const WorkProgress nobody;
    CountedWork work(nobody, 0);
    method.draw(CellsInOrder(surface_), work);
    grow();
    if (method.gave_up()) return find_others(lines_.names());
    std::vector<LineName> others(named.others().begin(), named.others().end());
    for (const std::uint32_t name : method.undecided()) others.push_back(lines_.names()[name]);
    std::ranges::sort(others);
    find_others(others);
  }

 private:
  struct Observer {
    PerimeterSteps* steps;
    void cell(std::uint32_t i, std::uint32_t j) const { steps->tell_cell(i, j); }
    void drawn(std::uint32_t name, const std::vector<PartOfLine>& hidden) const {
      steps->tell_drawn(name, hidden);
    }
    void extends(std::uint32_t from, std::uint32_t to) const {
      steps->extending_.emplace_back(from, to);
    }
  };

  void tell_cell(std::uint32_t i, std::uint32_t j) {
    grow();
    ++cells_;
    record_.step(at("cell"), fmt::format("The next cell is in column {} and row {} of the grid.",
                                         i + 1, j + 1));
    triangle_ = surface_.first_triangle(i, j);
    show();
  }

  /// Adds the sides of the previous cell to the perimeters.
  void grow() {
    if (extending_.empty()) return;
    record_.step(at("grow"),
                 fmt::format("The horizon grows by {}.", counted(extending_.size(), "side")));
    for (const auto& [from, to] : extending_) {
      record_.mark(StepRole::cut, {flat(surface_.point(from)), flat(surface_.point(to))},
                   StepMark::Kind::line);
      horizon_->extend(from, to);
    }
    extending_.clear();
    show();
    record_.show_segments(panel("array"), horizon_->chart());
  }

  void tell_drawn(std::uint32_t name, const std::vector<PartOfLine>& hidden) {
    std::vector<SeenPart> seen;
    double from = 0.0;
    for (const PartOfLine& part : hidden) {
      if (from < part.from) seen.push_back({name, {from, part.from}});
      from = part.to;
    }
    if (from < 1.0) seen.push_back({name, {from, 1.0}});
    lines_.tell_seen(lines_.line_of(name), seen,
                     seen.empty()     ? at("hidden")
                     : hidden.empty() ? at("seen")
                                      : at("part"));
    lines_.mark(StepRole::root, lines_.line_of(name));
    show();
  }

  void find_others(std::span<const LineName> names) {
    if (names.empty()) return;
    const SeenLines found =
        visible_lines(lines_.items(), names, {.method = HiddenMethod::franklin});
    for (const LineName& name : names) {
      const auto number = static_cast<std::uint32_t>(
          std::ranges::lower_bound(lines_.names(), name) - lines_.names().begin());
      std::vector<SeenPart> seen;
      for (const auto& [item, corner, from, to] : found.pieces) {
        if (LineName{item, corner} == name) seen.push_back({number, {from, to}});
      }
      lines_.tell_seen(lines_.line_of(number), seen, at("others"));
    }
  }

  void show() {
    record_.mark(StepRole::active, triangle_);
    record_.mark(StepRole::active, triangle_ + 1);
    if (horizon_) horizon_->mark(record_);
    record_.show(panel("cells"),
                 {{{"passed", std::to_string(cells_)}},
                  {{"of all", std::to_string(std::size_t{surface_.columns()} * surface_.rows())}}});
  }

  StepRecord& record_;
  StepLines lines_;
  GridSurface surface_;
  Verticals verticals_;
  std::optional<ShownHorizon> horizon_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> extending_;
  std::size_t cells_ = 0;
  std::uint32_t triangle_ = 0;
};

}  // namespace

const SteppedAlgorithm kPerimeterSteps{
    HiddenMethod::perimeter,
    "The perimeter method",
    "Wright 1973, as the problem book gives it (10.8)",
    "hidden/lines/perimeter_method.h",
    PerimeterSteps::kListing,
    PerimeterSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { PerimeterSteps(scene, record).run(); }};

}  // namespace displayfile
