#pragma once

/// Meshes: read from files, viewed by a camera, and entered as segments.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "clip/point.h"
#include "displayfile/looks/style.h"

namespace displayfile {

class GraphicsSystem;

// Options.

/// The orientation of a scene: three perpendicular directions, right x up = front. A scene whose up
/// axis is not y is viewed as if it had been rotated to y-up.
struct Upright {
  Point3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0};
  Point3 front{0.0, 0.0, 1.0};  ///< toward a viewer in front of it
  bool operator==(const Upright&) const = default;
};

/// Reads the axis that is up, `x`, `y`, `z`, `-x`, `-y` or `-z`. With z up, the front is the side
/// of negative y and x points right. Throws Error for anything else.
Upright upright(std::string_view axis);

/// How the up axis is found if the application does not set it. If meshes disagree, y is up.
enum class UprightBy {
  file,        ///< from the file or its format's specification (up_axis.h); y if neither states it
  convention,  ///< as `file`, and otherwise by the convention of the format
};

/// Direction from the target to the eye, in degrees: azimuth 0 is from the front and 90 from the
/// right, elevation 90 from above.
struct EyeDirection {
  double azimuth = 30.0, elevation = 20.0;
  bool operator==(const EyeDirection&) const = default;
};

/// The camera that views a mesh, in world coordinates. Lengths and directions that are not set are
/// computed from the mesh.
struct Camera {
  std::variant<EyeDirection, Point3> eye = EyeDirection{};  ///< a direction, or the eye's position
  /// The point in the middle of the picture; if not set, the middle of the visible scene.
  std::optional<Point3> look_at = std::nullopt;
  std::variant<UprightBy, Upright> upright = UprightBy::file;
  /// Vertical angle of view in degrees, more than 0 and less than 180. If not set, the eye is four
  /// times the mesh's radius away.
  std::optional<double> angle_of_view = std::nullopt;
  bool parallel = false;  ///< parallel projection; the angle of view is then unused
  /// Fits the window, or the eye's distance if an angle of view is set, so that the whole mesh is
  /// visible. If false, the view is that of a ball of radius 1 at the origin or at look_at,
  /// whatever the mesh.
  bool fit = true;
  /// Fits the eye's distance for a mesh that rotates about the up axis through its middle.
  bool turning = false;
  bool operator==(const Camera&) const = default;
};

/// Limits of the import library for one mesh. The library runs in a process of its own
/// (import_process.md), as glTF and 3MF do; OBJ, OFF, PLY and STL are read in this process without
/// these limits.
struct ImportLimits {
  std::size_t memory = std::size_t{2} << 30;  ///< bytes, beyond what the library itself uses
  double seconds = 60.0;                      ///< of elapsed time
  /// On systems without such a process: also reads formats whose readers are not on the list of
  /// allowed ones (allowed_formats.h). No effect elsewhere.
  bool any_format = false;
  /// STEP and IGES: the largest distance of a facet from its curved surface, in the file's units;
  /// 0: 1/2,500 of the diagonal of the scene's bounding box.
  double deflection = 0.0;
};

/// How meshes are entered, where that differs from their files.
struct MeshOptions {
  Camera camera;                   ///< of the fitted view
  std::optional<Colour> colour{};  ///< of all faces, overriding files and programs
  bool file_colours = true;        ///< use the face colours of files
  /// Draws the sides of faces unless the application has set a line style: for methods that show
  /// lines only, and where lines are selected.
  bool sides_drawn = false;
  bool hidden_sides_drawn = false;  ///< also draws hidden sides dashed; no back faces are removed
  ImportLimits import_limits{};     ///< for formats that the import library reads
};

// Meshes.

/// A mesh in plain arrays, in world coordinates. Faces are polygons of 3 or more sides and share
/// vertices as in the file: nothing is triangulated and no vertices are merged.
struct Mesh {
  static constexpr std::uint32_t kNoNormal = 0xFFFFFFFFu;
  static constexpr std::uint32_t kNoMaterial = 0xFFFFFFFFu;

