#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "interp/steps/algorithms.h"
#include "interp/steps/step_box_tree.h"
#include "interp/steps/step_record.h"
#include "interp/visibility/sample_area.h"

namespace displayfile {

namespace {

/// Ray casting in image space, one ray at a time through the tree of boxes through which the system
/// casts packets. Successive rays of a row with the same way are recorded together.
class RayCastSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"tree", 0, "put a box around the pixels of each polygon, and the boxes into a tree"},
      {"ray", 0, "for each pixel, row by row, send a ray through its centre:"},
      {"", 1, "begin at the root of the tree; nothing is hit yet"},
      {"node", 1, "at a node, put the boxes that the ray meets on a stack, the nearest on top"},
      {"", 1, "take the top box off the stack, until there is none:"},
      {"skip", 2, "it begins farther away than what is hit: leave it out"},
      {"down", 2, "it holds other boxes: go on at its node"},
      {"", 2, "it holds a polygon: does the polygon cover the pixel's centre?"},
      {"miss", 3, "no: the ray misses it"},
      {"nearer", 3, "yes, and nearer than what is hit, or the same and later: it is what is hit"},
      {"farther", 3, "yes, but farther: it stays hidden"},
      {"seen", 1, "the pixel shows what is hit; if nothing is, the background"},
      {"same", 1, "rays beside it that go the same way see the same"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"tree", "Tree of boxes", PanelEntry::Kind::tree},
      {"stack", "Stack, the nearest first", PanelEntry::Kind::list},
      {"depths", "The row from above, and the ray", PanelEntry::Kind::profile},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  RayCastSteps(const StepItems& scene, StepRecord& record)
      : scene_(scene), record_(record), tree_(scene) {}

  void run() {
    tell_tree();
    if (tree_.targets().empty()) return;
    for (int row = 0; row < scene_.size().height; ++row) cast_row(row);
  }

 private:
  using Polygon = StepItems::Polygon;
  using Branch = StepBoxTree::Branch;

  /// An event on the way of a ray. Two ways are the same if their events are equal, in order.
  struct Met {
    enum class Kind { node, skip, miss, nearer, farther } kind;
    int node;  ///< of the tree, as it is numbered here
    bool operator==(const Met&) const = default;
  };
  struct Way {
    std::vector<Met> met;
    std::optional<Polygon> hit;
    bool operator==(const Way&) const = default;
  };

  void tell_tree() {
    record_.step(at("tree"), fmt::format("The tree holds the boxes of {}.",
                                         counted(tree_.targets().size(), "polygon")));
    for (const auto& target : tree_.targets()) record_.mark(StepRole::compared, target.pixels);
    int number = 0;
    for (const auto& [parent, branch, polygon] : tree_.nodes()) {
      record_.show_node(panel("tree"), {number++, parent, branch,
                                        polygon      ? record_.name(*polygon)
                                        : parent < 0 ? "root"
                                                     : "box",
                                        polygon.value_or(StepRow::kNoPiece)});
    }
  }

  // ---- Rays ------------------------------------------------------------------------------

  void cast_row(int row) {
    std::optional<Way> before;
    int first = 0;  // of the rays that go this way
    for (int column = 0; column < scene_.size().width; ++column) {
      const Way way = cast(column, row, false);
      if (before && way == *before) continue;
      tell_same(first, column, row, before);
      cast(column, row, true);
      before = way;
      first = column;
    }
    tell_same(first, scene_.size().width, row, before);
  }

  /// Records that all rays first < column < end go the way of the first.
  void tell_same(int first, int end, int row, const std::optional<Way>& way) {
    if (!way || end - first < 2) return;
    const std::string seen =
        way->hit ? fmt::format("see {}", record_.name(*way->hit)) : "see the background";
    record_.step(
        at("same"),
        fmt::format("The next {} the same way, and {}.",
                    end - first == 2 ? "ray goes" : fmt::format("{} rays go", end - first - 1),
                    end - first == 2 ? "sees" + seen.substr(3) : seen));
    if (way->hit) record_.paint_nearer({row, first + 1, end, *way->hit});
    record_.mark(way->hit ? StepRole::seen : StepRole::hidden,
                 PixelBox{first + 1, end, row, row + 1});
  }

  Way cast(int column, int row, bool tells) {
    Way way;
    const PixelBox ray{column, column + 1, row, row + 1};
    waiting_.clear();
    if (tells) {
      record_.step(at("ray"),
                   fmt::format("A ray goes through the centre of pixel {},{}.", column, row));
      mark(ray, {});
      record_.show(panel("stack"), {});
      profile(column, row, way.hit);
    }
    Branch branch{};
    const auto meets = [&](const PixelBoxes& boxes, StepBoxTree::Branches& nearest) {
      PixelTree::Lanes met;
      const std::vector<Branch> more = tree_.met_by(ray, boxes, met, nearest);
      waiting_.insert(waiting_.end(), more.begin(), more.end());
      const int node = tree_.number(boxes);
      way.met.push_back({Met::Kind::node, node});
      if (tells) {
        record_.step(
            node == 0 ? at("node") : at("down"),
            fmt::format("At {} the ray meets {}.", node == 0 ? "the root" : "the node of a box",
                        more.size() == 1 ? "1 box" : fmt::format("{} boxes", more.size())));
        mark(ray, node);
        show_stack();
      }
      return met;
    };
    tree_.near_to_far(
        meets,
        [&](const Branch& next) {
          branch = next;
          if (!waiting_.empty()) waiting_.pop_back();
          if (!way.hit || !tree_.is_behind(next.nearest, *way.hit, column, row)) return false;
          const int node = tree_.number(next);
          way.met.push_back({Met::Kind::skip, node});
          if (tells) {
            record_.step(
                at("skip"),
                fmt::format(
                    "The next box begins farther away than {}, which is hit: it is left out.",
                    record_.name(*way.hit)));
            mark(ray, node);
            show_stack();
          }
          return true;
        },
        [&](const StepBoxTree::Target& target) {
          hit(target, column, row, way, tree_.number(branch), tells);
        });
    if (tells) tell_seen(ray, way);
    return way;
  }

