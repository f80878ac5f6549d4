#pragma once

#include <string>

namespace displayfile {

// The kinds of pictures, as type names of options' values (programs/manual/value_name.h).

std::string picture_file();          ///< OUT.{png,svg}, of all formats
std::string picture_format_words();  ///< png|svg
std::string raster_device_words();   ///< software|osmesa

}  // namespace displayfile
