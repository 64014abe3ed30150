// What filters leave behind: distances as vertex quality, and new layers.
#include "layers/results.h"

#include <vcg/complex/allocate.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace vorogeo::plugin {

// ---- Distances as quality and colours

vcg::Color4b color_of_distance(double distance, double largest) {
  if (!std::isfinite(distance)) return grey();
  vcg::Color4b color;
  color.SetColorRamp(0.0F, static_cast<float>(largest), static_cast<float>(distance));
  return color;
}

void write_distances(MeshModel& layer, std::span<const Index> host_vertices,
                     std::span<const double> distances, double largest) {
  layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
  for (std::size_t v = 0; v < distances.size(); ++v) {
    CVertexO& vertex = layer.cm.vert[static_cast<std::size_t>(host_vertices[v])];
    vertex.Q() = static_cast<Scalarm>(std::isfinite(distances[v]) ? distances[v] : quality_without_distance);
    vertex.C() = color_of_distance(distances[v], largest);
  }
}

// ---- Fills new layers of the document

namespace {

MeshModel& new_layer(MeshDocument& document, const MeshModel& on, const QString& name,
                     const std::vector<Point>& points, std::span<const double> quality, bool make_current) {
  MeshModel& layer = *document.addNewMesh("", name, make_current);
  layer.cm.Tr = on.cm.Tr;
  if (!points.empty()) vcg::tri::Allocator<CMeshO>::AddVertices(layer.cm, points.size());
  if (!quality.empty()) layer.updateDataMask(MeshModel::MM_VERTQUALITY);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    layer.cm.vert[i].P() =
        Point3m(static_cast<Scalarm>(p[0]), static_cast<Scalarm>(p[1]), static_cast<Scalarm>(p[2]));
    if (!quality.empty()) layer.cm.vert[i].Q() = static_cast<Scalarm>(quality[i]);
    layer.cm.bbox.Add(layer.cm.vert[i].P());
  }
  return layer;
}

}  // namespace

void add_polyline_layer(MeshDocument& document, const MeshModel& on, const QString& name,
                        const SurfaceLines& lines, std::span<const double> quality, bool make_current) {
  MeshModel& layer = new_layer(document, on, name, lines.points, quality, make_current);
  if (lines.segments.empty()) return;
  vcg::tri::Allocator<CMeshO>::AddEdges(layer.cm, lines.segments.size());
  for (std::size_t i = 0; i < lines.segments.size(); ++i) {
    layer.cm.edge[i].V(0) = &layer.cm.vert[lines.segments[i][0]];
    layer.cm.edge[i].V(1) = &layer.cm.vert[lines.segments[i][1]];
  }
}

QVariant add_surface_point_layer(FilterCall& call, const QString& name, const LayerSurface& layer,
                                 const Mesh& mesh, const PointList& points) {
  std::vector<Point> positions;
  std::vector<int> numbers;
  for (const SurfacePoint& point : points) {
    positions.push_back(position_of(mesh, point));
    numbers.push_back(point.is_vertex() ? layer.host_vertex(point.vertex) : -1);
  }
  new_layer(call.document, call.layer, name, positions, {}, true);
  return as_vector(numbers);
}

std::string logged_length(double length) {
  std::ostringstream text;
  text << std::setprecision(7) << length << " mesh units";
  return text.str();
}

}  // namespace vorogeo::plugin
