// The mesh with border edges split and sorted by patches, and the same faces unsplit for tables and exact
// runs.
#include "index/work_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "index/border_pieces.h"
#include "patches/halo.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Splitting of border edges and renumbering by patch

namespace {

/// A face while its edges are being split: triangles so far, with the one that still holds each edge.
class FaceSplitter {
 public:
  explicit FaceSplitter(const std::array<Index, 3>& corners) : triangles_{corners} {}

  /// Puts the points (from a to b) on the edge a-b: its triangle becomes a fan around the third corner.
  void split(Index a, Index b, const std::vector<Index>& points) {
    if (points.empty()) return;
    for (auto& triangle : triangles_) {
      for (int i = 0; i < 3; ++i) {
        if (triangle[i] != a || triangle[(i + 1) % 3] != b) continue;
        const Index apex = triangle[(i + 2) % 3];
        triangle = {a, points.front(), apex};
        for (std::size_t k = 0; k < points.size(); ++k) {
          triangles_.push_back({points[k], k + 1 < points.size() ? points[k + 1] : b, apex});
        }
        return;
      }
    }
  }

  const std::vector<std::array<Index, 3>>& triangles() const { return triangles_; }

 private:
  std::vector<std::array<Index, 3>> triangles_;
};

/// Lengths of the lines between points on the sides of one face, in the metric of the mesh.
class FaceLines {
 public:
  FaceLines(const Mesh& mesh, Index face, const std::vector<WorkMesh::EdgePoint>& edge_points)
      : mesh_(mesh), face_(face), edge_points_(edge_points), corners_(mesh.face_corners(face)) {}

  double length(Index u, Index v) const {
    for (int i = 0; i < 3; ++i) {
      const Index side = 3 * face_ + i;
      const double from = along(mesh_.edge_of(side), u);
      const double to = along(mesh_.edge_of(side), v);
      // On a side whose faces agree, both must get the same number.
      if (from >= 0.0 && to >= 0.0) return std::abs(to - from) * mesh_.side_length(side);
    }
    return distance_between(place(u), place(v));
  }

 private:
  /// Where a point lies on an edge, from its first vertex (0) to its second (1); -1 if it does not.
  double along(Index edge, Index vertex) const {
    if (vertex >= mesh_.vertex_count()) {
      const auto& point = edge_points_[vertex - mesh_.vertex_count()];
      return point.user_edge == edge ? point.position : -1.0;
    }
    if (vertex == mesh_.edge_vertices(edge)[0]) return 0.0;
    return vertex == mesh_.edge_vertices(edge)[1] ? 1.0 : -1.0;
  }

  Point place(Index vertex) const {
    const auto& at = mesh_.face_vertices(face_);
    for (int i = 0; i < 3; ++i) {
      if (at[i] == vertex) return corners_[i];
      const Index edge = mesh_.edge_of(3 * face_ + i);
      const double t = along(edge, vertex);
      if (t < 0.0) continue;
      const bool forward = mesh_.edge_vertices(edge)[0] == at[i];
      const Point& a = corners_[forward ? i : (i + 1) % 3];
      const Point& b = corners_[forward ? (i + 1) % 3 : i];
      if (vertex >= mesh_.vertex_count()) return {std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), 0.0};
    }
    return corners_[0];
  }

  const Mesh& mesh_;
  Index face_;
  const std::vector<WorkMesh::EdgePoint>& edge_points_;
  std::array<Point, 3> corners_;
};

}  // namespace

