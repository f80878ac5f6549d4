#include "displayfile/mesh/mesh_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "clip/base/error.h"
#include "clip/geometry/bounds.h"
#include "clip/geometry/secret_hash.h"
#include "clip/surfaces.h"
#include "displayfile/mesh/import_losses.h"

namespace displayfile {

bool has_three_positions(std::span<const Point3> vertices, std::span<const std::uint32_t> corners) {
  const Point3& first = vertices[corners[0]];
  const Point3* second = nullptr;
  for (const std::uint32_t corner : corners) {
    const Point3& p = vertices[corner];
    if (p == first) continue;
    if (second == nullptr) {
      second = &p;
    } else if (p != *second) {
      return true;
    }
  }
  return false;
}

namespace {

// ---- Colours ---------------------------------------------------------------------------

/// Marks a vertex of unknown colour.
constexpr Rgba kNoColour(-1.0);

/// Some programs write colours up to 1, some up to 255, whatever the type of the numbers: if a
/// component of any colour is larger than this, all are up to 255.
constexpr double kMostOfUnitRange = 2.0;

void bring_to_unit_range(std::span<Rgba> colours) {
  const auto largest = [](double most, const Rgba& c) { return std::max({most, c.r, c.g, c.b}); };
  const bool bytes =
      std::accumulate(colours.begin(), colours.end(), 0.0, largest) > kMostOfUnitRange;
  for (Rgba& c : colours) {
    if (c != kNoColour) c = brought_into_range(bytes ? c / 255.0 : c);
  }
}

std::size_t hash_of(const Rgba& c) { return SecretHash()(Point3(c)); }
std::size_t hash_of(const Mesh::Material& m) { return m.colour ? SecretHash()(*m.colour) : 0; }

}  // namespace

MeshBuilder::MeshBuilder(std::string_view path) : path_(path) {
  mesh_.first_corner = {0};
  begin_object("");
}

std::size_t MeshBuilder::begin_object(std::string_view name) {
  names_.emplace_back(name);
  go_on_with(names_.size() - 1);
  return names_.size() - 1;
}

void MeshBuilder::go_on_with(std::size_t object) { runs_.push_back({object, mesh_.faces()}); }

void MeshBuilder::reserve(std::size_t vertices, std::size_t faces) {
  mesh_.vertices.reserve(vertices);
  mesh_.first_corner.reserve(faces + 1);
  mesh_.corners.reserve(3 * faces);
}

void MeshBuilder::add_vertex(const Point3& position) {
  if (mesh_.vertices.size() == std::numeric_limits<std::uint32_t>::max()) {
    throw Error(fmt::format("{}: more than {} vertices", path_, mesh_.vertices.size()));
  }
  mesh_.vertices.push_back(position);
}

void MeshBuilder::warn_left_out(std::size_t count, std::string_view one, std::string_view many) {
  if (count > 0) warn(left_out_sentence(count, one, many));
}

void MeshBuilder::warn_of_lines_left(std::size_t lines) {
  if (lines == 0) return;
  warn(fmt::format("{} what it announces: left out",
                   lines == 1 ? "1 line follows" : fmt::format("{} lines follow", lines)));
}

void MeshBuilder::add_normal(const Point3& normal) {
  mesh_.normals.push_back(in_range(normal) ? normal : Point3(0.0));
}

void MeshBuilder::add_face(std::span<const std::uint32_t> corners,
                           std::span<const std::uint32_t> normals) {
  if (corners.size() < 3) return skip_points_and_lines(1);
  mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
  mesh_.corner_normals.insert(mesh_.corner_normals.end(), normals.begin(), normals.end());
  mesh_.first_corner.push_back(mesh_.corners.size());
  if (material_ != Mesh::kNoMaterial) {
    mesh_.face_materials.resize(mesh_.faces() - 1, Mesh::kNoMaterial);
    mesh_.face_materials.push_back(material_);
  }
}

std::uint32_t MeshBuilder::add_material(const Mesh::Material& material) {
  mesh_.materials.push_back(material);
  return static_cast<std::uint32_t>(mesh_.materials.size() - 1);
}

void MeshBuilder::use_colour(const std::optional<Rgba>& colour) {
  material_ = colour ? face_colours_.number(*colour, hash_of(*colour)) : Mesh::kNoMaterial;
}

void MeshBuilder::add_vertex_colour(const Rgba& colour) {
  vertex_colours_.resize(mesh_.vertices.size() - 1, kNoColour);
  vertex_colours_.push_back(colour);
}

Mesh MeshBuilder::finish() && {
  if (!mesh_.face_materials.empty()) {
    mesh_.face_materials.resize(mesh_.faces(), Mesh::kNoMaterial);
  }
  if (normals_as_vertices_) mesh_.corner_normals = mesh_.corners;
  if (mesh_.normals.empty()) mesh_.corner_normals.clear();
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    runs_[i].end_face = i + 1 < runs_.size() ? runs_[i + 1].first_face : mesh_.faces();
  }
  const bool in_order = std::ranges::is_sorted(runs_, {}, &Run::object);
  if (!in_order) std::ranges::stable_sort(runs_, {}, &Run::object);
  if (!in_order || has_degenerate_faces()) gather_faces();
  name_objects();
  find_rounding();
  give_faces_materials();
  if (mesh_.faces() == 0) fail_without_faces();
  return std::move(mesh_);
}

