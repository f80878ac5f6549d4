// libFuzzer target: whatever the text, replaying it throws nothing but Error, and what its lines
// drew, those that are refused left out, is recorded and replayed to the same display file.

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/failed.h"
#include "tests/fuzz/record_and_replay.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view program(reinterpret_cast<const char*>(data), size);
  try {
    displayfile::GraphicsSystem system;
    displayfile::replay(program, "program", system);
  } catch (const displayfile::Error&) {
  }
  if (const auto difference = displayfile::difference_after_record_and_replay(program)) {
    displayfile::fuzz::failed("the recording's dump differs: " + *difference);
  }
  return 0;
}
