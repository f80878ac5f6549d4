#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "interp/steps/algorithms.h"
#include "interp/steps/step_record.h"
#include "interp/visibility/plain_warnock.h"

namespace displayfile {

namespace {

/// Observer of the plain subdivision (interp/visibility/plain_warnock.h).
class WarnockSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"start", 0, "put the whole picture on the stack of areas, all polygons in its list"},
      {"area", 0, "take the next area off the stack, and make its list:"},
      {"", 1, "what surrounds the area that it is a part of surrounds it too"},
      {"", 1, "each other polygon surrounds it, intersects it, is contained, or is disjoint"},
      {"", 1, "strike off what is disjoint, and what one that surrounds it hides all over it"},
      {"background", 1, "(a) the list is empty: the area is background"},
      {"one", 1, "(b) one polygon, which does not surround it: scan-convert it on the background"},
      {"surrounded", 1, "(c) one polygon, which surrounds it: the area shows it"},
      {"pixel", 1, "(d) the area is a pixel: it shows the nearest of its list"},
      {"divide", 1, "otherwise divide it, and put its parts on the stack"},
      {"end", 0, "the stack is empty: the picture is done"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"list", "The area's potentially visible polygons", PanelEntry::Kind::table,
       "polygon|how it lies to the area"},
      {"stack", "Areas on the stack, the next first", PanelEntry::Kind::list},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  WarnockSteps(const StepItems& scene, StepRecord& record) : scene_(scene), record_(record) {}

  void run() {
    const auto [width, height] = scene_.size();
    stack_.push_back({0, width, 0, height});
    record_.step(at("start"), fmt::format("The first area is the whole picture, its list all {}.",
                                          counted(scene_.fills().size(), "polygon")));
    record_.mark(StepRole::active, stack_.back());
    show_stack();
    PlainWarnock warnock;
    warnock.prepare({scene_.viewed(), scene_.size(), {}}, 1);
    warnock.draw_rows(
        0, height, [](int, int, std::span<const Fill>) {}, *this);
    record_.step(at("end"), "No area is left: this is the picture.");
    record_.show(panel("list"), {});
    show_stack();
  }

  using Fill = ViewedScene::Fill;

  void remove(Fill hidden, Fill by) { removed_.push_back({hidden, by}); }
  void part(const SampleArea& area) { stack_.push_back(area); }
  void paint(Fill fill, int row, int first, int end) {
    record_.paint_over({row, first, end, polygon(fill)});
  }
  /// Records the examination of an area in one step, unless its list is empty, and the decision in
  /// another.
  void visit(const PlainWarnock::Visit& visited) {
    stack_.pop_back();
    if (!visited.list.empty()) look_at(visited);
    removed_.clear();
    decide(visited);
  }

 private:
  struct Removed {
    Fill hidden, by;
  };

  StepItems::Polygon polygon(Fill fill) const { return scene_.viewed().item_of(fill); }
  const std::string& name(Fill fill) const { return record_.name(polygon(fill)); }

  static std::string words(const SampleArea& area) {
    if (is_pixel(area)) return fmt::format("pixel {},{}", area.first_column, area.first_row);
    return fmt::format("columns {} to {}, rows {} to {}", area.first_column, area.end_column - 1,
                       area.first_row, area.end_row - 1);
  }
  static std::string subject(const SampleArea& area) {
    std::string sentence = words(area);
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    return sentence;
  }
  static std::string_view words(AreaCategory category) {
    switch (category) {
      case AreaCategory::surrounding: return "surrounds it";
      case AreaCategory::intersecting: return "intersects it";
      case AreaCategory::contained: return "is contained in it";
      case AreaCategory::disjoint: break;
    }
    return "is disjoint";
  }

