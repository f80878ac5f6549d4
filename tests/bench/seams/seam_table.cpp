// Seams: how tilings of pieces look in the viewers that are installed, written in several ways,
// beside what 16 x 16 samples a pixel of the same pieces show.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>

#include "interp/vector/pdf_device.h"
#include "interp/vector/seams.h"
#include "interp/vector/svg_device.h"
#include "programs/bench/temporary_folder.h"
#include "tests/bench/command_line.h"
#include "tests/bench/result_table.h"
#include "tests/bench/seams/tilings.h"
#include "tests/bench/seams/true_coverage.h"
#include "tests/bench/seams/viewers.h"

namespace displayfile::bench {
namespace {

namespace fs = std::filesystem;

/// A way to write pieces.
enum class Way { one_path, overlaid, butted, stroked, trapped };
constexpr std::array kWays{Way::one_path, Way::overlaid, Way::butted, Way::stroked, Way::trapped};
constexpr std::array<const char*, 5> kNames{"one path", "overlaid", "butted", "stroked", "trapped"};
const char* name_of(Way way) { return kNames[static_cast<std::size_t>(way)]; }

/// More colours cannot be laid over each other so that each side is drawn once.
constexpr std::size_t kMostOverlaid = 2;

void hand_over(const Tiling& tiling, VectorDevice& device) {
  const LineStyle none{LineStyle::Kind::none};
  std::int32_t pick = 0;
  for (const auto& tile : tiling.tiles) {
    const std::vector<std::int32_t> sides(tile.vertices.size(), 0);
    const FillStyle fill{FillStyle::Kind::solid, tile.colour};
    device.fill({tile.vertices, sides, fill, none, pick++});
  }
}

void hand_over_disjoint(const Tiling& tiling, VectorDevice& device) {
  device.begin_disjoint_fills();
  hand_over(tiling, device);
  device.end_disjoint_fills();
}

/// All in the first colour, over it all but those of the first in the second, and so on: inside,
/// what a viewer makes of one colour that meets another.
void lay_over_each_other(const Tiling& tiling, VectorDevice& device) {
  Tiling rest = tiling;
  rest.apart = false;
  for (const Colour& colour : colours_of(tiling)) {
    Tiling layer = rest;
    for (auto& tile : layer.tiles) tile.colour = colour;
    hand_over_disjoint(layer, device);
    std::erase_if(rest.tiles, [&](const Tiling::Tile& t) { return t.colour == colour; });
  }
}

void draw(const Tiling& tiling, Way way, VectorDevice& device) {
  device.begin_segment(1);
  switch (way) {
    case Way::one_path: hand_over_disjoint(in_black(tiling), device); break;
    case Way::overlaid: lay_over_each_other(tiling, device); break;
    case Way::stroked: hand_over(tiling, device); break;
    case Way::butted:
    case Way::trapped: hand_over_disjoint(tiling, device);
  }
  device.end_segment();
}

fs::path written(const Tiling& tiling, Way way, const std::string& format, const fs::path& folder) {
  std::string name = tiling.name + " " + name_of(way) + "." + format;
  std::ranges::replace_if(
      name, [](char c) { return c == ' ' || c == ','; }, '-');
  const fs::path file = folder / name;
  std::ofstream out(file, std::ios::binary);
  VectorOptions options;
  options.seams = way == Way::trapped ? Seams::trapped : Seams::butted;
  options.pick_ids = tiling.apart && (way == Way::butted || way == Way::trapped);
  if (format == "svg") {
    SvgDevice device(tiling.side, tiling.side, {}, options);
    draw(tiling, way, device);
    device.finish(out);
  } else {
    PdfDevice device(out, tiling.side, tiling.side, {}, options,
                     format == "pdf" ? PageFormat::pdf : PageFormat::eps);
    draw(tiling, way, device);
    device.finish();
  }
  return file;
}

struct Table {
  std::vector<std::vector<std::string>> rows;
  std::map<std::string, double> inside, outline;  ///< of those trapped: the worst, by viewer
};

void measure(const Tiling& tiling, double scale, const std::vector<Viewer>& viewers,
             const fs::path& folder, Table& table) {
  const TrueCoverage truth =
      true_coverage(tiling, scale, VectorOptions().precision, kTrapWidth / 2.0);
  for (const Viewer& viewer : viewers) {
    const std::string shown_by = fmt::format("{} {}", viewer.name, viewer.format);
    double outline_of_one_path = 0.0;
    for (const Way way : kWays) {
      if (way == Way::overlaid && colours_of(tiling).size() > kMostOverlaid) continue;
      const fs::path file = written(tiling, way, viewer.format, folder);
      Picture picture = seen_in(viewer, file, scale, tiling.side);
      if (way == Way::one_path) picture = as_one_path(truth, picture);
      const SeamError e = seam_error(truth, picture);
      if (way == Way::one_path) outline_of_one_path = e.outline;
      table.rows.push_back({tiling.name, fmt::format("{}", scale), shown_by, name_of(way),
                            fmt::format("{:.1f}", e.one), fmt::format("{:.1f}", e.two),
                            fmt::format("{:.1f}", e.near_others), fmt::format("{:.2f}", e.mean_two),
                            fmt::format("{:.2f}", e.mean_more), fmt::format("{:.1f}", e.outline),
                            fmt::format("{:.1f}", e.outline_meeting),
                            fmt::format("{:.0f}", e.outside),
                            fmt::format("{}", fs::file_size(file))});
      if (way != Way::trapped || tiling.apart) continue;
      double &inside = table.inside[shown_by], &outline = table.outline[shown_by];
      inside = std::max(inside, e.inside());
      outline = std::max(outline, e.outline - outline_of_one_path);
    }
  }
}

/// Whether what was asked for holds.
void print_results(const Table& table) {
  std::vector<Result> results;
  const auto is_asked = [](const std::string& shown_by) { return !shown_by.ends_with(" eps"); };
  for (const auto& [shown_by, inside] : table.inside) {
    if (!is_asked(shown_by)) continue;
    const double most = shown_by.starts_with("Chromium") ? 8.0 : 1.0;
    results.push_back({"inside, of 255", fmt::format("<= {}", most), fmt::format("{:.1f}", inside),
                       "", shown_by, holds_if(inside <= most)});
  }
  for (const auto& [shown_by, outline] : table.outline) {
    if (!is_asked(shown_by)) continue;
    results.push_back({"outline, mean, beyond one path's", "<= 1", fmt::format("{:.2f}", outline),
                       "", shown_by, holds_if(outline <= 1.0)});
  }
  fmt::print("\n{}", text_table(results));
}

}  // namespace
}  // namespace displayfile::bench

