#include "clip/base/error.h"
#include "tests/bench/command/gl2ps_sort.h"

namespace displayfile::bench {

std::optional<std::string> Gl2psSort::version() { return std::nullopt; }
double Gl2psSort::sort() const { throw Error("this build has no gl2ps"); }
bool Gl2psSort::ends() const { throw Error("this build has no gl2ps"); }
std::vector<Gl2psSort::Piece> Gl2psSort::pieces() const { throw Error("this build has no gl2ps"); }

}  // namespace displayfile::bench
