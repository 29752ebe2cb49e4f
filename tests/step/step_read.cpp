// step_read FILE: what Open CASCADE reads in a STEP file, as a line of JSON: how many solids and
// faces, whether they are valid, the areas of the curved and of the plane faces, the center of
// the curved ones, the volume. Areas
// are integrals to 1e-12 of themselves.

#include <cstdio>
#include <fstream>

#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Reader.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  STEPControl_Reader reader;
  if (reader.ReadFile(argv[1]) != IFSelect_RetDone || reader.TransferRoots() == 0) return 1;
  const TopoDS_Shape shape = reader.OneShape();
  int solids = 0;
  for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next()) ++solids;
  int faces = 0;
  GProp_GProps curved;
  GProp_GProps plane;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next(), ++faces) {
    const TopoDS_Face face = TopoDS::Face(at.Current());
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(face, properties, 1e-12);
    (BRepAdaptor_Surface(face).GetType() == GeomAbs_Plane ? plane : curved).Add(properties);
  }
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  const gp_Pnt center = curved.CentreOfMass();
  std::printf(
      "{\"solids\": %d, \"faces\": %d, \"valid\": %s, \"curved\": %.17g, \"plane\": %.17g, "
      "\"center\": [%.17g, %.17g, %.17g], \"volume\": %.17g}\n",
      solids, faces, BRepCheck_Analyzer(shape).IsValid() ? "true" : "false", curved.Mass(),
      plane.Mass(), center.X(), center.Y(), center.Z(), properties.Mass());
}
