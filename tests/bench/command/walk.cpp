#include "tests/bench/command/walk.h"

#include <cmath>
#include <numbers>

#include "displayfile/segments/retained_scene.h"
#include "displayfile/views/retained_views.h"
#include "interp/device/raster_request.h"
#include "interp/raster/software.h"
#include "programs/scenes/generated_scenes.h"

namespace displayfile::bench {

namespace {

class WalkDrawing : public Drawing {
 public:
  WalkDrawing(const std::vector<Scene>& views, const Contender& contender, const Frame& frame)
      : views_(views), contender_(contender), frame_(frame) {}
  void draw_anew() override {
    for (const Scene& view : views_) {
      const GraphicsSystem system = entered(view);
      contender_.draw(system.display_file(), frame_)->draw_anew();
    }
  }
  Picture judged() override {
    Picture all;
    for (const Scene& view : views_) {
      const GraphicsSystem system = entered(view);
      const auto drawing = contender_.draw(system.display_file(), frame_);
      drawing->draw_anew();
      append(drawing->judged(), all);
    }
    return all;
  }

 private:
  const std::vector<Scene>& views_;
  Contender contender_;
  Frame frame_;
};

class TreeWalkDrawing : public Drawing {
 public:
  TreeWalkDrawing(const std::vector<Scene>& views, const Frame& frame) : views_(views) {
    request_.width = frame.width;
    request_.height = frame.height;
    request_.surfaces.threads = frame.threads;
    request_.sorted = true;
    system_.retain(&scene_);
    enter(views.front(), system_);
  }
  void draw_anew() override {
    trees_ = std::make_unique<RetainedViews>(scene_, system_.display_file(), SurfacePlan{});
    draw_again();
  }
  void draw_again() override {
    for (const Scene& view : views_) renderer_.draw(trees_->view(view.view), request_);
  }
  Picture judged() override {
    RasterRequest request = request_;
    request.ids = request.depth = true;
    Picture all;
    for (const Scene& view : views_) {
      append(renderer_.draw(trees_->view(view.view), request), all);
    }
    return all;
  }

 private:
  const std::vector<Scene>& views_;
  RasterRequest request_;
  RetainedScene scene_;
  GraphicsSystem system_;
  std::unique_ptr<RetainedViews> trees_;
  SoftwareRenderer renderer_;
};

/// The k-th step: into the city above its streets, looking ahead and a little to the sides.
View view_of_step(int k) {
  const double along = static_cast<double>(k) / kViewsOfWalk;
  const double turn = 0.5 * std::sin(2.0 * std::numbers::pi * along);
  const Point3 ahead(std::sin(turn), -0.25, -std::cos(turn));
  const Point3 eye(0.3 * std::sin(9.0 * along), 0.55, 0.8 - 2.0 * along);
  View view;
  view.set_reference_point(eye + ahead);
  view.set_plane_normal(ahead);
  view.set_perspective(eye);
  view.set_window({-0.8, 0.8, -0.8, 0.8});
  view.set_depth(-0.95, 4.0);
  return view;
}

}  // namespace

std::vector<Scene> walk(std::size_t n, std::uint64_t seed) {
  std::vector<Scene> views;
  for (int k = 0; k < kViewsOfWalk; ++k) {
    views.push_back(generated_scene("city").make(n, seed));
    views.back().view = view_of_step(k);
  }
  return views;
}

void append(const Picture& picture, Picture& all) {
  all.width = picture.width;
  all.height += picture.height;
  all.ids.insert(all.ids.end(), picture.ids.begin(), picture.ids.end());
  all.depth.insert(all.depth.end(), picture.depth.begin(), picture.depth.end());
}

std::unique_ptr<Drawing> draw_walk(const std::vector<Scene>& views, const Contender& contender,
                                   const Frame& frame) {
  return std::make_unique<WalkDrawing>(views, contender, frame);
}

Contender retained_tree() { return {"bsp", "retained tree", false, true, true, nullptr}; }

std::unique_ptr<Drawing> draw_walk_with_tree(const std::vector<Scene>& views, const Frame& frame) {
  return std::make_unique<TreeWalkDrawing>(views, frame);
}

}  // namespace displayfile::bench
