// The face in the plane: paths through its corners, and paths unfolded over its edges.
#include "mesh/face_distance.h"

#include <algorithm>
#include <cmath>

#include "mesh/unfolded_distance.h"

namespace vorogeo {

double distance_in_face(const Mesh& mesh, Index face, const std::array<double, 3>& weights,
                        const std::array<double, 3>& corner_distance) {
  std::array<double, 3> length{};  // of the edge from corner i to the next
  for (int i = 0; i < 3; ++i) length[i] = mesh.side_length(3 * face + i);
  std::array<double, 3> to_corner{};  // distance of the point from corner i, by edge lengths alone
  for (int i = 0; i < 3; ++i) {
    const double next = weights[(i + 1) % 3];
    const double previous = weights[(i + 2) % 3];
    const double a = length[i] * length[i];
    const double b = length[(i + 2) % 3] * length[(i + 2) % 3];
    const double opposite = length[(i + 1) % 3] * length[(i + 1) % 3];
    const double square = next * next * a + previous * previous * b + next * previous * (a + b - opposite);
    to_corner[i] = std::sqrt(std::fmax(0.0, square));
  }
  double best = unreachable;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    best = std::min(best, corner_distance[i] + to_corner[i]);
    if (!(corner_distance[i] < unreachable && corner_distance[j] < unreachable)) continue;
    double through =
        unfolded_distance(length[i], corner_distance[i], corner_distance[j], to_corner[i], to_corner[j]);
    const double third =
        unfolded_distance(length[i], corner_distance[i], corner_distance[j], length[k], length[j]);
    if (third < corner_distance[k] && corner_distance[k] < unreachable) {
      through += weights[k] * (corner_distance[k] - third);
    }
    best = std::min(best, through);
  }
  return best;
}

}  // namespace vorogeo