  struct Object {
    std::string name;  ///< from read_mesh its own, or that of the file
    std::size_t first_face, faces;
  };
  /// The material of faces, as far as it is drawn.
  struct Material {
    std::optional<Colour> colour;  ///< none: not in the file
    bool textured = false;         ///< drawn in the colour, without the texture
    bool transparent = false;      ///< drawn opaque
    bool operator==(const Material&) const = default;
  };
  /// Contents of a file that are not in the mesh.
  struct Skipped {
    std::size_t points_and_lines = 0;
    std::size_t degenerate_faces = 0;   ///< with fewer than 3 distinct positions
    std::size_t textured_faces = 0;     ///< drawn without their textures
    std::size_t transparent_faces = 0;  ///< drawn opaque
    std::vector<std::string> warnings;  ///< other losses, one sentence each
  };

  /// The up axis by the file or its format's specification; none if neither states it.
  std::optional<Upright> upright{};
  std::optional<Upright> usual_upright{};  ///< by the format's convention, if neither states it
  std::vector<Object> objects;             ///< in the order of the faces; none is empty
  std::vector<Point3> vertices;            ///< including unused ones
  /// The largest rounding error of a coordinate in the file (entered_reach); 0: that of doubles.
  double rounding = 0.0;
  std::vector<Point3> normals;            ///< of any length; zero: unknown
  std::vector<std::uint32_t> corners;     ///< indices into vertices, face after face
  std::vector<std::size_t> first_corner;  ///< per face; one extra entry at the end
  /// Indices into normals, or kNoNormal, one per corner; or empty.
  std::vector<std::uint32_t> corner_normals;
  std::vector<Material> materials;
  /// Indices into materials, or kNoMaterial, one per face; or empty.
  std::vector<std::uint32_t> face_materials;
  Skipped skipped;

  /// Sets entered_reach to `reach`, for a mesh made from other inputs; values below that of doubles
  /// have no effect.
  void set_reach(double reach);
  std::size_t faces() const { return first_corner.empty() ? 0 : first_corner.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t i) const {
    return std::span(corners).subspan(first_corner[i], first_corner[i + 1] - first_corner[i]);
  }
  /// The face's colour in the file, if any.
  std::optional<Colour> colour(std::size_t face) const {
    if (face_materials.empty() || face_materials[face] == kNoMaterial) return std::nullopt;
    return materials[face_materials[face]].colour;
  }
  /// The surface normal at a corner, zero if unknown. Requires corner_normals.
  Point3 normal(std::size_t corner) const {
    const std::uint32_t n = corner_normals[corner];
    return n == kNoNormal ? Point3(0.0) : normals[n];
  }
};

/// Descriptions of the skipped contents, such as "3 points and lines", one per kind that occurred.
std::vector<std::string> left_out(const Mesh::Skipped& skipped);

/// Reads a mesh: OBJ, OFF, PLY and STL, also compressed, in the precision of the file; glTF 2.0 and
/// 3MF in that of the file, STEP and IGES through OpenCASCADE, and any other format through the
/// import library, in a separate process (import_process.h); formats.md lists the supported
/// contents of each format. An object is an OBJ
/// object or group, a solid of an STL text, a node of the library's scene, or otherwise the whole
/// file. Throws Error with the file and, where known, line and column: unreadable; unknown format;
/// truncated; an index out of range; a coordinate that is not finite or exceeds single precision;
/// more elements announced than the file can hold; no faces; the import library crashed or exceeded
/// its limits of time or memory.
///
/// Vertex normals are read only if with_normals is true, and never from STL files, whose normals
/// are per facet.
Mesh read_mesh(const std::string& path, bool with_normals = false, const ImportLimits& limits = {});

/// Sets missing corner normals to the mean of the normals of the faces around the vertex, weighted
/// by their angles there; vertices within entered_reach of each other count as one. With an angle
/// of less than 180 degrees, only faces count that are connected around the vertex by sides at
/// which they meet at no more than it (displayfile/looks/gouraud.md). Normals that cannot be
/// computed, and those of the face itself, stay zero. Throws Error for an angle that is not 0 to
/// 180. Thürmer and Wüthrich, "Computing vertex normals from polygonal facets", J. Graphics Tools 3
/// (1998).
void complete_normals(Mesh& mesh, double crease_degrees = 180.0);
/// The same with the system's crease angle. If the application has set one, and the mesh has all
/// normals, mesh.skipped says that it has no effect.
void complete_normals(Mesh& mesh, const GraphicsSystem& system);

