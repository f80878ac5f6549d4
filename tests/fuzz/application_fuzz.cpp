// libFuzzer target: whatever an application calls, and in whatever order, only Error is thrown; and
// its recorded calls replay to the same display file.

#include <sstream>

#include "displayfile/files.h"
#include "displayfile/text/dump_compare.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/random_application.h"

namespace {

/// A sort whose cuts would lie farther away than any double is refused, and the segment still open.
void close_open_segment(displayfile::GraphicsSystem& system) {
  if (!system.open_segment_name()) return;
  try {
    system.close_segment();
  } catch (const displayfile::Error&) {
    system.set_hidden_surfaces({.removal = false});
    system.close_segment();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace displayfile;
  constexpr std::uint64_t kEachByte = 0x0101010101010101u;
  fuzz::FuzzInput input({data, size});
  std::ostringstream recording;
  Recorder recorder(recording);
  GraphicsSystem first, second;
  first.set_recorder(&recorder);
  test::RandomApplication application([&] { return input.byte() * kEachByte; }, first);
  while (!input.empty()) application.call();
  while (first.counts().solids_open > 0) first.discard_solid();
  close_open_segment(first);
  while (first.counts().transformations_saved > 0) first.restore_transformation_3();
  replay(recording.str(), "recording", second);
  if (const auto difference =
          first_difference(dump(second.display_file()), dump(first.display_file()))) {
    fuzz::failed("the recording's dump differs: " + *difference);
  }
  return 0;
}
