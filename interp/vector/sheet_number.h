#pragma once

#include <fmt/format.h>

#include <string>

namespace displayfile {

/// A length on a sheet, as written to files: to a hundred-thousandth of a millimetre. Views are
/// computed to more digits than that, and no printer, plotter or cutter is that precise.
inline std::string sheet_number(double mm) {
  std::string text = fmt::format("{:.5f}", mm);
  text.resize(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace displayfile
