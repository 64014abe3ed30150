// Edges that the front has passed drop their windows, where only distances of vertices are wanted.
#include "exact/solver_state.h"

namespace vorogeo {

std::int64_t ExactSolver::State::closing_bucket(double distance) const {
  constexpr auto greatest = static_cast<double>(TimingWheel<ClosingEdge>::greatest_bucket / 2);
  return static_cast<std::int64_t>(std::min(distance / closing_width, greatest));
}

void ExactSolver::State::close_edges_at(Index vertex) {
  // By paths along the edge alone, each of its points is no farther than half the sum of the ends' distances
  // and the edge's length.
  auto close_later = [&](Index edge) {
    if (territories != nullptr && territories->of_edge[edge] != number) return;
    const auto [a, b] = mesh.edge_vertices(edge);
    const double bound = 0.5 * (vertices[a].distance + vertices[b].distance + mesh.edge_length(edge));
    if (bound < unreachable)
      closing.add({std::max(closing.current(), closing_bucket(bound * (1.0 + 1e-12))), edge});
  };
  for (Index corner : mesh.corners(vertex)) {
    close_later(mesh.edge_of(corner));
    close_later(mesh.edge_of(Mesh::previous_in_face(corner)));
  }
}

void ExactSolver::State::close_edges_behind(double front) {
  // A bound whose bucket lies before that of the front is below the front.
  const std::int64_t bucket = closing_bucket(front);
  if (bucket <= closed_before) return;
  closed_before = bucket;
  while (closing.least_bucket() < bucket) {
    closing.advance();
    while (closing.has_current()) envelope.retire(closing.take().edge);
  }
}

}  // namespace vorogeo
