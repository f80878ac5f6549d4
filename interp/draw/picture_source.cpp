#include "interp/draw/picture_source.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "clip/base/work_budget.h"
#include "displayfile/looks/style.h"
#include "displayfile/segments/sorted_display_file.h"
#include "interp/device/raster_request.h"
#include "interp/draw/picture_checks.h"
#include "interp/files/npy_file.h"
#include "interp/files/page_row_file.h"
#include "interp/files/row_file.h"
#include "interp/raster/antialias.h"

namespace displayfile {

bool has_background(const DrawOptions& options) {
  return options.background.value_or(Background{}).kind != Background::Kind::none;
}

RasterRequest raster_request(const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  RasterRequest request;
  request.width = options.width;
  request.height = options.height;
  request.rows = options.rows;
  request.surfaces = plan.surfaces.by(plan.method);
  request.ids = options.with_ids || !options.ids.empty();
  request.depth = options.with_depth || !options.depth.empty();
  request.background = options.background.value_or(Background{});
  request.crumbs = options.crumbs;
  request.lettering = options.lettering;
  request.dpi = options.dpi;
  return request;
}

void DisplayFileSource::write_vectors(const PictureFormat& format, const Destination& to,
                                      const RasterRequest& request) const {
  SortedDisplayFile map;
  if (by_depth_) {
    SurfacePlan plan = request.surfaces.by(HiddenMethod::map);
    plan.scope = HiddenScope::all;
    plan.shadows = true;
    map.update(file_, plan);
  }
  const DisplayFile& drawn = by_depth_ ? map.display_file() : file_;
  const DrawOptions& options = plan_.options;
  VectorOptions vectors = options.vectors;
  vectors.crumbs |= options.crumbs;
  vectors.lettering = options.lettering;
  if (options.pens) {
    Pens pens = *options.pens;
    pens.crumbs |= options.crumbs;
    pens.lettering = options.lettering;
    const PenDrawing by_pens =
        pen_drawing(drawn, request.width, request.height, vectors.paper.value_or(Paper{}), pens,
                    request.background);
    format.write_pens(by_pens, to, vectors);
    if (!options.warn) return;
    for (const std::string& colour : layers_without_pen(by_pens, pens)) {
      options.warn({DrawWarning::Kind::no_effect,
                    "layer " + colour + " has no effect: no pen of the picture has this colour"});
    }
    return;
  }
  format.write_vectors(drawn, request.width, request.height, to, request.background,
                       is_colour_rule(request.surfaces.method), vectors);
}

std::string DisplayFileSource::why_nothing_is_seen(const SeenIn& in) const {
  SeenIn as_entered = in;
  if (entered_.view != nullptr) as_entered.view = *entered_.view;
  if (!nothing_is_seen(file_, in)) return "";
  return entered_.scene != nullptr
             ? displayfile::why_nothing_is_seen(*entered_.scene, file_, as_entered)
             : displayfile::why_nothing_is_seen(file_, in);
}

namespace {

/// Records whether pixels differ from the background: then something is visible, and the scene need
/// not be examined.
class PixelsShown {
 public:
  /// Pixels are not examined if the options have no `warn`.
  PixelsShown(const DrawOptions& options, const RasterRequest& request)
      : shown_(!options.warn), background_(pixel_of(request.background)) {}
  void look_at(const Picture& rows) {
    shown_ = shown_ || std::ranges::any_of(rows.pixels, [this](std::uint32_t pixel) {
               return pixel != background_;
             });
  }
  bool any() const { return shown_; }

