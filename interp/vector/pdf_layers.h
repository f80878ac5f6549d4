#pragma once

#include <span>
#include <string>
#include <string_view>

namespace displayfile {

/// The structure element that Cairo is told to mark content of layers as.
inline constexpr const char* kMarkOfLayer = "Span";

/// A PDF document of one page as Cairo wrote it, whose content has so many parts that were marked
/// as kMarkOfLayer, with each of these in a layer: an optional content group, of that name, which
/// readers show in a list and can hide (ISO 32000-1, 8.11). Cairo knows no layers. Throws Error if
/// there is no library that changes PDF files, or if the document is not as expected.
std::string with_layers(const std::string& document,
                        std::span<const std::string_view> layer_of_parts);

}  // namespace displayfile
