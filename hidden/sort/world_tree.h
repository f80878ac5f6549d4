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

/// The tree of a scene's polygons in world coordinates, before viewing: built once and walked for
/// every eye (hidden/sort/world_tree.md).
///
/// The items are those of a sort, but in world coordinates; no item's plane has a side that is the
/// viewer's. A polygon whose vertices are in line in space hides nothing, and keeps its outline.
class WorldTree {
 public:
  using Index = std::uint32_t;

  /// The plan gives the precision, how many pieces there may be, and how a root is chosen: `free`
  /// is `sample` here, since overlaps in a projection belong to one view.
  WorldTree(const Primitives& world, const SurfacePlan& plan, bool names_sides = false);

  /// The pieces that the orders are of, in world coordinates; each item is one piece or more. The
  /// order in which they stand here has no meaning.
  const SortedPieces& pieces() const { return pieces_; }
  std::size_t size() const { return pieces_.pieces.size(); }

  /// Indices of all pieces, each once: what hides comes after what it hides, for an eye anywhere,
  /// also among the pieces. Coplanar ones are in order of entry, lines last. The eye's coordinates
  /// are up to kCoordinateLimit.
  void far_to_near(const Eye& eye, std::vector<Index>& order) const;
  /// The reverse of what far_to_near gives.
  void near_to_far(const Eye& eye, std::vector<Index>& order) const;

  /// Does what far_to_near does, and returns how far the eye may move, at the least, before the
  /// order can change: until it comes to the nearest plane. If the eye is at infinity, the vector's
  /// end may move that far.
  double far_to_near_until(const Eye& eye, std::vector<Index>& order) const;

 private:
  /// A x + B y + C z + D w at an eye, w being 0 at infinity and otherwise 1; with a bound of its
  /// error, and of that of the doubles that it is made of: error_of_normal (|x| + |y| + |z|)
  /// + error_of_offset w.
  struct NodePlane {
    NodePlane() = default;
    explicit NodePlane(const Plane& plane);
    Point3 normal{0.0};
    double offset = 0.0;
    double error_of_normal = 0.0, error_of_offset = 0.0;
    double per_length = 0.0;  // 1 / |normal|, or less
  };
  /// Nodes stand in the order of a walk that takes the front first, and pieces in the order of
  /// their nodes. Numbers of pieces are all that it takes to find one's way.
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
  template <bool far_first, class Visitor>
  void walk(const Eye& eye, std::vector<Index>& order, const Visitor& visit) const;

  std::vector<Node> nodes_;
  std::vector<Plane> planes_;  // for what the filter leaves undecided
  Index degenerate_ = 0;       // the first pieces, of which nothing is seen
  SortedPieces pieces_;
};

/// The order of a tree's pieces, far to near, for an eye that moves: walks the tree only when the
/// eye may have crossed a plane.
class MovingEye {
 public:
  /// The tree must stay.
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
