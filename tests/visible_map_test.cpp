// The visible-surface map (hidden/map/visible_map.h) against the definition, in rationals.

#include "hidden/map/visible_map.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/from_environment.h"
#include "tests/map_truth.h"
#include "tests/slower.h"
#include "tests/sort_scenes.h"

namespace displayfile {
namespace {

using namespace test;

std::vector<Point2> places_at_random(Source& s, int count) {
  std::vector<Point2> places;
  for (; count > 0; --count) {
    const double x = s.unit(), y = s.unit();
    places.emplace_back(x, y);
  }
  return places;
}

std::string wrong_in(const ItemList& list, int places = 12) {
  Source s(1'000'003);
  return wrong_in_map(list.view(), visible_map(list.view(), {}), places_at_random(s, places));
}

/// The scene that is left when everything is left out without which it is right.
std::string shrunken_wrong(const ItemList& list) {
  const ItemList least =
      shrunken(list, [](const ItemList& part) { return !wrong_in(part).empty(); });
  return wrong_in(least) + least.text();
}

TEST(VisibleMap, EveryFamilyAgainstTheTruth) {
  const int scenes = from_environment("DISPLAYFILE_MAP_SCENES", 30 / kSlower);
  for (const SortFamily& family : sort_families()) {
    for (int k = 0; k < scenes; ++k) {
      Source s(static_cast<std::uint64_t>(k));
      const ItemList list = family.make(s);
      if (wrong_in(list).empty()) continue;
      ADD_FAILURE() << family.name << ", seed " << k << "\n" << shrunken_wrong(list);
      break;
    }
  }
}

}  // namespace
}  // namespace displayfile
