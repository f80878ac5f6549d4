#pragma once

#include <cairo-pdf.h>
#include <cairo-ps.h>
#include <cairo.h>

#include <new>
#include <string>
#include <string_view>

#include "clip/base/error.h"
#include "clip/base/shared_library.h"

namespace displayfile {

/// Cairo's library and the functions used, loaded on first use, since it depends on screen-drawing
/// libraries.
class Cairo {
  SharedLibrary library_{"libcairo.so.2"};

 public:
#define DISPLAYFILE_CAIRO(name) DISPLAYFILE_LIBRARY_FUNCTION(library_, cairo_, name)
  DISPLAYFILE_CAIRO(clip);
  DISPLAYFILE_CAIRO(close_path);
  DISPLAYFILE_CAIRO(copy_path_flat);
  DISPLAYFILE_CAIRO(create);
  DISPLAYFILE_CAIRO(destroy);
  DISPLAYFILE_CAIRO(fill);
  DISPLAYFILE_CAIRO(fill_preserve);
  DISPLAYFILE_CAIRO(font_options_create);
  DISPLAYFILE_CAIRO(font_options_destroy);
  DISPLAYFILE_CAIRO(font_options_set_antialias);
  DISPLAYFILE_CAIRO(font_options_set_hint_metrics);
  DISPLAYFILE_CAIRO(font_options_set_hint_style);
  DISPLAYFILE_CAIRO(image_surface_create);
  DISPLAYFILE_CAIRO(image_surface_get_data);
  DISPLAYFILE_CAIRO(image_surface_get_stride);
  DISPLAYFILE_CAIRO(line_to);
  DISPLAYFILE_CAIRO(mask);
  DISPLAYFILE_CAIRO(move_to);
  DISPLAYFILE_CAIRO(new_path);
  DISPLAYFILE_CAIRO(path_destroy);
  DISPLAYFILE_CAIRO(pattern_add_color_stop_rgb);
  DISPLAYFILE_CAIRO(pattern_create_linear);
  DISPLAYFILE_CAIRO(pattern_destroy);
  DISPLAYFILE_CAIRO(pdf_surface_create_for_stream);
  DISPLAYFILE_CAIRO(pdf_surface_set_metadata);
  DISPLAYFILE_CAIRO(pop_group);
  DISPLAYFILE_CAIRO(ps_surface_create_for_stream);
  DISPLAYFILE_CAIRO(ps_surface_set_eps);
  DISPLAYFILE_CAIRO(push_group);
  DISPLAYFILE_CAIRO(rectangle);
  DISPLAYFILE_CAIRO(restore);
  DISPLAYFILE_CAIRO(rotate);
  DISPLAYFILE_CAIRO(save);
  DISPLAYFILE_CAIRO(scale);
  DISPLAYFILE_CAIRO(select_font_face);
  DISPLAYFILE_CAIRO(set_dash);
  DISPLAYFILE_CAIRO(set_fill_rule);
  DISPLAYFILE_CAIRO(set_font_options);
  DISPLAYFILE_CAIRO(set_font_size);
  DISPLAYFILE_CAIRO(set_line_cap);
  DISPLAYFILE_CAIRO(set_line_join);
  DISPLAYFILE_CAIRO(set_line_width);
  DISPLAYFILE_CAIRO(set_source);
  DISPLAYFILE_CAIRO(set_source_rgb);
  DISPLAYFILE_CAIRO(set_tolerance);
  DISPLAYFILE_CAIRO(show_page);
  DISPLAYFILE_CAIRO(show_text);
  DISPLAYFILE_CAIRO(status);
  DISPLAYFILE_CAIRO(status_to_string);
  DISPLAYFILE_CAIRO(stroke);
  DISPLAYFILE_CAIRO(surface_destroy);
  DISPLAYFILE_CAIRO(surface_finish);
  DISPLAYFILE_CAIRO(surface_flush);
  DISPLAYFILE_CAIRO(surface_status);
  DISPLAYFILE_CAIRO(tag_begin);
  DISPLAYFILE_CAIRO(tag_end);
  DISPLAYFILE_CAIRO(text_extents);
  DISPLAYFILE_CAIRO(text_path);
  DISPLAYFILE_CAIRO(translate);
#undef DISPLAYFILE_CAIRO
};

/// Throws Error, at each call, if this system has none.
inline const Cairo& cairo() {
  static const Cairo library;
  return library;
}

/// Throws std::bad_alloc if Cairo was out of memory, and Error, "`what`: " with Cairo's message,
/// for other failures.
inline void require_cairo_success(cairo_status_t status, std::string_view what) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  throw Error(std::string(what).append(": ").append(cairo().status_to_string(status)));
}

}  // namespace displayfile
