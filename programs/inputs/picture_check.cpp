#include "programs/inputs/picture_check.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "displayfile/looks/style.h"
#include "interp/files/picture_compare.h"
#include "interp/files/png_file.h"
#include "interp/raster/antialias.h"
#include "programs/inputs/drawn_inputs.h"
#include "programs/inputs/inputs.h"
#include "programs/inputs/not_in_picture.h"
#include "programs/options/number_in.h"
#include "programs/options/option_groups.h"
#include "programs/options/picture_words.h"

namespace displayfile {

void PictureCheck::add_to(CLI::App& command) {
  command
      .add_flag("--picture", asked_,
                "compare pictures with one sample per pixel, NAME.png for NAME.draw, instead of "
                "instructions")
      ->group(kPictureOptions);
  command
      .add_option(
          "--samples", samples_,
          "of pictures: the mean of N x N samples for each pixel, as the golden picture was "
          "drawn with; draw has 4 unless set")
      ->type_name("N")
      ->transform(number_in(1, kMostSamples))
      ->default_str("1")
      ->group(kPictureOptions);
  command
      .add_option("--shading", shading_,
                  "of pictures: what the inputs start with: flat, or gouraud or phong for smooth "
                  "meshes [flat]")
      ->type_name("flat|gouraud|phong")
      ->group(kPictureOptions);
  ShadingWord::add_crease_to(command, crease_);
  background_.add_colour_to(command);
  command.add_option("--device", device_, "what draws pictures [software]")
      ->type_name(raster_device_words())
      ->group(kPictureOptions);
  command
      .add_flag("--crumbs", crumbs_,
                "of pictures: with pieces of lines that are shorter than they are wide and join no "
                "other")
      ->group(kPictureOptions);
  tolerance_.add_to(command);
}

/// Options of pictures are not for instructions.
void PictureCheck::require_picture() const {
  if (tolerance_.is_set()) {
    throw Error("--tolerance and --wrong-pixels are of pictures: expected --picture too");
  }
  const std::array<std::pair<const char*, bool>, 6> given{
      {{"--samples", samples_.has_value()},
       {"--shading", shading_.has_value()},
       {"--crease", crease_.has_value()},
       {"--background", !background_.word.empty()},
       {"--device", device_.has_value()},
       {"--crumbs", crumbs_}}};
  for (const auto& [name, is_given] : given) {
    if (is_given) throw Error(fmt::format("{} is of pictures: expected --picture too", name));
  }
}

bool PictureCheck::asked_for(const CheckedInputs& inputs) {
  if (!asked_) {
    require_picture();
    return false;
  }
  tolerance_.require_number();
  has_size_ = !inputs.size.size.empty();
  if (has_size_) inputs.size.read(options_.width, options_.height);
  options_.samples = samples_.value_or(1);  // of one sample each pixel is decided at its centre
  options_.background = background_.background();
  if (device_) options_.device = *device_;
  require_raster_device(options_.device);
  if (shading_) shading(*shading_);  // refuses
  options_.crumbs = crumbs_;
  meshes_ = inputs.meshes;
  options_.surfaces = inputs.hidden_surfaces;
  return true;
}

Picture PictureCheck::picture_of(const Figure& figure, const DrawOptions& options) const {
  const StartingShading started{shading_ ? shading(*shading_) : Shading::flat,
                                crease_.value_or(kNoCrease), crease_.has_value()};
  const DrawnInputs entered(figure, resolve_call(options), meshes_, started);
  std::vector<DrawWarning> warned;
  DrawOptions drawing = entered.plan().options;
  drawing.warn = [&](const DrawWarning& warning) { warned.push_back(warning); };
  Picture picture = draw(entered.system(), drawing);
  NotInPicture left_out;
  left_out.note(entered.system(), entered.plan());
  const std::string name = input_name(figure.back());
  left_out.note(warned, name);
  left_out.warn(name);
  entered.warn_if_nothing_is_seen(warned);
  return picture;
}

void PictureCheck::read_golden(const std::string& file, const std::string& with) {
  golden_ = is_picture_file(file) ? read_picture(file)
                                  : picture_of(with_common(with, {{file}}).front(), options_);
}

std::optional<GoldenDifference> PictureCheck::difference(const Figure& figure) const {
  DrawOptions options = options_;
  if (!has_size_) {
    options.width = golden_.width;
    options.height = golden_.height;
  }
  const PictureDifference difference =
      compare(picture_of(figure, options), golden_, tolerance_.channel);
  if (tolerance_.passes(difference)) return std::nullopt;
  if (!difference.same_size) {
    return GoldenDifference{fmt::format("the picture is {} x {} pixels, expected {} x {}",
                                        options.width, options.height, golden_.width,
                                        golden_.height)};
  }
  return GoldenDifference{fmt::format(
      "{} wrong pixels of {} ({:.2f}%), largest difference {}", difference.wrong_pixels,
      difference.pixels,
      100.0 * static_cast<double>(difference.wrong_pixels) / static_cast<double>(difference.pixels),
      difference.largest)};
}

void PictureCheck::update(const Figure& figure, const std::string& golden) const {
  write_png(picture_of(figure, options_), golden);
}

}  // namespace displayfile
