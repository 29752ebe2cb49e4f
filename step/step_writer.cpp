// Solids in STEP (ISO 10303, AP214), by Open CASCADE: a library that phrame loads when it is asked
// for one. Patches become faces, those around an end a cap, and all of them a closed shell.

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeSolid.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Interface_FloatWriter.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Writer.hxx>
#include <ShapeFix_Face.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Wire.hxx>
#include <XSControl_WorkSession.hxx>

#include "phrame/io/write/step_patch.hpp"

namespace {

using phrame::StepBody;
using phrame::StepPatch;

/// The size of the box around the body, and the greatest coordinate.
std::pair<double, double> size_of(const StepBody& body) {
  std::array<double, 3> least = body.patches.front().points.front().front();
  std::array<double, 3> greatest = least;
  double farthest = 0;
  for (const StepPatch& patch : body.patches)
    for (const auto& row : patch.points)
      for (const auto& point : row)
        for (std::size_t k = 0; k < 3; ++k) {
          least[k] = std::min(least[k], point[k]);
          greatest[k] = std::max(greatest[k], point[k]);
          farthest = std::max(farthest, std::abs(point[k]));
        }
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) size = std::max(size, greatest[k] - least[k]);
  return {size, farthest};
}

/// Its first parameter is u, around the profile, so that the normal is outward.
TopoDS_Face face_of(const StepPatch& patch, double tolerance) {
  const int rows = static_cast<int>(patch.points.size());
  const int columns = static_cast<int>(patch.points.front().size());
  if (std::max(rows, columns) > Geom_BezierSurface::MaxDegree() + 1)
    throw std::runtime_error("the surface has the degree " + std::to_string(rows - 1) +
                             ", and Open CASCADE has at most " +
                             std::to_string(Geom_BezierSurface::MaxDegree()));
  TColgp_Array2OfPnt points(1, columns, 1, rows);
  TColStd_Array2OfReal weights(1, columns, 1, rows);
  for (int k = 0; k < rows; ++k)
    for (int l = 0; l < columns; ++l) {
      const auto& [x, y, z] =
          patch.points[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)];
      points.SetValue(l + 1, k + 1, gp_Pnt(x, y, z));
      weights.SetValue(l + 1, k + 1,
                       patch.weights[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)]);
    }
  const Handle(Geom_BezierSurface) surface = new Geom_BezierSurface(points, weights);
  BRepBuilderAPI_MakeFace face(surface, tolerance);
  if (!face.IsDone()) throw std::runtime_error("a patch makes no face");
  return face.Face();
}

TopoDS_Shape sewn(const std::vector<TopoDS_Shape>& shapes, double tolerance) {
  BRepBuilderAPI_Sewing sewing(tolerance);
  for (const TopoDS_Shape& shape : shapes) sewing.Add(shape);
  sewing.Perform();
  return sewing.SewedShape();
}

/// The edge of a patch where it starts, or where it ends.
TopoDS_Edge edge_of(const StepPatch& patch, bool is_start) {
  const auto& points = is_start ? patch.points.front() : patch.points.back();
  const auto& weights = is_start ? patch.weights.front() : patch.weights.back();
  const int count = static_cast<int>(points.size());
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal pole_weights(1, count);
  for (int l = 0; l < count; ++l) {
    const auto& [x, y, z] = points[static_cast<std::size_t>(l)];
    poles.SetValue(l + 1, gp_Pnt(x, y, z));
    pole_weights.SetValue(l + 1, weights[static_cast<std::size_t>(l)]);
  }
  const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(poles, pole_weights);
  return BRepBuilderAPI_MakeEdge(curve).Edge();
}

/// The side after the last one of a ring.
std::size_t end_of(const StepBody& body, std::size_t ring) {
  return ring + 1 < body.rings.size() ? body.rings[ring + 1] : body.sides;
}

/// Around a ring of the profile.
TopoDS_Wire wire_of(const StepBody& body, std::size_t ring, bool is_start) {
  const std::size_t first = is_start ? 0 : body.patches.size() - body.sides;
  TopTools_ListOfShape edges;
  for (std::size_t side = body.rings[ring]; side < end_of(body, ring); ++side)
    edges.Append(edge_of(body.patches[first + side], is_start));
  BRepBuilderAPI_MakeWire wire;
  wire.Add(edges);
  if (!wire.IsDone()) throw std::runtime_error("an end of the body makes no wire");
  return wire.Wire();
}

