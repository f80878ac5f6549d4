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

// What the import program answers: a mesh, or why there is none, as bytes. Arrays go as they stand
// in memory, each after the counts of all: import_process.md has the form.

/// Takes bytes; throws if it cannot.
using ByteSink = std::function<void(std::span<const std::byte>)>;
/// Fills bytes; throws if fewer come.
using ByteSource = std::function<void(std::span<std::byte>)>;

void send_mesh(const Mesh& mesh, const ByteSink& sink);
void send_refusal(std::string_view message, const ByteSink& sink);

/// A reply that no import program of this build gives.
class BadReply : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Receives a mesh, or the message of why there is none. Nothing that comes is believed: an array
/// takes no memory before its bytes are there, all arrays together have at most `most_bytes`, and
/// the mesh is one that MeshBuilder would make, every index, count, coordinate and colour in its
/// range. Throws BadReply for anything else, and what the source throws.
std::variant<Mesh, std::string> receive_reply(const ByteSource& source, std::size_t most_bytes);

}  // namespace displayfile
