#pragma once

#include <memory>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "interp/device/picture.h"
#include "tests/bench/command/application_mesh.h"

namespace displayfile::bench {

/// Ours with a moving camera: a retained scene drawn by the exact z-buffer in one new view after
/// another, without a sort; nothing is kept but the retained scene. Only this class depends on how
/// the library does that.
class NewViews {
 public:
  NewViews(const ApplicationMesh& mesh, const PictureSize& size, int threads);
  ~NewViews();
  NewViews(const NewViews&) = delete;
  NewViews& operator=(const NewViews&) = delete;

  /// The scene in the view; it stays until the next call. The first call prepares for views.
  const ViewedScene& new_view(const View& view);
  /// The picture stays until the next call.
  const Picture& draw_new_view(const View& view);
  /// With the item buffer.
  const Picture& draw_items_of_new_view(const View& view);
  /// The display file that this view would have.
  DisplayFile display_file(const View& view);

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile::bench
