#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "interp/draw/draw.h"

namespace displayfile {

/// What vectors leave out, or pixels, told once for all pictures of a call of the command.
class NotInPicture {
 public:
  /// Notes what a picture of that kind leaves out of what the application drew, and of the options.
  /// Shadows are the map's, which is drawn for methods of image space too. Several threads may call
  /// it at a time.
  void note(const GraphicsSystem& system, const DrawOptions& options, PictureKind kind);
  /// Notes what drawing warned of.
  void note(const std::vector<DrawWarning>& warned);
  /// Warns, with the output's name as given, if something was left out
  /// (programs/process/warnings.h).
  void warn(const std::string& output) const;

 private:
  std::atomic<bool> phong_ = false, shadows_ = false, samples_ = false, texts_ = false;
  std::atomic<bool> pick_ids_ = false;      // of vectors by other methods
  std::atomic<bool> hidden_lines_ = false;  // that a program set
  std::atomic<bool> elements_ = false, seams_ = false, precision_ = false;  // in pixels
};

}  // namespace displayfile
