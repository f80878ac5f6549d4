#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "clip/base/collected_text.h"
#include "displayfile/files.h"
#include "displayfile/segments/display_file.h"
#include "interp/device/picture.h"
#include "interp/vector/vector_device.h"

struct _cairo;
struct _cairo_surface;

namespace displayfile {

/// The page format that Cairo writes.
enum class PageFormat { pdf, eps };

/// Draws a PDF page, or an EPS picture, through Cairo, one point per pixel, on a background if
/// there is one. The bytes depend only on the drawing (and on Cairo's version; for texts on its
/// fonts). Cairo rounds coordinates to 1/256 point. Where lines were selected, each kind is a layer
/// with its name; lines of several kinds are in that of the first (clip/surfaces.h). If
/// VectorOptions::layers is set, each segment is a layer, with its title or number, and each kind
/// of its lines another. EPS has no layers.
class PdfDevice : public VectorDevice {
 public:
  /// The stream must outlive finish(). Throws Error unless both sides are 1 to kLargestSide, or if
  /// Cairo cannot make the surface. (Readers may show less: the PDF specification advises pages of
  /// at most 14,400 points.) With paper in the options: a page of its size, with the picture in its
  /// place and clipped to its frame.
  PdfDevice(std::ostream& out, int width, int height, const Background& background = {},
            const VectorOptions& options = {}, PageFormat format = PageFormat::pdf);
  ~PdfDevice() override;

  /// Completes the document. Must be called once. Throws Error if Cairo failed.
  void finish();

 private:
  void open_group(int segment_name) override { segment_ = segment_name; }
  void close_group() override { segment_ = 0; }
  void paint_fill(const Path& path, const FillPaint& paint, bool seam) override;
  void paint_figure(const Figure& figure) override;
  void paint_lines(const Path& path, const LineStyle& style, LineKinds kinds, LineCap cap) override;
  void paint_text(const DeviceText& text, const Point2& anchor, double size) override;

  void begin_layer(std::string_view name);  ///< for later drawing; empty: none
  /// Begins the layer of a segment, or of one kind of its lines.
  void begin_layer(int segment, std::string_view kind);
  void set_colour(const Colour& colour);
  void set_path(const Path& path);

  struct Destroy {
    void operator()(_cairo* context) const;
    void operator()(_cairo_surface* surface) const;
  };
  std::ostream& out_;
  PageFormat format_;
  CollectedText document_;           // until its layers are known
  std::vector<std::string> layers_;  // of the parts of the content that are in one, in order
  std::string layer_;                // in force
  int segment_ = 0;                  // that is open; 0: none
  std::unique_ptr<_cairo_surface, Destroy> surface_;
  std::unique_ptr<_cairo, Destroy> context_;
};

/// Draws the visible segments, in order, into a PDF file of one page, width x height points. The
/// file appears whole or not at all. Throws Error, naming the file, if it cannot be written, or for
/// a size outside of 1 to kLargestSide. With paper, the picture is as large as fits, on a page of
/// its size.
void write_pdf(const DisplayFile& display_file, int width, int height, const Destination& to,
               const Background& background = {}, bool colour_rule = false,
               const VectorOptions& options = {});

/// The same for an EPS file, a picture of that size (PostScript, level 3).
void write_eps(const DisplayFile& display_file, int width, int height, const Destination& to,
               const Background& background = {}, bool colour_rule = false,
               const VectorOptions& options = {});

}  // namespace displayfile
