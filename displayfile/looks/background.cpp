#include "displayfile/looks/background.h"

#include "clip/base/error.h"

namespace displayfile {

void require_colour_of_fills(HiddenMethod method, const Background& background) {
  if (!is_colour_rule(method) || background.kind != Background::Kind::none) return;
  throw Error(
      "the colour rule fills with the background's colour, and there is no background: expected "
      "one, or a picture of pixels, which can omit hidden parts");
}

}  // namespace displayfile
