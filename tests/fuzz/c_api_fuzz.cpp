// libFuzzer target: whatever a C program calls, in whatever order and with whatever structures, a
// call that fails has a message and leaves the system as a twin that never saw it; one that
// succeeds returns the same as from the twin.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "interp/c/displayfile_c.h"
#include "tests/fuzz/failed.h"
#include "tests/fuzz/fuzz_input.h"

namespace {

using displayfile::fuzz::failed;
using displayfile::fuzz::FuzzInput;

struct Destroy {
  void operator()(df_system* system) const { df_destroy(system); }
};
using System = std::unique_ptr<df_system, Destroy>;

/// A call's result: its code, and the bytes that it returned.
struct Returned {
  int code;
  std::string bytes = {};
  bool operator==(const Returned&) const = default;
};

template <class Value>
std::string bytes_of(const Value* values, std::size_t count) {
  return count == 0 ? ""
                    : std::string(reinterpret_cast<const char*>(values), count * sizeof *values);
}

Returned dumped(df_system* system) {
  const char* text = nullptr;
  std::size_t length = 0;
  const int code = df_dump(system, &text, &length);
  return {code, code == DF_OK ? std::string(text, length) : ""};
}

/// The first `size` bytes of a structure, in memory of that size, with its size field set.
template <class Structure>
class Sized {
 public:
  Sized(Structure structure, std::size_t size) : memory_(std::max(size, sizeof size)) {
    structure.size = size;
    std::memcpy(memory_.data(), &structure, std::min(memory_.size(), sizeof structure));
  }
  Structure* get() { return reinterpret_cast<Structure*>(memory_.data()); }
  Structure value() const {  // members that it has no room for are 0
    Structure structure{};
    std::memcpy(&structure, memory_.data(), std::min(memory_.size(), sizeof structure));
    return structure;
  }

 private:
  std::vector<std::byte> memory_;
};

class CProgram {
 public:
  explicit CProgram(FuzzInput& input) : input_(input) {}

  void call() {
    if (chance(2)) df_stop(system_.get());  // which does nothing between calls
    switch (input_.below(12)) {
      case 0: return mesh();
      case 1: return draw();
      case 2: return draw_as();
      case 3: return pieces();
      case 4: return pick();
      case 5: return replay();
      case 6: return call_numbers();
      case 7: return aspect();
      case 8: return another_eye();
      default: return call_words();
    }
  }

 private:
  // ---- Both systems ------------------------------------------------------------------------

  /// Makes the call, and if it succeeds, or stays where it fails, the same for the twin.
  void make(const std::function<Returned(df_system*)>& call, bool stays = false) {
    const Returned returned = call(system_.get());
    const bool is_ok = returned.code == DF_OK;
    if (returned.code == DF_BUSY) failed("a system is busy that nobody calls");
    if (is_ok != (df_error(system_.get())[0] == '\0')) failed("an error without a message, or not");
    if ((is_ok || stays) && call(twin_.get()) != returned)
      failed("the twin returns something else");
    if (dumped(system_.get()) != dumped(twin_.get())) failed("the twin's dump is another one");
  }

  // ---- Arguments ---------------------------------------------------------------------------

  bool chance(int percent) { return input_.below(100) < percent; }
  double number() {
    constexpr double kOdd[] = {0.0,
                               -0.0,
                               1e100,
                               2e100,
                               5e-324,
                               1e308,
                               std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()};
    if (chance(4)) return kOdd[input_.below(std::size(kOdd))];
    return chance(3) ? input_.any_double() : (input_.below(33) - 16) / 16.0;
  }
  std::vector<double> numbers(std::size_t count) {
    std::vector<double> all(count);
    for (double& value : all) value = number();
    return all;
  }
  template <std::size_t N>
  const char* one_of(const char* const (&words)[N]) {
    return words[input_.below(static_cast<int>(N))];
  }
  std::size_t size_of(std::size_t right) {
    if (chance(85)) return right;
    return static_cast<std::size_t>(input_.below(static_cast<int>(right + 24)));
  }
  const char* routine() {
    constexpr const char* kWrong[] = {nullptr, "", "#", "fly-3", "set-light 1 1 1", "move-abs-3\n"};
    if (chance(3)) return one_of(kWrong);
    return df_routine_name(input_.byte() % df_routines());
  }

