#include "displayfile/mesh/import_library.h"

#include <assimp/GltfMaterial.h>
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "clip/base/error.h"
#include "clip/base/files.h"
#include "clip/base/shared_library.h"
#include "clip/geometry/bounds.h"
#include "clip/geometry/corners.h"
#include "clip/surfaces.h"
#include "displayfile/mesh/formats_beside_library.h"
#include "displayfile/mesh/import_library_files.h"
#include "displayfile/mesh/import_losses.h"
#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/neighbour_files.h"
#include "displayfile/mesh/skins.h"
#include "displayfile/mesh/up_axis.h"

namespace displayfile {

namespace {

// ---- The library -----------------------------------------------------------------------

/// The routines of Assimp's C interface that are used here.
struct ImportLibrary {
  SharedLibrary library{DISPLAYFILE_IMPORT_LIBRARY};
  decltype(&aiCreatePropertyStore) create_properties =
      library.function<decltype(&aiCreatePropertyStore)>("aiCreatePropertyStore");
  decltype(&aiSetImportPropertyInteger) set_property =
      library.function<decltype(&aiSetImportPropertyInteger)>("aiSetImportPropertyInteger");
  decltype(&aiReleasePropertyStore) release_properties =
      library.function<decltype(&aiReleasePropertyStore)>("aiReleasePropertyStore");
  decltype(&aiImportFileExWithProperties) import_file =
      library.function<decltype(&aiImportFileExWithProperties)>("aiImportFileExWithProperties");
  decltype(&aiReleaseImport) release =
      library.function<decltype(&aiReleaseImport)>("aiReleaseImport");
  decltype(&aiGetErrorString) error =
      library.function<decltype(&aiGetErrorString)>("aiGetErrorString");
  decltype(&aiIsExtensionSupported) supports =
      library.function<decltype(&aiIsExtensionSupported)>("aiIsExtensionSupported");
  decltype(&aiGetExtensionList) extensions =
      library.function<decltype(&aiGetExtensionList)>("aiGetExtensionList");
  decltype(&aiGetMaterialColor) colour =
      library.function<decltype(&aiGetMaterialColor)>("aiGetMaterialColor");
  decltype(&aiGetMaterialFloatArray) numbers =
      library.function<decltype(&aiGetMaterialFloatArray)>("aiGetMaterialFloatArray");
  decltype(&aiGetMaterialString) text =
      library.function<decltype(&aiGetMaterialString)>("aiGetMaterialString");
  decltype(&aiGetMaterialTextureCount) textures =
      library.function<decltype(&aiGetMaterialTextureCount)>("aiGetMaterialTextureCount");
  decltype(&aiGetVersionMajor) major =
      library.function<decltype(&aiGetVersionMajor)>("aiGetVersionMajor");
  decltype(&aiGetVersionMinor) minor =
      library.function<decltype(&aiGetVersionMinor)>("aiGetVersionMinor");
  decltype(&aiGetVersionPatch) patch =
      library.function<decltype(&aiGetVersionPatch)>("aiGetVersionPatch");

