// From mesh files to meshes and to display files, by the readers here and by the import library in
// the same process: how many times as fast ours are. tests/bench/readers makes the files.

#include <filesystem>
#include <span>

#include "displayfile/mesh/fitted_view.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/mesh.h"
#include "tests/bench/benchmark.h"

namespace displayfile::bench {

const char* const kAbout = "From mesh files to display files, beside the import library";

namespace {

/// As import_meshes enters a bare mesh.
void enter_bare(const Mesh& mesh) {
  GraphicsSystem system;
  fit_view(std::span(&mesh, 1), system);
  enter_meshes(std::span(&mesh, 1), system);
}

}  // namespace

void run(const Options& options) {
  for (const std::string& path : options.inputs) {
    const auto theirs = [&] { return read_by_import_library(path, false); };
    const Spread to_mesh = times_faster(
        options.rounds, [&] { read_mesh(path); }, theirs);
    const Spread to_file = times_faster(
        options.rounds, [&] { enter_bare(read_mesh(path)); }, [&] { enter_bare(theirs()); });
    print_row({{"table", "times as fast as Assimp " + import_library_version().value_or("(none)")},
               {"file", std::filesystem::path(path).filename().string()},
               {"triangles", read_mesh(path).faces()},
               {"to a mesh", figures(to_mesh)},
               {"to a display file", figures(to_file)}});
  }
}

}  // namespace displayfile::bench
