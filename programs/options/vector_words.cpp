#include "programs/options/vector_words.h"

#include <CLI/CLI.hpp>

#include "clip/base/error.h"
#include "programs/options/number_list.h"
#include "programs/options/option_groups.h"

namespace displayfile {

void VectorWords::add_to(CLI::App& command) {
  command
      .add_option("--vector-precision", precision,
                  "unit in pixels to which vertices of visible surfaces in vectors are rounded, "
                  "0.001 to 1 [0.01]")
      ->type_name("PIXELS")
      ->group(kVectorOptions);
  command
      .add_option("--seams", seams,
                  "adjacent visible surfaces in vectors: trapped, without visible seams, or "
                  "butted, in a smaller file [trapped]")
      ->type_name("trapped|butted")
      ->group(kVectorOptions);
  command
      .add_flag(
          "--pick-ids", pick_ids,
          "visible surfaces in .svg: one element per pick identifier, with data-pick and a title")
      ->group(kVectorOptions);
  command
      .add_option("--font", font,
                  "font of texts, by the name that the system has for it; or hershey, or "
                  "hershey:NAME such as hershey:scripts: letters as strokes, also with --pens, in "
                  "the width of the line style (Debian: hershey-fonts-data) [sans-serif]")
      ->type_name("NAME|hershey[:NAME]")
      ->group(kPictureOptions);
  command
      .add_option(
          "--text", text,
          "letters in vectors: text, in the viewer's font, or outlines, the same everywhere "
          "and for --pens [text]")
      ->type_name("text|outlines")
      ->group(kVectorOptions);
  command
      .add_option("--id-prefix", id_prefix,
                  "beginning of every id and class with a rule in .svg, in place of the hash that "
                  "keeps figures of one page apart: letters, digits, - and _")
      ->type_name("PREFIX")
      ->group(kVectorOptions);
  command.add_flag("--inline", is_inline, "no XML declaration in .svg, to stand in an HTML page")
      ->group(kVectorOptions);
  command
      .add_flag("--layers", layers,
                "a layer for each object or segment, with its name: in .svg those of Inkscape, in "
                ".pdf those that readers show")
      ->group(kVectorOptions);
}

Lettering VectorWords::lettering() const {
  Lettering lettering;
  lettering.font = font;
  lettering.outlines = text == "outlines";
  if (!text.empty() && text != "text" && !lettering.outlines) {
    throw Error("--text " + text + ": expected text or outlines");
  }
  require_lettering_of_option(lettering);
  return lettering;
}

void require_lettering_of_option(const Lettering& lettering) {
  try {
    require_lettering(lettering);
  } catch (const Error& error) {
    const std::string what = error.what();
    const bool names_option = what.starts_with("font ");
    throw Error((names_option ? "--" : "--font " + lettering.font + ": ") + what);
  }
}

VectorOptions VectorWords::options() const {
  VectorOptions options;
  options.pick_ids = pick_ids;
  options.id_prefix = id_prefix;
  options.is_inline = is_inline;
  options.layers = layers;
  try {
    require_vector_options(options);
  } catch (const Error&) {
    throw Error("--id-prefix " + id_prefix +
                ": expected letters a-z and A-Z, digits, - and _, the first a letter or _");
  }
  if (seams == "butted") {
    options.seams = Seams::butted;
  } else if (!seams.empty() && seams != "trapped") {
    throw Error("--seams " + seams + ": expected trapped or butted");
  }
  if (precision.empty()) return options;
  const auto value = number_list(precision);
  const bool one = value && value->size() == 1;
  options.precision = one ? value->front() : 0.0;
  if (!one || options.precision < VectorOptions::kFinestPrecision ||
      options.precision > VectorOptions::kCoarsestPrecision) {
    throw Error("--vector-precision " + precision + ": expected 0.001 to 1 pixels");
  }
  return options;
}

}  // namespace displayfile
