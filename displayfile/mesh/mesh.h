#pragma once

/// Meshes: read from files, looked at by a camera, and entered as segments.

#include <cstddef>
#include <cstdint>
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

/// Which way is up in the world: three directions at right angles, right x up = front. A scene
/// whose up is another axis than y is seen as if it were turned to y-up.
struct Upright {
  Point3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0};
  Point3 front{0.0, 0.0, 1.0};  ///< toward a viewer who stands before it
  bool operator==(const Upright&) const = default;
};

/// Reads `x`, `y`, `z`, `-x`, `-y` or `-z`, the axis that is up. With z up the front is the side of
/// negative y, and x still runs to the right. Throws Error for anything else.
Upright upright(std::string_view axis);

/// By what the axis that is up is found, if the application does not set it. Of meshes that stand
/// by different axes none is followed: then y is up.
enum class UprightBy {
  file,        ///< the file, or what its format lays down (up_axis.h); y where neither says it
  convention,  ///< or else the custom of its format
};

/// From what is looked at to the eye, in degrees: azimuth 0 is from the front and 90 from the
/// right, elevation 90 from above.
struct EyeDirection {
  double azimuth = 30.0, elevation = 20.0;
  bool operator==(const EyeDirection&) const = default;
};

/// How a mesh is looked at, in the coordinates of the world. Lengths and directions that are not
/// given are found from the mesh.
struct Camera {
  std::variant<EyeDirection, Point3> eye = EyeDirection{};  ///< or where it is
  /// In the middle of the picture; if not given, the picture's middle is that of what is seen.
  std::optional<Point3> look_at = std::nullopt;
  std::variant<UprightBy, Upright> upright = UprightBy::file;
  /// In degrees, from the bottom to the top of the picture, more than 0 and less than 180. If not
  /// given, the eye is four times the mesh's radius away.
  std::optional<double> angle_of_view = std::nullopt;
  bool parallel = false;  ///< a parallel projection, which has no angle of view
  /// Finds the window, or the eye's distance for an angle of view, in which the mesh is seen whole.
  /// Otherwise nothing depends on the mesh: the view is that of a ball of radius 1 at the origin or
  /// at what is looked at.
  bool fit = true;
  /// Finds the eye's distance for the mesh as it turns about the axis that is up, through its
  /// middle.
  bool turning = false;
  bool operator==(const Camera&) const = default;
};

/// Limits of the import library for one mesh, in the process of its own in which it runs
/// (import_process.md). OBJ, OFF, PLY and STL are read in this process, and need none of it.
struct ImportLimits {
  std::size_t memory = std::size_t{2} << 30;  ///< bytes, beside what the library itself takes
  double seconds = 60.0;                      ///< by the clock
  /// Where there is no such process: formats are read whose readers are not on the list of those
  /// that are allowed (allowed_formats.h). Elsewhere it changes nothing.
  bool any_format = false;
};

/// How meshes are entered, where it is not as their files say.
struct MeshOptions {
  Camera camera;                   ///< of the fitted view
  std::optional<Colour> colour{};  ///< of all faces, whatever files and programs say
  bool file_colours = true;        ///< the colours that files give faces are taken
  /// Faces' sides are drawn, unless the application set how: with a method that shows lines only,
  /// and where lines are selected.
  bool sides_drawn = false;
  bool hidden_sides_drawn = false;  ///< and dashed where they are hidden: no back face is removed
  ImportLimits import_limits{};     ///< of formats that the import library reads
};

// Meshes.

/// A mesh in plain arrays, in world coordinates. Faces are polygons of any number of sides from 3
/// up, as in the file, and share the vertices that they share there: nothing is triangulated and
/// no vertices are joined.
struct Mesh {
  static constexpr std::uint32_t kNoNormal = 0xFFFFFFFFu;
  static constexpr std::uint32_t kNoMaterial = 0xFFFFFFFFu;

  struct Object {
    std::string name;
    std::size_t first_face, faces;
  };
  /// The look of faces of a file, as far as it is drawn.
  struct Material {
    std::optional<Colour> colour;  ///< nothing: the file does not say
    bool textured = false;         ///< drawn in the colour alone
    bool transparent = false;      ///< drawn opaque
    bool operator==(const Material&) const = default;
  };
  /// Contents of a file that the mesh leaves out.
  struct Skipped {
    std::size_t points_and_lines = 0;
    std::size_t degenerate_faces = 0;   ///< of fewer than 3 different positions
    std::size_t textured_faces = 0;     ///< drawn without their textures
    std::size_t transparent_faces = 0;  ///< drawn opaque
    std::vector<std::string> warnings;  ///< what else was lost, a sentence each
  };

  /// The axis that is up: as the file says or its format lays down; nothing if neither does.
  std::optional<Upright> upright{};
  std::optional<Upright> usual_upright{};  ///< by the custom of the format, where neither does
  std::vector<Object> objects;             ///< in the order of the faces; each has some
  std::vector<Point3> vertices;            ///< also those that no face uses
  /// By how much a coordinate may be off as the numbers of the file are rounded (entered_reach);
  /// 0: no more than doubles are.
  double rounding = 0.0;
  std::vector<Point3> normals;            ///< of any length; zero if not known
  std::vector<std::uint32_t> corners;     ///< indices into vertices, face after face
  std::vector<std::size_t> first_corner;  ///< of each face; one more at the end
  /// Indices into normals or kNoNormal, as many as corners; or none at all.
  std::vector<std::uint32_t> corner_normals;
  std::vector<Material> materials;
  /// Indices into materials or kNoMaterial, as many as faces; or none at all.
  std::vector<std::uint32_t> face_materials;
  Skipped skipped;

