// A shortest path between two places in space, written as a polyline that MeshLab and others open.
#include <vorogeo.h>

#include <cstdio>
#include <fstream>

#include "sheet.h"

int main(int argc, char** argv) {
  const Sheet sheet(64);
  const vorogeo::Surface surface(sheet.positions, sheet.faces);
  const vorogeo::SurfacePoint from = surface.snap({0.0, 0.0, 0.0});
  const vorogeo::SurfacePoint to = surface.snap({1.0, 1.0, 0.0});  // the nearest point is the far corner

  const vorogeo::Path path = surface.path(from, to, {.exact = true});
  std::printf("%.9f long, over %zu points, %s\n", path.length, path.points.size(),
              path.certified ? "proven to be the shortest" : "not proven");

  std::ofstream obj(argc > 1 ? argv[1] : "path.obj");
  for (const auto& [x, y, z] : path.points) obj << "v " << x << ' ' << y << ' ' << z << '\n';
  obj << 'l';
  for (std::size_t i = 1; i <= path.points.size(); ++i) obj << ' ' << i;
  obj << '\n';
  return path.certified && std::abs(path.length - std::sqrt(2.0)) < 1e-9 && obj.flush() ? 0 : 1;
}
