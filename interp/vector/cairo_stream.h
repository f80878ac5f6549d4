#pragma once

#include <ostream>

#include "interp/device/cairo.h"

namespace displayfile {

/// Cairo's callback for writing a surface to a stream, the closure.
inline cairo_status_t write_to_stream(void* stream, const unsigned char* data, unsigned length) {
  auto& out = *static_cast<std::ostream*>(stream);
  out.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(length));
  return out ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

}  // namespace displayfile