WorkMesh make_work_mesh(const Mesh& mesh, const Partition& partition) {
  const auto pieces = pieces_of_edges(mesh, partition);
  std::vector<Point> positions = mesh.positions();
  std::vector<Index> first_point(mesh.edge_count(), no_index);
  std::vector<WorkMesh::EdgePoint> edge_points;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (e % elements_per_checkpoint == 0) checkpoint();
    if (pieces[e] == 1) continue;
    first_point[e] = static_cast<Index>(positions.size());
    const Point a = mesh.position(mesh.edge_vertices(e)[0]);
    const Point b = mesh.position(mesh.edge_vertices(e)[1]);
    for (Index k = 1; k < pieces[e]; ++k) {
      const double t = static_cast<double>(k) / pieces[e];
      edge_points.push_back({static_cast<Index>(positions.size()), e, t});
      positions.push_back({std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)});
    }
  }

  // Faces by patch, those of a patch in their old order.
  std::vector<Index> slot(partition.second_layer_count + 1, 0);
  for (Index patch : partition.second_layer) ++slot[patch + 1];
  std::partial_sum(slot.begin(), slot.end(), slot.begin());
  std::vector<Index> order(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) order[slot[partition.second_layer[f]]++] = f;
  std::vector<std::array<Index, 3>> faces;
  SideLengths sides;
  WorkMesh work;
  faces.reserve(order.size());
  std::vector<Index> points;
  for (Index f : order) {
    if (faces.size() % elements_per_checkpoint == 0) checkpoint();
    FaceSplitter splitter(mesh.face_vertices(f));
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * f + i;
      const Index e = mesh.edge_of(h);
      points.clear();
      for (Index k = 1; k < pieces[e]; ++k) points.push_back(first_point[e] + k - 1);
      if (mesh.tail(h) != mesh.edge_vertices(e)[0]) std::reverse(points.begin(), points.end());
      splitter.split(mesh.tail(h), mesh.head(h), points);
    }
    for (const auto& triangle : splitter.triangles()) {
      faces.push_back(triangle);
      if (mesh.has_metric()) {
        const FaceLines lines(mesh, f, edge_points);
        const auto& [a, b, c] = triangle;
        sides.push_back({lines.length(b, c), lines.length(c, a), lines.length(a, b)});
      }
      work.second_layer.push_back(partition.second_layer[f]);
      work.user_face.push_back(f);
    }
  }

  // Vertices in the order in which the sorted faces first name them.
  std::vector<Index> renamed(positions.size(), no_index);
  std::vector<Point> sorted;
  sorted.reserve(positions.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    for (Index& v : faces[f]) {
      if (renamed[v] == no_index) {
        renamed[v] = static_cast<Index>(sorted.size());
        sorted.push_back(positions[v]);
        work.user_vertex.push_back(v < mesh.vertex_count() ? v : no_index);
      }
      v = renamed[v];
    }
  }
  for (auto& point : edge_points) point.vertex = renamed[point.vertex];
  std::sort(edge_points.begin(), edge_points.end(),
            [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
  edge_points.shrink_to_fit();
  work.edge_points = std::move(edge_points);
  renamed.resize(mesh.vertex_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) renamed[v] = renamed[mesh.representative(v)];
  renamed.shrink_to_fit();
  sorted.shrink_to_fit();
  work.user_vertex.shrink_to_fit();
  work.second_layer.shrink_to_fit();
  work.user_face.shrink_to_fit();
  work.work_vertex = std::move(renamed);
  work.mesh = mesh_in_metric_of(mesh, std::move(sorted), faces, std::move(sides));
  return work;
}

// ---- The work mesh without its added points

Index TableSurface::edge_point_of(const WorkMesh& work, Index work_vertex) {
  const auto at = std::ranges::lower_bound(work.edge_points, work_vertex, {}, &WorkMesh::EdgePoint::vertex);
  return static_cast<Index>(at - work.edge_points.begin());
}

TableSurface make_table_surface(const Mesh& mesh, const WorkMesh& work,
                                const std::shared_ptr<const LocalGeometry>& work_geometry) {
  TableSurface surface;
  surface.vertex.assign(work.user_vertex.size(), no_index);
  if (work.edge_points.empty()) {
    surface.geometry = work_geometry;
    surface.second_layer = work.second_layer;
    std::iota(surface.vertex.begin(), surface.vertex.end(), 0);
    return surface;
  }
  // As in the work mesh, the pieces of a face stay together, and vertices come in the order in which faces
  // first name them.
  constexpr Index per_checkpoint = 1 << 13;
  std::vector<Index> renamed(mesh.vertex_count(), no_index);
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> faces;
  SideLengths sides;
  std::vector<Index> face_of_user(mesh.face_count(), no_index);
  for (std::size_t f = 0; f < work.user_face.size(); ++f) {
    if (f % per_checkpoint == 0) checkpoint();
    const Index user = work.user_face[f];
    if (face_of_user[user] != no_index) continue;
    face_of_user[user] = static_cast<Index>(faces.size());
    std::array<Index, 3> corners = mesh.face_vertices(user);
    for (Index& v : corners) {
      if (renamed[v] == no_index) {
        renamed[v] = static_cast<Index>(positions.size());
        positions.push_back(mesh.position(v));
        surface.vertex[work.work_vertex[v]] = renamed[v];
      }
      v = renamed[v];
    }
    faces.push_back(corners);
    if (mesh.has_metric()) sides.push_back(mesh.side_lengths(user));
    surface.second_layer.push_back(work.second_layer[f]);
  }
  const auto whole = mesh_in_metric_of(mesh, std::move(positions), faces, std::move(sides));
  surface.edge_point.reserve(work.edge_points.size());
  for (const WorkMesh::EdgePoint& point : work.edge_points) {
    const Index user = mesh.edge_halfedge(point.user_edge);
    const Index edge = whole->edge_of(3 * face_of_user[Mesh::face_of(user)] + user % 3);
    const bool same_first = whole->edge_vertices(edge)[0] == renamed[mesh.edge_vertices(point.user_edge)[0]];
    surface.edge_point.push_back(
        {edge, whole->edge_length(edge) * (same_first ? point.position : 1.0 - point.position)});
  }
  surface.geometry = std::make_shared<const LocalGeometry>(whole);
  return surface;
}

// ---- Frames of the user's faces, and these faces by patch

UnsplitSurface::UnsplitSurface(std::shared_ptr<const Mesh> mesh, const WorkMesh& work,
                               const Partition& partition)
    : geometry(std::make_shared<const LocalGeometry>(std::move(mesh))),
      first_face(first_faces(partition.second_layer, partition.second_layer_count)) {
  // The pieces of a face stay together in the work mesh.
  std::ranges::unique_copy(work.user_face, std::back_inserter(faces));
}

}  // namespace vorogeo