int main(int argc, char** argv) {
  using namespace displayfile::bench;
  CLI::App app("Seams between pieces, in the viewers that are installed", "seam_table");
  std::vector<std::string> meshes;
  std::vector<double> scales{0.5, 1.0, 4.0};
  std::string keep;
  app.add_option("MESH", meshes, "their front faces are drawn too");
  app.add_option("--scales", scales, "so many pixels for one of the picture's")->delimiter(',');
  app.add_option("--keep", keep, "the folder for what is drawn, to look at it");
  return parsed_and_run(app, argc, argv, [&] {
    const TemporaryFolder own;
    const std::filesystem::path folder = keep.empty() ? own.path() : std::filesystem::path(keep);
    std::filesystem::create_directories(folder);
    std::vector<Tiling> tilings{one_colour_disc(), one_colour_disc_of_elements(), two_colour_disc(),
                                stripes(), many_colour_disc()};
    for (const std::string& mesh : meshes) tilings.push_back(front_faces(mesh));
    const std::vector<Viewer> viewers = installed_viewers();
    Table table;
    for (const Tiling& tiling : tilings) {
      for (const double scale : scales) measure(tiling, scale, viewers, folder, table);
    }
    fmt::print("{}", text_table({"figure", "scale", "viewer", "written", "one", "two",
                                 "near others", "mean two", "mean more", "outline",
                                 "where colours meet on it", "outside", "bytes"},
                                table.rows));
    print_results(table);
  });
}
