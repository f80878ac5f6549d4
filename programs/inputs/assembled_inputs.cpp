#include "programs/inputs/assembled_inputs.h"

#include "clip/base/files.h"
#include "displayfile/segments/display_file.h"
#include "displayfile/user_routines/system_inside.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/mistaken_words.h"
#include "programs/inputs/segment_names.h"
#include "programs/process/progress.h"
#include "programs/process/warnings.h"

namespace displayfile {

AssembledInputs::AssembledInputs(std::span<const std::string> inputs, const ImportLimits& limits,
                                 double aspect) {
  for (const std::string& input : inputs) require_no_folder_or_pattern(input);
  SystemInside::retain_alone(system, scene);
  system.set_aspect_ratio(aspect);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    enter(inputs[i], i, limits);
    planes.entered(i, system);
  }
}

void AssembledInputs::enter(const std::string& input, std::size_t number,
                            const ImportLimits& limits) {
  const Progress progress("reading " + input);
  if (is_drawing_program(input)) {
    replay_beside(read_text_file(input), input_name(input), system);
    openings.resize(SystemInside::segments_opened(system), {number, {}});
    return;
  }
  const Mesh mesh = [&] {
    const NamedWarnings named(input);
    return read_mesh(input, false, limits);
  }();
  report_skipped(std::span(&input, 1), std::span(&mesh.skipped, 1));
  naming_mesh(input, [&] { enter_meshes(std::span(&mesh, 1), system); });
  for (const Mesh::Object& object : mesh.objects) openings.push_back({number, object.name});
}

bool AssembledInputs::is_visible(const RetainedScene::Segment& segment) const {
  return system.display_file().segment(segment.name).visible;
}

}  // namespace displayfile
