// SPDX-License-Identifier: GPL-3.0-or-later
// OpenCASCADE: hidden-line removal of a shell with an edge along every row of the grid.
//
//   occ poly|exact DEM.heights OUTPUT.txt ELEVATION_DEG
//
// poly:  HLRBRep_PolyAlgo on a face with its triangles for every two rows
// exact: HLRBRep_Algo on a planar face for every triangle (so its columns and diagonals are drawn
//        as well)
// Writes visible edges as text, `x y` a line in metres, an empty line between edges.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_Line.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <HLRBRep_PolyHLRToShape.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <cmath>
#include <cstring>
#include <initializer_list>
#include <vector>

#include "heights.h"

namespace {

constexpr double kTolerance_m = 1e-3;

gp_Pnt vertex_m(const heights& h, int column, int row) {
  return {column * h.column_step_m, row * h.row_step_m,
          static_cast<double>(
              h.z_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(h.columns) +
                    static_cast<std::size_t>(column)])};
}

TopoDS_Edge straight(const TopoDS_Vertex& a, const TopoDS_Vertex& b) {
  const gp_Pnt from = BRep_Tool::Pnt(a), to = BRep_Tool::Pnt(b);
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, new Geom_Line(from, gp_Dir(gp_Vec(from, to))), kTolerance_m);
  builder.Add(edge, a.Oriented(TopAbs_FORWARD));
  builder.Add(edge, b.Oriented(TopAbs_REVERSED));
  builder.Range(edge, 0, from.Distance(to));
  return edge;
}

// Nodes of the southern row, then of the northern one.
Handle(Poly_Triangulation) strip_between(const heights& h, int south) {
  const int n = h.columns;
  Handle(Poly_Triangulation) strip = new Poly_Triangulation(2 * n, 2 * (n - 1), true);
  for (int c = 0; c < n; ++c) {
    strip->SetNode(c + 1, vertex_m(h, c, south));
    strip->SetUVNode(c + 1, gp_Pnt2d(c, 0));
    strip->SetNode(n + c + 1, vertex_m(h, c, south + 1));
    strip->SetUVNode(n + c + 1, gp_Pnt2d(c, 1));
  }
  for (int c = 1; c < n; ++c) { // diagonals from north-west to south-east
    strip->SetTriangle(2 * c - 1, Poly_Triangle(c, c + 1, n + c));
    strip->SetTriangle(2 * c, Poly_Triangle(c + 1, n + c + 1, n + c));
  }
  return strip;
}

// A surface that isn't a plane: of planes it takes one normal for all triangles.
Handle(Geom_Surface) surface_between(const heights& h, int south) {
  const int n = h.columns;
  TColgp_Array2OfPnt poles(1, n, 1, 2);
  TColStd_Array1OfReal across(1, n), along(1, 2);
  TColStd_Array1OfInteger across_times(1, n), along_times(1, 2);
  across_times.Init(1);
  across_times.ChangeFirst() = across_times.ChangeLast() = 2;
  along_times.Init(2);
  along.SetValue(1, 0);
  along.SetValue(2, 1);
  for (int c = 0; c < n; ++c) {
    across.SetValue(c + 1, c);
    poles.SetValue(c + 1, 1, vertex_m(h, c, south));
    poles.SetValue(c + 1, 2, vertex_m(h, c, south + 1));
  }
  return new Geom_BSplineSurface(poles, across, along, across_times, along_times, 1, 1);
}

