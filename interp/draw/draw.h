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

/// What a picture does not show that its user may have expected.
struct DrawWarning {
  enum class Kind {
    nothing_seen,  ///< there is nothing but the background, and why
    hidden_lines,  ///< those that the application set to be drawn dashed: nothing finds them
    stretched,     ///< the picture has another shape than what was viewed for it
    no_effect,     ///< an option of the call that has no effect on this picture
  };
  Kind kind;
  std::string text;  ///< a sentence, such as "nothing is seen: the only polygon or line is ..."
};
using Warn = std::function<void(const DrawWarning& warning)>;

/// How a display file becomes a picture.
struct DrawOptions {
  /// Pixels; of a PDF, points. For a picture that is not square, set_aspect_ratio before the first
  /// segment keeps windows from being stretched.
  int width = 512, height = 512;
  /// Only these rows of a picture of pixels, the same as they are in the whole of it, as a picture
  /// of so many. Machines may share a picture so.
  std::optional<PictureRows> rows = std::nullopt;
  /// How hidden surfaces are found, by how many threads, and within which limits.
  HiddenSurfaceOptions surfaces = {};
  /// The extension of one of picture_formats(), with its dot or without, in place of the file's
  /// own; if there is neither, it is .png for "-", standard output, or .ppm in a build without
  /// libpng, and an error for a stream.
  std::string format = {};
  std::string device = "software";  ///< of raster pictures: one of raster_devices()
  std::optional<Background> background = std::nullopt;  ///< in place of the application's
  /// Antialiasing: the mean of samples x samples for each pixel, 1 to kMostSamples; vectors, ids
  /// and depth are not affected. If it is not set, kUsualSamples, or the most that a picture of
  /// this size may have; 1 by a device that has no rows, such as OSMesa, and by the plain z-buffer,
  /// which both hold all samples of a picture in memory.
  std::optional<int> samples = std::nullopt;
  /// Pieces of lines are drawn that are shorter than they are wide, and join no other
  /// (hidden/lines/strokes_once.md).
  bool crumbs = false;
  /// Vectors for pens: on A4 unless another paper is set. The method of `surfaces` must then be a
  /// method that leaves out what is hidden, or hides nothing (draws_for_pens); `automatic` is
  /// franklin, or where fills are hatched the map.
  std::optional<Pens> pens = std::nullopt;
  std::string ids = {};    ///< item buffer as int32 .npy, if not empty
  std::string depth = {};  ///< depth of the fills seen as float64 .npy, if not empty
  bool with_ids = false, with_depth = false;  ///< a picture in memory has them: Picture's members
  VectorOptions vectors = {};                 ///< of vectors
  /// Called, if not empty, once the picture is drawn, or where it is stretched or an option has no
  /// effect before anything is drawn, in the thread that draws. Nothing is written or looked for
  /// otherwise. The reason why nothing is seen is closer where the scene is retained.
  Warn warn = {};

  /// How many rows of the picture are drawn: all, or those that are asked for.
  int drawn_rows() const { return rows ? rows->end - rows->first : height; }
};

/// The kind of picture that is drawn into that file. Error: an unknown extension.
PictureKind picture_kind(const Destination& to, const DrawOptions& options = {});

/// The method that draws the picture: that of the options, or else what the application set
/// with set_hidden_line_removal, set_hidden_method and set_z_buffer; where it set nothing, and not
/// all points have one depth, `automatic`. Never `automatic` itself, for which choose_method()
/// picks one (interp/visibility/auto_method.h).
HiddenMethod drawing_method(const GraphicsSystem& system, const DrawOptions& options,
                            PictureKind kind = PictureKind::raster);

/// Throws the Errors that draw would throw before it draws anything: an option out of its range, an
/// unknown extension, a size that a device cannot draw, a file that cannot be written.
void require_drawable(const Destination& to, const DrawOptions& options);
/// The same but for whether the file can be written: for who has another machine write it.
void require_format(const Destination& to, const DrawOptions& options);
/// The same of a system's picture in memory.
void require_drawable(const GraphicsSystem& system, const DrawOptions& options);

/// Draws the visible segments into a picture in memory. `kept` is what earlier calls sorted, used
/// again and brought up to date (displayfile/segments/sorted_display_file.h).
Picture draw(const GraphicsSystem& system, const DrawOptions& options, SortedDisplayFile& kept);
Picture draw(const GraphicsSystem& system, const DrawOptions& options = {});

/// Draws the visible segments into a file, or "-", standard output, or a stream. The file's
/// extension says the format if the options do not, which they must for a stream. It appears whole
/// or not at all. Throws Error for an unknown extension, a size that a device cannot draw, or a
/// file or stream that cannot be written; and as in memory for hidden lines by the colour rule or
/// on the OSMesa device, unless fills are put in order, and where the options ask for hidden lines,
/// there are some, and the method, such as `none`, draws in order of entry.
void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options,
          SortedDisplayFile& kept);
void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options = {});

/// The bytes of the file that draw would write with that extension, with its dot or without.
std::string draw_as(const GraphicsSystem& system, std::string_view format,
                    const DrawOptions& options = {});

/// Draws a display file that is ready: the visible segments in the order that it has. Of the
/// options that say how hidden surfaces are found, the colour rule has a meaning alone: Error for
/// a method, scope, precision or hidden lines other than those of the order. Otherwise it does what
/// drawing a system into a file does.
void draw(const DisplayFile& display_file, const Destination& to, const DrawOptions& options);
Picture draw(const DisplayFile& display_file, const DrawOptions& options = {});

/// Draws the visible segments, as vectors, on a device of the application's own
/// (interp/device/README.md): in the order of drawing, with the hidden surfaces found that the
/// options, or else the application, have set; of the options those count alone. Throws Error as
/// drawn_pieces does, and all that the device throws.
void draw(const GraphicsSystem& system, OutputDevice& device, const DrawOptions& options = {});

/// The pieces that a drawing of the system in vectors consists of, as arrays: with the hidden
/// surfaces found that the options, or else the application, have set. Throws Error as draw does,
/// and where hidden lines are set and the method finds none. `kept` is as in draw.
DrawnPieces drawn_pieces(const GraphicsSystem& system, const DrawOptions& options = {});
DrawnPieces drawn_pieces(const GraphicsSystem& system, const DrawOptions& options,
                         SortedDisplayFile& kept);

/// What a picture can be drawn as, or what can draw it: a name, and a few words about it.
struct Choice {
  std::string_view name;
  std::string_view what;
};
std::span<const Choice> picture_formats();  ///< by their extensions, with the dot
std::span<const Choice> raster_devices();

/// Throws Error, naming those that there are, for any other.
void require_raster_device(std::string_view name);

}  // namespace displayfile
