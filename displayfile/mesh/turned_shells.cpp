#include "displayfile/mesh/turned_shells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "clip/geometry/bounds.h"
#include "hidden/disjoint_sets.h"

namespace displayfile {

namespace {

using Triangle = SolidTriangles::Triangle;

struct SideOfTriangle {
  std::uint32_t low, high, triangle;
  int way;
  auto ends() const { return std::tie(low, high); }
};

/// The sides of triangles, those with the same ends in succession.
std::vector<SideOfTriangle> sorted_sides(const std::vector<Triangle>& triangles) {
  std::vector<SideOfTriangle> sides;
  sides.reserve(3 * triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    std::uint32_t from = triangles[i][2];
    for (const std::uint32_t to : triangles[i]) {
      sides.push_back({std::min(from, to), std::max(from, to), i, from < to ? 1 : -1});
      from = to;
    }
  }
  std::ranges::sort(sides, {}, &SideOfTriangle::ends);
  return sides;
}

/// Calls visit(first, last) for the sides of each pair of ends.
template <class Visit>
void for_each_pair_of_ends(const std::vector<SideOfTriangle>& sides, const Visit& visit) {
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].ends() == sides[first].ends()) ++last;
    visit(first, last);
  }
}

/// Which triangles are connected, as turn_shells_out says.
DisjointSets connected_triangles(const std::vector<SideOfTriangle>& sides, std::size_t triangles) {
  DisjointSets sets(triangles);
  for_each_pair_of_ends(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 2) sets.join(sides[first].triangle, sides[first + 1].triangle);
  });
  DisjointSets shells = sets;
  std::vector<std::pair<std::uint32_t, int>> ways;
  for_each_pair_of_ends(sides, [&](std::size_t first, std::size_t last) {
    if (last - first <= 2) return;
    ways.clear();
    for (std::size_t k = first; k < last; ++k) {
      ways.emplace_back(sets.name(sides[k].triangle), sides[k].way);
    }
    std::ranges::sort(ways);
    std::uint32_t open = 0;
    bool has_open = false;
    for (std::size_t k = 0; k < ways.size();) {
      const std::uint32_t set = ways[k].first;
      int sum = 0;
      for (; k < ways.size() && ways[k].first == set; ++k) sum += ways[k].second;
      if (sum == 0) continue;
      if (has_open) shells.join(open, set);
      open = set;
      has_open = true;
    }
  });
  return shells;
}

struct Shell {
  std::vector<std::uint32_t> triangles;
  Bounds bounds;
  double volume = 0.0;  ///< six times that, in its present orientation
  bool closed = true;
};

class Shells {
 public:
  explicit Shells(SolidTriangles::Object& object) : object_(object) {
    const auto sides = sorted_sides(object.triangles);
    DisjointSets sets = connected_triangles(sides, object.triangles.size());
    std::vector<std::size_t> shell_of(object.triangles.size());
    for (std::uint32_t i = 0; i < object.triangles.size(); ++i) {
      const std::uint32_t name = sets.name(i);  // the smallest, so its shell is there
      if (name == i) shells_.emplace_back();
      shell_of[i] = name == i ? shells_.size() - 1 : shell_of[name];
      shells_[shell_of[i]].triangles.push_back(i);
    }
    find_open(sides, shell_of);
    for (Shell& shell : shells_) measure(shell);
    std::erase_if(shells_, [](const Shell& shell) { return !shell.closed; });
  }

  void turn_out() {
    if (std::ranges::none_of(shells_, [](const Shell& s) { return s.volume < 0.0; })) return;
    // A shell comes after those around it.
    std::ranges::stable_sort(shells_, [](const Shell& a, const Shell& b) {
      return std::abs(a.volume) > std::abs(b.volume);
    });
    for (std::size_t k = 0; k < shells_.size(); ++k) {
      if (shells_[k].volume < 0.0 && !is_in_material(k)) turn_with_inner(k);
    }
  }

 private:
  const Point3& vertex(std::uint32_t triangle, std::size_t corner) const {
    return object_.vertices[object_.triangles[triangle][corner]];
  }

