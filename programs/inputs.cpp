#include "programs/inputs.h"

#include "displayfile/drawing_program.h"
#include "displayfile/mesh.h"
#include "programs/progress.h"

namespace displayfile {

bool is_drawing_program(const std::string& input) {
  return input == "-" || input.ends_with(".draw");
}

void enter_inputs(std::span<const std::string> inputs, GraphicsSystem& system, double aspect) {
  for (std::size_t i = 0; i < inputs.size();) {
    if (is_drawing_program(inputs[i])) {
      const Progress progress("replaying " + inputs[i]);
      replay_file(inputs[i++], system);
      continue;
    }
    std::size_t end = i;  // meshes that follow each other share a fitted view
    while (end < inputs.size() && !is_drawing_program(inputs[end])) ++end;
    const Progress progress("reading " + inputs[i] + (end - i > 1 ? " and others" : ""));
    import_meshes(inputs.subspan(i, end - i), system, aspect);
    i = end;
  }
}

}  // namespace displayfile
