#include "programs/inputs/not_in_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <string_view>
#include <vector>

#include "displayfile/segments/display_file.h"
#include "interp/visibility/image_space.h"
#include "programs/process/warnings.h"

namespace displayfile {

namespace {

/// True if a visible segment's instructions as entered have such vertex data.
template <class Stored>
bool has_stored(const DisplayFile& drawn, Stored stored) {
  return std::ranges::any_of(drawn.segments(), [&](const Segment& segment) {
    return segment.visible && !((*segment.entered()).*stored)().empty();
  });
}

}  // namespace

void NotInPicture::note(const GraphicsSystem& system, const PicturePlan& plan) {
  const DrawOptions& options = plan.options;
  if (plan.kind() == PictureKind::raster) {
    if (options.vectors.pick_ids) add(kElements);
    if (options.vectors.seams != VectorOptions().seams) add(kSeams);
    if (options.vectors.precision != VectorOptions().precision) add(kPrecision);
    if (options.lettering.outlines) add(kOutlines);
    if (!plan.is_on_first_device() && system.display_file().has_shadows()) add(kShadowsOfDevice);
    return;
  }
  const DisplayFile& drawn = system.display_file();
  if (options.pens && drawn.has_texts() && !options.lettering.is_of_paths()) add(kTexts);
  const HiddenMethod by = plan.method;
  const bool fills = !finds_lines(by) && (!options.pens || options.pens->hatching);
  if (fills && has_stored(drawn, &Instructions::stored_normals)) add(kPhong);
  const bool by_map = by == HiddenMethod::map || is_image_space(by);
  const bool each_segment =
      options.surfaces.scope == HiddenScope::segment && by == HiddenMethod::map;
  if (fills && drawn.has_shadows() && (!by_map || each_segment)) add(kShadows);
  if (options.samples.value_or(1) > 1) add(kSamples);
  if (options.vectors.pick_ids && !by_map) add(kPickIds);
  if (options.crumbs && !by_map && !finds_lines(by)) add(kCrumbs);
  if (by_map && !options.pens) return;
  if (options.vectors.seams != VectorOptions().seams) add(kSeamsOfMap);
  // Finer ones are those of a scale.
  if (options.vectors.precision > VectorOptions().precision) add(kPrecisionOfMap);
}

void NotInPicture::note(const std::vector<DrawWarning>& warned, const std::string& picture) {
  for (const DrawWarning& warning : warned) {
    if (warning.kind == DrawWarning::Kind::hidden_lines) add(kHiddenLines);
    if (warning.kind == DrawWarning::Kind::annotation) {
      warnings() << fmt::format("{}: {}\n", picture, warning.text);
    }
    if (warning.kind != DrawWarning::Kind::no_effect) continue;
    const std::lock_guard lock(adding_);
    no_effect_.insert(warning.text);
  }
}

void NotInPicture::warn(const std::string& output) const {
  if (has(kHiddenLines)) {
    warnings()
        << output
        << ": left out: set-hidden-lines dashed, as nothing finds hidden lines in order of entry\n";
  }
  for (const std::string& text : no_effect_) warnings() << fmt::format("{}: {}\n", output, text);
  std::vector<std::string_view> left_out;
  if (has(kPhong)) left_out.emplace_back("Phong shading (drawn as Gouraud shading)");
  if (has(kShadows)) left_out.emplace_back("shadows (those of map are drawn, of all segments)");
  if (has(kSamples)) left_out.emplace_back("--samples");
  if (has(kTexts)) {
    left_out.emplace_back("texts, which pens draw with --font hershey or --text outlines");
  }
  if (has(kPickIds)) left_out.emplace_back("--pick-ids, which name fills of map");
  if (has(kSeamsOfMap)) left_out.emplace_back("--seams, which are between fills of map");
  if (has(kPrecisionOfMap)) {
    left_out.emplace_back("--vector-precision, to which fills of map are rounded");
  }
  if (has(kCrumbs))
    left_out.emplace_back("--crumbs, of visible lines, which this method does not find");
  if (!left_out.empty()) {
    warnings() << fmt::format("{}: vectors leave out {}\n", output, fmt::join(left_out, ", "));
  }
  std::vector<std::string_view> not_in_pixels;
  if (has(kElements)) not_in_pixels.emplace_back("--pick-ids");
  if (has(kSeams)) not_in_pixels.emplace_back("--seams");
  if (has(kPrecision)) not_in_pixels.emplace_back("--vector-precision");
  if (has(kOutlines)) not_in_pixels.emplace_back("--text outlines");
  if (has(kShadowsOfDevice)) not_in_pixels.emplace_back("shadows, which osmesa does not draw");
  if (not_in_pixels.empty()) return;
  warnings() << fmt::format("{}: pixels leave out {}\n", output, fmt::join(not_in_pixels, ", "));
}

}  // namespace displayfile
