// The tree in world coordinates by itself: its orders, compared with rays in rational arithmetic.

#include "hidden/sort/world_tree.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "hidden/exact/support_plane.h"
#include "tests/predicate_truth.h"
#include "tests/random_views.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using test::ItemList;
using test::Q;
using test::QPlane;
using test::QPoint;
using test::Source;
using Index = WorldTree::Index;
using Order = std::vector<Index>;

WorldTree tree_of(const ItemList& list) { return {list.view(), {}}; }

Order far_to_near(const WorldTree& tree, const Eye& eye) {
  Order order;
  tree.far_to_near(eye, order);
  return order;
}

Eye any_eye(Source& s) {
  const Point3 away = test::any_direction(s);
  switch (s.below(3)) {
    case 0: return Eye::toward((0.1 + 3.0 * s.unit()) * away);
    case 1: return Eye::at(Point3(0.5) + 3.0 * away);
    default: return Eye::at(test::in_cube(s));
  }
}

std::string text_of(const Eye& eye) {
  std::ostringstream out;
  out.precision(17);
  out << (eye.at_infinity ? "eye toward " : "eye at ") << eye.place.x << " " << eye.place.y << " "
      << eye.place.z;
  return out.str();
}

// ---- The judge ---------------------------------------------------------------------------

/// The cube that contains the scene, and the distance from a side at which doubles still decide.
struct Cube {
  Point3 low{0.0};
  double side = 1.0, near = 1e-9;
};

/// Rays from an eye: pieces that a ray meets nearer to the eye must come later. Depths are
/// rationals; whether a ray meets a piece is a matter of doubles, because none that passes near a
/// side counts.
class Judge {
 public:
  Judge(const ItemList& list, const WorldTree& tree, const Cube& cube = Cube())
      : list_(list), tree_(tree), cube_(cube) {
    for (std::size_t i = 0; i < list.items.size(); ++i) planes_.push_back(plane_of(i));
  }

  /// Describes an error in the order along a random ray; "" if there is none.
  std::string along_any_ray(Source& s, const Eye& eye, std::span<const Index> order) {
    // From the eye, or toward an eye at infinity.
    const Point3 aim = cube_.low + cube_.side * test::in_cube(s);
    const Point3 from = eye.at_infinity ? aim + eye.place : eye.place;
    const Point3 along = eye.at_infinity ? -eye.place : aim - eye.place;
    if (along == Point3(0.0)) return "";
    std::vector<Met> met;
    std::vector<int> met_of(list_.items.size(), 0);
    for (const Index i : order) {
      const std::uint32_t item = tree_.pieces().pieces[i].item;
      if (list_.items[item].kind != ItemList::Kind::solid || !planes_[item]) continue;
      const auto t = meets(*planes_[item], from, along, eye.at_infinity);
      if (!t) continue;
      const Point3 at = from + t->get_d() * along;
      const std::optional<bool> covered = covers(points_of(i), planes_[item]->facing, at);
      if (!covered) return "";  // too near a side to decide
      if (!*covered) continue;
      met.push_back({item, *t});
      ++met_of[item];
      const auto whole = covers(list_.points_of(item), planes_[item]->facing, at);
      if (!whole) return "";
      if (!*whole) return "a piece of item " + std::to_string(item) + " is outside of it";
    }
    meetings += met.size();
    for (std::size_t i = 0; i < met_of.size(); ++i) {
      if (met_of[i] > 1) return "pieces of item " + std::to_string(i) + " overlap";
    }
    for (std::size_t k = 1; k < met.size(); ++k) {
      const bool tie = met[k].t == met[k - 1].t;
      if (tie ? met[k].item < met[k - 1].item : met[k].t > met[k - 1].t) {
        return "item " + std::to_string(met[k].item) + " hides item " +
               std::to_string(met[k - 1].item) + " wrongly";
      }
    }
    return "";
  }

  std::size_t meetings = 0;

 private:
  struct Met {
    std::uint32_t item;
    Q t;  // the distance along the ray
  };
  struct FacedPlane {
    QPlane plane;
    int facing;
  };

  static QPoint rational(const Point3& p) { return {Q(p.x), Q(p.y), Q(p.z)}; }

  std::optional<FacedPlane> plane_of(std::size_t item) const {
    const auto points = list_.points_of(item);
    const SupportVertices support = spread_vertices(points);
    if (points.size() < 3 || support.edge_on) return std::nullopt;
    const auto& [p, q, r] = support.index;
    return FacedPlane{QPlane(rational(points[p]), rational(points[q]), rational(points[r])),
                      facing_axis(Plane(points[p], points[q], points[r]))};
  }

