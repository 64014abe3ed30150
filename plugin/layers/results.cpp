// What filters leave behind: distances as vertex quality, and new layers.
#include "layers/results.h"

#include <vcg/complex/allocate.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "host/edit_host.h"
#include "layers/parameters.h"
#include "support/error.h"

namespace vorogeo::plugin {

// ---- Computes a distance field and writes it into the layer

namespace {

/// The limit to compute with: `unreachable` stands for none.
double max_distance_of(const FilterCall& call) {
  const double value = call.parameters.getAbsPerc("max_distance");
  if (!std::isfinite(value) || value < 0.0) {
    refuse(call, "max_distance", value,
           ". Give a positive length in the unit of the mesh, or 0 for no limit.");
  }
  return value == 0.0 ? unreachable : value;
}

}  // namespace

vcg::Color4b color_of_distance(double distance, double largest) {
  if (!std::isfinite(distance)) return {160, 160, 160, 255};
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

RichLength max_distance_parameter(const MeshDocument& document) {
  return length_parameter(
      document, "max_distance", 0.0, "Max distance (0: no limit)",
      "Distances above this length are not computed: those vertices get quality -1. In the unit of the mesh, "
      "or in percent of the diagonal of its bounding box.");
}

RichParameterList only_max_distance(const MeshDocument& document) {
  RichParameterList list;
  list.addParam(max_distance_parameter(document));
  return list;
}

void add_field_parameters(RichParameterList& list, const MeshDocument& document) {
  list.addParam(method_parameter());
  list.addParam(max_distance_parameter(document));
}

namespace {

/// Computes a field and writes it. `at_vertices`: all sources are vertices.
Results write_field(FilterCall& call, LayerSurface& layer, const std::vector<ExactSource>& sources,
                    AnswerMethod method, bool at_vertices, std::vector<Index>& nearest) {
  const double limit = max_distance_of(call);
  const auto shared_mesh = layer.mesh();
  const Mesh& mesh = *shared_mesh;
  const auto ask = [&](Surface& surface, Answered& answered, const Progress& progress) {
    return surface.field(sources, limit, method, answered, progress);
  };
  auto [field, by, seconds, results] = ask_surface(call, layer, "Geodesic distances", ask);
  std::vector<bool> has_source(static_cast<std::size_t>(mesh.component_count()), false);
  for (const ExactSource& source : sources) {
    const SurfacePoint& p = source.point;
    has_source[mesh.component(p.is_vertex() ? p.vertex : mesh.face_vertices(p.face)[0])] = true;
  }
  double largest = 0.0;
  int reached = 0;
  int no_path = 0;
  int beyond = 0;
  field.distance.resize(mesh.given_vertex_count());
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    if (std::isfinite(field.distance[v])) {
      ++reached;
      largest = std::max(largest, field.distance[v]);
    } else {
      ++(has_source[mesh.component(v)] ? beyond : no_path);
    }
  }
  if (by == AnswerMethod::exact && reached > max_vertices_kept) layer.rest();
  call.progress.report(1.0, "Writing quality and colours");

  write_distances(call.layer, layer.arrays().input_of_vertex, field.distance, largest);

  const bool one = sources.size() == 1;
  const char* kind = at_vertices ? (one ? " source vertex" : " source vertices")
                                 : (one ? " source point" : " source points");
  std::ostringstream text;
  text << "Distances from " << sources.size() << kind << " to " << reached << " vertices, the largest "
       << logged_length(largest) << ", in " << std::setprecision(3) << seconds << " s";
  call.log(text.str());
  if (no_path > 0) {
    call.log("No path leads to " + std::to_string(no_path) +
             " vertices, in other components than the sources; their quality is -1 and their colour grey");
  }
  if (beyond > 0) {
    call.log(std::to_string(beyond) +
             " vertices lie beyond the max distance; their quality is -1 and their colour grey");
  }
  nearest = std::move(field.source);
  results["source_vertices"] = static_cast<int>(sources.size());
  results["reached_vertices"] = reached;
  results["unreachable_vertices"] = no_path;
  results["vertices_beyond_max_distance"] = beyond;
  results["max_distance"] = largest;
  results["seconds"] = seconds;
  return results;
}

}  // namespace

Results write_distance_field(FilterCall& call, LayerSurface& layer, const std::vector<Index>& sources,
                             AnswerMethod method) {
  std::vector<ExactSource> points;
  points.reserve(sources.size());
  for (Index source : sources) points.push_back({SurfacePoint::at_vertex(source)});
  std::vector<Index> nearest;
  return write_field(call, layer, points, method, true, nearest);
}

Results write_distance_field(FilterCall& call, LayerSurface& layer, const std::vector<ExactSource>& sources,
                             const std::vector<Index>* numbers, AnswerMethod method) {
  std::vector<Index> nearest;
  Results results = write_field(call, layer, sources, method, false, nearest);
  if (numbers != nullptr) {
    auto label = vcg::tri::Allocator<CMeshO>::GetPerVertexAttribute<Scalarm>(call.layer.cm, "nearest_source");
    for (Index v = 0; v < static_cast<Index>(layer.arrays().positions.size()); ++v) {
      label[call.layer.cm.vert[layer.host_vertex(v)]] =
          static_cast<Scalarm>(nearest[v] == no_index ? no_index : (*numbers)[nearest[v]]);
    }
  }
  results["source_points"] = results["source_vertices"];
  results.erase("source_vertices");
  return results;
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

void add_point_layer(FilterCall& call, const QString& name, const std::vector<Point>& points,
                     std::span<const double> quality, bool make_current) {
  new_layer(call.document, call.layer, name, points, quality, make_current);
}

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
  add_point_layer(call, name, positions, {}, true);
  return as_vector(numbers);
}

}  // namespace vorogeo::plugin
