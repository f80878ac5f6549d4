#pragma once

#include <CLI/Option.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace displayfile {

// The placeholder of an option's value is its type name in CLI11: --help, the manual pages and
// completion all use it. It is written like the arguments of user routines, as alternatives with |
// between them, each of which is
//   segment          a word, in lower case, to be typed as it stands
//   roundoff[=EPS]   one after which more may stand
//   front=POSITION   one after which more must
//   IDS.npy          a file of that kind; OUT.{png,svg} of one of these kinds
//   FILE, FOLDER     any file, any folder
//   METHOD           a word from a list of the program (NamedValues)
//   WIDTHxHEIGHT     anything else in capitals, for the reader alone
// "KIND,..." are several with commas between them.

/// The values of a name in capitals: words, or files with these extensions. Null: none.
struct NamedValues {
  std::string_view name;
  std::vector<std::string> (*words)();
  std::vector<std::string> (*extensions)();
};

/// The values that completion offers.
struct OfferedValues {
  std::vector<std::string> words;  ///< one that ends in '=' is incomplete
  bool several = false;            ///< with commas between them
  bool files = false, folders = false;
  std::vector<std::string> extensions;  ///< of the files, without the dot; none: any file
};

/// The name of an option's value, and its check: "N" and "INT in [1 - 9]".
struct ValueName {
  std::string name, checked;
};
ValueName value_name(const CLI::Option& option);

/// The facts about an option that its description does not have, each after "; ": its range, its
/// default, whether it is required.
std::string option_facts(const CLI::Option& option);

OfferedValues offered_values(std::string_view value_name, std::span<const NamedValues> named);

}  // namespace displayfile
