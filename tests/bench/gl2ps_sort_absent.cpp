#include "clip/error.h"
#include "tests/bench/gl2ps_sort.h"

namespace displayfile::bench {

std::optional<std::string> Gl2psSort::version() { return std::nullopt; }
double Gl2psSort::seconds(const DeviceScene&) { throw Error("this build has no gl2ps"); }
std::size_t Gl2psSort::fragments(const DeviceScene&) { throw Error("this build has no gl2ps"); }

}  // namespace displayfile::bench
