#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace displayfile {

/// The file of the program that this process runs; an error if the system does not report it.
std::filesystem::path file_of_program(std::error_code& error);
/// The file of the program or shared library that this code is in; empty if it is not known.
std::filesystem::path file_of_this_code();

/// Runs another program in the place of this one, with that command line. Returns, with the reason
/// in errno, if it cannot be started.
void replace_program(const std::filesystem::path& program, char** arguments);

/// A number that no other running process has.
unsigned number_of_process();

/// Loads a shared library by the system's loader; a null pointer stands for the program itself.
/// Null, with the loader's message in `why`, if there is none. It stays loaded.
void* load_library(const char* name, std::string& why);
/// The address of a function of C linkage; null, with the loader's message, if there is none.
void* address_in_library(void* library, const char* function, std::string& why);

}  // namespace displayfile
