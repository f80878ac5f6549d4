#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/display_file.h"
#include "displayfile/intensity_plane.h"
#include "hidden/exact/plane.h"
#include "interp/visibility/fill_sources.h"

namespace displayfile {

/// The solid fills of a display file's visible segments as the image-space methods look at them:
/// device coordinates after the image transformation, in order of entry, those left out that are
/// edge-on and so cover nothing. Fill 0 stands for the background; the others count from 1, so
/// that of two fills the one entered later has the larger number.
class FillScene {
 public:
  using Fill = std::uint32_t;
  static constexpr Fill kBackground = 0;

  FillScene();
  /// Of coordinates up to kCoordinateLimit.
  explicit FillScene(const DisplayFile& display_file);

  /// One more than the last fill.
  Fill end() const { return static_cast<Fill>(begin_.size() - 1); }
  std::span<const Point3> vertices(Fill fill) const {
    return std::span(vertices_).subspan(begin_[fill], begin_[fill + 1] - begin_[fill]);
  }
  /// The place of its first vertex among those of all fills.
  std::uint32_t first_vertex(Fill fill) const { return begin_[fill]; }
  std::size_t all_vertices() const { return vertices_.size(); }
  double largest_depth() const { return largest_depth_; }  ///< of the vertices' |z|
  /// Through the support vertices (the design's section 4), which are not in line.
  Plane plane(Fill fill) const {
    const auto& s = support_[fill];
    return {vertices_[s[0]], vertices_[s[1]], vertices_[s[2]]};
  }
  std::uint32_t colour(Fill fill) const { return colour_[fill]; }  ///< as in Picture::pixels
  /// A fill whose colour is not the same everywhere, but multiplied by an intensity.
  struct Shade {
    Colour colour;
    IntensityPlane intensity;
  };
  bool has_shades() const { return !shades_.empty(); }
  /// Null if it is flat.
  const Shade* shade(Fill fill) const {
    return fill >= shade_.size() || shade_[fill] == kNone ? nullptr : &shades_[shade_[fill]];
  }
  bool has_shadows() const { return !shadows_.empty(); }  ///< some fill shows them
  /// Null if none is seen on it.
  const FillShadow* shadow(Fill fill) const {
    return fill >= shadow_.size() || shadow_[fill] == kNone ? nullptr : &shadows_[shadow_[fill]];
  }
  std::int32_t pick(Fill fill) const { return pick_[fill]; }  ///< -1: the background

  bool has_lines() const { return has_lines_; }  ///< or polygons with visible edges

  /// True while the display file's visible segments are as they were.
  bool is_of(const DisplayFile& display_file) const { return sources_.are_of(display_file); }

 private:
  struct Collector;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  /// False if it is edge-on and left out.
  bool enter(std::span<const Point3> vertices, std::uint32_t colour, std::int32_t pick);
  void shade_last(const Shade& shade);
  void shadow_last(const FillShadow& shadow);

  std::vector<Point3> vertices_;
  std::vector<std::uint32_t> begin_;  // of each fill's vertices, and the end
  std::vector<std::array<std::uint32_t, 3>> support_;
  std::vector<std::uint32_t> colour_;
  std::vector<std::int32_t> pick_;
  std::vector<std::uint32_t> shade_;  // of the fills up to the last that has one: in shades_
  std::vector<Shade> shades_;
  std::vector<std::uint32_t> shadow_;  // likewise, in shadows_
  std::vector<FillShadow> shadows_;
  FillSources sources_;
  bool has_lines_ = false;
  double largest_depth_ = 0.0;
};

}  // namespace displayfile
