// What an index consists of, and points of the user's mesh in its work mesh and back.
#include "index/index_data.h"

#include <algorithm>

#include "patches/halo.h"
#include "support/processor.h"
#include "support/progress.h"

namespace vorogeo {

// ---- What follows from the layout of both layers together

const UnsplitSurface* IndexData::unsplit() const {
  if (!UnsplitSurface::is_worthwhile(work)) return nullptr;
  std::call_once(unsplit_made_,
                 [&] { unsplit_ = std::make_unique<const UnsplitSurface>(mesh, work, partition); });
  return unsplit_.get();
}

void IndexData::link_layers() {
  parent_column.assign(second.border_node.size(), no_index);
  std::vector<Index> column(work.mesh->vertex_count(), no_index);
  Index last_parent = no_index;
  // Patches of one parent are consecutive.
  for (Index p = 0; p < second.patch_count; ++p) {
    checkpoint();
    const Index parent = partition.parent[p];
    if (parent != last_parent) {
      const auto members = first.members(parent);
      for (std::size_t i = 0; i < members.size(); ++i) column[members[i]] = static_cast<Index>(i);
      last_parent = parent;
    }
    const auto nodes = second.nodes(p);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      parent_column[second.border_begin[p] + i] = column[second.node_vertex[nodes[i]]];
    }
  }

  const Mesh& mesh_of_work = *work.mesh;
  first_face = first_faces(work.second_layer, second.patch_count);
  first_child = first_faces(partition.parent, first.patch_count);
  second_node.reserve(first.node_count());
  for (Index vertex : first.node_vertex) second_node.push_back(second.vertex_node[vertex]);
  node_position.reserve(second.node_count());
  for (Index vertex : second.node_vertex) node_position.push_back(mesh_of_work.position(vertex));
  for (Index e = 0; e < mesh_of_work.edge_count() && !has_branches; ++e) {
    if (e % elements_per_checkpoint == 0) checkpoint();
    has_branches = mesh_of_work.edge_face_count(e) > 2;
  }
}

// ---- Barycentric weights of work vertices in faces of the user's mesh, and their inverse

namespace {

using Weights = std::array<double, 3>;

/// Weights below this are rounding.
constexpr double least_weight = 1e-13;

Weights cleaned(Weights weights) {
  double sum = 0.0;
  for (double& w : weights) {
    if (w < least_weight) w = 0.0;
    sum += w;
  }
  for (double& w : weights) w /= sum;
  return weights;
}

/// Weights of a work vertex in a face of the user's mesh that holds it: a corner or a point on an edge.
Weights weights_of(const IndexData& data, Index work_vertex, Index user_face) {
  Weights weights{};
  const auto& corners = data.mesh->face_vertices(user_face);
  const Index user = data.work.user_vertex[work_vertex];
  if (user != no_index) {
    for (int i = 0; i < 3; ++i) weights[i] = corners[i] == user ? 1.0 : 0.0;
    return weights;
  }
  const auto& points = data.work.edge_points;
  const auto at = std::lower_bound(points.begin(), points.end(), work_vertex,
                                   [](const auto& point, Index vertex) { return point.vertex < vertex; });
  const auto [a, b] = data.mesh->edge_vertices(at->user_edge);
  for (int i = 0; i < 3; ++i) {
    if (corners[i] == a) weights[i] = 1.0 - at->position;
    if (corners[i] == b) weights[i] = at->position;
  }
  return weights;
}

/// Work faces of a face of the user: first and one past the last.
std::array<Index, 2> work_faces(const IndexData& data, Index user_face) {
  const auto& label = data.work.second_layer;
  const auto& user = data.work.user_face;
  const Index patch = data.partition.second_layer[user_face];
  const auto begin = std::lower_bound(label.begin(), label.end(), patch) - label.begin();
  const auto end = std::upper_bound(label.begin() + begin, label.end(), patch) - label.begin();
  const auto first = std::lower_bound(user.begin() + begin, user.begin() + end, user_face) - user.begin();
  const auto last = std::upper_bound(user.begin() + first, user.begin() + end, user_face) - user.begin();
  return {static_cast<Index>(first), static_cast<Index>(last)};
}

/// Weights (a, b, c) with a A + b B + c C = P, all of them weights in one face.
Weights solve(const std::array<Weights, 3>& corner, const Weights& point) {
  auto area = [](const Weights& a, const Weights& b, const Weights& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const double whole = area(corner[0], corner[1], corner[2]);
  if (whole == 0.0) return {-1.0, -1.0, -1.0};
  return {area(point, corner[1], corner[2]) / whole, area(corner[0], point, corner[2]) / whole,
          area(corner[0], corner[1], point) / whole};
}

}  // namespace

SurfacePoint work_point(const IndexData& data, const SurfacePoint& point) {
  if (point.is_vertex()) return SurfacePoint::at_vertex(data.work.work_vertex[point.vertex]);
  const auto [first, last] = work_faces(data, point.face);
  SurfacePoint best;
  double deepest = -unreachable;
  for (Index f = first; f < last; ++f) {
    std::array<Weights, 3> corner{};
    for (int i = 0; i < 3; ++i) {
      corner[i] = weights_of(data, data.work.mesh->face_vertices(f)[i], point.face);
    }
    const Weights weights = solve(corner, point.barycentric);
    const double depth = *std::min_element(weights.begin(), weights.end());
    if (depth <= deepest) continue;
    deepest = depth;
    best = SurfacePoint::in_face(f, weights);
  }
  best.barycentric = cleaned(best.barycentric);
  return validated(*data.work.mesh, best);
}

SurfacePoint user_point(const IndexData& data, const SurfacePoint& point) {
  Index face = point.face;
  if (point.is_vertex()) {
    const Index user = data.work.user_vertex[point.vertex];
    if (user != no_index) return SurfacePoint::at_vertex(user);
    face = Mesh::face_of(data.work.mesh->corners(point.vertex).front());
  }
  const Index user_face = data.work.user_face[face];
  Weights weights{};
  if (point.is_vertex()) {
    weights = weights_of(data, point.vertex, user_face);
  } else {
    for (int i = 0; i < 3; ++i) {
      if (point.barycentric[i] == 0.0) continue;
      const Weights corner = weights_of(data, data.work.mesh->face_vertices(face)[i], user_face);
      for (int k = 0; k < 3; ++k) weights[k] += point.barycentric[i] * corner[k];
    }
  }
  return validated(*data.mesh, SurfacePoint::in_face(user_face, cleaned(weights)));
}

SurfacePath user_path(const IndexData& data, const SurfacePath& path) {
  // Each of the user's faces is a cache miss.
  for (const SurfacePoint& point : path.points) {
    if (point.is_vertex()) continue;
    prefetch_line(&data.work.user_face[point.face]);
    for (Index vertex : data.work.mesh->face_vertices(point.face)) {
      prefetch_line(&data.work.user_vertex[vertex]);
    }
  }
  for (const SurfacePoint& point : path.points) {
    if (!point.is_vertex()) prefetch_line(&data.mesh->face_vertices(data.work.user_face[point.face]));
  }
  SurfacePath result;
  result.length = path.length;
  result.points.reserve(path.points.size());
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const SurfacePoint point = user_point(data, path.points[i]);
    const bool inside =
        !point.is_vertex() && std::ranges::all_of(point.barycentric, [](double w) { return w > 0.0; });
    if (inside && i > 0 && i + 1 < path.points.size()) continue;
    if (!result.points.empty() && point.is_vertex() && result.points.back().vertex == point.vertex) continue;
    result.points.push_back(point);
  }
  return result;
}

}  // namespace vorogeo
