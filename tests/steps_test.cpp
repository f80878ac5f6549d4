// Algorithms step by step: the steps add up to the item buffer of truth, every sentence and line of
// a listing exists, and too many steps are an error.

#include "interp/steps/steps.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "hidden/lines/visible_lines.h"
#include "interp/truth/truth.h"
#include "tests/error_of.h"
#include "tests/gallery.h"
#include "tests/slower.h"
#include "tests/temporary_folder.h"
#include "tests/truth_scenes.h"

namespace displayfile {
namespace {

constexpr std::uint32_t kSeeds = 12 / test::kShare;

/// The item buffer, top row first, after the first `steps` steps.
std::vector<std::int32_t> ids_after(const Steps& told, std::size_t steps) {
  std::vector<std::int32_t> ids(
      static_cast<std::size_t>(told.width) * static_cast<std::size_t>(told.height), -1);
  for (std::size_t k = 0; k < steps; ++k) {
    for (const auto& [row, first, end, polygon] : told.steps[k].gained) {
      for (int i = first; i < end; ++i) {
        ids[static_cast<std::size_t>(told.height - 1 - row) * static_cast<std::size_t>(told.width) +
            static_cast<std::size_t>(i)] = told.polygons[polygon].pick;
      }
    }
  }
  return ids;
}

/// Words of capitals alone, maybe with a number, are names of pieces.
void expect_names(const std::string& sentence, const std::set<std::string>& names) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (auto begin = sentence.begin(); begin != sentence.end();) {
    begin = std::find_if(begin, sentence.end(), is_part);
    const auto end = std::find_if_not(begin, sentence.end(), is_part);
    const std::string word(begin, end);
    const std::size_t letters = word.find_first_of("0123456789");
    const std::string capitals = word.substr(0, letters);
    const bool is_name = !capitals.empty() &&
                         std::ranges::all_of(capitals, [](char c) { return c >= 'A' && c <= 'Z'; });
    const bool is_word = word == "IN" || (word == "A" && begin == sentence.begin()) ||
                         std::string(end, sentence.end()).starts_with(" buffer");
    EXPECT_TRUE(!is_name || is_word || names.contains(word)) << word << ": " << sentence;
    begin = end;
  }
}

/// Line, names and places exist.
void expect_valid(const Steps& told) {
  const auto pieces = static_cast<std::uint32_t>(told.pieces.size());
  std::set<std::string> names;
  for (const StepPiece& piece : told.pieces) names.insert(piece.name);
  EXPECT_EQ(names.size(), pieces);
  ASSERT_GE(pieces, told.polygons.size());
  for (const Step& step : told.steps) {
    EXPECT_TRUE(step.line >= 0 && step.line < static_cast<int>(told.listing.size()));
    EXPECT_FALSE(told.listing[static_cast<std::size_t>(step.line)].name.empty());
    EXPECT_TRUE(step.sentence.ends_with('.') || step.sentence.ends_with('?')) << step.sentence;
    EXPECT_TRUE(step.sentence[0] >= 'A' && step.sentence[0] <= 'Z') << step.sentence;
    expect_names(step.sentence, names);
    for (const StepMark& mark : step.marks) {
      if (mark.kind == StepMark::Kind::piece) {
        EXPECT_LT(mark.piece, pieces);
      }
    }
    for (const StepRun& run : step.gained) {
      EXPECT_TRUE(run.row >= 0 && run.row < told.height && run.first >= 0 && run.first < run.end &&
                  run.end <= told.width);
      EXPECT_LT(run.polygon, told.polygons.size());
    }
    for (const PanelChange& change : step.panels) {
      ASSERT_TRUE(change.panel >= 0 && change.panel < static_cast<int>(told.panels.size()));
      const auto& panel = told.panels[static_cast<std::size_t>(change.panel)];
      if (panel.kind != PanelEntry::Kind::tree) {
        EXPECT_TRUE(change.nodes.empty());
      }
      const auto columns = static_cast<std::size_t>(std::ranges::count(panel.columns, '|')) + 1;
      for (const StepRow& row : change.rows) {
        EXPECT_EQ(row.cells.size(), columns) << panel.title;
        if (row.piece != StepRow::kNoPiece) {
          EXPECT_LT(row.piece, pieces);
        }
      }
    }
  }
}

std::vector<HiddenMethod> surface_methods() {
  std::vector<HiddenMethod> methods = methods_with_steps();
  std::erase_if(methods, [](HiddenMethod method) { return finds_lines(method); });
  return methods;
}

void expect_truth(const DisplayFile& file, HiddenMethod method, int width, int height) {
  SCOPED_TRACE(name_of(method));
  const Steps told = tell_steps(file, {method, width, height, 1'000'000});
  expect_valid(told);
  const Picture right = truth(file, width, height, false);
  const auto ids = ids_after(told, told.steps.size());
  EXPECT_EQ(test::different(ids, right.ids), 0u);
}

std::vector<HiddenMethod> line_methods() {
  std::vector<HiddenMethod> methods = methods_with_steps();
  std::erase_if(methods, [](HiddenMethod method) { return !finds_lines(method); });
  return methods;
}

/// The lines that the steps draw are those that the method finds, to the last bit, and the hidden
/// ones are the rest of all drawn lines.
void expect_lines(const DisplayFile& file, HiddenMethod method) {
  SCOPED_TRACE(name_of(method));
  const Steps told = tell_steps(file, {method, 16, 16, 1'000'000});
  expect_valid(told);
  std::vector<VisiblePiece> drawn;
  std::map<LineName, double> lengths;
  for (const Step& step : told.steps) {
    for (const StepLine& line : step.lines) {
      lengths[{line.polygon, line.corner}] += line.to - line.from;
      if (!line.hidden) drawn.push_back({line.polygon, line.corner, line.from, line.to});
    }
  }
  const auto key = [](const VisiblePiece& p) { return std::tuple(p.item, p.corner, p.from); };
  std::ranges::sort(drawn, {}, key);
  const ViewedScene scene(file);
  const std::vector<std::uint8_t> sides = scene.drawn_sides();
  Primitives items = scene.primitives();
  items.visible = sides;
  const std::vector<LineName> names = drawn_lines(items);
  const SeenLines right = visible_lines(items, names, {.method = method});
  EXPECT_EQ(drawn, right.pieces);
  EXPECT_EQ(lengths.size(), names.size());
  for (const auto& [name, length] : lengths) EXPECT_NEAR(length, 1.0, 1e-12);
}

TEST(Steps, DrawTheLinesThatTheMethodFinds) {
  int drawn = 0;
  test::Share share;
  test::for_each_in_gallery([&](const std::string& name, const test::Retained& retained) {
    const DisplayFile& file = retained.system.display_file();
    if (file.polygons() > 60) return;
    ++drawn;
    SCOPED_TRACE(name);
    for (const HiddenMethod method : line_methods()) {
      if (!needs_surface(method) && share.takes_next()) expect_lines(file, method);
    }
  });
  EXPECT_GE(drawn, 8);
  for (const test::SceneFamily& family : test::scene_families()) {
    SCOPED_TRACE(family.name);
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(fmt::format("seed {}", seed));
      const DisplayFile file = test::scene(family, seed, 2 + static_cast<int>(seed % 6), {});
      for (const HiddenMethod method : line_methods()) {
        if (!needs_surface(method)) expect_lines(file, method);
      }
      if (HasFailure()) return;
    }
  }
}

