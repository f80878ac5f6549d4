#include "interp/raster/undecided_centres.h"

namespace displayfile {

NearestAtCentres::NearestAtCentres(const PixelSet& centres, const PictureSize& size,
                                   FillsAsEntered& fills, const Shadows* shadows)
    : set_(centres), size_(size), fills_(fills), shadows_(shadows), centres_(centres, size) {}

void NearestAtCentres::begin_layer(Layer layer) {
  layer_ = layer;
  ++layers_;
}

void NearestAtCentres::enter(const DrawnPolygon& drawn, FillsAsEntered::Fill fill,
                             const Plane& plane) {
  const ScanConverter::Region region = centres_.rows_of(drawn.vertices);
  if (region.row_begin >= region.row_end) return;
  const Seen seen{plane, FillColour(drawn, size_, shadows_), drawn.pick};
  Owner own = kNone;
  fills_.scan(fill, region, set_, [&](int row, int first, int end) {
    enter_run({row, first, end}, seen, fill, own);
  });
}

void NearestAtCentres::enter_run(const Run& run, const Seen& polygon, FillsAsEntered::Fill fill,
                                 Owner& own) {
  centres_.in_run(run.row, run.first, run.end, [&](int column, Owner& owner) {
    if (owner != kNone && !is_seen(owner, fill, run.row, column)) return;
    if (own == kNone) own = take_place(polygon, fill);
    if (owner != kNone && --owners_[owner].centres == 0) free_.push_back(owner);
    owner = own;
    ++owners_[own].centres;
  });
}

bool NearestAtCentres::is_seen(Owner other, FillsAsEntered::Fill fill, int row, int column) {
  if (layer_ == Layer::painted || owners_[other].layer != layers_) return true;
  return fills_.later_is_seen(owners_[other].fill, fill, column, row);
}

NearestAtCentres::Owner NearestAtCentres::take_place(const Seen& polygon,
                                                     FillsAsEntered::Fill fill) {
  auto place = static_cast<Owner>(owners_.size());
  if (free_.empty()) {
    owners_.push_back({polygon, fill, layers_, 0});
  } else {
    place = free_.back();
    free_.pop_back();
    owners_[place] = {polygon, fill, layers_, 0};
  }
  return place;
}

}  // namespace displayfile
