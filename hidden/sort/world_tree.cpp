#include "hidden/sort/world_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "clip/base/budgeted_work.h"
#include "clip/base/work_budget.h"
#include "hidden/sort/sort_polygons.h"

namespace displayfile {

namespace {

using Index = WorldTree::Index;

double sum(const Point3& v) { return v.x + v.y + v.z; }
double dot(const Point3& a, const Point3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double largest(const Point3& v) { return std::max({v.x, v.y, v.z}); }

/// |x| + |y| + |z|, rounded up.
double size_of(const Eye& eye) { return sum(glm::abs(eye.place)) * kInflate; }

/// The polygons in a node's plane, in order of entry, lines last.
template <class Scene>
void add_pieces(const Scene& scene, Index node, std::vector<Index>& pieces) {
  const auto first = static_cast<std::ptrdiff_t>(pieces.size());
  if (scene.table[node].sides > 0) pieces.push_back(node);
  for (Index i = scene.table[node].on; i != PolygonTable::kNone; i = scene.table[i].on) {
    pieces.push_back(i);
  }
  std::ranges::sort(pieces.begin() + first, pieces.end(),
                    [&](Index a, Index b) { return scene.entered_before(a, b); });
}

}  // namespace

/// A node of the tree in the polygon table, and its parent by position.
struct WorldTree::Placed {
  Index entry, parent;
  bool in_front;

