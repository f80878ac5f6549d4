#pragma once

#include <memory>
#include <vector>

#include "clip/transformation.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {

/// A retained scene, and the display file that has what its segments are drawn with, as an object
/// keeps them that made something of both: it tells whether they still are what they were then.
/// Both may be moved.
class TakenScene {
 public:
  /// Nothing has been taken yet.
  TakenScene(const RetainedScene& scene, const DisplayFile& attributes);

  /// As they are now. Throws Error if one of the two is gone.
  const RetainedScene& scene() const;
  const DisplayFile& attributes() const;
  bool is_gone() const;  ///< one of the two

  /// True if what was drawn is what was taken last. Throws Error as scene() does.
  bool has_same_scene() const;
  /// The same, and each segment is as visible as it was and has the image transformation that it
  /// had. Throws Error too for a segment that the display file has not.
  bool is_same() const;
  /// What they are now is what something has been made of.
  void take();

 private:
  /// What a segment is drawn with.
  struct Look {
    bool visible;
    ImageTransformation image;
    bool operator==(const Look& o) const = default;
  };
  std::vector<Look> looks() const;

  std::shared_ptr<const RetainedScene::Place> scene_;
  std::shared_ptr<const DisplayFile::Place> attributes_;
  RetainedScene::Edition edition_;
  std::vector<Look> looks_;
  bool is_taken_ = false;
};

}  // namespace displayfile
