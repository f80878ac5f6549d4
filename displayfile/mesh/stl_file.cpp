// STL: M. Burns, "Automated Fabrication", section 6.5, Prentice Hall 1993.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "clip/base/error.h"
#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/mesh_file.h"
#include "displayfile/mesh/text_cursor.h"
#include "displayfile/text/characters.h"

namespace displayfile {

namespace {

// Bytes.
constexpr std::size_t kHeader = 80, kCount = 4, kFacet = 50, kNormalBytes = 12, kAttribute = 2;

/// The number of facets that a binary file announces; 0 if the file is too short.
std::uint64_t announced_facets(std::string_view data) {
  if (data.size() < kHeader + kCount) return 0;
  return binary_value<std::uint32_t>(data.substr(kHeader), std::endian::little);
}

/// Compares a word of the text, in letters of either case.
bool is_word(std::string_view word, std::string_view in_lower_case) {
  return std::equal(
      word.begin(), word.end(), in_lower_case.begin(), in_lower_case.end(),
      [](char c, char lower) { return (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) == lower; });
}

/// True if the file is text. A binary file may begin with "solid" too: then its size decides, also
/// if some bytes follow its facets. Characters of text read as a count are more than 150 million.
bool is_text(std::string_view data) {
  constexpr std::string_view kSolid = "solid";
  const std::uint64_t size = kHeader + kCount + kFacet * announced_facets(data);
  const bool size_fits = data.size() == size || (data.size() > size && announced_facets(data) > 0);
  const std::string_view text = without_byte_order_mark(data);
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return !size_fits && is_word(text.substr(start, kSolid.size()), kSolid);
}

void add_facet(MeshBuilder& mesh) {
  const auto end = static_cast<std::uint32_t>(mesh.vertices());
  mesh.add_face(std::array{end - 3, end - 2, end - 1});
}

/// Programs write colours into the two bytes after each facet, and one for all into the header.
/// They disagree about the order of the components.
void warn_of_colours(std::string_view data, std::size_t facets, MeshBuilder& mesh) {
  std::size_t coloured = 0;
  for (std::size_t i = 0; i < facets; ++i) {
    const std::string_view attribute =
        data.substr(kHeader + kCount + kFacet * (i + 1) - kAttribute, kAttribute);
    coloured += attribute != std::string_view("\0\0", kAttribute) ? 1 : 0;
  }
  mesh.warn_left_out(coloured, "the two bytes behind {} facet, perhaps its colour",
                     "the two bytes behind {} facets, perhaps their colours");
  if (data.substr(0, kHeader).find("COLOR=") == std::string_view::npos) return;
  mesh.warn("left out: the colour in the header");
}

Mesh read_binary(const MeshFile& file) {
  const std::string_view data = file.data;
  const std::uint64_t announced = announced_facets(data);
  if (data.size() < kHeader + kCount || announced > (data.size() - kHeader - kCount) / kFacet) {
    throw Error(
        fmt::format("{}: neither STL text, which begins with 'solid', nor binary STL: expected {} "
                    "bytes for {} facets, not {}",
                    file.path, kHeader + kCount + kFacet * announced, announced, data.size()));
  }
  const auto facets = static_cast<std::size_t>(announced);
  MeshBuilder mesh(file.path);
  mesh.reserve(3 * facets, facets);
  for (std::size_t i = 0; i < facets; ++i) {
    std::string_view rest = data.substr(kHeader + kCount + kFacet * i + kNormalBytes);
    for (int k = 0; k < 3; ++k) {
      Point3 p(0.0);
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = binary_value<float>(rest, std::endian::little);
        rest.remove_prefix(sizeof(float));
      }
      if (!in_range(p)) {
        throw Error(
            fmt::format("{}: facet {}: vertex {} is ({}, {}, {}): expected finite "
                        "coordinates",
                        file.path, i, k, p.x, p.y, p.z));
      }
      mesh.add_vertex(p);
    }
    add_facet(mesh);
  }
  const std::size_t left = data.size() - kHeader - kCount - kFacet * facets;
  if (left > 0 && left % kFacet == 0) {
    mesh.warn(fmt::format(
        "{} those that it announces: left out",
        left == kFacet ? "1 facet follows" : fmt::format("{} facets follow", left / kFacet)));
  }
  warn_of_colours(data, facets, mesh);
  mesh.set_single_precision();
  return std::move(mesh).finish();
}

/// Reads text. Unknown words are skipped; facets and solids must be complete.
class StlText {
 public:
  explicit StlText(const MeshFile& file) : text_(text_of(file.path, file.data)), mesh_(file.path) {}

  Mesh read() && {
    for (auto word = text_.field_on_any_line(); !word.empty(); word = text_.field_on_any_line()) {
      read_part(word);
    }
    if (in_solid_) text_.fail(text_.at(), "end of file: expected endsolid");
    warn_of_other_words();
    mesh_.note_rounding(text_.rounding_of_coordinates());
    return std::move(mesh_).finish();
  }

 private:
  void read_part(std::string_view word) {
    if (is_word(word, "vertex")) {
      mesh_.add_vertex(text_.position());
      ++vertices_;
    } else if (is_word(word, "facet")) {
      require_whole_facet(word);
      vertices_ = 0;
      in_facet_ = true;
    } else if (is_word(word, "endfacet")) {
      if (!in_facet_ || vertices_ != 3) {
        text_.fail(word, fmt::format("a facet of {} vertices: expected 3", vertices_));
      }
      add_facet(mesh_);
      vertices_ = 0;
      in_facet_ = false;
    } else if (is_word(word, "solid")) {
      require_whole_facet(word);
      mesh_.begin_object(text_.rest_of_line());
      in_solid_ = true;
    } else if (is_word(word, "endsolid")) {
      require_whole_facet(word);
      text_.rest_of_line();
      in_solid_ = false;
    } else if (!is_number(word) && !is_of_every_facet(word)) {
      if (other_words_++ == 0) first_other_ = word;
    }
  }

  static bool is_of_every_facet(std::string_view word) {
    return is_word(word, "normal") || is_word(word, "outer") || is_word(word, "loop") ||
           is_word(word, "endloop");
  }

  /// True for a component of a normal, which need not be finite: some programs write -nan(ind).
  static bool is_number(std::string_view word) {
    return number<double>(word) || is_word(word.substr(0, 3), "nan") ||
           is_word(word.substr(0, 4), "-nan");
  }

  void warn_of_other_words() {
    if (other_words_ == 0) return;
    mesh_.warn(fmt::format("{}: {}: not read: {}", text_.place(text_.offset(first_other_)),
                           TextCursor::quoted(first_other_),
                           other_words_ == 1
                               ? "the word is left out"
                               : fmt::format("{} such words are left out", other_words_)));
  }

  void require_whole_facet(std::string_view word) const {
    if (in_facet_) text_.fail(word, fmt::format("{}: expected endfacet first", word));
    if (vertices_ > 0) text_.fail(word, fmt::format("{}: vertices outside of a facet", word));
  }

  TextCursor text_;
  MeshBuilder mesh_;
  int vertices_ = 0;  // of the current facet
  bool in_solid_ = false, in_facet_ = false;
  std::size_t other_words_ = 0;
  std::string_view first_other_;
};

}  // namespace

Mesh read_stl(const MeshFile& file) {
  return is_text(file.data) ? StlText(file).read() : read_binary(file);
}

}  // namespace displayfile
