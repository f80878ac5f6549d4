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

/// Called with the fills visible at the centres of columns first, first + 1, ... of a row:
/// ViewedScene::kBackground where there is none. Rows count from the bottom.
using SeenRun = std::function<void(int row, int first, std::span<const ViewedScene::Fill> seen)>;

/// An image-space method: finds the fill visible at each pixel centre (interp/truth/truth.md). Each
/// method is one file and one line in the list of image_space_methods().
class ImageSpaceMethod {
 public:
  virtual ~ImageSpaceMethod() = default;

  /// Data shared by pictures of the scene, which must outlive it.
  struct Request {
    const ViewedScene& scene;
    PictureSize size;
    /// Depths closer than this count as equal (the textbook's ROUNDOFF); none: exact.
    std::optional<double> roundoff;
  };

  /// Prepares for a scene and releases the previous one. On up to `threads` threads, with the same
  /// result.
  virtual void prepare(const Request& request, int threads) = 0;

  /// Reports every pixel of rows row_begin <= row < row_end once, in any order. May be called
  /// again, and with different rows by several threads at a time.
  virtual void draw_rows(int row_begin, int row_end, const SeenRun& seen) const = 0;

  /// The least number of rows that are as cheap to draw separately as with others.
  virtual int rows_at_a_time() const { return 1; }
};

/// A row of the table of methods.
struct ImageSpaceEntry {
  HiddenMethod method;
  std::unique_ptr<ImageSpaceMethod> (*make)();
};
/// The methods that decide exactly by the viewed scene: all but world_ray_cast and the plain forms.
std::span<const ImageSpaceEntry> image_space_methods();

/// Also true for `automatic`, which for pixels chooses one of them, and for world_ray_cast, whose
/// result before viewing is passed to the viewed scene.
bool is_image_space(HiddenMethod by);
/// True for the plain z-buffers, in any storage format.
bool is_plain_z_buffer(HiddenMethod by);
/// True for image-space methods that decide by the viewed scene without rounding: all but
/// world_ray_cast and the plain z-buffers.
bool decides_exactly(HiddenMethod by);

/// Throws Error if the method does not work in image space. world_ray_cast uses `world`, which must
/// outlive it: the source of the view.
std::unique_ptr<ImageSpaceMethod> make_image_space_method(HiddenMethod method,
                                                          const ViewedWorld* world = nullptr);

}  // namespace displayfile
