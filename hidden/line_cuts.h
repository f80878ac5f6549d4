#pragma once

#include <cstdint>

namespace displayfile {

/// At which ends a part of a line is cut: the line goes on there, but something hides the rest of
/// it, or it is outside of the view. An end that is not cut is an end of the line itself.
struct LineCuts {
  bool at_start = false, at_end = false;

  bool any() const { return at_start || at_end; }
  LineCuts reversed() const { return {at_end, at_start}; }
  bool operator==(const LineCuts&) const = default;

  /// As a byte, 0 without cuts.
  std::uint8_t byte() const {
    return static_cast<std::uint8_t>((at_start ? 1 : 0) | (at_end ? 2 : 0));
  }
  static LineCuts of(std::uint8_t byte) { return {(byte & 1) != 0, (byte & 2) != 0}; }
};

}  // namespace displayfile
