#pragma once

#include <atomic>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "interp/draw/picture_plan.h"

namespace displayfile {

/// Warnings about contents that vectors, or pixels, omit, given once for all pictures of a call of
/// the command.
class NotInPicture {
 public:
  /// Notes which of the application's drawing and which options a picture leaves out. Shadows are
  /// the map's, which is drawn for methods of image space too. Several threads may call it at a
  /// time.
  void note(const GraphicsSystem& system, const PicturePlan& plan);
  /// Notes the warnings of drawing a picture. Those of annotation, which hold for that picture
  /// alone, are given at once, with its name.
  void note(const std::vector<DrawWarning>& warned, const std::string& picture);
  /// Warns, with the output's name as given, if something was left out
  /// (programs/process/warnings.h).
  void warn(const std::string& output) const;

 private:
  enum LeftOut : unsigned {
    kPhong = 1,
    kShadows = 2,
    kSamples = 4,
    kTexts = 8,
    kPickIds = 16,      // of vectors by other methods
    kHiddenLines = 32,  // that a program set
    kElements = 64,     // these three in pixels
    kSeams = 128,
    kPrecision = 256,
    kShadowsOfDevice = 512,
    kOutlines = 1024,    // of letters, in pixels
    kSeamsOfMap = 2048,  // these two in vectors by other methods
    kPrecisionOfMap = 4096,
    kCrumbs = 8192,
  };
  void add(LeftOut what) { left_out_ |= what; }
  bool has(LeftOut what) const { return (left_out_ & what) != 0; }

  std::atomic<unsigned> left_out_ = 0;
  std::mutex adding_;
  std::set<std::string> no_effect_;  // sentences
};

}  // namespace displayfile
