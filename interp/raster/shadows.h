#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"
#include "hidden/exact/plane.h"
#include "hidden/space_tree.h"
#include "interp/scan/pixel_depth.h"

namespace displayfile {

/// Shadows: what hides the light from the points that are seen (interp/raster/shadows.md). Every
/// solid fill of the visible segments hides light, those that are edge-on to the viewer too; device
/// coordinates after the image transformation.
class Shadows {
 public:
  using Caster = std::uint32_t;
  static constexpr Caster kNone = ~Caster{0};

  /// The scene must live on.
  explicit Shadows(const ViewedScene& scene);

  /// A point of a fill, from which the light is looked at (FillShadow::light).
  struct LitPoint {
    Point3 at;
    double depth_error;  ///< how far it may be off the fill, along z
    HomogeneousPoint light;
  };
  /// True if a fill lies between the point and the light. A fill that the point lies on, but for
  /// rounding, hides nothing. `last` is what hid the light from the point before, or kNone: it is
  /// looked at first, and becomes what hides it from this one.
  bool hidden(const LitPoint& point, Caster& last) const;

 private:
  struct Polygon {
    Point3 p, normal;  // of its plane: a point, and A, B, C
    double thickness;  // how far from 0 the plane's value may be at points that lie on the fill
    ViewedScene::Item item;
  };
  struct Ray;
  void enter(ViewedScene::Item item);
  void build_tree();
  bool hides(const Polygon& polygon, const Ray& ray) const;
  bool is_met(const Polygon& polygon, const Ray& ray) const;

  const ViewedScene* scene_;
  std::vector<Polygon> casters_;  // as the tree has them
  SpaceTree tree_;
};

/// The pixels of one fill that are in shadow.
class ShadowedFill {
 public:
  /// The fill is in device coordinates; the plane is its support plane, which is not edge-on.
  ShadowedFill(const Shadows& shadows, std::span<const Point3> fill, const Plane& plane,
               const FillShadow& shadow, const PictureSize& size);

  /// Paints the columns first, first + 1, ... of a row, where the fill is seen: those in shadow get
  /// its colour there, as in Picture::pixels. A pixel is always judged by the same expressions of
  /// its centre, wherever a run begins.
  void paint(int row, int first, std::span<std::uint32_t> pixels) const;

 private:
  const Shadows* shadows_;
  PictureSize size_;
  PixelDepth depth_;
  double depth_error_;
  HomogeneousPoint light_;
  std::uint32_t colour_;
};

}  // namespace displayfile
