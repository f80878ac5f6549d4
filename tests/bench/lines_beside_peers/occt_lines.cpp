// Times OpenCASCADE's hidden-line removal on a mesh in a view, and writes the visible lines: a peer
// of lines-beside-peers (README.md here has the protocol).
//   occt_lines MESH.obj VIEW polygonal|exact
// Each face of the mesh is a planar face of the shape, and faces share the edges that they share
// there; each connected part is a shell. So all edges of the mesh are edges of the shape.

#include <time.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <HLRBRep_PolyHLRToShape.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <iostream>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Mesh {
  std::vector<gp_Pnt> vertices;
  std::vector<std::vector<std::size_t>> faces;
};

Mesh read_mesh(const std::string& path) {
  Mesh mesh;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      double x = 0.0, y = 0.0, z = 0.0;
      words >> x >> y >> z;
      mesh.vertices.emplace_back(x, y, z);
    } else if (word == "f") {
      mesh.faces.emplace_back();
      for (std::size_t vertex = 0; words >> vertex;) mesh.faces.back().push_back(vertex - 1);
    }
  }
  return mesh;
}

using View = std::map<std::string, std::vector<double>>;
View read_view(const std::string& path) {
  View view;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    words >> name;
    for (double x = 0.0; words >> x;) view[name].push_back(x);
  }
  return view;
}

/// The axes of a view plane through the world's origin: the polygonal algorithm does not move its
/// results to another plane. Parallel views alone: nor does it project them in a perspective.
gp_Ax2 axes_of(const View& view) {
  if (view.at("perspective")[0] != 0.0) throw std::runtime_error("a perspective view");
  const auto direction = [&](const char* name) {
    const auto& v = view.at(name);
    return gp_Dir(v[0], v[1], v[2]);
  };
  return {gp_Pnt(0.0, 0.0, 0.0), direction("toward"), direction("right")};
}

/// Which connected part each face is of, by vertices.
std::vector<std::size_t> parts_of(const Mesh& mesh) {
  std::vector<std::size_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& face : mesh.faces) {
    for (const std::size_t vertex : face) parent[root(vertex)] = root(face[0]);
  }
  std::vector<std::size_t> parts;
  for (const auto& face : mesh.faces) parts.push_back(root(face[0]));
  return parts;
}

class ShapeMaker {
 public:
  explicit ShapeMaker(const Mesh& mesh) : mesh_(mesh) {
    for (const gp_Pnt& p : mesh.vertices) {
      TopoDS_Vertex vertex;
      builder_.MakeVertex(vertex, p, Precision::Confusion());
      vertices_.push_back(vertex);
    }
  }

  /// A shell for each connected part, closed if each edge is there once in each direction.
  std::vector<TopoDS_Shape> shells() {
    std::map<std::size_t, TopoDS_Shell> shells;
    std::map<std::size_t, bool> closed;
    count_edges();
    const std::vector<std::size_t> parts = parts_of(mesh_);
    for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
      const auto [shell, added] = shells.try_emplace(parts[i]);
      if (added) builder_.MakeShell(shell->second);
      closed.try_emplace(parts[i], true).first->second &= is_closed_at(mesh_.faces[i]);
      if (const auto face = face_of(mesh_.faces[i])) builder_.Add(shell->second, *face);
    }
    std::vector<TopoDS_Shape> shapes;
    for (auto& [part, shell] : shells) {
      shell.Closed(closed.at(part));
      shapes.push_back(shell);
    }
    return shapes;
  }
  std::size_t left_out() const { return left_out_; }

 private:
  using Ends = std::pair<std::size_t, std::size_t>;

  template <class Visit>
  static void for_each_side(const std::vector<std::size_t>& face, const Visit& visit) {
    for (std::size_t k = 0; k < face.size(); ++k) visit(face[k], face[(k + 1) % face.size()]);
  }
  void count_edges() {
    for (const auto& face : mesh_.faces) {
      for_each_side(face, [&](std::size_t a, std::size_t b) { ++uses_[{a, b}]; });
    }
  }
  bool is_closed_at(const std::vector<std::size_t>& face) const {
    bool closed = true;
    for_each_side(face, [&](std::size_t a, std::size_t b) {
      const auto back = uses_.find({b, a});
      closed &= uses_.at({a, b}) == 1 && back != uses_.end() && back->second == 1;
    });
    return closed;
  }

  TopoDS_Edge edge_of(std::size_t a, std::size_t b) {
    const Ends ends = std::minmax(a, b);
    const auto [edge, added] = edges_.try_emplace(ends);
    if (added) {
      BRepBuilderAPI_MakeEdge make(vertices_[ends.first], vertices_[ends.second]);
      if (make.IsDone()) edge->second = make.Edge();
    }
    if (edge->second.IsNull()) return {};
    return TopoDS::Edge(a == ends.first ? edge->second : edge->second.Reversed());
  }

  std::optional<TopoDS_Face> face_of(const std::vector<std::size_t>& corners) {
    BRepBuilderAPI_MakeWire wire;
    gp_XYZ normal(0.0, 0.0, 0.0);  // Newell's
    for_each_side(corners, [&](std::size_t a, std::size_t b) {
      const TopoDS_Edge edge = edge_of(a, b);
      if (!edge.IsNull()) wire.Add(edge);
      normal += mesh_.vertices[a].XYZ().Crossed(mesh_.vertices[b].XYZ());
    });
    if (wire.IsDone() && normal.Modulus() > gp::Resolution()) {
      const gp_Pln plane(mesh_.vertices[corners[0]], gp_Dir(normal));
      const BRepBuilderAPI_MakeFace face(plane, wire.Wire());
      if (face.IsDone()) return face.Face();
    }
    ++left_out_;
    return std::nullopt;
  }

  const Mesh& mesh_;
  BRep_Builder builder_;
  std::vector<TopoDS_Vertex> vertices_;
  std::map<Ends, TopoDS_Edge> edges_;
  std::map<Ends, int> uses_;
  std::size_t left_out_ = 0;
};