  /// The nodes in the order of a front-first traversal.
  static std::vector<Placed> front_first(const PolygonTable& table, Index root) {
    std::vector<Placed> placed, waiting;
    if (root != PolygonTable::kNone) waiting.push_back({root, 0, false});
    while (!waiting.empty()) {
      const Placed next = waiting.back();
      waiting.pop_back();
      const auto place = static_cast<Index>(placed.size());
      placed.push_back(next);
      const auto& entry = table[next.entry];
      if (entry.back != PolygonTable::kNone) waiting.push_back({entry.back, place, false});
      if (entry.front != PolygonTable::kNone) waiting.push_back({entry.front, place, true});
    }
    return placed;
  }
};

/// Bounds are derived in hidden/sort/world_tree.md, "The filter".
WorldTree::NodePlane::NodePlane(const Plane& plane) : normal(plane.normal) {
  const Point3 size = glm::abs(plane.normal), p = glm::abs(plane.p);
  offset = -dot(plane.normal, plane.p);
  error_of_normal = (largest(plane.bound) + 5.0 * kUnit * largest(size)) * kInflate;
  error_of_offset =
      (dot(plane.bound, p) + 5.0 * kUnit * (dot(size, p) + std::abs(offset))) * kInflate + kTiny;
  const double length = glm::length(size + plane.bound);
  const bool usable = length > 0.0 && length < std::numeric_limits<double>::max();
  per_length = usable ? 1.0 / (length * kInflate) : 0.0;
}

WorldTree::WorldTree(const Primitives& world, const SurfacePlan& plan, bool names_sides) {
  const NamedWork named(
      {"the tree of all views", "a hidden-surface method in image space, such as z-buffer"});
  const Definitions points{world.points, {}};
  if (plan.precision.exact) {
    build(world, Exact(points, Exact::Lift::along_facing_axis), plan, names_sides);
  } else {
    build(world, Roundoff::relative(points, plan.precision.roundoff), plan, names_sides);
  }
}

template <class Policy>
void WorldTree::build(const Primitives& world, const Policy& policy, const SurfacePlan& plan,
                      bool names_sides) {
  SurfacePlan of_tree;
  of_tree.root = plan.root == RootChoice::free ? RootChoice::sample : plan.root;
  SortTables scene(world, policy, SortSpace::world);
  scene.table.most_entries = most_pieces_of_sort(plan, world.items.size());
  SortPolygons sorting(scene, of_tree);
  sorting.sort_all();
  const std::vector<Placed> placed = Placed::front_first(scene.table, sorting.root());
  add_nodes(scene, placed);
  std::vector<Index> pieces;
  pieces.reserve(sorting.order().size());
  for (const Placed& node : placed) add_pieces(scene, node.entry, pieces);
  pieces_ = sorted_pieces(scene, pieces, names_sides);
  pieces_.depth = sorting.depth();
  degenerate_ = static_cast<Index>(scene.degenerate.size());
}

template <class Scene>
void WorldTree::add_nodes(const Scene& scene, std::span<const Placed> placed) {
  nodes_.resize(placed.size());
  std::vector<Index> pieces;
  for (std::size_t i = placed.size(); i-- > 0;) {  // children follow their parents
    const auto& entry = scene.table[placed[i].entry];
    Node& node = nodes_[i];
    pieces.clear();
    add_pieces(scene, placed[i].entry, pieces);
    node.here = static_cast<Index>(pieces.size());
    if (!node.is_leaf()) {
      const Plane plane =  // no plane if the branches need no order
          entry.plane == kNoPlane ? Plane() : scene.vertices.plane(entry.plane);
      node.plane = NodePlane(plane);
      node.exact_plane = static_cast<Index>(planes_.size());
      planes_.push_back(plane);
    }
    if (i == 0) break;
    assert(placed[i].parent < i);
    Node& parent = nodes_[placed[i].parent];
    (placed[i].in_front ? parent.front : parent.back) += node.front + node.here + node.back;
  }
}

/// Algorithm 9.16 in the lecture's form, for an eye on either side. The pieces of a subtree are
/// consecutive in the order, and where they begin is known when its root is reached: so nodes are
/// visited in stored order, whatever the eye, without recursion. `visit` gets each node with its
/// plane's value at the eye and a bound on the value's error.
template <class Visitor>
void WorldTree::walk(const Eye& eye, std::vector<Index>& order, const Visitor& visit) const {
  order.resize(size());
  const double size = size_of(eye), w = eye.at_infinity ? 0.0 : 1.0;
  const auto put = [&](Index at, Index first, Index count) {
    for (Index k = 0; k < count; ++k) order[at + k] = first + k;
  };
  put(0, 0, degenerate_);
  std::vector<Index> begins(pieces_.depth + 2);  // of pending trees in back of nodes
  std::size_t waiting = 1;                       // the first is unused
  Index begin = degenerate_, first = degenerate_;
  for (const Node& node : nodes_) {
    const NodePlane& plane = node.plane;
    const double value = dot(plane.normal, eye.place) + plane.offset * w;
    const double error = plane.error_of_normal * size + plane.error_of_offset * w;
    bool eye_in_front = value > 0.0;
    if (!(std::abs(value) > error) && !node.is_leaf()) [[unlikely]] {
      eye_in_front = side_of_plane(eye, planes_[node.exact_plane]) >= 0;
    }
    visit(node, value, error);
    const Index at = begin + (eye_in_front ? node.back : node.front);
    put(at, first, node.here);
    first += node.here;
    const Index after = at + node.here;
    const Index begin_of_front = eye_in_front ? after : begin;
    const Index begin_of_back = eye_in_front ? begin : after;
    // The nodes in front follow in storage; if there are none, those in back of the last node that
    // has any pending.
    assert(waiting < begins.size());
    begins[waiting] = begin_of_back;
    waiting += node.back != 0 ? 1 : 0;
    const bool has_front = node.front != 0;
    assert(has_front || waiting > 0);
    waiting -= has_front ? 0 : 1;
    begin = has_front ? begin_of_front : begins[waiting];
  }
  assert(first == order.size() && (nodes_.empty() || waiting == 0));
}

double WorldTree::far_to_near(const Eye& eye, std::vector<Index>& order) const {
  double nearest = std::numeric_limits<double>::infinity();
  walk(eye, order, [&](const Node& node, double value, double error) {
    if (node.is_leaf()) return;
    const double distance = (std::abs(value) - error) * node.plane.per_length;
    nearest = std::min(nearest, std::max(distance, 0.0));
  });
  return nearest * (1.0 - 16.0 * kUnit);
}

bool MovingEye::is_still_right(const Eye& eye) const {
  if (walks_ == 0 || eye.at_infinity != walked_for_.at_infinity) return false;
  if (eye == walked_for_) return true;
  const Point3 moved = eye.place - walked_for_.place;
  constexpr double kVanishes = 0x1p-500;  // squares of smaller numbers may underflow
  return glm::length(moved) * (1.0 + 16.0 * kUnit) + kVanishes < may_move_;
}

std::span<const WorldTree::Index> MovingEye::far_to_near(const Eye& eye) {
  if (is_still_right(eye)) {
    ++reused_;
  } else {
    may_move_ = tree_->far_to_near(eye, order_);
    walked_for_ = eye;
    ++walks_;
  }
  return order_;
}

}  // namespace displayfile
