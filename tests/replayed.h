#pragma once

#include <string>
#include <string_view>

#include "displayfile/files.h"
#include "tests/error_of.h"

// The result of a drawing program, which is called scene.draw.

namespace displayfile::test {

inline GraphicsSystem replayed(std::string_view program) {
  GraphicsSystem system;
  replay(program, "scene.draw", system);
  return system;
}

inline std::string dump_of(std::string_view program) {
  return dump(replayed(program).display_file());
}

inline std::string error_of_program(std::string_view program, GraphicsSystem& system) {
  return error_of([&] { replay(program, "scene.draw", system); });
}
inline std::string error_of_program(std::string_view program) {
  GraphicsSystem system;
  return error_of_program(program, system);
}

}  // namespace displayfile::test
