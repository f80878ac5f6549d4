#include "hidden/world_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "hidden/exact_vector.h"
#include "hidden/predicate_counts.h"
#include "hidden/sort_polygons.h"

namespace displayfile {

namespace {

using Index = WorldTree::Index;

/// The plane's value at the eye, or for one at infinity its normal's product with the direction,
/// and the bound: plane_value for both kinds of eye.
PlaneValue value_for(const Point3& p, const Point3& normal, const Point3& bound, const Eye& eye) {
  const Point3 v = eye.at_infinity ? eye.place : eye.place - p;
  return {normal.x * v.x + normal.y * v.y + normal.z * v.z,
          bound.x * std::abs(v.x) + bound.y * std::abs(v.y) + bound.z * std::abs(v.z) + kTiny};
}

/// At most 1 / |normal|, whatever the plane's true normal within the bounds.
double per_length(const Plane& plane) {
  const Point3 most = glm::abs(plane.normal) + plane.bound;
  const double length = glm::length(most);
  return length > 0.0 && length < std::numeric_limits<double>::max() ? 1.0 / (length * kInflate)
                                                                     : 0.0;
}

}  // namespace

WorldTree::WorldTree(const SortItems& world, const SortOptions& options) {
  const Definitions points{world.points, {}};
  if (options.precision.exact) {
    build(world, Exact(points, Exact::Lift::along_facing_axis));
  } else {
    build(world, Roundoff::relative(points, options.precision.roundoff));
  }
}

template <class Policy>
void WorldTree::build(const SortItems& world, const Policy& policy) {
  SortOptions options;
  options.root = RootChoice::sample;
  SortScene scene(world, policy, SortSpace::world);
  SortPolygons sorting(scene, options);
  sorting.sort_all();
  pieces_ = sorted_pieces(scene, sorting.order());
  pieces_.depth = sorting.depth();
  degenerate_ = static_cast<Index>(scene.degenerate.size());
  compact(scene, sorting.root());
}

/// The nodes, numbered front first. Their pieces stand in pieces_ as the sort saved them: what is
/// in back of a node, what is in its plane, what is in front.
template <class Scene>
void WorldTree::compact(const Scene& scene, Index root) {
  const PolygonTable& table = scene.table;
  struct Waiting {
    Index entry, back_of;  // the node that this is in back of, or kNone
  };
  std::vector<Waiting> waiting;
  std::vector<Index> node_of(table.free(), kNone);
  if (root != PolygonTable::kNone) waiting.push_back({root, kNone});
  while (!waiting.empty()) {
    const auto [entry, back_of] = waiting.back();
    waiting.pop_back();
    const auto number = static_cast<Index>(nodes_.size());
    node_of[entry] = number;
    if (back_of != kNone) nodes_[back_of].back = number;
    Node node;
    Plane plane;
    if (table[entry].plane != kNoPlane) {
      plane = scene.vertices.plane(table[entry].plane);
      node.p = plane.p;
      node.normal = plane.normal;
      node.bound = plane.bound;
      node.per_length = per_length(plane);
    }
    node.count = table[entry].sides > 0 ? 1 : 0;
    for (Index i = table[entry].on; i != PolygonTable::kNone; i = table[i].on) ++node.count;
    node.has_front = table[entry].front != PolygonTable::kNone ? 1 : 0;
    nodes_.push_back(node);
    planes_.push_back(plane);
    if (table[entry].back != PolygonTable::kNone) waiting.push_back({table[entry].back, number});
    if (node.has_front) waiting.push_back({table[entry].front, kNone});
  }
  // Where each node's pieces are: the walk of save_polygons_in_order.
  Index first = degenerate_;
  std::vector<Index> path;
  for (Index entry = root; entry != PolygonTable::kNone || !path.empty();) {
    for (; entry != PolygonTable::kNone; entry = table[entry].back) path.push_back(entry);
    entry = path.back();
    path.pop_back();
    Node& node = nodes_[node_of[entry]];
    node.first = first;
    first += node.count;
    entry = table[entry].front;
  }
}

/// Which side of the node's plane the eye is on: 1, -1, or 0 on it, where any order is right.
int WorldTree::side(Index node, const Eye& eye) const {
  const auto [value, bound] =
      value_for(nodes_[node].p, nodes_[node].normal, nodes_[node].bound, eye);
  if (std::abs(value) > bound) [[likely]]
    return decided_sign(value);
  return exact_side(node, eye);
}

int WorldTree::exact_side(Index node, const Eye& eye) const {
  const Plane& plane = planes_[node];
  if (!eye.at_infinity) return exact_side_of_plane(eye.place, plane);
  count_exact(Predicate::side_of_plane);
  const ExactVector normal =
      cross(exact_difference(plane.q, plane.p), exact_difference(plane.r, plane.p));
  return dot(normal, exact_difference(eye.place, Point3(0.0))).sign();
}

/// Algorithm 9.16 as the lecture gives it for an eye on either side. Its recursion is a stack: of
/// the nodes whose far half is being walked, what is left to do.
template <class Visitor>
void WorldTree::walk(bool far_first, const Eye& eye, Visitor&& visit) const {
  struct Rest {
    Index first, count, then;
  };
  std::vector<Rest> path;
  Index at = nodes_.empty() ? kNone : 0;
  while (true) {
    while (at != kNone) {
      const Node& node = nodes_[at];
      const Index front = node.has_front ? at + 1 : kNone;
      if (front == kNone && node.back == kNone) {
        visit(node.first, node.count);
        break;
      }
      const bool front_first = (side(at, eye) < 0) == far_first;
      path.push_back({node.first, node.count, front_first ? node.back : front});
      at = front_first ? front : node.back;
    }
    if (path.empty()) return;
    const auto [first, count, then] = path.back();
    path.pop_back();
    visit(first, count);
    at = then;
  }
}

void WorldTree::far_to_near(const Eye& eye, std::vector<Index>& order) const {
  order.resize(size());
  Index* next = order.data();
  const auto put = [&](Index first, Index end) {
    while (first < end) *next++ = first++;
  };
  put(0, degenerate_);
  walk(true, eye, [&](Index first, Index count) { put(first, first + count); });
}

void WorldTree::near_to_far(const Eye& eye, std::vector<Index>& order) const {
  order.resize(size());
  Index* next = order.data();
  const auto put = [&](Index first, Index end) {
    while (end > first) *next++ = --end;
  };
  walk(false, eye, [&](Index first, Index count) { put(first, first + count); });
  put(0, degenerate_);
}

double WorldTree::far_to_near_until(const Eye& eye, std::vector<Index>& order) const {
  far_to_near(eye, order);
  double nearest = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    if (!node.has_front && node.back == kNone) continue;
    const auto [value, bound] = value_for(node.p, node.normal, node.bound, eye);
    const double distance = (std::abs(value) - bound) * node.per_length;
    nearest = std::min(nearest, distance > 0.0 ? distance * (1.0 - 8.0 * kUnit) : 0.0);
  }
  return nearest;
}

bool MovingEye::is_still_right(const Eye& eye) const {
  if (walks_ == 0 || eye.at_infinity != walked_for_.at_infinity) return false;
  if (eye == walked_for_) return true;
  const Point3 moved = eye.place - walked_for_.place;
  constexpr double kVanishes = 0x1p-500;  // the square of less
  return glm::length(moved) * (1.0 + 16.0 * kUnit) + kVanishes < may_move_;
}

std::span<const WorldTree::Index> MovingEye::far_to_near(const Eye& eye) {
  if (is_still_right(eye)) {
    ++reused_;
  } else {
    may_move_ = tree_->far_to_near_until(eye, order_);
    walked_for_ = eye;
    ++walks_;
  }
  return order_;
}

}  // namespace displayfile
