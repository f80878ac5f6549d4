#include <fmt/format.h>

#include "hidden/lines/convex_objects.h"
#include "hidden/lines/roberts_finder.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_lines.h"

namespace displayfile {

namespace {

/// Observer of the system's form of Roberts's method (hidden/lines/roberts.md): records the objects
/// against which a line is tested.
class RobertsSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"objects", 0, "join polygons that have a convex outline together into objects"},
      {"line", 0, "for each line that is drawn:"},
      {"", 1, "for each object whose box meets the line's in the picture:"},
      {"farther", 2, "no part of the object is nearer than the line: it hides nothing"},
      {"nothing", 2, "the line is on the outer side of the outline: it hides nothing"},
      {"all", 2, "the line is within it, and behind all its planes: it hides all"},
      {"some", 2, "otherwise hold the line against each polygon of the object:"},
      {"misses", 3, "it covers no part of the line, or is nowhere nearer: nothing"},
      {"hides", 3, "where it covers the line and is nearer, there is a hidden part"},
      {"seen", 1, "draw what is hidden nowhere"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"hidden", "Hidden of the line, in shares of it", PanelEntry::Kind::table,
       "by|from|to|where"},
      {"objects", "Objects", PanelEntry::Kind::list},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  RobertsSteps(const StepItems& scene, StepRecord& record)
      : record_(record),
        lines_(scene, record),
        objects_(lines_.items(), lines_.lines()),
        tree_(extent_tree(objects_.extents(), 1)),
        finder_(lines_.lines(), objects_, tree_, lines_.policy(), Observer{this}) {}

  void run() {
    record_.step(at("objects"), fmt::format("There are {} to hold lines against.",
                                            counted(objects_.size(), "object")));
    std::vector<std::uint32_t> objects;
    for (std::uint32_t k = 0; k < objects_.size(); ++k) {
      objects.push_back(k);
      mark_object(StepRole::compared, k);
    }
    record_.show(panel("objects"), StepRecord::rows(objects, [&](std::uint32_t object) {
                   return StepRow{{name(object)}};
                 }));
    lines_.find_all(lines_.lines().first_lines(), *this, at("seen"));
  }

  /// Called by find_seen.
  const std::vector<PartOfLine>& hidden_parts(const LineTable::Line& line) {
    line_ = &line;
    hidden_.clear();
    record_.step(at("line"), fmt::format("Which parts of {} are seen?", lines_.name(line)));
    show();
    return finder_.hidden_parts(line);
  }

 private:
  struct Observer {
    RobertsSteps* steps;
    void farther(std::uint32_t object) const { steps->tell_farther(object); }
    void volume(std::uint32_t object, ObjectHides hides) const {
      steps->tell_volume(object, hides);
    }
    void compared(std::uint32_t polygon) const { steps->tell_polygon(polygon); }
  };

  std::string name(std::uint32_t object) const { return record_.names(objects_.polygons(object)); }

  void tell_farther(std::uint32_t object) {
    record_.step(at("farther"),
                 fmt::format("No part of {} is nearer than the line: nothing is hidden by it.",
                             name(object)));
    mark_object(StepRole::back, object);
    show();
  }

  void tell_volume(std::uint32_t object, ObjectHides hides) {
    const bool single = objects_.outline(object).empty();
    switch (hides) {
      case ObjectHides::nothing:
        record_.step(
            at("nothing"),
            fmt::format("The line is outside of the outline of {}: nothing is hidden by it.",
                        name(object)));
        mark_object(StepRole::back, object);
        break;
      case ObjectHides::all:
        record_.step(
            at("all"),
            fmt::format("The line is within the outline of {}, and behind it: all is hidden.",
                        name(object)));
        hidden_.push_back({{name(object), "0", "1", "both sides"}, objects_.polygons(object)[0]});
        mark_object(StepRole::front, object);
        break;
      case ObjectHides::some:
        if (single) return;
        record_.step(
            at("some"),
            fmt::format(
                "The line may be behind a part of {}: it is compared with each of its polygons.",
                name(object)));
        mark_object(StepRole::compared, object);
        break;
    }
    show();
  }

  void tell_polygon(std::uint32_t polygon) {
    lines_.tell_covered(polygon, *line_, {at("misses"), at("hides")}, hidden_);
    show();
  }

  void mark_object(StepRole role, std::uint32_t object) {
    for (const std::uint32_t polygon : objects_.polygons(object)) record_.mark(role, polygon);
  }
  void show() {
    lines_.mark(StepRole::root, *line_);
    record_.show(panel("hidden"), hidden_);
  }

  StepRecord& record_;
  StepLines lines_;
  ConvexObjects objects_;
  ExtentTree tree_;
  Roberts<ExactLines, Observer> finder_;
  const LineTable::Line* line_ = nullptr;
  std::vector<StepRow> hidden_;
};

}  // namespace

const SteppedAlgorithm kRobertsSteps{
    HiddenMethod::roberts,
    "Roberts's hidden lines",
    "Roberts 1963; the chapter's section \"Hidden-line methods\"",
    "hidden/lines/roberts_finder.h",
    RobertsSteps::kListing,
    RobertsSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { RobertsSteps(scene, record).run(); }};

}  // namespace displayfile
