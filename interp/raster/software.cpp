#include "interp/raster/software.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "clip/base/budgeted_work.h"
#include "clip/base/parallel.h"
#include "clip/base/work_budget.h"
#include "interp/device/interpreter.h"
#include "interp/device/raster_request.h"
#include "interp/raster/line_painter.h"
#include "interp/raster/lines_by_depth.h"
#include "interp/raster/painter.h"
#include "interp/raster/phong_shade.h"
#include "interp/raster/pixel_shade.h"
#include "interp/raster/raster_band.h"
#include "interp/raster/sorted_painter.h"
#include "interp/raster/write_pixels.h"
#include "interp/scan/shown_depth.h"
#include "interp/text/seen_texts.h"
#include "interp/text/text_painter.h"
#include "interp/visibility/auto_method.h"

namespace displayfile {

namespace {

using Fill = ViewedScene::Fill;

constexpr double kNothingSeen = -std::numeric_limits<double>::infinity();

/// The number of pixels in memory where the picture is drawn in strips.
constexpr int kPixelsAtATime = 1 << 20;

/// Calls draw(rows) for bands that together are the rows `all`, each in one of the threads; bands
/// have about at_a_time rows, but there is one for each thread.
template <class Draw>
void for_bands_of_rows(const RasterRequest& request, const RowRange& all, int at_a_time,
                       Draw&& draw) {
  const int rows = all.end - all.begin;
  if (request.surfaces.threads <= 1) return draw(all);
  const int bands =
      std::clamp(rows / std::max(1, at_a_time), std::min(request.surfaces.threads, rows), rows);
  const auto row = [&](long long b) { return all.begin + static_cast<int>(b * rows / bands); };
  in_parallel(request.surfaces.threads, static_cast<std::size_t>(bands), [&](std::size_t k) {
    const auto b = static_cast<int>(k);
    draw(RowRange{row(b), row(b + 1)});
  });
}

/// Every band costs a walk over all polygons; if they are few for the picture's size, more bands
/// balance the work better.
int rows_worth_a_walk(const RasterRequest& request, std::size_t polygons) {
  constexpr std::size_t kPixelsForEachPolygon = 64;
  constexpr std::size_t kLeast = 64;
  const auto width = static_cast<std::size_t>(request.width);
  const auto rows = std::max(kLeast, kPixelsForEachPolygon * (polygons + 1) / width);
  return static_cast<int>(std::min(rows, static_cast<std::size_t>(request.height)));
}

/// Resizes to that number of values, discarding the contents.
template <class T>
void make_room(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) values = std::vector<T>();
  values.resize(size);
}

/// Writes colours, identifiers and depths of the visible fills.
class FillsShown {
 public:
  FillsShown(const ViewedScene& scene, const FillPaints& paints, const RasterBand& band)
      : scene_(scene), paints_(paints), band_(band) {}

  void show(int row, int first, std::span<const Fill> seen) {
    Picture& picture = band_.picture;
    const std::size_t start = band_.index(row, first);
    if (band_.shows_fills) {
      write_pixels(seen, paints_.pixels(), picture.pixels.data() + start);
      if (paints_.has_shades()) shade(row, first, seen);
      if (band_.shadows != nullptr && scene_.has_shadows()) shadow(row, first, seen);
    } else {
      std::fill_n(picture.pixels.data() + start, seen.size(), band_.background);
    }
    if (!picture.ids.empty()) {
      for (std::size_t i = 0; i < seen.size(); ++i) picture.ids[start + i] = scene_.pick(seen[i]);
    }
    if (!picture.depth.empty()) show_depth(row, first, seen);
  }

 private:
  /// Calls paint(fill, column, pixels) for each run of a fill.
  template <class Paint>
  void for_each_run(int row, int first, std::span<const Fill> seen, Paint&& paint) {
    const std::span pixels(band_.picture.pixels.data() + band_.index(row, first), seen.size());
    for (std::size_t i = 0, end = 0; i < seen.size(); i = end) {
      while (end < seen.size() && seen[end] == seen[i]) ++end;
      paint(seen[i], first + static_cast<int>(i), pixels.subspan(i, end - i));
    }
  }

