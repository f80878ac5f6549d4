#pragma once

#include <glm/mat3x3.hpp>
#include <string>
#include <tuple>

#include "clip/view.h"
#include "displayfile/files.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/views/scene_viewer.h"
#include "interp/device/picture.h"
#include "interp/device/raster_request.h"
#include "interp/draw/draw.h"
#include "interp/draw/nothing_seen.h"
#include "interp/draw/picture_checks.h"
#include "interp/draw/picture_plan.h"
#include "interp/raster/software.h"

/// Sources of pictures, and drawing a source into memory or a file.
namespace displayfile {

/// The source of a picture: a display file, or a retained scene in a view.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  virtual Picture draw(const RasterRequest& request) const = 0;
  /// Passes rows on as they are drawn, if the device can.
  virtual void draw(const RasterRequest& request, const TakeRows& take) const = 0;
  /// A picture whose memory may be reused; its contents are undefined.
  virtual Picture take_spare() const = 0;
  virtual void write_vectors(const PictureFormat& format, const Destination& to,
                             const RasterRequest& request) const = 0;
  /// The reason why nothing of it is visible in such a picture; empty if something is.
  virtual std::string why_nothing_is_seen(const SeenIn& in) const = 0;
};

/// The application's primitives of the display file, if known, and their view if it is not their
/// own.
struct EnteredSource {
  const RetainedScene* scene = nullptr;
  const View* view = nullptr;
};

class DisplayFileSource : public PictureSource {
 public:
  /// `by_depth`: its vectors are its map, as with an image-space method. The plan must outlive it.
  DisplayFileSource(const DisplayFile& file, bool by_depth, const PicturePlan& plan,
                    SoftwareRenderer& kept, const EnteredSource& entered = {})
      : file_(file), entered_(entered), by_depth_(by_depth), plan_(plan), kept_(kept) {}

  Picture draw(const RasterRequest& request) const override {
    return plan_.device->draw(file_, request, kept_);
  }
  void draw(const RasterRequest& request, const TakeRows& take) const override {
    const RasterDevice& device = *plan_.device;
    if (device.draw_rows == nullptr) return take(device.draw(file_, request, kept_));
    device.draw_rows(file_, request, kept_, take);
  }
  Picture take_spare() const override { return kept_.take_picture(); }
  void write_vectors(const PictureFormat& format, const Destination& to,
                     const RasterRequest& request) const override;
  std::string why_nothing_is_seen(const SeenIn& in) const override;

 private:
  const DisplayFile& file_;
  EnteredSource entered_;
  bool by_depth_;
  const PicturePlan& plan_;
  SoftwareRenderer& kept_;
};

/// Without a display file, except for a device that needs one. The casters are the cached shadow
/// data, or null.
class RetainedSource : public PictureSource {
  template <class Do>
  auto of_display_file(Do&& work) const {
    const DisplayFile file = viewer_.display_file(view_, lights_turned_);
    return work(DisplayFileSource(file, true, plan_, kept_));
  }

 public:
  RetainedSource(SceneViewer& viewer, const View& view, const glm::dmat3& lights_turned,
                 const PicturePlan& plan, SoftwareRenderer& kept, RetainedCasters* casters)
      : viewer_(viewer),
        view_(view),
        lights_turned_(lights_turned),
        plan_(plan),
        kept_(kept),
        casters_(casters) {}

  Picture draw(const RasterRequest& request) const override {
    if (!plan_.is_on_first_device())
      return of_display_file([&](const PictureSource& s) { return s.draw(request); });
    const ViewedScene& seen = scene(request);
    kept_.draw(seen, request, kept_of_views(seen, request));
    return kept_.take_picture();
  }
  void draw(const RasterRequest& request, const TakeRows& take) const override {
    if (!plan_.is_on_first_device())
      return of_display_file([&](const PictureSource& s) { s.draw(request, take); });
    const ViewedScene& seen = scene(request);
    kept_.draw(seen, request, kept_of_views(seen, request), take);
  }
  Picture take_spare() const override { return kept_.take_picture(); }
  void write_vectors(const PictureFormat& format, const Destination& to,
                     const RasterRequest& request) const override {
    of_display_file([&](const PictureSource& s) { s.write_vectors(format, to, request); });
  }
  std::string why_nothing_is_seen(const SeenIn& in) const override {
    const SeenIn in_view{in.pixels, view_};
    const auto& [scene, attributes] = std::tie(viewer_.scene(), viewer_.attributes());
    if (!nothing_is_seen(scene, attributes, in_view)) return "";
    return displayfile::why_nothing_is_seen(scene, attributes, in_view);
  }

 private:
  SceneViewer::Wanted wanted(const RasterRequest& request) const {
    return {view_, lights_turned_, PictureSize{request.width, request.height},
            request.surfaces.threads};
  }
  const ViewedScene& scene(const RasterRequest& request) const {
    return viewer_.view(wanted(request));
  }
  SoftwareRenderer::KeptBetweenPictures kept_of_views(const ViewedScene& seen,
                                                      const RasterRequest& request) const {
    const bool casters = casters_ != nullptr && casters_->take(viewer_, wanted(request), seen);
    return {casters ? casters_ : nullptr, viewer_.is_lit()};
  }
  SceneViewer& viewer_;
  const View& view_;
  const glm::dmat3& lights_turned_;
  const PicturePlan& plan_;
  SoftwareRenderer& kept_;
  RetainedCasters* casters_;
};

bool has_background(const DrawOptions& options);

/// The raster parameters of the plan.
RasterRequest raster_request(const PicturePlan& plan);

/// Draws in memory; only colours are antialiased.
Picture draw_pixels(const PictureSource& source, const RasterRequest& request,
                    const PicturePlan& plan);
/// Draws into a file, and other requested data into further files: all of them or, on failure,
/// none.
void write_picture(const PictureSource& source, const RasterRequest& request,
                   const PicturePlan& plan);

}  // namespace displayfile
