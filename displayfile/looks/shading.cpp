#include "displayfile/looks/shading.h"

#include "clip/words.h"

namespace displayfile {

namespace {

constexpr Word<Shading> kShadings[] = {
    {Shading::flat, "flat"}, {Shading::gouraud, "gouraud"}, {Shading::phong, "phong"}};

}  // namespace

Shading shading(std::string_view text) { return value_of(kShadings, text, "shading is"); }
std::string_view name_of(Shading shading) { return word_of(kShadings, shading); }

}  // namespace displayfile
