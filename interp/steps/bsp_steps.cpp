#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hidden/exact/depth_order.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/piece_table.h"
#include "interp/steps/step_record.h"

namespace displayfile {

namespace {

/// SORT-POLYGONS and SAVE-POLYGONS-IN-ORDER (algorithms 9.8, 9.9 and 9.16) over COMPARE-POLYS as
/// the system runs it, with stacks in place of recursion. A polygon in the root's own plane is kept
/// with the root, where the chapter puts it in front, so that equally near ones stay in order of
/// entry.
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

  BspSteps(const StepScene& scene, StepRecord& record) : record_(record), table_(scene, record) {}

  void run() {
    std::vector<Index> all = table_.all();
    std::ranges::reverse(all);  // each polygon is linked to the one entered before it
    waiting_.push_back({std::move(all), PolygonTable::kNone, false});
    while (!waiting_.empty()) sort_list();
    walk();
  }

 private:
  using Index = PieceTable::Index;
  /// A list that hangs on a branch of a node.
  struct Branch {
    std::vector<Index> list;
    Index parent;
    bool in_front;
  };
  using List = std::vector<Index>;

  void sort_list() {
    const auto [list, parent, in_front] = std::move(waiting_.back());
    waiting_.pop_back();
    if (list.empty()) return;
    const Index root = list.front();
    front_.clear();
    back_.clear();
    begin_root(list, parent, in_front);
    for (std::size_t k = 1; k < list.size(); ++k) {
      compare(root, list[k]);
      show_lists(std::span(list).subspan(k + 1));
    }
    for (const bool front : {false, true})
      waiting_.push_back({front ? front_ : back_, root, front});
    if (front_.empty() && back_.empty()) return;
    record_.step(
        at("branch"),
        fmt::format("In front of {}: {}; in back of it: {}. The lists are sorted in the same way.",
                    name(root), names(front_), names(back_)));
    record_.mark(StepRole::root, table_.piece(root));
    for (const Index i : front_) record_.mark(StepRole::front, table_.piece(i));
    for (const Index i : back_) record_.mark(StepRole::back, table_.piece(i));
    show_lists({});
    show_waiting();
  }

  void begin_root(const List& list, Index parent, bool in_front) {
    const Index root = list.front();
    if (parent == PolygonTable::kNone) {
      record_.step(at("root"), fmt::format("{} was entered last: it becomes the root of the tree.",
                                           name(root)));
      root_ = root;
    } else {
      record_.step(at("root"), fmt::format("{} becomes the root of what is in {} of {}.",
                                           name(root), in_front ? "front" : "back", name(parent)));
      (in_front ? table_.entry(parent).front : table_.entry(parent).back) = root;
    }
    table_.entry(root).front = table_.entry(root).back = PolygonTable::kNone;
    record_.mark(StepRole::root, table_.piece(root));
    const int above =
        parent == PolygonTable::kNone ? StepNode::kNoParent : static_cast<int>(parent);
    node(root, above, in_front ? 1 : 0);
    show_lists(std::span(list).subspan(1));
    show_waiting();
  }

  void node(Index i, int parent, int branch) {
    record_.show_node(panel("tree"),
                      {static_cast<int>(i), parent, branch, name(i), table_.piece(i)});
  }

  void compare(Index root, Index test) {
    const PieceTable::Sides sides = table_.sides_of(test, table_.entry(root).plane);
    const std::string found = fmt::format(
        "of the vertices of {}, {} in front of the plane of {}, {} on it and {} behind", name(test),
        fmt::format("{} {}", sides.front.size(), sides.front.size() == 1 ? "is" : "are"),
        name(root), sides.on.size(), sides.back.size());
    if (!sides.front.empty() && !sides.back.empty()) {
      record_.step(at("cut"), capital(found + ": it is cut."));
      mark_comparison(root, test, sides, StepRole::cut);
      return cut(root, test);
    }
    if (!sides.front.empty()) {
      record_.step(at("front"), capital(found + ": it goes to the front list."));
      front_.insert(front_.begin(), test);
      mark_comparison(root, test, sides, StepRole::front);
    } else if (!sides.back.empty()) {
      record_.step(at("back"), capital(found + ": it goes to the back list."));
      back_.insert(back_.begin(), test);
      mark_comparison(root, test, sides, StepRole::back);
    } else {
      record_.step(at("on"), fmt::format("All of {} lies in the plane of {}: it is kept with it.",
                                         name(test), name(root)));
      table_.keep_on(root, test);
      mark_comparison(root, test, sides, StepRole::on);
      record_.show_node(panel("tree"), {static_cast<int>(root), 0, -1,
                                        record_.names(pieces_on(root)), table_.piece(root)});
    }
  }

  void mark_comparison(Index root, Index test, const PieceTable::Sides& sides, StepRole role) {
    record_.mark(StepRole::root, table_.piece(root));
    record_.mark(role, table_.piece(test));
    record_.mark(StepRole::front, sides.front, StepMark::Kind::points);
    record_.mark(StepRole::back, sides.back, StepMark::Kind::points);
    record_.mark(StepRole::on, sides.on, StepMark::Kind::points);
  }

