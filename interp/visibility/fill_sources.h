#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "displayfile/display_file.h"

namespace displayfile {

/// The visible segments of a display file as they are now: to tell later whether what was made from
/// their fills can be used again.
class FillSources {
 public:
  FillSources() = default;
  explicit FillSources(const DisplayFile& display_file);

  /// True while the display file's visible segments are as they were.
  bool are_of(const DisplayFile& display_file) const;

 private:
  struct Source {
    std::shared_ptr<const Instructions> instructions;
    ImageTransformation image;
    std::size_t codes;
  };
  std::vector<Source> sources_;
};

}  // namespace displayfile
