#include "tests/bench/lines_beside_peers/degenerate_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <utility>
#include <vector>

#include "programs/scenes/random.h"

namespace displayfile::bench {

namespace {

/// A mesh of parts that share no vertices.
class Parts {
 public:
  Parts() { mesh_.first_corner = {0}; }

  Parts& face(std::initializer_list<Point3> corners) {
    for (const Point3& p : corners) {
      mesh_.corners.push_back(static_cast<std::uint32_t>(mesh_.vertices.size()));
      mesh_.vertices.push_back(p);
    }
    mesh_.first_corner.push_back(mesh_.corners.size());
    return *this;
  }

  /// A box from one corner to the opposite one, its faces turned out.
  Parts& box(const Point3& low, const Point3& high) {
    std::vector<Point3> corners;
    corners.reserve(8);
    for (int k = 0; k < 8; ++k) {
      corners.emplace_back((k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                           (k & 4) != 0 ? high.z : low.z);
    }
    return solid(
        corners,
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  }

  /// Over a square in z = base, the side length 2 `half` around a middle.
  Parts& pyramid(const Point3& middle, double half, const Point3& apex) {
    std::vector<Point3> corners{middle + half * Point3(-1, -1, 0), middle + half * Point3(1, -1, 0),
                                middle + half * Point3(1, 1, 0), middle + half * Point3(-1, 1, 0),
                                apex};
    return solid(corners, {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  }

  /// The faces are turned out if they are all turned in.
  Parts& solid(std::span<const Point3> corners,
               std::initializer_list<std::initializer_list<std::uint32_t>> faces) {
    double volume = 0.0;
    for (const auto& face : faces) {
      const std::span<const std::uint32_t> of(face.begin(), face.size());
      for (std::size_t k = 2; k < of.size(); ++k) {
        volume += glm::dot(corners[of[0]], glm::cross(corners[of[k - 1]], corners[of[k]]));
      }
    }
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.insert(mesh_.vertices.end(), corners.begin(), corners.end());
    for (const auto& face : faces) {
      const std::size_t begin = mesh_.corners.size();
      for (const std::uint32_t corner : face) mesh_.corners.push_back(first + corner);
      if (volume < 0.0) {
        std::reverse(mesh_.corners.begin() + static_cast<std::ptrdiff_t>(begin),
                     mesh_.corners.end());
      }
      mesh_.first_corner.push_back(mesh_.corners.size());
    }
    return *this;
  }

  Mesh mesh() const { return mesh_; }

 private:
  Mesh mesh_;
};

/// Along the z axis, after a shear along it, so much to the right and up a unit of z: an aside look
/// in which no coordinate is rounded. The view's window and depth are powers of two, so that points
/// that coincide in the world do so in the display file.
PeerScene seen(const Parts& parts, const Point2& shear) {
  PeerScene scene;
  scene.mesh = parts.mesh();
  double largest = 0.0;
  for (Point3& p : scene.mesh.vertices) {
    p += Point3(p.z * shear, 0.0);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  const double half = std::exp2(std::floor(std::log2(largest)) + 1.0);
  scene.view.set_window({-half, half, -half, half});
  scene.view.set_depth(-half, half);
  return scene;
}
constexpr Point2 kFront(0.0), kAside(-0.5, -0.25), kAbove(-0.125, 0.5);

PeerScene cube() { return seen(Parts().box({-1, -1, -1}, {1, 1, 1}), kFront); }

/// 27 unit cubes that touch, as a draughtsman looks at them.
Parts stack() {
  Parts parts;
  for (int k = 0; k < 27; ++k) {
    const Point3 low(k % 3, k / 3 % 3, k / 9);
    parts.box(low, low + 1.0);
  }
  return parts;
}
PeerScene stack_from_front() { return seen(stack(), kFront); }
PeerScene stack_from_aside() { return seen(stack(), kAside); }

PeerScene touching_boxes() {
  return seen(Parts().box({0, 0, 0}, {2, 1, 1}).box({2, 0, 0}, {3, 2, 1}).box({0, 1, 0}, {2, 2, 1}),
              kAside);
}

/// Part of a face of each body lies in a face of another.
PeerScene coplanar_faces() {
  return seen(
      Parts().box({0, 0, 0}, {3, 2, 1}).box({1, 1, -1}, {4, 3, 1}).box({2, -1, -2}, {3, 2.5, 1}),
      kAside);
}

/// Sheets of two rectangles behind one another: the middle edges of all are one in the picture.
PeerScene edges_behind_shared_edges() {
  Parts parts;
  for (int k = 0; k < 5; ++k) {
    const double z = -k;
    const std::vector<Point3> corners{{-2, -1, z}, {0, -1, z}, {2, -1, z},
                                      {2, 1, z},   {0, 1, z},  {-2, 1, z}};
    parts.solid(corners, {{0, 1, 4, 5}, {1, 2, 3, 4}});
  }
  parts.box({-1, -0.5, -7}, {0, 0.5, -6});
  return seen(parts, kFront);
}

PeerScene interpenetrating_boxes() {
  return seen(Parts()
                  .box({-3, -1, -1}, {3, 1, 1})
                  .box({-1, -3, -0.5}, {1, 3, 0.5})
                  .box({-0.5, -0.5, -3}, {0.5, 0.5, 3}),
              kAside);
}

/// Three bars, each over the next.
PeerScene cyclic_overlap() {
  const auto bar = [](Parts& parts, const Point3& from, const Point3& to, const Point3& across) {
    const Point3 down(0, 0, -0.25);
    const std::vector<Point3> corners{from, from + across, from + down, from + across + down,
                                      to,   to + across,   to + down,   to + across + down};
    parts.solid(
        corners,
        {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}});
  };
  Parts parts;
  bar(parts, {-3, -2, 0}, {3, -2, 1}, {0, 1, 0});
  bar(parts, {1, -3, 0}, {1, 3, 1}, {1, 0, 0});
  bar(parts, {3, 1, 0}, {-3, 1, 1}, {0, 1, 0});
  bar(parts, {-2, 3, 0}, {-2, -3, 1}, {1, 0, 0});
  return seen(parts, kFront);
}

/// Triangles ten thousand times as long as wide, over one another.
PeerScene needles() {
  Parts parts;
  for (int k = 0; k < 40; ++k) {
    const double z = k / 64.0, x = k / 8.0 - 2.5;
    parts.face({{x, -4, z}, {x + 1.0 / 1024, -4, z}, {-x + 0.25, 4, 1.0 - z}});
    parts.face({{-4, x, z}, {4, -x, 1.0 - z}, {4, 1.0 / 1024 - x, 1.0 - z}});
  }
  return seen(parts, kFront);
}

/// Pyramids whose tips touch the face before them, or which stand on it.
PeerScene touching_tips() {
  Parts parts;
  parts.box({-3, -3, 0}, {3, 3, 1});
  parts.pyramid({-1, -1, 1}, 0.5, {-1, -1, 2});
  parts.pyramid({1, 1, 2}, 0.5, {1, 1, 1});
  parts.pyramid({2.5, -2.5, 1}, 0.5, {2.5, -2.5, 3});
  parts.pyramid({-2, 2, 3}, 1.0, {-3, 3, 1});
  return seen(parts, kAbove);
}

/// Faces that lie in the face of a box: of equal depth.
PeerScene decals() {
  Parts parts;
  parts.box({-2, -2, -2}, {2, 2, 2});
  parts.face({{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}});
  parts.face({{0, 0, 2}, {2, 0, 2}, {2, 1.5, 2}, {0, 1.5, 2}});
  parts.face({{2, -1, 1}, {2, -1, -1}, {2, 1, -1}, {2, 1, 1}});
  return seen(parts, kAside);
}

/// A point of whole coordinates, from 0 to one less than the end.
Point3 grid_point(Random& random, std::size_t end) {
  const auto x = random.below(end), y = random.below(end), z = random.below(end);
  return Point3(x, y, z);
}

/// Sheets close behind one another: by a millionth of their size, and two that cross at as small an
/// angle.
PeerScene thin_sheets() {
  Parts parts;
  constexpr double kGap = 0x1p-18;
  for (int k = 0; k < 16; ++k) {
    const double x = -2.0 + k % 4, y = -2.0 + k / 4 % 4, z = kGap * k;
    parts.face({{x, y, z}, {x + 1.5, y, z}, {x + 1.5, y + 1.5, z}, {x, y + 1.5, z}});
  }
  for (const double way : {1.0, -1.0}) {
    const double z = 32.0 * kGap;
    parts.face({{-1, -1, z - way * kGap},
                {1, -1, z + way * kGap},
                {1, way, z + way * kGap},
                {-1, way, z - way * kGap}});
  }
  return seen(parts, kFront);
}

/// Boxes whose corners are whole: they touch, overlap, interpenetrate and lie in each other's
/// faces.
Parts boxes_on_a_grid() {
  Parts parts;
  Random random(1);
  for (int k = 0; k < 60; ++k) {
    const Point3 low = grid_point(random, 7);
    parts.box(low, low + 1.0 + grid_point(random, 3));
  }
  return parts;
}
PeerScene boxes_from_front() { return seen(boxes_on_a_grid(), kFront); }
PeerScene boxes_from_aside() { return seen(boxes_on_a_grid(), kAside); }

PeerScene triangles_on_a_grid() {
  Parts parts;
  Random random(1);
  for (int k = 0; k < 100;) {
    const Point3 p = grid_point(random, 9), q = grid_point(random, 9), r = grid_point(random, 9);
    if (glm::cross(q - p, r - p) == Point3(0.0)) continue;
    parts.face({p, q, r});
    ++k;
  }
  return seen(parts, kFront);
}

/// Touching boxes and a cyclic overlap's bars, scaled.
PeerScene scaled(double scale) {
  Parts parts;
  for (const auto& [low, high] :
       std::initializer_list<std::pair<Point3, Point3>>{{{0, 0, 0}, {2, 1, 1}},
                                                        {{2, 0, 0}, {3, 2, 1}},
                                                        {{0, 1, 0}, {2, 2, 1}},
                                                        {{0.5, 0.5, 1}, {2.5, 1.5, 1.25}},
                                                        {{-1, 0.75, 0.25}, {4, 1.25, 0.75}}}) {
    parts.box(scale * low, scale * high);
  }
  return seen(parts, kAside);
}
PeerScene tiny() { return scaled(0x1p-20); }
PeerScene huge() { return scaled(0x1p20); }

constexpr std::array<DegenerateMesh, 17> kMeshes{{
    {"cube", "a cube along an axis", cube},
    {"stack, front", "27 cubes that touch, along an axis", stack_from_front},
    {"stack, aside", "the same from aside", stack_from_aside},
    {"touching boxes", "faces that coincide", touching_boxes},
    {"coplanar faces", "boxes with faces in one plane", coplanar_faces},
    {"behind shared edges", "edges right behind edges that polygons share",
     edges_behind_shared_edges},
    {"interpenetrating", "boxes through one another", interpenetrating_boxes},
    {"cyclic overlap", "four bars, each over the next", cyclic_overlap},
    {"needles", "triangles 8,000 times as long as wide", needles},
    {"touching tips", "pyramids whose tips touch a face, or stand on it", touching_tips},
    {"decals", "faces in a box's faces", decals},
    {"thin sheets", "sheets a 2^-20 of the picture apart, two that cross", thin_sheets},
    {"boxes, front", "60 boxes with whole corners, along an axis", boxes_from_front},
    {"boxes, aside", "the same from aside", boxes_from_aside},
    {"triangles", "100 triangles with whole corners", triangles_on_a_grid},
    {"tiny", "boxes that touch and interpenetrate, 2^-20 as large", tiny},
    {"huge", "the same, 2^20 as large", huge},
}};

}  // namespace

std::span<const DegenerateMesh> degenerate_meshes() { return kMeshes; }

}  // namespace displayfile::bench
