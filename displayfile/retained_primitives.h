#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "displayfile/retained_scene.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The polygons and lines of the retained segments that share a tree, in order of entry and in
/// world coordinates; those of them that draw something are the items of its sort.
class RetainedPrimitives {
 public:
  using Attributes = RetainedScene::Attributes;

  struct Segment {
    int name;
    std::size_t end;  ///< of its primitives
    std::vector<Attributes> attributes;
  };

  /// Throws Error if there are more than 2^32 - 2 points then.
  void add(const RetainedScene::Segment& segment);

  std::size_t size() const { return primitives_.size(); }
  const RetainedScene::Primitive& operator[](std::size_t i) const { return primitives_[i]; }
  std::span<const Point3> points(std::size_t i) const {
    return std::span(points_).subspan(primitives_[i].first, primitives_[i].sides);
  }
  std::span<const std::uint8_t> edge_visible(std::size_t i) const {
    return std::span(edge_visible_).subspan(primitives_[i].first, primitives_[i].sides);
  }
  /// Empty unless the polygon is shaded smoothly.
  std::span<const Point3> vertex_normals(std::size_t i) const {
    const std::size_t first = primitives_[i].first, end = first + primitives_[i].sides;
    if (end > vertex_normals_.size() || vertex_normals_[first] == Point3(0.0)) return {};
    return std::span(vertex_normals_).subspan(first, primitives_[i].sides);
  }
  const Attributes& attributes(std::size_t i) const {
    return segments_[segment_of_[i]].attributes[primitives_[i].attributes];
  }
  const std::vector<Segment>& segments() const { return segments_; }
  int segment_name(std::size_t i) const { return segments_[segment_of_[i]].name; }

  SortItems items() const { return {points_, edge_visible_, items_}; }
  std::uint32_t primitive_of(std::uint32_t item) const { return primitive_of_[item]; }

  /// How far a vertex lies from the plane that the tree takes the polygon to be in, at most: a
  /// polygon of more than three sides counts as flat within a tolerance (clip/planarity.h).
  double off_plane(std::size_t i) const { return off_plane_[i]; }

 private:
  std::vector<Point3> points_;
  std::vector<std::uint8_t> edge_visible_;
  std::vector<Point3> vertex_normals_;  // up to those of the last polygon that has some
  std::vector<RetainedScene::Primitive> primitives_;  // points counted over all segments
  std::vector<std::uint32_t> segment_of_;             // the primitives' segments
  std::vector<Segment> segments_;
  std::vector<SortItems::Item> items_;
  std::vector<std::uint32_t> primitive_of_;  // the items' primitives
  std::vector<double> off_plane_;            // of the primitives
};

}  // namespace displayfile