  /// The library, loaded on the first call. Throws Error if it cannot be loaded.
  static const ImportLibrary& get() {
    static const ImportLibrary loaded;
    return loaded;
  }
};

const ImportLibrary& library_for(const std::string& path) {
  try {
    return ImportLibrary::get();
  } catch (const Error& e) {
    throw Error(
        fmt::format("{}: the import library (Assimp) cannot be loaded: {}", path, e.what()));
  }
}

using Scene = std::unique_ptr<const aiScene, decltype(&aiReleaseImport)>;

Scene import_scene(const ImportLibrary& library, const std::string& path,
                   const ImportLosses& losses) {
  const std::unique_ptr<aiPropertyStore, decltype(&aiReleasePropertyStore)> properties(
      library.create_properties(), library.release_properties);
  library.set_property(properties.get(), AI_CONFIG_IMPORT_NO_SKELETON_MESHES, 1);
  const NeighbourFiles neighbours(path);
  const OpenFiles open_files{neighbours, losses.meant_names};
  aiFileIO files = files_among(open_files);
  // The library keeps the message of the last failure in one place for all threads.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  Scene scene(library.import_file(path.c_str(), 0, &files, properties.get()), library.release);
  // If there is a scene, the message is that of an earlier file.
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw Error(fmt::format("{}: not a mesh that can be read: {}", path,
                            scene == nullptr ? library.error() : "it is empty"));
  }
  return scene;
}

// ---- Its scene -------------------------------------------------------------------------

/// The nodes in the order of the file, parents first.
std::vector<MeshNode> nodes_in_order(const aiScene& scene) {
  std::vector<MeshNode> order, waiting{{scene.mRootNode, matrix(scene.mRootNode->mTransformation)}};
  while (!waiting.empty()) {
    const MeshNode next = waiting.back();
    waiting.pop_back();
    order.push_back(next);
    for (unsigned i = next.node->mNumChildren; i-- > 0;) {
      const aiNode* child = next.node->mChildren[i];
      if (child == nullptr) continue;  // the RAW importer leaves gaps
      waiting.push_back({child, next.to_world * matrix(child->mTransformation)});
    }
  }
  return order;
}

/// The up axis of the scene: the file's, after the root's transformation, by which
/// the library turns some files to y up. Nothing if the library does not report the file's axis.
std::optional<Upright> upright_of_file(const aiScene& scene) {
  std::int32_t axis = -1, sign = 1;
  if (scene.mMetaData == nullptr || !scene.mMetaData->Get("UpAxis", axis)) return std::nullopt;
  if (axis < 0 || axis > 2) return std::nullopt;
  scene.mMetaData->Get("UpAxisSign", sign);
  Point3 up(0.0);
  up[axis] = sign < 0 ? -1.0 : 1.0;
  return nearest_upright(glm::dmat3(matrix(scene.mRootNode->mTransformation)) * up);
}

/// Reads a material as the library reports it. Materials that the library makes up for faces
/// without any have no properties.
class MaterialReader {
 public:
  MaterialReader(const ImportLibrary& library, const aiMaterial& material)
      : library_(library), material_(material) {}

  Mesh::Material read() const {
    Mesh::Material read;
    if (text(AI_MATKEY_NAME) == AI_DEFAULT_MATERIAL_NAME) return read;
    const auto base = colour(AI_MATKEY_BASE_COLOR), diffuse = colour(AI_MATKEY_COLOR_DIFFUSE);
    if (const auto seen = base ? base : diffuse) read.colour = in_unit_range(*seen);
    const bool opaque = text(AI_MATKEY_GLTF_ALPHAMODE) == "OPAQUE";  // whatever the numbers are
    read.transparent = !opaque && (number(AI_MATKEY_OPACITY).value_or(1.0f) < 1.0f ||
                                   textures(aiTextureType_OPACITY) > 0);
    read.textured = textures(aiTextureType_DIFFUSE) + textures(aiTextureType_BASE_COLOR) > 0;
    // Programs that write a black diffuse colour beside a texture mean the texture alone.
    if (read.textured && !base && read.colour == Colour(0.0)) read.colour.reset();
    return read;
  }

 private:
  static std::optional<Colour> in_unit_range(const aiColor4D& c) {
    const Colour colour(c.r, c.g, c.b);
    if (!in_range(colour)) return std::nullopt;
    return brought_into_range(colour);
  }

  // A key is three arguments.
  std::optional<aiColor4D> colour(const char* key, unsigned type, unsigned index) const {
    aiColor4D c(0.0f, 0.0f, 0.0f, 1.0f);
    if (library_.colour(&material_, key, type, index, &c) != aiReturn_SUCCESS) return std::nullopt;
    return c;
  }
  std::optional<float> number(const char* key, unsigned type, unsigned index) const {
    float value = 0.0f;
    unsigned n = 1;
    const aiReturn found = library_.numbers(&material_, key, type, index, &value, &n);
    return found == aiReturn_SUCCESS && n == 1 ? std::optional(value) : std::nullopt;
  }
  std::string text(const char* key, unsigned type, unsigned index) const {
    aiString value;
    const aiReturn found = library_.text(&material_, key, type, index, &value);
    return found == aiReturn_SUCCESS ? value.C_Str() : "";
  }
  unsigned textures(aiTextureType type) const { return library_.textures(&material_, type); }

  const ImportLibrary& library_;
  const aiMaterial& material_;
};

/// Copies the scene's meshes into a Mesh, checking every number on the way.
class AssimpReader {
 public:
  AssimpReader(const std::string& path, bool with_normals)
      : path_(path), with_normals_(with_normals), mesh_(path) {
    mesh_.set_single_precision();
  }

