#include "interp/visibility/decided_centres.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "clip/base/parallel.h"
#include "interp/visibility/fills_as_entered.h"

namespace displayfile {

void DecidedCentres::find(const ViewedScene& scene, const PictureSize& size, int threads) {
  forget();
  if (scene.viewing_radius() == 0.0) return;
  const auto bands = static_cast<std::size_t>(std::clamp(threads, 1, size.height));
  if (bands_.size() < bands) bands_.resize(bands);
  in_parallel(threads, bands, [&](std::size_t number) {
    const auto row = [&](std::size_t k) {
      return static_cast<int>(k * static_cast<std::size_t>(size.height) / bands);
    };
    Band& band = bands_[number];
    band.decided.clear();
    PixelSet noted(size.width, row(number), row(number + 1));
    for (ViewedScene::Fill fill = 1; fill < scene.end(); ++fill) {
      note_boundary(scene, fill, size, band.converter, noted);
    }
    if (noted.empty()) return;
    FillsAsEntered(scene, size).decide(noted, [&](int at, int column, ViewedScene::Fill fill) {
      band.decided.push_back({at, column, fill});
    });
  });
  for (std::size_t k = 0; k < bands; ++k) {
    all_.insert(all_.end(), bands_[k].decided.begin(), bands_[k].decided.end());
  }
}

std::span<const DecidedCentres::Decided> DecidedCentres::in_row(int row, int first, int end) const {
  const auto before = [&](int column) {
    const auto at = std::ranges::lower_bound(
        all_, std::pair(row, column), {},
        [](const Decided& decided) { return std::pair(decided.row, decided.column); });
    return static_cast<std::size_t>(at - all_.begin());
  };
  const std::size_t from = before(first);
  return std::span(all_).subspan(from, before(end) - from);
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
    for (const DecidedCentres::Decided& one : here) {
      changed[static_cast<std::size_t>(one.column - first)] = one.fill;
    }
    seen(row, first, changed);
  };
  method_->draw_rows(row_begin, row_end, std::cref(decide));
}

}  // namespace displayfile
