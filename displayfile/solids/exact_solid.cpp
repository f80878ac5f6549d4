#include "displayfile/solids/exact_solid.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <string>

#include "clip/base/budgeted_work.h"
#include "clip/base/error.h"
#include "clip/base/module.h"
#include "clip/surfaces.h"
#include "displayfile/solids/combining_steps.h"
#include "displayfile/solids/solids_module.h"

namespace displayfile {

namespace {

const SolidsModule& solids_module() {
  static const auto& module =
      module_interface<SolidsModule>("displayfile-solids", "combining solids");
  return module;
}

/// Returns the result of `work`. Exceptions of the module's own become an Error, after `context`.
template <class Work>
auto by_module(const std::string& context, const Work& work) {
  try {
    return work(solids_module());
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(context + error.what());
  }
}

/// Faces that a modelling transformation has turned are planar only up to rounding, and so are
/// their diagonals in line with their sides: both hold within the reach of doubles
/// (clip/surfaces.h).
double reach_of_doubles(double largest) { return entered_reach(kUnlessSet, largest); }

}  // namespace

ExactSolid::ExactSolid(const BoundingTriangles& triangles, std::string_view name) {
  body_ = by_module({}, [&](const SolidsModule& m) { return m.bounded(triangles, name); });
}

ExactSolid ExactSolid::combined(SolidOperation operation, const ExactSolid& a, const ExactSolid& b,
                                std::string_view name) {
  if (a.is_empty() || b.is_empty()) {
    const bool gone = operation == SolidOperation::intersect ||
                      (operation == SolidOperation::difference && a.is_empty());
    if (gone) return ExactSolid(nullptr);
    return a.is_empty() ? b : a;
  }
  const NamedWork work({"combining solids"});
  CountedSteps steps(fmt::format("the {} with {}", name_of(operation), name));
  return ExactSolid(by_module(steps.what() + " was not found: ", [&](const SolidsModule& m) {
    return m.combined(operation, *a.body_, *b.body_, steps);
  }));
}

bool ExactSolid::is_empty() const { return body_ == nullptr || solids_module().is_empty(*body_); }

BoundingTriangles ExactSolid::rounded() const {
  if (body_ == nullptr) return {};
  return by_module({}, [&](const SolidsModule& m) { return m.rounded(*body_, reach_of_doubles); });
}

}  // namespace displayfile
