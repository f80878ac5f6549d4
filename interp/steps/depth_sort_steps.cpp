#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "hidden/sort/overlap.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/piece_table.h"
#include "interp/steps/step_record.h"

namespace displayfile {

namespace {

/// The lecture's depth sort with the problem book's tests 0 to 5 and its tags. The system's own
/// (hidden/sort/depth_sort.md) makes a graph of the same tests; this is the books' list.
///
/// The books cut by the plane of P alone. Where three polygons hide one another in turn, and none
/// crosses the plane of the one that it is tested against, that plane cuts nothing: then the plane
/// of Q cuts P, or a plane through a side of one of them and the viewer the other. There are
/// finitely many such planes and each cut parts a polygon for good, so that it ends.
class DepthSortSteps {
 public:
  static constexpr auto kListing = std::to_array<ListingLine>({
      {"order", 0, "order the list by the farthest point, the farthest polygon first"},
      {"first", 0, "until the list is empty, P is the first of it"},
      {"", 1, "test P against each other polygon Q of the list:"},
      {"0", 2, "0: is the farthest of Q nearer than the nearest of P?"},
      {"1", 2, "1: are they apart in y?"},
      {"2", 2, "2: are they apart in x?"},
      {"3", 2, "3: is all of P behind the plane of Q, or on it?"},
      {"4", 2, "4: is all of Q before the plane of P, or on it?"},
      {"5", 2, "5: are their projections apart?"},
      {"", 2, "one yes is enough: P does not hide Q"},
      {"fail", 1, "all six are no: P may hide Q"},
      {"swap", 2, "Q has no tag: tag it, and move it to the front: it is P now"},
      {"cut", 2, "Q has one, they hide one another: cut it by P's plane"},
      {"insert", 3, "put both halves, without tags, where they belong in the list"},
      {"paint", 1, "P hides none of them: paint it and strike it off the list"},
  });
  static constexpr auto kPanels = std::to_array<PanelEntry>({
      {"list", "List, the first is P", PanelEntry::Kind::table, "polygon|farthest z|nearest z|tag"},
      {"tests", "Tests of P against Q", PanelEntry::Kind::table, "test|question|answer"},
      {"painted", "Painted, the last first", PanelEntry::Kind::list},
  });
  static consteval int at(std::string_view name) { return number_named(kListing, name); }
  static consteval int panel(std::string_view name) { return number_named(kPanels, name); }

  DepthSortSteps(const StepItems& scene, StepRecord& record)
      : scene_(scene), record_(record), table_(scene, record) {}

  void run() {
    for (const Index i : table_.all()) list_.push_back({i, table_.sorted().extent(i), false});
    std::ranges::stable_sort(list_, {}, [](const Listed& p) { return p.extent.z_min; });
    if (list_.empty()) return;
    record_.step(at("order"), fmt::format("The list has {}, ordered by their farthest points.",
                                          counted(list_.size(), "polygon")));
    show_list();
    while (!list_.empty()) {
      record_.step(at("first"),
                   fmt::format("The first of the list is {}: it is tested against all others.",
                               name(list_.front())));
      record_.mark(StepRole::root, piece(list_.front()));
      show_list();
      if (const auto hidden = first_perhaps_hidden()) {
        resolve(*hidden);
      } else {
        paint();
      }
    }
  }

 private:
  using Index = PieceTable::Index;
  struct Listed {
    Index entry;
    Extent extent;
    bool tagged;
  };
  static constexpr int kTests = 6;

  std::uint32_t piece(const Listed& p) const { return table_.piece(p.entry); }
  const std::string& name(const Listed& p) const { return record_.name(piece(p)); }
  std::uint32_t plane(const Listed& p) const { return table_.entry(p.entry).plane; }
  bool is_apart_from(const Listed& of, const Listed& from, int side) const {
    const auto sides = table_.sides_of(of.entry, plane(from));
    return side > 0 ? sides.back.empty() : sides.front.empty();
  }

  bool passes(int test, const Listed& p, const Listed& q) const {
    const SortTables<Exact>& sorted = table_.sorted();
    switch (test) {
      case 0: return q.extent.z_min > p.extent.z_max;
      case 1: return p.extent.y_max < q.extent.y_min || q.extent.y_max < p.extent.y_min;
      case 2: return p.extent.x_max < q.extent.x_min || q.extent.x_max < p.extent.x_min;
      case 3: return is_apart_from(p, q, -1);
      case 4: return is_apart_from(q, p, 1);
      default:
        return !overlap_in_projection(sorted.vertices, sorted.outline(p.entry),
                                      sorted.outline(q.entry));
    }
  }

