#include "clip/base/error.h"
#include "tests/bench/command/embree_rays.h"

namespace displayfile::bench {

struct EmbreeRays::Scene {};
std::optional<std::string> EmbreeRays::version() { return std::nullopt; }
int EmbreeRays::packet_width() { return 0; }
EmbreeRays::Input::Input(const Triangles&, const PictureSize& of_picture) : size(of_picture) {}
EmbreeRays::EmbreeRays(const Input&, int, Quality) { throw Error("this build has no Embree"); }
EmbreeRays::~EmbreeRays() = default;
void EmbreeRays::cast(int, int, Hits&) const {}

}  // namespace displayfile::bench
