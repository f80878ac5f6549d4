#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/exact/eye.h"
#include "hidden/exact/plane.h"
#include "hidden/sort/hidden_surface_sort.h"

namespace displayfile {

/// The tree of a scene's polygons in world coordinates, before viewing: built once and traversed
/// for every eye (hidden/sort/world_tree.md).
///
/// The items are as for a sort, but in world coordinates; planes are not oriented to a viewer. A
/// polygon with vertices collinear in space hides nothing, and keeps its outline.
class WorldTree {
 public:
  using Index = std::uint32_t;

  /// The plan sets the precision, the limit of pieces, and the choice of roots: `free` is `sample`
  /// here, since overlaps in a projection belong to one view.
  WorldTree(const Primitives& world, const SurfacePlan& plan, bool names_sides = false);

  /// The pieces to which orders refer, in world coordinates; each item is one piece or more. Their
  /// sequence here has no meaning.
  const SortedPieces& pieces() const { return pieces_; }
  std::size_t size() const { return pieces_.pieces.size(); }

  /// Indices of all pieces, each once: each piece follows those that it hides, for an eye anywhere,
  /// also among the pieces. Coplanar ones are in order of entry, lines last. The eye's coordinates
  /// are up to kCoordinateLimit.
  /// Returns a lower bound on the eye's movement that can change the order: its distance to the
  /// nearest plane. For an eye at infinity, on the movement of the vector's end.
  double far_to_near(const Eye& eye, std::vector<Index>& order) const;

 private:
  /// A x + B y + C z + D w at an eye, with w 0 at infinity and otherwise 1; with a bound on its
  /// error, including that of its coefficients: error_of_normal (|x| + |y| + |z|) + error_of_offset
  /// w.
  struct NodePlane {
    NodePlane() = default;
    explicit NodePlane(const Plane& plane);
    Point3 normal{0.0};
    double offset = 0.0;
    double error_of_normal = 0.0, error_of_offset = 0.0;
    double per_length = 0.0;  // 1 / |normal|, or less
  };
  /// Nodes are stored in the order of a front-first traversal, and pieces in the order of their
  /// nodes. Counts of pieces suffice for navigation.
  struct Node {
    NodePlane plane;
    Index front = 0, back = 0;  // pieces in front of the plane and in back of it
    Index here = 0;             // pieces in the plane
    Index exact_plane = 0;      // index in planes_, unless both sides are empty
    bool is_leaf() const { return front == 0 && back == 0; }
  };
  struct Placed;

  template <class Policy>
  void build(const Primitives& world, const Policy& policy, const SurfacePlan& plan,
             bool names_sides);
  template <class Scene>
  void add_nodes(const Scene& scene, std::span<const Placed> placed);
  template <class Visitor>
  void walk(const Eye& eye, std::vector<Index>& order, const Visitor& visit) const;

  std::vector<Node> nodes_;
  std::vector<Plane> planes_;  // for undecided filters
  Index degenerate_ = 0;       // number of initial, invisible pieces
  SortedPieces pieces_;
};

/// The order of a tree's pieces, far to near, for a moving eye: traverses the tree only when the
/// eye may have crossed a plane.
class MovingEye {
 public:
  /// The tree must outlive this.
  explicit MovingEye(const WorldTree& tree) : tree_(&tree) {}

  /// Valid until the next call.
  std::span<const WorldTree::Index> far_to_near(const Eye& eye);

  std::uint64_t walks() const { return walks_; }
  std::uint64_t reused() const { return reused_; }  ///< calls that needed no walk

 private:
  bool is_still_right(const Eye& eye) const;

  const WorldTree* tree_;
  std::vector<WorldTree::Index> order_;
  Eye walked_for_{Point3(0.0), false};
  double may_move_ = 0.0;
  std::uint64_t walks_ = 0, reused_ = 0;
};

}  // namespace displayfile