  void shade(int row, int first, std::span<const Fill> seen) {
    for_each_run(row, first, seen, [&](Fill fill, int column, std::span<std::uint32_t> pixels) {
      if (const FillPaints::Shade* const shade = paints_.shade(fill)) {
        PixelShade(shade->colour, shade->intensity, band_.size()).paint(row, column, pixels);
      } else if (const FillPaints::Phong* const phong = paints_.phong(fill)) {
        PhongShade(phong->colour, phong->normal, phong->light, band_.size())
            .paint(row, column, pixels);
      }
    });
  }

  void shadow(int row, int first, std::span<const Fill> seen) {
    for_each_run(row, first, seen, [&](Fill fill, int column, std::span<std::uint32_t> pixels) {
      const FillShadow* const shadow =
          fill == ViewedScene::kBackground ? nullptr : scene_.shadow(fill);
      if (shadow == nullptr) return;
      const Shadows::OnFill on_fill = band_.shadows->on(fill, band_.size());
      if (on_fill.search.is_never_hidden()) return;
      ShadowedFill(*band_.shadows, on_fill, scene_.plane(fill), *shadow, band_.size())
          .paint(row, column, pixels);
    });
  }

  void show_depth(int row, int first, std::span<const Fill> seen) {
    double* depths = band_.picture.depth.data() + band_.index(row, first);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (seen[i] == ViewedScene::kBackground) {
        depths[i] = kNothingSeen;
        continue;
      }
      if (seen[i] != fill_) {
        fill_ = seen[i];
        depth_ = ShownDepth(scene_.plane(fill_), band_.size());
      }
      depths[i] = depth_.at(first + static_cast<int>(i), row);
    }
  }

  const ViewedScene& scene_;
  const FillPaints& paints_;
  RasterBand band_;
  Fill fill_ = ViewedScene::kBackground;  // whose depth_ it is
  ShownDepth depth_;
};

/// True if a display file whose segments were sorted together draws lines.
bool has_lines(const SortedScene& sorted) {
  return std::ranges::any_of(sorted.parts,
                             [](const auto& part) { return part->scene->has_lines(); });
}

/// The renderer counts rows from the bottom.
RowRange rows_asked_for(const RasterRequest& request) {
  const PictureRows rows = request.rows.value_or(PictureRows{0, request.height});
  return {request.height - rows.end, request.height - rows.first};
}

Point2 pixels_of(const RasterRequest& request) {
  return request.crumbs ? Point2(0.0) : Point2(request.width, request.height) / request.line_scale;
}
LinesOverFills::Wanted wanted_of(const RasterRequest& request) {
  return LinesOverFills::Wanted::beside(request.surfaces, pixels_of(request));
}

}  // namespace

SoftwareRenderer::Drawn SoftwareRenderer::prepare(const DisplayFile& display_file,
                                                  const RasterRequest& request) {
  require_picture_size(request.width, request.height);
  geometry_ = 0;
  const bool image_space = is_image_space(request.surfaces.method);
  if (image_space || display_file.has_shadows()) {
    take_up_scene_of(display_file);
    take_up_scene(request);
  } else {
    shadows_.reset();
  }
  take_up_lines(display_file, request);
  texts_.clear();
  if (request.texts && display_file.has_texts()) {
    texts_ = image_space ? seen_texts(*scene_) : seen_texts(display_file, false);
  }
  annotation_.clear();
  if (request.texts && display_file.has_annotations()) {
    annotation_ = annotation_marks(display_file, annotation_page(request));
  }
  return {&display_file, display_file.polygons()};
}