  df_options options() {
    constexpr const char* kMethods[] = {"bsp",  "map",       "z-buffer", "franklin", "auto",
                                        "none", "scan-line", "fly",      ""};
    df_options said = DF_OPTIONS_INIT;
    said.width = chance(95) ? 8 : input_.below(4) - 2;
    said.height = chance(95) ? 6 : (input_.below(4) - 2) * 40000;
    if (chance(70)) said.method = one_of(kMethods);
    if (chance(10)) said.scope = one_of({"all", "segment", "none"});
    if (chance(10)) said.precision = one_of({"exact", "roundoff", "roundoff=1e-7", "roundoff=2"});
    if (chance(10)) said.hidden_lines = one_of({"dashed", "none", "dotted"});
    if (chance(10)) said.line_order = one_of({"entry", "depth", "width"});
    if (chance(10)) said.line_halo = number();
    if (chance(5)) said.device = one_of({"software", "plotter"});
    if (chance(10)) said.background = input_.below(5) - 1;
    if (chance(10)) said.background_colour[input_.below(3)] = number();
    if (chance(10)) said.samples = input_.below(5) - 1;
    if (chance(5)) said.threads = input_.below(4) - 1;
    if (chance(5)) said.most_pieces = input_.byte();
    if (chance(5)) said.most_comparisons = input_.byte();
    if (chance(5)) said.most_bytes = std::uint64_t{input_.byte()} << 8;
    if (chance(5)) said.most_seconds = chance(50) ? 1e9 : -number();
    if (chance(10)) {
      said.first_row = input_.below(8) - 1;
      said.end_row = chance(90) ? input_.below(9) : std::numeric_limits<int>::max();
    }
    if (chance(3)) said.font = one_of({"serif", "hershey", "hershey:", "a;b", ""});
    if (chance(3)) said.text = one_of({"text", "outlines", "lines", ""});
    return said;
  }

  // ---- Calls -------------------------------------------------------------------------------

  void call_words() {
    constexpr const char* kWords[] = {
        "on",  "off", "solid", "none", "hollow", "1",     "2",      "3", "0.5", "0",     "-1",
        "map", "bsp", "all",   "#",    "\"a\"",  "union", "dashed", "x", "nan", "1e999", "\n"};
    const char* const name = routine();
    std::string words;
    for (int n = input_.below(10); n > 0; --n) (words += one_of(kWords)) += ' ';
    const bool is_null = chance(2);
    make([&](df_system* s) {
      return Returned{df_call(s, name, is_null ? nullptr : words.c_str())};
    });
  }
  void call_numbers() {
    const char* const name = chance(60) ? one_of({"polygon-abs-3", "line-abs-3", "open-segment",
                                                  "surface-3", "box-3", "set-light"})
                                        : routine();
    const std::vector<double> all = numbers(static_cast<std::size_t>(input_.below(13)));
    const bool is_null = chance(2);
    make([&](df_system* s) {
      return Returned{df_call_numbers(s, name, is_null ? nullptr : all.data(), all.size())};
    });
  }
  void aspect() {
    const double aspect = number();
    make([&](df_system* s) { return Returned{df_set_aspect_ratio(s, aspect)}; });
  }
  void replay() {
    constexpr const char* kLines[] = {"open-segment 7\n",
                                      "close-segment\n",
                                      "move-abs-3 0 0 0\n",
                                      "polygon-abs-3 0 0 0 1 0 0 0 1 0\n",
                                      "fly\n",
                                      "text \"a\"",
                                      "set-hidden-line-removal on\n"};
    std::string text;
    for (int n = input_.below(6); n > 0; --n) text += one_of(kLines);
    const bool is_null = chance(2);
    make(
        [&](df_system* s) {
          return Returned{df_replay(s, is_null ? nullptr : text.data(), text.size(), "text")};
        },
        true);
  }
  void mesh() {
    const auto count = [&](std::size_t right) {
      return chance(95) ? right : static_cast<std::size_t>(input_.below(7));
    };
    const std::size_t vertices = static_cast<std::size_t>(input_.below(8));
    const std::size_t polygons = static_cast<std::size_t>(input_.below(4));
    const std::vector<double> points = numbers(3 * vertices), normals = numbers(3 * vertices);
    std::vector<double> colours = numbers(3 * polygons);
    if (chance(90)) std::ranges::fill(colours, 0.5);
    std::vector<std::uint32_t> corners(3 * polygons);
    for (std::uint32_t& corner : corners) {
      corner = static_cast<std::uint32_t>(input_.below(static_cast<int>(vertices) + 1));
      if (corner == vertices && chance(95)) corner = 0;
    }
    const std::vector<std::uint32_t> sides(polygons, chance(90) ? 3 : input_.byte());
    const std::vector<std::int32_t> picks(polygons, input_.byte() - 8);
    df_mesh said = DF_MESH_INIT;
    said.vertices = chance(98) ? points.data() : nullptr;
    said.vertex_count = vertices == 0 ? 0 : std::min(count(vertices), vertices);
    said.corners = corners.data();
    said.corner_count = std::min(count(corners.size()), corners.size());
    if (chance(40)) said.sides = sides.data(), said.polygon_count = polygons;
    if (chance(40))
      said.colours = colours.data(), said.colour_count = std::min(count(polygons), polygons);
    if (chance(40))
      said.picks = picks.data(), said.pick_count = std::min(count(polygons), polygons);
    if (chance(20)) said.normals = normals.data(), said.normal_count = said.vertex_count;
    Sized<df_mesh> sized(said, size_of(sizeof said));
    const bool is_null = chance(1);
    make([&](df_system* s) { return Returned{df_polygons(s, is_null ? nullptr : sized.get())}; });
  }
  void draw() {
    constexpr std::size_t kRoom = 64;
    Sized<df_options> said(options(), size_of(sizeof(df_options)));
    const std::size_t pixels = chance(80) ? 48 : static_cast<std::size_t>(input_.below(kRoom));
    const bool with_ids = chance(30), with_depth = chance(30), is_null = chance(1);
    make([&](df_system* s) {
      std::vector<std::uint8_t> rgba(4 * pixels);
      std::vector<std::int32_t> ids(pixels);
      std::vector<double> depth(pixels);
      const int code =
          df_draw(s, is_null ? nullptr : said.get(), pixels, rgba.data(),
                  with_ids ? ids.data() : nullptr, with_depth ? depth.data() : nullptr);
      if (code != DF_OK) return Returned{code};
      return Returned{code, bytes_of(rgba.data(), 4 * pixels) + bytes_of(ids.data(), pixels) +
                                bytes_of(depth.data(), pixels)};
    });
  }
  void draw_as() {
    Sized<df_options> said(options(), size_of(sizeof(df_options)));
    const char* const format = one_of({"svg", "ppm", "png", "eps", "gif", ""});
    make([&](df_system* s) {
      const char* bytes = nullptr;
      std::size_t length = 0;
      const int code = df_draw_as(s, said.get(), format, &bytes, &length);
      return code == DF_OK ? Returned{code, {bytes, length}} : Returned{code};
    });
  }
  void pieces() {
    Sized<df_options> said(options(), size_of(sizeof(df_options)));
    const std::size_t size = size_of(sizeof(df_pieces));
    make([&](df_system* s) {
      Sized<df_pieces> out({}, size);
      const int code = df_drawn_pieces(s, said.get(), out.get());
      if (code != DF_OK) return Returned{code};
      const df_pieces p = out.value();
      Returned returned{code, std::to_string(p.pieces)};
      if (p.first == nullptr) return returned;
      const std::size_t points = p.pieces == 0 ? 0 : p.first[p.pieces];
      if (p.points != nullptr) returned.bytes += bytes_of(p.points, 3 * points);
      if (p.sides != nullptr) returned.bytes += bytes_of(p.sides, points);
      if (p.cuts != nullptr) returned.bytes += bytes_of(p.cuts, points);
      if (p.fills != nullptr) returned.bytes += bytes_of(p.fills, 3 * p.pieces);
      if (p.segments != nullptr) returned.bytes += bytes_of(p.segments, p.pieces);
      return returned;
    });
  }
  void pick() {
    Sized<df_options> said(options(), size_of(sizeof(df_options)));
    const double x = 8.0 * number(), y = 6.0 * number(), reach = chance(50) ? 0.0 : number();
    const std::size_t size = size_of(sizeof(df_seen));
    make([&](df_system* s) {
      Sized<df_seen> seen({}, size);
      const int code = df_pick(s, said.get(), x, y, reach, seen.get());
      const df_seen value = seen.value();
      if (code != DF_OK) return Returned{code};
      return Returned{code, std::to_string(value.is_seen) + ' ' + std::to_string(value.pick)};
    });
  }

