#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "displayfile/graphics_system.h"
#include "displayfile/mesh/mesh.h"

namespace displayfile {

/// The object viewed, and the defaults of the options.
struct UsualCamera {
  const char* what = "a bare mesh";
  const char* eye = "30,20";
  const char* up = "as the file says, or y";
  bool many = false;  ///< the command draws a picture of each of many inputs
};

/// The camera options for meshes alone, and the window options, as words.
struct CameraWords {
  std::string eye, look_at, up, fov;
  std::string fit_to;  ///< each or all; empty: each
  bool parallel = false, fit = true, widen = false;
  bool turning = false;  ///< not an option: the camera is a turntable's

  void add_to(CLI::App& command, const UsualCamera& usual = {});
  /// Throws Error, naming the option, for an invalid word.
  Camera camera() const;
  /// True if one view is to be fitted to all inputs of several pictures. Throws Error for any word
  /// but each or all.
  bool fits_all() const;
  /// True if `each` is set, not the default: then windows are fitted to drawing programs too.
  bool fits_each() const { return fit_to == "each"; }
  /// Throws Error, naming the options, if some change a fitted view and there is none.
  void require_fitted(bool fitted) const;
  /// Sets the state in which the inputs are entered.
  void start(GraphicsSystem& system, double aspect) const;

 private:
  std::vector<std::string> given() const;
};

/// The axis that --up sets. Throws Error, naming the option, for any other word.
Upright upright_of_option(const std::string& word);

/// Warns on standard error if a window of a picture was stretched by a pixel or more by default.
void warn_of_stretched_window(const GraphicsSystem& system, const std::string& picture, int width,
                              int height);
/// Warns of images that a program rotates, if the picture is not square (distorted_by_turning).
void warn_of_turned_images(const GraphicsSystem& system, const std::string& picture, int width,
                           int height);
/// Warns of segments that a program makes larger or smaller in the picture, which is at a scale.
void warn_of_scaled_images(const GraphicsSystem& system, const std::string& picture,
                           const std::string& scale);

}  // namespace displayfile
