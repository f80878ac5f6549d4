#include "interp/visibility/fill_sources.h"

namespace displayfile {

FillSources::FillSources(const DisplayFile& display_file) {
  for (const Segment* segment : display_file.visible_segments()) {
    sources_.push_back({segment->entered(), segment->image, segment->entered()->codes()});
  }
}

bool FillSources::are_of(const DisplayFile& display_file) const {
  std::size_t k = 0;
  for (const Segment& segment : display_file.segments()) {
    if (!segment.visible) continue;
    if (k == sources_.size()) return false;
    const Source& source = sources_[k++];
    if (source.instructions != segment.entered() || !(source.image == segment.image) ||
        source.codes != segment.entered()->codes()) {
      return false;
    }
  }
  return k == sources_.size();
}

}  // namespace displayfile