/// Prepares for the display file's scene, unless it is the one drawn last.
void SoftwareRenderer::take_up_scene_of(const DisplayFile& display_file) {
  if (scene_ != nullptr && scene_->is_of(display_file)) return;
  prepared_.reset();
  shadows_.reset();
  lines_.clear();
  scene_ = std::make_shared<const ViewedScene>(display_file);
  paints_.take(*scene_);
}

/// Lines that are found together belong to the one scene, by whatever method its surfaces are
/// found.
void SoftwareRenderer::take_up_lines(const DisplayFile& display_file,
                                     const RasterRequest& request) {
  const SortedScene* const together = display_file.sorted().get();
  const bool in_image_space = is_image_space(request.surfaces.method);
  const bool as_they_come =
      !in_image_space && together != nullptr &&
      ((finds_lines(together->plan.method) && together->plan.line_order == LineOrder::entry) ||
       !has_lines(*together));
  if (is_colour_rule(request.surfaces.method) || as_they_come) return lines_.clear();
  if (in_image_space) return lines_.take(scene_, wanted_of(request));
  if (together == nullptr)
    return lines_.take_sorted_segments(display_file, pixels_of(request), request.surfaces.threads);
  take_up_scene_of(display_file);
  SurfacePlan plan = together->plan;
  plan.threads = request.surfaces.threads;
  lines_.take(scene_, LinesOverFills::Wanted::beside(plan, pixels_of(request)));
}

SoftwareRenderer::Drawn SoftwareRenderer::prepare(const ViewedScene& scene,
                                                  const RasterRequest& request,
                                                  const KeptBetweenPictures& kept) {
  require_picture_size(request.width, request.height);
  const bool same = scene.geometry() != 0 && scene.geometry() == geometry_;
  geometry_ = 0;  // unless it succeeds
  scene_ = std::shared_ptr<const ViewedScene>(std::shared_ptr<void>(), &scene);  // not its owner
  if (!same && prepared_) prepared_->scene = nullptr;
  take_up_shadows(scene, kept.casters, same);
  paints_.take(scene);
  take_up_scene(request);
  if (!same || is_colour_rule(request.surfaces.method)) lines_.clear();
  if (!is_colour_rule(request.surfaces.method)) {
    lines_.take(scene_, wanted_of(request));
  }
  texts_.clear();
  if (request.texts && !scene.texts().empty()) texts_ = seen_texts(scene);
  annotation_.clear();
  if (request.texts) annotation_ = annotation_marks(scene, annotation_page(request));
  geometry_ = scene.geometry();
  const bool is_first = !std::exchange(has_drawn_views_, true);
  return {nullptr, scene.items(), kept.surfaces && geometry_ != 0 && (same || is_first)};
}

/// Shadows found without cached casters are created on first use.
void SoftwareRenderer::take_up_shadows(const ViewedScene& scene, RetainedCasters* casters,
                                       bool same_geometry) {
  const bool of_same_kind = shadows_ != nullptr && shadows_->is_by(casters);
  if (of_same_kind && same_geometry) return shadows_->take_lights();
  if (casters == nullptr) {
    shadows_.reset();
  } else if (of_same_kind) {
    shadows_->take(scene, *casters);
  } else {
    shadows_ = std::make_unique<Shadows>(scene, *casters);
  }
}

/// Prepares the method and the shadows for the scene, unless they are prepared for it.
void SoftwareRenderer::take_up_scene(const RasterRequest& request) {
  paints_.set_background(pixel_of(request.background));
  if (scene_->has_shadows() && shadows_ == nullptr) shadows_ = std::make_unique<Shadows>(*scene_);
  if (!is_image_space(request.surfaces.method)) return;
  const PictureSize size{request.width, request.height};
  if (prepared_ && prepared_->method != request.surfaces.method) prepared_.reset();
  if (prepared_ && prepared_->scene == scene_.get() && prepared_->size == size &&
      prepared_->roundoff == request.roundoff() && prepared_->world == request.world) {
    return;
  }
  if (!prepared_ || request.world != nullptr) {
    const HiddenMethod asked = surfaces_of(request.surfaces.method);
    const HiddenMethod method = asked == HiddenMethod::automatic ? kMethodForPixels : asked;
    prepared_ = Prepared{.method = request.surfaces.method,
                         .finder = make_image_space_method(method, request.world)};
  }
  prepared_->scene = nullptr;  // unless it succeeds
  prepared_->finder->prepare({*scene_, size, request.roundoff()}, request.surfaces.threads);
  prepared_->scene = scene_.get();
  prepared_->size = size;
  prepared_->roundoff = request.roundoff();
  prepared_->world = request.world;
}

