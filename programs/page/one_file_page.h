#pragma once

#include <string>

#include "programs/page/page_files.h"

namespace displayfile {

/// The contents of a page.
struct PageContents {
  std::string title;       ///< plain text; empty: the template's
  std::string data;        ///< JSON
  std::string still = {};  ///< SVG, for browsers without WebAssembly or JavaScript
};

/// A page in one file that needs no network: a template of programs/page, in which
///
///  1. the content of `<title>` is the title,
///  2. each line `<link rel="stylesheet" href="NAME">` is the style sheet,
///  3. each line `<script src="NAME"></script>` is the script,
///  4. the line `<!-- still -->` is the SVG, without its XML declaration,
///  5. the content of `<script type="application/json" id="data">` is the data.
///
/// Throws Error if a file is missing, or the template has no place for a part.
std::string one_file_page(const PageFiles& files, const std::string& page,
                          const PageContents& contents);

}  // namespace displayfile
