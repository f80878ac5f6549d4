#include "interp/draw/picture_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/nearest_word.h"
#include "interp/device/raster_request.h"
#include "interp/files/ppm_file.h"
#include "interp/opengl/osmesa.h"
#include "interp/vector/pdf_device.h"
#include "interp/vector/pdf_layers.h"
#include "interp/vector/pens/pen_files.h"
#include "interp/vector/svg_device.h"

namespace displayfile {

namespace {

constexpr std::array kFormats{
    PictureFormat{{".png", "pixels, compressed"},
                  png_row_file_at,
                  nullptr,
                  nullptr,
                  {.density = true, .alpha = true}},
    PictureFormat{{".ppm", "pixels, plain"},
                  [](const Destination& to, int width, int height, Alpha, PictureFormat::Density) {
                    return ppm_row_file(to, width, height);
                  },
                  nullptr},
    PictureFormat{{".svg", "vectors for the web"},
                  nullptr,
                  write_svg,
                  write_pens_svg,
                  {.ids = true, .layers = true, .pen_layers = [] { return true; }}},
    PictureFormat{{".pdf", "vectors for print"},
                  nullptr,
                  write_pdf,
                  write_pens_pdf,
                  {.layers = true, .points = true, .pen_layers = has_pdf_layers}},
    PictureFormat{
        {".eps", "vectors to embed in documents"}, nullptr, write_eps, nullptr, {.points = true}},
    PictureFormat{{".dxf", "lines for plotters and laser cutters"},
                  nullptr,
                  nullptr,
                  write_pens_dxf,
                  {.pen_layers = [] { return true; }}},
};

/// The requested rows of a picture from a device that draws whole pictures only.
Picture rows_of(Picture picture, const RasterRequest& request) {
  if (!request.rows) return picture;
  const auto width = static_cast<std::size_t>(picture.width);
  const auto keep = [&](auto& values) {
    if (values.empty()) return;
    const auto row = [&](int n) {
      return values.begin() + static_cast<std::ptrdiff_t>(width * static_cast<std::size_t>(n));
    };
    values.erase(row(request.rows->end), values.end());
    values.erase(values.begin(), row(request.rows->first));
  };
  keep(picture.pixels);
  keep(picture.ids);
  keep(picture.depth);
  picture.height = request.rows->end - request.rows->first;
  return picture;
}

constexpr std::array kDevices{
    RasterDevice{{"software", "built-in scan conversion"},
                 [](const DisplayFile& d, const RasterRequest& r, SoftwareRenderer& kept) {
                   kept.draw(d, r);
                   return kept.take_picture();
                 },
                 [](const DisplayFile& d, const RasterRequest& r, SoftwareRenderer& kept,
                    const TakeRows& take) { kept.draw(d, r, take); }},
    RasterDevice{{"osmesa", "OpenGL, for comparison"},
                 [](const DisplayFile& d, const RasterRequest& r, SoftwareRenderer&) {
                   return rows_of(draw_with_osmesa(d, r), r);
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

/// The names of a table's rows for which `which` is true, separated by `between`.
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

}  // namespace

const PictureFormat& format_named(const std::string& extension, const std::string& whose) {
  const std::string name = extension_of((extension.starts_with('.') ? "x" : "x.") + extension);
  for (const PictureFormat& format : kFormats) {
    if (format.choice.name == name) return format;
  }
  throw Error(fmt::format("{}unknown picture format '{}':{} expected one of {}", whose, extension,
                          meant_by(kFormats, name), names(kFormats, " ", kAny)));
}

const PictureFormat& format_of(const Destination& to, const DrawOptions& options) {
  if (!options.format.empty()) return format_named(options.format);
  if (to.name() == "-") return format_named(kHasPng ? ".png" : ".ppm");
  return format_named(to.extension(), to.name() + ": ");
}

const RasterDevice& device_of(std::string_view name) {
  for (const RasterDevice& device : kDevices) {
    if (device.choice.name == name) return device;
  }
  throw Error(fmt::format("unknown device '{}':{} expected {}", name, meant_by(kDevices, name),
                          names(kDevices, " or ", kAny)));
}

const RasterDevice& first_device() { return kDevices.front(); }

std::string names_of_formats(bool (PictureFormat::*which)() const, const char* between) {
  return names(kFormats, between, [&](const PictureFormat& f) { return (f.*which)(); });
}

std::span<const Choice> picture_formats() { return kFormatChoices; }
std::span<const Choice> raster_devices() { return kDeviceChoices; }
void require_raster_device(std::string_view name) { device_of(name); }

}  // namespace displayfile