  void another_eye() {
    switch (input_.below(5)) {
      case 0: return make([](df_system* s) { return Returned{df_retain(s)}; });
      case 1: return look_from();
      case 2:
        return make([](df_system* s) {
          std::vector<double> box(6);
          const int code = df_box(s, box.data());
          return code == DF_OK ? Returned{code, bytes_of(box.data(), 6)} : Returned{code};
        });
      case 3:
        return make([](df_system* s) {
          const char* text = nullptr;
          std::size_t length = 0;
          const int code = df_program(s, &text, &length);
          return code == DF_OK ? Returned{code, {text, length}} : Returned{code};
        });
      default: return truth();
    }
  }
  /// From near where it was drawn, or from anywhere.
  void look_from() {
    const std::size_t size = size_of(sizeof(df_view));
    const bool is_near = chance(80), is_null = chance(20);
    const std::vector<double> moved = numbers(3);
    const int changed = input_.byte();
    make([&](df_system* s) {
      df_view view{};
      view.size = sizeof view;
      if (is_near && df_drawn_view(s, &view) != DF_OK) return Returned{DF_ERROR};
      std::ranges::copy(moved, (changed & 1) != 0 ? view.projection : view.reference_point);
      if ((changed & 2) != 0) view.window[0] -= moved[0];
      if ((changed & 4) != 0) view.is_perspective = 1 - view.is_perspective;
      if ((changed & 8) != 0) view.clips_back = 1;
      Sized<df_view> said(view, size);
      return Returned{df_look_from(s, is_null ? nullptr : said.get())};
    });
  }
  void truth() {
    Sized<df_options> said(options(), size_of(sizeof(df_options)));
    make([&](df_system* s) {
      std::vector<std::int32_t> ids(48);
      const int code = df_truth(s, said.get(), ids.size(), ids.data(), nullptr);
      return code == DF_OK ? Returned{code, bytes_of(ids.data(), ids.size())} : Returned{code};
    });
  }

  FuzzInput& input_;
  System system_{df_create()}, twin_{df_create()};
};

}  // namespace

// The memory that Fontconfig keeps until the process ends, for texts in PNG.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzInput input({data, size});
  CProgram program(input);
  while (!input.empty()) program.call();
  return 0;
}
