#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "clip/point.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/primitives.h"

namespace displayfile {

/// A line of a picture: the side of a polygon that ends at the vertex `corner` and starts at the
/// vertex before it (before number 0 is the last); or an entered line, whose corner is 1, its end.
/// Items count from 0 in order of entry, as in LineItems.
struct LineId {
  std::uint32_t item, corner;
  auto operator<=>(const LineId&) const = default;
};

/// The polygons and lines of a picture for the truth of lines: the entered primitives of the
/// visible segments in order of creation, in device coordinates after the image transformation.
/// Invisible items, hollow polygons and lines with line style none, are omitted. Found by separate
/// code.
class LineItems {
 public:
  /// Throws Error for a coordinate that is not finite.
  explicit LineItems(const DisplayFile& display_file);

  enum class Kind : std::uint8_t { solid, hollow, line };

  std::uint32_t size() const { return static_cast<std::uint32_t>(items_.size()); }
  Kind kind(std::uint32_t item) const { return items_[item].kind; }
  std::span<const Point3> points(std::uint32_t item) const {
    return std::span(points_).subspan(items_[item].first, items_[item].points);
  }

  /// Three points of the plane that a polygon shares with others as they were entered; null if it
  /// shares none.
  const std::array<Point3, 3>* shared_plane(std::uint32_t item) const {
    return plane_of_.empty() || plane_of_[item] == kNoPlane ? nullptr : &planes_[plane_of_[item]];
  }

  /// As Primitives::plane_rest.
  Point3 plane_rest(std::uint32_t item) const { return primitives_.plane_rest(item); }

  /// True if two polygons share one.
  bool share_plane(std::uint32_t a, std::uint32_t b) const {
    return !plane_of_.empty() && shared_plane(a) != nullptr && shared_plane(b) != nullptr &&
           *shared_plane(a) == *shared_plane(b);
  }
  /// As LineTable::touching.
  double touching() const {
    if (primitives_.ends == nullptr || primitives_.touching > 0.0) return primitives_.touching;
    return std::numeric_limits<double>::infinity();
  }
  double rounding() const { return primitives_.rounding; }
  bool some_touch() const { return touching() > 0.0; }
  /// The positions of the line's ends, as entered, relative to the polygon's plane.
  EndsAsEntered::Places places(LineId line, std::uint32_t item) const {
    return primitives_.places(line.item, line.corner, item);
  }

  /// True if there is such a line, drawn or not.
  bool contains(LineId line) const;
  const Point3& from(LineId line) const;
  const Point3& to(LineId line) const { return points(line.item)[line.corner]; }

  std::vector<LineId> all_lines() const;    ///< every side whatever its style, and every line
  std::vector<LineId> drawn_lines() const;  ///< those that are drawn

  /// Sides that are one line, because polygons share it: their ends are the same points, in either
  /// direction. In order; a line that is not shared stands alone, as does an entered line.
  using Sharers = std::vector<LineId>;
  /// The given lines, each with all that share it, given or not; in order of the first sharer.
  /// Throws Error for a line that does not exist.
  std::vector<Sharers> shared(std::span<const LineId> lines) const;

 private:
  struct Walk;
  struct Item {
    std::size_t first;     // of its points
    std::uint32_t points;  // how many
    Kind kind;
  };
  static constexpr std::uint32_t kNoPlane = 0xffffffffu;
  void take_planes(const DisplayFile& display_file);
  std::vector<Item> items_;
  std::vector<std::array<Point3, 3>> planes_;
  std::shared_ptr<const ViewedScene> scene_;
  Primitives primitives_;                // its
  std::vector<std::uint32_t> plane_of_;  // of the items, in planes_; empty: none share one
  std::vector<Point3> points_;
  std::vector<std::uint8_t> drawn_;  // of the points: the line that ends there is drawn
};

}  // namespace displayfile
