// A first field: the distance of every vertex from one, and from the nearest of three.
#include <vorogeo.h>

#include <algorithm>
#include <cstdio>

#include "sheet.h"

int main() {
  const Sheet sheet(64);
  const vorogeo::Surface surface(sheet.positions, sheet.faces);

  const std::vector<double> distance = surface.distances_from(0);
  double error = 0.0;
  for (int v = 0; v < surface.vertex_count(); ++v) {
    error = std::max(error, std::abs(distance[v] - sheet.flat_distance(0, v)));
  }
  std::printf("the far corner is %.9f away, no distance off by more than %.1e\n", distance.back(), error);

  // Sources are vertices or any points of the surface; each may begin with a distance of its own.
  const vorogeo::Field field = surface.field({0, 64, surface.snap({0.5, 1.0, 0.0})},
                                             {.limit = 0.5, .labels = true, .offsets = {0.0, 0.1, 0.0}});
  std::printf("%ld vertices are nearest to the second source\n",
              static_cast<long>(std::count(field.label.begin(), field.label.end(), 1)));
  return error < 1e-9 ? 0 : 1;
}
