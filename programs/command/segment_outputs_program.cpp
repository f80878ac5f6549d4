// The command `displayfile check` by itself, for tests/check-goldens, so that a compiler need not
// compile code that draws.

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "programs/command/check_command.h"

int main(int argc, char** argv) {
  try {
    CLI::App app("Compares segment outputs with golden files.", "segment_outputs");
    app.require_subcommand(1);
    displayfile::CheckCommand check;
    check.add_to(app);
    CLI11_PARSE(app, argc, argv);
    return check.run();
  } catch (const std::exception& e) {
    std::cerr << "segment_outputs: " << e.what() << '\n';
  }
  return 2;
}
