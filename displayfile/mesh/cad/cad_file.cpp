#include "displayfile/mesh/cad/cad_file.h"

#include <fmt/format.h>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Precision.hxx>
#include <Quantity_ColorRGBA.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDF_Tool.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XCAFPrs_DocumentExplorer.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <map>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "clip/base/error.h"
#include "displayfile/mesh/cad/cad_document.h"
#include "displayfile/mesh/cad/cad_faces.h"
#include "displayfile/mesh/cad/cad_sewing.h"
#include "displayfile/mesh/import_protocol.h"
#include "displayfile/mesh/mesh_builder.h"

namespace displayfile {

namespace {

constexpr double kDiagonalsOfDeflection = 2500.0;
/// On a surface that is curved two ways the library's facets are farther from it than the
/// deflection that is set: on spheres up to 2.08 times as far.
constexpr double kOfLibrary = 1.0 / 2.2;
constexpr double kMostAngle = 0.349;  // 20 degrees, less than a crease

/// The number of the file, which the library keeps in single precision and, of sRGB, as light.
double component(double value) {
  constexpr double kDigits = 1e6;
  return std::clamp(std::round(value * kDigits) / kDigits, 0.0, 1.0);
}

Rgba rgba_of(const Quantity_ColorRGBA& colour) {
  std::array<double, 3> rgb;
  colour.GetRGB().Values(rgb[0], rgb[1], rgb[2], Quantity_TOC_sRGB);
  return {component(rgb[0]), component(rgb[1]), component(rgb[2]),
          component(static_cast<double>(colour.Alpha()))};
}

std::string text_of(const TCollection_ExtendedString& text) {
  std::string utf8(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  char* begin = utf8.data();
  text.ToUTF8CString(begin);
  utf8.resize(utf8.find('\0'));
  return utf8;
}

/// Names that the library makes up for shapes without any: those of their kinds, or references.
bool is_made_up(std::string_view name) {
  constexpr std::string_view kKinds[] = {"ASSEMBLY", "COMPOUND", "COMPSOLID", "SOLID", "SHELL",
                                         "FACE",     "WIRE",     "EDGE",      "VERTEX"};
  return name.empty() || name.starts_with("=>[") ||
         std::ranges::find(kKinds, name) != std::end(kKinds);
}

std::string name_of_label(const TDF_Label& label) {
  opencascade::handle<TDataStd_Name> name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name)) return "";
  const std::string text = text_of(name->Get());
  return is_made_up(text) ? "" : text;
}

/// A part's shape, and its faces in their order as they are drawn.
struct CadPart {
  TopoDS_Shape shape;
  std::vector<TopoDS_Face> faces;
  std::vector<std::optional<Rgba>> colours;  ///< of the faces alone, without those of the part
};

class CadReader {
 public:
  CadReader(const std::string& path, CadFormat format, bool with_normals, double deflection)
      : path_(path),
        format_(format),
        document_(read_cad_document(path, format)),
        shapes_(XCAFDoc_DocumentTool::ShapeTool(document_.shapes->Main())),
        colours_(XCAFDoc_DocumentTool::ColorTool(document_.shapes->Main())),
        mesh_(path),
        faces_(mesh_, with_normals) {
    diagonal_ = diagonal();
    deflection_ = deflection_of_library(deflection);
  }

  Mesh read() && {
    for (XCAFPrs_DocumentExplorer instances(document_.shapes,
                                            XCAFPrs_DocumentExplorerFlags_OnlyLeafNodes);
         instances.More(); instances.Next()) {
      add(instances);
    }
    for (std::string& warning : document_.warnings) mesh_.warn(std::move(warning));
    mesh_.warn_left_out(hidden_, "{} instance of a part that is hidden in the file",
                        "{} instances of parts that are hidden in the file");
    // The library hides which: it catches its own exception of too little memory.
    mesh_.warn_left_out(
        not_meshed_,
        "{} face that the library cannot divide into triangles, or not within --import-memory",
        "{} faces that the library cannot divide into triangles, or not within --import-memory");
    // Within the library's tolerance its points are the same.
    constexpr double kReachOfRounding = 8.0;
    mesh_.note_rounding(::Precision::Confusion() / kReachOfRounding);
    return std::move(mesh_).finish();
  }

 private:
  /// That of the box around all that is placed.
  double diagonal() const {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    Bnd_Box box;
    for (const TDF_Label& root : roots) {
      const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(root);
      if (!shape.IsNull()) BRepBndLib::Add(shape, box, Standard_False);
    }
    if (box.IsVoid() || box.IsOpen()) fail("it has no shapes, or one without an end");
    const double length = std::sqrt(box.SquareExtent());
    if (!(length > 0.0) || std::isinf(length)) fail("its shapes have no extent");
    return length;
  }

  /// `set`: ImportLimits::deflection.
  double deflection_of_library(double set) const {
    const double least = ::Precision::Confusion();
    if (!(set > 0.0)) return std::max(kOfLibrary * diagonal_ / kDiagonalsOfDeflection, least);
    if (kOfLibrary * set >= least) return kOfLibrary * set;
    throw Error(fmt::format("{}: deflection {}: expected at least {:g}, the library's precision",
                            path_, set, least / kOfLibrary));
  }

  void add(const XCAFPrs_DocumentExplorer& instances) {
    const XCAFPrs_DocumentNode& node = instances.Current();
    if (!node.Style.IsVisible() || !colours_->IsVisible(node.RefLabel)) {
      ++hidden_;
      return;
    }
    const CadPart* const part = part_of(node.RefLabel);
    if (part == nullptr) return;
    mesh_.begin_object(name_of_instance(instances));
    faces_.begin(matrix_of(node.Location));
    std::optional<Rgba> of_instance;
    if (node.Style.IsSetColorSurf()) of_instance = rgba_of(node.Style.GetColorSurfRGBA());
    for (std::size_t i = 0; i < part->faces.size(); ++i) {
      const auto& own = part->colours[i];
      mesh_.use_colour(own ? own : of_instance);
      if (!faces_.add(part->faces[i])) ++not_meshed_;
    }
    mesh_.skip_points_and_lines(points_and_lines(part->shape));
  }

