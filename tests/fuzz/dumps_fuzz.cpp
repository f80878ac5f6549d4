// libFuzzer target: two dumps, one after the other with a zero between them. Whatever they hold,
// comparing them throws nothing but Error, and a dump does not differ from itself.

#include <string_view>

#include "clip/base/error.h"
#include "displayfile/text/dump_compare.h"
#include "tests/fuzz/failed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace displayfile;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::string_view a = all.substr(0, all.find('\0'));
  const std::string_view b = a.size() < all.size() ? all.substr(a.size() + 1) : a;
  try {
    require_dump(a, "a");
    if (first_difference(a, a)) fuzz::failed("a dump differs from itself");
    const bool differ = first_difference(a, b).has_value();
    if (differ != first_difference(b, a).has_value()) {
      fuzz::failed("one differs from the other, which does not differ from it");
    }
  } catch (const Error&) {
  }
  return 0;
}