// Along a row or a side, by the number of the point.
TopoDS_Edge polyline(const TopoDS_Vertex& a, const TopoDS_Vertex& b,
                     const std::vector<gp_Pnt>& points) {
  const int n = static_cast<int>(points.size());
  TColgp_Array1OfPnt poles(1, n);
  TColStd_Array1OfReal knots(1, n);
  TColStd_Array1OfInteger times(1, n);
  times.Init(1);
  times.ChangeFirst() = times.ChangeLast() = 2;
  for (int i = 0; i < n; ++i) {
    poles.SetValue(i + 1, points[static_cast<std::size_t>(i)]);
    knots.SetValue(i + 1, i);
  }
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, new Geom_BSplineCurve(poles, knots, times, 1), kTolerance_m);
  builder.Add(edge, a.Oriented(TopAbs_FORWARD));
  builder.Add(edge, b.Oriented(TopAbs_REVERSED));
  builder.Range(edge, 0, n - 1);
  return edge;
}

// An edge's place on a strip: from node `first` every `step`, and where that is on the surface.
struct Place {
  int first, count, step;
  gp_Pnt2d at;
  gp_Dir2d along;
};

void put(const TopoDS_Edge& edge, const Place& place, const TopoDS_Face& face,
         const Handle(Poly_Triangulation) & triangles) {
  TColStd_Array1OfInteger nodes(1, place.count);
  TColStd_Array1OfReal parameters(1, place.count);
  for (int i = 0; i < place.count; ++i) {
    nodes.SetValue(i + 1, place.first + i * place.step);
    parameters.SetValue(i + 1, i);
  }
  const BRep_Builder builder;
  builder.UpdateEdge(edge, new Geom2d_Line(place.at, place.along), face, kTolerance_m);
  builder.UpdateEdge(edge, new Poly_PolygonOnTriangulation(nodes, parameters), triangles,
                     TopLoc_Location());
}

TopoDS_Shell strips(const heights& h) {
  const BRep_Builder builder;
  std::vector<TopoDS_Vertex> west(static_cast<std::size_t>(h.rows)), east(west);
  std::vector<TopoDS_Edge> along(west.size());
  for (int r = 0; r < h.rows; ++r) {
    const auto i = static_cast<std::size_t>(r);
    builder.MakeVertex(west[i], vertex_m(h, 0, r), kTolerance_m);
    builder.MakeVertex(east[i], vertex_m(h, h.columns - 1, r), kTolerance_m);
    std::vector<gp_Pnt> points;
    for (int c = 0; c < h.columns; ++c) points.push_back(vertex_m(h, c, r));
    along[i] = polyline(west[i], east[i], points);
  }
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  for (int r = 0; r + 1 < h.rows; ++r) {
    const auto i = static_cast<std::size_t>(r);
    const Handle(Poly_Triangulation) triangles = strip_between(h, r);
    TopoDS_Face face;
    builder.MakeFace(face, surface_between(h, r), kTolerance_m);
    builder.UpdateFace(face, triangles);
    const int n = h.columns;
    const auto side = [&](const std::vector<TopoDS_Vertex>& v) {
      return polyline(v[i], v[i + 1], {BRep_Tool::Pnt(v[i]), BRep_Tool::Pnt(v[i + 1])});
    };
    const TopoDS_Edge east_side = side(east), west_side = side(west);
    put(along[i], {1, n, 1, {0, 0}, {1, 0}}, face, triangles);
    put(along[i + 1], {n + 1, n, 1, {0, 1}, {1, 0}}, face, triangles);
    put(east_side, {n, 2, n, {n - 1.0, 0}, {0, 1}}, face, triangles);
    put(west_side, {1, 2, n, {0, 0}, {0, 1}}, face, triangles);
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    builder.Add(wire, along[i]);
    builder.Add(wire, east_side);
    builder.Add(wire, along[i + 1].Reversed());
    builder.Add(wire, west_side.Reversed());
    builder.Add(face, wire);
    builder.Add(shell, face);
  }
  return shell;
}

