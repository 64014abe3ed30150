// Edges that the front has passed drop their windows, where only distances of vertices are wanted.
#include "exact/solver_state.h"

namespace vorogeo {

void ExactSolver::State::close_edges_at(Index vertex) {
  // By paths along the edge alone, each of its points is no farther than half the sum of the ends' distances
  // and the edge's length.
  auto close_later = [&](Index edge) {
    if (territories != nullptr && territories->of_edge[edge] != number) return;
    const auto [a, b] = mesh.edge_vertices(edge);
    const double bound = 0.5 * (vertices[a].distance + vertices[b].distance + mesh.edge_length(edge));
    if (bound < unreachable) closing.emplace_back(bound * (1.0 + 1e-12), edge);
  };
  for (Index corner : mesh.corners(vertex)) {
    close_later(mesh.edge_of(corner));
    close_later(mesh.edge_of(Mesh::previous_in_face(corner)));
  }
}

void ExactSolver::State::close_edges_behind(double front) {
  for (; !closing.empty() && closing.front().first < front; closing.pop_front()) {
    envelope.retire(closing.front().second);
  }
}

}  // namespace vorogeo
