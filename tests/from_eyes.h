#pragma once

#include <glm/mat3x3.hpp>

#include "displayfile/segments/display_file.h"
#include "displayfile/segments/retained_scene.h"
#include "interp/draw/renderer.h"

namespace displayfile::test {

/// A Renderer of one retained scene, from one eye after another, without an application's settings.
class FromEyes {
 public:
  FromEyes(const RetainedScene& scene, const DisplayFile& attributes)
      : scene_(scene), attributes_(attributes) {}

  const Picture& draw(const View& view, const DrawOptions& options = {},
                      const glm::dmat3& lights_turned = glm::dmat3(1.0)) {
    return renderer_.draw(in(view, lights_turned), options);
  }
  void draw(const View& view, const Destination& to, const DrawOptions& options = {},
            const glm::dmat3& lights_turned = glm::dmat3(1.0)) {
    renderer_.draw(in(view, lights_turned), to, options);
  }
  DisplayFile display_file(const View& view, const glm::dmat3& lights_turned = glm::dmat3(1.0)) {
    return renderer_.display_file(in(view, lights_turned));
  }
  Picture take_picture() { return renderer_.take_picture(); }
  void give_back(Picture picture) { renderer_.give_back(std::move(picture)); }
  const Renderer& renderer() const { return renderer_; }
  Renderer::Made made() const { return renderer_.made(); }
  std::size_t bytes_of_casters() const { return renderer_.bytes_of_casters(); }

 private:
  InView in(const View& view, const glm::dmat3& lights_turned) const {
    return {scene_, attributes_, view, &lights_turned};
  }
  const RetainedScene& scene_;
  const DisplayFile& attributes_;
  Renderer renderer_;
};

}  // namespace displayfile::test
