#include "displayfile/mesh/import_losses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <limits>
#include <string_view>

#include "clip/base/files.h"
#include "clip/geometry/bounds.h"

namespace displayfile {

void ImportLosses::add(std::size_t count, const std::string& one, const std::string& many) {
  if (count > 0) left_out.push_back(left_out_sentence(count, one, many));
}

ForeignFormat foreign_format(const std::string& path, bool by_extension) {
  const std::string extension = extension_of(path);
  if (extension == ".gltf" || extension == ".glb") return ForeignFormat::gltf;
  if (extension == ".3mf") return ForeignFormat::three_mf;
  if (by_extension) return ForeignFormat::other;
  std::array<char, 4> bytes{};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  const std::string_view beginning(bytes.data(), bytes.size());
  if (beginning == "glTF" || beginning.starts_with('{')) return ForeignFormat::gltf;
  return beginning.starts_with("PK") ? ForeignFormat::three_mf : ForeignFormat::other;
}

namespace {

/// The distance between neighbouring single-precision numbers of that size.
double distance_between_floats(double size) {
  const auto f = static_cast<float>(size);
  return static_cast<double>(std::nextafter(f, std::numeric_limits<float>::infinity())) -
         static_cast<double>(f);
}

}  // namespace

void LostDetail::add_edge(const Point3& from, const Point3& to) {
  constexpr double kEnough = 64.0;
  const double size = std::max(largest_coordinate(from), largest_coordinate(to));
  const double length = glm::distance(from, to);
  ++edges_;
  if (length >= kEnough * distance_between_floats(size)) return;
  ++lost_;
  largest_ = std::max(largest_, size);
}

std::optional<std::string> LostDetail::sentence() const {
  if (10 * lost_ <= edges_) return std::nullopt;
  return fmt::format(
      "its coordinates, up to {:.6g}, were read in single precision, which rounds them to "
      "multiples of {:.2g}: {} of {} edges are too short for that",
      largest_, distance_between_floats(largest_), lost_, edges_);
}

}  // namespace displayfile
