#pragma once

#include <span>
#include <string_view>

#include "clip/surfaces.h"
#include "interp/steps/listing.h"

namespace displayfile {

class StepItems;
class StepRecord;

/// An algorithm that records steps: one file, which ends with its entry, and one line of the table
/// in algorithms.cpp.
struct SteppedAlgorithm {
  HiddenMethod method;
  std::string_view title;
  std::string_view source;
  std::string_view code;
  std::span<const ListingLine> listing;
  std::span<const PanelEntry> panels;
  void (*run)(const StepItems& scene, StepRecord& record);
};

extern const SteppedAlgorithm kBspSteps, kDepthSortSteps, kZBufferSteps, kScanLineSteps,
    kScanLineZSteps, kWarnockSteps, kRayCastSteps, kRobertsSteps, kAppelSteps, kFranklinSteps,
    kPerimeterSteps;

std::span<const SteppedAlgorithm* const> stepped_algorithms();

}  // namespace displayfile
