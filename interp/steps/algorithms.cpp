#include "interp/steps/algorithms.h"

#include <array>

namespace displayfile {

std::span<const SteppedAlgorithm* const> stepped_algorithms() {
  static constexpr std::array kAlgorithms{&kBspSteps,      &kDepthSortSteps, &kZBufferSteps,
                                          &kScanLineSteps, &kScanLineZSteps, &kWarnockSteps,
                                          &kRayCastSteps,  &kRobertsSteps,   &kAppelSteps,
                                          &kFranklinSteps, &kPerimeterSteps};
  return kAlgorithms;
}

}  // namespace displayfile
