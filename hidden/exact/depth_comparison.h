#pragma once

#include <optional>

#include "hidden/exact/depth_order.h"
#include "hidden/exact/exact_number.h"
#include "hidden/exact/plane_in_picture.h"

namespace displayfile {

/// depth_order(a, b, at), asked at many places: what takes exact arithmetic is done once, where
/// the first filter is undecided (predicates.md, section 6). Two planes that are given by two
/// common points, as neighbours in a mesh are, change their order along the line through these: it
/// is found out on one side of it. Otherwise the difference of the two depths, linear in the
/// projection, is computed exactly and then rounded, so that what is lost between planes that
/// nearly agree is not lost in the filter that decides from then on.
class DepthComparison {
 public:
  DepthComparison() = default;
  /// Neither plane may be edge-on.
  DepthComparison(const Plane& a, const Plane& b) : a_(a), b_(b) {}
  /// It is ready.
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

  /// The order at a point of the projection, if that takes no exact arithmetic with both planes
  /// now.
  std::optional<int> order_at_hand(const Point2& at) const;

  /// True once more is known than the first filter.
  bool is_ready() const { return hinge_ || difference_; }
  void make_ready();
  /// True if that found that they are one plane.
  bool is_one_plane() const {
    return (hinge_ && hinge_->order_on_left == 0) || (difference_ && difference_->is_zero());
  }

  /// What is known once it is ready: za - zb at (x, y) is x slope_x + y slope_y + constant times
  /// some positive number. Each is off by less than 2^-38 of the largest, which is from 1/2 to 1
  /// unless all are zero. Planes that meet in a line far off the picture have none.
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
    bool is_zero() const;  ///< one plane
    int filtered(const Position& at) const;
    int exact(const PixelCentre& centre) const;
    int exact(const Point2& at) const;

    ExactNumber slope_x, slope_y, constant;
    Linear near;
    /// In whole numbers of 62 bits, if they fit: planes through points of a grid meet where exact
    /// arithmetic alone tells, and most of those grids are coarse.
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
  std::optional<Hinge> hinge_;  // one of the two at most
  std::optional<Difference> difference_;
};

}  // namespace displayfile
