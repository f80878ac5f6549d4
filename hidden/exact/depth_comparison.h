#pragma once

#include <optional>

#include "hidden/exact/depth_order.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/plane_in_picture.h"

namespace displayfile {

/// depth_order(a, b, at) at many points: exact arithmetic is done once, when the first filter is
/// undecided (predicates.md, section 6). Two planes with two common points, as neighbours in a
/// mesh, change their order along the line through these: the order on one side is computed.
/// Otherwise the difference of the depths, linear in the projection, is computed exactly and then
/// rounded, so that the later filter does not suffer from cancellation between nearly equal planes.
class DepthComparison {
 public:
  DepthComparison() = default;
  /// Neither plane may be edge-on.
  DepthComparison(const Plane& a, const Plane& b) : a_(a), b_(b) {}
  /// Prepares the comparison at once.
  DepthComparison(const PlaneInPicture& a, const PlaneInPicture& b) { difference_.emplace(a, b); }

  /// The order at a pixel's centre; the planes in device coordinates.
  int order(const PixelCentre& centre) {
    const int order = filtered({centre.x, centre.y, centre.error});
    return order != 0 ? order : exact(centre);
  }
  /// The order at a point of the projection.
  int order(const Point2& at) {
    const int order = filtered({at.x, at.y, 0.0});
    return order != 0 ? order : exact(at);
  }

  /// The order at a point of the projection, if no exact arithmetic with both planes is needed now.
  std::optional<int> order_at_hand(const Point2& at) const;

  /// True after preparation, when the first filter was undecided.
  bool is_ready() const { return hinge_ || difference_; }
  void make_ready();
  /// True if the planes were found to be equal.
  bool is_one_plane() const {
    return (hinge_ && hinge_->order_on_left == 0) || (difference_ && difference_->is_zero());
  }

  /// The prepared difference: za - zb at (x, y) is x slope_x + y slope_y + constant times a
  /// positive number. Each is off by less than 2^-38 of the largest, which is from 1/2 to 1 unless
  /// all are zero. Planes that meet in a line far outside of the picture have none.
  struct Linear {
    double slope_x = 0.0, slope_y = 0.0, constant = 0.0;
  };
  std::optional<Linear> rounded() const;

 private:
  /// The line where both planes meet, and the order on its left; 0: they meet everywhere.
  struct Hinge {
    Point2 from, to;
    int order_on_left;
  };
  static std::optional<Hinge> hinge_of(const Plane& a, const Plane& b);

  /// A positive multiple of za - zb at (x, y): slope_x x + slope_y y + constant.
  struct Difference {
    Difference(const Plane& a, const Plane& b);
    Difference(const PlaneInPicture& a, const PlaneInPicture& b);
    void make_near();
    bool is_zero() const;  ///< equal planes
    int filtered(const Position& at) const;
    int exact(const PixelCentre& centre) const;
    int exact(const Point2& at) const;

    ExactNumber slope_x, slope_y, constant;
    Linear near;
    /// The difference in integers of 62 bits, if they fit: planes through grid points often meet
    /// where only exact arithmetic decides, and most such grids are coarse.
    struct Whole {
      std::int64_t slope_x, slope_y, constant;
    };
    std::optional<Whole> whole;
  };

  int filtered(const Position& at) const {
    return difference_ ? difference_->filtered(at) : hinge_ ? 0 : filtered_depth_order(a_, b_, at);
  }
  template <class At>
  int exact(const At& at);

  Plane a_, b_;
  std::optional<Hinge> hinge_;  // at most one of the two is set
  std::optional<Difference> difference_;
};

}  // namespace displayfile