void MeshBuilder::fail_without_faces() const {
  const Mesh::Skipped& skipped = mesh_.skipped;
  const bool only_points =
      skipped.points_and_lines == 0 && skipped.degenerate_faces == 0 && !mesh_.vertices.empty();
  std::string found =
      only_points ? fmt::format("{} points and no faces: points are not drawn: expected polygons",
                                mesh_.vertices.size())
                  : fmt::format(
                        "no faces: expected polygons (found {} points and lines, and {} faces of "
                        "fewer than 3 different vertices)",
                        skipped.points_and_lines, skipped.degenerate_faces);
  for (const std::string& warning : skipped.warnings) found += "; " + warning;
  throw Error(fmt::format("{}: {}", path_, found));
}

void MeshBuilder::find_rounding() {
  constexpr double kMost = 0x1p-17;  // of the largest coordinate
  const double largest = largest_coordinate(mesh_.vertices);
  if (is_in_single_precision_) note_rounding(kUnitOfSingles * largest);
  mesh_.rounding = std::min(mesh_.rounding, kMost * largest);
}

bool MeshBuilder::is_degenerate(std::size_t face) const {
  return !has_three_positions(mesh_.vertices, mesh_.face(face));
}

bool MeshBuilder::has_degenerate_faces() const {
  for (std::size_t i = 0; i < mesh_.faces(); ++i) {
    if (is_degenerate(i)) return true;
  }
  return false;
}

void MeshBuilder::gather_faces() {
  const auto append = [](std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from,
                         std::size_t first, std::size_t end) {
    to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(first),
              from.begin() + static_cast<std::ptrdiff_t>(end));
  };
  std::vector<std::uint32_t> corners, normals, materials;
  std::vector<std::size_t> first_corner{0};
  for (Run& run : runs_) {
    const std::size_t first_face = first_corner.size() - 1;
    for (std::size_t i = run.first_face; i < run.end_face; ++i) {
      if (is_degenerate(i)) {
        ++mesh_.skipped.degenerate_faces;
        continue;
      }
      const std::size_t first = mesh_.first_corner[i], end = mesh_.first_corner[i + 1];
      append(corners, mesh_.corners, first, end);
      if (!mesh_.corner_normals.empty()) append(normals, mesh_.corner_normals, first, end);
      if (!mesh_.face_materials.empty()) materials.push_back(mesh_.face_materials[i]);
      first_corner.push_back(corners.size());
    }
    run = {run.object, first_face, first_corner.size() - 1};
  }
  mesh_.corners = std::move(corners);
  mesh_.corner_normals = std::move(normals);
  mesh_.face_materials = std::move(materials);
  mesh_.first_corner = std::move(first_corner);
}