/// The least number of rows that are as cheap to draw by themselves.
int SoftwareRenderer::rows_at_a_time(const Drawn& drawn, const RasterRequest& request) const {
  const int rows = rows_worth_a_walk(request, drawn.polygons);
  if (!is_image_space(request.surfaces.method)) return rows;
  const int of_method = prepared_->finder->rows_at_a_time();
  return scene_->has_lines() ? std::max(rows, of_method) : of_method;
}

/// Draws these rows; they become the picture's contents.
void SoftwareRenderer::draw_rows(const Drawn& drawn, const RasterRequest& request,
                                 const RowRange& rows) {
  const bool image_space = is_image_space(request.surfaces.method);
  const bool by_depth =
      image_space && is_colour_rule(request.surfaces.method) && scene_->has_lines();
  picture_.width = request.width;
  picture_.height = rows.end - rows.begin;
  picture_.undecided_centres = 0;
  const auto pixels =
      static_cast<std::size_t>(picture_.width) * static_cast<std::size_t>(picture_.height);
  make_room(picture_.pixels, pixels);
  make_room(picture_.ids, request.ids ? pixels : 0);
  const bool spare = by_depth && !request.depth;
  if (spare) std::swap(picture_.depth, spare_depth_);
  make_room(picture_.depth, request.depth || by_depth ? pixels : 0);
  if (image_space) {
    show_fills_seen(drawn, request, rows);
    by_depth ? draw_lines_by_depth(request, rows) : draw_lines_seen(request, rows);
  } else {
    paint_in_order(*drawn.display_file, request, rows);
  }
  const PictureSize size{request.width, request.height};
  const DrawnLetters letters{request.lettering, request.line_scale};
  if (!texts_.empty()) paint_texts(texts_, letters, size, rows.begin, rows.end, picture_);
  if (!annotation_.empty()) {
    paint_annotation(annotation_, request.background, letters, size, rows.begin, rows.end,
                     picture_);
  }
  if (spare) {
    std::swap(picture_.depth, spare_depth_);
    picture_.depth.clear();
  }
}

std::size_t SoftwareRenderer::bytes_of_picture() const {
  const auto held = [](const auto& values) { return values.capacity() * sizeof(values[0]); };
  return held(picture_.pixels) + held(picture_.ids) + held(picture_.depth);
}

namespace {

/// The depth of the part at the pixel, if it is drawn there.
std::optional<double> depth_shown(const LinesOverFills::DeepPart& part, const PictureSize& size,
                                  const Picker::Pixel& at) {
  std::optional<double> depth;
  LinePainter painter({size, at.row, at.row + 1});
  LinesOverFills::Group::draw(part, painter, [&](int x, int, double z, std::uint32_t) {
    if (x == at.column) depth = z;
  });
  return depth;
}

struct NearPart {
  double distance, depth;
};

/// The distance of the part's axis from the pixel's centre, in pixels, and its depth there.
NearPart nearest_of(const LinesOverFills::DeepPart& part, const PictureSize& size,
                    const Picker::Pixel& at) {
  const Point2 pixels(size.width, size.height), centre(at.column + 0.5, at.row + 0.5);
  const Point3 &from = part.stroke.from, &to = part.stroke.to;
  const Point2 start = Point2(from) * pixels, way = Point2(to - from) * pixels;
  const double squared = glm::dot(way, way);
  const double along = squared > 0.0 ? glm::dot(centre - start, way) / squared : part.from;
  const double t = std::clamp(along, part.from, part.to);
  return {glm::distance(centre, start + t * way), from.z + t * (to.z - from.z)};
}

}  // namespace