  static std::optional<Q> meets(const FacedPlane& plane, const Point3& from, const Point3& along,
                                bool all_of_line) {
    const QPlane& h = plane.plane;
    const Q rise = h.a * Q(along.x) + h.b * Q(along.y) + h.c * Q(along.z);
    if (rise == 0) return std::nullopt;
    const Q t = -h.at(rational(from)) / rise;
    if (!all_of_line && t <= 0) return std::nullopt;
    return t;
  }

  std::span<const Point3> points_of(Index i) const {
    const SortedPiece& piece = tree_.pieces().pieces[i];
    if (piece.first == SortedPiece::kWhole) return list_.points_of(piece.item);
    return std::span(tree_.pieces().points).subspan(piece.first, piece.sides);
  }

  /// Seen along an axis, by the even-odd rule; nothing near a side.
  std::optional<bool> covers(std::span<const Point3> loop, int axis, const Point3& at) const {
    const auto flat = [&](const Point3& p) { return Point2(p[(axis + 1) % 3], p[(axis + 2) % 3]); };
    const Point2 p = flat(at);
    bool inside = false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Point2 a = flat(loop[k == 0 ? loop.size() - 1 : k - 1]), b = flat(loop[k]);
      const Point2 side = b - a;
      const double length = glm::dot(side, side);
      const double t = length == 0.0 ? 0.0 : std::clamp(glm::dot(p - a, side) / length, 0.0, 1.0);
      if (!(glm::length(a + t * side - p) > cube_.near)) return std::nullopt;
      if ((a.y <= p.y) != (b.y <= p.y) && a.x + (p.y - a.y) / side.y * side.x > p.x) {
        inside = !inside;
      }
    }
    return inside;
  }

  const ItemList& list_;
  const WorldTree& tree_;
  Cube cube_;
  std::vector<std::optional<FacedPlane>> planes_;
};

void expect_all_pieces_once(const WorldTree& tree, const ItemList& list, const Order& order) {
  Order sorted = order;
  std::ranges::sort(sorted);
  Order all(tree.size());
  std::iota(all.begin(), all.end(), Index{0});
  ASSERT_EQ(sorted, all);
  std::vector<bool> seen(list.items.size(), false);
  for (const SortedPiece& piece : tree.pieces().pieces) seen[piece.item] = true;
  EXPECT_EQ(std::ranges::count(seen, false), 0) << "an item was lost";
}

// ---- Orders ------------------------------------------------------------------------------

TEST(WorldTree, OrdersAreRightForAnyEye) {
  std::size_t meetings = 0;
  for (const test::SortFamily& family : test::sort_families()) {
    for (std::uint64_t seed = 1; seed <= 20 / test::kSlower; ++seed) {
      Source s(seed);
      const ItemList list = family.make(s);
      const WorldTree tree = tree_of(list);
      Judge judge(list, tree);
      for (int k = 0; k < 6; ++k) {
        const Eye eye = any_eye(s);
        const Order order = far_to_near(tree, eye);
        expect_all_pieces_once(tree, list, order);
        for (int ray = 0; ray < 20; ++ray) {
          ASSERT_EQ(judge.along_any_ray(s, eye, order), "")
              << family.name << ", seed " << seed << "\n"
              << text_of(eye) << "\n"
              << list.text();
        }
      }
      meetings += judge.meetings;
    }
  }
  EXPECT_GT(meetings, 10'000u / test::kSlower) << "the rays miss the polygons";
}

/// On the planes of polygons, at their vertices and on their sides.
TEST(WorldTree, OrdersAreRightForEyesOnPlanes) {
  for (std::uint64_t seed = 1; seed <= 60 / test::kSlower; ++seed) {
    Source s(seed);
    const ItemList list = seed % 2 == 0 ? test::families::dyadic(s) : test::families::tiny_grid(s);
    const WorldTree tree = tree_of(list);
    Judge judge(list, tree);
    for (const Point3& p : list.points) {
      const Point3& q =
          list.points[static_cast<std::size_t>(s.below(static_cast<int>(list.points.size())))];
      for (const Eye& eye : {Eye::at(p), Eye::at(0.5 * (p + q)), Eye::toward(p - q)}) {
        if (eye.at_infinity && p == q) continue;
        const Order order = far_to_near(tree, eye);
        for (int ray = 0; ray < 10; ++ray) {
          ASSERT_EQ(judge.along_any_ray(s, eye, order), "") << "seed " << seed << "\n"
                                                            << text_of(eye) << "\n"
                                                            << list.text();
        }
      }
    }
  }
}

/// As close to planes as doubles come: there the filter must not decide.
TEST(WorldTree, OrdersAreRightForEyesAHairOffPlanes) {
  reset_predicate_counts();
  for (std::uint64_t seed = 1; seed <= 60 / test::kSlower; ++seed) {
    Source s(seed);
    const ItemList list = test::families::triangles(s);
    const WorldTree tree = tree_of(list);
    Judge judge(list, tree);
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      const auto p = list.points_of(i);
      const double a = s.unit(), b = s.unit();
      const Point3 along = a * (p[1] - p[0]) + b * (p[2] - p[0]);
      for (const Eye& eye : {Eye::at(p[0] + along), Eye::toward(along)}) {
        const Order order = far_to_near(tree, eye);
        for (int ray = 0; ray < 10; ++ray) {
          ASSERT_EQ(judge.along_any_ray(s, eye, order), "") << "seed " << seed << "\n"
                                                            << text_of(eye) << "\n"
                                                            << list.text();
        }
      }
    }
  }
  const StageCounts stages = predicate_counts()[static_cast<std::size_t>(Predicate::side_of_plane)];
  EXPECT_GT(stages.exact, 100u / test::kSlower) << "a filter decided what it cannot know";
}

