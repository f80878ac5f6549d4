#include "tests/bench/scene_program.h"

#include <fstream>
#include <sstream>

#include "clip/error.h"
#include "displayfile/files.h"
#include "displayfile/graphics_system.h"

namespace displayfile::bench {

void write_program(const Scene& scene, const std::string& path) {
  std::stringstream recorded;
  {
    Recorder recorder(recorded);
    GraphicsSystem system;
    system.set_recorder(&recorder);
    enter(scene, system);
  }
  std::ofstream file(path);
  for (std::string line; std::getline(recorded, line);) {
    if (!line.starts_with("set-touching")) file << line << '\n';
  }
  if (!file.flush()) throw Error(path + ": not all could be written");
}

}  // namespace displayfile::bench
