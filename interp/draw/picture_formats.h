#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "displayfile/files.h"
#include "displayfile/looks/style.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/files/png_file.h"
#include "interp/files/row_file.h"
#include "interp/raster/software.h"
#include "interp/vector/pens/pen_drawing.h"

/// The tables of picture formats and raster devices. A new format or device is one line here and
/// one file.
namespace displayfile {

/// One line per format: how it is written from pixels, or from the display file itself.
struct PictureFormat {
  using Density = std::optional<double>;  ///< pixels per inch
  /// Capabilities beyond the drawing itself.
  struct Extras {
    bool density = false, alpha = false, ids = false, layers = false;
    bool points = false;             ///< without paper a pixel is a point: 1/72 inch
    bool (*pen_layers)() = nullptr;  ///< true where drawings for pens have layers in an order
  };
  Choice choice;
  std::unique_ptr<RowFile> (*pixel_file)(const Destination&, int width, int height, Alpha, Density);
  /// Null for pixels, and for formats of pens alone.
  void (*write_vectors)(const DisplayFile&, int width, int height, const Destination&,
                        const Background&, bool colour_rule, const VectorOptions&);
  void (*write_pens)(const PenDrawing&, const Destination&, const VectorOptions&) = nullptr;
  Extras extras = {};

  bool is_of_pixels() const { return pixel_file != nullptr; }
  bool is_for_paper() const { return pixel_file == nullptr; }
  bool is_for_areas() const { return pixel_file != nullptr || write_vectors != nullptr; }
  bool is_for_pens() const { return write_pens != nullptr; }
  bool has_points() const { return extras.points; }
  bool has_density() const { return extras.density; }
  bool has_ids() const { return extras.ids; }
  bool has_layers() const { return extras.layers; }
  bool has_pen_layers() const { return extras.pen_layers && extras.pen_layers(); }
  bool can_be_transparent() const { return extras.alpha || pixel_file == nullptr; }
};

/// The format for an extension, in either case, with or without its dot. Throws Error if there is
/// none, with `whose` before the message.
const PictureFormat& format_named(const std::string& extension, const std::string& whose = "");
/// The format of the options, or else of the file's name. Throws Error if there is none.
const PictureFormat& format_of(const Destination& to, const DrawOptions& options);
/// The names of the formats for which `which` is true, separated by `between`.
std::string names_of_formats(bool (PictureFormat::*which)() const, const char* between);

/// One line per raster device: it draws the whole picture or, if possible, row by row, for pictures
/// of any size. `kept` is the first device's.
struct RasterDevice {
  Choice choice;
  Picture (*draw)(const DisplayFile&, const RasterRequest&, SoftwareRenderer& kept);
  void (*draw_rows)(const DisplayFile&, const RasterRequest&, SoftwareRenderer& kept,
                    const TakeRows&);
};

/// Throws Error if there is none of that name.
const RasterDevice& device_of(std::string_view name);
/// The default device: the built-in one.
const RasterDevice& first_device();

}  // namespace displayfile