 private:
  bool shown_;
  std::uint32_t background_;
};

void warn_if_nothing_is_seen(const PictureSource& source, const PicturePlan& plan) {
  std::string why;
  try {
    why = source.why_nothing_is_seen(seen_in(plan));
  } catch (const LimitReached&) {  // the picture is there
    return;
  } catch (const std::bad_alloc&) {
    return;
  }
  if (why.empty()) return;
  plan.options.warn({DrawWarning::Kind::nothing_seen, "nothing is seen: " + why});
}

/// The request for a picture whose pixels are the samples: colours only.
RasterRequest request_of_samples(RasterRequest request, int samples) {
  request.width *= samples;
  request.height *= samples;
  if (request.rows)
    request.rows = PictureRows{request.rows->first * samples, request.rows->end * samples};
  request.line_scale *= samples;
  request.ids = request.depth = false;
  return request;
}

/// The colours of a picture, antialiased.
void draw_colours(const PictureSource& source, const RasterRequest& request, int n,
                  const TakeRows& take) {
  source.draw(request_of_samples(request, n), SampleAverage(request.width, n, take));
}

}  // namespace

namespace {

/// An empty picture, which reuses the source's spare memory if it has some.
Picture empty_picture(const PictureSource& source) {
  Picture picture;
  picture.pixels = source.take_spare().pixels;
  return picture;
}

Picture draw_samples(const PictureSource& source, const RasterRequest& request,
                     const PicturePlan& plan) {
  if (plan.samples == 1) return source.draw(request);
  const bool wants_fills = request.ids || request.depth;
  Picture picture = wants_fills ? source.draw(request) : empty_picture(source);
  picture.width = request.width;
  picture.height = plan.options.drawn_rows();
  picture.pixels.clear();
  picture.pixels.reserve(static_cast<std::size_t>(picture.width) *
                         static_cast<std::size_t>(picture.height));
  draw_colours(source, request, plan.samples, [&](const Picture& rows) {
    picture.pixels.insert(picture.pixels.end(), rows.pixels.begin(), rows.pixels.end());
  });
  return picture;
}

}  // namespace

Picture draw_pixels(const PictureSource& source, const RasterRequest& request,
                    const PicturePlan& plan) {
  require_drawable_by(request.surfaces.method, plan);
  Picture picture = draw_samples(source, request, plan);
  PixelsShown shown(plan.options, request);
  shown.look_at(picture);
  if (!shown.any()) warn_if_nothing_is_seen(source, plan);
  return picture;
}

namespace {

using RowFiles = std::vector<std::unique_ptr<RowFile>>;

TakeRows write_rows(const RowFiles& files, PixelsShown& shown) {
  return [&](const Picture& rows) {
    shown.look_at(rows);
    for (const auto& file : files) file->write(rows);
  };
}

}  // namespace

void write_picture(const PictureSource& source, const RasterRequest& request,
                   const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  const Destination& to = *plan.to;
  const PictureFormat& format = *plan.format;
  const auto open = [&](auto* row_file, const Destination& path) {
    return row_file(path, options.width, options.drawn_rows());
  };
  const auto open_picture = [&] {
    const Alpha alpha = has_background(options) ? Alpha::none : Alpha::stored;
    const auto& file = format.pixel_file;
    if (!plan.page) return file(to, options.width, options.drawn_rows(), alpha, options.dpi);
    return page_row_file(file(to, plan.page->width, plan.page->height, alpha, options.dpi),
                         *plan.page, pixel_of(request.background));
  };
  require_drawable_by(request.surfaces.method, plan);
  if (!format.is_of_pixels()) require_colour_of_fills(request.surfaces.method, request.background);
  RowFiles files, colours;
  if (!options.ids.empty()) files.push_back(open(ids_row_file, options.ids));
  if (!options.depth.empty()) files.push_back(open(depth_row_file, options.depth));
  if (format.is_of_pixels()) {
    (plan.samples == 1 ? files : colours).push_back(open_picture());
  }
  RasterRequest of_files = request;
  of_files.texts = format.is_of_pixels();
  PixelsShown shown(options, request);
  if (!files.empty()) source.draw(of_files, write_rows(files, shown));
  if (!colours.empty()) draw_colours(source, request, plan.samples, write_rows(colours, shown));
  for (const auto* written : {&files, &colours}) {
    for (const auto& pixel_file : *written) pixel_file->finish();
  }
  if (!format.is_of_pixels()) source.write_vectors(format, to, request);
  for (const auto* written : {&files, &colours}) {
    for (const auto& pixel_file : *written) pixel_file->commit();
  }
  if (options.warn && !shown.any()) warn_if_nothing_is_seen(source, plan);
}

}  // namespace displayfile