/// True if the mesh bounds solids with its light faces outward: in each object, or in all objects
/// together, every edge is used exactly twice, once in each direction (vertices with equal
/// positions are the same), and every connected part encloses a positive volume.
bool closed_and_consistently_oriented(const Mesh& mesh);

/// The distance within which parts of the mesh touch unless one is set (clip/surfaces.h): 8 times
/// the unit of the file's numbers. The unit is 2^-24 of the largest coordinate in single precision;
/// half a unit of the last digit, at most 2^-17, for decimals whose longest has 6 or more
/// significant digits; otherwise 2^-52.
double entered_reach(const Mesh& mesh);

/// Enters each object as a segment, named from first_segment_name up, in the view and styles in
/// force. Outward faces stay outward under mirroring modelling transformations. A face is filled in
/// the options' colour, or its own if it has one; the fill style in force is unchanged. Where
/// touching is automatic, the segments use the mesh's entered_reach. Vertex normals, if any, are
/// set for each face. Object names are recorded as comments. Throws Error, before anything is
/// entered, if a segment is open, a name is in use, or the colour is outside of [0,1].
void enter_mesh(const Mesh& mesh, GraphicsSystem& system, int first_segment_name,
                const MeshOptions& options = {});

/// Enters meshes in the view in force, in segments named from the first number above all names in
/// use. Settings made by the application hold; the defaults for meshes are a light over the
/// viewer's left shoulder, a neutral fill style, no lines, and hidden-line removal, with back-face
/// removal for meshes that are closed_and_consistently_oriented. Light and hidden-line removal stay
/// set; styles are restored. Throws Error if a segment is open.
void enter_meshes(std::span<const Mesh> meshes, GraphicsSystem& system,
                  const MeshOptions& options = {});

/// The number of objects of the mesh that a cutting plane cuts, with cut faces to be closed, and
/// that stay open, as they are not closed. The transformation and planes in force are those with
/// which it was entered; where segments are placed apart, none are counted.
std::size_t objects_cut_open(const Mesh& mesh, const GraphicsSystem& system);

/// The direction of the default light for meshes in the view in force, over the viewer's left
/// shoulder, as it is passed to set_light: of any length.
Point3 mesh_light(const GraphicsSystem& system);

/// Calls enter() with the light, fill style and line style that meshes have by default, where the
/// application has set none. Styles are restored; the light stays set.
void with_mesh_looks(GraphicsSystem& system, const MeshOptions& options,
                     const std::function<void()>& enter);

/// Opens and closes the segments that enter_meshes would use for the mesh, empty, for programs that
/// refer to them by name. Throws Error as open_segment does.
void enter_empty_segments(const Mesh& mesh, GraphicsSystem& system);

/// The result of an import of meshes.
struct ImportedMeshes {
  std::vector<Mesh::Skipped> skipped;  ///< per mesh
  /// The orientation used by the fitted view; none if no view was fitted.
  std::optional<Upright> fitted;
};

/// Reads meshes and enters them by enter_meshes; with smooth shading in force, with vertex normals
/// from the file or computed. If no window was set before, a view is fitted to the meshes
/// (fitted_view.h) and stays set: with the modelling transformation in force and the system's
/// aspect ratio, or the one passed, which then becomes the system's.
///
/// A face is filled in the first that exists of: the options' colour; the fill style set by the
/// application; its colour in the file; the neutral colour.
///
/// Throws Error as read_mesh and fit_view do, or if a segment is open, the aspect ratio is not
/// positive or the colour is outside of [0,1]; the system is then unchanged.
ImportedMeshes import_meshes(std::span<const std::string> paths, GraphicsSystem& system,
                             const MeshOptions& options = {});
ImportedMeshes import_meshes(std::span<const std::string> paths, GraphicsSystem& system,
                             double aspect);
/// The same for one mesh. Returns what was skipped.
Mesh::Skipped import_mesh(const std::string& path, GraphicsSystem& system,
                          const MeshOptions& options = {});
Mesh::Skipped import_mesh(const std::string& path, GraphicsSystem& system, double aspect);

}  // namespace displayfile
