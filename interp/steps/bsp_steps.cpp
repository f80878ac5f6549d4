#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "hidden/sort/plain_bsp.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/piece_table.h"
#include "interp/steps/step_record.h"

namespace displayfile {

namespace {

/// Observer of the plain binary space partition (hidden/sort/plain_bsp.h).
class BspSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"sort", 0, "sort a list of polygons into a branch of the tree:"},
      {"root", 1, "the first of the list becomes the root"},
      {"", 1, "for each other polygon of the list, in order:"},
      {"", 2, "find the side of the root's plane that each vertex is on"},
      {"front", 2, "none behind: link it into the front list"},
      {"back", 2, "none in front: link it into the back list"},
      {"on", 2, "all in the plane: keep it with the root"},
      {"cut", 2, "some on either side: cut it, going round its sides:"},
      {"e", 3, "the half of its first vertex goes to the E buffer"},
      {"d", 3, "the other half goes to the D buffer, crossings to both"},
      {"link", 3, "link each half into the list of its side"},
      {"branch", 1, "sort the front list and the back list in the same way"},
      {"walk", 0, "then walk the tree, the viewer in front of every plane:"},
      {"behind", 1, "first the branch in back of the root"},
      {"paint", 1, "then paint the root over all that is there"},
      {"before", 1, "then the branch in front of the root"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"tree", "Tree so far (in back left, in front right)", PanelEntry::Kind::tree},
      {"list", "List being sorted", PanelEntry::Kind::list},
      {"front", "Front list", PanelEntry::Kind::list},
      {"back", "Back list", PanelEntry::Kind::list},
      {"e", "E buffer", PanelEntry::Kind::list},
      {"d", "D buffer, new sides", PanelEntry::Kind::list},
      {"waiting", "Lists still to be sorted", PanelEntry::Kind::list},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  BspSteps(const StepItems& scene, StepRecord& record)
      : record_(record), table_(scene, record), bsp_(table_.to_sort(), table_.comparing(), *this) {}

  void run() { bsp_.sort_all(); }

  using Index = PieceTable::Index;
  using List = std::vector<Index>;

  void begin_root(Index root, Index parent, bool in_front) {
    const bool is_first = parent == PolygonTable::kNone;
    record_.step(
        at("root"),
        is_first ? fmt::format("{} was entered last: it becomes the root of the tree.", name(root))
                 : fmt::format("{} becomes the root of what is in {} of {}.", name(root),
                               in_front ? "front" : "back", name(parent)));
    record_.mark(StepRole::root, table_.piece(root));
    record_.show_node(panel("tree"), {static_cast<int>(root),
                                      is_first ? StepNode::kNoParent : static_cast<int>(parent),
                                      in_front ? 1 : 0, name(root), table_.piece(root)});
    show_lists();
    show_waiting();
  }

  void compared(Index root, Index test, PlaneSide side) {
    const PieceTable::Sides sides = table_.sides_of(test, table_.entry(root).plane);
    const std::string found = fmt::format(
        "Of the vertices of {}, {} {} in front of the plane of {}, {} on it and {} "
        "behind: it ",
        name(test), sides.front.size(), sides.front.size() == 1 ? "is" : "are", name(root),
        sides.on.size(), sides.back.size());
    StepRole role = StepRole::on;
    switch (side) {
      case PlaneSide::both:
        record_.step(at("cut"), found + "is cut.");
        role = StepRole::cut;
        break;
      case PlaneSide::front:
        record_.step(at("front"), found + "goes to the front list.");
        role = StepRole::front;
        break;
      case PlaneSide::back:
        record_.step(at("back"), found + "goes to the back list.");
        role = StepRole::back;
        break;
      case PlaneSide::on:
        record_.step(at("on"), fmt::format("All of {} lies in the plane of {}: it is kept with it.",
                                           name(test), name(root)));
        break;
    }
    record_.mark(StepRole::root, table_.piece(root));
    record_.mark(role, table_.piece(test));
    record_.mark(StepRole::front, sides.front, StepMark::Kind::points);
    record_.mark(StepRole::back, sides.back, StepMark::Kind::points);
    record_.mark(StepRole::on, sides.on, StepMark::Kind::points);
  }

  void cut(Index root, Index test, Index front, Index back) {
    const std::uint32_t whole = table_.piece(test);
    const PieceTable::Cut cut = table_.note_cut(test, table_.entry(root).plane, {front, back});
    const auto tell = [&](bool in_e) {
      const auto& put = in_e ? cut.in_e : cut.in_d;
      record_.step(
          in_e ? at("e") : at("d"),
          fmt::format("The half of {} {} goes to the {} buffer: {}, {} of them where it "
                      "crosses the plane of {}.",
                      record_.name(whole), in_e ? "with its first vertex" : "beyond the plane",
                      in_e ? "E" : "D", counted(put.size(), "side"), cut.crossings, name(root)));
      record_.mark(StepRole::root, table_.piece(root));
      record_.mark(StepRole::compared, whole);
      std::vector<Point2> points;
      std::vector<StepRow> rows;
      for (const auto& [point, crosses] : put) {
        points.push_back(flat(point));
        rows.push_back({{fmt::format("{:.3f} {:.3f} {:.3f}", point.x, point.y, point.z)},
                        StepRow::kNoPiece,
                        crosses ? StepRole::cut : StepRole::none});
      }
      record_.mark(StepRole::cut, points, StepMark::Kind::points);
      points.push_back(points.front());
      record_.mark(StepRole::active, points, StepMark::Kind::line);
      record_.show(in_e ? panel("e") : panel("d"), std::move(rows));
    };
    tell(true);
    tell(false);
    record_.step(
        at("link"),
        fmt::format(
            "{} is now {}, which goes to the front list, and {}, which goes to the back list.",
            record_.name(whole), name(front), name(back)));
    record_.mark(StepRole::root, table_.piece(root));
    record_.mark(StepRole::front, table_.piece(front));
    record_.mark(StepRole::back, table_.piece(back));
    record_.show(panel("e"), {});
    record_.show(panel("d"), {});
  }