  /// Makes entered_reach that of parts of other inputs; one that is smaller than that of doubles
  /// has no effect.
  void set_reach(double reach);
  std::size_t faces() const { return first_corner.empty() ? 0 : first_corner.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t i) const {
    return std::span(corners).subspan(first_corner[i], first_corner[i + 1] - first_corner[i]);
  }
  /// The colour that the file gives a face; nothing if it gives none.
  std::optional<Colour> colour(std::size_t face) const {
    if (face_materials.empty() || face_materials[face] == kNoMaterial) return std::nullopt;
    return materials[face_materials[face]].colour;
  }
  /// The surface's normal at a corner, zero if it is not known. There must be corner_normals.
  Point3 normal(std::size_t corner) const {
    const std::uint32_t n = corner_normals[corner];
    return n == kNoNormal ? Point3(0.0) : normals[n];
  }
};

/// The parts left out, in words: "3 points and lines", each kind that there was some of.
std::vector<std::string> left_out(const Mesh::Skipped& skipped);

/// Reads a mesh: OBJ, OFF, PLY and STL in the precision of the file, any other format through the
/// import library in a process of its own (import_process.h); README.md lists what is read of each.
/// An object is an object or a group of OBJ, a solid of an STL text, a node of the library's scene,
/// or else the whole file. Throws Error, naming the file and, where known, line and column:
/// unreadable, unknown format, truncated, an index out of range, a coordinate that is not finite or
/// larger than single precision holds, more announced than the file can hold, no faces; and, of
/// what the import library reads, that it crashed, or took more time or memory than the limits say.
///
/// Normals of vertices are read only if they are wanted, and not from STL files, which have those
/// of facets.
Mesh read_mesh(const std::string& path, bool with_normals = false, const ImportLimits& limits = {});

/// Gives each corner that has no normal the mean of the faces around its vertex, weighted by their
/// angles there; vertices of equal position are one. Zero is left where they have none. Thürmer and
/// Wüthrich, "Computing vertex normals from polygonal facets", J. Graphics Tools 3 (1998).
void complete_normals(Mesh& mesh);

/// True if the mesh bounds solids and turns its light faces out: in each object by itself, or
/// else in all taken together, every edge is used exactly twice, once in each direction (vertices
/// of equal position are the same), and every connected part encloses a positive volume.
bool closed_and_consistently_oriented(const Mesh& mesh);

/// Within which distance parts of the mesh touch, unless it is set (clip/surfaces.h): 8 times the
/// unit of its file's numbers. That is 2^-24 of the largest coordinate in single precision; of
/// decimals, the longest of which has 6 significant digits or more, half a unit of its last digit,
/// at most 2^-17; else 2^-52.
double entered_reach(const Mesh& mesh);

/// One segment an object, named first_segment_name and up, in the view and the styles in force;
/// faces that are turned outward stay so where the modelling transformation mirrors; faces that
/// have a colour are filled in it, or all in that of the options. The fill style in force stays
/// what it was. Where touching is automatic, that of the segments is entered_reach of the mesh.
/// The normals of the vertices, if the mesh has any, are set for each face. The name
/// of an object is recorded as a comment. Throws Error if a segment is open, one of the names is in
/// use or the colour is outside of [0,1]; then nothing was entered.
void enter_mesh(const Mesh& mesh, GraphicsSystem& system, int first_segment_name,
                const MeshOptions& options = {});

/// Enters meshes in the view in force, in segments named from the first number that follows all in
/// use. Settings that the application made hold for them; otherwise they bring a light over the
/// viewer's left shoulder, a neutral fill style, no lines, and hidden-line removal, with back-face
/// removal for those meshes that are closed_and_consistently_oriented. Light and hidden-line
/// removal stay; styles are then what they were. Throws Error if a segment is open.
void enter_meshes(std::span<const Mesh> meshes, GraphicsSystem& system,
                  const MeshOptions& options = {});

/// Opens and closes the segments that enter_meshes would enter the mesh into, with nothing in them:
/// for programs that name them. Throws Error as open_segment.
void enter_empty_segments(const Mesh& mesh, GraphicsSystem& system);

/// The result of an import of meshes.
struct ImportedMeshes {
  std::vector<Mesh::Skipped> skipped;  ///< of each mesh: what was left out
  /// The upright of the camera of the view that was fitted to them; nothing if no camera was
  /// fitted.
  std::optional<Upright> fitted;
};

/// Reads meshes and enters them so; where smooth shading is in force, with normals of the
/// vertices, from the file or else completed. If no window was set before, a view is fitted to them
/// (fitted_view.h), which stays set: in the modelling transformation in force, for the system's
/// aspect ratio, or for the one given, which then stays that of the system.
///
/// A face is filled in the first of these that there is: the colour of the options; the fill style
/// that the application set; the colour that its file gives it; the neutral one.
///
/// Throws Error as read_mesh and fit_view do, or if a segment is
/// open, the aspect ratio is not positive or the colour is outside of [0,1]; then nothing was
/// changed.
ImportedMeshes import_meshes(std::span<const std::string> paths, GraphicsSystem& system,
                             const MeshOptions& options = {});
ImportedMeshes import_meshes(std::span<const std::string> paths, GraphicsSystem& system,
                             double aspect);
/// The same of one mesh. Returns what was left out.
Mesh::Skipped import_mesh(const std::string& path, GraphicsSystem& system,
                          const MeshOptions& options = {});
Mesh::Skipped import_mesh(const std::string& path, GraphicsSystem& system, double aspect);

}  // namespace displayfile
