// New views of a retained scene (displayfile/scene_viewer.md) against entering each view anew and
// drawing that, with what both keep from picture to picture.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "clip/error.h"
#include "displayfile/mesh/mesh.h"
#include "displayfile/scene_viewer.h"
#include "displayfile/turntable.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "programs/bench/side_by_side.h"
#include "tests/bench/kept_views.h"

namespace {

using namespace displayfile;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A height field of 2 n^2 triangles.
void enter_terrain(int n, GraphicsSystem& system) {
  std::vector<Point3> vertices;
  std::vector<std::uint32_t> corners;
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = 1.8 * i / n - 0.9, y = 1.8 * j / n - 0.9;
      const double hills = 0.2 * std::sin(7.0 * x) * std::cos(5.0 * y);
      vertices.emplace_back(x, y, hills + 0.02 * std::sin(61.0 * x + 3.0) * std::sin(47.0 * y));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      corners.insert(corners.end(), {at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  system.set_line_style({LineStyle::Kind::none});
  system.set_perspective({0.3, -2.5, 2.0});
  system.set_view_plane_normal({-0.3, 2.5, -2.0});
  system.set_view_reference_point({0, 0, 0});
  system.set_view_up({0, 0, 1});
  system.set_window(-1.3, 1.3, -1.3, 1.3);
  system.open_segment(1);
  system.polygons_abs_3({vertices, corners});
  system.close_segment();
}

struct Wanted {
  std::string mesh;
  int side = 300, size = 1024, threads = 1, views = 24;
  bool light = false, shadows = false, kept = false, against_truth = false;
};

void enter_wanted(const Wanted& wanted, GraphicsSystem& system) {
  if (wanted.light || wanted.shadows || wanted.kept) system.set_light({1, 2, 3}, 0.2);
  system.set_shadows(wanted.shadows);
  if (wanted.mesh.empty()) return enter_terrain(wanted.side, system);
  system.set_line_style({LineStyle::Kind::none});
  import_mesh(wanted.mesh, system);
}

/// Seconds of one view after another, from the third on.
struct Times {
  std::vector<double> new_views, viewing, drawing, anew;
  std::size_t wrong_pixels = 0;
};

class Bench {
 public:
  explicit Bench(const Wanted& wanted) : wanted_(wanted) {
    system_.retain(&scene_);
    enter_wanted(wanted, system_);
    turntable_.emplace(scene_, system_.display_file(), system_.view());
    if (!wanted.mesh.empty()) turntable_->fit_window(8);
    viewer_.emplace(scene_, system_.display_file());
    request_.width = request_.height = wanted.size;
    request_.threads = wanted.threads;
    request_.method = HiddenMethod::z_buffer;
  }

  void run() {
    if (wanted_.kept) {
      fmt::print("{} polygons, {} x {}, {} threads, {} views\n", system_.counts().polygons,
                 wanted_.size, wanted_.size, wanted_.threads, wanted_.views);
      return bench::print_kept_views(scene_, system_.display_file(), *turntable_, request_,
                                     wanted_.views);
    }
    constexpr int kWarm = 3;
    for (int k = -kWarm; k < wanted_.views; ++k) measure(360.0 * k / wanted_.views, k >= 0);
    const double all = bench::spread(times_.new_views).median;
    fmt::print("{} polygons, {} x {}, {} threads, {} views: anew {:.2f} in units of a new view\n",
               system_.counts().polygons, wanted_.size, wanted_.size, wanted_.threads,
               wanted_.views, bench::spread(times_.anew).median / all);
    fmt::print(
        "viewing {:.2f} and drawing {:.2f} of it; memory of the views: {:.0f} bytes a polygon\n",
        bench::spread(times_.viewing).median / all, bench::spread(times_.drawing).median / all,
        static_cast<double>(viewer_->bytes()) / static_cast<double>(system_.counts().polygons));
    if (wanted_.against_truth) {
      fmt::print("wrong pixels in all views: {}\n", times_.wrong_pixels);
    }
  }

 private:
  void measure(double degrees, bool counts) {
    const auto [view, lights] = turntable_->at(degrees);
    const SceneViewer::Wanted in_view{view, lights, PictureSize{wanted_.size, wanted_.size},
                                      wanted_.threads};
    const auto start = Clock::now();
    const ViewedScene& seen = viewer_->view(in_view);
    const double viewing = since(start);
    renderer_.draw(seen, request_);
    const double new_view = since(start);
    if (!counts) return;
    const auto start_anew = Clock::now();
    const DisplayFile file = viewer_->display_file(view, lights);
    renderer_of_files_.draw(file, request_);
    times_.anew.push_back(since(start_anew));
    times_.new_views.push_back(new_view);
    times_.viewing.push_back(viewing);
    times_.drawing.push_back(new_view - viewing);
    if (wanted_.against_truth) count_wrong(file, seen);
  }

  void count_wrong(const DisplayFile& file, const ViewedScene& seen) {
    RasterRequest with_ids = request_;
    with_ids.ids = true;
    const auto right = truth(file, wanted_.size, wanted_.size, false).ids;
    const Picture& drawn = renderer_.draw(seen, with_ids);
    for (std::size_t i = 0; i < right.size(); ++i) {
      times_.wrong_pixels += drawn.ids[i] != right[i] ? 1 : 0;
    }
  }

  Wanted wanted_;
  RetainedScene scene_;
  GraphicsSystem system_;
  std::optional<Turntable> turntable_;
  RasterRequest request_;
  std::optional<SceneViewer> viewer_;
  SoftwareRenderer renderer_, renderer_of_files_;
  Times times_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("New views of a retained scene, and entering each anew in units of one");
  Wanted wanted;
  app.add_option("MESH", wanted.mesh, "a mesh file; without one, a terrain");
  app.add_option("--side", wanted.side, "of the terrain: 2 n^2 triangles")
      ->check(CLI::Range(1, 5000));
  app.add_option("--size", wanted.size, "pixels a side")->check(CLI::Range(1, 16384));
  app.add_option("--threads", wanted.threads)->check(CLI::Range(1, 1024));
  app.add_option("--views", wanted.views, "around it, measured in turn")
      ->check(CLI::Range(1, 10000));
  app.add_flag("--light", wanted.light, "of the polygons, which turns with the eye");
  app.add_flag("--shadows", wanted.shadows, "with a light as --light");
  app.add_flag("--kept", wanted.kept,
               "what is kept where only the eye moves, and where only the light does, instead");
  app.add_flag("--truth", wanted.against_truth, "wrong pixels of each view, by exact arithmetic");
  CLI11_PARSE(app, argc, argv);
  try {
    Bench(wanted).run();
  } catch (const Error& error) {
    fmt::print(stderr, "new_view_bench: {}\n", error.what());
    return 2;
  }
}
