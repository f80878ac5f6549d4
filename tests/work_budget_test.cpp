// Budgets: every long operation at every limit, stopped from another thread, and the state after
// it.

#include "clip/base/work_budget.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "clip/base/budgeted_work.h"
#include "clip/base/memory.h"
#include "clip/base/parallel.h"
#include "displayfile/files.h"
#include "displayfile/mesh/mesh.h"
#include "interp/draw/renderer.h"
#include "interp/draw/turntable_renderer.h"
#include "interp/truth/truth.h"
#include "tests/error_of.h"
#include "tests/temporary_folder.h"

namespace displayfile {
namespace {

namespace fs = std::filesystem;

class Budgets : public test::TemporaryFolder {};

/// The message of the call that reaches a limit; "done" if it reaches none.
std::string reached(const std::function<void()>& call) {
  try {
    call();
  } catch (const LimitReached& limit) {
    return limit.what();
  }
  return "done";
}

/// Triangles that pass through each other, in an open segment.
void enter_crossing(GraphicsSystem& g, int count) {
  g.open_segment(1);
  for (int k = 0; k < count; ++k) {
    const double u = 0.6 * k / count, v = (k * 7 % count) / (1.0 * count), w = 0.5 - 0.4 * v;
    g.polygon_abs_3({{-0.9, u - 0.5, v - 0.5}, {0.9, 0.4 - u, w}, {u - 0.2, 0.9, 0.5 - v}});
  }
}

GraphicsSystem crossing(int count) {
  GraphicsSystem g;
  enter_crossing(g, count);
  g.close_segment();
  return g;
}

/// A long operation under a budget: a name, and the call.
struct Operation {
  std::string name;
  std::function<void(WorkBudget&)> run;
};

std::vector<Operation> operations(const GraphicsSystem& g, const fs::path& folder, int threads) {
  std::vector<Operation> all;
  const auto draws = [&](const std::string& name, HiddenMethod method, const std::string& file) {
    all.push_back({name, [&g, method, threads, file = folder / file](WorkBudget& budget) {
                     DrawOptions options{.samples = 1};
                     options.surfaces.method = method;
                     options.surfaces.threads = threads;
                     options.surfaces.budget = &budget;
                     draw(g, file, options);
                   }});
  };
  draws("bsp", HiddenMethod::bsp, "bsp.svg");
  draws("depth-sort", HiddenMethod::depth_sort, "depth-sort.svg");
  draws("map", HiddenMethod::map, "map.svg");
  draws("roberts", HiddenMethod::roberts, "roberts.svg");
  draws("appel", HiddenMethod::appel, "appel.svg");
  draws("franklin", HiddenMethod::franklin, "franklin.svg");
  draws("z-buffer", HiddenMethod::z_buffer, "z-buffer.png");
  draws("scan-line", HiddenMethod::scan_line, "scan-line.png");
  draws("scan-line-z", HiddenMethod::scan_line_z, "scan-line-z.png");
  draws("ray-cast", HiddenMethod::ray_cast, "ray-cast.png");
  draws("warnock", HiddenMethod::warnock, "warnock.png");
  all.push_back({"truth", [&g](WorkBudget& budget) {
                   const BudgetInForce in_force(budget);
                   truth(g.display_file(), 60, 60, false);
                 }});
  return all;
}

constexpr std::size_t kSorts = 2, kThatCompare = 6;  // the first of them

TEST_F(Budgets, NoTimeStopsEveryOperationAndWritesNothing) {
  const GraphicsSystem g = crossing(60);
  const std::string before = dump(g.display_file());
  for (const int threads : {1, 3}) {
    for (const Operation& operation : operations(g, folder_, threads)) {
      WorkBudget budget({.seconds = 1e-9});
      const std::string said = reached([&] { operation.run(budget); });
      EXPECT_NE(said.find("1e-09 seconds are not enough"), said.npos) << operation.name << said;
      EXPECT_NE(said.find("expected a higher limit of seconds"), said.npos) << operation.name;
      EXPECT_TRUE(empty_folder()) << operation.name;
    }
  }
  EXPECT_EQ(dump(g.display_file()), before);
}

TEST_F(Budgets, WhatIsStoppedBeforeItBeginsDoesNothing) {
  const GraphicsSystem g = crossing(25);
  for (const Operation& operation : operations(g, folder_, 2)) {
    WorkBudget budget;
    budget.stop();
    const std::string said = reached([&] { operation.run(budget); });
    EXPECT_NE(said.find("stopped on request"), said.npos) << operation.name << said;
    EXPECT_TRUE(empty_folder()) << operation.name;
    budget.start();
    EXPECT_EQ(reached([&] { operation.run(budget); }), "done") << operation.name;
    EXPECT_FALSE(empty_folder() && operation.name != "truth") << operation.name;
    for (const auto& made : fs::directory_iterator(folder_)) fs::remove(made);
  }
}

TEST_F(Budgets, ABudgetThatIsEnoughChangesNothing) {
  const GraphicsSystem g = crossing(20);
  for (const Operation& operation : operations(g, folder_, 2)) {
    WorkBudget unlimited, enough({.pieces = 1000000, .comparisons = 1u << 30, .seconds = 1e6});
    EXPECT_EQ(reached([&] { operation.run(unlimited); }), "done") << operation.name;
    std::vector<std::string> made;
    for (const auto& file : fs::directory_iterator(folder_)) made.push_back(test::content(file));
    EXPECT_EQ(reached([&] { operation.run(enough); }), "done") << operation.name;
    std::size_t k = 0;
    for (const auto& file : fs::directory_iterator(folder_)) {
      EXPECT_EQ(test::content(file), made[k++]) << operation.name;
      fs::remove(file);
    }
  }
}

TEST_F(Budgets, ComparisonsAreCountedWhereThingsAreCompared) {
  const GraphicsSystem g = crossing(120);
  const std::vector<Operation> all = operations(g, folder_, 2);
  for (std::size_t k = 0; k < kThatCompare; ++k) {
    WorkBudget counting;
    EXPECT_EQ(reached([&] { all[k].run(counting); }), "done");
    EXPECT_GT(counting.comparisons(), 2000u) << all[k].name;
    fs::remove_all(folder_ / (all[k].name + ".svg"));
    WorkBudget budget({.comparisons = counting.comparisons() / 2});
    const std::string said = reached([&] { all[k].run(budget); });
    EXPECT_NE(said.find(" comparisons are not enough"), said.npos) << all[k].name << said;
    EXPECT_NE(said.find(all[k].name), said.npos) << said;
    EXPECT_NE(said.find(", or "), said.npos) << said;
    EXPECT_TRUE(empty_folder());
  }
}

TEST_F(Budgets, PiecesAndBytesOfTheirTables) {
  const GraphicsSystem g = crossing(120);
  const std::vector<Operation> all = operations(g, folder_, 1);
  for (std::size_t k = 0; k < kThatCompare; ++k) {
    WorkBudget pieces({.pieces = 500}), bytes({.bytes = 15000});
    const std::string of_pieces = reached([&] { all[k].run(pieces); });
    EXPECT_NE(of_pieces.find(k < kSorts ? "more than 500 pieces: expected hidden-surface method "
                                          "map"
                                        : "500 pieces are not enough"),
              of_pieces.npos)
        << all[k].name << of_pieces;
    const std::string of_bytes = reached([&] { all[k].run(bytes); });
    EXPECT_NE(of_bytes.find("15000"), of_bytes.npos) << all[k].name << of_bytes;
    EXPECT_TRUE(empty_folder());
  }
  WorkBudget budget({.bytes = 30000});
  EXPECT_NE(reached([&] {
              draw(g, {.width = 100, .height = 100, .surfaces = {.budget = &budget}, .samples = 1});
            })
                .find("a picture of 100 x 100 pixels needs at least 40000 bytes, and the limit is "
                      "30000"),
            std::string::npos);
}

/// The textbook's routine: the segment is still open, and can be closed with another method. Draws
/// by that method with no more pieces, by a renderer that keeps data and by a new one: the same
/// pixels, or the same limit reached. True if it was not reached.
bool draws_as_a_new_renderer(Renderer& kept, const GraphicsSystem& g, const DrawOptions& options) {
  std::string of_kept, of_new;
  Renderer anew;
  const auto pixels = [&](Renderer& renderer) { return renderer.draw(g, options).pixels; };
  std::vector<std::uint32_t> drawn, right;
  of_kept = reached([&] { drawn = pixels(kept); });
  of_new = reached([&] { right = pixels(anew); });
  EXPECT_EQ(of_kept, of_new);
  EXPECT_EQ(drawn, right);
  return of_new == "done";
}

/// A sort that is kept does not hide from a limit of pieces that comes later.
TEST_F(Budgets, AKeptSortReachesALowerLimitOfPieces) {
  const GraphicsSystem g = crossing(12);
  for (const HiddenMethod method :
       {HiddenMethod::bsp, HiddenMethod::plain_bsp, HiddenMethod::depth_sort}) {
    SCOPED_TRACE(name_of(method));
    DrawOptions options{.width = 16, .height = 16, .surfaces = {.method = method}, .samples = 1};
    for (const HiddenScope scope : {HiddenScope::all, HiddenScope::segment}) {
      options.surfaces.scope = scope;
      Renderer kept;
      bool is_drawn = false, is_refused = false;
      for (const std::size_t most : {kMostPieces, std::size_t{5000}, std::size_t{60},
                                     std::size_t{30}, std::size_t{13}, std::size_t{1000}}) {
        SCOPED_TRACE(most);
        options.surfaces.most_pieces = most;
        (draws_as_a_new_renderer(kept, g, options) ? is_drawn : is_refused) = true;
      }
      EXPECT_TRUE(is_drawn);
      EXPECT_TRUE(is_refused);
    }
  }
}

/// Nor do a kept map, kept lines, and lines that are drawn over fills.
TEST_F(Budgets, KeptMapsAndLinesReachALowerLimitOfPieces) {
  const GraphicsSystem g = crossing(12);
  for (const HiddenMethod method : {HiddenMethod::map, HiddenMethod::franklin, HiddenMethod::appel,
                                    HiddenMethod::z_buffer, HiddenMethod::bsp}) {
    SCOPED_TRACE(name_of(method));
    DrawOptions options{.width = 16, .height = 16, .surfaces = {.method = method}, .samples = 1};
    Renderer kept;
    EXPECT_TRUE(draws_as_a_new_renderer(kept, g, options));
    bool is_refused = false;
    for (const std::uint64_t most :
         {std::uint64_t{100'000}, std::uint64_t{40}, std::uint64_t{1000}, std::uint64_t{100'000}}) {
      SCOPED_TRACE(most);
      WorkBudget budget({.pieces = most});
      options.surfaces.budget = &budget;
      is_refused = !draws_as_a_new_renderer(kept, g, options) || is_refused;
    }
    EXPECT_TRUE(is_refused);
  }
}

/// Trees for all views of a retained scene are used again within the limit, and reach a lower one.
TEST_F(Budgets, KeptTreesOfViewsReachALowerLimitOfPieces) {
  GraphicsSystem g;
  g.retain();
  enter_crossing(g, 12);
  g.close_segment();
  View view;
  DrawOptions options{
      .width = 16, .height = 16, .surfaces = {.method = HiddenMethod::bsp}, .samples = 1};
  Renderer kept;
  kept.draw(in_view(g, view), options);
  const std::uint64_t pieces = 12 + kept.trees().cuts;
  ASSERT_GT(kept.trees().cuts, 2u);
  const std::uint64_t walks = kept.trees().walks;
  options.surfaces.most_pieces = pieces;
  EXPECT_EQ(reached([&] { kept.draw(in_view(g, view), options); }), "done");
  EXPECT_EQ(kept.trees().walks, walks);  // the order that is there
  options.surfaces.most_pieces = pieces - 1;
  const std::string words = reached([&] { kept.draw(in_view(g, view), options); });
  EXPECT_EQ(words, reached([&] { Renderer().draw(in_view(g, view), options); }));
  EXPECT_NE(words, "done");
  options.surfaces.most_pieces = pieces;
  EXPECT_EQ(reached([&] { kept.draw(in_view(g, view), options); }), "done");
  // Trees that are made anew later keep to the last limit.
  options.surfaces.most_pieces = kMostPieces;
  kept.draw(in_view(g, view), options);
  options.surfaces.most_pieces = pieces;
  kept.draw(in_view(g, view), options);
  g.delete_segment(1);
  enter_crossing(g, 14);
  g.close_segment();
  EXPECT_EQ(reached([&] { kept.draw(in_view(g, view), options); }),
            reached([&] { Renderer().draw(in_view(g, view), options); }));
}

/// The message of a drawing with several samples a pixel names fewer.
TEST_F(Budgets, DrawingSeveralSamplesNamesFewer) {
  GraphicsSystem g;
  g.set_line_style({LineStyle::Kind::none});
  g.open_segment(1);
  g.polygon_abs_3({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
  g.close_segment();
  for (const int samples : {1, 4}) {
    WorkBudget budget({.seconds = 0.0});
    const DrawOptions options{.width = 16,
                              .height = 16,
                              .surfaces = {.method = HiddenMethod::z_buffer, .budget = &budget},
                              .samples = samples};
    const std::string words = reached([&] { draw(g, options); });
    EXPECT_NE(words.find("a smaller picture"), words.npos) << words;
    EXPECT_EQ(words.find("fewer samples a pixel, such as --samples 1") != words.npos, samples > 1)
        << words;
  }
}

TEST_F(Budgets, CloseSegmentAtItsLimitLeavesTheSegmentOpen) {
  GraphicsSystem g, same;
  for (GraphicsSystem* system : {&g, &same}) {
    system->set_hidden_surfaces({.removal = true});
    system->set_hidden_surfaces({.method = HiddenMethod::bsp});
    enter_crossing(*system, 60);
  }
  WorkBudget budget({.pieces = 100});
  const auto close_within = [&] {
    const BudgetInForce in_force(budget);
    g.close_segment();
  };
  EXPECT_NE(reached(close_within).find("more than 100 pieces"), std::string::npos);
  EXPECT_EQ(g.open_segment_name(), 1);
  EXPECT_EQ(g.display_file().polygons(), 60u);
  for (GraphicsSystem* system : {&g, &same}) {
    system->set_hidden_surfaces({.method = HiddenMethod::depth_sort});
    system->polygon_abs_3({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    system->close_segment();
  }
  EXPECT_EQ(dump(g.display_file()), dump(same.display_file()));
}

/// A renderer that was stopped draws the same as a new one.
TEST_F(Budgets, StoppedFromAnotherThreadAndDrawnAgain) {
  const GraphicsSystem g = crossing(400);
  for (const HiddenMethod method :
       {HiddenMethod::bsp, HiddenMethod::map, HiddenMethod::franklin, HiddenMethod::z_buffer}) {
    Renderer renderer;
    WorkBudget budget;
    DrawOptions options{
        .width = 1500, .height = 1500, .surfaces = {.method = method, .threads = 2}, .samples = 1};
    options.surfaces.budget = &budget;
    std::atomic<bool> begun = false;
    std::thread stopper([&] {
      while (!begun) std::this_thread::yield();
      while (budget.comparisons() == 0 && method != HiddenMethod::z_buffer) {
        std::this_thread::yield();
      }
      budget.stop();
    });
    const std::string said = reached([&] {
      begun = true;
      renderer.draw(g, options);
    });
    stopper.join();
    EXPECT_NE(said.find("stopped"), said.npos) << name_of(method) << said;
  }
  const GraphicsSystem few = crossing(20);
  Renderer renderer;
  WorkBudget none({.seconds = 1e-9});
  DrawOptions options{.width = 300,
                      .height = 200,
                      .surfaces = {.method = HiddenMethod::bsp, .budget = &none},
                      .samples = 1};
  EXPECT_NE(reached([&] { renderer.draw(few, options); }), "done");
  options.surfaces.budget = nullptr;
  EXPECT_EQ(renderer.draw(few, options).pixels, draw(few, options).pixels);
}

/// Few polygons may take long to paint: the budget is checked between rows.
TEST_F(Budgets, PaintingStops) {
  GraphicsSystem g;
  g.set_view_depth(-1, 3);
  g.open_segment(1);
  for (int k = 0; k < 1000; ++k) {
    const double z = -0.001 * k;
    g.polygon_abs_3({{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}});
  }
  g.close_segment();
  for (const HiddenMethod method : {HiddenMethod::none, HiddenMethod::bsp}) {
    WorkBudget budget({.seconds = 0.2});
    const DrawOptions options{.width = 3000,
                              .height = 3000,
                              .surfaces = {.method = method, .budget = &budget},
                              .samples = 1};
    EXPECT_NE(reached([&] { draw(g, options); }).find("0.2 seconds are not enough"),
              std::string::npos)
        << name_of(method);
  }
}

TEST_F(Budgets, PickingAndTheTreeOfATurntable) {
  GraphicsSystem g;
  RetainedScene scene;
  g.retain(&scene);
  enter_crossing(g, 60);
  g.close_segment();
  WorkBudget stopped;
  stopped.stop();
  DrawOptions options{.width = 50, .height = 50, .surfaces = {.budget = &stopped}, .samples = 1};
  Renderer renderer;
  EXPECT_NE(reached([&] { renderer.pick(g, 25, 25, options); }).find("stopped"), std::string::npos);
  const auto turntable = [&] {
    TurntableRenderer(g, scene, g.display_file(), {4}, options).draw(0);
  };
  EXPECT_NE(reached(turntable).find("stopped"), std::string::npos);
  WorkBudget pieces({.pieces = 100});
  options.surfaces.budget = &pieces;
  EXPECT_NE(reached(turntable).find("more than 100 pieces"), std::string::npos);
  options.surfaces.budget = nullptr;
  options.surfaces.most_pieces = 90;
  EXPECT_NE(test::error_of(turntable).find("more than 90 pieces"), std::string::npos);
  options.surfaces.most_pieces = kMostPieces;
  EXPECT_EQ(reached(turntable), "done");
}

/// A lack of memory is reported with the work in progress, not with work that failed before.
TEST_F(Budgets, WorkThatFailedIsNotToldOfOtherWork) {
  const GraphicsSystem g = crossing(60);
  WorkBudget budget({.pieces = 100});
  EXPECT_NE(reached([&] {
              draw(g, {.surfaces = {.method = HiddenMethod::bsp, .budget = &budget}, .samples = 1});
            }),
            "done");
  const std::string said = reached([] {
    with_memory(
        1000, [] { return "entering polygons"; }, [] { throw std::bad_alloc(); });
  });
  EXPECT_NE(said.find("entering polygons"), said.npos) << said;
  EXPECT_EQ(said.find("hidden-surface method"), said.npos) << said;
}

TEST_F(Budgets, ReadingAndEnteringStopWithTheirPlace) {
  std::string program = "open-segment 1\n", obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int k = 0; k < 5000; ++k) {
    program += "polygon-abs-3 0 0 0  1 0 0  0 1 0\n";
    obj += "f 1 2 3\n";
  }
  WorkBudget budget({.seconds = 1e-9});
  const BudgetInForce in_force(budget);
  GraphicsSystem g;
  EXPECT_NE(reached([&] {
              replay(program + "close-segment\n", "p.draw", g);
            }).find("p.draw:1024:1: 1e-09 seconds are not enough"),
            std::string::npos);
  GraphicsSystem other;
  const fs::path mesh = file("m.obj", obj);
  EXPECT_NE(reached([&] { import_mesh(mesh.string(), other); }), "done");
  EXPECT_TRUE(other.display_file().segments().empty());
}

/// A mesh whose segment cannot be sorted is not entered, and nothing is open.
TEST_F(Budgets, AMeshAtTheLimitLeavesNoSegment) {
  std::string obj;
  for (int k = 0; k < 60; ++k) {
    const double u = 0.6 * k / 60, v = (k * 7 % 60) / 60.0;
    obj += fmt::format("v -0.9 {} {}\nv 0.9 {} {}\nv {} 0.9 {}\nf -3 -2 -1\n", u - 0.5, v - 0.5,
                       0.4 - u, 0.5 - 0.4 * v, u - 0.2, 0.5 - v);
  }
  const fs::path mesh = file("m.obj", obj);
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true});
  g.set_hidden_surfaces({.method = HiddenMethod::bsp});
  WorkBudget budget({.pieces = 70});
  const BudgetInForce in_force(budget);
  EXPECT_NE(reached([&] { import_mesh(mesh.string(), g); }).find("more than 70 pieces"),
            std::string::npos);
  EXPECT_FALSE(g.open_segment_name());
  EXPECT_TRUE(g.display_file().segments().empty());
}

TEST_F(Budgets, BudgetsAreInForceInTurnAndOnEveryThread) {
  EXPECT_EQ(work_in_force().budget, nullptr);
  WorkBudget outer, inner;
  {
    const BudgetInForce in_force(outer);
    {
      const BudgetInForce nothing_said(nullptr);
      EXPECT_EQ(work_in_force().budget, &outer);
      const BudgetInForce within(inner);
      std::atomic<int> other = 0;
      in_parallel(4, 100, [&](std::size_t) { other += work_in_force().budget != &inner ? 1 : 0; });
      EXPECT_EQ(other, 0);
    }
    EXPECT_EQ(work_in_force().budget, &outer);
  }
  EXPECT_EQ(work_in_force().budget, nullptr);
  in_parallel(4, 100, [&](std::size_t) { EXPECT_EQ(work_in_force().budget, nullptr); });
  std::atomic<int> calls = 0;
  const BudgetInForce in_force(outer);
  EXPECT_NE(reached([&] {
              in_parallel(2, 100000, [&](std::size_t) {
                if (++calls == 5) outer.stop();
              });
            }),
            "done");
  EXPECT_LT(calls, 1000);
}

/// Slivers along a diagonal: each is in the boxes of most others, and overlaps none.
TEST_F(Budgets, PairsThatAreLookedAtCountAlsoWhereNoneOverlaps) {
  WorkBudget budget({.comparisons = 5000});
  GraphicsSystem g;
  g.set_hidden_surfaces({.removal = true});
  g.set_back_face_removal(false);
  g.set_hidden_surfaces({.method = HiddenMethod::bsp});
  const BudgetInForce in_force(budget);
  g.open_segment(1);
  for (int k = 0; k < 400; ++k) {
    const double x = 1e-3 * k;
    g.polygon_abs_3({{x - 0.6, -0.5, 0}, {x + 0.4, 0.5, 0}, {x + 0.4002, 0.5, 0}});
  }
  EXPECT_NE(reached([&] { g.close_segment(); }).find("5000 comparisons are not enough"),
            std::string::npos);
}

/// A line of a program may enter very many polygons.
TEST_F(Budgets, ShapesAndManyPolygonsAreStoppedBeforeTheyAreEntered) {
  GraphicsSystem g;
  g.open_segment(1);
  WorkBudget budget;
  const BudgetInForce in_force(budget);
  replay("sphere-3 0 0 0 1 9\n", "p.draw", g);
  const std::int64_t entered = g.counts().polygons;
  EXPECT_GT(entered, 9);
  budget.stop();
  for (const char* line : {"sphere-3 0 0 0 1 9\n", "box-3 0 1 0 1 0 1\n",
                           "turn-3 5  0 0  1 0  0 1\n", "surface-3 0 1 2 0 1 2  0 0 0 0\n"}) {
    EXPECT_NE(reached([&] { replay(line, "p.draw", g); }).find("p.draw:1:1: stopped"),
              std::string::npos)
        << line;
    EXPECT_EQ(g.counts().polygons, entered);
  }
}

}  // namespace
}  // namespace displayfile
