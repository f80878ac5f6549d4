#include "programs/mesh_words.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "clip/error.h"

namespace displayfile {

namespace {

/// R,G,B, each 0 to 1.
Colour colour_of(const std::string& word) {
  Colour colour(0.0);
  const char *at = word.data(), *const end = at + word.size();
  for (int part = 0; part < 3; ++part) {
    const auto [stop, failure] = std::from_chars(at, end, colour[part]);
    const bool ends_well = part < 2 ? stop != end && *stop == ',' : stop == end;
    if (failure != std::errc{} || !ends_well || !(colour[part] >= 0.0 && colour[part] <= 1.0)) {
      throw Error(fmt::format(
          "--colour {}: expected red, green and blue, each 0 to 1, such as 0.8,0.2,0.1", word));
    }
    at = stop + 1;
  }
  return colour;
}

}  // namespace

void MeshWords::add_to(CLI::App& command) {
  command.add_option("--colour", colour,
                     "R,G,B, each 0 to 1: of all faces of meshes, in place of their files' colours "
                     "and a program's fill style");
}

MeshOptions MeshWords::options() const {
  MeshOptions options;
  if (!colour.empty()) options.colour = colour_of(colour);
  return options;
}

}  // namespace displayfile
