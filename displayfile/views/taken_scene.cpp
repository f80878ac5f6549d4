#include "displayfile/views/taken_scene.h"

#include "clip/base/error.h"

namespace displayfile {

TakenScene::TakenScene(const RetainedScene& scene, const DisplayFile& attributes)
    : scene_(scene.place()),
      attributes_(attributes.Watched<DisplayFile>::place()) {}  // it has another place()

const RetainedScene& TakenScene::scene() const {
  if (scene_->object != nullptr) return *scene_->object;
  throw Error("the retained scene is gone: expected it to live as long as what draws it");
}

const DisplayFile& TakenScene::attributes() const {
  if (attributes_->object != nullptr) return *attributes_->object;
  throw Error(
      "the display file of the retained scene is gone: expected it to live as long as what draws "
      "the scene");
}

bool TakenScene::is_gone() const {
  return scene_->object == nullptr || attributes_->object == nullptr;
}

bool TakenScene::has_same_scene() const { return is_taken_ && scene().edition() == edition_; }

bool TakenScene::is_same() const { return has_same_scene() && looks() == looks_; }

void TakenScene::take() {
  looks_ = looks();
  edition_ = scene().edition();
  is_taken_ = true;
}

std::vector<TakenScene::Look> TakenScene::looks() const {
  std::vector<Look> all;
  for (const RetainedScene::Segment& segment : scene().segments()) {
    const Segment& now = attributes().segment(segment.name);
    all.push_back({now.visible, now.image});
  }
  return all;
}

}  // namespace displayfile
