// Computes a distance field by either method and writes it into the layer.
#include "layers/distance_field.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "exact/exact_solver.h"
#include "field/geodesic_query.h"
#include "host/logged_length.h"
#include "host/ticking.h"
#include "layers/index_of_layer.h"
#include "layers/parameters.h"
#include "support/error.h"

namespace vorogeo::plugin {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* distances_activity = "Geodesic distances";

struct Field {
  std::shared_ptr<const Mesh> mesh;
  std::vector<double> distances;
  double seconds = 0.0;
  Results about_index;
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The limit to compute with: `unreachable` stands for none.
double max_distance_of(const FilterCall& call) {
  const double value = call.parameters.getAbsPerc("max_distance");
  if (!std::isfinite(value) || value < 0.0) {
    refuse(call, "max_distance", value,
           ". Give a positive length in the unit of the mesh, or 0 for no limit.");
  }
  return value == 0.0 ? unreachable : value;
}

Field field_by_index(FilterCall& call, const LayerMesh& layer_mesh, const std::vector<Index>& sources,
                     double max_distance) {
  const IndexOfLayer found = index_of_layer(call, layer_mesh);
  Field field;
  field.mesh = found.index->mesh();
  const auto start = Clock::now();
  field.distances = run_ticking(call.progress.part(0.9, 1.0), distances_activity, [&](const Progress&) {
    return GeodesicQuery(found.index).distance_field(sources, max_distance);
  });
  field.seconds = seconds_since(start);
  field.about_index = about_index(found);
  return field;
}

Field field_by_exact_solver(FilterCall& call, const LayerMesh& layer_mesh, const std::vector<Index>& sources,
                            double max_distance) {
  log_warnings(call, layer_mesh);
  const auto start = Clock::now();
  Field field;
  run_ticking(call.progress, "Exact geodesic distances", [&](const Progress& inner) {
    field.mesh = layer_mesh.make_mesh();
    ExactSolver solver(field.mesh);
    ExactLimits limits;
    limits.max_distance = max_distance;
    limits.progress = &inner;
    limits.distances_only = true;
    solver.run_from_vertices(sources, limits);
    field.distances.resize(static_cast<std::size_t>(field.mesh->vertex_count()));
    for (Index v = 0; v < field.mesh->vertex_count(); ++v) {
      field.distances[v] = solver.distance(v) <= max_distance ? solver.distance(v) : unreachable;
    }
  });
  field.seconds = seconds_since(start);
  return field;
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
      document, "max_distance", 0.0, "Max distance",
      "Distances above this length are not computed: those vertices get quality -1. In the unit of "
      "the mesh, or in percent of the diagonal of its bounding box. 0 means no limit.");
}

RichParameterList only_max_distance(const MeshDocument& document) {
  RichParameterList list;
  list.addParam(max_distance_parameter(document));
  return list;
}

namespace {

/// Writes a computed field; `has_source`: by component of its mesh; `at_vertices`: all sources are vertices.
Results write_field(FilterCall& call, const LayerMesh& layer_mesh, Field& field,
                    const std::vector<bool>& has_source, std::size_t source_count, bool at_vertices) {
  const Mesh& mesh = *field.mesh;
  double largest = 0.0;
  int reached = 0;
  int no_path = 0;
  int beyond = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (std::isfinite(field.distances[v])) {
      ++reached;
      largest = std::max(largest, field.distances[v]);
    } else {
      ++(has_source[mesh.component(v)] ? beyond : no_path);
    }
  }
  call.progress.report(1.0, "Writing quality and colours");

  write_distances(call.layer, layer_mesh.arrays().input_of_vertex, field.distances, largest);

  const bool one = source_count == 1;
  const char* sources = at_vertices ? (one ? " source vertex" : " source vertices")
                                    : (one ? " source point" : " source points");
  std::ostringstream text;
  text << "Distances from " << source_count << sources << " to " << reached << " vertices, the largest "
       << logged_length(largest) << ", in " << std::setprecision(3) << field.seconds << " s";
  call.log(text.str());
  if (no_path > 0) {
    call.log("No path leads to " + std::to_string(no_path) +
             " vertices, in other components than the sources; their quality is -1 and their colour grey");
  }
  if (beyond > 0) {
    call.log(std::to_string(beyond) +
             " vertices lie beyond the max distance; their quality is -1 and their colour grey");
  }
  Results results = std::move(field.about_index);
  results["source_vertices"] = static_cast<int>(source_count);
  results["reached_vertices"] = reached;
  results["unreachable_vertices"] = no_path;
  results["vertices_beyond_max_distance"] = beyond;
  results["max_distance"] = largest;
  results["seconds"] = field.seconds;
  return results;
}

}  // namespace

Results write_distance_field(FilterCall& call, const LayerMesh& layer_mesh, const std::vector<Index>& sources,
                             Method method) {
  const double limit = max_distance_of(call);
  Field field = method == Method::index ? field_by_index(call, layer_mesh, sources, limit)
                                        : field_by_exact_solver(call, layer_mesh, sources, limit);
  std::vector<bool> has_source(static_cast<std::size_t>(field.mesh->component_count()), false);
  for (Index source : sources) has_source[field.mesh->component(source)] = true;
  return write_field(call, layer_mesh, field, has_source, sources.size(), true);
}

Results write_distance_field(FilterCall& call, const LayerMesh& layer_mesh,
                             const std::shared_ptr<const Mesh>& mesh, const std::vector<ExactSource>& sources,
                             const std::vector<Index>* numbers, Method method) {
  const double limit = max_distance_of(call);
  Field field;
  field.mesh = mesh;
  LabelledField found;
  if (method == Method::index) {
    const IndexOfLayer index = index_of_layer(call, layer_mesh);
    const auto start = Clock::now();
    found = run_ticking(call.progress.part(0.9, 1.0), distances_activity, [&](const Progress&) {
      return GeodesicQuery(index.index).labelled_field(sources, limit);
    });
    field.seconds = seconds_since(start);
    field.about_index = about_index(index);
  } else {
    log_warnings(call, layer_mesh);
    const auto start = Clock::now();
    run_ticking(call.progress, "Exact geodesic distances", [&](const Progress& inner) {
      ExactSolver solver(mesh);
      ExactLimits limits;
      limits.max_distance = limit;
      limits.progress = &inner;
      limits.distances_only = true;
      solver.run(sources, limits);
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        found.distance.push_back(solver.distance(v));
        found.source.push_back(solver.nearest_source(v));
      }
    });
    field.seconds = seconds_since(start);
  }
  field.distances = std::move(found.distance);
  std::vector<bool> has_source(static_cast<std::size_t>(mesh->component_count()), false);
  for (const ExactSource& source : sources) {
    const SurfacePoint& p = source.point;
    has_source[mesh->component(p.is_vertex() ? p.vertex : mesh->face_vertices(p.face)[0])] = true;
  }
  Results results = write_field(call, layer_mesh, field, has_source, sources.size(), false);
  if (numbers != nullptr) {
    auto label = vcg::tri::Allocator<CMeshO>::GetPerVertexAttribute<Scalarm>(call.layer.cm, "nearest_source");
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const Index source = found.source[v];
      label[call.layer.cm.vert[layer_mesh.host_vertex(v)]] =
          static_cast<Scalarm>(source == no_index ? no_index : (*numbers)[source]);
    }
  }
  results["source_points"] = results["source_vertices"];
  results.erase("source_vertices");
  return results;
}

}  // namespace vorogeo::plugin
