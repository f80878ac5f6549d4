#include "interp/vector/pens/hatched_faces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

namespace displayfile {

namespace {

constexpr double kLargestFacet = 8.0;  // in areas of the facet beside it
// Tolerances of slopes: relative, and absolute where they are small, in depths (0 to 1) per
// millimetre.
constexpr double kSamePlane = 2e-3, kLevel = 1e-9;

/// A side of a fill, its ends in order.
struct FillSide {
  Point2 low, high;
  double dark_at_low, dark_at_high;
  std::uint32_t fill;
  auto place() const { return std::tie(low.x, low.y, high.x, high.y); }
};

std::vector<FillSide> sides_in_order(std::span<const HatchedFill> fills,
                                     std::span<const Point2> points,
                                     std::span<const double> darkness) {
  std::vector<FillSide> sides;
  sides.reserve(points.size());
  for (std::uint32_t f = 0; f < fills.size(); ++f) {
    std::size_t from = fills[f].end - 1;
    for (std::size_t to = fills[f].first; to < fills[f].end; from = to++) {
      FillSide side{points[from], points[to], darkness[from], darkness[to], f};
      if (std::tie(side.low.x, side.low.y) > std::tie(side.high.x, side.high.y)) {
        std::swap(side.low, side.high);
        std::swap(side.dark_at_low, side.dark_at_high);
      }
      sides.push_back(side);
    }
  }
  std::ranges::sort(sides, [](const FillSide& a, const FillSide& b) {
    return std::tuple_cat(a.place(), std::tie(a.fill)) <
           std::tuple_cat(b.place(), std::tie(b.fill));
  });
  return sides;
}

bool are_in_one_plane(const HatchedFill& a, const HatchedFill& b) {
  const double size = glm::length(a.slope) + glm::length(b.slope);
  return glm::distance(a.slope, b.slope) <= kSamePlane * size + kLevel;
}

/// Faces of even darkness, and the facets among them.
class FacesOfTones {
 public:
  FacesOfTones(std::span<const HatchedFill> fills, std::span<const Point2> points,
               std::span<const double> darkness)
      : fills_(fills),
        darkness_(darkness),
        sides_(sides_in_order(fills, points, darkness)),
        face_of_(fills.size(), kNone),
        areas_(fills.size(), 0.0),
        facet_of_(fills.size(), 0.0),
        members_from_(fills.size(), 0),
        members_to_(fills.size(), 0) {}

  HatchedFaces found() {
    find_neighbours();
    for (std::uint32_t f = 0; f < fills_.size(); ++f) {
      if (face_of_[f] == kNone) grow_face(f);
    }
    find_first_facets();
    std::size_t next = 0;
    while (next < facets_.size()) {  // more are found on the way
      const std::uint32_t facet = facets_[next++];
      for (std::size_t k = members_from_[facet]; k < members_to_[facet]; ++k) {
        for_neighbours_of(members_[k],
                          [&](std::uint32_t n) { try_facet(face_of_[n], facet_of_[facet]); });
      }
    }
    HatchedFaces result{std::move(face_of_), {}};
    for (const std::uint32_t face : result.face_of) {
      result.is_facet.push_back(facet_of_[face] > 0.0 ? 1 : 0);
    }
    return result;
  }

 private:
  static constexpr auto kNone = static_cast<std::uint32_t>(-1);
  static constexpr std::size_t kMostOnASide = 8;

  /// Visits pairs of fills with a common side, once for each such side. Where fills overlap, many
  /// may have the same side: each is paired with the few that follow it.
  template <class Visit>
  void for_pairs(const Visit& visit) const {
    for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
      const std::size_t end = std::min(sides_.size(), i + kMostOnASide);
      for (std::size_t k = i + 1; k < end && sides_[k].place() == sides_[i].place(); ++k) {
        if (sides_[k].fill != sides_[i].fill) visit(sides_[i], sides_[k]);
      }
    }
  }
  bool are_even(const FillSide& a, const FillSide& b) const {
    return fills_[a.fill].is_even && fills_[b.fill].is_even;
  }
  double tone(std::uint32_t fill) const { return darkness_[fills_[fill].first]; }
  void find_neighbours() {
    for_pairs([&](const FillSide& a, const FillSide& b) {
      if (!are_even(a, b) || std::abs(tone(a.fill) - tone(b.fill)) > kSameTone) return;
      pairs_.emplace_back(a.fill, b.fill);
      pairs_.emplace_back(b.fill, a.fill);
    });
    std::ranges::sort(pairs_);
  }
  template <class Visit>
  void for_neighbours_of(std::uint32_t fill, const Visit& visit) const {
    const auto first = std::ranges::lower_bound(pairs_, std::pair(fill, std::uint32_t{0}));
    for (auto it = first; it != pairs_.end() && it->first == fill; ++it) visit(it->second);
  }
  /// Compares with the face's first fill: tones and planes that change gradually are not one face.
  void grow_face(std::uint32_t first) {
    const auto take = [&](std::uint32_t f) {
      face_of_[f] = first;
      areas_[first] += fills_[f].area;
      members_.push_back(f);
    };
    members_from_[first] = members_.size();
    take(first);
    for (std::size_t next = members_from_[first]; next < members_.size(); ++next) {
      for_neighbours_of(members_[next], [&](std::uint32_t n) {
        const bool is_of_it = face_of_[n] == kNone &&
                              std::abs(tone(n) - tone(first)) <= kSameTone &&
                              are_in_one_plane(fills_[n], fills_[first]);
        if (is_of_it) take(n);
      });
    }
    members_to_[first] = members_.size();
  }
  void find_first_facets() {
    for_pairs([&](const FillSide& a, const FillSide& b) {
      const bool is_as_dark = std::abs(a.dark_at_low - b.dark_at_low) <= kSameTone &&
                              std::abs(a.dark_at_high - b.dark_at_high) <= kSameTone;
      if (!is_as_dark || fills_[a.fill].is_even == fills_[b.fill].is_even) return;
      const FillSide &even = fills_[a.fill].is_even ? a : b, &uneven = &even == &a ? b : a;
      try_facet(face_of_[even.fill], fills_[uneven.fill].area);
    });
  }
  /// Tests a face beside a facet of area `beside`, or beside one of a surface whose largest facet
  /// so far has that area.
  void try_facet(std::uint32_t face, double beside) {
    if (facet_of_[face] > 0.0 || !(areas_[face] <= kLargestFacet * beside)) return;
    facet_of_[face] = std::max(areas_[face], beside);
    facets_.push_back(face);
  }

  std::span<const HatchedFill> fills_;
  std::span<const double> darkness_;
  std::vector<FillSide> sides_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      pairs_;                                           // even fills of one tone, with a side
  std::vector<std::uint32_t> face_of_;                  // of fills
  std::vector<double> areas_, facet_of_;                // of faces, by their first fill
  std::vector<std::uint32_t> members_;                  // fills of one face after the other
  std::vector<std::size_t> members_from_, members_to_;  // of faces, by their first fill
  std::vector<std::uint32_t> facets_;                   // to be continued from
};

}  // namespace

HatchedFaces hatched_faces(std::span<const HatchedFill> fills, std::span<const Point2> points,
                           std::span<const double> darkness) {
  return FacesOfTones(fills, points, darkness).found();
}

}  // namespace displayfile