/// Two parallel sheets: one's plane divides, and the order shows on which side of it the eye is
/// assumed to be. That must be the true side, also where the doubles' error is larger than the
/// value.
TEST(WorldTree, EverySideIsTrue) {
  Source s(17);
  std::size_t judged = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const double size = std::pow(10.0, s.between(-2, 3)), out = std::pow(10.0, s.between(-3, 9));
    const Point3 p = out * test::any_direction(s);
    const Point3 u = size * test::any_direction(s), v = size * test::any_direction(s);
    const Point3 apart = size * glm::cross(glm::normalize(u), glm::normalize(v));
    const std::array<Point3, 3> sheet = {p, p + u, p + v};
    ItemList list;
    list.solid({sheet[0], sheet[1], sheet[2]});
    list.solid({sheet[0] + apart, sheet[1] + apart, sheet[2] + apart});
    const WorldTree tree = tree_of(list);
    if (tree.pieces().cuts > 0) continue;
    const auto first_item = [&](const Eye& eye) {
      return tree.pieces().pieces[far_to_near(tree, eye)[0]].item;
    };
    // From between the two the one that divides is first.
    const std::uint32_t divides = first_item(Eye::at(p + 0.1 * u + 0.1 * v + 0.5 * apart));
    const auto d = list.points_of(divides);
    const auto rational = [](const Point3& q) { return QPoint{Q(q.x), Q(q.y), Q(q.z)}; };
    const QPlane plane(rational(d[0]), rational(d[1]), rational(d[2]));
    const int other = sgn(plane.at(rational(list.points_of(1 - divides)[0])));
    // In the plane up to rounding: anywhere, where it is nearest to the origin, and directions.
    const double a = s.unit(), b = s.unit();
    const Point3 along = a * u + b * v, normal = glm::normalize(glm::cross(u, v));
    for (const Eye& eye :
         {Eye::at(d[0] + along), Eye::at(glm::dot(d[0], normal) * normal), Eye::toward(along)}) {
      Q value = plane.at(rational(eye.place));
      if (eye.at_infinity) value -= plane.d;
      if (sgn(value) == 0) continue;
      const bool beyond_it = sgn(value) == other;  // the eye is on the other's side: that is nearer
      EXPECT_EQ(first_item(eye), beyond_it ? divides : 1 - divides)
          << trial << ", " << text_of(eye) << "\n"
          << list.text();
      ++judged;
    }
  }
  EXPECT_GT(judged, 9000u);
}