/// Waves over a grid, with holes in no place.
DisplayFile surface_seen(std::uint32_t seed, bool perspective) {
  test::Dice dice(seed);
  const int nx = dice.from(2, 8), ny = dice.from(2, 8);
  std::vector<double> heights;
  for (int k = 0; k < nx * ny; ++k) heights.push_back(dice.from(-4, 4) / 6.0);
  GraphicsSystem g;
  const Point3 eye(dice.from(-5, 5), dice.from(-9, -3), dice.from(-4, 6));
  g.set_view_plane_normal(-eye);
  g.set_view_up({0, 0, 1});
  if (perspective) {
    g.set_perspective(3.0 * eye);
    g.set_window(-4, 4, -4, 4);
  } else {
    g.set_parallel(-eye);
    g.set_window(-2, 2, -2, 2);
  }
  g.set_surface_curves(dice.one_in(2) ? SurfaceCurves::both : SurfaceCurves::x);
  g.open_segment(1);
  g.surface_3({-1, 1, nx, -1, 1, ny, heights});
  g.close_segment();
  return g.display_file();
}

TEST(Steps, DrawTheCurvesOfASurface) {
  for (std::uint32_t seed = 0; seed < 100 / test::kSlower; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    for (const HiddenMethod method : line_methods()) {
      expect_lines(surface_seen(seed, seed % 2 == 0), method);
    }
    if (HasFailure()) return;
  }
}

