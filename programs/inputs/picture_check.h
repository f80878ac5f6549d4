#pragma once

#include <optional>
#include <string>

#include "interp/draw/draw.h"
#include "programs/inputs/golden_check.h"
#include "programs/options/background_option.h"
#include "programs/options/picture_size.h"
#include "programs/options/picture_tolerance.h"

namespace displayfile {

/// `displayfile check --picture`: the picture of an input, drawn as `displayfile draw` does with
/// the same options, against a golden picture.
class PictureCheck : public GoldenCheckOption {
 public:
  void add_to(CLI::App& command) override;
  bool asked_for(const CheckedInputs& inputs) override;

  std::string_view extension() const override { return ".png"; }
  void read_golden(const std::string& file, const std::string& with) override;
  std::optional<GoldenDifference> difference(const Figure& figure) const override;
  void update(const Figure& figure, const std::string& golden) const override;

 private:
  Picture picture_of(const Figure& figure, const DrawOptions& options) const;
  void require_picture() const;

  bool asked_ = false;
  std::optional<int> samples_;
  std::optional<std::string> device_, shading_;
  std::optional<double> crease_;
  BackgroundWord background_;
  bool crumbs_ = false;
  MeshWords meshes_;
  bool has_size_ = false;
  PictureTolerance tolerance_;
  DrawOptions options_;  // of a golden file that is written or drawn
  Picture golden_;
};

}  // namespace displayfile