  void cut(Index root, Index test) {
    const std::uint32_t whole = table_.piece(test);
    const PieceTable::Cut cut = table_.cut(test, table_.entry(root).plane);
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
    front_.insert(front_.begin(), cut.front);
    back_.insert(back_.begin(), cut.back);
    record_.step(
        at("link"),
        fmt::format(
            "{} is now {}, which goes to the front list, and {}, which goes to the back list.",
            record_.name(whole), name(cut.front), name(cut.back)));
    record_.mark(StepRole::root, table_.piece(root));
    record_.mark(StepRole::front, table_.piece(cut.front));
    record_.mark(StepRole::back, table_.piece(cut.back));
    record_.show(panel("e"), {});
    record_.show(panel("d"), {});
  }

  /// Algorithm 9.16: a node waits on the stack until what is in back of it is painted.
  void walk() {
    std::vector<Index> open;
    Index i = root_;
    while (i != PolygonTable::kNone || !open.empty()) {
      for (; i != PolygonTable::kNone; i = table_.entry(i).back) {
        if (open.empty() && i == root_) {
          record_.step(at("walk"),
                       fmt::format("The tree is whole: the walk begins at its root, {}.", name(i)));
          record_.mark(StepRole::root, table_.piece(i));
          show_lists({});
          show_waiting();
        }
        open.push_back(i);
        const Index back = table_.entry(i).back;
        if (back == PolygonTable::kNone) continue;
        record_.step(at("behind"),
                     fmt::format("First what is in back of {}: down to {}.", name(i), name(back)));
        record_.mark(StepRole::root, table_.piece(i));
        record_.mark(StepRole::back, table_.piece(back));
      }
      i = open.back();
      open.pop_back();
      paint(i);
      const Index front = table_.entry(i).front;
      if (front != PolygonTable::kNone) {
        record_.step(at("before"),
                     fmt::format("Then what is in front of {}: down to {}.", name(i), name(front)));
        record_.mark(StepRole::root, table_.piece(i));
        record_.mark(StepRole::front, table_.piece(front));
      }
      i = front;
    }
  }

  void paint(Index root) {
    for (const Index i : table_.in_plane_of(root)) {
      Step& step = record_.step(at("paint"), "");
      int gained = 0;
      for (const StepRun& run : table_.runs(i)) gained += record_.paint_over(run);
      step.sentence =
          fmt::format("All that {} hides is painted: {} is painted over it, {}.", name(i), name(i),
                      counted(static_cast<std::size_t>(gained), "pixel"));
      record_.mark(StepRole::seen, table_.piece(i));
    }
    record_.show_node(panel("tree"), {static_cast<int>(root), 0, -1, record_.names(pieces_on(root)),
                                      table_.piece(root), StepRole::seen});
  }

  std::vector<std::uint32_t> pieces_on(Index root) const {
    std::vector<std::uint32_t> pieces;
    for (const Index i : table_.in_plane_of(root)) pieces.push_back(table_.piece(i));
    return pieces;
  }
  const std::string& name(Index i) const { return record_.name(table_.piece(i)); }
  std::string names(const List& list) const {
    std::vector<std::uint32_t> pieces;
    for (const Index i : list) pieces.push_back(table_.piece(i));
    return record_.names(pieces);
  }
  static std::string capital(std::string sentence) {
    sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    return sentence;
  }
  std::vector<StepRow> rows(std::span<const Index> list, StepRole role = StepRole::none) const {
    return StepRecord::rows(list, [&](Index i) { return record_.row(table_.piece(i), role); });
  }
  void show_lists(std::span<const Index> rest) {
    record_.show(panel("list"), rows(rest));
    record_.show(panel("front"), rows(front_, StepRole::front));
    record_.show(panel("back"), rows(back_, StepRole::back));
  }
  void show_waiting() {
    std::vector<const Branch*> lists;  // the next first
    for (const Branch& branch : waiting_) {
      if (!branch.list.empty()) lists.push_back(&branch);
    }
    std::ranges::reverse(lists);
    record_.show(
        panel("waiting"), StepRecord::rows(lists, [&](const Branch* branch) {
          return StepRow{{fmt::format("{} {}: {}", branch->in_front ? "in front of" : "in back of",
                                      name(branch->parent), names(branch->list))}};
        }));
  }

  StepRecord& record_;
  PieceTable table_;
  std::vector<Branch> waiting_;
  List front_, back_;
  Index root_ = PolygonTable::kNone;
};

}  // namespace

const SteppedAlgorithm kBspSteps{
    HiddenMethod::bsp,
    "Binary space partition",
    "Fuchs, Kedem and Naylor 1980, as the chapter's algorithms 9.8 to 9.16 give it",
    BspSteps::kListing,
    BspSteps::kPanels,
    [](const StepScene& scene, StepRecord& record) { BspSteps(scene, record).run(); }};

}  // namespace displayfile
