#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/fwd.hpp>
#include <memory>
#include <optional>

#include "clip/view.h"
#include "displayfile/files.h"
#include "interp/device/picture.h"
#include "interp/draw/draw.h"

namespace displayfile {

class RetainedScene;

/// A retained scene in a view. Its pictures are, bit for bit, those that the system would have
/// drawn in that view.
struct InView {
  const RetainedScene& scene;
  /// The display file of the system that retained the scene: visibility and image transformations
  /// of its segments.
  const DisplayFile& attributes;
  View view = {};
  const glm::dmat3* lights_turned = nullptr;  ///< rotates the lights; must outlive it; null: none
  /// Settings used where the options have no value; null: the options alone.
  const GraphicsSystem* settings = nullptr;
};

/// A system's retained scene, with its settings. Throws Error if nothing is retained.
InView in_view(const GraphicsSystem& system, const View& view);

/// Draws successive pictures of a system, or of its retained scene in any view, and picks. It draws
/// as draw (interp/draw/draw.h) does and caches intermediate results between pictures.
///
/// A system's picture: nothing is recomputed while the display file, the size and the method stay
/// the same; only changed segments are sorted again.
///
/// A retained scene: image-space methods sort nothing, transform each vertex once and skip polygons
/// that cover no pixel centre (displayfile/views/scene_viewer.md). Shadow data independent of the
/// eye is cached, and with one sample per pixel (DrawOptions::samples) visible surfaces are kept
/// while only lights move. `bsp` caches a tree in world coordinates (hidden/sort/world_tree.md),
/// world_ray_cast a tree of boxes (interp/visibility/ray_cast.md). Other methods sort each view
/// anew. A scene that the application edits is prepared again.
///
/// Not thread-safe: for use by one thread, which works with as many threads as the options set.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&& other) noexcept;
  Renderer& operator=(Renderer&& other) noexcept;

  /// Draws the visible segments into memory. The picture is valid until the next call, which reuses
  /// its memory. All draw overloads throw Error as draw does.
  const Picture& draw(const GraphicsSystem& system, const DrawOptions& options = {});
  void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options = {});

  /// Draws the visible segments in another view. `automatic` is the z-buffer for pixels, the map
  /// for vectors and franklin for pens. Also throws Error as ViewVolume does; for scope `segment`
  /// with an image-space method, which draws all segments together; and for segments with image
  /// transformations, which act after viewing, with world_ray_cast, or with `bsp` if they differ
  /// and the segments are sorted together.
  const Picture& draw(const InView& scene, const DrawOptions& options = {});
  void draw(const InView& scene, const Destination& to, const DrawOptions& options = {});

  /// The display file as if the application had drawn in that view, in order of entry.
  DisplayFile display_file(const InView& scene);

  /// Moves the last picture out; the next one uses new memory or that of a picture passed to
  /// give_back. Empty if there is none.
  Picture take_picture();
  void give_back(Picture picture);

  /// The lines, and the hatching of fills, that the last call of draw for pens drew in a view.
  const DisplayFile& drawn_by_pens() const;

  /// Returns the primitive visible, in a picture of the options' size, at the pixel that holds the
  /// point (x, y): in pixels from the picture's upper left corner, y down, as the rows of
  /// Picture::pixels. The pixel in column i of row j from the top holds i <= x < i + 1, j <= y < j
  /// + 1. None outside of the picture and where only the background is visible.
  ///
  /// The result is what the picture with these options shows at the pixel's centre: the value in
  /// its item buffer (Picture::ids), by any method and on any device. For the exact methods that is
  /// the definition of truth (interp/truth/truth.md); for `none` and `back-face` the fill entered
  /// last; where each segment is sorted by itself, the visible fill of the last segment; for a
  /// method that finds lines and draws no fills, the fill that hides. A line or drawn side of a
  /// polygon visible within `reach` pixels of the centre, or within half its width, takes
  /// precedence over the fill; of several, the one whose visible part is nearest to the centre.
  /// With a reach of 0 only fills are picked, as in an item buffer.
  ///
  /// The first pick of a display file builds a tree of boxes and costs about as much as a picture;
  /// later picks, while it is unchanged, examine only the pixel's surroundings, or draw its row
  /// where the picture does not show the truth. Errors: x or y is not finite; a reach outside of 0
  /// to kLargestSide; those of draw.
  std::optional<Pick> pick(const GraphicsSystem& system, double x, double y,
                           const DrawOptions& options = {}, double reach = 0.0);

  /// Returns the solid fill of a retained scene visible at a point of the picture, with the exact
  /// point in world coordinates (Pick::world). x and y are normalised device coordinates, 0 to 1
  /// over the picture, y up: the upper left corner of pixel (i, j) is (i / width, 1 - j / height).
  /// Clipped parts and removed back faces are not hit. None where nothing is hit and outside of the
  /// viewport. One tree of boxes serves all views. Throws Error as draw with world_ray_cast does,
  /// and for coordinates that are not finite.
  std::optional<Pick> seen_at(const InView& scene, double x, double y);

  /// How often cached data of a retained scene was built, since construction. While only lights
  /// change, no surfaces are found again. One tree of shadow casters serves all views of a scene
  /// that is not edited; while the lights stay, each visible polygon gets one list of its possible
  /// casters.
  struct Made {
    std::size_t surfaces, caster_trees, caster_lists;
  };
  Made made() const;
  std::size_t bytes_of_casters() const;  ///< memory cached for shadows
  /// The trees in world coordinates with which the last views were drawn.
  struct Trees {
    std::size_t sorted = 0;  ///< BSP trees: one, or one per segment
    std::uint64_t pieces = 0, cuts = 0, comparisons = 0, depth = 0;  ///< totals; maximum depth
    std::uint64_t walks = 0;                                         ///< traversals of a tree
    std::uint64_t reused = 0;           ///< orders reused because the eye crossed no plane
    std::size_t polygons_in_boxes = 0;  ///< in the tree of boxes
  };
  Trees trees() const;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile
