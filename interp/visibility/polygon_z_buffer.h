#pragma once

#include "interp/visibility/image_space.h"

namespace displayfile {

/// The z-buffer in its simplest exact form: the fills are scan-converted one after another into
/// a depth and a fill for each pixel (interp/visibility/z_buffer.md). With a ROUNDOFF depths are
/// compared as the textbook's SIGNOF does. 8 bytes a pixel, 16 with a ROUNDOFF.
class PolygonZBuffer : public ImageSpaceMethod {
 public:
  void prepare(const Request& request, int threads) override;
  void draw_rows(int row_begin, int row_end, const SeenRun& seen) const override;
  /// Every polygon is looked at for each call.
  int rows_at_a_time() const override { return 64; }

 private:
  template <class Depth>
  void draw(int row_begin, int row_end, const SeenRun& seen) const;

  std::optional<Request> request_;
};

}  // namespace displayfile