  void find_open(const std::vector<SideOfTriangle>& sides,
                 const std::vector<std::size_t>& shell_of) {
    std::vector<std::pair<std::size_t, int>> ways;
    for_each_pair_of_ends(sides, [&](std::size_t first, std::size_t last) {
      ways.clear();
      for (std::size_t k = first; k < last; ++k) {
        ways.emplace_back(shell_of[sides[k].triangle], sides[k].way);
      }
      std::ranges::sort(ways);
      for (std::size_t k = 0; k < ways.size();) {
        const std::size_t shell = ways[k].first;
        int sum = 0;
        for (; k < ways.size() && ways[k].first == shell; ++k) sum += ways[k].second;
        if (sum != 0) shells_[shell].closed = false;
      }
    });
  }

  void measure(Shell& shell) const {
    const Point3& origin = vertex(shell.triangles.front(), 0);
    for (const std::uint32_t t : shell.triangles) {
      for (std::size_t k = 0; k < 3; ++k) shell.bounds.include(vertex(t, k));
      const Point3 a = vertex(t, 0) - origin, b = vertex(t, 1) - origin, c = vertex(t, 2) - origin;
      shell.volume += glm::dot(a, glm::cross(b, c));
    }
  }

  /// How often the shell winds around a point, by the solid angles of its triangles (Van Oosterom
  /// and Strackee, "The solid angle of a plane triangle", 1983); nothing on the shell itself.
  std::optional<int> winding(const Shell& shell, const Point3& p) const {
    constexpr double kOnTriangle = 1e-9;
    double sum = 0.0;
    for (const std::uint32_t t : shell.triangles) {
      const Point3 a = vertex(t, 0) - p, b = vertex(t, 1) - p, c = vertex(t, 2) - p;
      const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
      const double sine = glm::dot(a, glm::cross(b, c));
      const double cosine =
          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
      const double near = kOnTriangle * la * lb * lc;
      if (std::abs(sine) <= near && cosine <= near) return std::nullopt;
      sum += std::atan2(sine, cosine);
    }
    return static_cast<int>(std::lround(sum / (2.0 * std::numbers::pi)));
  }

  /// True if the inner shell's box is in that of the outer one, within rounding: the wall between a
  /// cavity and the outside may have no thickness but for that.
  static bool has_box_in(const Shell& outer, const Shell& inner) {
    constexpr double kRelativeReach = 0x1p-40;
    const Point3 largest = glm::max(glm::abs(outer.bounds.low), glm::abs(outer.bounds.high));
    const double reach = kRelativeReach * std::max({largest.x, largest.y, largest.z});
    for (int axis = 0; axis < 3; ++axis) {
      if (inner.bounds.low[axis] < outer.bounds.low[axis] - reach) return false;
      if (inner.bounds.high[axis] > outer.bounds.high[axis] + reach) return false;
    }
    return true;
  }

  /// How often one shell winds around another, by the middle of a triangle that is not on it.
  int windings_around(const Shell& outer, const Shell& inner) const {
    if (!has_box_in(outer, inner)) return 0;
    constexpr std::size_t kMostTries = 64;
    const std::size_t tries = std::min(kMostTries, inner.triangles.size());
    for (std::size_t k = 0; k < tries; ++k) {  // from all of them: a flush face may have many
      const std::uint32_t t = inner.triangles[k * inner.triangles.size() / tries];
      if (const auto times = winding(outer, (vertex(t, 0) + vertex(t, 1) + vertex(t, 2)) / 3.0)) {
        return *times;
      }
    }
    return 0;
  }

  bool is_in_material(std::size_t k) const {
    int times = 0;
    for (std::size_t outer = 0; outer < k; ++outer) {
      times += windings_around(shells_[outer], shells_[k]);
    }
    return times > 0;
  }

  void turn_with_inner(std::size_t k) {
    for (std::size_t inner = k + 1; inner < shells_.size(); ++inner) {
      if (windings_around(shells_[k], shells_[inner]) != 0) turn(shells_[inner]);
    }
    turn(shells_[k]);
  }

  void turn(Shell& shell) {
    for (const std::uint32_t t : shell.triangles) {
      std::swap(object_.triangles[t][1], object_.triangles[t][2]);
    }
    shell.volume = -shell.volume;
  }

  SolidTriangles::Object& object_;
  std::vector<Shell> shells_;
};

}  // namespace

void turn_shells_out(SolidTriangles::Object& object) { Shells(object).turn_out(); }

}  // namespace displayfile
