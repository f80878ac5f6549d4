#include "interp/picture_source.h"

#include <memory>
#include <vector>

#include "displayfile/background.h"
#include "displayfile/sorted_display_file.h"
#include "interp/files/npy_file.h"
#include "interp/files/row_file.h"
#include "interp/picture_checks.h"
#include "interp/raster/antialias.h"

namespace displayfile {

bool has_background(const DrawOptions& options) {
  return options.background.value_or(Background{}).kind != Background::Kind::none;
}

RasterRequest raster_request(const DrawOptions& options) {
  RasterRequest request;
  request.width = options.width;
  request.height = options.height;
  request.rows = options.rows;
  request.ids = options.with_ids || !options.ids.empty();
  request.depth = options.with_depth || !options.depth.empty();
  request.background = options.background.value_or(Background{});
  request.threads = options.threads;
  return request;
}

void DisplayFileSource::write_vectors(const PictureFormat& format, const Destination& to,
                                      const RasterRequest& request) const {
  SortedDisplayFile map;
  if (by_depth_) {
    HiddenSurfaceOptions options;
    options.threads = request.threads;
    if (request.roundoff) options.precision = Precision{false, *request.roundoff};
    options.hidden_lines = request.hidden_lines;
    options.intersections = request.intersections;
    options.shadows = true;
    map.update(file_, HiddenMethod::map, options);
  }
  const DisplayFile& drawn = by_depth_ ? map.display_file() : file_;
  if (pens_) {
    return format.write_pens(
        pen_drawing(drawn, request.width, request.height, vectors_.paper.value_or(Paper{}), *pens_,
                    request.background),
        to);
  }
  format.write_vectors(drawn, request.width, request.height, to, request.background,
                       is_colour_rule(request.method), vectors_);
}

namespace {

/// A pixel's samples in place of the pixel: colours only.
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
void draw_colours(const PictureSource& source, const RasterRequest& request,
                  const DrawOptions& options, const TakeRows& take) {
  const int n = options.samples;
  source.draw(request_of_samples(request, n), SampleAverage(request.width, n, take));
}

}  // namespace

Picture draw_pixels(const PictureSource& source, const RasterRequest& request,
                    const DrawOptions& options) {
  require_drawable_by(request.method, options);
  if (options.samples == 1) return source.draw(request);
  Picture picture;
  if (request.ids || request.depth) picture = source.draw(request);
  picture.width = request.width;
  picture.height = options.drawn_rows();
  picture.pixels.clear();
  draw_colours(source, request, options, [&](const Picture& rows) {
    picture.pixels.insert(picture.pixels.end(), rows.pixels.begin(), rows.pixels.end());
  });
  return picture;
}

namespace {

using RowFiles = std::vector<std::unique_ptr<RowFile>>;

TakeRows write_rows(const RowFiles& files) {
  return [&files](const Picture& rows) {
    for (const auto& file : files) file->write(rows);
  };
}

}  // namespace

void write_picture(const PictureSource& source, const RasterRequest& request, const Destination& to,
                   const DrawOptions& options) {
  const auto open = [&](auto* row_file, const Destination& path) {
    return row_file(path, options.width, options.drawn_rows());
  };
  const PictureFormat& format = format_of(to, options);
  require_drawable_by(request.method, options);
  if (!format.is_of_pixels()) require_colour_of_fills(request.method, request.background);
  RowFiles files, colours;
  if (!options.ids.empty()) files.push_back(open(ids_row_file, options.ids));
  if (!options.depth.empty()) files.push_back(open(depth_row_file, options.depth));
  if (format.is_of_pixels()) {
    (options.samples == 1 ? files : colours)
        .push_back(open(has_background(options) ? format.pixel_file : format.alpha_file, to));
  }
  RasterRequest of_files = request;
  of_files.texts = format.is_of_pixels();
  if (!files.empty()) source.draw(of_files, write_rows(files));
  if (!colours.empty()) draw_colours(source, request, options, write_rows(colours));
  for (const auto* written : {&files, &colours}) {
    for (const auto& pixel_file : *written) pixel_file->finish();
  }
  if (format.write_vectors != nullptr) source.write_vectors(format, to, request);
  for (const auto* written : {&files, &colours}) {
    for (const auto& pixel_file : *written) pixel_file->commit();
  }
}

}  // namespace displayfile