  /// The place of the first Q for which all tests are inconclusive.
  std::optional<std::size_t> first_perhaps_hidden() {
    const Listed& p = list_.front();
    for (std::size_t k = 1; k < list_.size(); ++k) {
      const Listed& q = list_[k];
      int test = 0;
      while (test < kTests && !passes(test, p, q)) ++test;
      tell_test(p, q, test);
      if (test == kTests && can_resolve(q)) return k;
    }
    return std::nullopt;
  }

  void tell_test(const Listed& p, const Listed& q, int passed) {
    static constexpr std::array<int, kTests> kLines{at("0"), at("1"), at("2"),
                                                    at("3"), at("4"), at("5")};
    static constexpr std::array<std::string_view, kTests> kQuestions{
        "apart in z",         "apart in y",         "apart in x",
        "P behind Q's plane", "Q before P's plane", "projections apart"};
    const std::array<std::string, kTests> why{
        fmt::format("the farthest of {} is nearer than the nearest of {}", name(q), name(p)),
        fmt::format("{} and {} are apart in y", name(p), name(q)),
        fmt::format("{} and {} are apart in x", name(p), name(q)),
        fmt::format("all of {} is behind the plane of {}, or on it", name(p), name(q)),
        fmt::format("all of {} is before the plane of {}, or on it", name(q), name(p)),
        fmt::format("the projections of {} and {} are apart", name(p), name(q))};
    if (passed < kTests) {
      const auto k = static_cast<std::size_t>(passed);
      record_.step(kLines[k], fmt::format("Test {}: {}. So {} does not hide {}.", passed, why[k],
                                          name(p), name(q)));
    } else {
      record_.step(at("fail"), fmt::format("No test parts {} from {}: {} may hide {}.", name(p),
                                           name(q), name(p), name(q)));
    }
    record_.mark(StepRole::root, piece(p));
    record_.mark(StepRole::compared, piece(q));
    std::vector<StepRow> rows;
    rows.reserve(kTests);
    for (int k = 0; k < kTests; ++k) {
      rows.push_back({{std::to_string(k), std::string(kQuestions[static_cast<std::size_t>(k)]),
                       k < passed    ? "no"
                       : k == passed ? "yes"
                                     : ""},
                      StepRow::kNoPiece,
                      k == passed ? StepRole::front : StepRole::none});
    }
    record_.show(panel("tests"), std::move(rows));
  }

  /// A cut of one of two polygons that hide each other.
  struct Parting {
    bool cuts_p;
    std::uint32_t plane;
    std::string by;
  };

  bool is_cut(const Listed& p, std::uint32_t plane) const {
    const auto sides = table_.sides_of(p.entry, plane);
    return !sides.front.empty() && !sides.back.empty();
  }

  /// The first plane that cuts one of the two: P's, Q's, those of sides of both, then those of all
  /// others. None only if the projections are disjoint after all, which test 5 may miss for
  /// polygons that are not convex.
  std::optional<Parting> parting(const Listed& p, const Listed& q) {
    const auto by_plane = [&](const Listed& of) -> std::optional<Parting> {
      const std::string by = fmt::format("the plane of {}", name(of));
      if (is_cut(q, plane(of))) return Parting{false, plane(of), by};
      if (is_cut(p, plane(of))) return Parting{true, plane(of), by};
      return std::nullopt;
    };
    const auto by_sides = [&](const Listed& of) -> std::optional<Parting> {
      const auto polygon = table_.polygon(of.entry);
      const auto corners = static_cast<std::uint32_t>(scene_.viewed().points(polygon).size());
      for (std::uint32_t corner = 0; corner < corners; ++corner) {
        const auto upright = table_.upright_plane(polygon, corner);
        const std::string by =
            fmt::format("a plane through a side of {} and the viewer", name_of_polygon(polygon));
        if (is_cut(q, upright)) return Parting{false, upright, by};
        if (is_cut(p, upright)) return Parting{true, upright, by};
      }
      return std::nullopt;
    };
    for (const Listed* of : {&p, &q}) {
      if (auto found = by_plane(*of)) return found;
    }
    for (const Listed* of : {&p, &q}) {
      if (auto found = by_sides(*of)) return found;
    }
    for (const Listed& of : list_) {
      if (auto found = by_plane(of)) return found;
      if (auto found = by_sides(of)) return found;
    }
    return std::nullopt;
  }

