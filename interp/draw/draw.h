#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "clip/base/work_budget.h"
#include "clip/surfaces.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"
#include "displayfile/looks/style.h"
#include "interp/device/output_device.h"
#include "interp/device/picture.h"

namespace displayfile {

class SortedDisplayFile;

/// A warning about content that a picture does not show as expected.
struct DrawWarning {
  enum class Kind {
    nothing_seen,  ///< only the background is visible; the text says why
    hidden_lines,  ///< set to be drawn dashed, but the method does not find them
    stretched,     ///< the picture's aspect ratio is not that of the view
    no_effect,     ///< an option of the call has no effect on this picture
    annotation,    ///< some has no room, is cut off, or a parts list contradicts itself
  };
  Kind kind;
  std::string text;  ///< a sentence, such as "nothing is seen: the only polygon or line is ..."
};
using Warn = std::function<void(const DrawWarning& warning)>;

/// Options for drawing a picture.
struct DrawOptions {
  /// In pixels; for a PDF, in points. For a picture that is not square, set_aspect_ratio before the
  /// first segment keeps windows from being stretched.
  int width = 512, height = 512;
  /// Draws only these rows of a raster picture, identical to those of the whole picture; the result
  /// has this number of rows. Several machines may share a picture this way.
  std::optional<PictureRows> rows = std::nullopt;
  /// Hidden-surface method, threads and limits.
  HiddenSurfaceOptions surfaces = {};
  /// The extension of one of picture_formats(), with or without its dot, in place of the file's
  /// own. Without either: .png for "-", standard output (.ppm in a build without libpng), and an
  /// error for a stream.
  std::string format = {};
  std::string device = "software";  ///< for raster pictures: one of raster_devices()
  std::optional<Background> background = std::nullopt;  ///< overrides the application's
  /// Antialiasing: each pixel is the mean of samples x samples, 1 to kMostSamples; vectors, ids and
  /// depth are not affected. Default: kUsualSamples, or the most that a picture of this size may
  /// have; 1 for devices without rows, such as OSMesa, and for the plain z-buffer, which hold all
  /// samples of a picture in memory.
  std::optional<int> samples = std::nullopt;
  /// Also draws pieces of lines that are shorter than they are wide and join no other
  /// (hidden/lines/strokes_once.md).
  bool crumbs = false;
  /// Draws vectors for pens, on A4 unless a paper is set. The method in `surfaces` must omit hidden
  /// parts or hide nothing (draws_for_pens); `automatic` is franklin, or the map where fills are
  /// hatched.
  std::optional<Pens> pens = std::nullopt;
  Lettering lettering = {};  ///< of texts; by pens they are drawn if it is of paths
  std::string ids = {};      ///< path of an item buffer as int32 .npy, if not empty
  std::string depth = {};    ///< path of the visible fills' depth as float64 .npy, if not empty
  bool with_ids = false, with_depth = false;  ///< fill these members of a Picture in memory
  /// PNG only: pixels per inch, 1 to 100000. The file states it, and so the picture's size; with a
  /// paper (VectorOptions::paper) the file is that sheet, with the picture in its middle, without
  /// rows, ids or depth.
  std::optional<double> dpi = std::nullopt;
  VectorOptions vectors = {};
  /// Called, if not empty, in the drawing thread: after drawing, or before it for `stretched`,
  /// `no_effect` and `annotation`. Warnings are not computed otherwise. The reason why nothing is
  /// visible is more precise where the scene is retained.
  Warn warn = {};

  /// The number of rows drawn.
  int drawn_rows() const { return rows ? rows->end - rows->first : height; }
};

/// The kind of picture drawn into that destination. Error: an unknown extension.
PictureKind picture_kind(const Destination& to, const DrawOptions& options = {});

/// The method that draws the picture: the options', or the one set by set_hidden_line_removal,
/// set_hidden_method and set_z_buffer; where none is set and not all points have one depth,
/// `automatic`. In place of `automatic` it returns the choice of choose_method()
/// (interp/visibility/auto_method.h).
HiddenMethod drawing_method(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind = PictureKind::raster);

/// Throws the Errors that draw would throw before drawing: an option out of range, an unknown
/// extension, a size that the device cannot draw, a file that cannot be written.
void require_drawable(const Destination& to, const DrawOptions& options);
/// The same, without checking that the file can be written: for files that another machine writes.
void require_format(const Destination& to, const DrawOptions& options);
/// The same for a system's picture in memory.
void require_drawable(const GraphicsSystem& system, const DrawOptions& options);

/// Draws the visible segments into a picture in memory. `kept` caches the sorted display file
/// between calls and is updated (displayfile/segments/sorted_display_file.h).
Picture draw(const GraphicsSystem& system, const DrawOptions& options, SortedDisplayFile& kept);
Picture draw(const GraphicsSystem& system, const DrawOptions& options = {});

/// Draws the visible segments into a file, "-" (standard output), or a stream. The format is the
/// options' or else the file's extension; for a stream the options must set it. The file is written
/// completely or not at all. Throws Error for an unknown extension, a size that the device cannot
/// draw, or a destination that cannot be written; for hidden lines by the colour rule or on the
/// OSMesa device, unless fills are sorted; and where the options set hidden lines, there are lines,
/// and the method, such as `none`, draws in order of entry.
void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options,
          SortedDisplayFile& kept);
void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options = {});

/// The bytes of the file that draw would write in that format, an extension with or without its
/// dot.
std::string draw_as(const GraphicsSystem& system, std::string_view format,
                    const DrawOptions& options = {});

/// Draws the visible segments of a display file in its order. Of the hidden-surface options only
/// the colour rule applies: Error for a method, scope, precision or hidden lines that differ from
/// those of the order. Otherwise as draw of a system.
void draw(const DisplayFile& display_file, const Destination& to, const DrawOptions& options);
Picture draw(const DisplayFile& display_file, const DrawOptions& options = {});

/// Draws the visible segments as vectors on an application's own device (interp/device/README.md):
/// in drawing order, with hidden surfaces removed as the options or else the application have set.
/// Other options are ignored. Throws Error as drawn_pieces does, and whatever the device throws.
void draw(const GraphicsSystem& system, OutputDevice& device, const DrawOptions& options = {});

/// The pieces of a vector drawing of the system, as arrays, with hidden surfaces removed as the
/// options or else the application have set. Throws Error as draw does, and if hidden lines are set
/// and the method finds none. `kept` is as in draw.
DrawnPieces drawn_pieces(const GraphicsSystem& system, const DrawOptions& options = {});
DrawnPieces drawn_pieces(const GraphicsSystem& system, const DrawOptions& options,
                         SortedDisplayFile& kept);

/// A picture format or a device: its name and a short description.
struct Choice {
  std::string_view name;
  std::string_view what;
};
std::span<const Choice> picture_formats();  ///< extensions, with the dot
std::span<const Choice> raster_devices();

/// Throws Error, listing the available devices, for an unknown name.
void require_raster_device(std::string_view name);

}  // namespace displayfile
