#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <memory>

#include "clip/view.h"
#include "displayfile/display_file.h"
#include "displayfile/files.h"
#include "displayfile/retained_scene.h"
#include "interp/draw/draw.h"

namespace displayfile {

/// Draws a retained scene from new eyes, one picture after another, by any method that works in
/// image space (displayfile/scene_viewer.md) or finds lines. In image space nothing is sorted, each
/// vertex is viewed once, what no pixel's centre can show is left out, and memory is kept from
/// picture to picture; so is what a moving eye leaves as it was of shadows, and a moving light of
/// visible surfaces. What is seen is what the system would have drawn in that view, to the last
/// bit. Where the application edited the scene, it is taken up anew. For one thread, which shares
/// the work among as many as the options say.
class ViewRenderer {
 public:
  /// The scene, and the display file of the system that retained it, which says which segments are
  /// visible and how their images are transformed. Both must live on, and may be edited and moved.
  ViewRenderer(const RetainedScene& scene, const DisplayFile& attributes);
  ~ViewRenderer();
  ViewRenderer(ViewRenderer&& other) noexcept;
  ViewRenderer& operator=(ViewRenderer&& other) noexcept;

  /// The visible segments in that view, with the lights turned by a rotation. The options' method
  /// is `automatic`, the z-buffer, unless they say otherwise; scope has a meaning for methods of
  /// lines alone: without one all segments are drawn together. The picture stays until the next
  /// call, which uses its memory again. Throws Error as draw (interp/draw/draw.h) and ViewVolume
  /// do, for a method that neither works in image space nor finds lines, for scope `segment` where
  /// it has no meaning, and if the scene or the display file is gone.
  const Picture& draw(const View& view, const DrawOptions& options = {},
                      const glm::dmat3& lights_turned = glm::dmat3(1.0));
  void draw(const View& view, const Destination& to, const DrawOptions& options = {},
            const glm::dmat3& lights_turned = glm::dmat3(1.0));

  /// The picture that draw made last, for a caller that keeps it, as of a Renderer
  /// (interp/draw/renderer.h).
  Picture take_picture();
  void give_back(Picture picture);

  /// What the last call of draw for pens drew: the lines that it found.
  const DisplayFile& lines_for_pens() const;

  /// How often what is kept was made, since the beginning: while only lights change, no surfaces
  /// are found; for all views of a scene that is not edited one tree of what casts shadows is made;
  /// and while the lights stay, for each polygon that is seen one list of what can hide its light.
  struct Made {
    std::size_t surfaces, caster_trees, caster_lists;
  };
  Made made() const;
  std::size_t bytes_of_casters() const;  ///< kept for shadows

  /// The display file as if the application had drawn in that view, written for who asks.
  DisplayFile display_file(const View& view,
                           const glm::dmat3& lights_turned = glm::dmat3(1.0)) const;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile
