#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "displayfile/segments/display_file.h"
#include "displayfile/text/dump_compare.h"
#include "programs/options/mesh_words.h"

namespace displayfile {

/// Inputs as drawn, and their dump.
struct DumpedInputs {
  std::span<const std::string> inputs;
  const DisplayFile& file;
  std::string_view dump;
};

/// The line of the last input, counted from 1, that the differing instruction of the dump comes
/// from: the routine of its primitive, or the one that set its attribute. Nothing if that is not
/// known: if an input is a mesh or standard input, or if the line is of another input; for texts;
/// where segments are renamed; and in sorted segments for lines, and for polygons after
/// set-pick-id. The inputs are replayed once more, for pictures of that aspect ratio.
std::optional<std::size_t> program_line_of(const DumpDifference& difference,
                                           const DumpedInputs& dumped, const MeshWords& meshes,
                                           double aspect);

}  // namespace displayfile
