#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/segments/viewed_scene.h"
#include "hidden/boxes/space_tree.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane.h"
#include "interp/device/picture.h"
#include "interp/raster/on_demand.h"
#include "interp/raster/retained_casters.h"
#include "interp/scan/pixel_depth.h"

namespace displayfile {

/// Shadows: finds the fills that hide the light from visible points (interp/raster/shadows.md).
/// Every solid fill of the visible segments hides light, including those edge-on to the viewer;
/// device coordinates after the image transformation.
class Shadows {
 public:
  using Caster = std::uint32_t;
  static constexpr Caster kNone = ~Caster{0};

  /// The scene must outlive this.
  explicit Shadows(const ViewedScene& scene);
  /// For a view of a retained scene: shadows are found by its cached data; both must outlive this.
  Shadows(const ViewedScene& scene, RetainedCasters& retained) { take(scene, retained); }
  /// Replaces the contents, reusing memory.
  void take(const ViewedScene& scene, RetainedCasters& retained);
  /// Must be called when only the scene's lights changed.
  void take_lights() { on_items_.forget(retained_ == nullptr ? 0 : scene_->items()); }
  /// True if they are found by this cached data of a retained scene.
  bool is_by(const RetainedCasters* retained) const { return retained_ == retained; }

  /// A point of a fill, for which the visibility of the light is tested (FillShadow::light).
  struct LitPoint {
    Point3 at;
    double depth_error;  ///< how far it may be off the fill, along z
    HomogeneousPoint light;
  };
  /// Data common to all points of a fill.
  using Search = RetainedCasters::Search;
  struct OnFill {
    double depth_error;  ///< how far a point's depth may be off
    Search search = {};  ///< where to search for casters
  };
  /// The data of any fill in device coordinates; the plane is its support plane.
  static OnFill on(std::span<const Point3> fill, const Plane& plane, const PictureSize& size);
  /// The same for a fill of the scene that shows shadows, in pictures of one size: computed once,
  /// along with the candidate casters that hide no light from it.
  OnFill on(ViewedScene::Fill fill, const PictureSize& size) const;
  /// True if a fill lies between the point and the light. A fill on which the point lies, up to
  /// rounding, hides nothing. `last` is the previous caster, or kNone: it is tested first, and set
  /// to this point's caster.
  bool hidden(const LitPoint& point, const Search& search, Caster& last) const;

 private:
  struct Polygon {
    Point3 p, normal;  // of its plane: a point, and A, B, C
    // The largest magnitude of the plane's value at points that lie on the fill; infinite if it has
    // no plane, and hides nothing.
    double thickness;
    ViewedScene::Item item;
  };
  struct Ray;
  class FromFill;
  Polygon caster_of(ViewedScene::Item item) const;
  void build_tree();
  bool is_hidden_by(Caster caster, const Ray& ray) const;
  const Polygon& polygon_of(Caster caster, Polygon& spare) const;
  OnFill work_out(ViewedScene::Fill fill, const PictureSize& size) const;
  bool hides(const Polygon& polygon, const Ray& ray) const;
  bool is_met(const Polygon& polygon, const Ray& ray) const;

  const ViewedScene* scene_;
  std::vector<Polygon> casters_;  // as the tree has them
  SpaceTree tree_;
  // Cached data of a retained scene used instead, and casters by item.
  RetainedCasters* retained_ = nullptr;
  mutable OnDemand<Polygon> of_items_;
  mutable OnDemand<OnFill> on_items_;
};

/// The pixels of one fill that are in shadow.
class ShadowedFill {
 public:
  /// The plane is the fill's support plane in device coordinates, which is not edge-on.
  ShadowedFill(const Shadows& shadows, const Shadows::OnFill& on_fill, const Plane& plane,
               const FillShadow& shadow, const PictureSize& size)
      : shadows_(&shadows),
        on_fill_(on_fill),
        size_(size),
        depth_(plane, size.width, size.height),
        light_(shadow.light),
        colour_(pixel_of(shadow.colour)) {}

  /// Paints the columns first, first + 1, ... of a row, where the fill is visible: pixels in shadow
  /// get the shadow's colour there, as in Picture::pixels. A pixel is always tested by the same
  /// expressions of its centre, wherever a run begins.
  void paint(int row, int first, std::span<std::uint32_t> pixels) const;

 private:
  const Shadows* shadows_;
  Shadows::OnFill on_fill_;
  PictureSize size_;
  PixelDepth depth_;
  HomogeneousPoint light_;
  std::uint32_t colour_;
};

}  // namespace displayfile
