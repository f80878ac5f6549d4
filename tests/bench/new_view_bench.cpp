// New views of a retained scene (displayfile/views/scene_viewer.md) against entering each view anew
// and drawing that; and the gain from keeping the data that a moving eye, or a moving light, leaves
// unchanged: with them kept, the same with only memory kept, and entered and drawn anew, in turn. A
// mesh, or a terrain of about that number of polygons: plain, lit, and with shadows.

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <optional>

#include "displayfile/mesh/mesh.h"
#include "displayfile/views/scene_viewer.h"
#include "displayfile/views/turntable.h"
#include "interp/raster/software.h"
#include "interp/truth/truth.h"
#include "tests/bench/benchmark.h"
#include "tests/from_eyes.h"

namespace displayfile::bench {

const char* const kAbout = "New views of a retained scene, and entering each anew in units of one";

namespace {

constexpr int kViews = 24, kWarm = 3;

void enter_terrain(std::size_t polygons, GraphicsSystem& system) {
  const auto n = static_cast<int>(std::sqrt(static_cast<double>(polygons) / 2.0));
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
  system.set_perspective({0.3, -2.5, 2.0});
  system.set_view_plane_normal({-0.3, 2.5, -2.0});
  system.set_view_up({0, 0, 1});
  system.set_window(-1.3, 1.3, -1.3, 1.3);
  system.open_segment(1);
  system.polygons_abs_3({vertices, corners});
  system.close_segment();
}

/// As Turntable turns, in world coordinates.
glm::dmat3 turned(double degrees) {
  return glm::dmat3(
      glm::rotate(glm::dmat4(1.0), degrees * std::numbers::pi / 180.0, Point3(0.3, 0.2, 1.0)));
}

struct Times {
  std::vector<double> seconds;
  void add(double s, bool counts) {
    if (counts) seconds.push_back(s);
  }
  double over(const Times& unit) const {
    return figure(spread(seconds).median / spread(unit.seconds).median);
  }
};

class Bench {
 public:
  Bench(const std::string& mesh, const char* look, const Options& options)
      : options_(options), row_{{"look", look}} {
    const std::string words = look;
    system_.retain(&scene_);
    if (words != "plain") system_.set_light({1, 2, 3}, 0.2);
    system_.set_shadows(words == "shadows");
    system_.set_line_style({LineStyle::Kind::none});
    if (mesh.empty()) {
      enter_terrain(options.polygons, system_);
    } else {
      import_mesh(mesh, system_);
    }
    turntable_.emplace(scene_, system_.display_file(), system_.view());
    if (!mesh.empty()) turntable_->fit_window(8);
    request_.width = request_.height = options.size;
    request_.surfaces.threads = options.threads;
    request_.surfaces.method = HiddenMethod::z_buffer;
    row_["polygons"] = system_.counts().polygons;
  }

  void print_views() {
    SceneViewer viewer(scene_, system_.display_file());
    SoftwareRenderer renderer, renderer_of_files;
    Times views, viewing, anew;
    std::size_t wrong = 0;
    for (int k = -kWarm; k < kViews; ++k) {
      const auto [view, lights] = turntable_->at(360.0 * k / kViews);
      const ViewedScene* seen = nullptr;
      const double found = seconds([&, &at = view, &by = lights] {
        seen = &viewer.view({at, by, size(), options_.threads});
      });
      viewing.add(found, k >= 0);
      views.add(found + seconds([&] { renderer.draw(*seen, request_); }), k >= 0);
      if (k < 0) continue;
      anew.add(seconds([&, &at = view, &by = lights] {
                 renderer_of_files.draw(viewer.display_file(at, by), request_);
               }),
               true);
      RasterRequest with_ids = request_;
      with_ids.ids = true;
      const auto right =
          truth(viewer.display_file(view, lights), size().width, size().height, false).ids;
      const Picture& drawn = renderer.draw(*seen, with_ids);
      for (std::size_t i = 0; i < right.size(); ++i) wrong += drawn.ids[i] != right[i] ? 1 : 0;
    }
    Json row{{"table", "in units of a new view"}};
    row.update(row_);
    row["anew"] = anew.over(views);
    row["viewing"] = viewing.over(views);
    row["bytes a polygon of the views"] =
        viewer.bytes() / static_cast<std::size_t>(system_.counts().polygons);
    row["wrong pixels"] = wrong;
    print_row(row);
  }

  void print_kept(bool eye_moves) {
    test::FromEyes kept(scene_, system_.display_file());
    SceneViewer viewer(scene_, system_.display_file());
    SoftwareRenderer renderer, renderer_of_files;
    DrawOptions drawn{.samples = 1};
    drawn.width = drawn.height = options_.size;
    drawn.surfaces.threads = options_.threads;
    drawn.surfaces.method = request_.surfaces.method;
    Times of_kept, of_memory, anew;
    int same = 0;
    for (int k = -kWarm; k < kViews; ++k) {
      const double degrees = 360.0 * k / kViews;
      const View view = turntable_->at(eye_moves ? degrees : 20.0).view;
      const glm::dmat3 lights = eye_moves ? glm::dmat3(1.0) : turned(degrees);
      const Picture *by_kept = nullptr, *by_file = nullptr;
      of_kept.add(seconds([&] { by_kept = &kept.draw(view, drawn, lights); }), k >= 0);
      viewer.view(
          {View(), lights, size(), options_.threads});  // discards the data of earlier views
      of_memory.add(
          seconds([&] {
            renderer.draw(viewer.view({view, lights, size(), options_.threads}), request_);
          }),
          k >= 0);
      anew.add(seconds([&] {
                 by_file = &renderer_of_files.draw(viewer.display_file(view, lights), request_);
               }),
               k >= 0);
      same += k >= 0 && by_kept->pixels == by_file->pixels ? 1 : 0;
    }
    Json row{{"table", "in units of a kept view"}};
    row.update(row_);
    row["moves"] = eye_moves ? "eye" : "light";
    row["only memory kept"] = of_memory.over(of_kept);
    row["anew"] = anew.over(of_kept);
    row["same pictures"] = fmt::format("{} of {}", same, kViews);
    row["bytes a polygon for shadows"] = kept.bytes_of_casters() / scene_.size();
    print_row(row);
  }

 private:
  PictureSize size() const { return {options_.size, options_.size}; }

  const Options& options_;
  Json row_;
  RetainedScene scene_;
  GraphicsSystem system_;
  std::optional<Turntable> turntable_;
  RasterRequest request_;
};

}  // namespace

void run(const Options& options) {
  for (const char* look : {"plain", "lit", "shadows"}) {
    if (!options.has(look)) continue;
    Bench bench(options.inputs.empty() ? "" : options.inputs.front(), look, options);
    bench.print_views();
    if (look == std::string("plain")) continue;
    for (const bool eye_moves : {true, false}) bench.print_kept(eye_moves);
  }
}

}  // namespace displayfile::bench
