#pragma once

#include <memory>
#include <string_view>

#include "displayfile/solids/combining_steps.h"
#include "displayfile/solids/exact_solid.h"

namespace displayfile {

/// The functions of the module `displayfile-solids` (clip/base/module.h). The module is compiled
/// with CGAL, which is under the GPL, and so is not part of the libraries. It uses no state of
/// theirs. The functions throw what the steps throw, std::bad_alloc, and other exceptions of the
/// standard library, whose `what` is a message.
struct SolidsModule {
  const char* version;
  /// As ExactSolid's constructor.
  std::shared_ptr<const ExactSolid::Body> (*bounded)(const BoundingTriangles& triangles,
                                                     std::string_view name);
  /// Neither is empty.
  std::shared_ptr<const ExactSolid::Body> (*combined)(SolidOperation operation,
                                                      const ExactSolid::Body& a,
                                                      const ExactSolid::Body& b,
                                                      CombiningSteps& steps);
  bool (*is_empty)(const ExactSolid::Body& body);
  /// As ExactSolid::rounded. `reach_of` returns the distance within which vertices count as
  /// collinear, for the largest magnitude of a coordinate.
  BoundingTriangles (*rounded)(const ExactSolid::Body& body, double (*reach_of)(double largest));
};

}  // namespace displayfile
