// Points of a mesh in numpy arrays.
#include "mesh_points.h"

#include <string>

#include "arrays.h"
#include "exact/exact_solver.h"
#include "path_arrays.h"
#include "tasks/curve_sources.h"

namespace vorogeo::python {

nb::tuple MeshPoints::snap(const VertexArray& points) {
  PointRows rows;
  std::vector<double> distances(points.shape(0));
  {
    nb::gil_scoped_release release;
    const SurfaceLocator& on_surface = locator();
    for (std::size_t i = 0; i < distances.size(); ++i) {
      const double* p = points.data() + 3 * i;
      const SnappedPoint found = on_surface.nearest({p[0], p[1], p[2]});
      distances[i] = found.distance;
      rows.add(mesh(), found.point);
    }
  }
  return nb::make_tuple(to_numpy(std::move(rows.face)), to_numpy(std::move(rows.weights)),
                        to_numpy(std::move(distances)));
}

nb::tuple MeshPoints::along_edges(const EdgeArray& ends, double spacing) const {
  std::vector<Index> edges;
  for (std::size_t i = 0; i < ends.shape(0); ++i) {
    const auto parts =
        edges_between(mesh(), mesh().representative(ends(i, 0)), mesh().representative(ends(i, 1)));
    if (parts.empty()) {
      throw InvalidInput("There is no edge between vertex " + std::to_string(ends(i, 0)) + " and vertex " +
                         std::to_string(ends(i, 1)) + "; a curve runs along edges of the mesh.");
    }
    edges.insert(edges.end(), parts.begin(), parts.end());
  }
  PointRows rows;
  const double wanted = spacing > 0.0 ? spacing : 0.25 * mesh().typical_edge_length();
  for (const ExactSource& source : sources_along_edges(mesh(), edges, wanted)) rows.add(mesh(), source.point);
  return nb::make_tuple(to_numpy(std::move(rows.vertex)), to_numpy(std::move(rows.face)),
                        to_numpy(std::move(rows.weights)));
}

nb::tuple MeshPoints::path_arrays(const std::vector<ExactPath>& found) const {
  PathArrays arrays(mesh());
  for (const ExactPath& one : found) arrays.add(one.path, one.certified);
  return arrays.take();
}

const SurfaceLocator& MeshPoints::locator() {
  const std::lock_guard lock(mutex_);
  if (!locator_) locator_ = std::make_unique<SurfaceLocator>(mesh_);
  return *locator_;
}

}  // namespace vorogeo::python
