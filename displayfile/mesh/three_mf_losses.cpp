// 3MF: 3MF Consortium, "3D Manufacturing Format, Core Specification & Reference Guide", 1.3.

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "clip/base/error.h"
#include "displayfile/mesh/import_losses.h"
#include "displayfile/mesh/xml_tags.h"
#include "displayfile/mesh/zip_archive.h"

namespace displayfile {

namespace {

/// Its only elements and attributes that matter here refer to other parts of the file: a model
/// without such references is read whole.
constexpr std::string_view kProduction =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

/// Elements of extensions that add to objects or stand in the place of their meshes.
constexpr std::pair<std::string_view, std::string_view> kOtherGeometry[] = {
    {"beamlattice", "beam lattice"},
    {"booleanshape", "Boolean shape"},
    {"displacementmesh", "displacement mesh"},
    {"levelset", "level set"}};

/// The name of the part that holds the model, without the slash before it; empty if there is none.
std::string model_part(const ZipArchive& archive) {
  constexpr std::string_view kModel =
      "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
  const std::string relationships = archive.content("_rels/.rels").value_or("");
  XmlTags tags(relationships);
  while (const XmlTag* tag = tags.next()) {
    if (tag->local_name() != "Relationship" || tag->value("Type") != kModel) continue;
    std::string_view target = tag->value("Target").value_or("");
    if (target.starts_with('/')) target.remove_prefix(1);
    return std::string(target);
  }
  return {};
}

/// What a triangle looks like: an entry of a group of materials, colours or others.
struct Property {
  std::string_view group, index;
  bool operator==(const Property&) const = default;
};

/// Goes through a model once.
class Model {
 public:
  Model(const std::string& path, std::string_view text) : path_(path) {
    XmlTags tags(text);
    while (const XmlTag* tag = tags.next()) {
      if (!has_root_) {
        begin(*tag);
      } else {
        note(*tag);
      }
    }
    end_object();
  }

  ImportLosses losses() const {
    require_read_extensions();
    ImportLosses losses;
    losses.add(varied_, "the colours of {} triangle that differ within an object",
               "the colours of {} triangles that differ within an object");
    for (const auto& [group, triangles] : by_group_) {
      losses.add(triangles, fmt::format("the colours of {{}} triangle ({})", group),
                 fmt::format("the colours of {{}} triangles ({})", group));
    }
    losses.add(elsewhere_, "{} component in another part of the file (the production extension)",
               "{} components in other parts of the file (the production extension)");
    for (const auto& [name, count] : other_geometry_) {
      losses.add(count, fmt::format("{{}} {}", name), fmt::format("{{}} {}s", name));
    }
    return losses;
  }

 private:
  void begin(const XmlTag& tag) {
    has_root_ = true;
    if (tag.name != "model") {
      throw Error(
          fmt::format("{}: not a mesh that can be read: 3MF: its model begins with '{}': "
                      "expected 'model', in UTF-8 and without a prefix",
                      path_, tag.name.substr(0, 20)));
    }
    for (const auto& [name, value] : tag.attributes) {
      constexpr std::string_view kNamespace = "xmlns:";
      if (name.starts_with(kNamespace)) namespaces_[name.substr(kNamespace.size())] = value;
    }
    required_ = tag.value("requiredextensions").value_or("");
  }

  void note(const XmlTag& tag) {
    const std::string_view name = tag.local_name();
    if (name == "triangle") return note_triangle(tag);
    if (name == "object") {
      end_object();
      own_ = {tag.value("pid").value_or(""), tag.value("pindex").value_or("")};
    } else if (name == "component" || name == "item") {
      elsewhere_ += names_other_part(tag) ? 1 : 0;
    } else if (name == "basematerials" || name == "colorgroup" || name == "texture2dgroup" ||
               name == "compositematerials" || name == "multiproperties") {
      groups_[tag.value("id").value_or("")] = name;
    }
    for (const auto& [element, words] : kOtherGeometry) {
      if (name == element) ++other_geometry_[words];
    }
  }

  static bool names_other_part(const XmlTag& tag) {
    return std::ranges::any_of(tag.attributes,
                               [](const auto& a) { return a.first.ends_with(":path"); });
  }

  void note_triangle(const XmlTag& tag) {
    const auto group = tag.value("pid"), index = tag.value("p1");
    const Property property{group.value_or(own_.group), index.value_or(own_.index)};
    if (triangles_++ == 0) first_ = property;
    // The library takes no index of a triangle without its group.
    varies_ |= property != first_ || (!group && property != own_);
    for (const char* other : {"p2", "p3"}) {
      varies_ |= tag.value(other).value_or(property.index) != property.index;
    }
  }

  void end_object() {
    const std::size_t triangles = std::exchange(triangles_, 0);
    if (std::exchange(varies_, false)) {
      varied_ += triangles;
    } else if (triangles > 0 && !first_.group.empty()) {
      const auto group = groups_.find(first_.group);
      const std::string_view name = group == groups_.end() ? "unknown" : group->second;
      if (name != "basematerials") by_group_[name] += triangles;
    }
  }

  void require_read_extensions() const {
    for (std::string_view rest = required_; !rest.empty();) {
      constexpr std::string_view kBlanks = " \t\r\n";
      rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
      const std::string_view prefix = rest.substr(0, rest.find_first_of(kBlanks));
      rest.remove_prefix(prefix.size());
      if (prefix.empty()) return;
      const auto found = namespaces_.find(prefix);
      const std::string_view extension = found == namespaces_.end() ? prefix : found->second;
      if (extension == kProduction && elsewhere_ == 0) continue;
      throw Error(
          fmt::format("{}: requires the 3MF extension {}, which is not read", path_, extension));
    }
  }

  const std::string& path_;
  bool has_root_ = false;
  std::string_view required_;                                // prefixes of extensions
  std::map<std::string_view, std::string_view> namespaces_;  // by prefix
  std::map<std::string_view, std::string_view> groups_;      // the element of each identifier
  std::size_t varied_ = 0, elsewhere_ = 0;
  std::map<std::string_view, std::size_t> by_group_, other_geometry_;
  // These belong to the object that is being read.
  Property own_, first_;
  std::size_t triangles_ = 0;
  bool varies_ = false;
};

}  // namespace

ImportLosses losses_of_3mf(const std::string& path, const SharedLibrary& library) {
  const ZipArchive archive(library, path);
  const std::string part = model_part(archive);
  if (part.empty()) return {};
  const auto text = archive.content(part);
  if (!text) {
    throw Error(
        fmt::format("{}: not a mesh that can be read: 3MF: its model {} is not in it", path, part));
  }
  return Model(path, *text).losses();
}

}  // namespace displayfile
