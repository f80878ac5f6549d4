#include "displayfile/mesh/cad/cad_sewing.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

namespace displayfile {

namespace {

/// The shape's faces, those of closed shells with their outside outward.
TopTools_IndexedMapOfShape outward_faces(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  for (TopExp_Explorer shells(shape, TopAbs_SHELL); shells.More(); shells.Next()) {
    TopoDS_Shape of_faces = shells.Current();
    if (BRep_Tool::IsClosed(of_faces)) {
      TopoDS_Solid solid;
      BRep_Builder builder;
      builder.MakeSolid(solid);
      builder.Add(solid, of_faces);
      BRepLib::OrientClosedSolid(solid);
      of_faces = solid;
    }
    TopExp::MapShapes(of_faces, TopAbs_FACE, faces);
  }
  TopExp::MapShapes(shape, TopAbs_FACE, faces);  // those that are in no shell
  return faces;
}

}  // namespace

std::vector<TopoDS_Face> sewn_faces(const TopoDS_Shape& shape, double tolerance) {
  BRepBuilderAPI_Sewing sewing(tolerance);
  sewing.Add(shape);
  sewing.Perform();
  std::vector<TopoDS_Face> faces;
  if (sewing.SewedShape().IsNull()) {
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
      faces.push_back(TopoDS::Face(face.Current()));
    }
    return faces;
  }
  const TopTools_IndexedMapOfShape sewn = outward_faces(sewing.SewedShape());
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
    const TopoDS_Shape in_place = sewing.ModifiedSubShape(face.Current());
    // The map has the orientation that the shell gives.
    const bool is_face = !in_place.IsNull() && in_place.ShapeType() == TopAbs_FACE;
    const int found = is_face ? sewn.FindIndex(in_place) : 0;
    faces.push_back(TopoDS::Face(found > 0 ? sewn.FindKey(found) : face.Current()));
  }
  return faces;
}

bool has_free_edges(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
  for (int i = 1; i <= faces_of_edges.Extent(); ++i) {
    if (faces_of_edges(i).Extent() == 1 &&
        !BRep_Tool::Degenerated(TopoDS::Edge(faces_of_edges.FindKey(i)))) {
      return true;
    }
  }
  return false;
}

}  // namespace displayfile
