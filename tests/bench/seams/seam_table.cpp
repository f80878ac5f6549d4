// Seams: how tilings of pieces look in the viewers that are installed, written in several ways,
// beside what 16 x 16 samples a pixel of the same pieces show.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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
struct Way {
  std::string name;
  bool disjoint;  ///< said to be; otherwise each has a stroke in its own colour
  Seams seams;
  bool even;  ///< all in their mean colour: one solid path
};
const std::vector<Way> kWays{{"one solid path", true, Seams::butted, true},
                             {"butted", true, Seams::butted, false},
                             {"stroked", false, Seams::butted, false},
                             {"trapped", true, Seams::trapped, false}};

void hand_over(const Tiling& tiling, bool disjoint, VectorDevice& device) {
  const LineStyle none{LineStyle::Kind::none};
  device.begin_segment(1);
  if (disjoint) device.begin_disjoint_fills();
  std::int32_t pick = 0;
  for (const auto& tile : tiling.tiles) {
    const std::vector<std::int32_t> sides(tile.vertices.size(), 0);
    const FillStyle fill{FillStyle::Kind::solid, tile.colour};
    device.fill({tile.vertices, sides, fill, none, pick++});
  }
  if (disjoint) device.end_disjoint_fills();
  device.end_segment();
}

fs::path written(const Tiling& tiling, const Way& way, const std::string& format,
                 const fs::path& folder) {
  std::string name = tiling.name + " " + way.name + "." + format;
  std::ranges::replace_if(
      name, [](char c) { return c == ' ' || c == ','; }, '-');
  const fs::path file = folder / name;
  std::ofstream out(file, std::ios::binary);
  VectorOptions options;
  options.seams = way.seams;
  options.pick_ids = tiling.apart && !way.even;
  if (format == "svg") {
    SvgDevice device(tiling.side, tiling.side, {}, options);
    hand_over(tiling, way.disjoint, device);
    device.finish(out);
  } else {
    PdfDevice device(out, tiling.side, tiling.side, {}, options);
    hand_over(tiling, way.disjoint, device);
    device.finish();
  }
  return file;
}

struct Table {
  std::vector<std::vector<std::string>> rows;
  double worst_inside = 0.0, worst_outline = 0.0, worst_in_browser = 0.0;
};

void measure(const Tiling& tiling, double scale, const std::vector<Viewer>& viewers,
             const fs::path& folder, Table& table) {
  const double precision = VectorOptions().precision, reach = kTrapWidth / 2.0;
  const TrueCoverage truth = true_coverage(tiling, scale, precision, reach);
  const Tiling even = in_mean_colour(tiling);
  const TrueCoverage even_truth = true_coverage(even, scale, precision, reach);
  for (const Viewer& viewer : viewers) {
    double solid_outline = 0.0;
    for (const Way& way : kWays) {
      const fs::path file = written(way.even ? even : tiling, way, viewer.format, folder);
      const SeamError e =
          seam_error(way.even ? even_truth : truth, seen_in(viewer, file, scale, tiling.side));
      if (way.even) solid_outline = e.outline;
      table.rows.push_back(
          {tiling.name, fmt::format("{}", scale), fmt::format("{} {}", viewer.name, viewer.format),
           way.name, fmt::format("{:.1f}", e.one), fmt::format("{:.1f}", e.two),
           fmt::format("{:.1f}", e.near_others), fmt::format("{:.2f}", e.mean_two),
           fmt::format("{:.2f}", e.mean_more), fmt::format("{:.1f}", e.outline),
           fmt::format("{:.0f}", e.outside), fmt::format("{}", fs::file_size(file))});
      if (way.name != "trapped" || viewer.format == "eps") continue;
      if (viewer.is_browser) {
        table.worst_in_browser = std::max(table.worst_in_browser, e.inside());
      } else {
        table.worst_inside = std::max(table.worst_inside, e.inside());
        table.worst_outline = std::max(table.worst_outline, e.outline - solid_outline);
      }
    }
  }
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
    std::vector<Tiling> tilings{one_colour_disc(), two_colour_disc(), stripes(),
                                many_colour_disc()};
    for (const std::string& mesh : meshes) tilings.push_back(front_faces(mesh));
    const std::vector<Viewer> viewers = installed_viewers();
    Table table;
    for (const Tiling& tiling : tilings) {
      for (const double scale : scales) measure(tiling, scale, viewers, folder, table);
    }
    fmt::print("{}",
               text_table({"figure", "scale", "viewer", "written", "one", "two", "near others",
                           "mean two", "mean more", "outline", "outside", "bytes"},
                          table.rows));
  });
}
