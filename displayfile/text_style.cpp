#include "displayfile/text_style.h"

#include <string>

#include "clip/error.h"

namespace displayfile {

using Alignment = TextStyle::Alignment;

Alignment alignment(std::string_view text) {
  for (const Alignment a : {Alignment::left, Alignment::centre, Alignment::right}) {
    if (text == name_of(a)) return a;
  }
  throw Error("expected left, centre or right, not '" + std::string(text) + "'");
}

std::string_view name_of(Alignment alignment) {
  return alignment == Alignment::left     ? "left"
         : alignment == Alignment::centre ? "centre"
                                          : "right";
}

}  // namespace displayfile
