// Patches and border distances of end points.
#include "path/path_ends.h"

#include <algorithm>
#include <array>

#include "index/local_tables.h"
#include "index/work_points.h"
#include "mesh/face_distance.h"
#include "path/path_chain.h"

namespace vorogeo {

PathEnd path_end(const IndexData& data, const SurfacePoint& user) {
  const Mesh& mesh = *data.work.mesh;
  PathEnd end;
  end.point = work_point(data, user);
  end.user = user;
  if (end.point.is_vertex()) {
    end.vertex = end.point.vertex;
  } else {
    const auto distances = distances_in_face(mesh, end.point);
    const auto nearest = std::ranges::min_element(distances);
    end.to_vertex = *nearest;
    end.vertex = mesh.face_vertices(end.point.face)[nearest - distances.begin()];
  }
  for_each_face_at(mesh, end.point, [&](Index face, const std::array<double, 3>&) {
    const Index patch = data.work.second_layer[face];
    if (std::ranges::find(end.patches, patch) == end.patches.end()) end.patches.push_back(patch);
  });
  return end;
}

bool are_near(const IndexData& data, const PathEnd& a, const PathEnd& b) {
  auto is_of_b = [&](Index p) { return std::ranges::find(b.patches, p) != b.patches.end(); };
  return std::ranges::any_of(a.patches, [&](Index p) {
    return is_of_b(p) || std::ranges::any_of(data.second.touching.of(p), is_of_b);
  });
}

RouteEnd route_end_of(const IndexData& data, const PathEnd& end) {
  RouteEnd result;
  if (end.point.is_vertex()) {
    route_end(data, end.vertex, result);
    return result;
  }
  result.patch = end.patch(data);
  const auto nodes = data.second.nodes(result.patch);
  result.parents.push_back(data.partition.parent[result.patch]);
  const Mesh& mesh = *data.work.mesh;
  std::array<Index, 3> column{};
  for (int k = 0; k < 3; ++k) {
    column[k] = data.column_in_patch(result.patch, mesh.face_vertices(end.point.face)[k]);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    std::array<double, 3> corners{};
    for (int k = 0; k < 3; ++k) {
      corners[k] = data.second.distance(result.patch, static_cast<Index>(i), column[k]);
    }
    const double distance = distance_in_face(mesh, end.point.face, end.point.barycentric, corners);
    if (distance < unreachable) result.seeds.push_back({nodes[i], distance});
  }
  return result;
}

}  // namespace vorogeo
