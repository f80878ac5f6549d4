#pragma once

#include <assimp/cfileio.h>

#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

/// What the import library opens files by: it is told that none is there but a mesh's neighbours,
/// and none is written. The neighbours must outlive it.
aiFileIO files_among(const NeighbourFiles& neighbours);

}  // namespace displayfile
