#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <string>

namespace displayfile::test {

/// A copy of a file with a few changes, as a fuzzer makes them: bits, bytes, integers of four bytes
/// and numbers of a text, parts cut out, doubled or moved, an end cut off, a part of `other`.
std::string mutated(std::string bytes, const std::string& other, std::mt19937_64& random);

}  // namespace displayfile::test
