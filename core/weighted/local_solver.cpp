// The choice of the solver.
#include "weighted/local_solver.h"

namespace vorogeo {

namespace {

std::variant<ExactSolver, WeightedSolver> solver_of(const LocalGeometry& geometry) {
  if (geometry.windows) return ExactSolver(geometry.windows);
  return WeightedSolver(geometry.norms);
}

}  // namespace

LocalGeometry::LocalGeometry(std::shared_ptr<const Mesh> shared_mesh, std::span<const Index> added)
    : mesh(std::move(shared_mesh)) {
  if (mesh->metric_jumps()) {
    norms = std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge());
    return;
  }
  auto frames = std::make_shared<ExactGeometry>(mesh);
  for (const Index vertex : added) frames->can_bend[vertex] = ExactGeometry::never;
  windows = std::move(frames);
}

std::size_t LocalGeometry::memory_bytes() const {
  return windows ? windows->memory_bytes() : norms->memory_bytes();
}

LocalSolver::LocalSolver(const std::shared_ptr<const LocalGeometry>& geometry)
    : solver_(solver_of(*geometry)) {}
LocalSolver::LocalSolver(std::shared_ptr<const Mesh> mesh)
    : solver_(solver_of(LocalGeometry(std::move(mesh)))) {}

}  // namespace vorogeo
