#include "clip/base/work_budget.h"
#include "displayfile/mesh/format_not_read.h"
#include "displayfile/mesh/import_library.h"
#include "displayfile/mesh/import_process.h"

namespace displayfile {

/// For systems that cannot limit processes as import_process.cpp does: the library runs in this
/// process, for the allowed formats.
Mesh read_by_import_process(const std::string& path, bool with_normals,
                            const ImportLimits& limits) {
  if (!limits.any_format) require_allowed_format(path);
  try {
    return read_by_import_library(path, with_normals);
  } catch (const LimitReached&) {
    throw;
  } catch (const Error& error) {
    throw NotRead(error.what());
  }
}

}  // namespace displayfile
