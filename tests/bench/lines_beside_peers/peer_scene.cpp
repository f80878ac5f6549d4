#include "tests/bench/lines_beside_peers/peer_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>
#include <sstream>
#include <utility>

#include "clip/base/error.h"
#include "clip/geometry/corners.h"
#include "clip/surfaces.h"
#include "clip/view/view_volume.h"
#include "displayfile/mesh/fitted_view.h"
#include "displayfile/segments/scene_lines.h"
#include "displayfile/user_routines/system_inside.h"
#include "programs/scenes/scene.h"

namespace displayfile::bench {

namespace {

double to_single(double x) { return static_cast<double>(static_cast<float>(x)); }

/// Triangles, in single precision.
Mesh in_single_triangles(const Mesh& mesh) {
  Mesh single;
  for (const Point3& p : mesh.vertices) {
    single.vertices.emplace_back(to_single(p.x), to_single(p.y), to_single(p.z));
  }
  single.first_corner = {0};
  for (std::size_t i = 0; i < mesh.faces(); ++i) {
    const auto face = mesh.face(i);
    for (std::size_t k = 2; k < face.size(); ++k) {
      single.corners.insert(single.corners.end(), {face[0], face[k - 1], face[k]});
      single.first_corner.push_back(single.corners.size());
    }
  }
  single.objects = {{"mesh", 0, single.faces()}};
  return single;
}

/// The sides of all faces, those with the same ends together.
class Edges {
 public:
  struct Use {
    std::uint32_t other;  ///< the larger vertex
    std::uint32_t face, corner;
    bool forward;  ///< from the smaller vertex to the larger
  };

  explicit Edges(const Mesh& mesh) : first_(mesh.vertices.size() + 1, 0) {
    for_each_side(mesh, [&](std::uint32_t low, const Use&) { ++first_[low + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    uses_.resize(mesh.corners.size());
    std::vector<std::size_t> next = first_;
    for_each_side(mesh, [&](std::uint32_t low, const Use& use) { uses_[next[low]++] = use; });
    for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
      const auto at = [&](std::size_t k) {
        return uses_.begin() + static_cast<std::ptrdiff_t>(first_[i + k]);
      };
      std::sort(at(0), at(1), [](const Use& a, const Use& b) {
        return a.other != b.other ? a.other < b.other : a.face < b.face;
      });
    }
  }

  /// Calls visit(uses) for each edge.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
      for (std::size_t from = first_[i], to = from; from < first_[i + 1]; from = to) {
        while (to < first_[i + 1] && uses_[to].other == uses_[from].other) ++to;
        visit(std::span(uses_).subspan(from, to - from));
      }
    }
  }

 private:
  template <class Visit>
  static void for_each_side(const Mesh& mesh, const Visit& visit) {
    for (std::uint32_t i = 0; i < mesh.faces(); ++i) {
      const auto face = mesh.face(i);
      std::uint32_t a = face.back();
      for (std::uint32_t corner = 0; corner < face.size(); ++corner) {
        const std::uint32_t b = face[corner];
        visit(std::min(a, b), Use{std::max(a, b), i, corner, a < b});
        a = b;
      }
    }
  }

