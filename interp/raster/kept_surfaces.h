#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "clip/surfaces.h"
#include "displayfile/segments/viewed_scene.h"
#include "hidden/exact/pixel_centre.h"

namespace displayfile {

/// The visible surfaces of a picture, by their fills, kept for the same view in other lights. Rows
/// count from the bottom.
class KeptSurfaces {
 public:
  using Fill = ViewedScene::Fill;
  /// The data that determine them.
  struct Of {
    std::uint64_t geometry;  ///< ViewedScene::geometry
    HiddenMethod method;
    PictureSize size;
    std::optional<double> roundoff;
    bool operator==(const Of&) const = default;
  };

  bool are(const Of& of) const { return of_ == of; }
  /// Begins keeping new surfaces in place of others: all rows, written by several threads, before
  /// they are complete.
  void begin(const PictureSize& size) {
    of_.reset();
    size_ = size;
    fills_.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  }
  void keep(int row, int first, std::span<const Fill> seen) {
    std::ranges::copy(seen, fills_.begin() + static_cast<std::ptrdiff_t>(index(row, first)));
  }
  void complete(const Of& of) { of_ = of; }

  std::span<const Fill> row(int row) const {
    return std::span(fills_).subspan(index(row, 0), static_cast<std::size_t>(size_.width));
  }

 private:
  std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.width) +
           static_cast<std::size_t>(column);
  }
  std::optional<Of> of_;
  PictureSize size_{};
  std::vector<Fill> fills_;
};

}  // namespace displayfile
