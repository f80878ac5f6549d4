#pragma once

#include <assimp/cfileio.h>

#include <map>
#include <string>

#include "displayfile/mesh/neighbour_files.h"

namespace displayfile {

/// The files that the import library may open, and aliases: names as written in a file, and the
/// names that they stand for.
struct OpenFiles {
  const NeighbourFiles& neighbours;
  const std::map<std::string, std::string>& meant_names;
};

/// The import library's file access: only a mesh's neighbours exist, and nothing is written. An
/// alias opens the file that it stands for, if that exists. `files` must outlive it.
aiFileIO files_among(const OpenFiles& files);

}  // namespace displayfile