void MeshBuilder::give_faces_materials() {
  if (!face_colours_.values().empty()) {
    std::vector<Rgba> colours = face_colours_.values();
    bring_to_unit_range(colours);
    mesh_.materials.clear();
    for (const Rgba& c : colours) mesh_.materials.push_back({Colour(c), false, c.a < 1.0});
  }
  mix_in_colours_of_vertices();
  for (const std::uint32_t m : mesh_.face_materials) {
    if (m == Mesh::kNoMaterial) continue;
    mesh_.skipped.textured_faces += mesh_.materials[m].textured ? 1 : 0;
    mesh_.skipped.transparent_faces += mesh_.materials[m].transparent ? 1 : 0;
  }
  const auto says_nothing = [](const Mesh::Material& m) { return m == Mesh::Material{}; };
  if (mesh_.face_materials.empty() || std::ranges::all_of(mesh_.materials, says_nothing)) {
    mesh_.materials = {};
    mesh_.face_materials = {};
  }
}

/// A face with a colour of its own keeps it.
void MeshBuilder::mix_in_colours_of_vertices() {
  if (vertex_colours_.empty()) return;
  bring_to_unit_range(vertex_colours_);
  vertex_colours_.resize(mesh_.vertices.size(), kNoColour);
  mesh_.face_materials.resize(mesh_.faces(), Mesh::kNoMaterial);
  const bool faces_have_colours = !face_colours_.values().empty();
  Palette<Mesh::Material> mixed;
  std::size_t varied = 0;
  for (std::size_t i = 0; i < mesh_.faces(); ++i) {
    std::uint32_t& index = mesh_.face_materials[i];
    const bool has_material = index != Mesh::kNoMaterial;
    Mesh::Material material = has_material ? mesh_.materials[index] : Mesh::Material{};
    const auto mean = has_material && faces_have_colours ? std::nullopt : mean_colour(i);
    if (mean) {
      varied += corners_differ_in_colour(i) ? 1 : 0;
      material.colour = material.colour.value_or(Colour(1.0)) * Colour(*mean);
      material.transparent |= mean->a < 1.0;
    }
    if (has_material || mean) index = mixed.number(material, hash_of(material));
  }
  mesh_.materials = std::move(mixed).take();
  warn_left_out(varied, "the different colours of {} face's corners: their mean is drawn",
                "the different colours of the corners of {} faces: their mean is drawn");
}

bool MeshBuilder::corners_differ_in_colour(std::size_t face) const {
  const Rgba* first = nullptr;
  for (const std::uint32_t corner : mesh_.face(face)) {
    const Rgba& colour = vertex_colours_[corner];
    if (colour == kNoColour) continue;
    if (first == nullptr) first = &colour;
    if (Colour(colour) != Colour(*first)) return true;
  }
  return false;
}

std::optional<Rgba> MeshBuilder::mean_colour(std::size_t face) const {
  std::optional<Rgba> first;
  Rgba from_first(0.0);  // so that the mean of equal colours is that colour
  double n = 0.0;
  for (const std::uint32_t corner : mesh_.face(face)) {
    const Rgba& colour = vertex_colours_[corner];
    if (colour == kNoColour) continue;
    if (!first) first = colour;
    from_first += colour - *first;
    ++n;
  }
  if (!first) return std::nullopt;
  return brought_into_range(*first + from_first / n);
}

void MeshBuilder::name_objects() {
  for (std::size_t i = 0; i < runs_.size();) {
    const std::size_t object = runs_[i].object, first_face = runs_[i].first_face;
    while (i < runs_.size() && runs_[i].object == object) ++i;
    const std::size_t faces = runs_[i - 1].end_face - first_face;
    if (faces > 0) mesh_.objects.push_back({names_[object], first_face, faces});
  }
}

}  // namespace displayfile
