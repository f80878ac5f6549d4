#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "displayfile/mesh/solid_triangles.h"

namespace displayfile {

/// Formats in which triangles are written, by extension, in the order of messages.
std::vector<std::string_view> written_mesh_formats();

/// The files that write_mesh writes for this one: for an .obj, also one for its colours beside it.
/// Throws Error, naming the file, for an extension that is none of those formats, and for .3mf in a
/// build without minizip.
std::vector<std::string> files_of_mesh(const std::string& file);

/// Writes triangles in the format that the file's name ends in; all of its files whole, or none.
///
/// .stl: binary, in single precision, without names and colours; in_single_precision must have
/// made the triangles. .obj: doubles in the shortest form that reads back to them, an object each,
/// with a name of its own (`pin`, `pin (2)`) that is one line, and with materials in a file beside
/// it if there are colours. .ply: binary, in double precision, all
/// in one, with colours of faces in parts of 255. .3mf: doubles as in .obj, in millimetres, an
/// object each, with its name and base materials of 255 parts.
///
/// Throws Error, naming the file, if it cannot be written or holds too many triangles.
void write_mesh(const SolidTriangles& solid, const std::string& file);

/// Writers for one format each.
void write_stl(const SolidTriangles& solid, const std::string& file);
void write_obj(const SolidTriangles& solid, const std::string& file);
void write_ply(const SolidTriangles& solid, const std::string& file);
void write_3mf(const SolidTriangles& solid, const std::string& file);
/// Throws Error, naming the file, where 3MF cannot be written.
void require_3mf(const std::string& file);

/// A component of a colour in parts of 255.
int part_of_255(double component);

}  // namespace displayfile
