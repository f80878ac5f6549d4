#include "hard/document.h"

#include <fmt/format.h>

#include "hard/hard_cases.h"
#include "interp/osmesa.h"

namespace displayfile {

std::string where_each_breaks(std::span<const TableRow> sweep, std::span<const Method> methods) {
  std::string text;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::string first_wrong, breaks;
    for (const TableRow& row : sweep) {
      if (first_wrong.empty() && row.tally.wrong[i] > 0) first_wrong = row.name;
      if (breaks.empty() && row.tally.wrong[i] * 100 > row.tally.pixels) breaks = row.name;
    }
    text += fmt::format("- {}: ", methods[i].name);
    if (first_wrong.empty()) {
      text += "no wrong pixel at any gap\n";
    } else {
      text += fmt::format("first wrong pixels at {}, more than one in a hundred {}\n", first_wrong,
                          breaks.empty() ? "at no gap" : "from " + breaks + " on");
    }
  }
  return text;
}

std::string osmesa_note(std::span<const Method> methods) {
  std::string text;
  for (const Method& method : methods) {
    for (int bits : {32, 24, 16}) {
      if (method.column != fmt::format("osmesa {}", bits)) continue;
      text += fmt::format("- {}: {}\n", method.name, osmesa_description(bits));
    }
  }
  return text;
}

std::string document(std::span<const TableRow> rows, std::span<const Sweep> sweeps,
                     std::span<const Method> methods, int size, int seeds) {
  (void)sweeps;
  (void)size;
  (void)seeds;
  return markdown_table(rows, methods, "family");
}

}  // namespace displayfile