  /// Must be called before any node is added.
  void add_materials(const ImportLibrary& library, const aiScene& scene) {
    std::vector<Mesh::Material> materials;
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
      materials.push_back(MaterialReader(library, *scene.mMaterials[i]).read());
    }
    // The library's readers report black where a file states no colour.
    const auto says_nothing = [](const Mesh::Material& material) {
      return material.colour.value_or(Colour(0.0)) == Colour(0.0);
    };
    const bool none_does = std::ranges::all_of(materials, says_nothing);
    for (Mesh::Material& material : materials) {
      if (none_does) material.colour.reset();
      mesh_.add_material(material);
    }
    materials_ = scene.mNumMaterials;
  }

  void add(const aiScene& scene, const MeshNode& node) {
    name_ = node.node->mName.C_Str();
    mesh_.begin_object(name_);
    for (unsigned i = 0; i < node.node->mNumMeshes; ++i) {
      const unsigned m = node.node->mMeshes[i];
      if (m >= scene.mNumMeshes) {
        fail(fmt::format("mesh {}: expected one of {}", m, scene.mNumMeshes));
      }
      add_part(*scene.mMeshes[m], node.to_world);
    }
  }

  /// Returns the mesh with these warnings, and one of lost detail, if any.
  Mesh take(std::vector<std::string> warnings) && {
    if (auto lost = lost_detail_.sentence()) warnings.push_back(std::move(*lost));
    for (const std::string& warning : warnings) mesh_.warn(warning);
    return std::move(mesh_).finish();
  }

 private:
  void add_part(const aiMesh& part, const glm::dmat4& to_world) {
    const auto first_vertex = static_cast<std::uint32_t>(mesh_.vertices());
    const auto first_normal = static_cast<std::uint32_t>(mesh_.normals());
    add_vertices(part, to_world);
    if (with_normals_) add_normals(part, glm::dmat3(to_world));
    mesh_.use_material(part.mMaterialIndex < materials_ ? part.mMaterialIndex : Mesh::kNoMaterial);
    const bool mirrored = glm::determinant(glm::dmat3(to_world)) < 0.0;
    std::vector<std::uint32_t> corners, normals;
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      corners.clear();
      normals.clear();
      for (const unsigned index : std::span(part.mFaces[i].mIndices, part.mFaces[i].mNumIndices)) {
        if (index >= part.mNumVertices) {
          fail(fmt::format("face {}: vertex index {} out of range: expected 0 to {}", i, index,
                           part.mNumVertices - 1.0));
        }
        corners.push_back(first_vertex + index);
        if (with_normals_) {
          normals.push_back(part.HasNormals() ? first_normal + index : Mesh::kNoNormal);
        }
      }
      note_lost_detail(part, part.mFaces[i]);
      if (mirrored) {
        std::ranges::reverse(corners);
        std::ranges::reverse(normals);
      }
      mesh_.add_face(corners, normals);
    }
  }

  /// False for zeros only, alpha included: some of the library's readers leave these where there
  /// are no colours.
  static bool says_colours(const aiMesh& part) {
    if (part.mColors[0] == nullptr) return false;
    return std::any_of(part.mColors[0], part.mColors[0] + part.mNumVertices, [](const auto& c) {
      return c.r != 0.0f || c.g != 0.0f || c.b != 0.0f || c.a != 0.0f;
    });
  }

  void add_vertices(const aiMesh& part, const glm::dmat4& to_world) {
    const bool moved = to_world != glm::dmat4(1.0);
    const bool coloured = says_colours(part);
    double largest = 0.0;
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& v = part.mVertices[i];
      Point3 p(v.x, v.y, v.z);
      largest = std::max(largest, largest_coordinate(p));
      if (moved) p = Point3(to_world * HomogeneousPoint(p, 1.0));
      if (!in_range(p)) {
        fail(fmt::format("vertex {} is ({}, {}, {}): expected finite coordinates", i, p.x, p.y,
                         p.z));
      }
      mesh_.add_vertex(p);
      if (coloured) add_colour(i, part.mColors[0][i]);
    }
    double longest = 0.0;  // column
    for (int k = 0; k < 3; ++k) longest = std::max(longest, glm::length(Point3(to_world[k])));
    mesh_.note_rounding(kUnitOfSingles * largest * longest);
  }

  /// The vertex's opacity is unknown: the library makes one up where the file has none.
  void add_colour(unsigned vertex, const aiColor4D& c) {
    const Rgba colour(c.r, c.g, c.b, kOpaque);
    if (!in_range(Point3(colour))) {
      fail(fmt::format("vertex {} has colour ({}, {}, {}): expected finite numbers", vertex, c.r,
                       c.g, c.b));
    }
    mesh_.add_vertex_colour(colour);
  }

  /// Uses coordinates before the node's transformation, which is in double precision here.
  void note_lost_detail(const aiMesh& part, const aiFace& face) {
    const auto corner = [&](unsigned k) {
      const aiVector3D& v = part.mVertices[face.mIndices[k]];
      return Point3(v.x, v.y, v.z);
    };
    if (face.mNumIndices < 3) return;
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      lost_detail_.add_edge(corner(k), corner(next_corner(k, face.mNumIndices)));
    }
  }

  /// Normals stay outward when the node's transformation mirrors, as the faces do.
  void add_normals(const aiMesh& part, const glm::dmat3& m) {
    if (!part.HasNormals()) return;
    const double outward = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& n = part.mNormals[i];
      mesh_.add_normal(outward * (cofactors * Point3(n.x, n.y, n.z)));
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("{}: object '{}': {}", path_, name_, what));
  }

  const std::string& path_;
  bool with_normals_;
  std::string name_;  // of the object that is read
  unsigned materials_ = 0;
  LostDetail lost_detail_;
  MeshBuilder mesh_;
};

