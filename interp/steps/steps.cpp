#include "interp/steps/steps.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "clip/base/error.h"
#include "displayfile/segments/display_file.h"
#include "hidden/exact/support_plane.h"
#include "interp/device/picture.h"
#include "interp/steps/algorithms.h"
#include "interp/steps/step_items.h"
#include "interp/steps/step_record.h"

namespace displayfile {

std::string_view name_of(StepRole role) {
  static constexpr std::array<std::string_view, 13> kNames{
      "none",   "root", "compared", "front",  "back",  "on",   "cut",
      "active", "seen", "hidden",   "tagged", "upper", "lower"};
  return kNames[static_cast<std::size_t>(role)];
}

std::vector<HiddenMethod> methods_with_steps() {
  std::vector<HiddenMethod> methods;
  for (const SteppedAlgorithm* algorithm : stepped_algorithms()) {
    methods.push_back(algorithm->method);
  }
  return methods;
}

namespace {

/// The methods whose plain form, which the steps observe, is a separate file.
struct PlainForm {
  HiddenMethod plain, method;
};
constexpr std::array kPlainForms{
    PlainForm{HiddenMethod::plain_bsp, HiddenMethod::bsp},
    PlainForm{HiddenMethod::plain_scan_line, HiddenMethod::scan_line},
    PlainForm{HiddenMethod::plain_warnock, HiddenMethod::warnock},
    PlainForm{HiddenMethod::plain_appel, HiddenMethod::appel},
};

const SteppedAlgorithm& algorithm_of(HiddenMethod method) {
  const auto all = stepped_algorithms();
  const auto form = std::ranges::find(kPlainForms, method, &PlainForm::plain);
  const HiddenMethod told = form == kPlainForms.end() ? method : form->method;
  const auto found =
      std::ranges::find_if(all, [&](const SteppedAlgorithm* a) { return a->method == told; });
  if (found != all.end()) return **found;
  std::string names;
  for (const SteppedAlgorithm* algorithm : all)
    names.append(" ").append(name_of(algorithm->method));
  for (const PlainForm& plain : kPlainForms) names.append(" ").append(name_of(plain.plain));
  throw Error("hidden-surface method " + std::string(name_of(method)) +
              " has no steps: expected one of" + names);
}

void describe(const StepItems& scene, Steps& steps) {
  const ViewedScene& viewed = scene.viewed();
  for (std::uint32_t k = 0; k < scene.polygons(); ++k) {
    const Primitives::Kind kind = viewed.kind(k);
    const bool solid = kind == Primitives::Kind::solid;
    StepPolygon polygon{kind, solid ? viewed.fill_colour(k) : viewed.line_style(k).colour,
                        viewed.pick_of_item(k), false};
    if (solid) {
      const auto vertices = scene.vertices(k);
      const auto [index, edge_on] = support_vertices(vertices);
      polygon.edge_on = edge_on;
      if (!edge_on) {
        const auto plane = depth_plane(vertices[index[0]], vertices[index[1]], vertices[index[2]]);
        polygon.z0 = plane.at(0.0, 0.0);
        polygon.dz_dx = plane.dz_dx;
        polygon.dz_dy = plane.dz_dy;
      }
    }
    steps.polygons.push_back(polygon);
    steps.pieces.push_back({name_of_polygon(k), k, scene.vertices(k)});
  }
}

}  // namespace

std::vector<HiddenMethod> plain_forms_with_steps() {
  std::vector<HiddenMethod> forms;
  forms.reserve(std::size(kPlainForms));
  for (const PlainForm& form : kPlainForms) forms.push_back(form.plain);
  return forms;
}

Steps tell_steps(const DisplayFile& file, const StepsOptions& options) {
  const SteppedAlgorithm& algorithm = algorithm_of(options.method);
  require_picture_size(options.width, options.height);
  const StepItems scene(file, {options.width, options.height});
  Steps steps;
  steps.method = algorithm.method;
  steps.title = algorithm.title;
  steps.source = algorithm.source;
  steps.code = algorithm.code;
  steps.listing = algorithm.listing;
  steps.panels = algorithm.panels;
  steps.width = options.width;
  steps.height = options.height;
  describe(scene, steps);
  StepRecord record(scene, steps, options.most_steps);
  algorithm.run(scene, record);
  return steps;
}

Steps tell_steps(const GraphicsSystem& system, const StepsOptions& options) {
  Steps steps = tell_steps(system.display_file(), options);
  steps.background = system.looks().background.colour;
  return steps;
}

std::string steps_as_json(const GraphicsSystem& system, const StepsOptions& options) {
  return as_json(tell_steps(system, options));
}

}  // namespace displayfile
