#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace displayfile {

/// The predicates, for counting.
enum class Predicate : std::uint8_t {
  orientation_2,   ///< side of a point to a line in the projection
  orientation_3,   ///< side of a point to the plane of three others
  row,             ///< vertex against a row or a column of pixel centres
  crossing,        ///< pixel centre against an edge
  side_of_plane,   ///< stored or defined point against a plane
  side_of_line,    ///< defined points in the projection
  compare,         ///< coordinates of two defined points
  depth_at_pixel,  ///< two planes at a pixel centre
  depth_at_point,  ///< two planes along the projector through a point
  line_parameter,  ///< where along a line something meets it
  within_reach,    ///< point as entered against a plane as entered
};
inline constexpr std::size_t kPredicates = 11;
std::string_view name_of(Predicate predicate);

/// How often a predicate's filter was undecided, by the stage that decided.
struct StageCounts {
  std::uint64_t by_definition = 0;  ///< zero because of how the points are defined
  std::uint64_t exact = 0;          ///< the exact stage
};
using PredicateCounts = std::array<StageCounts, kPredicates>;

/// The counts of all threads since the last reset. Other threads may be counting meanwhile;
/// what a thread counted before it was joined is included. The fast paths count nothing.
PredicateCounts predicate_counts();
void reset_predicate_counts();

// Called by the slow stages, to count themselves.
void count_by_definition(Predicate predicate);
void count_exact(Predicate predicate);

}  // namespace displayfile
