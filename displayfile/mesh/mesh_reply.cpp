#include "displayfile/mesh/mesh_reply.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "clip/point.h"
#include "displayfile/mesh/import_protocol.h"
#include "displayfile/mesh/mesh_builder.h"
#include "displayfile/mesh/up_axis.h"

namespace displayfile {

namespace {

constexpr std::uint64_t kMesh = 0x3148534d46444449, kRefusal = 0x3152524546444449;

/// The beginning of a reply.
struct Beginning {
  std::uint64_t kind = kMesh;
  std::uint64_t message_bytes = 0;  ///< of the error message that follows
};

/// Follows the beginning of a mesh: the sizes of all that comes after, in this order.
struct Counts {
  std::uint64_t vertices = 0, normals = 0, corners = 0, faces = 0, corner_normals = 0;
  std::uint64_t face_materials = 0, materials = 0, objects = 0, warnings = 0, text_bytes = 0;
  std::uint64_t points_and_lines = 0, degenerate_faces = 0, textured_faces = 0;
  std::uint64_t transparent_faces = 0;
  std::uint64_t has_upright = 0;
  double rounding = 0.0;
  double up[3] = {0.0, 0.0, 0.0};
};

struct MaterialOnTheWay {
  double r = 0.0, g = 0.0, b = 0.0;
  std::uint64_t has_colour = 0, textured = 0, transparent = 0;
};

struct ObjectOnTheWay {
  std::uint64_t faces = 0, name_bytes = 0;
};

template <class Values>
void send(const Values& values, const ByteSink& sink) {
  sink(std::as_bytes(std::span(values)));
}

void require(bool holds, std::string_view what) {
  if (!holds) throw BadReply(std::string(what));
}

// ---- Receiving -------------------------------------------------------------------------

/// Memory is allocated as bytes arrive: twice as much as has arrived, or this much.
constexpr std::size_t kFirstBytes = std::size_t{1} << 16;

template <class Value>
Value receive_one(const ByteSource& source) {
  static_assert(std::is_trivially_copyable_v<Value>);
  Value value;
  source(std::as_writable_bytes(std::span(&value, 1)));
  return value;
}

/// Memory that the source does not fill is reserved but not touched, so it costs nothing.
template <class Values>
void receive(Values& values, std::uint64_t count, const ByteSource& source) {
  static_assert(std::is_trivially_copyable_v<typename Values::value_type>);
  values.reserve(static_cast<std::size_t>(count));
  while (values.size() < count) {
    const std::size_t had = values.size();
    const std::size_t more = std::max(had, kFirstBytes / sizeof(typename Values::value_type));
    values.resize(had + std::min<std::size_t>(more, static_cast<std::size_t>(count) - had));
    source(std::as_writable_bytes(std::span(values).subspan(had)));
  }
}

/// Bytes of everything the counts announce; nothing if that is more than `most`.
std::optional<std::uint64_t> bytes_of(const Counts& counts, std::uint64_t most) {
  const std::pair<std::uint64_t, std::size_t> parts[] = {
      {counts.vertices, sizeof(Point3)},
      {counts.normals, sizeof(Point3)},
      {counts.corners, sizeof(std::uint32_t)},
      {counts.faces, sizeof(std::size_t)},
      {counts.corner_normals, sizeof(std::uint32_t)},
      {counts.face_materials, sizeof(std::uint32_t)},
      {counts.materials, sizeof(MaterialOnTheWay)},
      {counts.objects, sizeof(ObjectOnTheWay)},
      {counts.warnings, sizeof(std::uint64_t)},
      {counts.text_bytes, 1}};
  std::uint64_t bytes = 0;
  for (const auto& [count, size] : parts) {
    if (count > (most - bytes) / size) return std::nullopt;
    bytes += count * size;
  }
  return bytes;
}

void require_finite(const std::vector<Point3>& points, std::string_view what) {
  require(std::ranges::all_of(points, [](const Point3& p) { return in_range(p); }), what);
}

void require_indices(const std::vector<std::uint32_t>& indices, std::size_t count,
                     std::uint32_t none, std::string_view what) {
  const bool all = std::ranges::all_of(
      indices, [&](std::uint32_t index) { return index < count || index == none; });
  require(all, what);
}

/// Requires faces that MeshBuilder could make: three or more corners, at three or more different
/// positions.
void require_faces(const Mesh& mesh) {
  require(mesh.first_corner.front() == 0 && mesh.first_corner.back() == mesh.corners.size(),
          "faces that do not match the corners");
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const std::size_t first = mesh.first_corner[i], end = mesh.first_corner[i + 1];
    require(first < end && end - first >= 3 && end <= mesh.corners.size(),
            "a face of fewer than three corners");
  }
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    require(has_three_positions(mesh.vertices, mesh.face(i)),
            "a face of fewer than three different positions");
  }
}

