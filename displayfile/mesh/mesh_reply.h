#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "displayfile/mesh/mesh.h"

namespace displayfile {

// The import program's reply: a mesh or an error message, as bytes. Arrays are sent as in memory,
// after all counts: import_process.md has the format.

/// Consumes bytes; throws on failure.
using ByteSink = std::function<void(std::span<const std::byte>)>;
/// Fills bytes; throws if fewer arrive.
using ByteSource = std::function<void(std::span<std::byte>)>;

void send_mesh(const Mesh& mesh, const ByteSink& sink);
void send_refusal(std::string_view message, const ByteSink& sink);

/// Thrown for an invalid reply.
class BadReply : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Receives a mesh or an error message. The input is not trusted: arrays allocate memory only as
/// their bytes arrive, all arrays together have at most `most_bytes`, and every index, count,
/// coordinate and colour is checked to be one that MeshBuilder could make. Throws BadReply
/// otherwise, and what the source throws.
std::variant<Mesh, std::string> receive_reply(const ByteSource& source, std::size_t most_bytes);

}  // namespace displayfile
