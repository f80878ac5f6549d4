#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace displayfile {

// Files by descriptors, which both systems' C libraries have. Bytes are written and read as they
// are, and no started process inherits a descriptor. A failure leaves its reason in errno.

/// Creates a file, to read and write; -1 if it exists or cannot be created.
int create_file(const std::string& path);
/// Creates a file without a name in a folder (empty: the working folder), and sets `path` to a path
/// by which it can be opened. -1 if the system or the file system has no such files.
int create_nameless_file(const std::filesystem::path& folder, std::string& path);
/// Names that file; false if it cannot have that name.
bool name_nameless_file(int descriptor, const std::string& name);
/// Empties an existing file, device or pipe, to write; -1 if it cannot be opened.
int open_emptied(const std::string& path);
/// The descriptor of standard output.
int standard_output();
void close_file(int descriptor);
/// Renames a file, and atomically replaces an existing file of the new name.
bool rename_file(const std::string& from, const std::string& to);

/// False for a file that this process may not write to.
bool may_write(const std::string& path);
/// False for a descriptor that is closed or open for reading alone.
bool can_write(int descriptor);
/// Sets the file's permissions, if the system has permissions of that kind.
void set_permissions(int descriptor, std::filesystem::perms permissions);

/// False if not all could be written.
bool write_all(int descriptor, const char* bytes, std::size_t count);
/// Returns the number of bytes read; 0 at the end, negative for a failure.
std::ptrdiff_t read_some(int descriptor, char* bytes, std::size_t count);
/// Moves to the file's first byte.
void rewind_file(int descriptor);

/// Waits until the file's data is on the disk. False if that fails; true for file systems without
/// such an operation.
bool put_on_disk(int descriptor);
/// The same for the names in a folder; an empty path is the working folder. True also if the folder
/// may not be opened: its contents may be usable all the same.
bool put_names_on_disk(const std::filesystem::path& folder);

// A held folder can be found again after it has been moved. Where the system does not support this,
// every folder is kNotHeld, and paths start from the working folder.

inline constexpr int kNotHeld = -1;

/// A number for the folder; kNotHeld if it cannot be held.
int hold_folder(const std::filesystem::path& folder);
void release_folder(int held);
/// Removes the folder, by its path from a held one, if it is empty.
void remove_empty_folder(int held, const std::filesystem::path& path);

/// Removes a file or an empty folder; false if neither could be removed. For signal handlers too.
bool remove_path(const char* path) noexcept;

/// Called at process start: standard input, output and error that are closed stay closed for
/// readers and writers, but no opened file takes their descriptors, so that no message is written
/// into a picture. Bytes and ends of lines pass through all three as they are.
void keep_standard_descriptors();

/// True if standard error is a terminal on which a line can be written over.
bool errors_are_on_terminal();

}  // namespace displayfile
