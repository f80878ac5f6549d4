#include "clip/surfaces.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/words.h"
#include "clip/geometry/crease_angle.h"

namespace displayfile {

namespace {

constexpr std::array kKinds{
    LineKindEntry{LineKind::outline, "outline"},
    LineKindEntry{LineKind::boundary, "boundary"},
    LineKindEntry{LineKind::crease, "crease"},
    LineKindEntry{LineKind::material, "material"},
    LineKindEntry{LineKind::intersection, "intersection"},
    LineKindEntry{LineKind::all, "all"},
};

constexpr LineKinds kEveryKind = [] {
  LineKinds kinds = 0;
  for (const LineKindEntry& entry : kKinds) {
    kinds = static_cast<LineKinds>(kinds | kinds_of(entry.kind));
  }
  return kinds;
}();

constexpr std::string_view kHiddenName = "hidden";
constexpr std::string_view kExpected = "expected";
constexpr std::string_view kCrease = "crease=";

double degrees_of(std::string_view word) {
  const std::string_view digits = word.substr(kCrease.size());
  double degrees = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, degrees);
  if (error == std::errc{} && stop == end && is_crease_angle(degrees)) return degrees;
  throw Error("expected crease=DEGREES, a number from 0 to 180, not " + quoted(word));
}

}  // namespace

std::span<const LineKindEntry> line_kinds() { return kKinds; }

std::string names_of(LineKinds kinds) {
  std::string names;
  for (const auto& [kind, name] : kKinds) {
    if (contains(kinds, kind)) names.append(names.empty() ? "" : " ").append(name);
  }
  if (is_hidden_line(kinds)) names.append(names.empty() ? "" : " ").append(kHiddenName);
  return names;
}

std::string_view first_name_of(LineKinds kinds) {
  if (is_hidden_line(kinds)) return kHiddenName;
  const auto first =
      std::ranges::find_if(kKinds, [&](const auto& entry) { return contains(kinds, entry.kind); });
  return first == kKinds.end() ? std::string_view() : first->name;
}

void add_line_kind(std::string_view word, LineSelection& selection) {
  std::string_view name = word;
  if (word.starts_with(kCrease)) {
    selection.crease_degrees = degrees_of(word);
    name = kCrease.substr(0, kCrease.size() - 1);
  }
  const auto entry = std::ranges::find(kKinds, name, &LineKindEntry::name);
  if (entry == kKinds.end()) {
    std::vector<std::string_view> known;
    known.reserve(kKinds.size());
    for (const LineKindEntry& kind : kKinds) known.push_back(kind.name);
    refuse_word(word, known, kExpected);
  }
  selection.kinds = static_cast<LineKinds>(selection.kinds | kinds_of(entry->kind));
}

LineSelection line_selection(std::string_view text) {
  LineSelection selection{.kinds = 0};
  for (std::string_view rest = text;;) {
    const std::size_t length = std::min(rest.find(','), rest.size());
    add_line_kind(rest.substr(0, length), selection);
    if (length == rest.size()) return selection;
    rest.remove_prefix(length + 1);
  }
}

std::string words_of(const LineSelection& selection) {
  std::string words;
  for (const auto& [kind, name] : kKinds) {
    if (!contains(selection.kinds, kind)) continue;
    words.append(words.empty() ? "" : " ").append(name);
    if (kind != LineKind::crease || selection.crease_degrees == LineSelection{}.crease_degrees) {
      continue;
    }
    std::array<char, 32> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), selection.crease_degrees);
    words.append("=").append(digits.data(), end.ptr);
  }
  return words;
}

void require_selection(const LineSelection& selection) {
  if ((selection.kinds & kEveryKind) == 0 || (selection.kinds & ~kEveryKind) != 0) {
    throw Error("unknown kinds of lines: expected one or more of " + names_of(kEveryKind));
  }
  require_crease_angle(selection.crease_degrees);
}

}  // namespace displayfile
