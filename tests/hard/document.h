#pragma once

#include <span>
#include <string>
#include <vector>

#include "hard/tally.h"

namespace displayfile {

/// A table of gaps for some families.
struct Sweep {
  std::string families;
  std::vector<TableRow> rows;
};

/// tests/hard/README.md: the tables, a paragraph a family, and the sweeps. `off_rows` are those of
/// the families that touch, drawn with `set-touching off`.
std::string document(std::span<const TableRow> rows, std::span<const TableRow> off_rows,
                     std::span<const Sweep> sweeps, std::span<const Method> methods, int size,
                     int seeds, int random);

/// A line for each method: the largest gap at which more than a hundredth of the pixels is wrong.
std::string where_each_breaks(std::span<const TableRow> sweep, std::span<const Method> methods);

/// The notes of methods, a line each: the depths that OSMesa granted.
std::string notes(std::span<const Method> methods);

}  // namespace displayfile
