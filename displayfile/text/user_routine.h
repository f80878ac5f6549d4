#pragma once

#include <span>
#include <string_view>

#include "displayfile/graphics_system.h"

namespace displayfile {

/// A user routine as drawing programs call it: its name, its arguments in words, such as "x y z",
/// and what it does.
struct UserRoutine {
  static constexpr int kVaries = -1;

  std::string_view name;
  std::string_view expected;      ///< the arguments; empty: none
  int arguments;                  ///< how many words they are; kVaries: as `expected` says
  std::string_view meaning;       ///< in sentences, with defaults in brackets
  std::string_view section = {};  ///< what it is about, such as "View"; they follow each other
};

/// All of them, in the order of the table: bindings to other languages are made from it, or checked
/// against it.
std::span<const UserRoutine> user_routines();

/// Calls the user routine of that name with arguments written as in a drawing program
/// (displayfile/text/drawing_programs.md), on one line. A number is the double that its shortest
/// decimal form stands for, so nothing is lost by writing it. Throws Error for an unknown routine
/// or wrong arguments, and what the routine throws.
void call_user_routine(GraphicsSystem& system, std::string_view name, std::string_view arguments);

}  // namespace displayfile