  bool can_resolve(const Listed& q) { return !q.tagged || parting(list_.front(), q).has_value(); }

  void resolve(std::size_t k) {
    Listed q = list_[k];
    if (!q.tagged) {
      record_.step(
          at("swap"),
          fmt::format("{} has no tag: it is tagged, and moves to the front of the list.", name(q)));
      record_.mark(StepRole::tagged, piece(q));
      record_.mark(StepRole::root, piece(list_.front()));
      q.tagged = true;
      list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(k));
      list_.insert(list_.begin(), q);
      return show_list();
    }
    const Parting parts = *parting(list_.front(), q);
    const std::size_t place = parts.cuts_p ? 0 : k;
    const Listed whole = list_[place];
    const std::uint32_t whole_piece = piece(whole);
    record_.step(
        at("cut"),
        fmt::format("{} is tagged: it was moved before, so {} and {} hide one another, perhaps by "
                    "way of others. {} is cut by {}.",
                    name(q), name(list_.front()), name(q), name(whole), parts.by));
    record_.mark(StepRole::root, piece(list_[parts.cuts_p ? k : 0]));
    record_.mark(StepRole::cut, whole_piece);
    list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(place));
    const auto [front, back, in_e, in_d, crossings] = table_.cut(whole.entry, parts.plane);
    for (const Index half : {back, front}) insert({half, table_.sorted().extent(half), false});
    record_.step(at("insert"),
                 fmt::format("{} has become {} and {}, which are put into the list by their "
                             "farthest points.",
                             record_.name(whole_piece), record_.name(table_.piece(back)),
                             record_.name(table_.piece(front))));
    record_.mark(StepRole::back, table_.piece(back));
    record_.mark(StepRole::front, table_.piece(front));
    show_list();
  }

  void insert(const Listed& p) {
    const auto farther = [&](const Listed& other) { return other.extent.z_min > p.extent.z_min; };
    list_.insert(std::ranges::find_if(list_, farther), p);
  }

  void paint() {
    const Listed p = list_.front();
    Step& step = record_.step(at("paint"), "");
    int gained = 0;
    for (const StepRun& run : table_.runs(p.entry)) gained += record_.paint_over(run);
    step.sentence = fmt::format("{} hides nothing that is left: it is painted, {}.", name(p),
                                counted(static_cast<std::size_t>(gained), "pixel"));
    record_.mark(StepRole::seen, piece(p));
    painted_.insert(painted_.begin(), piece(p));
    record_.show(panel("painted"), StepRecord::rows(painted_, [&](std::uint32_t painted) {
                   return record_.row(painted);
                 }));
    list_.erase(list_.begin());
    show_list();
    record_.show(panel("tests"), {});
  }

  void show_list() {
    record_.show(panel("list"), StepRecord::rows(list_, [&](const Listed& p) {
                   const StepRole tag = p.tagged ? StepRole::tagged : StepRole::none;
                   return StepRow{{name(p), fmt::format("{:.3f}", p.extent.z_min),
                                   fmt::format("{:.3f}", p.extent.z_max), p.tagged ? "tagged" : ""},
                                  piece(p),
                                  &p == list_.data() ? StepRole::root : tag};
                 }));
  }

  const StepItems& scene_;
  StepRecord& record_;
  PieceTable table_;
  std::vector<Listed> list_;
  std::vector<std::uint32_t> painted_;  // the last first
};

}  // namespace

const SteppedAlgorithm kDepthSortSteps{
    HiddenMethod::depth_sort,
    "Depth sort",
    "Newell, Newell and Sancha 1972, with the problem book's tests 0 to 5 (10.4) and the lecture's "
    "section 6",
    "interp/steps/depth_sort_steps.cpp",
    DepthSortSteps::kListing,
    DepthSortSteps::kPanels,
    [](const StepItems& scene, StepRecord& record) { DepthSortSteps(scene, record).run(); }};

}  // namespace displayfile
