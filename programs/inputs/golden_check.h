#pragma once

#include <CLI/App.hpp>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "programs/inputs/input_names.h"
#include "programs/options/hidden_surface_words.h"
#include "programs/options/mesh_words.h"
#include "programs/options/picture_size.h"

namespace displayfile {

/// The difference between inputs and their reference.
struct GoldenDifference {
  std::string text;      ///< one line
  std::size_t line = 0;  ///< of the last input, if it is a drawing program; 0: not known
};

/// The property of inputs that `displayfile check` compares with golden files.
class GoldenCheck {
 public:
  virtual ~GoldenCheck() = default;

  virtual std::string_view extension() const = 0;  ///< of golden files, with the dot
  /// Sets the reference for the figures that follow: a golden file, or the result of a drawing
  /// program, entered after `with`, if there is one. Throws Error.
  virtual void read_golden(const std::string& file, const std::string& with) = 0;
  /// How the figure differs from it; nothing if it passes. Throws Error for a bad input.
  virtual std::optional<GoldenDifference> difference(const Figure& figure) const = 0;
  /// Writes the golden file of a figure. Throws Error.
  virtual void update(const Figure& figure, const std::string& golden) const = 0;
};

/// How the inputs are drawn.
struct CheckedInputs {
  HiddenSurfaceOptions hidden_surfaces;
  MeshWords meshes;
  PictureSizeWord size;  ///< empty: not given
};

/// A check that the command line may select in place of the usual one.
class GoldenCheckOption : public GoldenCheck {
 public:
  virtual void add_to(CLI::App& command) = 0;
  /// True if it is selected. Its options are then read; throws Error for an invalid one.
  virtual bool asked_for(const CheckedInputs& inputs) = 0;
};

}  // namespace displayfile
