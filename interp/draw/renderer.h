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

/// A retained scene in a view: what a system's application drew, from any eye. What is drawn is
/// what the system would have drawn in that view, to the last bit.
struct InView {
  const RetainedScene& scene;
  /// The display file of the system that retained the scene: which segments are visible, and how
  /// their images are transformed.
  const DisplayFile& attributes;
  View view = {};
  const glm::dmat3* lights_turned = nullptr;  ///< a rotation, which must last; null: none
  /// Has settings that hold where options leave something open; null: the options alone hold.
  const GraphicsSystem* settings = nullptr;
};

/// The scene that a system retained, with its settings. Throws Error if it retained none.
InView in_view(const GraphicsSystem& system, const View& view);

/// Draws a system's pictures one after another, and what it retained in any view, and picks: as
/// draw (interp/draw/draw.h) does, but what is made ready for a picture is kept for the next.
///
/// A system's picture: while the display file, the size and the method stay the same, nothing is
/// made anew; where only some segments changed, only these are sorted again.
///
/// A retained scene: methods of image space sort nothing, view each vertex once and leave out
/// what no pixel's centre can show (displayfile/views/scene_viewer.md); what a moving eye leaves as
/// it was of shadows is kept, and, where a pixel has one sample (DrawOptions::samples), what a
/// moving light leaves of visible surfaces. `bsp` keeps a tree in world coordinates
/// (hidden/sort/world_tree.md), world_ray_cast a tree of boxes (interp/visibility/ray_cast.md). All
/// others sort each view anew. A scene that the application edited is taken up anew.
///
/// For one thread, which shares the work among as many as the options say.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&& other) noexcept;
  Renderer& operator=(Renderer&& other) noexcept;

  /// The visible segments in memory. The picture stays until the next call, which uses its memory
  /// again. Throws Error as draw does, here as below.
  const Picture& draw(const GraphicsSystem& system, const DrawOptions& options = {});
  void draw(const GraphicsSystem& system, const Destination& to, const DrawOptions& options = {});

  /// The visible segments in another view. `automatic` is the z-buffer, of vectors the map, and for
  /// pens franklin. Throws Error as ViewVolume does too; for scope `segment` by a method of image
  /// space, which draws all segments together; and where a tree for all views is to be made of
  /// segments with image transformations, which act after viewing: for world_ray_cast, and for
  /// `bsp` if they differ and are to be sorted together.
  const Picture& draw(const InView& scene, const DrawOptions& options = {});
  void draw(const InView& scene, const Destination& to, const DrawOptions& options = {});

  /// The display file as if the application had drawn in that view, in order of entry.
  DisplayFile display_file(const InView& scene);

  /// The picture that draw made last, for a caller that keeps it: the next one gets memory of its
  /// own, or that of a picture that was given back. Empty if there is none.
  Picture take_picture();
  void give_back(Picture picture);

  /// What the last call of draw for pens drew in a view: lines, and fills where they are hatched.
  const DisplayFile& drawn_by_pens() const;

  /// What is seen, in a picture of the options' size, at the pixel that holds the point (x, y):
  /// in pixels from the picture's upper left corner, y down, as the rows of Picture::pixels; so the
  /// pixel in column i of row j from the top holds i <= x < i + 1, j <= y < j + 1. Nothing beyond
  /// the picture, and where there is only the background.
  ///
  /// It is what the picture with these options shows at the pixel's centre: what its item buffer
  /// holds (Picture::ids), by whichever method and on whichever device. By the exact methods that
  /// is the definition of truth (interp/truth/truth.md). By `none` and `back-face` it is what was
  /// entered last, and where each segment is sorted by itself, what is seen of the last segment. By
  /// a method that finds lines, which draws no fills, it is the fill that hides. A line, or a drawn
  /// side of a polygon, that is seen within `reach` pixels of the centre, or within half its width,
  /// comes before the fill there; with a reach of 0 only fills are picked, as they are in an item
  /// buffer. Of lines the one that is seen nearest to the centre.
  ///
  /// The first pick of a display file makes a tree of boxes, and costs about as much as a picture;
  /// those that follow, while it stays the same, look only at what lies around the pixel, or where
  /// the picture does not show the truth draw its row of pixels. Errors: x or y is not finite, a
  /// reach outside of 0 to kLargestSide, and those of draw.
  std::optional<Pick> pick(const GraphicsSystem& system, double x, double y,
                           const DrawOptions& options = {}, double reach = 0.0);

  /// What is seen of a retained scene at a point of the picture, with the point in world
  /// coordinates (Pick::world), exactly. The point is in normalised device coordinates, 0 to 1 over
  /// the picture, y up: the upper left corner of pixel (i, j) is (i / width, 1 - j / height). Solid
  /// fills alone are seen, through what clipping and back-face removal take away. Nothing where
  /// there is none, and outside of the viewport. One tree of boxes serves all views. Throws Error
  /// as draw by world_ray_cast, and for coordinates that are not finite.
  std::optional<Pick> seen_at(const InView& scene, double x, double y);

  /// How often what is kept of a retained scene was made, since the beginning: while only lights
  /// change, no surfaces are found; for all views of a scene that is not edited one tree of what
  /// casts shadows is made; and while the lights stay, for each polygon that is seen one list of
  /// what can hide its light.
  struct Made {
    std::size_t surfaces, caster_trees, caster_lists;
  };
  Made made() const;
  std::size_t bytes_of_casters() const;  ///< kept for shadows
  /// The trees in world coordinates by which views were drawn last.
  struct Trees {
    std::size_t sorted = 0;  ///< BSP trees: one, or one for each segment
    std::uint64_t pieces = 0, cuts = 0, comparisons = 0, depth = 0;  ///< theirs; the deepest
    std::uint64_t walks = 0;                                         ///< of a tree
    std::uint64_t reused = 0;           ///< orders that needed no walk: the eye crossed no plane
    std::size_t polygons_in_boxes = 0;  ///< of the tree of boxes
  };
  Trees trees() const;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile
