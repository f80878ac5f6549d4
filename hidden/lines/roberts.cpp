#include "hidden/lines/roberts.h"

#include "hidden/lines/line_against_polygon.h"
#include "hidden/lines/visible_pieces.h"

namespace displayfile {

namespace {

/// Finds what is hidden of one line after the other.
template <class Policy>
class Roberts {
 public:
  Roberts(const LineScene& scene, const ExtentTree& tree, const Policy& policy)
      : scene_(scene), tree_(tree), line_(scene, policy) {}

  const std::vector<PartOfLine>& hidden_parts(const LineScene::Line& line) {
    parts_.clear();
    line_.look_at(line);
    const Extent box = scene_.extent(line);
    const auto meets = [flat = FlatBox::of(box)](const FlatBoxes& b) { return b.meets(flat); };
    tree_.any(meets, [&](ExtentTree::Position position) {
      const std::uint32_t polygon = tree_.order()[position];
      // The minimax test in depth.
      if (scene_.extent(polygon).z_max > box.z_min) line_.hide(polygon, parts_);
      return false;
    });
    return parts_.hidden();
  }

 private:
  const LineScene& scene_;
  const ExtentTree& tree_;
  LineAgainstPolygon<Policy> line_;
  HiddenParts parts_;
};

}  // namespace

SeenLines visible_lines_by_roberts(const Primitives& items, const LineScene& scene,
                                   const LineOptions& options) {
  const ExtentTree tree = extent_tree(scene.extents(), options.threads);
  const auto find = [&](const auto& policy) {
    return visible_pieces(scene, scene.first_lines(), options,
                          [&] { return Roberts(scene, tree, policy); });
  };
  const Definitions points{items.points, {}};
  if (options.precision.exact) return find(ExactLines(points));
  return find(RoundoffLines(points, options.precision.roundoff));
}

}  // namespace displayfile
