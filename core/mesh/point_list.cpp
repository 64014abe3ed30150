// Checks of point lists.
#include "mesh/point_list.h"

#include <algorithm>
#include <string>

#include "support/error.h"

namespace vorogeo {

bool PointList::only_vertices() const {
  return std::ranges::all_of(points_, [](const SurfacePoint& point) { return point.is_vertex(); });
}

std::vector<Index> PointList::vertices() const {
  std::vector<Index> result;
  result.reserve(points_.size());
  for (const SurfacePoint& point : points_) result.push_back(point.vertex);
  return result;
}

PointList points_on(const Mesh& mesh, const PointList& points, const char* role) {
  std::vector<SurfacePoint> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& point = points[i];
    const std::string name = std::string(role) + " " + std::to_string(i);
    if (point.face == no_index && (point.vertex < 0 || point.vertex >= mesh.vertex_count())) {
      throw InvalidInput(name + " is vertex " + std::to_string(point.vertex) +
                         ", which does not exist: the mesh has vertices 0 to " +
                         std::to_string(mesh.vertex_count() - 1) + ".");
    }
    try {
      result.push_back(canonical(mesh, validated(mesh, point)));
    } catch (const InvalidInput& error) {
      throw InvalidInput(name + " is not on the mesh. " + error.what());
    }
  }
  return result;
}

}  // namespace vorogeo