/// The result of a round: shapes of visible edges, some of them null.
using Seen = std::vector<TopoDS_Shape>;

/// Visible edges, followed by hidden ones if requested.
Seen seen_polygonally(const std::vector<TopoDS_Shape>& shapes, const HLRAlgo_Projector& projector,
                      bool with_hidden) {
  const Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo;
  for (const TopoDS_Shape& shape : shapes) algorithm->Load(shape);
  algorithm->Projector(projector);
  algorithm->Update();
  HLRBRep_PolyHLRToShape to_shape;
  to_shape.Update(algorithm);
  Seen seen{to_shape.VCompound(), to_shape.Rg1LineVCompound(), to_shape.RgNLineVCompound(),
            to_shape.OutLineVCompound()};
  if (with_hidden) {
    for (const TopoDS_Shape& hidden : {to_shape.HCompound(), to_shape.Rg1LineHCompound(),
                                       to_shape.RgNLineHCompound(), to_shape.OutLineHCompound()}) {
      seen.push_back(hidden);
    }
  }
  return seen;
}

Seen seen_exactly(const std::vector<TopoDS_Shape>& shapes, const HLRAlgo_Projector& projector) {
  const Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo;
  for (const TopoDS_Shape& shape : shapes) algorithm->Add(shape);
  algorithm->Projector(projector);
  algorithm->Update();
  algorithm->Hide();
  HLRBRep_HLRToShape to_shape(algorithm);
  return {to_shape.VCompound(), to_shape.Rg1LineVCompound(), to_shape.RgNLineVCompound(),
          to_shape.OutLineVCompound()};
}

/// The ends of the visible segments, in the view plane's coordinates.
std::vector<double> segments_of(const Seen& seen, const View& view) {
  std::vector<double> ends;
  const gp_Ax2 axes = axes_of(view);
  const gp_XYZ at(view.at("origin")[0], view.at("origin")[1], view.at("origin")[2]);
  const double x = at.Dot(axes.XDirection().XYZ()), y = at.Dot(axes.YDirection().XYZ());
  for (const TopoDS_Shape& shape : seen) {
    if (shape.IsNull()) continue;
    BRepLib::BuildCurves3d(shape);
    for (TopExp_Explorer edges(shape, TopAbs_EDGE); edges.More(); edges.Next()) {
      double from = 0.0, to = 0.0;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(TopoDS::Edge(edges.Current()), from, to);
      if (curve.IsNull()) continue;
      const gp_Pnt p = curve->Value(from), q = curve->Value(to);
      ends.insert(ends.end(), {p.X() - x, p.Y() - y, q.X() - x, q.Y() - y});
    }
  }
  return ends;
}

double now(bool processor) {
  timespec t{};
  clock_gettime(processor ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void serve(const std::string& mesh_path, const std::string& view_path, bool exact) {
  const Mesh mesh = read_mesh(mesh_path);
  ShapeMaker maker(mesh);
  const View view = read_view(view_path);
  const std::vector<TopoDS_Shape> shapes = maker.shells();
  const HLRAlgo_Projector projector(axes_of(view));
  for (const TopoDS_Shape& shape : shapes) {
    if (!exact) BRepMesh_IncrementalMesh(shape, 1.0);  // of planar faces: any deflection
  }
  std::cout << "peer: ready " << maker.left_out() << std::endl;
  const auto find = [&](bool with_hidden) {
    return exact ? seen_exactly(shapes, projector)
                 : seen_polygonally(shapes, projector, with_hidden);
  };
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string word, argument, more;
    words >> word >> argument >> more;
    if (word == "round") {
      const double start = now(argument == "processor");
      find(more == "hidden");
      std::cout << "peer: seconds " << now(argument == "processor") - start << std::endl;
    } else if (word == "segments") {
      const std::vector<double> ends = segments_of(find(false), view);
      std::ofstream(argument, std::ios::binary)
          .write(reinterpret_cast<const char*>(ends.data()),
                 static_cast<std::streamsize>(ends.size() * sizeof(double)));
      std::cout << "peer: segments " << ends.size() / 4 << std::endl;
    } else {
      break;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4 || (std::string(argv[3]) != "polygonal" && std::string(argv[3]) != "exact")) {
    std::cerr << "usage: occt_lines MESH.obj VIEW polygonal|exact\n";
    return 2;
  }
  try {
    serve(argv[1], argv[2], std::string(argv[3]) == "exact");
  } catch (const Standard_Failure& failure) {
    std::cout << "peer: failed " << failure.GetMessageString() << std::endl;
    return 1;
  } catch (const std::exception& error) {
    std::cout << "peer: failed " << error.what() << std::endl;
    return 1;
  }
  return 0;
}