  void hit(const StepBoxTree::Target& target, int column, int row, Way& way, int node, bool tells) {
    const Polygon polygon = target.polygon;
    const bool covered =
        covers(scene_.viewed().vertices(target.fill), PixelCentre(column, row, scene_.size()));
    const bool seen = covered && (!way.hit || scene_.hides(polygon, *way.hit, column, row));
    const auto kind = !covered ? Met::Kind::miss : seen ? Met::Kind::nearer : Met::Kind::farther;
    way.met.push_back({kind, node});
    const auto before = way.hit;
    if (seen) way.hit = polygon;
    if (!tells) return;
    const std::string& name = record_.name(polygon);
    if (!covered) {
      record_.step(
          at("miss"),
          fmt::format("The box of {} is met, but {} does not cover the centre.", name, name));
    } else if (seen) {
      record_.step(at("nearer"),
                   before ? fmt::format("{} is hit, before {}.", name, record_.name(*before))
                          : fmt::format("{} is hit: it is the nearest so far.", name));
    } else {
      record_.step(at("farther"),
                   fmt::format("{} is hit, but behind {}.", name, record_.name(*before)));
    }
    record_.mark(covered ? (seen ? StepRole::seen : StepRole::hidden) : StepRole::compared,
                 polygon);
    mark({column, column + 1, row, row + 1}, node);
    show_stack();
    profile(column, row, way.hit);
  }

  void tell_seen(const PixelBox& ray, const Way& way) {
    record_.step(
        at("seen"),
        way.hit ? fmt::format("The stack is empty: the pixel shows {}.", record_.name(*way.hit))
                : "The stack is empty, and nothing is hit: the pixel shows the background.");
    if (way.hit) {
      record_.paint_nearer({ray.first_row, ray.first_column, ray.end_column, *way.hit});
      record_.mark(StepRole::seen, *way.hit);
    }
    mark(ray, {});
  }

  // ---- Marks and panels ------------------------------------------------------------------

  void mark(const PixelBox& ray, std::optional<int> node) {
    record_.mark(StepRole::active, ray);
    std::vector<StepRow> lit;
    if (node) lit.push_back({{std::to_string(*node)}, StepRow::kNoPiece, StepRole::active});
    record_.show(panel("tree"), std::move(lit));
  }

  void show_stack() {
    const std::vector<Branch> next_first(waiting_.rbegin(), waiting_.rend());
    record_.show(panel("stack"), StepRecord::rows(next_first, [&](const Branch& branch) {
                   const auto polygon =
                       tree_.nodes()[static_cast<std::size_t>(tree_.number(branch))].polygon;
                   return StepRow{
                       {fmt::format("{} from {:.3f}", polygon ? record_.name(*polygon) : "box",
                                    branch.nearest)},
                       polygon.value_or(StepRow::kNoPiece)};
                 }));
  }

  void profile(int column, int row, std::optional<Polygon> hit) {
    const double width = scene_.size().width;
    if (row != profile_row_) {
      profile_row_ = row;
      profile_.clear();
      for (const auto& [fill, polygon, pixels] : tree_.targets()) {
        for (const StepRun& run :
             scene_.coverage(polygon, {0, scene_.size().width, row, row + 1})) {
          profile_.push_back({run.first / width, scene_.depth(polygon, run.first, row),
                              run.end / width, scene_.depth(polygon, run.end - 1, row), polygon});
        }
      }
    }
    std::vector<StepSegment> segments = profile_;
    double low = 0.0, high = 1.0;
    for (const StepSegment& s : profile_) {
      low = std::min({low, s.z0, s.z1});
      high = std::max({high, s.z0, s.z1});
    }
    const double x = (column + 0.5) / width;
    segments.push_back({x, high, x, hit ? scene_.depth(*hit, column, row) : low, StepRow::kNoPiece,
                        StepRole::active});
    record_.show_segments(panel("depths"), std::move(segments));
  }

  const StepItems& scene_;
  StepRecord& record_;
  StepBoxTree tree_;
  std::vector<Branch> waiting_;
  std::vector<StepSegment> profile_;
  int profile_row_ = -1;
};

}  // namespace

const SteppedAlgorithm kRayCastSteps{
    HiddenMethod::ray_cast,
    "Ray casting",
    "The lecture's section 5, in image space, through a tree of boxes",
    "interp/steps/ray_cast_steps.cpp",
    RayCastSteps::kListing,
    RayCastSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { RayCastSteps(scene, record).run(); }};

}  // namespace displayfile
