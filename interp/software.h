#pragma once

#include <utility>
#include <vector>

#include "displayfile/display_file.h"
#include "interp/interpreter.h"
#include "interp/picture.h"
#include "interp/z_buffer.h"

namespace displayfile {

/// What the z-buffer stores for the pixels: of one kind, the other is empty.
struct SoftwareCells {
  std::vector<ZBuffer::Cell<float>> exact;
  std::vector<ZBuffer::Cell<double>> roundoff;
  bool clear = true;  ///< all show the background, as they do between pictures

  /// Makes them as many, all clear.
  void make_clear(std::size_t exact_cells, std::size_t roundoff_cells);
};

/// Draws display files by our own scan conversion, on a white background. With the z-buffer
/// the nearest fill is seen, of equally near ones the one entered later, and a line where no
/// fill is nearer; without it, whatever is drawn last. Coverage and, unless roundoff is asked
/// for, nearness are decided exactly. The picture is the same for any number of threads.
class SoftwareRenderer {
 public:
  /// The picture stays until the next call; its memory is used again. Throws Error for a size
  /// outside of 1 to kLargestSide.
  const Picture& draw(const DisplayFile& display_file, const RasterRequest& request);
  Picture take_picture() { return std::move(picture_); }

 private:
  void interpret_in_bands(const DisplayFile& display_file, const RasterRequest& request, Pass pass);

  Picture picture_;
  SoftwareCells cells_;
};

/// One picture by a renderer of its own.
Picture draw_with_software(const DisplayFile& display_file, const RasterRequest& request);

/// A colour as a pixel: each component rounded to the nearest of 0 to 255.
std::uint32_t pixel_of(const Colour& colour);

}  // namespace displayfile
