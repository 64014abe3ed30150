// Meshes, points on them, metrics and checks.
#pragma once

#include <nanobind/nanobind.h>

#include <memory>
#include <mutex>
#include <vector>

#include "arrays.h"
#include "mesh/surface_locator.h"
#include "query/path_query.h"

namespace vorogeo::python {

// ---- Points of a mesh between Python and the core: moved to the surface, along edges, and those of paths

using EdgeArray = nb::ndarray<const Index, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using ValueArray = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// What can be asked about points of a mesh without distances. May be used by several threads.
class MeshPoints {
 public:
  explicit MeshPoints(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {}

  const Mesh& mesh() const { return *mesh_; }

  /// Nearest points of the surface: faces, weights, distances.
  nb::tuple snap(const VertexArray& points);
  /// Points along the edges between pairs of vertices, at most `spacing` apart; 0: a quarter of the typical
  /// edge. \throw InvalidInput if the mesh has no such edge.
  nb::tuple along_edges(const EdgeArray& ends, double spacing) const;
  /// Paths as lengths, certified, where the points of each begin, positions, vertices, faces, weights.
  nb::tuple path_arrays(const std::vector<ExactPath>& found) const;

 private:
  const SurfaceLocator& locator();

  std::shared_ptr<const Mesh> mesh_;
  std::mutex mutex_;
  std::unique_ptr<SurfaceLocator> locator_;
};

// ---- The functions of _core about a mesh: its check, and what an index would cost

void bind_mesh_functions(nanobind::module_& module);

// ---- Lengths of edges by costs and tensors, and metrics that follow from the shape

void bind_metrics(nanobind::module_& module);

}  // namespace vorogeo::python
