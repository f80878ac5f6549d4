#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "hidden/exact/precision_policies.h"

namespace displayfile {

/// The arrays of the D buffer and of the E buffer (the textbook's ID, XD, YD, ZD and IE, XE, YE,
/// ZE): the sides of polygons, each with the vertex at which it ends. They grow as needed.
class SideBuffer {
 public:
  struct Side {
    std::uint32_t vertex;  ///< number in the vertex table
    SideLine line;         ///< the side's line
    std::uint8_t
        visible;  ///< as Primitives::visible: the textbook's line, or for a cut side a move
  };

  /// PUT-IN-D and PUT-IN-E (algorithms 9.14 and 9.15).
  void put(const Side& side) {
    vertex_.push_back(side.vertex);
    line_.push_back(side.line);
    visible_.push_back(side.visible);
  }
  void replace(std::uint32_t at, const Side& side) {
    assert(at < free());
    vertex_[at] = side.vertex;
    line_[at] = side.line;
    visible_[at] = side.visible;
  }
  Side operator[](std::uint32_t at) const {
    assert(at < free());
    return {vertex_[at], line_[at], visible_[at]};
  }
  std::uint32_t vertex(std::uint32_t at) const {
    assert(at < free());
    return vertex_[at];
  }
  std::span<const std::uint32_t> vertices(std::uint32_t first, std::uint32_t sides) const {
    assert(first <= free() && sides <= free() - first);
    return std::span(vertex_).subspan(first, sides);
  }

  /// DFREE, EFREE: the next free place.
  std::uint32_t free() const { return static_cast<std::uint32_t>(vertex_.size()); }
  std::size_t bytes() const {
    return vertex_.capacity() * (sizeof(vertex_[0]) + sizeof(line_[0]) + sizeof(visible_[0]));
  }
  void clear() { shrink(0); }
  void shrink(std::uint32_t free) {
    vertex_.resize(free);
    line_.resize(free);
    visible_.resize(free);
  }
  void reserve(std::size_t sides) {
    vertex_.reserve(sides);
    line_.reserve(sides);
    visible_.reserve(sides);
  }

 private:
  std::vector<std::uint32_t> vertex_;
  std::vector<SideLine> line_;
  std::vector<std::uint8_t> visible_;
};

}  // namespace displayfile