Mesh::Material received(const MaterialOnTheWay& m) {
  require(m.has_colour <= 1 && m.textured <= 1 && m.transparent <= 1, "a material out of range");
  Mesh::Material material{std::nullopt, m.textured == 1, m.transparent == 1};
  if (m.has_colour == 0) return material;
  for (const double part : {m.r, m.g, m.b}) {
    require(part >= 0.0 && part <= 1.0, "an invalid colour");
  }
  material.colour = Colour(m.r, m.g, m.b);
  return material;
}

/// Takes the texts, which are stored one after the other.
class Texts {
 public:
  explicit Texts(const std::string& all) : rest_(all) {}
  std::string next(std::uint64_t bytes) {
    require(bytes <= rest_.size(), "texts longer than announced");
    const std::string_view text = rest_.substr(0, static_cast<std::size_t>(bytes));
    rest_.remove_prefix(text.size());
    return std::string(text);
  }
  bool is_at_end() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

std::size_t faces_of(const std::vector<ObjectOnTheWay>& objects, std::size_t faces) {
  std::size_t of_objects = 0;
  for (const ObjectOnTheWay& object : objects) {
    require(object.faces >= 1 && object.faces <= faces - of_objects,
            "objects that are not those of the faces");
    of_objects += static_cast<std::size_t>(object.faces);
  }
  return of_objects;
}

Mesh receive_mesh(const ByteSource& source, std::size_t most_bytes) {
  const auto counts = receive_one<Counts>(source);
  require(bytes_of(counts, most_bytes).has_value(), "more than the limit of memory holds");
  require(counts.faces >= 1 && counts.vertices < std::numeric_limits<std::uint32_t>::max(),
          "no faces, or too many vertices");
  require(counts.corner_normals == 0 || counts.corner_normals == counts.corners,
          "normals that do not match the corners");
  require(counts.face_materials == 0 || counts.face_materials == counts.faces,
          "materials that do not match the faces");
  Mesh mesh;
  receive(mesh.vertices, counts.vertices, source);
  receive(mesh.normals, counts.normals, source);
  receive(mesh.corners, counts.corners, source);
  receive(mesh.first_corner, counts.faces + 1, source);
  receive(mesh.corner_normals, counts.corner_normals, source);
  receive(mesh.face_materials, counts.face_materials, source);
  std::vector<MaterialOnTheWay> materials;
  std::vector<ObjectOnTheWay> objects;
  std::vector<std::uint64_t> warnings;
  std::string text;
  receive(materials, counts.materials, source);
  receive(objects, counts.objects, source);
  receive(warnings, counts.warnings, source);
  receive(text, counts.text_bytes, source);

  require_finite(mesh.vertices, "a vertex that is not finite");
  require_finite(mesh.normals, "a normal that is not finite");
  require_indices(mesh.corners, mesh.vertices.size(), Mesh::kNoNormal, "a corner without a vertex");
  require(std::ranges::find(mesh.corners, Mesh::kNoNormal) == mesh.corners.end(),
          "a corner without a vertex");
  require_indices(mesh.corner_normals, mesh.normals.size(), Mesh::kNoNormal,
                  "a corner's normal out of range");
  require_indices(mesh.face_materials, materials.size(), Mesh::kNoMaterial,
                  "a face's material out of range");
  require_faces(mesh);
  for (const MaterialOnTheWay& m : materials) mesh.materials.push_back(received(m));
  require(faces_of(objects, mesh.faces()) == mesh.faces(),
          "objects that are not those of the faces");
  Texts texts(text);
  std::size_t first_face = 0;
  for (const ObjectOnTheWay& object : objects) {
    const auto faces = static_cast<std::size_t>(object.faces);
    mesh.objects.push_back({texts.next(object.name_bytes), first_face, faces});
    first_face += faces;
  }
  Mesh::Skipped& skipped = mesh.skipped;
  for (const std::uint64_t bytes : warnings) skipped.warnings.push_back(texts.next(bytes));
  require(texts.is_at_end(), "texts shorter than announced");
  require(counts.textured_faces <= counts.faces && counts.transparent_faces <= counts.faces,
          "more skipped faces than there are faces");
  skipped.points_and_lines = static_cast<std::size_t>(counts.points_and_lines);
  skipped.degenerate_faces = static_cast<std::size_t>(counts.degenerate_faces);
  skipped.textured_faces = static_cast<std::size_t>(counts.textured_faces);
  skipped.transparent_faces = static_cast<std::size_t>(counts.transparent_faces);
  require(counts.rounding >= 0.0 && counts.rounding <= kCoordinateLimit, "an invalid rounding");
  mesh.rounding = counts.rounding;
  if (counts.has_upright != 0) {
    const Point3 up(counts.up[0], counts.up[1], counts.up[2]);
    require(in_range(up), "a direction that is not finite");
    mesh.upright = nearest_upright(up);
  }
  return mesh;
}

}  // namespace