  std::vector<std::size_t> first_;  // of each vertex, among the uses; and the end
  std::vector<Use> uses_;
};

/// Newell's, of no special length.
Point3 normal_of(const Mesh& mesh, std::size_t face) {
  Point3 normal(0.0);
  Point3 p = mesh.vertices[mesh.face(face).back()];
  for (const std::uint32_t corner : mesh.face(face)) {
    const Point3& q = mesh.vertices[corner];
    normal +=
        Point3((p.y - q.y) * (p.z + q.z), (p.z - q.z) * (p.x + q.x), (p.x - q.x) * (p.y + q.y));
    p = q;
  }
  return normal;
}

/// Twice the area of an item in the projection, positive if it runs anticlockwise.
double area_of(const ViewedScene& scene, std::uint32_t item) {
  const auto points = scene.points(item);
  double area = 0.0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    const Point2 p(points[0]), q(points[i - 1]), r(points[i]);
    area += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }
  return area;
}

/// The sides that are outlines, boundaries among them, or creases: by the faces in the world, and
/// by which of them face the viewer.
std::vector<LineName> features_of(const Mesh& mesh, const ViewedScene& scene,
                                  const LineKinds& kinds) {
  const double least_cosine = std::cos(kCreaseDegrees * std::numbers::pi / 180.0);
  std::vector<Point3> normals(kinds.crease ? mesh.faces() : 0);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Point3 normal = normal_of(mesh, i);
    normals[i] = normal / std::max(glm::length(normal), 1e-300);
  }
  std::vector<std::uint8_t> is_front(mesh.faces());
  for (std::uint32_t i = 0; i < is_front.size(); ++i) is_front[i] = area_of(scene, i) > 0.0;
  std::vector<LineName> lines;
  Edges(mesh).for_each([&](std::span<const Edges::Use> uses) {
    const Edges::Use &one = uses.front(), &other = uses.back();
    const bool same_way = one.forward == other.forward;
    const bool outline =
        uses.size() != 2 || (is_front[one.face] != is_front[other.face]) != same_way;
    const bool crease =
        kinds.crease && uses.size() == 2 &&
        (same_way ? -1.0 : 1.0) * glm::dot(normals[one.face], normals[other.face]) < least_cosine;
    if ((kinds.outline && outline) || crease) lines.push_back({one.face, one.corner});
  });
  return lines;
}

/// The whole mesh as a segment, in the scene's view.
void enter_mesh(const PeerScene& scene, GraphicsSystem& system) {
  set_view(scene.view, system);
  system.set_back_face_removal(false);
  system.set_line_style(LineStyle{});
  std::vector<std::uint32_t> sides(scene.mesh.faces());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    sides[i] = static_cast<std::uint32_t>(scene.mesh.face(i).size());
  }
  system.open_segment(1);
  system.polygons_abs_3({scene.mesh.vertices, scene.mesh.corners, sides});
  system.close_segment();
}

std::vector<double> read_numbers(const std::string& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw Error(path + ": cannot be read");
  std::vector<double> numbers(static_cast<std::size_t>(file.tellg()) / sizeof(double));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(numbers.data()),
            static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  return numbers;
}

Point2 in_device(const ViewedScene& scene, std::uint32_t item, std::uint32_t corner, double at) {
  const auto points = scene.points(item);
  const Point2 to(points[corner]);
  const Point2 from(points[previous_corner<std::size_t>(corner, points.size())]);
  return (1.0 - at) * from + at * to;
}

}  // namespace

LineKinds line_kinds(const std::string& words) {
  LineKinds kinds{words};
  std::istringstream parts(words);
  for (std::string word; std::getline(parts, word, ',');) {
    if (word == "all") {
      kinds.all = true;
    } else if (word == "outline") {
      kinds.outline = true;
    } else if (word == "crease") {
      kinds.crease = true;
    } else if (word == "intersection") {
      kinds.intersection = true;
    } else {
      throw Error("no kind of line " + word + ": expected all, outline, crease or intersection");
    }
  }
  return kinds;
}

PeerScene peer_scene(std::string name, std::string seen_from, const Mesh& mesh,
                     const Camera& camera) {
  PeerScene scene{std::move(name), std::move(seen_from), in_single_triangles(mesh), {}};
  GraphicsSystem system;
  fit_view(std::span(&scene.mesh, 1), system, camera);
  scene.view = system.view();
  return scene;
}

void write_mesh(const PeerScene& scene, const std::string& path) {
  std::ofstream file(path);
  for (const Point3& p : scene.mesh.vertices) file << fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (std::size_t i = 0; i < scene.mesh.faces(); ++i) {
    file << "f";
    for (const std::uint32_t corner : scene.mesh.face(i)) file << fmt::format(" {}", corner + 1);
    file << "\n";
  }
  if (!file.flush()) throw Error(path + ": cannot be written");
}