  /// The part's name, or that of the instance, or of what they are in.
  static std::string name_of_instance(const XCAFPrs_DocumentExplorer& instances) {
    for (int depth = instances.CurrentDepth(); depth >= 0; --depth) {
      const XCAFPrs_DocumentNode& node = instances.Current(depth);
      for (const TDF_Label& label : {node.RefLabel, node.Label}) {
        std::string name = name_of_label(label);
        if (!name.empty()) return name;
      }
    }
    return "";
  }

  /// Parts are divided into facets once, however often they are placed.
  const CadPart* part_of(const TDF_Label& label) {
    TCollection_AsciiString entry;
    TDF_Tool::Entry(label, entry);
    const auto [found, is_new] = parts_.try_emplace(entry.ToCString());
    CadPart& part = found->second;
    if (is_new) {
      part.shape = XCAFDoc_ShapeTool::GetShape(label);
      if (!part.shape.IsNull()) divide(part, label);
    }
    return part.shape.IsNull() ? nullptr : &part;
  }

  void divide(CadPart& part, const TDF_Label& label) {
    std::vector<TopoDS_Face> original;
    for (TopExp_Explorer face(part.shape, TopAbs_FACE); face.More(); face.Next()) {
      original.push_back(TopoDS::Face(face.Current()));
    }
    part.faces = original;
    if (format_ == CadFormat::iges && has_free_edges(part.shape)) {
      constexpr double kLeastOfDiagonal = 1e-5;
      part.faces =
          sewn_faces(part.shape, std::max(document_.resolution, kLeastOfDiagonal * diagonal_));
    }
    give_colours(part, original, label);
    BRep_Builder builder;
    TopoDS_Compound all;
    builder.MakeCompound(all);
    for (const TopoDS_Face& face : part.faces) builder.Add(all, face);
    IMeshTools_Parameters parameters;
    parameters.Deflection = deflection_;
    parameters.Angle = kMostAngle;
    parameters.MinSize = ::Precision::Confusion();  // else a coarse deflection exceeds the angle
    BRepMesh_IncrementalMesh(all, parameters);
  }

  /// A face's colour is its own, or that of the smallest shape around it that has one.
  void give_colours(CadPart& part, const std::vector<TopoDS_Face>& faces, const TDF_Label& label) {
    part.colours.resize(faces.size());
    TDF_LabelSequence labels;
    XCAFDoc_ShapeTool::GetSubShapes(label, labels);
    for (int kind = TopAbs_FACE; kind >= TopAbs_COMPOUND; --kind) {
      TopTools_DataMapOfShapeInteger of_faces;  // indices of colours
      std::vector<Rgba> colours;
      for (const TDF_Label& sub : labels) {
        const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(sub);
        if (shape.IsNull() || shape.ShapeType() != kind) continue;
        Quantity_ColorRGBA colour;
        if (!colours_->GetColor(sub, XCAFDoc_ColorSurf, colour) &&
            !colours_->GetColor(sub, XCAFDoc_ColorGen, colour)) {
          continue;
        }
        for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
          of_faces.Bind(face.Current(), static_cast<int>(colours.size()));
        }
        colours.push_back(rgba_of(colour));
      }
      for (std::size_t i = 0; i < faces.size(); ++i) {
        if (part.colours[i] || !of_faces.IsBound(faces[i])) continue;
        part.colours[i] = colours[static_cast<std::size_t>(of_faces.Find(faces[i]))];
      }
    }
  }

  /// The number of edges and points that belong to no face.
  static std::size_t points_and_lines(const TopoDS_Shape& shape) {
    std::size_t n = 0;
    for (TopExp_Explorer edge(shape, TopAbs_EDGE, TopAbs_FACE); edge.More(); edge.Next()) ++n;
    for (TopExp_Explorer point(shape, TopAbs_VERTEX, TopAbs_EDGE); point.More(); point.Next()) ++n;
    return n;
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw Error(
        fmt::format("{}: not a mesh that can be read: {}: {}", path_, name_of(format_), why));
  }

  const std::string& path_;
  CadFormat format_;
  CadDocument document_;
  opencascade::handle<XCAFDoc_ShapeTool> shapes_;
  opencascade::handle<XCAFDoc_ColorTool> colours_;
  MeshBuilder mesh_;
  CadFaces faces_;
  double diagonal_ = 0.0, deflection_ = 0.0;
  std::map<std::string, CadPart> parts_;  // by the entries of their labels
  std::size_t hidden_ = 0, not_meshed_ = 0;
};

/// The library lets its exception of too little memory leave destructors.
[[noreturn]] void end_process() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const Standard_OutOfMemory&) {
    std::_Exit(kOutOfMemoryStatus);
  } catch (...) {
  }
  std::abort();
}

}  // namespace

Mesh read_cad_file(const std::string& path, bool with_normals, double deflection) {
  const CadFormat format = cad_format(path).value_or(CadFormat::step);
  try {
    return CadReader(path, format, with_normals, deflection).read();
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure& failure) {
    throw Error(fmt::format("{}: not a mesh that can be read: {}: {} {}", path, name_of(format),
                            failure.DynamicType()->Name(), failure.GetMessageString()));
  }
}

void load_cad_library(const std::string&) {
  std::set_terminate(end_process);
  load_cad_readers();
}

}  // namespace displayfile