  void look_at(const PlainWarnock::Visit& visited) {
    std::string sentence = subject(visited.area) + ": ";
    bool first = true;
    for (const auto& [fill, category] :
         visited.list.first(std::min(visited.list.size(), StepRecord::kMostNames))) {
      sentence += fmt::format("{}{} {}", first ? "" : ", ", name(fill), words(category));
      first = false;
    }
    if (visited.list.size() > StepRecord::kMostNames) {
      sentence += fmt::format(" and {} more", visited.list.size() - StepRecord::kMostNames);
    }
    if (removed_.size() > StepRecord::kMostNames) {
      sentence += fmt::format("; {} are struck off, for others hide them here", removed_.size());
    }
    for (const auto& [hidden, by] : removed_) {
      if (removed_.size() > StepRecord::kMostNames) break;
      sentence += fmt::format("; {} is struck off, for {} hides it here", name(hidden), name(by));
    }
    record_.step(at("area"), sentence + ".");
    mark_list(visited);
    record_.mark(StepRole::active, visited.area);
    show_stack();
  }

  void decide(const PlainWarnock::Visit& visited) {
    const auto& [area, list, decision] = visited;
    StepRole role = StepRole::seen;
    switch (decision) {
      case PlainWarnock::Decision::background:
        record_.step(at("background"),
                     fmt::format("{}: nothing is in it. It is background.", subject(area)));
        role = StepRole::hidden;
        break;
      case PlainWarnock::Decision::surrounded:
        record_.step(at("surrounded"),
                     fmt::format("{} alone is left, and surrounds the area: it shows {}.",
                                 name(list[0].fill), name(list[0].fill)));
        break;
      case PlainWarnock::Decision::one_polygon:
        record_.step(at("one"),
                     fmt::format("{} alone is left: it is scan-converted on the background.",
                                 name(list[0].fill)));
        break;
      case PlainWarnock::Decision::pixel:
        record_.step(at("pixel"), fmt::format("The area is a pixel: it shows the nearest of {}.",
                                              counted(list.size(), "polygon")));
        break;
      case PlainWarnock::Decision::subdivided:
        record_.step(at("divide"),
                     fmt::format("None of the tests holds with {}: the area is divided.",
                                 counted(list.size(), "polygon")));
        role = StepRole::active;
        break;
    }
    mark_list(visited);
    record_.mark(role, area);
    if (role != StepRole::active && !is_pixel(area)) record_.mark(role, area, true);
    if (role == StepRole::hidden) show_stack();
  }

  void mark_list(const PlainWarnock::Visit& visited) {
    auto rows = StepRecord::rows(visited.list, [&](const PlainWarnock::Listed& listed) {
      record_.mark(StepRole::compared, polygon(listed.fill));
      return StepRow{{name(listed.fill), std::string(words(listed.category))},
                     polygon(listed.fill)};
    });
    auto removed = StepRecord::rows(removed_, [&](const Removed& r) {
      record_.mark(StepRole::hidden, polygon(r.hidden));
      return StepRow{{name(r.hidden), fmt::format("is behind {}", name(r.by))},
                     polygon(r.hidden),
                     StepRole::hidden};
    });
    rows.insert(rows.end(), removed.begin(), removed.end());
    record_.show(panel("list"), std::move(rows));
  }

  void show_stack() {
    const std::vector<SampleArea> next_first(stack_.rbegin(), stack_.rend());
    record_.show(panel("stack"), StepRecord::rows(next_first, [](const SampleArea& area) {
                   return StepRow{{words(area)}};
                 }));
  }

  const StepItems& scene_;
  StepRecord& record_;
  std::vector<SampleArea> stack_;
  std::vector<Removed> removed_;
};

}  // namespace

const SteppedAlgorithm kWarnockSteps{
    HiddenMethod::warnock,
    "Warnock's area subdivision",
    "Warnock 1969; the chapter's section \"Warnock's algorithm\", the problem book's 10.6",
    "interp/visibility/plain_warnock.h",
    WarnockSteps::kListing,
    WarnockSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { WarnockSteps(scene, record).run(); }};

}  // namespace displayfile