TEST(WorldTree, CoplanarPiecesAreInOrderOfEntryFromBothSides) {
  ItemList list;
  for (int k = 0; k < 5; ++k) {
    const double x = 0.1 * k;
    if (k % 2 == 0) {
      list.solid({{x, 0, x}, {x + 0.5, 0, x + 0.5}, {x, 1, x}});
    } else {
      list.solid({{x, 0, x}, {x, 1, x}, {x + 0.5, 0, x + 0.5}});
    }
  }
  list.line({0.2, 0.2, 0.2}, {0.4, 0.3, 0.4});
  list.solid({{0, 0, 0}, {1, 0, 1}, {0, 1, 0}});
  const WorldTree tree = tree_of(list);
  for (const Eye& eye :
       {Eye::toward({1, 0, -1}), Eye::toward({-1, 0, 1}), Eye::at({3, 0, 0}), Eye::at({0, 0, 3})}) {
    std::vector<std::uint32_t> items;
    for (const Index i : far_to_near(tree, eye)) items.push_back(tree.pieces().pieces[i].item);
    EXPECT_EQ(items, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 6, 5})) << text_of(eye);
  }
}

TEST(WorldTree, RoundoffBuildsTheSameCode) {
  Source s(7);
  const ItemList list = test::families::triangles(s);
  SurfacePlan options;
  options.precision = {.exact = false, .roundoff = 1e-9};
  const WorldTree tree(list.view(), options);
  Judge judge(list, tree);
  const Eye eye = Eye::toward({0.3, 0.4, 0.5});
  const Order order = far_to_near(tree, eye);
  expect_all_pieces_once(tree, list, order);
  for (int ray = 0; ray < 200; ++ray) EXPECT_EQ(judge.along_any_ray(s, eye, order), "");
}

// ---- Unusual scenes ----------------------------------------------------------------------