std::optional<Pick> SoftwareRenderer::line_at(const PictureSize& size, const Picker::Pixel& at,
                                              double reach) const {
  const LinesOverFills::Group* const group = lines_.all();
  if (group == nullptr) return std::nullopt;
  const auto pick = [&](const LinesOverFills::DeepPart& part, double depth) {
    const ViewedScene& scene = *group->scene;
    const bool is_line = scene.kind(part.item) == Primitives::Kind::line;
    return Pick{is_line ? Pick::Kind::line : Pick::Kind::edge, scene.pick_of_item(part.item),
                scene.segment_name(part.item), depth, std::nullopt};
  };
  std::optional<Pick> nearest;
  double least = reach;
  for (std::size_t k = group->by_depth.size(); k-- > 0;) {  // the nearest is the last
    const auto& part = group->by_depth[k];
    if (part.is_hidden) continue;
    if (const auto depth = depth_shown(part, size, at)) return pick(part, *depth);
    const NearPart near = nearest_of(part, size, at);
    if (near.distance > least || (nearest && near.distance == least)) continue;
    least = near.distance;
    nearest = pick(part, near.depth);
  }
  return nearest;
}

std::shared_ptr<const ViewedScene> SoftwareRenderer::scene_of(
    const DisplayFile& display_file) const {
  if (scene_ != nullptr && scene_->is_of(display_file)) return scene_;
  return std::make_shared<const ViewedScene>(display_file);
}

void SoftwareRenderer::paint_in_order(const DisplayFile& display_file, const RasterRequest& request,
                                      const RowRange& rows) {
  const std::uint32_t background = pixel_of(request.background);
  std::ranges::fill(picture_.pixels, background);
  std::ranges::fill(picture_.ids, -1);
  std::ranges::fill(picture_.depth, kNothingSeen);
  std::atomic<std::size_t> undecided = 0;
  const int at_a_time = rows_worth_a_walk(request, display_file.polygons());
  for_bands_of_rows(request, rows, at_a_time, [&](const RowRange& of_band) {
    const RasterBand band(picture_, {request.width, request.height}, background, rows, of_band,
                          shadows_.get(), !is_colour_rule(request.surfaces.method), request.crumbs);
    if (request.sorted) {
      SortedPainter painter(display_file, band, lines_, request.line_scale);
      interpret(display_file, painter, Pass::everything, Order::drawn, request.line_scale);
      undecided += painter.decide_centres();
    } else {
      Painter painter(band, lines_, request.line_scale);
      interpret(display_file, painter, Pass::everything, Order::drawn, request.line_scale);
      painter.end();
    }
  });
  picture_.undecided_centres = undecided;
}

/// Shows the visible fills, newly found or kept.
void SoftwareRenderer::show_fills_seen(const Drawn& drawn, const RasterRequest& request,
                                       const RowRange& rows) {
  const PictureSize size{request.width, request.height};
  const KeptSurfaces::Of of{geometry_, request.surfaces.method, size, request.roundoff()};
  const bool keeps = drawn.keeps_surfaces && rows.begin == 0 && rows.end == request.height;
  const bool kept = keeps && surfaces_.are(of);
  if (keeps && !kept) surfaces_.begin(size);
  if (!kept) ++surfaces_found_;
  const ImageSpaceMethod& finder = *prepared_->finder;
  for_bands_of_rows(request, rows, finder.rows_at_a_time(), [&](const RowRange& band) {
    FillsShown shown(*scene_, paints_,
                     {picture_, size, pixel_of(request.background), rows, band, shadows_.get(),
                      !is_colour_rule(request.surfaces.method)});
    if (kept) {
      for (int row = band.begin; row < band.end; ++row) shown.show(row, 0, surfaces_.row(row));
      return;
    }
    int asked_at = -1;
    const auto show = [&](int row, int first, std::span<const Fill> seen) {
      if (row != asked_at) {
        asked_at = row;
        ask_budget();
      }
      if (keeps) surfaces_.keep(row, first, seen);
      shown.show(row, first, seen);
    };
    finder.draw_rows(band.begin, band.end, std::cref(show));  // copying would allocate memory
  });
  if (keeps) surfaces_.complete(of);
}

