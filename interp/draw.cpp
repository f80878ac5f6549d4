#include "interp/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "clip/error.h"
#include "displayfile/file_extension.h"
#include "displayfile/output_file.h"
#include "interp/files/npy_file.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/antialias.h"
#include "interp/raster/software.h"
#include "interp/vector/pdf_device.h"
#include "interp/vector/svg_device.h"
#include "interp/visibility/auto_method.h"
#include "interp/visibility/image_space.h"

namespace displayfile {

namespace {

/// One line a format: how it is written, from pixels or from the display file itself.
struct PictureFormat {
  Choice choice;
  std::unique_ptr<RowFile> (*pixel_file)(const std::filesystem::path&, int width, int height);
  void (*write_vectors)(const DisplayFile&, int width, int height, bool z_buffer,
                        const std::filesystem::path&);
};
constexpr std::array kFormats{
    PictureFormat{{".png", "pixels, compressed"}, png_row_file, nullptr},
    PictureFormat{{".ppm", "pixels, plain"}, ppm_row_file, nullptr},
    PictureFormat{{".svg", "vectors, for the web"}, nullptr, write_svg},
    PictureFormat{{".pdf", "vectors, for print"}, nullptr, write_pdf},
};

/// One line a device that draws pixels, the whole picture or, row by row, however large it is. One
/// that has the whole picture in memory anyway leaves out the latter.
struct RasterDevice {
  Choice choice;
  Picture (*draw)(const DisplayFile&, const RasterRequest&);
  void (*draw_rows)(const DisplayFile&, const RasterRequest&, const TakeRows&);
};
constexpr std::array kDevices{
    RasterDevice{
        {"software", "by our own scan conversion"}, draw_with_software, draw_rows_with_software},
    RasterDevice{
        {"osmesa", "by OpenGL, to compare with"},
        [](const DisplayFile& d, const RasterRequest& r) { return draw_with_osmesa(d, r); },
        nullptr},
};

template <class Table>
constexpr auto choices_of(const Table& table) {
  std::array<Choice, std::tuple_size_v<Table>> choices;
  std::ranges::transform(table, choices.begin(), &Table::value_type::choice);
  return choices;
}
constexpr auto kFormatChoices = choices_of(kFormats);
constexpr auto kDeviceChoices = choices_of(kDevices);

/// The names of those lines of a table that are asked for, with something between.
template <class Table, class Which>
std::string names(const Table& table, const char* between, Which which) {
  std::string all;
  for (const auto& entry : table) {
    if (which(entry)) all.append(all.empty() ? "" : between).append(entry.choice.name);
  }
  return all;
}
constexpr auto kAny = [](const auto&) { return true; };

const PictureFormat& format_of(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  for (const PictureFormat& format : kFormats) {
    if (format.choice.name == extension) return format;
  }
  throw Error(fmt::format("{}: unknown picture format '{}': expected one of {}", file.string(),
                          file.extension().string(), names(kFormats, " ", kAny)));
}

const RasterDevice& device_of(std::string_view name) {
  for (const RasterDevice& device : kDevices) {
    if (device.choice.name == name) return device;
  }
  throw Error(fmt::format("unknown device '{}': expected {}", name, names(kDevices, " or ", kAny)));
}

/// The request for what is drawn in the order that the display file has.
RasterRequest raster_request(const DisplayFile& file, const DrawOptions& options) {
  RasterRequest request;
  request.width = options.width;
  request.height = options.height;
  request.sorted = has_exact_order(file);
  request.ids = !options.ids.empty();
  request.depth = !options.depth.empty();
  request.threads = options.threads;
  return request;
}

/// The display file has been brought up to date for the picture.
RasterRequest raster_request(const GraphicsSystem& system, const DisplayFile& file,
                             const DrawOptions& options) {
  RasterRequest request = raster_request(file, options);
  request.method = method_in_force(system, hidden_surface_options(options));
  const Precision precision = precision_in_force(system, hidden_surface_options(options));
  if (!precision.exact) request.roundoff = precision.roundoff;
  return request;
}

RasterRequest raster_request(const ViewedWorld& world, const DrawOptions& options) {
  RasterRequest request = raster_request(world.display_file, options);
  request.method = HiddenMethod::world_ray_cast;
  request.world = &world;
  if (options.precision && !options.precision->exact) {
    request.roundoff = options.precision->roundoff;
  }
  return request;
}

/// What the application drew, where the method in force casts rays before viewing.
std::optional<ViewedWorld> world_in_force(const GraphicsSystem& system, HiddenMethod method) {
  if (method != HiddenMethod::world_ray_cast) return std::nullopt;
  if (system.retained() == nullptr) {
    throw Error(
        "hidden-surface method 'world-ray-cast' needs world coordinates: expected it to be set, or "
        "the scene to be retained, before the first segment");
  }
  return WorldViews(*system.retained(), system.display_file()).as_drawn();
}

/// Every output must be writable before any is written.
void require_writable(const std::filesystem::path& file, const DrawOptions& options) {
  OutputFile{file.string()};
  if (!options.ids.empty()) OutputFile{options.ids.string()};
  if (!options.depth.empty()) OutputFile{options.depth.string()};
}

Picture draw_samples(const DisplayFile& file, const RasterRequest& request,
                     const DrawOptions& options) {
  return device_of(options.device).draw(file, request);
}

/// Rows are passed on as they are drawn, if the device can.
void draw_samples(const DisplayFile& file, const RasterRequest& request, const DrawOptions& options,
                  const TakeRows& take) {
  const RasterDevice& device = device_of(options.device);
  if (device.draw_rows == nullptr) return take(device.draw(file, request));
  device.draw_rows(file, request, take);
}

/// A pixel's samples in place of the pixel: colours only.
RasterRequest request_of_samples(RasterRequest request, int samples) {
  request.width *= samples;
  request.height *= samples;
  request.line_scale *= samples;
  request.ids = request.depth = false;
  return request;
}

/// The colours of a picture, antialiased.
void draw_colours(const DisplayFile& file, const RasterRequest& request, const DrawOptions& options,
                  const TakeRows& take) {
  const int n = options.samples;
  draw_samples(file, request_of_samples(request, n), options,
               SampleAverage(request.width, n, take));
}

/// Draws in memory; what is not a colour is not antialiased.
Picture draw_pixels(const DisplayFile& file, const RasterRequest& request,
                    const DrawOptions& options) {
  if (options.samples == 1) return draw_samples(file, request, options);
  Picture picture;
  if (request.ids || request.depth) picture = draw_samples(file, request, options);
  picture.width = request.width;
  picture.height = request.height;
  picture.pixels.clear();
  draw_colours(file, request, options, [&](const Picture& rows) {
    picture.pixels.insert(picture.pixels.end(), rows.pixels.begin(), rows.pixels.end());
  });
  return picture;
}

using RowFiles = std::vector<std::unique_ptr<RowFile>>;

TakeRows write_rows(const RowFiles& files) {
  return [&files](const Picture& rows) {
    for (const auto& file : files) file->write(rows);
  };
}

void write_picture(const DisplayFile& drawn, const RasterRequest& request, bool vectors_by_depth,
                   const std::filesystem::path& file, const DrawOptions& options) {
  const auto open = [&](auto* row_file, const std::filesystem::path& path) {
    return row_file(path, options.width, options.height);
  };
  const PictureFormat& format = format_of(file);
  RowFiles files, colours;
  if (!options.ids.empty()) files.push_back(open(ids_row_file, options.ids));
  if (!options.depth.empty()) files.push_back(open(depth_row_file, options.depth));
  if (format.pixel_file != nullptr) {
    (options.samples == 1 ? files : colours).push_back(open(format.pixel_file, file));
  }
  if (!files.empty()) draw_samples(drawn, request, options, write_rows(files));
  if (!colours.empty()) draw_colours(drawn, request, options, write_rows(colours));
  if (format.write_vectors != nullptr) {
    format.write_vectors(drawn, options.width, options.height, vectors_by_depth, file);
  }
  for (const auto* written : {&files, &colours}) {
    for (const auto& pixel_file : *written) pixel_file->commit();
  }
}

DrawOptions with_precision(const GraphicsSystem& system, DrawOptions options) {
  options.precision = precision_in_force(system, hidden_surface_options(options));
  return options;
}

/// Checks the size of what is drawn; throws Error.
void require_raster_size(const DrawOptions& options) {
  if (options.samples < 1 || options.samples > kMostSamples) {
    throw Error(fmt::format("{} samples along a pixel's side: expected 1 to {}", options.samples,
                            kMostSamples));
  }
  const auto n = static_cast<long long>(options.samples);
  require_picture_size(options.width, options.height);
  require_picture_size(n * options.width, n * options.height);
}

}  // namespace

HiddenSurfaceOptions hidden_surface_options(const DrawOptions& options) {
  return {options.hidden, options.scope, options.precision, options.threads};
}

PictureKind picture_kind(const std::filesystem::path& file) {
  return format_of(file).write_vectors != nullptr ? PictureKind::vector : PictureKind::raster;
}

HiddenMethod drawing_method(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind) {
  const HiddenMethod method = method_in_force(system, hidden_surface_options(options));
  if (method != HiddenMethod::automatic) return method;
  return choose_method(system.display_file(), kind).method;
}

void require_drawable(const std::filesystem::path& file, const DrawOptions& options) {
  const PictureFormat& format = format_of(file);
  require_raster_size(options);
  const RasterDevice& device = device_of(options.device);  // the first unless one was asked for
  if (format.write_vectors != nullptr && &device != &kDevices.front()) {
    const auto of_pixels = [](const PictureFormat& f) { return f.pixel_file != nullptr; };
    throw Error(fmt::format("{}: the {} device draws pixels: expected {}", file.string(),
                            device.choice.name, names(kFormats, " or ", of_pixels)));
  }
  require_writable(file, options);
}

Picture draw(const GraphicsSystem& system, const DrawOptions& options, SortedDisplayFile& kept) {
  require_raster_size(options);
  const HiddenSurfaceOptions hidden = hidden_surface_options(options);
  const HiddenMethod method = method_in_force(system, hidden);
  const DisplayFile& sorted = kept.update(system, method, hidden);
  if (const auto world = world_in_force(system, method)) {
    return draw(*world, with_precision(system, options));
  }
  return draw_pixels(sorted, raster_request(system, sorted, options), options);
}

Picture draw(const GraphicsSystem& system, const DrawOptions& options) {
  SortedDisplayFile kept;
  return draw(system, options, kept);
}

void draw(const GraphicsSystem& system, const std::filesystem::path& file,
          const DrawOptions& options, SortedDisplayFile& kept) {
  require_drawable(file, options);
  const HiddenSurfaceOptions hidden = hidden_surface_options(options);
  // For a picture of pixels it is the renderer that picks a method.
  const HiddenMethod method = picture_kind(file) == PictureKind::raster
                                  ? method_in_force(system, hidden)
                                  : drawing_method(system, options, PictureKind::vector);
  const DisplayFile& sorted = kept.update(system, method, hidden);
  if (const auto world = world_in_force(system, method)) {
    return draw(*world, file, with_precision(system, options));
  }
  write_picture(sorted, raster_request(system, sorted, options), is_image_space(method), file,
                options);
}

void draw(const DisplayFile& display_file, const std::filesystem::path& file,
          const DrawOptions& options) {
  require_drawable(file, options);
  write_picture(display_file, raster_request(display_file, options), false, file, options);
}

void draw(const ViewedWorld& world, const std::filesystem::path& file, const DrawOptions& options) {
  require_drawable(file, options);
  write_picture(world.display_file, raster_request(world, options), true, file, options);
}

Picture draw(const ViewedWorld& world, const DrawOptions& options) {
  require_raster_size(options);
  return draw_pixels(world.display_file, raster_request(world, options), options);
}

void draw(const GraphicsSystem& system, const std::filesystem::path& file,
          const DrawOptions& options) {
  SortedDisplayFile kept;
  draw(system, file, options, kept);
}

std::span<const Choice> picture_formats() { return kFormatChoices; }
std::span<const Choice> raster_devices() { return kDeviceChoices; }
void require_raster_device(std::string_view name) { device_of(name); }

}  // namespace displayfile
