#include "hidden/lines/depth_boxes.h"

#include "hidden/boxes/build_box_tree.h"

namespace displayfile {

template <>
void DepthTree::build(std::size_t items, const std::function<DepthBox(Item)>& box_of, int threads) {
  build_by<Halves<DepthBox>>(items, box_of, threads);
}

}  // namespace displayfile
