#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "interp/annotation/annotation_marks.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"
#include "interp/files/row_file.h"
#include "interp/raster/fill_paints.h"
#include "interp/raster/kept_surfaces.h"
#include "interp/raster/lines_over_fills.h"
#include "interp/raster/raster_band.h"
#include "interp/raster/retained_casters.h"
#include "interp/raster/shadows.h"
#include "interp/visibility/image_space.h"
#include "interp/visibility/picker.h"

namespace displayfile {

/// Draws display files by the built-in scan conversion, on the background. With an image-space
/// method the nearest fill is visible, of equally near ones the one entered later; otherwise the
/// one drawn last. Over the fills, except without hidden-surface removal, lines are drawn where
/// they are visible (interp/scan/lines.md), or by the colour rule (interp/raster/colour_rule.md).
/// Fills that show shadows get them (interp/raster/shadows.md) with every method; texts are drawn
/// last (interp/text/). Coverage and, without roundoff, depth order are decided exactly. The
/// picture does not depend on the number of threads.
///
/// Prepared data are reused while the display file's fills, the size and the method are the same.
class SoftwareRenderer {
 public:
  /// The picture is valid until the next call, which reuses its memory. Throws Error for a size
  /// outside of 1 to kLargestSide.
  const Picture& draw(const DisplayFile& display_file, const RasterRequest& request);
  /// Draws the same picture in strips from the top: only a few rows for each thread are in memory
  /// at a time.
  void draw(const DisplayFile& display_file, const RasterRequest& request, const TakeRows& take);
  /// Data cached between views of a retained scene, besides memory.
  struct KeptBetweenPictures {
    RetainedCasters* casters = nullptr;  ///< prepared for the view; null: found anew
    /// Keeps the visible fills, 4 bytes a pixel, for the same view in other lights: those of the
    /// first picture, and later those of views that recur. A moving eye costs nothing.
    bool surfaces = false;
  };
  /// The same for a scene without a display file, by an image-space method other than
  /// world_ray_cast. Prepared data are reused if the scene is the last one in other lights
  /// (ViewedScene::geometry), but not after a change of method; visible fills are reused if a whole
  /// picture is held. Otherwise only memory is.
  const Picture& draw(const ViewedScene& scene, const RasterRequest& request,
                      const KeptBetweenPictures& kept);
  void draw(const ViewedScene& scene, const RasterRequest& request, const KeptBetweenPictures& kept,
            const TakeRows& take);
  const Picture& draw(const ViewedScene& scene, const RasterRequest& request) {
    return draw(scene, request, KeptBetweenPictures{});
  }
  Picture take_picture() { return std::move(picture_); }
  /// The line that the last picture, of that size and in line order depth, shows at a pixel, row 0
  /// at the bottom: the one drawn last of those that cover its centre, or else the one whose axis
  /// is nearest to it, within `reach` pixels. Hidden parts are not found. None also if there are no
  /// lines.
  std::optional<Pick> line_at(const PictureSize& size, const Picker::Pixel& at, double reach) const;
  /// A picture whose memory the next one may use.
  void give_back(Picture picture) { picture_ = std::move(picture); }
  std::size_t bytes_of_picture() const;  ///< held for the next one
  /// How often a method computed the visible surfaces, for all pictures or their rows.
  std::size_t surfaces_found() const { return surfaces_found_; }
  /// The scene of a display file: the cached one if the file was drawn last, otherwise a new one.
  std::shared_ptr<const ViewedScene> scene_of(const DisplayFile& display_file) const;

 private:
  /// An image-space method prepared for the scene.
  struct Prepared {
    HiddenMethod method;  // as requested
    PictureSize size{};
    std::optional<double> roundoff = std::nullopt;
    const ViewedScene* scene = nullptr;
    const ViewedWorld* world = nullptr;
    std::unique_ptr<ImageSpaceMethod> finder = nullptr;
  };
  /// The input of a drawing: a scene, or for a method outside of image space its display file.
  struct Drawn {
    const DisplayFile* display_file;
    std::size_t polygons;
    bool keeps_surfaces = false;
  };
  Drawn prepare(const DisplayFile& display_file, const RasterRequest& request);
  Drawn prepare(const ViewedScene& scene, const RasterRequest& request,
                const KeptBetweenPictures& kept);
  void take_up_shadows(const ViewedScene& scene, RetainedCasters* casters, bool same_geometry);
  void take_up_scene(const RasterRequest& request);
  void take_up_scene_of(const DisplayFile& display_file);
  void take_up_lines(const DisplayFile& display_file, const RasterRequest& request);
  const Picture& draw(const Drawn& drawn, const RasterRequest& request);
  void draw(const Drawn& drawn, const RasterRequest& request, const TakeRows& take);
  int rows_at_a_time(const Drawn& drawn, const RasterRequest& request) const;
  void draw_rows(const Drawn& drawn, const RasterRequest& request, const RowRange& rows);
  void paint_in_order(const DisplayFile& display_file, const RasterRequest& request,
                      const RowRange& rows);
  void show_fills_seen(const Drawn& drawn, const RasterRequest& request, const RowRange& rows);
  void draw_lines_seen(const RasterRequest& request, const RowRange& rows);
  void draw_lines_by_depth(const RasterRequest& request, const RowRange& rows);

  Picture picture_;                  // or the rows of it that are being drawn
  std::vector<double> spare_depth_;  // of the colour rule, while the picture has none
  std::shared_ptr<const ViewedScene> scene_;
  FillPaints paints_;                 // of the scene
  std::unique_ptr<Shadows> shadows_;  // null: none
  std::optional<Prepared> prepared_;
  std::uint64_t geometry_ = 0;  // of the scene last prepared for a view
  KeptSurfaces surfaces_;
  std::size_t surfaces_found_ = 0;
  bool has_drawn_views_ = false;
  LinesOverFills lines_;
  std::vector<DeviceText> texts_;  // visible ones
  std::vector<AnnotationMark> annotation_;
};

/// Draws one picture with a renderer of its own.
Picture draw_with_software(const DisplayFile& display_file, const RasterRequest& request);

}  // namespace displayfile
