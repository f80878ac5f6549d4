#include "interp/visibility/warnock.h"
#include "interp/visibility/warnock_subdivision.h"

namespace displayfile {

/// Hands on to an observer what it asks for.
struct Warnock::Told {
  const Observer& observer;
  void visit(const Visit& visited) const {
    if (observer.visit) observer.visit(visited);
  }
  void remove(Fill hidden, Fill by) const {
    if (observer.remove) observer.remove(hidden, by);
  }
  void part(const SampleArea& area) const {
    if (observer.part) observer.part(area);
  }
  void paint(Fill fill, int row, int first, int end) const {
    if (observer.paint && first < end) observer.paint(fill, row, first, end);
  }
};

void Warnock::draw_rows(int row_begin, int row_end, const SeenRun& seen,
                        const Observer& observer) const {
  subdivide(row_begin, row_end, seen, Told{observer});
}

}  // namespace displayfile