/// A plane face within the outer ring, without what is within the others.
TopoDS_Face cap_of(const StepBody& body, bool is_start) {
  BRepBuilderAPI_MakeFace face(wire_of(body, 0, is_start), Standard_True);
  for (std::size_t ring = 1; face.IsDone() && ring < body.rings.size(); ++ring)
    face.Add(wire_of(body, ring, is_start));
  if (!face.IsDone()) throw std::runtime_error("an end of the body makes no plane face");
  ShapeFix_Face fixed(face.Face());  // the plane may have the wires the other way round
  fixed.FixOrientation();
  return fixed.Face();
}

/// What the faces bound, which is not all the rest of space.
TopoDS_Solid solid_within(const std::vector<TopoDS_Shape>& faces, double tolerance) {
  const TopoDS_Shape shape = sewn(faces, tolerance);
  TopExp_Explorer shells(shape, TopAbs_SHELL);
  if (!shells.More()) throw std::runtime_error("the faces make no shell");
  const TopoDS_Shell shell = TopoDS::Shell(shells.Current());
  shells.Next();
  if (shells.More() || !shell.Closed()) throw std::runtime_error("the faces make no closed shell");
  TopoDS_Solid solid = BRepBuilderAPI_MakeSolid(shell).Solid();
  if (!BRepLib::OrientClosedSolid(solid)) throw std::runtime_error("the faces bound no solid");
  return solid;
}

/// The tubes of a body without ends: what is within the first and not within the others.
TopoDS_Solid hollow_solid(const StepBody& body, const std::vector<TopoDS_Shape>& faces,
                          double tolerance) {
  BRep_Builder builder;
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  for (std::size_t ring = 0; ring < body.rings.size(); ++ring) {
    std::vector<TopoDS_Shape> tube;
    for (std::size_t n = 0; n < faces.size(); ++n) {
      const std::size_t side = n % body.sides;
      if (body.rings[ring] <= side && side < end_of(body, ring)) tube.push_back(faces[n]);
    }
    const TopExp_Explorer shell(solid_within(tube, tolerance), TopAbs_SHELL);
    builder.Add(solid, ring == 0 ? shell.Current() : shell.Current().Reversed());
  }
  return solid;
}

TopoDS_Solid solid_of(const StepBody& body) {
  const auto [size, farthest] = size_of(body);
  const double tolerance = 1e-7 * std::max(size, 1e-3);
  if (!(0x1p-50 * farthest <= tolerance / 10))
    throw std::runtime_error(
        "the body is too far from 0 for its size: doubles are too coarse there");
  std::vector<TopoDS_Shape> faces;
  for (const StepPatch& patch : body.patches) faces.push_back(face_of(patch, tolerance));
  if (!body.is_closed)
    for (const bool is_start : {true, false}) faces.push_back(cap_of(body, is_start));
  const TopoDS_Solid solid =
      body.is_closed ? hollow_solid(body, faces, tolerance) : solid_within(faces, tolerance);
  if (!BRepCheck_Analyzer(solid).IsValid())
    throw std::runtime_error("the body is no valid solid: it meets itself");
  return solid;
}

/// With 17 digits, which are those of a double; Open CASCADE's own way to a file has 13.
std::string bytes_of(STEPControl_Writer& writer) {
  StepData_StepWriter file(writer.Model());
  file.FloatWriter().SetFormat("%.16E");
  file.FloatWriter().SetZeroSuppress(Standard_False);  // which spoils numbers of so many digits
  file.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream stream;
  if (!file.Print(stream)) throw std::runtime_error("the file was not written");
  return std::move(stream).str();
}

std::string step_of(const StepBody& body) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.product.name", "phrame");
  if (writer.Transfer(solid_of(body), STEPControl_ManifoldSolidBrep) != IFSelect_RetDone)
    throw std::runtime_error("the solid was not taken");
  return bytes_of(writer);
}

}  // namespace

extern "C" void phrame_write_step_2(const StepBody& body, std::string& bytes,
                                    std::string& complaint) {
  try {
    bytes = step_of(body);
  } catch (const Standard_Failure& failure) {
    complaint = std::string("Open CASCADE: ") + failure.GetMessageString();
  } catch (const std::exception& error) {
    complaint = error.what();
  }
}
