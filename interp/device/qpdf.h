#pragma once

#include <qpdf/qpdf-c.h>

#include "clip/base/shared_library.h"

namespace displayfile {

/// The library that edits PDF files, and the functions used, loaded on first use.
class Qpdf {
  SharedLibrary library_{DISPLAYFILE_QPDF_SONAME};

 public:
#define DISPLAYFILE_QPDF(name) DISPLAYFILE_LIBRARY_FUNCTION(library_, qpdf_, name)
  DISPLAYFILE_QPDF(cleanup);
  DISPLAYFILE_QPDF(get_buffer);
  DISPLAYFILE_QPDF(get_buffer_length);
  DISPLAYFILE_QPDF(get_error);
  DISPLAYFILE_QPDF(get_error_full_text);
  DISPLAYFILE_QPDF(get_page_n);
  DISPLAYFILE_QPDF(get_root);
  DISPLAYFILE_QPDF(has_error);
  DISPLAYFILE_QPDF(init);
  DISPLAYFILE_QPDF(init_write_memory);
  DISPLAYFILE_QPDF(make_indirect_object);
  DISPLAYFILE_QPDF(oh_append_item);
  DISPLAYFILE_QPDF(oh_get_key);
  DISPLAYFILE_QPDF(oh_get_page_content_data);
  DISPLAYFILE_QPDF(oh_new_array);
  DISPLAYFILE_QPDF(oh_new_dictionary);
  DISPLAYFILE_QPDF(oh_new_name);
  DISPLAYFILE_QPDF(oh_new_null);
  DISPLAYFILE_QPDF(oh_new_stream);
  DISPLAYFILE_QPDF(oh_new_unicode_string);
  DISPLAYFILE_QPDF(oh_remove_key);
  DISPLAYFILE_QPDF(oh_replace_key);
  DISPLAYFILE_QPDF(oh_replace_stream_data);
  DISPLAYFILE_QPDF(read_memory);
  DISPLAYFILE_QPDF(set_deterministic_ID);
  DISPLAYFILE_QPDF(set_object_stream_mode);
  DISPLAYFILE_QPDF(silence_errors);
  DISPLAYFILE_QPDF(write);
#undef DISPLAYFILE_QPDF
};

/// Throws Error, at each call, if this system has none.
inline const Qpdf& qpdf() {
  static const Qpdf library;
  return library;
}

}  // namespace displayfile
