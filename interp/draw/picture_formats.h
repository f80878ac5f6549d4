#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "displayfile/files.h"
#include "displayfile/looks/background.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/files/row_file.h"
#include "interp/raster/software.h"
#include "interp/vector/pens/pen_drawing.h"

/// The tables of what a picture can be written as and by what its pixels can be drawn. A new format
/// or device is a line here and a file of its own.
namespace displayfile {

/// One line a format: how it is written, from pixels, with alpha where there is no background, or
/// from the display file itself.
struct PictureFormat {
  Choice choice;
  std::unique_ptr<RowFile> (*pixel_file)(const Destination&, int width, int height);
  std::unique_ptr<RowFile> (*alpha_file)(const Destination&, int width, int height);
  void (*write_vectors)(const DisplayFile&, int width, int height, const Destination&,
                        const Background&, bool colour_rule, const VectorOptions&);
  void (*write_pens)(const PenDrawing&, const Destination&) = nullptr;

  bool is_of_pixels() const { return pixel_file != nullptr; }
  bool is_for_paper() const { return write_pens != nullptr; }  ///< with pens and without
  bool can_be_transparent() const { return alpha_file != nullptr || write_vectors != nullptr; }
};

/// The format of an extension as it was given, in letters of either case, with its dot or without.
/// Throws Error if there is none, with `whose` before the message.
const PictureFormat& format_named(const std::string& extension, const std::string& whose = "");
/// That of the options, or else of the file's name. Throws Error if there is none.
const PictureFormat& format_of(const Destination& to, const DrawOptions& options);
/// The names of those formats that are so, with something between.
std::string names_of_formats(bool (PictureFormat::*which)() const, const char* between);

/// One line a device that draws pixels, the whole picture or, row by row, however large it is. One
/// that has the whole picture in memory anyway leaves out the latter. `kept` is the first device's.
struct RasterDevice {
  Choice choice;
  Picture (*draw)(const DisplayFile&, const RasterRequest&, SoftwareRenderer& kept);
  void (*draw_rows)(const DisplayFile&, const RasterRequest&, SoftwareRenderer& kept,
                    const TakeRows&);
};

/// Throws Error if there is none of that name.
const RasterDevice& device_of(std::string_view name);
/// The one that draws unless another was asked for: our own.
const RasterDevice& first_device();

}  // namespace displayfile
