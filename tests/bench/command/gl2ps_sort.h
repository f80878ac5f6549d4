#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "clip/point.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile::bench {

/// gl2ps's BSP sort (Geuzaine, gl2ps 1.4), in this process. It gets triangles as they come out of
/// an OpenGL feedback buffer, in window coordinates, in pixels, and in single precision; no OpenGL
/// is involved. Its state is global: one page at a time.
struct Gl2psSort {
  std::span<const Point3> corners;  ///< three a triangle, in normalised device coordinates
  PictureSize window;
  /// Its options, none of which is best in all: with the second there are fewer cuts, with the
  /// third fewer pieces are written, for which it takes longer.
  struct Options {
    std::string_view name;        ///< after that of the sort
    bool best_root = true;        ///< GL2PS_BEST_ROOT: of some candidates the root that cuts least
    bool occlusion_cull = false;  ///< GL2PS_OCCLUSION_CULL: wholly hidden triangles are left out
  };
  static constexpr std::array<Options, 3> kOptions{
      {{"", false, false}, {", best root", true, false}, {", best root, culled", true, true}}};
  Options options = kOptions[1];

  /// gl2ps's version; nothing if this build has no gl2ps.
  static std::optional<std::string> version();

  /// Hands the triangles over and sorts them, in a format that writes no polygons (GL2PS_TEX):
  /// depth is rescaled, the tree built, traversed and freed. Returns the processor's
  /// seconds without the handing over, those of gl2psEndPage.
  double sort() const;

  /// False if it does not come to an end within a limit of the processor's time that grows with the
  /// triangles: some scenes it cuts for ever. Tried in a process of its own.
  bool ends() const;

  /// A part of a triangle.
  struct Piece {
    std::uint32_t triangle;       ///< counted from 0
    std::vector<Point2> corners;  ///< in normalised device coordinates
  };
  /// The pieces that it writes, back to front, read back from PGF, its format with the most digits:
  /// six after the point, of pixels. PGF ignores GL2PS_OCCLUSION_CULL: the pieces that it leaves
  /// out are read from PostScript. Throws Error for more than 2^24 triangles, whose numbers are
  /// encoded as colours.
  std::vector<Piece> pieces() const;

 private:
  void leave_out_hidden(std::vector<Piece>& pieces) const;
};

}  // namespace displayfile::bench
