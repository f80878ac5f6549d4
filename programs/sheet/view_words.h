#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "programs/sheet/arrangement.h"

namespace displayfile {

/// The views of a sheet in the words of options, in order.
inline constexpr std::array<std::string_view, 4> kViewNames{"front", "top", "side", "isometric"};

/// The words between commas; some may be empty.
std::vector<std::string_view> words_between_commas(std::string_view words);

/// The positions of sections, from words such as `front=0`. Throws Error for any other word, for
/// the isometric view, and for a second section in one view.
std::array<std::optional<double>, 4> sections_of(const std::vector<std::string>& words);

/// In which views hidden lines are drawn: `all`, `none`, or names of views between commas; empty:
/// in those that are neither cut nor isometric. `dashed` is another word for `all`. Throws Error
/// for any other word.
std::array<bool, 4> hidden_lines_in_views(const std::string& words,
                                          const std::array<std::optional<double>, 4>& sections);

/// Details from words such as `front=10,5,3@5:1`: the middle of a circle and its radius in the
/// view's coordinates, and a scale. Throws Error for any other word, and for more than there are
/// letters.
std::vector<DetailWanted> details_of(const std::vector<std::string>& words);

}  // namespace displayfile
