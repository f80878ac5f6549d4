#include "displayfile/shading.h"

#include <string>

#include "clip/error.h"

namespace displayfile {

Shading shading(std::string_view text) {
  if (text == "flat") return Shading::flat;
  if (text == "gouraud") return Shading::gouraud;
  throw Error("shading is flat or gouraud, not '" + std::string(text) + "'");
}

std::string_view name_of(Shading shading) { return shading == Shading::flat ? "flat" : "gouraud"; }

}  // namespace displayfile