TEST(Steps, AddUpToTheTruthOfTheGallery) {
  int drawn = 0;
  test::Share share;
  test::for_each_in_gallery([&](const std::string& name, const test::Retained& retained) {
    const DisplayFile& file = retained.system.display_file();
    if (file.polygons() > 60) return;
    ++drawn;
    SCOPED_TRACE(name);
    for (const HiddenMethod method : surface_methods()) {
      if (share.takes_next()) expect_truth(file, method, 37, 29);
    }
  });
  EXPECT_GE(drawn, 8);
}

TEST(Steps, AddUpToTheTruthOfRandomScenes) {
  for (const test::SceneFamily& family : test::scene_families()) {
    SCOPED_TRACE(family.name);
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(fmt::format("seed {}", seed));
      const DisplayFile file = test::scene(family, seed, 2 + static_cast<int>(seed % 6));
      for (const HiddenMethod method : surface_methods()) expect_truth(file, method, 16, 14);
      if (HasFailure()) return;
    }
  }
}

TEST(Steps, TooManyAreAnErrorThatNamesTheLimit) {
  GraphicsSystem system;
  replay_file(DISPLAYFILE_SOURCE_DIR "/programs/cube.draw", system);
  for (const HiddenMethod method : surface_methods()) {
    const Steps told = tell_steps(system, {method, 16, 16});
    StepsOptions options{method, 16, 16, told.steps.size()};
    EXPECT_EQ(tell_steps(system, options).steps.size(), told.steps.size());
    --options.most_steps;
    try {
      tell_steps(system, options);
      FAIL() << name_of(method);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("--limit-steps"), std::string::npos);
    }
  }
}

/// The file whose code runs is the file of the steps, or a file of the repository that it includes.
TEST(Steps, NameTheFileWhoseCodeRuns) {
  for (const HiddenMethod method : methods_with_steps()) {
    const Steps told = tell_steps(surface_seen(0, false), {method, 8, 8});
    std::string name(name_of(method));
    std::ranges::replace(name, '-', '_');
    const std::string file = fmt::format("interp/steps/{}_steps.cpp", name);
    const std::string text = test::content(fmt::format("{}/{}", DISPLAYFILE_SOURCE_DIR, file));
    if (told.code == file) continue;
    EXPECT_FALSE(told.code.starts_with("interp/steps/")) << told.code;
    EXPECT_NE(text.find(fmt::format("#include \"{}\"", told.code)), std::string::npos) << told.code;
  }
}

TEST(Steps, AMethodThatTellsNoneIsAnError) {
  EXPECT_THROW(tell_steps(GraphicsSystem(), {HiddenMethod::map}), Error);
  EXPECT_THROW(tell_steps(GraphicsSystem(), {HiddenMethod::bsp, 0, 10}), Error);
}

/// The steps of a method's plain form are the method's steps, under another name.
TEST(Steps, OfAPlainFormAreThoseThatShowIt) {
  const DisplayFile file = test::file_of(
      {{{0, 0, 0}, {1, 0, 0.5}, {0, 1, 0}}, {{0, 0, 0.5}, {1, 0, 0}, {0.5, 1, 0.25}}});
  const std::vector<HiddenMethod> methods = methods_with_steps();
  ASSERT_EQ(plain_forms_with_steps().size(), 4u);
  for (const HiddenMethod form : plain_forms_with_steps()) {
    const std::string name(name_of(form));
    ASSERT_TRUE(name.starts_with("plain-"));
    const HiddenMethod shown = hidden_method(name.substr(6));
    EXPECT_NE(std::ranges::find(methods, shown), methods.end());
    EXPECT_EQ(as_json(tell_steps(file, {.method = form, .width = 8, .height = 8})),
              as_json(tell_steps(file, {.method = shown, .width = 8, .height = 8})));
  }
  const std::string words = test::error_of([&] {
    tell_steps(file, {.method = HiddenMethod::plain_z_buffer});  // which errs, as no steps do
  });
  EXPECT_TRUE(words.starts_with("hidden-surface method plain-z-buffer has no steps: ")) << words;
  EXPECT_TRUE(words.ends_with(" plain-bsp plain-scan-line plain-warnock plain-appel")) << words;
}

}  // namespace
}  // namespace displayfile