void SoftwareRenderer::draw_lines_seen(const RasterRequest& request, const RowRange& rows) {
  if (lines_.all() == nullptr || lines_.all()->is_nothing()) return;
  const LinesOverFills::Group& lines = *lines_.all();
  const int at_a_time = rows_worth_a_walk(request, scene_->items());
  for_bands_of_rows(request, rows, at_a_time, [&](const RowRange& of_band) {
    const PictureSize size{request.width, request.height};
    RasterBand band(picture_, size, pixel_of(request.background), rows, of_band);
    LinePainter painter(band.region, request.line_scale);
    lines.draw(painter, [&](int x, int y, double /*z*/, std::uint32_t colour) {
      picture_.pixels[band.index(y, x)] = colour;
    });
  });
}

void SoftwareRenderer::draw_lines_by_depth(const RasterRequest& request, const RowRange& rows) {
  std::vector<double> of_fills;
  if (request.depth) of_fills = picture_.depth;
  const int at_a_time = rows_worth_a_walk(request, scene_->items());
  for_bands_of_rows(request, rows, at_a_time, [&](const RowRange& band) {
    LinesByDepth lines(
        {picture_, {request.width, request.height}, pixel_of(request.background), rows, band},
        request.line_scale);
    interpret_lines(*scene_, lines, request.line_scale);
  });
  if (request.depth) picture_.depth = std::move(of_fills);
}

const Picture& SoftwareRenderer::draw(const Drawn& drawn, const RasterRequest& request) {
  draw_rows(drawn, request, rows_asked_for(request));
  return picture_;
}

/// Draws from the top, in strips that are whole bands of the method's.
void SoftwareRenderer::draw(const Drawn& drawn, const RasterRequest& request,
                            const TakeRows& take) {
  const int band = rows_at_a_time(drawn, request);
  const int bands =
      std::max(useful_threads(request.surfaces.threads), kPixelsAtATime / request.width / band);
  const int rows = std::min(band * bands, request.height);
  const RowRange all = rows_asked_for(request);
  for (int end = all.end; end > all.begin;) {
    ask_budget();
    const int begin = std::max((end - 1) / rows * rows, all.begin);
    draw_rows(drawn, request, {begin, end});
    take(picture_);
    end = begin;
  }
}

const Picture& SoftwareRenderer::draw(const DisplayFile& display_file,
                                      const RasterRequest& request) {
  return draw(prepare(display_file, request), request);
}

void SoftwareRenderer::draw(const DisplayFile& display_file, const RasterRequest& request,
                            const TakeRows& take) {
  draw(prepare(display_file, request), request, take);
}

const Picture& SoftwareRenderer::draw(const ViewedScene& scene, const RasterRequest& request,
                                      const KeptBetweenPictures& kept) {
  const Picture& picture = draw(prepare(scene, request, kept), request);
  scene_.reset();
  return picture;
}

void SoftwareRenderer::draw(const ViewedScene& scene, const RasterRequest& request,
                            const KeptBetweenPictures& kept, const TakeRows& take) {
  draw(prepare(scene, request, kept), request, take);
  scene_.reset();
}

Picture draw_with_software(const DisplayFile& display_file, const RasterRequest& request) {
  SoftwareRenderer renderer;
  renderer.draw(display_file, request);
  return renderer.take_picture();
}

}  // namespace displayfile
