#pragma once

#include <assimp/cfileio.h>

#include <map>
#include <string>

#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

/// The files that the import library may open, and names of others of which a file means something
/// else: the name as it is written, and what it stands for.
struct OpenFiles {
  const NeighbourFiles& neighbours;
  const std::map<std::string, std::string>& meant_names;
};

/// How the import library opens files: none is there but a mesh's neighbours, and none is written.
/// A name that means another opens that one, if it is there. The files must outlive it.
aiFileIO files_among(const OpenFiles& files);

}  // namespace displayfile
