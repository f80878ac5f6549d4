#include "displayfile/mesh/three_mf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "displayfile/mesh/text_cursor.h"

namespace displayfile {

namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";

/// Extensions whose elements are read.
constexpr std::string_view kNamespacesRead[] = {
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"};

/// Elements of extensions that add to objects or replace their meshes.
constexpr std::pair<std::string_view, std::string_view> kOtherGeometry[] = {
    {"beamlattice", "beam lattice"},
    {"booleanshape", "Boolean shape"},
    {"displacementmesh", "displacement mesh"},
    {"levelset", "level set"},
    {"slicestack", "slice stack"}};

constexpr std::pair<std::string_view, double> kMillimetres[] = {
    {"micron", 0.001}, {"millimeter", 1.0}, {"centimeter", 10.0},
    {"inch", 25.4},    {"foot", 304.8},     {"meter", 1000.0}};

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("not a mesh that can be read: 3MF: " + what);
}

/// A value as messages show it.
std::string in_quotes(std::string_view value) {
  constexpr std::size_t kMost = 20;
  return fmt::format("'{}{}'", value.substr(0, kMost), value.size() > kMost ? "..." : "");
}

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kXmlBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kXmlBlanks) + 1);
}

/// The words of a list separated by blanks.
std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = without_blanks(text); !text.empty(); text = without_blanks(text)) {
    words.push_back(text.substr(0, text.find_first_of(kXmlBlanks)));
    text.remove_prefix(words.back().size());
  }
  return words;
}

double real(std::string_view text, std::string_view what) {
  const auto value = number<double>(without_blanks(text));
  if (!value || !(std::abs(*value) <= kLargestCoordinate)) {
    fail(fmt::format("{} {}: expected a finite number", what, in_quotes(text)));
  }
  return *value;
}

std::string_view required(const XmlTag& tag, std::string_view name) {
  const auto value = tag.value(name);
  if (!value) fail(fmt::format("{} without {}", tag.local_name(), name));
  return *value;
}

std::size_t index(std::string_view text, std::size_t end, std::string_view what) {
  const auto value = number<std::uint64_t>(without_blanks(text));
  if (!value || *value >= end) {
    fail(fmt::format("{} {} out of range: expected less than {}", what, in_quotes(text), end));
  }
  return static_cast<std::size_t>(*value);
}

