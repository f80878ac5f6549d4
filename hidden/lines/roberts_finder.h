#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "clip/geometry/corners.h"
#include "hidden/lines/convex_objects.h"
#include "hidden/lines/line_against_polygon.h"

namespace displayfile {

/// The part of a line that an object as a whole hides.
enum class ObjectHides { nothing, all, some };

/// Null observer; compiles to nothing.
struct RobertsUnobserved {
  static void farther(std::uint32_t /*object*/) {}
  static void volume(std::uint32_t /*object*/, ObjectHides /*hides*/) {}
  static void compared(std::uint32_t /*polygon*/) {}
};

/// Finds the hidden parts of lines one by one. An Observer is notified of each object whose extent
/// meets the line's: that it is farther away, or the result of the volume test; and of each polygon
/// with which the line is compared.
template <class Policy, class Observer = RobertsUnobserved>
class Roberts {
 public:
  /// `tree` must contain the objects' extents.
  Roberts(const LineTable& scene, const ConvexObjects& objects, const ExtentTree& tree,
          const Policy& policy, const Observer& observer = {})
      : scene_(scene),
        objects_(objects),
        tree_(tree),
        policy_(policy),
        line_(scene, policy),
        observer_(observer) {}

  const std::vector<PartOfLine>& hidden_parts(const LineTable::Line& line) {
    parts_.clear();
    line_.look_at(line);
    has_own_ends_ = scene_.intersection(line) == nullptr;
    box_ = scene_.extent(line);
    const auto meets = [flat = FlatBox::of(box_)](const FlatBoxes& b) { return b.meets(flat); };
    tree_.any(meets, [&](ExtentTree::Position position) {
      compare(tree_.order()[position]);
      return parts_.hides(kWhole);
    });
    return parts_.hidden();
  }

 private:
  static constexpr PartOfLine kWhole{0.0, 1.0};
  using Hides = ObjectHides;

  void compare(std::uint32_t object) {
    const Extent& around = objects_.extents()[object];
    if (around.z_max <= box_.z_min) return observer_.farther(object);  // the minimax test in depth
    const bool is_one = has_own_ends_ && !objects_.outline(object).empty();
    const Hides hides = is_one ? volume_test(object) : Hides::some;
    observer_.volume(object, hides);
    switch (hides) {
      case Hides::nothing: return;
      case Hides::all: parts_.add_both(kWhole); return;
      case Hides::some: break;
    }
    for (const std::uint32_t polygon : objects_.polygons(object)) {
      const Extent& box = scene_.extent(polygon);
      if (box.z_max <= box_.z_min || !box.meets_in_projection(box_)) continue;
      line_.hide(polygon, parts_);
      observer_.compared(polygon);
    }
  }

  /// Tests the line against the volume behind the object: within its outline, and behind the planes
  /// of its polygons.
  Hides volume_test(std::uint32_t object) {
    const Point2 a(line_.line().a), b(line_.line().b);
    const auto outline = objects_.outline(object);
    bool within = true;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Point2 p(scene_.point(outline[k]));
      const Point2 q(scene_.point(outline[next_corner(k, outline.size())]));
      if (line_.is_near(scene_.point(outline[k]))) return Hides::some;
      const int of_a = policy_.turn(p, q, a), of_b = policy_.turn(p, q, b);
      if (of_a <= 0 && of_b <= 0) return of_a < 0 || of_b < 0 ? Hides::nothing : Hides::some;
      within = within && of_a >= 0 && of_b >= 0;
    }
    if (!within) return Hides::some;
    if (objects_.extents()[object].z_min > box_.z_max) return Hides::all;
    const auto polygons = objects_.polygons(object);
    const bool behind = std::ranges::all_of(
        polygons, [&](std::uint32_t polygon) { return line_.is_behind(polygon); });
    return behind ? Hides::all : Hides::some;
  }

  const LineTable& scene_;
  const ConvexObjects& objects_;
  const ExtentTree& tree_;
  const Policy& policy_;
  LineAgainstPolygon<Policy> line_;
  Extent box_{};
  bool has_own_ends_ = true;  // false for an intersection, whose ends are rounded
  HiddenParts parts_;
  [[no_unique_address]] Observer observer_;
};

}  // namespace displayfile
