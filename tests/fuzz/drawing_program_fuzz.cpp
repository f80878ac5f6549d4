// libFuzzer target: whatever the text, replaying it throws nothing but Error, and what it drew
// before can be dumped, recorded and replayed to the same display file.
//
//   cmake -S . -B build/fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DDISPLAYFILE_FUZZ=ON
//         -DDISPLAYFILE_SANITIZE=ON -DCMAKE_BUILD_TYPE=RelWithDebInfo
//   ninja -C build/fuzz drawing_program_fuzz
//   build/fuzz/tests/fuzz/drawing_program_fuzz -dict=tests/fuzz/drawing_program.dict
//         -max_total_time=600 NEW_CORPUS tests/fuzz/corpus/drawing_program

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/record_and_replay.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view program(reinterpret_cast<const char*>(data), size);
  if (const auto difference = displayfile::difference_after_record_and_replay(program)) {
    std::fprintf(stderr, "the recording's dump differs: %s\n", difference->c_str());
    std::abort();
  }
  return 0;
}
