#include "clip/system/standard_streams.h"

#include <fcntl.h>
#include <io.h>

#include <initializer_list>

namespace displayfile {

/// The C library gives the descriptors 0 to 2 to nothing else.
void keep_standard_descriptors() {
  for (const int descriptor : {0, 1, 2}) {
    if (::_get_osfhandle(descriptor) >= 0) ::_setmode(descriptor, _O_BINARY);
  }
}

/// Consoles there may be, but not every one of them obeys what a terminal does.
bool errors_are_on_terminal() { return false; }

}  // namespace displayfile
