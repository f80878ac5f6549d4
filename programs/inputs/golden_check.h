#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "programs/options/hidden_surface_words.h"
#include "programs/options/mesh_words.h"
#include "programs/options/picture_size.h"

namespace displayfile {

/// The property of inputs that `displayfile check` compares with golden files.
class GoldenCheck {
 public:
  virtual ~GoldenCheck() = default;

  virtual std::string_view extension() const = 0;  ///< of golden files, with the dot
  /// Sets the reference for the inputs that follow: a golden file, or the result of a drawing
  /// program. Throws Error.
  virtual void read_golden(const std::string& file) = 0;
  /// How the input differs from it, in a line; nothing if it passes. Throws Error for a bad input.
  virtual std::optional<std::string> difference(const std::string& input) const = 0;
  /// Writes the golden file of an input. Throws Error.
  virtual void update(const std::string& input, const std::string& golden) const = 0;
};

/// How the inputs are drawn.
struct CheckedInputs {
  HiddenSurfaceOptions hidden_surfaces;
  MeshWords meshes;
  PictureSizeWord size;  ///< empty: not given
};

/// A check that the command line may ask for in place of the usual one.
class GoldenCheckOption : public GoldenCheck {
 public:
  virtual void add_to(CLI::App& command) = 0;
  /// True if it is selected. Its options are then read; throws Error for an invalid one.
  virtual bool asked_for(const CheckedInputs& inputs) = 0;
};

}  // namespace displayfile
