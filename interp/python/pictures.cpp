#include "interp/python/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clip/base/collected_text.h"
#include "clip/base/error.h"
#include "clip/surfaces.h"
#include "displayfile/files.h"
#include "displayfile/segments/hidden_lines_left.h"
#include "displayfile/segments/sorted_display_file.h"
#include "displayfile/user_routines/system_inside.h"
#include "interp/device/output_device.h"
#include "interp/device/picture.h"
#include "interp/draw/drawing_choice.h"
#include "interp/draw/size_on_paper.h"
#include "interp/python/arguments.h"
#include "interp/python/arrays.h"
#include "interp/python/errors.h"
#include "interp/python/pieces.h"
#include "interp/python/system.h"

namespace displayfile::python {

namespace py = pybind11;

// ---- Options -----------------------------------------------------------------------------

namespace {

constexpr int kUsualSize = 512;  // of both sides

Colour colour_in(py::handle value, std::string_view what) {
  const std::vector<double> colour = numbers_in(value, what);
  if (colour.size() != 3) {
    throw Error(
        fmt::format("{}: expected red, green and blue, not {} numbers", what, colour.size()));
  }
  for (const double part : colour) {
    if (!(part >= 0.0 && part <= 1.0)) {
      throw Error(fmt::format("{}: colour component {}: expected 0 to 1", what, part));
    }
  }
  return {colour[0], colour[1], colour[2]};
}

Background background_in(py::handle value) {
  if (PyUnicode_Check(value.ptr()) != 0) {
    if (word_in(value, "background") == "none") return {Background::Kind::none};
    throw Error("background: expected red, green and blue, or 'none'");
  }
  return {Background::Kind::solid, colour_in(value, "background")};
}

PictureRows rows_in(py::handle value) {
  const std::vector<std::int32_t> rows = whole_numbers_in(value, "rows");
  if (rows.size() != 2) {
    throw Error(fmt::format("rows: expected the first and the end, not {} numbers", rows.size()));
  }
  return {rows[0], rows[1]};
}

/// A spacing, or a dictionary of spacing, angle, cross, colour and width.
Hatching hatching_in(py::handle value) {
  Hatching hatching;
  if (!PyDict_Check(value.ptr())) {
    hatching.spacing = number_in(value, "hatch");
    return hatching;
  }
  for (const auto& [key, part] : py::reinterpret_borrow<py::dict>(value)) {
    const std::string name = word_in(key, "hatch");
    if (name == "spacing") {
      hatching.spacing = number_in(part, "spacing");
    } else if (name == "angle") {
      hatching.angle = number_in(part, "angle");
    } else if (name == "cross") {
      hatching.cross = switch_in(part, "cross");
    } else if (name == "colour") {
      hatching.colour = colour_in(part, "colour");
    } else if (name == "width") {
      hatching.width = number_in(part, "width");
    } else {
      throw Error(fmt::format("hatch: {}: expected spacing, angle, cross, colour and width", name));
    }
  }
  return hatching;
}

Seams seams_in(std::string_view word) {
  if (word == "trapped") return Seams::trapped;
  if (word == "butted") return Seams::butted;
  throw Error(fmt::format("seams '{}': expected trapped or butted", word));
}

void require_pens_before(std::string_view option, const DrawOptions& options) {
  if (!options.pens) throw Error(fmt::format("{}: expected it with pens or hatch", option));
}

/// A sequence of colours.
std::vector<Colour> layers_in(py::handle value) {
  if (PySequence_Check(value.ptr()) == 0 || PyUnicode_Check(value.ptr()) != 0) {
    throw Error("pen_layers: expected a list of colours");
  }
  std::vector<Colour> layers;
  for (const py::handle colour : py::reinterpret_borrow<py::sequence>(value)) {
    layers.push_back(colour_in(colour, "pen_layers"));
  }
  return layers;
}

/// True for options that must be read after the paper and the pens.
bool needs_pens(std::string_view option) {
  return option == "margin" || option == "pen_order" || option == "pen_layers";
}

using Read = void (*)(py::handle value, DrawOptions& options);

/// The readers of the options, by name.
const std::map<std::string_view, Read>& readers() {
  static const std::map<std::string_view, Read> all{
      {"hidden", [](py::handle v,
                    DrawOptions& o) { o.surfaces.method = hidden_method(word_in(v, "hidden")); }},
      {"hidden_lines",
       [](py::handle v, DrawOptions& o) {
         o.surfaces.hidden_lines = hidden_lines(word_in(v, "hidden_lines"));
       }},
      {"line_order",
       [](py::handle v, DrawOptions& o) {
         o.surfaces.line_order = line_order(word_in(v, "line_order"));
       }},
      {"line_halo",
       [](py::handle v, DrawOptions& o) { o.surfaces.line_halo = number_in(v, "line_halo"); }},
      {"scope",
       [](py::handle v, DrawOptions& o) { o.surfaces.scope = hidden_scope(word_in(v, "scope")); }},
      {"precision",
       [](py::handle v, DrawOptions& o) {
         o.surfaces.precision = precision(word_in(v, "precision"));
       }},
      {"background", [](py::handle v, DrawOptions& o) { o.background = background_in(v); }},
      {"rows", [](py::handle v, DrawOptions& o) { o.rows = rows_in(v); }},
      {"samples", [](py::handle v, DrawOptions& o) { o.samples = whole_number_in(v, "samples"); }},
      {"threads", [](py::handle v, DrawOptions& o) { o.surfaces.threads = threads_in(v); }},
      {"device",
       [](py::handle v, DrawOptions& o) {
         o.device = word_in(v, "device");
         require_raster_device(o.device);
       }},
      {"ids", [](py::handle v, DrawOptions& o) { o.with_ids = switch_in(v, "ids"); }},
      {"depth", [](py::handle v, DrawOptions& o) { o.with_depth = switch_in(v, "depth"); }},
      {"paper",
       [](py::handle v, DrawOptions& o) { o.vectors.paper = paper_of(word_in(v, "paper")); }},
      {"pens",
       [](py::handle v, DrawOptions& o) {
         if (switch_in(v, "pens") && !o.pens) o.pens.emplace();
       }},
      {"hatch",
       [](py::handle v, DrawOptions& o) {
         o.pens = Pens{.hatching = hatching_in(v)};
         require_pens(*o.pens);
       }},
      {"pen_order",
       [](py::handle v, DrawOptions& o) {
         require_pens_before("pen_order", o);
         o.pens->order = pen_order(word_in(v, "pen_order"));
       }},
      {"pen_layers",
       [](py::handle v, DrawOptions& o) {
         require_pens_before("pen_layers", o);
         o.pens->layers = layers_in(v);
         require_pens(*o.pens);
       }},
      {"margin",
       [](py::handle v, DrawOptions& o) {
         if (!o.vectors.paper && !o.pens) {
           throw Error("margin: expected it with paper, pens or hatch");
         }
         if (!o.vectors.paper) o.vectors.paper.emplace();
         o.vectors.paper->margin = number_in(v, "margin");
       }},
      {"vector_precision",
       [](py::handle v, DrawOptions& o) {
         o.vectors.precision = number_in(v, "vector_precision");
         require_vector_options(o.vectors);
       }},
      {"seams",
       [](py::handle v, DrawOptions& o) { o.vectors.seams = seams_in(word_in(v, "seams")); }},
      {"font",
       [](py::handle v, DrawOptions& o) {
         o.lettering.font = lettering_of(word_in(v, "font"), std::nullopt).font;
       }},
      {"text",
       [](py::handle v, DrawOptions& o) {
         o.lettering.outlines = lettering_of(std::nullopt, word_in(v, "text")).outlines;
       }},
      {"pick_ids",
       [](py::handle v, DrawOptions& o) { o.vectors.pick_ids = switch_in(v, "pick_ids"); }},
      {"id_prefix",
       [](py::handle v, DrawOptions& o) {
         o.vectors.id_prefix = word_in(v, "id_prefix");
         require_vector_options(o.vectors);
       }},
      {"inline",
       [](py::handle v, DrawOptions& o) { o.vectors.is_inline = switch_in(v, "inline"); }},
      {"layers", [](py::handle v, DrawOptions& o) { o.vectors.layers = switch_in(v, "layers"); }},
      {"dpi", [](py::handle v, DrawOptions& o) { o.dpi = number_in(v, "dpi"); }}};
  return all;
}

bool has_usable_density(const DrawOptions& options) {
  return !options.dpi || (*options.dpi >= 1.0 && *options.dpi <= kHighestDensity);
}

/// Must be called after the paper, the pens and the density are read.
void read_size(py::handle size, DrawOptions& options) {
  const py::object given = plain(size, "size");
  if (PyUnicode_Check(given.ptr()) != 0) {
    const std::string word = word_in(given, "size");
    const auto in_mm = millimetre_size(word, "size");
    if (!in_mm) {
      throw Error(fmt::format(
          "size '{}': expected whole numbers of pixels, or millimetres, such as '80x60mm'", word));
    }
    if (has_usable_density(options)) take_size_on_paper(*in_mm, options);
    return;
  }
  if (PySequence_Check(given.ptr()) == 0) {
    options.width = options.height = whole_number_in(given, "size");
    return;
  }
  const std::vector<py::object> pair = reading("size: expected a number, or width and height", [&] {
    const auto all = py::reinterpret_borrow<py::sequence>(given);
    const std::size_t count = py::len(all);
    if (count != 2) {
      throw Error(
          fmt::format("size: expected a number, or width and height, not {} numbers", count));
    }
    return std::vector<py::object>{all[0], all[1]};
  });
  options.width = whole_number_in(pair[0], "width");
  options.height = whole_number_in(pair[1], "height");
}

}  // namespace

DrawOptions draw_options_in(py::handle size, const py::kwargs& keywords) {
  DrawOptions options;
  const auto read = [&](bool last) {
    for (const auto& [key, value] : keywords) {
      if (value.is_none()) continue;
      const std::string name = word_in(key, "option");
      const auto reader = readers().find(name);
      if (reader == readers().end()) throw Error(fmt::format("unknown option {}", name));
      if (needs_pens(name) == last) reader->second(value, options);
    }
  };
  read(false);
  read(true);
  read_size(size, options);
  return options;
}

std::optional<double> aspect_of(const DrawOptions& options) {
  if (options.width < 1 || options.height < 1) return std::nullopt;  // which drawing refuses
  return static_cast<double>(options.width) / options.height;
}

// ---- Pictures ----------------------------------------------------------------------------

namespace {

/// The pixels as an array over the picture's own memory, which returns to the system when the array
/// is destroyed.
py::array pixels_of(Picture&& picture, std::shared_ptr<SparePictures> spare) {
  struct Kept {
    std::vector<std::uint32_t> pixels;
    std::shared_ptr<SparePictures> spare;
  };
  auto kept = std::make_unique<Kept>(Kept{std::move(picture.pixels), std::move(spare)});
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(kept->pixels.data());
  const py::capsule owner(kept.get(), [](void* p) {
    const std::unique_ptr<Kept> gone(static_cast<Kept*>(p));
    gone->spare->put(std::move(gone->pixels));
  });
  kept.release();
  return py::array_t<std::uint8_t>(
      {py::ssize_t{picture.height}, py::ssize_t{picture.width}, py::ssize_t{4}}, bytes, owner);
}

}  // namespace

py::tuple arrays_of(Picture&& picture, const DrawOptions& options,
                    std::shared_ptr<SparePictures> spare) {
  if constexpr (std::endian::native != std::endian::little) {
    for (std::uint32_t& pixel : picture.pixels) pixel = in_bytes(pixel);
  }
  const std::vector<py::ssize_t> shape{picture.height, picture.width};
  py::object ids = py::none(), depth = py::none();
  if (options.with_ids) ids = owned<std::int32_t>(std::move(picture.ids), shape);
  if (options.with_depth) depth = owned<double>(std::move(picture.depth), shape);
  return py::make_tuple(pixels_of(std::move(picture), std::move(spare)), ids, depth);
}

namespace {

void warn(const std::string& message) {
  constexpr int kOfCaller = 2;  // of the method that called
  if (PyErr_WarnEx(PyExc_UserWarning, message.c_str(), kOfCaller) < 0) {
    throw py::error_already_set();
  }
}

/// Warnings of drawing without the interpreter's lock: collected for tell(), except that a picture
/// is stretched, which is known before anything is drawn or written. An open segment that a camera
/// does not show yet is warned of too, and is then the reason if nothing is seen. Where no view is
/// set, that warning names look().
class Warned {
 public:
  explicit Warned(DrawOptions& options) {
    options.warn = [this](const DrawWarning& warning) {
      if (warning.kind == DrawWarning::Kind::nothing_seen && left_open_) return;
      if (warning.kind != DrawWarning::Kind::stretched) {
        texts_.push_back(warning.text);
        if (warning.kind == DrawWarning::Kind::nothing_seen) texts_.back() += advice_;
        return;
      }
      const py::gil_scoped_acquire lock;
      warn(warning.text);
    };
  }
  Warned(const Warned&) = delete;
  Warned& operator=(const Warned&) = delete;
  /// Must be called before drawing.
  void note(GraphicsSystem& system, const FollowedView& followed) {
    if (!followed.follows() && !FollowedView::is_view_set(system) && system.counts().polygons > 0 &&
        std::ranges::all_of(system.display_file().segments(), &Segment::visible)) {
      advice_ =
          ": no view is set, and x and y from -1 to 1 are shown: look() before the first segment "
          "fits a camera to all of them";
    }
    const auto open = system.open_segment_name();
    if (!open || !followed.follows() || system.retained() == nullptr) return;
    const RetainedScene& scene = *system.retained();
    const RetainedScene::Segment& last = scene.segments().back();
    const bool is_empty =
        last.first == scene.size() && scene.texts(last).empty() && last.annotations.empty();
    if (!is_empty) left_open_ = open;
  }
  void tell() const {
    if (left_open_) {
      warn(fmt::format(
          "segment {} is open, and not in the picture: a camera shows segments that are closed: "
          "expected close_segment before the picture",
          *left_open_));
    }
    for (const std::string& text : texts_) warn(text);
  }