/// `by_extension`: the library supports the extension of the file's name.
Mesh read_by(const ImportLibrary& library, const std::string& path, bool with_normals,
             bool by_extension) {
  const ForeignFormat format = foreign_format(path, by_extension);
  std::optional<Mesh> read_here;
  if (format == ForeignFormat::gltf) read_here = read_gltf(path, with_normals);
  if (format == ForeignFormat::three_mf) read_here = read_three_mf(path, library.library);
  if (read_here) return std::move(*read_here);
  ImportLosses losses;
  if (format == ForeignFormat::gltf) losses = losses_of_gltf(path);
  const Scene scene = import_scene(library, path, losses);
  AssimpReader reader(path, with_normals);
  reader.add_materials(library, *scene);
  const std::vector<MeshNode> nodes = nodes_in_order(*scene);
  for (const MeshNode& node : nodes) reader.add(*scene, node);
  losses.add(animations_that_move(*scene), "{} animation", "{} animations");
  losses.add(skins_that_move(*scene, nodes), "the skin of {} object", "the skins of {} objects");
  Mesh mesh = std::move(reader).take(std::move(losses.left_out));
  mesh.upright = upright_of_file(*scene);
  return mesh;
}

}  // namespace

/// A file with an unknown extension is read by the first reader that recognises its beginning. That
/// may be the wrong one: then its message is about another format.
Mesh read_by_import_library(const std::string& path, bool with_normals) {
  const ImportLibrary& library = library_for(path);
  const std::string extension = extension_of(path);
  if (!extension.empty() && library.supports(extension.c_str()) == AI_TRUE) {
    return read_by(library, path, with_normals, true);
  }
  try {
    return read_by(library, path, with_normals, false);
  } catch (const Error&) {
    throw Error(fmt::format(
        "{}: not a mesh that can be read: no reader takes {}", path,
        extension.empty() ? "it, and its name has no extension" : extension + " files"));
  }
}

void load_import_library(const std::string& path) { library_for(path); }

std::optional<std::string> import_library_version() {
  try {
    const ImportLibrary& library = ImportLibrary::get();
    return fmt::format("{}.{}.{}", library.major(), library.minor(), library.patch());
  } catch (const Error&) {
    return std::nullopt;
  }
}

std::vector<std::string> import_library_extensions() {
  std::vector<std::string> extensions;
  try {
    aiString list;  // "*.3ds;*.dae"
    ImportLibrary::get().extensions(&list);
    std::string_view rest(list.C_Str(), list.length);
    while (!rest.empty()) {
      const std::string_view pattern = rest.substr(0, rest.find(';'));
      rest.remove_prefix(std::min(pattern.size() + 1, rest.size()));
      if (pattern.starts_with("*.")) extensions.emplace_back(pattern.substr(1));
    }
  } catch (const Error&) {
  }
  return extensions;
}

}  // namespace displayfile
