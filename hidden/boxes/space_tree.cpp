#include "hidden/boxes/space_tree.h"

#include "hidden/boxes/build_box_tree.h"

namespace displayfile {

template <>
void SpaceTree::build(std::size_t items, const std::function<Bounds(Item)>& box_of, int threads) {
  build_by<Halves<Bounds>>(items, box_of, threads);
}

}  // namespace displayfile