/// Text with XML entities replaced, for the names of objects.
std::string without_entities(std::string_view text) {
  constexpr std::pair<std::string_view, char> kEntities[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
  std::string result;
  while (!text.empty()) {
    const auto* entity =
        std::ranges::find_if(kEntities, [&](const auto& e) { return text.starts_with(e.first); });
    const bool is_entity = entity != std::end(kEntities);
    result += is_entity ? entity->second : text.front();
    text.remove_prefix(is_entity ? entity->first.size() : 1);
  }
  return result;
}

/// The material of a colour #RRGGBB or #RRGGBBAA.
Mesh::Material coloured(std::string_view colour) {
  colour = without_blanks(colour);
  const bool is_whole = colour.starts_with('#') && (colour.size() == 7 || colour.size() == 9);
  std::uint32_t bits = 0;
  const char* const end = colour.data() + colour.size();
  const auto parsed = std::from_chars(is_whole ? colour.data() + 1 : end, end, bits, 16);
  if (!is_whole || parsed.ec != std::errc() || parsed.ptr != end) {
    fail(fmt::format("colour {}: expected #RRGGBB or #RRGGBBAA", in_quotes(colour)));
  }
  const bool has_opacity = colour.size() == 9;
  const std::uint32_t rgb = has_opacity ? bits >> 8 : bits;
  const bool is_transparent = has_opacity && (bits & 0xFF) < 0xFF;
  return {Colour(rgb >> 16, rgb >> 8 & 0xFF, rgb & 0xFF) / 255.0, false, is_transparent};
}

/// Reads twelve numbers, rows of a matrix that is multiplied by points as row vectors.
glm::dmat4 transformation_of(const XmlTag& tag) {
  glm::dmat4 m(1.0);
  const auto text = tag.value("transform");
  if (!text) return m;
  const auto words = words_of(*text);
  if (words.size() != 12) fail(fmt::format("transform {}: expected 12 numbers", in_quotes(*text)));
  for (int i = 0; i < 12; ++i) {
    m[i / 3][i % 3] = real(words[static_cast<std::size_t>(i)], "transform");
  }
  return m;
}

class ModelReader {
 public:
  ModelReader(std::string_view text, MeshBuilder& mesh, ThreeMfFindings& findings)
      : tags_(text), mesh_(mesh), findings_(findings) {}

  ThreeMfModel read() && {
    const XmlTag* root = tags_.next();
    if (root == nullptr || root->local_name() != "model") {
      fail(fmt::format("its model begins with {}: expected 'model', in UTF-8",
                       in_quotes(root == nullptr ? "" : root->name)));
    }
    begin(*root);
    while (const XmlTag* tag = tags_.next()) read(*tag);
    if (!tags_.all_closed()) fail("its model ends early: expected </model>");
    return std::move(model_);
  }

 private:
  struct Property {
    const std::vector<std::uint32_t>* group;  ///< none if null
    std::size_t index;
  };

  void begin(const XmlTag& root) {
    const std::string_view unit = root.value("unit").value_or("millimeter");
    const auto* found =
        std::ranges::find(kMillimetres, unit, [](const auto& u) { return u.first; });
    if (found == std::end(kMillimetres)) fail(fmt::format("unit {}: unknown", in_quotes(unit)));
    model_.millimetres = found->second;
    model_.unit = unit;
    for (const std::string_view prefix : words_of(root.value("requiredextensions").value_or(""))) {
      std::string_view extension = prefix;
      for (const auto& [name, value] : root.attributes) {
        if (name.starts_with("xmlns:") && name.substr(6) == prefix) extension = value;
      }
      if (std::ranges::find(kNamespacesRead, extension) != std::end(kNamespacesRead)) continue;
      throw std::runtime_error(
          fmt::format("requires the 3MF extension {}, which is not read", extension));
    }
  }

  void read(const XmlTag& tag) {
    const std::string_view name = tag.local_name();
    if (name == "vertex") {
      add_vertex(tag);
    } else if (name == "triangle") {
      add_triangle(tag);
    } else if (name == "object") {
      begin_object(tag);
    } else if (name == "component") {
      if (object_ != nullptr) object_->components.push_back(placement_of(tag));
    } else if (name == "item") {
      model_.build.push_back(placement_of(tag));
    } else {
      read_property(tag, name);
    }
    for (const auto& [element, words] : kOtherGeometry) {
      if (name == element) ++findings_.other_geometry[words];
    }
  }

  void read_property(const XmlTag& tag, std::string_view name) {
    if (name == "basematerials" || name == "colorgroup" || name == "texture2dgroup" ||
        name == "compositematerials" || name == "multiproperties") {
      const std::string id(required(tag, "id"));
      group_ = &groups_[id];
      if (name == "multiproperties") layered_.push_back(group_);
      if (name == "compositematerials") mixed_ = group_of(required(tag, "matid"));
      if (name == "compositematerials") mixed_indices_ = tag.value("matindices").value_or("");
      if (name == "multiproperties") mixed_ = group_of(first_word(required(tag, "pids")));
    } else if (group_ == nullptr) {
      return;
    } else if (name == "base") {
      const auto colour = tag.value("displaycolor");
      add_to_group(colour ? coloured(*colour) : Mesh::Material{});
    } else if (name == "color") {
      add_to_group(coloured(required(tag, "color")));
    } else if (name == "tex2coord") {
      if (group_->empty()) {
        add_to_group({std::nullopt, true, false});
      } else {
        group_->push_back(group_->front());
      }
    } else if (name == "composite") {
      add_to_group(mixed_material(words_of(required(tag, "values"))));
    } else if (name == "multi") {
      const auto first = first_word(required(tag, "pindices"));
      const bool is_known = mixed_ != nullptr && !mixed_->empty();
      group_->push_back(is_known ? (*mixed_)[index(first, mixed_->size(), "pindices")]
                                 : Mesh::kNoMaterial);
    }
  }

  static std::string_view first_word(std::string_view list) {
    const auto words = words_of(list);
    return words.empty() ? std::string_view() : words.front();
  }

  void add_to_group(const Mesh::Material& material) {
    group_->push_back(mesh_.add_material(material));
    materials_.emplace(group_->back(), material);
  }

  /// The mean of the base materials, weighted by these values.
  Mesh::Material mixed_material(const std::vector<std::string_view>& values) const {
    const auto indices = words_of(mixed_indices_);
    Colour sum(0.0);
    double weights = 0.0;
    for (std::size_t i = 0; i < std::min(values.size(), indices.size()); ++i) {
      if (mixed_ == nullptr) continue;
      const auto part = materials_.find((*mixed_)[index(indices[i], mixed_->size(), "matindices")]);
      const double weight = real(values[i], "values");
      if (part == materials_.end() || !part->second.colour || !(weight > 0.0)) continue;
      sum += weight * *part->second.colour;
      weights += weight;
    }
    if (weights == 0.0) return {};
    return {brought_into_range(sum / weights), false, false};
  }

  const std::vector<std::uint32_t>* group_of(std::string_view id) const {
    const auto found = groups_.find(id);
    return found == groups_.end() ? nullptr : &found->second;
  }

  void begin_object(const XmlTag& tag) {
    group_ = nullptr;
    const std::string id(required(tag, "id"));
    const auto [object, is_new] = model_.objects.try_emplace(id);
    if (!is_new) fail(fmt::format("object {} is defined twice", in_quotes(id)));
    object_ = &object->second;
    object_->name = without_entities(tag.value("name").value_or(""));
    own_group_ = tag.value("pid").value_or("");
    own_index_ = tag.value("pindex").value_or("0");
  }

  static ThreeMfPlacement placement_of(const XmlTag& tag) {
    ThreeMfPlacement placement{{}, std::string(required(tag, "objectid")), transformation_of(tag)};
    for (const auto& [name, value] : tag.attributes) {
      if (!name.ends_with(":path")) continue;
      placement.part = value.substr(value.starts_with('/') ? 1 : 0);
    }
    return placement;
  }

  void add_vertex(const XmlTag& tag) {
    if (object_ == nullptr) return;
    Point3 p(0.0);
    constexpr std::string_view kAxes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view value = required(tag, kAxes[axis]);
      p[axis] = real(value, kAxes[axis]);
      findings_.digits.see(without_blanks(value));
    }
    object_->vertices.push_back(p);
  }

  void add_triangle(const XmlTag& tag) {
    if (object_ == nullptr) return;
    const std::size_t end = object_->vertices.size();
    const auto corner = [&](std::string_view name) {
      return static_cast<std::uint32_t>(index(required(tag, name), end, "vertex index"));
    };
    object_->triangles.push_back({{corner("v1"), corner("v2"), corner("v3")}, material_of(tag)});
  }

  /// The triangle's own property, or otherwise the object's.
  std::uint32_t material_of(const XmlTag& triangle) {
    const std::string_view id = triangle.value("pid").value_or(own_group_);
    if (id.empty()) return Mesh::kNoMaterial;
    const std::vector<std::uint32_t>* group = group_of(id);
    if (group == nullptr) {
      ++findings_.unknown;
      return Mesh::kNoMaterial;
    }
    const auto first = triangle.value("p1");
    const std::string_view one = first.value_or(own_index_);
    std::array<std::uint32_t, 3> of_corners{};
    constexpr std::string_view kNames[] = {"p1", "p2", "p3"};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto value = first ? triangle.value(kNames[k]).value_or(one) : one;
      of_corners[k] = (*group)[displayfile::index(value, group->size(), "property index")];
    }
    if (std::ranges::find(layered_, group) != layered_.end()) ++findings_.layered;
    return mean_of(of_corners);
  }

  std::uint32_t mean_of(const std::array<std::uint32_t, 3>& of_corners) {
    if (of_corners[1] == of_corners[0] && of_corners[2] == of_corners[0]) return of_corners[0];
    const auto known = means_.find(of_corners);
    if (known != means_.end()) {
      findings_.varied += known->second.varies ? 1 : 0;
      return known->second.material;
    }
    Mean mean{};
    Mesh::Material material;
    std::optional<Colour> first;
    Colour from_first(0.0);  // so that the mean of equal colours is that colour
    double n = 0.0;
    for (const std::uint32_t m : of_corners) {
      const auto found = materials_.find(m);
      if (found == materials_.end()) continue;
      material.textured |= found->second.textured;
      material.transparent |= found->second.transparent;
      if (!found->second.colour) continue;
      if (!first) first = found->second.colour;
      from_first += *found->second.colour - *first;
      ++n;
      mean.varies |= *found->second.colour != *first;
    }
    if (first) material.colour = brought_into_range(*first + from_first / n);
    mean.material = mesh_.add_material(material);
    findings_.varied += mean.varies ? 1 : 0;
    means_.emplace(of_corners, mean);
    return mean.material;
  }

  struct Mean {
    std::uint32_t material;
    bool varies;
  };

  XmlTags tags_;
  MeshBuilder& mesh_;
  ThreeMfFindings& findings_;
  ThreeMfModel model_;
  // Materials of the builder: those of each group, their contents, and means of three.
  std::map<std::string, std::vector<std::uint32_t>, std::less<>> groups_;
  std::map<std::uint32_t, Mesh::Material> materials_;
  std::map<std::array<std::uint32_t, 3>, Mean> means_;
  std::vector<const std::vector<std::uint32_t>*> layered_;  // groups of several properties
  // State of the element being read:
  std::vector<std::uint32_t>* group_ = nullptr;
  const std::vector<std::uint32_t>* mixed_ = nullptr;  // the materials mixed in the group's entries
  std::string mixed_indices_;
  ThreeMfObject* object_ = nullptr;
  std::string own_group_, own_index_;  // of the object
};

}  // namespace

ThreeMfModel read_three_mf_model(std::string_view text, MeshBuilder& mesh,
                                 ThreeMfFindings& findings) {
  return ModelReader(text, mesh, findings).read();
}

}  // namespace displayfile