 private:
  std::optional<int> left_open_;
  std::string advice_;
  std::vector<std::string> texts_;
};

/// Without a size it is the usual one or, on paper, that of the paper between its margins where a
/// camera fits the view to pictures of any shape.
DrawOptions options_of_file(System& self, py::handle size, const py::kwargs& keywords) {
  if (!size.is_none()) return draw_options_in(size, keywords);
  DrawOptions options = draw_options_in(py::int_(kUsualSize), keywords);
  const bool is_on_paper = options.vectors.paper || options.pens;
  const bool fits = self.call([&](GraphicsSystem&) { return self.fits_any_shape(); });
  if (is_on_paper && fits && has_usable_density(options)) take_shape_of_paper(options);
  return options;
}

py::tuple draw(System& self, py::handle size, const py::kwargs& keywords) {
  DrawOptions options = draw_options_in(size, keywords);
  Warned warned(options);
  Picture picture =
      self.viewed(aspect_of(options), [&](GraphicsSystem& system, Renderer& renderer) {
        warned.note(system, self.followed());
        renderer.give_back(self.spare()->take());
        renderer.draw(system, options);
        return renderer.take_picture();
      });
  warned.tell();
  return arrays_of(std::move(picture), options, self.spare());
}

/// Throws the Errors that drawing would throw before it begins, here or in another process, into
/// memory or a file. Returns width and height.
py::tuple require_drawn(System& self, py::handle to, py::handle size, const py::kwargs& keywords) {
  const DrawOptions options = draw_options_in(size, keywords);
  if (!to.is_none()) require_format(path_in(to, "path"), options);
  self.viewed(aspect_of(options),
              [&](GraphicsSystem& system, Renderer&) { require_drawable(system, options); });
  return py::make_tuple(options.width, options.height);
}

py::object draw_as(System& self, py::handle format, py::handle size, const py::kwargs& keywords) {
  DrawOptions options = options_of_file(self, size, keywords);
  Warned warned(options);
  const std::string name = word_in(format, "format");
  const std::string bytes =
      self.viewed(aspect_of(options), [&](GraphicsSystem& system, Renderer& renderer) {
        DrawOptions in_format = options;
        in_format.format = name;
        warned.note(system, self.followed());
        CollectedText written;
        written.exceptions(std::ios::badbit);  // that of memory, where it is written
        renderer.draw(system, written, in_format);
        return std::move(written).str();
      });
  warned.tell();
  return py::bytes(bytes);
}

void save(System& self, py::handle to, py::handle format, py::handle size,
          const py::kwargs& keywords) {
  DrawOptions options = options_of_file(self, size, keywords);
  const std::string path = path_in(to, "path");
  if (!format.is_none()) options.format = word_in(format, "format");
  Warned warned(options);
  self.viewed(aspect_of(options), [&](GraphicsSystem& system, Renderer& renderer) {
    warned.note(system, self.followed());
    renderer.draw(system, path, options);
  });
  warned.tell();
}

py::object pick(System& self, py::handle x, py::handle y, py::handle reach, py::handle size,
                const py::kwargs& keywords) {
  const DrawOptions options = draw_options_in(size, keywords);
  const double at_x = number_in(x, "x"), at_y = number_in(y, "y");
  const double within = number_in(reach, "reach");
  const auto picked =
      self.viewed(aspect_of(options), [&](GraphicsSystem& system, Renderer& renderer) {
        return renderer.pick(system, at_x, at_y, options, within);
      });
  if (!picked) return py::none();
  constexpr const char* kKinds[] = {"polygon", "edge", "line"};
  return py::make_tuple(kKinds[static_cast<int>(picked->kind)], picked->id, picked->segment,
                        picked->depth);
}

py::tuple pieces(System& self, const py::kwargs& keywords) {
  const DrawOptions options = draw_options_in(py::int_(512), keywords);
  return arrays_of(self.viewed(std::nullopt, [&](GraphicsSystem& system, Renderer&) {
    return drawn_pieces(system, options);
  }));
}

std::string dump_of(System& self, const py::kwargs& keywords) {
  const HiddenSurfaceOptions options = draw_options_in(py::int_(1), keywords).surfaces;
  return self.viewed(std::nullopt, [&](GraphicsSystem& system, Renderer&) {
    const SurfacePlan plan = resolve_surfaces(system, options);
    const HiddenMethod method = plan.method;
    require_hidden_lines_found(plan.hidden_lines, method);
    SortedDisplayFile sorted;
    const DisplayFile& file = sorted.update(system, options, plan, unsorted_if_automatic(method));
    require_hidden_lines_dumped(file, method, options);
    if (!is_colour_rule(method)) return dump(file);
    require_colour_of_fills(method, system.looks().background);
    return dump(file, system.looks().background.colour);
  });
}

}  // namespace

void add_pictures(SystemClass& system) {
  system.def("_draw", draw);
  system.def("_require_drawn", require_drawn);
  system.def("_draw_as", draw_as);
  system.def("_save", save);
  system.def("_pick", pick);
  system.def("_pieces", pieces);
  system.def("_dump", dump_of);
  system.def("_set_aspect_ratio", [](System& self, py::handle aspect) {
    self.set_aspect_ratio(number_in(aspect, "aspect"));
  });
  system.def("_set_threads", [](System& self, py::handle threads) {
    const int count = whole_number_in(threads, "threads");
    if (count < 1 || count > 1024) {
      throw Error(fmt::format("threads: {}: expected 1 to 1024", count));
    }
    self.call([&](GraphicsSystem& s) { s.set_threads(count); });
  });
  system.def("_replace_lines", [](System& self, py::handle words) {
    const LineSelection selection = line_selection(word_in(words, "lines"));
    self.call([&](GraphicsSystem& s) { SystemInside::replace_lines(s, selection); });
  });
  system.def("_require_lines", [](System& self, py::handle words) {
    if (words.is_none()) return;
    const LineSelection asked = line_selection(word_in(words, "lines"));
    const LineSelection selected =
        self.call([](GraphicsSystem& s) { return s.hidden_surfaces().lines; });
    if (asked == selected) return;
    throw Error(fmt::format(
        "lines '{}': the system selects '{}' as segments are closed: expected System(lines=...), "
        "or set_lines before the first segment",
        displayfile::words_of(asked), displayfile::words_of(selected)));
  });
  system.def("_aspect_ratio", [](System& self) {
    return self.call([](GraphicsSystem& s) { return s.aspect_ratio(); });
  });
  system.def("_polygons", [](System& self) {
    return self.viewed(std::nullopt,
                       [](GraphicsSystem& s, Renderer&) { return s.display_file().polygons(); });
  });
  system.def("_is_empty", [](System& self) {
    return self.call([](GraphicsSystem& s) { return s.display_file().visible_segments().empty(); });
  });
  system.def("_open_segment_name", [](System& self) {
    return self.call([](GraphicsSystem& s) { return s.open_segment_name().value_or(0); });
  });
  system.def("_segments", [](System& self) {
    const auto names = self.call([](GraphicsSystem& s) {
      std::vector<int> of_all;
      for (const Segment& segment : s.display_file().segments()) of_all.push_back(segment.name());
      return of_all;
    });
    py::list list;
    for (const int name : names) list.append(name);
    return list;
  });
  system.def("_to_device", [](System& self, py::handle point) -> py::object {
    const std::vector<double> p = numbers_in(point, "point");
    if (p.size() != 3) throw Error(fmt::format("point: expected 3 numbers, not {}", p.size()));
    const auto device = self.viewed(std::nullopt, [&](GraphicsSystem& s, Renderer&) {
      return s.to_device({p[0], p[1], p[2]});
    });
    if (!device) return py::none();
    return py::make_tuple(device->x, device->y, device->z);
  });
}

}  // namespace displayfile::python
