#pragma once

#include <span>
#include <string>
#include <vector>

#include "hard/methods.h"
#include "interp/device/picture.h"
#include "programs/scenes/scene.h"

namespace displayfile {

/// The counts of a table's row.
struct Tally {
  long long scenes = 0, polygons = 0, pixels = 0;
  std::vector<long long> wrong;  ///< pixels, for each method

  Tally& operator+=(const Tally& other);
};

/// One scene, drawn by each method, against its right picture, which is square.
Tally judge(const Scene& scene, const Picture& right, std::span<const Method> methods);

/// A table to print: a name for each row, and its counts.
struct TableRow {
  std::string name;
  Tally tally;
};

/// For people: rows and columns aligned, with the total.
std::string text_table(std::span<const TableRow> rows, std::span<const Method> methods,
                       const std::string& first_column);
/// The same table in Markdown.
std::string markdown_table(std::span<const TableRow> rows, std::span<const Method> methods,
                           const std::string& first_column);
/// For programs: comma-separated, one line a row, without the total.
std::string csv_table(std::span<const TableRow> rows, std::span<const Method> methods,
                      const std::string& first_column);

Tally total(std::span<const TableRow> rows);

}  // namespace displayfile
