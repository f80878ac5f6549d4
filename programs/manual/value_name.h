#pragma once

#include <CLI/Option.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace displayfile {

// What stands for an option's value is its type name in CLI11: --help, the manual pages and
// completion all have it from there. It is written as the arguments of user routines are,
// alternatives with | between them, and each of them is
//   segment          a word, in lower case, to be typed as it stands
//   roundoff[=EPS]   one after which more may stand
//   front=POSITION   one after which more must
//   IDS.npy          a file of that kind; OUT.{png,svg} of one of these kinds
//   FILE, FOLDER     any file, any folder
//   METHOD           what the program has a list of (NamedValues)
//   WIDTHxHEIGHT     anything else in capitals, for the reader alone
// "KIND,..." are several with commas between them.

/// The values of a name in capitals: words, or files with these extensions. Null: none.
struct NamedValues {
  std::string_view name;
  std::vector<std::string> (*words)();
  std::vector<std::string> (*extensions)();
};

/// What may be typed for a value.
struct OfferedValues {
  std::vector<std::string> words;  ///< one that ends in '=' must go on
  bool several = false;            ///< with commas between them
  bool files = false, folders = false;
  std::vector<std::string> extensions;  ///< of the files, without the dot; none: any file
};

/// The name of an option's value, and its check: "N" and "INT in [1 - 9]".
struct ValueName {
  std::string name, checked;
};
ValueName value_name(const CLI::Option& option);

OfferedValues offered_values(std::string_view value_name, std::span<const NamedValues> named);

}  // namespace displayfile
