#include <cstddef>
#include <string>
#include <type_traits>

#include "interp/c/displayfile_c.h"

// The layout of the C API's structures, as JSON, so that a page need not know the compiler's layout
// rules: {"df_options": {"size": 96, "members": {"width": ["i32", 4], ...}}, ...}.

namespace {

template <typename Member>
const char* kind() {
  if constexpr (std::is_pointer_v<Member>) return "pointer";
  if constexpr (std::is_array_v<Member>) {  // of doubles
    static const std::string numbers = "numbers" + std::to_string(std::extent_v<Member>);
    return numbers.c_str();
  }
  if constexpr (std::is_same_v<Member, double>) return "f64";
  if constexpr (std::is_same_v<Member, std::uint64_t>) return "u64";
  return std::is_signed_v<Member> ? "i32" : "u32";
}

class Layout {
 public:
  Layout& structure(const char* name, std::size_t size) {
    text_ += text_.empty() ? "{" : "}},";
    text_ += '"' + std::string(name) + "\":{\"size\":" + std::to_string(size) + ",\"members\":{";
    separator_ = "";
    return *this;
  }
  template <typename Member>
  Layout& member(const char* name, std::size_t place) {
    text_ += separator_ + ('"' + std::string(name)) + "\":[\"" + kind<Member>() + "\"," +
             std::to_string(place) + ']';
    separator_ = ",";
    return *this;
  }
  std::string text() const { return text_ + "}}}"; }

 private:
  std::string text_, separator_;
};

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): a member's name is needed as a word
#define MEMBER(structure, name) .member<decltype(structure::name)>(#name, offsetof(structure, name))

extern "C" const char* df_layout() {
  static const std::string text =
      Layout()
          .structure("df_mesh", sizeof(df_mesh)) MEMBER(df_mesh, vertices)
              MEMBER(df_mesh, vertex_count) MEMBER(df_mesh, corners) MEMBER(df_mesh, corner_count)
                  MEMBER(df_mesh, sides) MEMBER(df_mesh, polygon_count) MEMBER(df_mesh, colours)
                      MEMBER(df_mesh, colour_count) MEMBER(df_mesh, picks)
                          MEMBER(df_mesh, pick_count) MEMBER(df_mesh, normals)
                              MEMBER(df_mesh, normal_count)
          .structure("df_options", sizeof(df_options)) MEMBER(df_options, width)
              MEMBER(df_options, height) MEMBER(df_options, method) MEMBER(df_options, scope)
                  MEMBER(df_options, precision) MEMBER(df_options, hidden_lines)
                      MEMBER(df_options, background) MEMBER(df_options, background_colour)
                          MEMBER(df_options, samples) MEMBER(df_options, most_pieces)
                              MEMBER(df_options, most_seconds) MEMBER(df_options, line_order)
                                  MEMBER(df_options, line_halo) MEMBER(df_options, font)
                                      MEMBER(df_options, text)
          .structure("df_pieces", sizeof(df_pieces)) MEMBER(df_pieces, pieces)
              MEMBER(df_pieces, kinds) MEMBER(df_pieces, first) MEMBER(df_pieces, points)
                  MEMBER(df_pieces, sides) MEMBER(df_pieces, fills) MEMBER(df_pieces, line_colours)
                      MEMBER(df_pieces, line_widths) MEMBER(df_pieces, line_kinds)
                          MEMBER(df_pieces, picks) MEMBER(df_pieces, segments)
                              MEMBER(df_pieces, cuts)
          .structure("df_seen", sizeof(df_seen)) MEMBER(df_seen, is_seen) MEMBER(df_seen, kind)
              MEMBER(df_seen, pick) MEMBER(df_seen, segment) MEMBER(df_seen, depth)
          .structure("df_view", sizeof(df_view)) MEMBER(df_view, reference_point)
              MEMBER(df_view, plane_normal) MEMBER(df_view, up) MEMBER(df_view, distance)
                  MEMBER(df_view, is_perspective) MEMBER(df_view, projection) MEMBER(df_view, depth)
                      MEMBER(df_view, clips_front) MEMBER(df_view, clips_back)
                          MEMBER(df_view, window) MEMBER(df_view, viewport)
          .text();
  return text.c_str();
}
