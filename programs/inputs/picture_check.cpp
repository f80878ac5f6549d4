#include "programs/inputs/picture_check.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <span>
#include <vector>

#include "clip/base/error.h"
#include "interp/files/picture_compare.h"
#include "interp/files/png_file.h"
#include "programs/inputs/drawn_inputs.h"
#include "programs/inputs/inputs.h"
#include "programs/options/option_groups.h"

namespace displayfile {

void PictureCheck::add_to(CLI::App& command) {
  command
      .add_flag("--picture", asked_,
                "compare pictures with one sample per pixel, NAME.png for NAME.draw, instead of "
                "instructions")
      ->group(kPictureOptions);
  tolerance_.add_to(command);
}

bool PictureCheck::asked_for(const CheckedInputs& inputs) {
  if (!asked_) {
    if (tolerance_.is_set()) {
      throw Error("--tolerance and --wrong-pixels apply to pictures: expected --picture too");
    }
    return false;
  }
  tolerance_.require_number();
  has_size_ = !inputs.size.size.empty();
  if (has_size_) inputs.size.read(options_.width, options_.height);
  options_.samples = 1;  // a golden picture has each pixel decided at its centre
  meshes_ = inputs.meshes;
  options_.surfaces = inputs.hidden_surfaces;
  return true;
}

Picture PictureCheck::picture_of(const std::string& input, const DrawOptions& options) const {
  const DrawnInputs entered(std::span(&input, 1), options, meshes_, Shading::flat);
  std::vector<DrawWarning> warned;
  DrawOptions drawing = entered.options();
  drawing.warn = [&](const DrawWarning& warning) { warned.push_back(warning); };
  Picture picture = draw(entered.system(), drawing);
  entered.warn_if_nothing_is_seen(warned, PictureKind::raster);
  return picture;
}

void PictureCheck::read_golden(const std::string& file) {
  golden_ = is_picture_file(file) ? read_picture(file) : picture_of(file, options_);
}

std::optional<std::string> PictureCheck::difference(const std::string& input) const {
  DrawOptions options = options_;
  if (!has_size_) {
    options.width = golden_.width;
    options.height = golden_.height;
  }
  const PictureDifference difference =
      compare(picture_of(input, options), golden_, tolerance_.channel);
  if (tolerance_.passes(difference)) return std::nullopt;
  if (!difference.same_size) {
    return fmt::format("the picture is {} x {} pixels, expected {} x {}", options.width,
                       options.height, golden_.width, golden_.height);
  }
  return fmt::format(
      "{} wrong pixels of {} ({:.2f}%), largest difference {}", difference.wrong_pixels,
      difference.pixels,
      100.0 * static_cast<double>(difference.wrong_pixels) / static_cast<double>(difference.pixels),
      difference.largest);
}

void PictureCheck::update(const std::string& input, const std::string& golden) const {
  write_png(picture_of(input, options_), golden);
}

}  // namespace displayfile