// ---- Sending ---------------------------------------------------------------------------

void send_mesh(const Mesh& mesh, const ByteSink& sink) {
  std::vector<MaterialOnTheWay> materials;
  for (const Mesh::Material& m : mesh.materials) {
    const Colour c = m.colour.value_or(Colour(0.0));
    materials.push_back(
        {c.r, c.g, c.b, m.colour ? 1u : 0u, m.textured ? 1u : 0u, m.transparent ? 1u : 0u});
  }
  std::vector<ObjectOnTheWay> objects;
  std::vector<std::uint64_t> warnings;
  std::string text;
  for (const Mesh::Object& object : mesh.objects) {
    objects.push_back({object.faces, object.name.size()});
    text += object.name;
  }
  for (const std::string& warning : mesh.skipped.warnings) {
    warnings.push_back(warning.size());
    text += warning;
  }
  Counts counts{.vertices = mesh.vertices.size(),
                .normals = mesh.normals.size(),
                .corners = mesh.corners.size(),
                .faces = mesh.faces(),
                .corner_normals = mesh.corner_normals.size(),
                .face_materials = mesh.face_materials.size(),
                .materials = materials.size(),
                .objects = objects.size(),
                .warnings = warnings.size(),
                .text_bytes = text.size(),
                .points_and_lines = mesh.skipped.points_and_lines,
                .degenerate_faces = mesh.skipped.degenerate_faces,
                .textured_faces = mesh.skipped.textured_faces,
                .transparent_faces = mesh.skipped.transparent_faces,
                .has_upright = mesh.upright ? 1u : 0u,
                .rounding = mesh.rounding};
  if (mesh.upright) {
    for (int k = 0; k < 3; ++k) counts.up[k] = mesh.upright->up[k];
  }
  const Beginning beginning{kMesh, 0};
  send(std::span(&beginning, 1), sink);
  send(std::span(&counts, 1), sink);
  send(mesh.vertices, sink);
  send(mesh.normals, sink);
  send(mesh.corners, sink);
  send(mesh.first_corner, sink);
  send(mesh.corner_normals, sink);
  send(mesh.face_materials, sink);
  send(materials, sink);
  send(objects, sink);
  send(warnings, sink);
  send(text, sink);
}

void send_refusal(std::string_view message, const ByteSink& sink) {
  const std::string_view sent = message.substr(0, kMostOfMessage);
  const Beginning beginning{kRefusal, sent.size()};
  send(std::span(&beginning, 1), sink);
  send(sent, sink);
}

std::variant<Mesh, std::string> receive_reply(const ByteSource& source, std::size_t most_bytes) {
  const auto beginning = receive_one<Beginning>(source);
  if (beginning.kind == kMesh) return receive_mesh(source, most_bytes);
  require(beginning.kind == kRefusal, "neither a mesh nor a message");
  require(beginning.message_bytes <= kMostOfMessage, "a message that is too long");
  std::string message;
  receive(message, beginning.message_bytes, source);
  return message;
}

}  // namespace displayfile
