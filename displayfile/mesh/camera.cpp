#include "displayfile/mesh/mesh.h"

#include "clip/base/words.h"

namespace displayfile {

namespace {

constexpr Point3 kX(1.0, 0.0, 0.0), kY(0.0, 1.0, 0.0), kZ(0.0, 0.0, 1.0);
constexpr Point3 kMinusX(-1.0, 0.0, 0.0), kMinusY(0.0, -1.0, 0.0), kMinusZ(0.0, 0.0, -1.0);
constexpr Word<Upright> kUprights[] = {
    {{kMinusY, kX, kZ}, "x"},       {{kX, kY, kZ}, "y"},
    {{kX, kZ, kMinusY}, "z"},       {{kY, kMinusX, kZ}, "-x"},
    {{kMinusX, kMinusY, kZ}, "-y"}, {{kX, kMinusZ, kY}, "-z"},
};

}  // namespace

Upright upright(std::string_view axis) { return value_of(kUprights, axis, "up is"); }

}  // namespace displayfile
