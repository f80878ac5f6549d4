#include "clip/error.h"
#include "tests/bench/embree_rays.h"

namespace displayfile::bench {

struct EmbreeRays::Scene {};
std::optional<std::string> EmbreeRays::version() { return std::nullopt; }
EmbreeRays::EmbreeRays(const FillScene&, int, int, int) { throw Error("this build has no Embree"); }
EmbreeRays::~EmbreeRays() = default;
void EmbreeRays::cast(int, int, std::vector<FillScene::Fill>&) const {}

}  // namespace displayfile::bench
