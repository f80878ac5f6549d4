// A build without CGAL: solids are not combined.

#include "clip/base/error.h"
#include "displayfile/solids/exact_solid.h"

namespace displayfile {

namespace {

[[noreturn]] void say_so() {
  throw Error(
      "combining solids needs CGAL, which this build was made without: install it (Debian: "
      "libcgal-dev) and GMP, and build again");
}

}  // namespace

ExactSolid::ExactSolid(const BoundingTriangles& /*triangles*/, std::string_view /*name*/) {
  say_so();
}

ExactSolid ExactSolid::combined(SolidOperation /*operation*/, const ExactSolid& /*a*/,
                                const ExactSolid& /*b*/, std::string_view /*name*/) {
  say_so();
}

bool ExactSolid::is_empty() const { say_so(); }

BoundingTriangles ExactSolid::rounded() const { say_so(); }

}  // namespace displayfile
