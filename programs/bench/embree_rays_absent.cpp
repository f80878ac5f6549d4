#include "clip/error.h"
#include "programs/bench/embree_rays.h"

namespace displayfile::bench {

struct EmbreeRays::Scene {};
std::optional<std::string> EmbreeRays::version() { return std::nullopt; }
EmbreeRays::EmbreeRays(const Triangles&, const PictureSize&, int) {
  throw Error("this build has no Embree");
}
EmbreeRays::~EmbreeRays() = default;
void EmbreeRays::cast(int, int, Hits&) const {}

}  // namespace displayfile::bench
