#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "clip/surfaces.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

struct ViewedWorld;

/// Called with the fills seen at the centres of columns first, first + 1, ... of a row:
/// ViewedScene::kBackground where there is none. Rows count from the bottom.
using SeenRun = std::function<void(int row, int first, std::span<const ViewedScene::Fill> seen)>;

/// A way to find hidden surfaces in image space: which fill is seen at each pixel centre
/// (interp/truth/truth.md). Each method is one file and one line in the list of
/// image_space_methods().
class ImageSpaceMethod {
 public:
  virtual ~ImageSpaceMethod() = default;

  /// What pictures of the scene, which must live on, share.
  struct Request {
    const ViewedScene& scene;
    PictureSize size;
    /// Depths closer than this count as equal (the textbook's ROUNDOFF); none: exact.
    std::optional<double> roundoff;
  };

  /// Takes up a scene, and lets go of the one before. On up to so many threads, with the same
  /// result.
  virtual void prepare(const Request& request, int threads) = 0;

  /// Tells of every pixel of rows row_begin <= row < row_end once, in any order. May be called
  /// again, and with different rows by several threads at a time.
  virtual void draw_rows(int row_begin, int row_end, const SeenRun& seen) const = 0;

  /// The least number of rows that are as cheap to draw by themselves as together with others.
  virtual int rows_at_a_time() const { return 1; }
};

/// One line a method.
struct ImageSpaceEntry {
  HiddenMethod method;
  std::unique_ptr<ImageSpaceMethod> (*make)();
};
/// Those that decide exactly by the viewed scene: all but world_ray_cast and the plain forms.
std::span<const ImageSpaceEntry> image_space_methods();

/// True also of `automatic`, which for a picture in pixels picks one of them, and of
/// world_ray_cast, which tells of the viewed scene what was found before viewing.
bool is_image_space(HiddenMethod by);
/// True for the plain z-buffers, whatever they store depths as.
bool is_plain_z_buffer(HiddenMethod by);
/// True for those of image space that decide by the viewed scene without rounding: all but
/// world_ray_cast and the plain z-buffers.
bool decides_exactly(HiddenMethod by);

/// Throws Error if the method does not work in image space. world_ray_cast works on `world`, which
/// must live on: what the scene is a view of.
std::unique_ptr<ImageSpaceMethod> make_image_space_method(HiddenMethod method,
                                                          const ViewedWorld* world = nullptr);

}  // namespace displayfile
