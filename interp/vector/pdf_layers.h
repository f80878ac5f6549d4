#pragma once

#include <span>
#include <string>
#include <string_view>

namespace displayfile {

/// The structure element with which Cairo marks content of layers.
inline constexpr const char* kMarkOfLayer = "Span";

/// Converts a one-page PDF document written by Cairo, with this many parts marked as kMarkOfLayer,
/// to one with each of these in a layer: an optional content group with that name, which readers
/// list and can hide (ISO 32000-1, 8.11). Cairo has no layers. Throws Error without the library
/// that edits PDF files, or if the document is not as expected.
std::string with_layers(const std::string& document, std::span<const std::string> layer_of_parts);

/// True if the library that edits PDF files is there.
bool has_pdf_layers();

}  // namespace displayfile
