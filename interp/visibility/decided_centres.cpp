#include "interp/visibility/decided_centres.h"

#include <algorithm>
#include <functional>

#include "hidden/parallel.h"
#include "interp/visibility/fills_as_entered.h"

namespace displayfile {

void DecidedCentres::find(const ViewedScene& scene, const PictureSize& size, int threads) {
  forget();
  if (scene.viewing_radius() == 0.0) return;
  rows_.resize(static_cast<std::size_t>(size.height));
  const auto bands = static_cast<std::size_t>(std::clamp(threads, 1, size.height));
  in_parallel(threads, bands, [&](std::size_t band) {
    const auto row = [&](std::size_t k) {
      return static_cast<int>(k * static_cast<std::size_t>(size.height) / bands);
    };
    FillsAsEntered fills(scene, size);
    PixelSet noted(size.width, row(band), row(band + 1));
    for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) fills.note_boundary(fill, noted);
    if (noted.empty()) return;
    fills.decide(noted, [&](int at, int column, ViewedScene::Fill fill) {
      rows_[static_cast<std::size_t>(at)].push_back({column, fill});
    });
  });
}

std::span<const DecidedCentres::Decided> DecidedCentres::in_row(int row, int first, int end) const {
  if (rows_.empty()) return {};
  const auto& all = rows_[static_cast<std::size_t>(row)];
  const auto from = std::ranges::lower_bound(all, first, {}, &Decided::column);
  const auto to = std::ranges::lower_bound(all, end, {}, &Decided::column);
  return {from, to};
}

void MethodAsEntered::prepare(const Request& request, int threads) {
  method_->prepare(request, threads);
  decided_.forget();
  if (!request.roundoff) decided_.find(request.scene, request.size, threads);
}

void MethodAsEntered::draw_rows(int row_begin, int row_end, const SeenRun& seen) const {
  if (decided_.empty()) return method_->draw_rows(row_begin, row_end, seen);
  std::vector<ViewedScene::Fill> changed;
  const auto decide = [&](int row, int first, std::span<const ViewedScene::Fill> fills) {
    const auto here = decided_.in_row(row, first, first + static_cast<int>(fills.size()));
    if (here.empty()) return seen(row, first, fills);
    changed.assign(fills.begin(), fills.end());
    for (const auto& [column, fill] : here)
      changed[static_cast<std::size_t>(column - first)] = fill;
    seen(row, first, changed);
  };
  method_->draw_rows(row_begin, row_end, std::cref(decide));
}

}  // namespace displayfile
