#pragma once

#include <memory>

#include "hidden/exact/pixel_centre.h"
#include "interp/picture.h"
#include "programs/bench/application_mesh.h"

namespace displayfile::bench {

/// Ours with a moving camera: a retained scene drawn by the exact z-buffer in one new view after
/// another, without a sort. How the library does that stands behind this class alone.
class NewViews {
 public:
  /// The mesh must live on.
  NewViews(const ApplicationMesh& mesh, const PictureSize& size, int threads);
  ~NewViews();
  NewViews(const NewViews&) = delete;
  NewViews& operator=(const NewViews&) = delete;

  /// The picture stays until the next call.
  const Picture& draw_new_view(const View& view);

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace displayfile::bench
