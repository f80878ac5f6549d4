#pragma once

#include <memory>
#include <vector>

#include "clip/view/transformation.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"

namespace displayfile {

/// A retained scene and its display file, held by an object derived from both: detects whether they
/// have changed since. Both may be moved.
class TakenScene {
 public:
  /// Records nothing yet.
  TakenScene(const RetainedScene& scene, const DisplayFile& attributes);

  /// Their present state. Throws Error if either is destroyed.
  const RetainedScene& scene() const;
  const DisplayFile& attributes() const;
  bool is_gone() const;  ///< either is destroyed

  /// True if the primitives are those recorded last. Throws Error as scene() does.
  bool has_same_scene() const;
  /// The same, and each segment has the same visibility and image transformation. Throws Error too
  /// for a segment that the display file does not have.
  bool is_same() const;
  /// Records their present state.
  void take();

 private:
  /// A segment's visibility and image transformation.
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
