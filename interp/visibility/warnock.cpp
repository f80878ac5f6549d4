#include "interp/visibility/warnock.h"

#include "interp/visibility/warnock_subdivision.h"

namespace displayfile {

void Warnock::prepare(const Request& request, int /*threads*/) {
  request_.emplace(request);
  const ViewedScene& scene = request.scene;
  depths_ = FillDepths(scene, request.size, request.roundoff);
  extents_.assign(scene.end(), {});
  for (Fill fill = 1; fill < scene.end(); ++fill) {
    extents_[fill] = extents_of(scene.vertices(fill), request.size);
  }
}

void Warnock::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  subdivide(row_begin, row_end, seen, Unobserved());
}

}  // namespace displayfile