TopoDS_Shell planar_triangles(const heights& h) {
  const BRep_Builder builder;
  const auto index = [&](int c, int r) {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(h.columns) +
           static_cast<std::size_t>(c);
  };
  std::vector<TopoDS_Vertex> vertices(index(0, h.rows));
  for (int r = 0; r < h.rows; ++r)
    for (int c = 0; c < h.columns; ++c)
      builder.MakeVertex(vertices[index(c, r)], vertex_m(h, c, r), kTolerance_m);
  std::vector<TopoDS_Edge> east(vertices.size()), north(vertices.size()), diagonal(vertices.size());
  for (int r = 0; r < h.rows; ++r)
    for (int c = 0; c < h.columns; ++c) {
      const TopoDS_Vertex& v = vertices[index(c, r)];
      if (c + 1 < h.columns) east[index(c, r)] = straight(v, vertices[index(c + 1, r)]);
      if (r + 1 < h.rows) north[index(c, r)] = straight(v, vertices[index(c, r + 1)]);
      if (c > 0 && r + 1 < h.rows)
        diagonal[index(c, r)] = straight(v, vertices[index(c - 1, r + 1)]);
    }
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  const auto add = [&](const TopoDS_Shape& a, const TopoDS_Shape& b, const TopoDS_Shape& c) {
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    for (const TopoDS_Shape& edge : {a, b, c}) builder.Add(wire, edge);
    builder.Add(shell, BRepBuilderAPI_MakeFace(wire, true).Face());
  };
  for (int r = 0; r + 1 < h.rows; ++r)
    for (int c = 0; c + 1 < h.columns; ++c) {
      const TopoDS_Edge& slope = diagonal[index(c + 1, r)];
      add(east[index(c, r)], slope, north[index(c, r)].Reversed());
      add(north[index(c + 1, r)], east[index(c, r + 1)].Reversed(), slope.Reversed());
    }
  return shell;
}

void write_edges(const TopoDS_Shape& edges, std::FILE* file) {
  if (edges.IsNull()) return;
  for (TopExp_Explorer edge(edges, TopAbs_EDGE); edge.More(); edge.Next()) {
    for (TopExp_Explorer end(edge.Current(), TopAbs_VERTEX); end.More(); end.Next()) {
      const gp_Pnt at = BRep_Tool::Pnt(TopoDS::Vertex(end.Current()));
      std::fprintf(file, "%.9g %.9g\n", at.X(), at.Y());
    }
    std::fputc('\n', file);
  }
}

} // namespace

int main(int count, char** arguments) {
  if (count != 5) {
    std::fputs("usage: occ poly|exact DEM.heights OUTPUT.txt ELEVATION_DEG\n", stderr);
    return 2;
  }
  const heights h = read_heights(arguments[2]);
  const double elevation = std::atof(arguments[4]) * std::acos(-1.0) / 180;
  // Towards the eye, and to the right.
  const HLRAlgo_Projector projector(gp_Ax2(
      gp_Pnt(0, 0, 0), gp_Dir(0, -std::cos(elevation), std::sin(elevation)), gp_Dir(1, 0, 0)));
  std::FILE* const file = std::fopen(arguments[3], "w");
  if (!file) {
    std::perror(arguments[3]);
    return 1;
  }
  try {
    if (std::strcmp(arguments[1], "poly") == 0) {
      Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo();
      algorithm->Projector(projector);
      algorithm->Load(strips(h));
      algorithm->Update();
      HLRBRep_PolyHLRToShape result;
      result.Update(algorithm);
      write_edges(result.VCompound(), file);
      write_edges(result.Rg1LineVCompound(), file);
      write_edges(result.OutLineVCompound(), file);
    } else {
      Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo();
      algorithm->Add(planar_triangles(h));
      algorithm->Projector(projector);
      algorithm->Update();
      algorithm->Hide();
      HLRBRep_HLRToShape result(algorithm);
      write_edges(result.VCompound(), file);
    }
  } catch (const Standard_Failure& failure) {
    std::fprintf(stderr, "occ: error: %s: %s\n", failure.DynamicType()->Name(),
                 failure.GetMessageString());
    return 1;
  }
  return std::fclose(file) == 0 ? 0 : 1;
}