TEST(WorldTree, EmptyScenesHaveEmptyOrders) {
  const WorldTree tree = tree_of({});
  Order order(7);
  EXPECT_EQ(tree.far_to_near(Eye::at(Point3(0.0)), order), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(order.empty());
  MovingEye moving(tree);
  EXPECT_TRUE(moving.far_to_near(Eye::at(Point3(1.0))).empty());
  EXPECT_TRUE(moving.far_to_near(Eye::at(Point3(2.0))).empty());
}

TEST(WorldTree, WhatHidesNothingIsKept) {
  ItemList list;
  list.line({0, 0, 0}, {1, 1, 1});
  list.hollow({{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}});
  list.solid({{0, 0, 0}, {0.5, 0.5, 0.5}, {1, 1, 1}});  // in line
  list.add(ItemList::Kind::solid, {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, {0, 0, 0});
  const WorldTree alone = tree_of(list);
  expect_all_pieces_once(alone, list, far_to_near(alone, Eye::at({2, 0, 0})));
  list.solid({{0.2, 0, 0}, {0.2, 1, 0}, {0.2, 0, 1}, {0.2, -1, -1}});
  const WorldTree tree = tree_of(list);
  EXPECT_GT(tree.pieces().cuts, 0u);
  for (const Eye& eye : {Eye::at({2, 0, 0}), Eye::at({-2, 0, 0}), Eye::toward({0, 0, 1})}) {
    expect_all_pieces_once(tree, list, far_to_near(tree, eye));
  }
}

/// The mantle of a cone, in the direction of (1, 1, 1) from its base: each plane has all others on
/// one side, and so have those across the axes through the apex, where each triangle begins.
ItemList cone(int n, bool light_face_out) {
  const Point3 apex(1.0), u = glm::normalize(Point3(1, -1, 0)),
                          v = glm::normalize(Point3(1, 1, -2));
  const auto at = [&](int k) {
    const double angle = 2.0 * std::numbers::pi * (k % n) / n;
    return 0.3 * (std::cos(angle) * u + std::sin(angle) * v);
  };
  ItemList list;
  for (int k = 0; k < n; ++k) {
    list.solid({apex, at(light_face_out ? k : k + 1), at(light_face_out ? k + 1 : k)});
  }
  return list;
}

/// In a thread whose stack would not hold a frame for each level of the tree.
template <class Work>
void on_a_small_stack(Work work) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(
      pthread_attr_setstacksize(&attributes, static_cast<std::size_t>(PTHREAD_STACK_MIN) + 65536),
      0);
  pthread_t thread;
  const auto run = [](void* it) -> void* {
    (*static_cast<Work*>(it))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, &work), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
}

TEST(WorldTree, DeepTreesDoNotRecur) {
  for (const bool light_face_out : {true, false}) {
    constexpr int kTriangles = 5000 / test::kSlower;
    const ItemList list = cone(kTriangles, light_face_out);
    std::optional<WorldTree> tree;
    on_a_small_stack([&] { tree.emplace(list.view(), SurfacePlan{}); });
    ASSERT_EQ(tree->pieces().depth, kTriangles) << "the scene no longer makes a chain";
    const Eye inside = Eye::at(Point3(0.5)), outside = Eye::at({5, 4, 3});
    Order near_inside, near_outside;
    double until = 0.0;
    on_a_small_stack([&] {
      tree->far_to_near(outside, near_outside);
      until = tree->far_to_near(inside, near_inside);
    });
    EXPECT_GT(until, 0.0);
    Source s(1);
    Judge judge(list, *tree);
    for (const auto& [eye, order] : {std::pair(outside, near_outside), {inside, near_inside}}) {
      expect_all_pieces_once(*tree, list, order);
      for (int ray = 0; ray < 5; ++ray) EXPECT_EQ(judge.along_any_ray(s, eye, order), "");
    }
  }
}

/// Far from the origin the fast filter decides little; it must not decide wrongly.
TEST(WorldTree, OrdersAreRightFarFromTheOrigin) {
  for (const double offset : {1e3, 1e9, 1e15}) {
    for (std::uint64_t seed = 1; seed <= 10 / test::kSlower; ++seed) {
      Source s(seed);
      const auto vertex = [&] { return Point3(offset) + 4096.0 * test::on_grid(s, 64, 64); };
      ItemList list;
      for (int k = 0; k < 12; ++k) {
        const Point3 a = vertex(), b = vertex(), c = vertex();
        list.solid({a, b, c});
      }
      const WorldTree tree = tree_of(list);
      Judge judge(list, tree, {Point3(offset), 4096.0, 1e-14 * (offset + 4096.0)});
      for (int k = 0; k < 20; ++k) {
        const Eye eye = k % 2 == 0 ? Eye::at(vertex()) : Eye::toward(test::any_direction(s));
        const Order order = far_to_near(tree, eye);
        for (int ray = 0; ray < 10; ++ray) {
          ASSERT_EQ(judge.along_any_ray(s, eye, order), "") << offset << ", seed " << seed << "\n"
                                                            << text_of(eye);
        }
      }
    }
  }
}

// ---- An eye that moves -------------------------------------------------------------------

TEST(MovingEye, OrdersAreThoseOfFreshWalks) {
  for (const bool at_infinity : {false, true}) {
    Source s(13);
    ItemList list;
    for (int k = 0; k < 10; ++k) list.solid({test::in_cube(s), test::in_cube(s), test::in_cube(s)});
    const WorldTree tree = tree_of(list);
    MovingEye moving(tree);
    for (int step = 0; step < 4000; ++step) {
      const double angle = step * 1e-3;
      const Point3 place(2.0 * std::cos(angle), 0.7, 2.0 * std::sin(angle));
      const Eye eye = at_infinity ? Eye::toward(place) : Eye::at(place);
      const auto order = moving.far_to_near(eye);
      ASSERT_EQ(Order(order.begin(), order.end()), far_to_near(tree, eye)) << step;
    }
    EXPECT_EQ(moving.walks() + moving.reused(), 4000u);
    EXPECT_GT(moving.reused(), 1000u);
    EXPECT_GT(moving.walks(), 10u);
  }
}

TEST(MovingEye, StaysBetweenPlanes) {
  ItemList list;
  list.solid({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  list.solid({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}});
  const WorldTree tree = tree_of(list);
  Order order;
  // One of the two planes divides; the other polygon is a leaf, and decides nothing.
  const double until = tree.far_to_near(Eye::at({0.3, 0.3, 5.0}), order);
  EXPECT_TRUE(std::abs(until - 4.0) < 1e-12 || std::abs(until - 5.0) < 1e-12) << until;
  MovingEye moving(tree);
  moving.far_to_near(Eye::at({0.3, 0.3, 5.0}));
  moving.far_to_near(Eye::at({0.3, 0.3, 5.0}));
  moving.far_to_near(Eye::at({0.3, 2.0, 5.0}));
  EXPECT_EQ(moving.walks(), 1u);
  EXPECT_EQ(moving.reused(), 2u);
  moving.far_to_near(Eye::toward({0.3, 2.0, 5.0}));  // another kind of eye
  EXPECT_EQ(moving.walks(), 2u);
  moving.far_to_near(Eye::at({0.0, 0.0, -1.0}));  // crosses the planes
  EXPECT_EQ(moving.walks(), 3u);
}

}  // namespace
}  // namespace displayfile