void write_view(const PeerScene& scene, const std::string& path) {
  const View& view = scene.view;
  const ViewVolume volume(view);
  const glm::dmat4& m = volume.view_plane();
  std::ofstream file(path);
  const auto write = [&](const char* name, const Point3& p) {
    file << fmt::format("{} {} {} {}\n", name, p.x, p.y, p.z);
  };
  const auto row = [&](int i) { return Point3(m[0][i], m[1][i], m[2][i]); };
  file << fmt::format("perspective {}\n", volume.is_perspective() ? 1 : 0);
  write("origin", view.reference_point + view.distance * glm::normalize(view.plane_normal));
  write("right", row(0));
  write("up", row(1));
  write("toward", row(2));
  const Point3 eye(m * HomogeneousPoint(view.centre_of_projection, 1.0));
  write("eye", volume.is_perspective() ? eye : Point3(0.0));
  file << fmt::format("window {} {} {} {}\n", view.window.x_min, view.window.x_max,
                      view.window.y_min, view.window.y_max);
  if (!file.flush()) throw Error(path + ": cannot be written");
}

EnteredMesh enter(const PeerScene& scene, const LineKinds& kinds) {
  GraphicsSystem system;
  enter_mesh(scene, system);
  EnteredMesh entered{system.display_file(), nullptr, {}, kinds.intersection};
  entered.scene = std::make_unique<ViewedScene>(entered.file);
  if (entered.scene->items() != scene.mesh.faces()) {
    throw Error(scene.name + ": a face was clipped or cut");
  }
  entered.lines = kinds.all ? drawn_lines(entered.scene->primitives())
                            : features_of(scene.mesh, *entered.scene, kinds);
  return entered;
}

RetainedMesh::RetainedMesh(const PeerScene& scene, const LineKinds& kinds)
    : view_(scene.view), intersections_(kinds.intersection) {
  SystemInside::retain_alone(system_, retained_);
  std::string words = kinds.words;  // theirs are named as ours, and boundaries count as outlines
  if (kinds.outline) words += ",boundary";
  system_.set_hidden_surfaces({.lines = line_selection(words)});
  enter_mesh(scene, system_);
  viewer_.emplace(retained_, system_.display_file());
}

SortedPieces RetainedMesh::draw(int threads) {
  const ViewedScene& seen = viewer_->view({.view = view_, .threads = threads});
  SurfacePlan options;
  options.threads = threads;
  options.intersections = intersections_;
  return lines_in_order(seen, find_lines(seen, options.by(HiddenMethod::franklin)),
                        HiddenLines::none);
}

void RetainedMesh::look_elsewhere() {
  View other = view_;
  other.up += 0.125 * Point3(0.5, 0.25, 1.0);
  viewer_->view({.view = other});
}

LineDrawing read_world_segments(const std::string& path, const View& view) {
  const ViewVolume volume(view);
  const std::vector<double> numbers = read_numbers(path);
  const auto at = [&](std::size_t i) {
    return Point2(volume.to_device(volume.transform({numbers[i], numbers[i + 1], numbers[i + 2]})));
  };
  LineDrawing drawing;
  for (std::size_t i = 0; i + 6 <= numbers.size(); i += 6) drawing.push_back({at(i), at(i + 3)});
  return drawing;
}

LineDrawing read_view_plane_segments(const std::string& path, const View& view) {
  const std::vector<double> numbers = read_numbers(path);
  const auto& window = view.window;
  const auto at = [&](std::size_t i) {
    return Point2((numbers[i] - window.x_min) / (window.x_max - window.x_min),
                  (numbers[i + 1] - window.y_min) / (window.y_max - window.y_min));
  };
  LineDrawing drawing;
  for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4) drawing.push_back({at(i), at(i + 2)});
  return drawing;
}

LineDrawing drawing_of(const ViewedScene& scene, std::span<const VisiblePiece> pieces) {
  LineDrawing drawing;
  for (const auto& [item, corner, from, to] : pieces) {
    drawing.push_back({in_device(scene, item, corner, from), in_device(scene, item, corner, to)});
  }
  return drawing;
}

LineDrawing drawing_of(const ViewedScene& scene, std::span<const LineName> lines) {
  LineDrawing drawing;
  for (const auto& [item, corner] : lines) {
    drawing.push_back({in_device(scene, item, corner, 0.0), in_device(scene, item, corner, 1.0)});
  }
  return drawing;
}

}  // namespace displayfile::bench
