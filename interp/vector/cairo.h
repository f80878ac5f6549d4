#pragma once

#include <cairo-pdf.h>
#include <cairo.h>

#include "displayfile/shared_library.h"

namespace displayfile {

/// Cairo's library and the functions of it that are used, loaded when it is first asked for: it
/// brings what draws on screens.
class Cairo {
  SharedLibrary library_{"libcairo.so.2"};

 public:
#define DISPLAYFILE_CAIRO(name) \
  decltype(&::cairo_##name) name = library_.function<decltype(&::cairo_##name)>("cairo_" #name)
  DISPLAYFILE_CAIRO(clip);
  DISPLAYFILE_CAIRO(close_path);
  DISPLAYFILE_CAIRO(create);
  DISPLAYFILE_CAIRO(destroy);
  DISPLAYFILE_CAIRO(fill);
  DISPLAYFILE_CAIRO(fill_preserve);
  DISPLAYFILE_CAIRO(line_to);
  DISPLAYFILE_CAIRO(move_to);
  DISPLAYFILE_CAIRO(new_path);
  DISPLAYFILE_CAIRO(pdf_surface_create_for_stream);
  DISPLAYFILE_CAIRO(pdf_surface_set_metadata);
  DISPLAYFILE_CAIRO(rectangle);
  DISPLAYFILE_CAIRO(restore);
  DISPLAYFILE_CAIRO(save);
  DISPLAYFILE_CAIRO(set_dash);
  DISPLAYFILE_CAIRO(set_fill_rule);
  DISPLAYFILE_CAIRO(set_line_cap);
  DISPLAYFILE_CAIRO(set_line_join);
  DISPLAYFILE_CAIRO(set_line_width);
  DISPLAYFILE_CAIRO(set_source_rgb);
  DISPLAYFILE_CAIRO(show_page);
  DISPLAYFILE_CAIRO(status);
  DISPLAYFILE_CAIRO(status_to_string);
  DISPLAYFILE_CAIRO(stroke);
  DISPLAYFILE_CAIRO(surface_destroy);
  DISPLAYFILE_CAIRO(surface_finish);
  DISPLAYFILE_CAIRO(surface_status);
#undef DISPLAYFILE_CAIRO
};

/// Throws Error, each time that it is called, if this system has none.
inline const Cairo& cairo() {
  static const Cairo library;
  return library;
}

}  // namespace displayfile
