#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "clip/point.h"
#include "hidden/hidden_surface_sort.h"
#include "hidden/plane.h"

namespace displayfile {

/// From where a scene is seen, in world coordinates.
struct Eye {
  /// The centre of a perspective projection.
  static Eye at(const Point3& centre) { return {centre, false}; }
  /// A parallel projection: any vector toward the viewer, not zero.
  static Eye toward(const Point3& direction) { return {direction, true}; }

  Point3 place;
  bool at_infinity;
  bool operator==(const Eye&) const = default;
};

/// The tree of a scene's polygons in world coordinates, before viewing: built once and walked for
/// every eye (hidden/world_tree.md).
///
/// The items are those of a sort, but in world coordinates; no item's plane has a side that is the
/// viewer's. A polygon whose vertices are in line in space hides nothing, and keeps its outline.
class WorldTree {
 public:
  using Index = std::uint32_t;

  /// Of the options the precision; the root is chosen by RootChoice::sample, since overlaps in a
  /// projection belong to one view.
  WorldTree(const SortItems& world, const SortOptions& options);

  /// The pieces that the orders are of, in world coordinates; each item is one piece or more. The
  /// order in which they stand here has no meaning.
  const SortedPieces& pieces() const { return pieces_; }
  std::size_t size() const { return pieces_.pieces.size(); }

  /// Indices of all pieces, each once: what hides comes after what it hides, for an eye anywhere,
  /// also among the pieces. Coplanar ones are in order of entry, lines last.
  void far_to_near(const Eye& eye, std::vector<Index>& order) const;
  /// The reverse.
  void near_to_far(const Eye& eye, std::vector<Index>& order) const;

  /// The same, and how far the eye may move, at the least, before the order can change: until it
  /// comes to the nearest plane. Of an eye at infinity the vector's end may move that far.
  double far_to_near_until(const Eye& eye, std::vector<Index>& order) const;

 private:
  /// In the order of a walk that takes the front first.
  struct Node {
    Point3 p{0.0}, normal{0.0}, bound{0.0};  // as in Plane
    double per_length = 0.0;                 // 1 / |normal|, or less
    Index back = kNone;                      // the front is the next node, if there is one
    Index first = 0;                         // piece
    Index count : 31 = 0;                    // of pieces in the plane
    Index has_front : 1 = 0;
  };
  static constexpr Index kNone = std::numeric_limits<Index>::max();

  template <class Policy>
  void build(const SortItems& world, const Policy& policy);
  template <class Scene>
  void compact(const Scene& scene, Index root);
  int side(Index node, const Eye& eye) const;
  int exact_side(Index node, const Eye& eye) const;
  template <class Visitor>
  void walk(bool far_first, const Eye& eye, Visitor&& visit) const;

  std::vector<Node> nodes_;
  std::vector<Plane> planes_;  // of the nodes, for what the filter leaves undecided
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