  void kept(Index root) { show_looks(root, bsp_.in_plane_of(root), StepRole::none); }
  void linked() { show_lists(); }

  void end_root(Index root) {
    if (bsp_.front().empty() && bsp_.back().empty()) return;
    record_.step(
        at("branch"),
        fmt::format("In front of {}: {}; in back of it: {}. The lists are sorted in the same way.",
                    name(root), names(bsp_.front()), names(bsp_.back())));
    record_.mark(StepRole::root, table_.piece(root));
    for (const Index i : as_linked(bsp_.front())) record_.mark(StepRole::front, table_.piece(i));
    for (const Index i : as_linked(bsp_.back())) record_.mark(StepRole::back, table_.piece(i));
    show_lists();
    show_waiting();
  }

  void begin_walk(Index root) {
    record_.step(at("walk"),
                 fmt::format("The tree is whole: the walk begins at its root, {}.", name(root)));
    record_.mark(StepRole::root, table_.piece(root));
    show_lists();
    show_waiting();
  }

  void behind(Index root, Index back) {
    record_.step(at("behind"),
                 fmt::format("First what is in back of {}: down to {}.", name(root), name(back)));
    record_.mark(StepRole::root, table_.piece(root));
    record_.mark(StepRole::back, table_.piece(back));
  }

  void before(Index root, Index front) {
    record_.step(at("before"),
                 fmt::format("Then what is in front of {}: down to {}.", name(root), name(front)));
    record_.mark(StepRole::root, table_.piece(root));
    record_.mark(StepRole::front, table_.piece(front));
  }

  void paint(Index root, const List& in_plane) {
    for (const Index i : in_plane) {
      Step& step = record_.step(at("paint"), "");
      int gained = 0;
      for (const StepRun& run : table_.runs(i)) gained += record_.paint_over(run);
      step.sentence =
          fmt::format("All that {} hides is painted: {} is painted over it, {}.", name(i), name(i),
                      counted(static_cast<std::size_t>(gained), "pixel"));
      record_.mark(StepRole::seen, table_.piece(i));
    }
    show_looks(root, in_plane, StepRole::seen);
  }

 private:
  const std::string& name(Index i) const { return record_.name(table_.piece(i)); }
  std::vector<std::uint32_t> pieces(const List& list) const {
    std::vector<std::uint32_t> pieces;
    for (const Index i : list) pieces.push_back(table_.piece(i));
    return pieces;
  }
  /// The list in reverse order of linking: the last one linked in comes first.
  static List as_linked(const List& list) { return {list.rbegin(), list.rend()}; }
  std::string names(const List& list) const { return record_.names(pieces(as_linked(list))); }
  void show_looks(Index root, const List& in_plane, StepRole role) {
    record_.show_node(panel("tree"), {static_cast<int>(root), 0, -1,
                                      record_.names(pieces(in_plane)), table_.piece(root), role});
  }
  void show_list(int panel, const List& list, StepRole role) {
    record_.show(panel, StepRecord::rows(as_linked(list), [&](Index i) {
                   return record_.row(table_.piece(i), role);
                 }));
  }
  void show_lists() {
    show_list(panel("list"), bsp_.rest(), StepRole::none);
    show_list(panel("front"), bsp_.front(), StepRole::front);
    show_list(panel("back"), bsp_.back(), StepRole::back);
  }
  void show_waiting() {
    std::vector<const Bsp::Branch*> lists;  // the next first
    for (const Bsp::Branch& branch : bsp_.waiting()) {
      if (!branch.list.empty()) lists.push_back(&branch);
    }
    std::ranges::reverse(lists);
    record_.show(
        panel("waiting"), StepRecord::rows(lists, [&](const Bsp::Branch* branch) {
          return StepRow{{fmt::format("{} {}: {}", branch->in_front ? "in front of" : "in back of",
                                      name(branch->parent), names(branch->list))}};
        }));
  }

  using Bsp = PlainBsp<Exact, BspSteps, PieceTable::Comparing>;

  StepRecord& record_;
  PieceTable table_;
  Bsp bsp_;
};

}  // namespace

const SteppedAlgorithm kBspSteps{
    HiddenMethod::bsp,
    "Binary space partition",
    "Fuchs, Kedem and Naylor 1980, as the chapter's algorithms 9.8 to 9.16 give it",
    "hidden/sort/plain_bsp.h",
    BspSteps::kListing,
    BspSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { BspSteps(scene, record).run(); }};

}  // namespace displayfile
