#include "interp/draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/error.h"
#include "clip/memory.h"
#include "clip/nearest_word.h"
#include "displayfile/file_extension.h"
#include "displayfile/output_file.h"
#include "displayfile/scene_viewer.h"
#include "interp/files/npy_file.h"
#include "interp/files/png_file.h"
#include "interp/files/ppm_file.h"
#include "interp/opengl/osmesa.h"
#include "interp/raster/antialias.h"
#include "interp/raster/software.h"
#include "interp/renderer.h"
#include "interp/vector/pdf_device.h"
#include "interp/vector/svg_device.h"
#include "interp/view_renderer.h"
#include "interp/visibility/auto_method.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/picker.h"

namespace displayfile {

namespace {

/// One line a format: how it is written, from pixels, with alpha where there is no background, or
/// from the display file itself.
struct PictureFormat {
  Choice choice;
  std::unique_ptr<RowFile> (*pixel_file)(const std::filesystem::path&, int width, int height);
  std::unique_ptr<RowFile> (*alpha_file)(const std::filesystem::path&, int width, int height);
  void (*write_vectors)(const DisplayFile&, int width, int height, bool z_buffer,
                        const std::filesystem::path&, const Background&);

  bool can_be_transparent() const { return alpha_file != nullptr || write_vectors != nullptr; }
};
constexpr std::array kFormats{
    PictureFormat{{".png", "pixels, compressed"}, png_row_file, png_alpha_row_file, nullptr},
    PictureFormat{{".ppm", "pixels, plain"}, ppm_row_file, nullptr, nullptr},
    PictureFormat{{".svg", "vectors, for the web"}, nullptr, nullptr, write_svg},
    PictureFormat{{".pdf", "vectors, for print"}, nullptr, nullptr, write_pdf},
};

/// One line a device that draws pixels, the whole picture or, row by row, however large it is. One
/// that has the whole picture in memory anyway leaves out the latter. `kept` is the first device's.
struct RasterDevice {
  Choice choice;
  Picture (*draw)(const DisplayFile&, const RasterRequest&, SoftwareRenderer& kept);
  void (*draw_rows)(const DisplayFile&, const RasterRequest&, SoftwareRenderer& kept,
                    const TakeRows&);
};
constexpr std::array kDevices{
    RasterDevice{{"software", "by our own scan conversion"},
                 [](const DisplayFile& d, const RasterRequest& r, SoftwareRenderer& kept) {
                   kept.draw(d, r);
                   return kept.take_picture();
                 },
                 [](const DisplayFile& d, const RasterRequest& r, SoftwareRenderer& kept,
                    const TakeRows& take) { kept.draw(d, r, take); }},
    RasterDevice{{"osmesa", "by OpenGL, to compare with"},
                 [](const DisplayFile& d, const RasterRequest& r, SoftwareRenderer&) {
                   return draw_with_osmesa(d, r);
                 },
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
template <class Table>
std::string meant_by(const Table& table, std::string_view name) {
  std::vector<std::string_view> known;
  known.reserve(std::size(table));
  for (const auto& entry : table) known.push_back(entry.choice.name);
  return did_you_mean(name, known);
}
constexpr auto kAny = [](const auto&) { return true; };

/// The format of an extension as it was given, in letters of either case, with its dot or without.
/// Throws Error if there is none, with `whose` before the message.
const PictureFormat& format_named(const std::string& extension, const std::string& whose = "") {
  const std::string name = extension_of((extension.starts_with('.') ? "x" : "x.") + extension);
  for (const PictureFormat& format : kFormats) {
    if (format.choice.name == name) return format;
  }
  throw Error(fmt::format("{}unknown picture format '{}':{} expected one of {}", whose, extension,
                          meant_by(kFormats, name), names(kFormats, " ", kAny)));
}

const PictureFormat& format_of(const std::filesystem::path& file, const DrawOptions& options) {
  if (!options.format.empty()) return format_named(options.format);
  if (file == "-") return kFormats.front();
  return format_named(file.extension().string(), file.string() + ": ");
}

const RasterDevice& device_of(std::string_view name) {
  for (const RasterDevice& device : kDevices) {
    if (device.choice.name == name) return device;
  }
  throw Error(fmt::format("unknown device '{}':{} expected {}", name, meant_by(kDevices, name),
                          names(kDevices, " or ", kAny)));
}

bool has_background(const DrawOptions& options) {
  return options.background.value_or(Background{}).kind != Background::Kind::none;
}

RasterRequest raster_request(const DrawOptions& options) {
  RasterRequest request;
  request.width = options.width;
  request.height = options.height;
  request.ids = options.with_ids || !options.ids.empty();
  request.depth = options.with_depth || !options.depth.empty();
  request.background = options.background.value_or(Background{});
  request.threads = options.threads;
  return request;
}

/// The request for what is drawn in the order that the display file has.
RasterRequest raster_request(const DisplayFile& file, const DrawOptions& options) {
  RasterRequest request = raster_request(options);
  request.sorted = has_exact_order(file);
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

/// A retained scene in a view. Throws Error for a method that does not draw one.
RasterRequest raster_request_of_view(const DrawOptions& options) {
  RasterRequest request = raster_request(options);
  request.method = options.hidden.value_or(HiddenMethod::automatic);
  if (!is_image_space(request.method) || request.method == HiddenMethod::world_ray_cast) {
    throw Error(
        fmt::format("a view renderer finds hidden surfaces in image space, not by {}: "
                    "expected a method of image space",
                    name_of(request.method)));
  }
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

/// What a picture is drawn of: a display file, or a retained scene in a view.
class Source {
 public:
  virtual ~Source() = default;
  virtual Picture draw(const RasterRequest& request) const = 0;
  /// Rows are passed on as they are drawn, if the device can.
  virtual void draw(const RasterRequest& request, const TakeRows& take) const = 0;
  virtual void write_vectors(const PictureFormat& format, const std::filesystem::path& file,
                             const RasterRequest& request) const = 0;
};

class DisplayFileSource : public Source {
 public:
  /// `by_depth`: vectors find their hidden surfaces themselves.
  DisplayFileSource(const DisplayFile& file, bool by_depth, const DrawOptions& options,
                    SoftwareRenderer& kept)
      : file_(file), by_depth_(by_depth), device_(device_of(options.device)), kept_(kept) {}

  Picture draw(const RasterRequest& request) const override {
    return device_.draw(file_, request, kept_);
  }
  void draw(const RasterRequest& request, const TakeRows& take) const override {
    if (device_.draw_rows == nullptr) return take(device_.draw(file_, request, kept_));
    device_.draw_rows(file_, request, kept_, take);
  }
  void write_vectors(const PictureFormat& format, const std::filesystem::path& file,
                     const RasterRequest& request) const override {
    format.write_vectors(file_, request.width, request.height, by_depth_, file, request.background);
  }

 private:
  const DisplayFile& file_;
  bool by_depth_;
  const RasterDevice& device_;
  SoftwareRenderer& kept_;
};

/// Without a display file, but for a device that needs one.
class ViewSource : public Source {
  template <class Do>
  auto of_display_file(Do&& work) const {
    const DisplayFile file = viewer_.display_file(view_, lights_turned_);
    return work(DisplayFileSource(file, true, options_, kept_));
  }

 public:
  ViewSource(SceneViewer& viewer, const View& view, const glm::dmat3& lights_turned,
             const DrawOptions& options, SoftwareRenderer& kept)
      : viewer_(viewer),
        view_(view),
        lights_turned_(lights_turned),
        options_(options),
        kept_(kept) {}

  Picture draw(const RasterRequest& request) const override {
    if (!is_first_device())
      return of_display_file([&](const Source& s) { return s.draw(request); });
    kept_.draw(scene(request), request);
    return kept_.take_picture();
  }
  void draw(const RasterRequest& request, const TakeRows& take) const override {
    if (!is_first_device()) return of_display_file([&](const Source& s) { s.draw(request, take); });
    kept_.draw(scene(request), request, take);
  }
  void write_vectors(const PictureFormat& format, const std::filesystem::path& file,
                     const RasterRequest& request) const override {
    of_display_file([&](const Source& s) { s.write_vectors(format, file, request); });
  }

 private:
  bool is_first_device() const { return &device_of(options_.device) == kDevices.data(); }
  const ViewedScene& scene(const RasterRequest& request) const {
    return viewer_.view(
        {view_, lights_turned_, PictureSize{request.width, request.height}, request.threads});
  }
  SceneViewer& viewer_;
  const View& view_;
  const glm::dmat3& lights_turned_;
  const DrawOptions& options_;
  SoftwareRenderer& kept_;
};

/// A pixel's samples in place of the pixel: colours only.
RasterRequest request_of_samples(RasterRequest request, int samples) {
  request.width *= samples;
  request.height *= samples;
  request.line_scale *= samples;
  request.ids = request.depth = false;
  return request;
}

/// The colours of a picture, antialiased.
void draw_colours(const Source& source, const RasterRequest& request, const DrawOptions& options,
                  const TakeRows& take) {
  const int n = options.samples;
  source.draw(request_of_samples(request, n), SampleAverage(request.width, n, take));
}

/// Checks numbers that are the same for a file and in memory; throws Error.
void require_numbers(const DrawOptions& options) {
  if (options.threads < 1) {
    throw Error(fmt::format("{} threads: expected 1 or more", options.threads));
  }
  if (options.samples < 1 || options.samples > kMostSamples) {
    throw Error(fmt::format("{} samples along a pixel's side: expected 1 to {}", options.samples,
                            kMostSamples));
  }
  require_picture_size(options.width, options.height);
  const int most = kLargestSide / options.samples;
  if (options.width <= most && options.height <= most) return;
  throw Error(
      fmt::format("picture size {}x{} with {} x {} samples a pixel: expected 1x1 to {}x{} pixels",
                  options.width, options.height, options.samples, options.samples, most, most));
}

/// Checks what is asked of a picture in memory; throws Error.
void require_drawable_in_memory(const DrawOptions& options) {
  require_numbers(options);
  device_of(options.device);
  if (!options.format.empty()) format_named(options.format);
}

/// What `draw` returns: a picture in memory, for which there must be room before any work is done.
template <class Draw>
Picture with_memory_of_picture(const DrawOptions& options, const SoftwareRenderer& kept,
                               Draw&& draw) {
  require_drawable_in_memory(options);
  const auto pixels =
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  const std::size_t of_pixel = sizeof(Picture::pixels[0]) +
                               (options.with_ids ? sizeof(Picture::ids[0]) : 0) +
                               (options.with_depth ? sizeof(Picture::depth[0]) : 0);
  return with_memory(
      pixels * of_pixel,
      [&] { return fmt::format("a picture of {} x {} pixels", options.width, options.height); },
      draw, kept.bytes_of_picture());
}

/// Draws into a file: by rows, but for a device that has the whole picture in memory, with a depth
/// for each of its pixels. What a method makes of a scene of so many bytes is no smaller than it
/// is.
template <class Draw>
void with_memory_of_drawing(std::size_t bytes_of_scene, const std::filesystem::path& file,
                            const DrawOptions& options, Draw&& draw) {
  constexpr std::size_t kBytesOfPixel = 8;
  const bool by_rows = device_of(options.device).draw_rows != nullptr;
  const auto pixels =
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  const auto samples = static_cast<std::size_t>(options.samples * options.samples);
  with_memory(
      bytes_of_scene + (by_rows ? 0 : kBytesOfPixel * pixels * samples),
      [&] { return fmt::format("{} of {} x {}", file.string(), options.width, options.height); },
      draw);
}

/// Draws in memory; what is not a colour is not antialiased.
Picture draw_pixels(const Source& source, const RasterRequest& request,
                    const DrawOptions& options) {
  if (options.samples == 1) return source.draw(request);
  Picture picture;
  if (request.ids || request.depth) picture = source.draw(request);
  picture.width = request.width;
  picture.height = request.height;
  picture.pixels.clear();
  draw_colours(source, request, options, [&](const Picture& rows) {
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

void write_picture(const Source& source, const RasterRequest& request,
                   const std::filesystem::path& file, const DrawOptions& options) {
  const auto open = [&](auto* row_file, const std::filesystem::path& path) {
    return row_file(path, options.width, options.height);
  };
  const PictureFormat& format = format_of(file, options);
  RowFiles files, colours;
  if (!options.ids.empty()) files.push_back(open(ids_row_file, options.ids));
  if (!options.depth.empty()) files.push_back(open(depth_row_file, options.depth));
  if (format.pixel_file != nullptr) {
    (options.samples == 1 ? files : colours)
        .push_back(open(has_background(options) ? format.pixel_file : format.alpha_file, file));
  }
  RasterRequest of_files = request;
  of_files.texts = format.pixel_file != nullptr;
  if (!files.empty()) source.draw(of_files, write_rows(files));
  if (!colours.empty()) draw_colours(source, request, options, write_rows(colours));
  if (format.write_vectors != nullptr) source.write_vectors(format, file, request);
  for (const auto* written : {&files, &colours}) {
    for (const auto& pixel_file : *written) pixel_file->commit();
  }
}

DrawOptions with_precision(const GraphicsSystem& system, DrawOptions options) {
  options.precision = precision_in_force(system, hidden_surface_options(options));
  return options;
}

DrawOptions with_background(const GraphicsSystem& system, DrawOptions options) {
  if (!options.background) options.background = system.background();
  return options;
}

}  // namespace

HiddenSurfaceOptions hidden_surface_options(const DrawOptions& options) {
  return {options.hidden, options.scope, options.precision, options.threads};
}

PictureKind picture_kind(const std::filesystem::path& file, const DrawOptions& options) {
  return format_of(file, options).write_vectors != nullptr ? PictureKind::vector
                                                           : PictureKind::raster;
}

HiddenMethod drawing_method(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind) {
  const HiddenMethod method = method_in_force(system, hidden_surface_options(options));
  if (method != HiddenMethod::automatic) return method;
  return choose_method(system.display_file(), kind).method;
}

void require_drawable(const std::filesystem::path& file, const DrawOptions& options) {
  const PictureFormat& format = format_of(file, options);
  require_numbers(options);
  const RasterDevice& device = device_of(options.device);  // the first unless one was asked for
  if (format.write_vectors != nullptr && &device != &kDevices.front()) {
    const auto of_pixels = [](const PictureFormat& f) { return f.pixel_file != nullptr; };
    throw Error(fmt::format("{}: the {} device draws pixels: expected {}", file.string(),
                            device.choice.name, names(kFormats, " or ", of_pixels)));
  }
  if (!has_background(options) && !format.can_be_transparent()) {
    const auto transparent = [](const PictureFormat& f) { return f.can_be_transparent(); };
    throw Error(fmt::format("{}: {} files have no alpha: expected a background, or one of {}",
                            file.string(), format.choice.name, names(kFormats, " ", transparent)));
  }
  require_writable(file, options);
}

namespace {

/// What is kept from one picture to the next.
struct KeptForPictures {
  SortedDisplayFile& sorted;
  SoftwareRenderer& software;
};

/// Gives the display file, brought up to date, and what is asked of it; or the view of a retained
/// scene.
template <class DrawFile, class DrawWorld>
auto draw_up_to_date(const GraphicsSystem& system, const DrawOptions& options, HiddenMethod method,
                     SortedDisplayFile& kept, DrawFile&& draw_file, DrawWorld&& draw_world) {
  const DisplayFile& sorted = kept.update(system, method, hidden_surface_options(options));
  if (const auto world = world_in_force(system, method)) {
    return draw_world(*world, with_precision(system, options));
  }
  return draw_file(sorted, raster_request(system, sorted, options));
}

Picture draw_in_memory(const GraphicsSystem& system, const DrawOptions& as_asked,
                       const KeptForPictures& kept) {
  const DrawOptions options = with_background(system, as_asked);
  return with_memory_of_picture(options, kept.software, [&] {
    return draw_up_to_date(
        system, options, method_in_force(system, hidden_surface_options(options)), kept.sorted,
        [&](const DisplayFile& sorted, const RasterRequest& request) {
          return draw_pixels(DisplayFileSource(sorted, false, options, kept.software), request,
                             options);
        },
        [](const ViewedWorld& world, const DrawOptions& exact) { return draw(world, exact); });
  });
}

void draw_into_file(const GraphicsSystem& system, const std::filesystem::path& file,
                    const DrawOptions& as_asked, const KeptForPictures& kept) {
  const DrawOptions options = with_background(system, as_asked);
  require_drawable(file, options);
  // For a picture of pixels it is the renderer that picks a method.
  const HiddenMethod method = picture_kind(file, options) == PictureKind::raster
                                  ? method_in_force(system, hidden_surface_options(options))
                                  : drawing_method(system, options, PictureKind::vector);
  with_memory_of_drawing(system.display_file().bytes(), file, options, [&] {
    draw_up_to_date(
        system, options, method, kept.sorted,
        [&](const DisplayFile& sorted, const RasterRequest& request) {
          const DisplayFileSource source(sorted, is_image_space(method), options, kept.software);
          write_picture(source, request, file, options);
        },
        [&](const ViewedWorld& world, const DrawOptions& exact) { draw(world, file, exact); });
  });
}

}  // namespace

Picture draw(const GraphicsSystem& system, const DrawOptions& options, SortedDisplayFile& kept) {
  SoftwareRenderer software;
  return draw_in_memory(system, options, {kept, software});
}

Picture draw(const GraphicsSystem& system, const DrawOptions& options) {
  SortedDisplayFile kept;
  return draw(system, options, kept);
}

void draw(const GraphicsSystem& system, const std::filesystem::path& file,
          const DrawOptions& options, SortedDisplayFile& kept) {
  SoftwareRenderer software;
  draw_into_file(system, file, options, {kept, software});
}

void draw(const DisplayFile& display_file, const std::filesystem::path& file,
          const DrawOptions& options) {
  require_drawable(file, options);
  SoftwareRenderer software;
  write_picture(DisplayFileSource(display_file, false, options, software),
                raster_request(display_file, options), file, options);
}

void draw(const ViewedWorld& world, const std::filesystem::path& file, const DrawOptions& options) {
  require_drawable(file, options);
  SoftwareRenderer software;
  write_picture(DisplayFileSource(world.display_file, true, options, software),
                raster_request(world, options), file, options);
}

Picture draw(const ViewedWorld& world, const DrawOptions& options) {
  SoftwareRenderer software;
  return with_memory_of_picture(options, software, [&] {
    return draw_pixels(DisplayFileSource(world.display_file, true, options, software),
                       raster_request(world, options), options);
  });
}

void draw(const GraphicsSystem& system, const std::filesystem::path& file,
          const DrawOptions& options) {
  SortedDisplayFile kept;
  draw(system, file, options, kept);
}

// ---- What is kept ------------------------------------------------------------------------

struct Renderer::Kept {
  SortedDisplayFile sorted;
  SoftwareRenderer software;
  Picture picture;  ///< where the software renderer has not the whole of it
  std::optional<Picker> picker;
};

Renderer::Renderer() : kept_(std::make_unique<Kept>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&& other) noexcept = default;
Renderer& Renderer::operator=(Renderer&& other) noexcept = default;

const Picture& Renderer::draw(const GraphicsSystem& system, const DrawOptions& options) {
  require_drawable_in_memory(options);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));  // none, if drawing fails
  kept.picture = draw_in_memory(system, options, {kept.sorted, kept.software});
  return kept.picture;
}

void Renderer::draw(const GraphicsSystem& system, const std::filesystem::path& file,
                    const DrawOptions& options) {
  draw_into_file(system, file, options, {kept_->sorted, kept_->software});
}

std::optional<Pick> Renderer::pick(const GraphicsSystem& system, double x, double y,
                                   const DrawOptions& options, double reach) {
  require_drawable_in_memory(options);
  const PictureSize size{options.width, options.height};
  Kept& kept = *kept_;
  std::optional<Picker>& picker = kept.picker;
  const bool same_scene = picker && picker->scene().is_of(system.display_file());
  if (!same_scene || !(picker->size() == size)) {
    picker.reset();
    const std::size_t polygons = system.display_file().polygons();
    with_memory(
        system.display_file().bytes(),
        [&] { return fmt::format("picking among {} polygons", polygons); },
        [&] {
          picker.emplace(kept.software.scene_of(system.display_file()), size, options.threads);
        });
  }
  return picker->pick(x, y, reach);
}

// ---- New views ---------------------------------------------------------------------------

struct ViewRenderer::Kept {
  SceneViewer viewer;
  SoftwareRenderer software;
  Picture picture;
};

ViewRenderer::ViewRenderer(const RetainedScene& scene, const DisplayFile& attributes)
    : kept_(std::make_unique<Kept>(Kept{SceneViewer(scene, attributes), {}, {}})) {}
ViewRenderer::~ViewRenderer() = default;
ViewRenderer::ViewRenderer(ViewRenderer&& other) noexcept = default;
ViewRenderer& ViewRenderer::operator=(ViewRenderer&& other) noexcept = default;

const Picture& ViewRenderer::draw(const View& view, const DrawOptions& options,
                                  const glm::dmat3& lights_turned) {
  const RasterRequest request = raster_request_of_view(options);
  device_of(options.device);
  Kept& kept = *kept_;
  kept.software.give_back(std::exchange(kept.picture, Picture()));
  kept.picture = with_memory_of_picture(options, kept.software, [&] {
    return draw_pixels(ViewSource(kept.viewer, view, lights_turned, options, kept.software),
                       request, options);
  });
  return kept.picture;
}

void ViewRenderer::draw(const View& view, const std::filesystem::path& file,
                        const DrawOptions& options, const glm::dmat3& lights_turned) {
  const RasterRequest request = raster_request_of_view(options);
  require_drawable(file, options);
  const SceneViewer& viewer = kept_->viewer;
  with_memory_of_drawing(viewer.bytes(), file, options, [&] {
    write_picture(ViewSource(kept_->viewer, view, lights_turned, options, kept_->software), request,
                  file, options);
  });
}

DisplayFile ViewRenderer::display_file(const View& view, const glm::dmat3& lights_turned) const {
  return kept_->viewer.display_file(view, lights_turned);
}

std::span<const Choice> picture_formats() { return kFormatChoices; }
std::span<const Choice> raster_devices() { return kDeviceChoices; }
void require_raster_device(std::string_view name) { device_of(name); }

}  // namespace displayfile
