// The surface that an index works on: the user's faces sorted by patch, and points on the borders of patches.
#include "index/inner_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "index/border_pieces.h"
#include "support/processor.h"
#include "support/progress.h"

namespace vorogeo {

InnerSurface::InnerSurface(const Mesh& user, const Partition& partition) {
  std::vector<Index> slot(partition.second_layer_count + 1, 0);
  for (Index patch : partition.second_layer) ++slot[patch + 1];
  std::partial_sum(slot.begin(), slot.end(), slot.begin());
  face.resize(user.face_count());
  for (Index f = 0; f < user.face_count(); ++f) face[f] = slot[partition.second_layer[f]]++;
  user_face.resize(face.size());
  for (Index f = 0; f < user.face_count(); ++f) user_face[face[f]] = f;

  vertex.assign(user.vertex_count(), no_index);
  second_layer.reserve(face.size());
  std::vector<Point> positions;
  std::vector<std::array<Index, 3>> corners;
  SideLengths sides;
  positions.reserve(vertex.size());
  corners.reserve(face.size());
  for (const std::size_t f : checked(face.size())) {
    corners.push_back(user.face_vertices(user_face[f]));
    for (Index& v : corners.back()) {
      if (vertex[v] == no_index) {
        vertex[v] = static_cast<Index>(positions.size());
        positions.push_back(user.position(v));
        user_vertex.push_back(v);
      }
      v = vertex[v];
    }
    if (user.has_metric()) sides.push_back(user.side_lengths(user_face[f]));
    second_layer.push_back(partition.second_layer[user_face[f]]);
  }
  for (Index v = 0; v < user.vertex_count(); ++v) vertex[v] = vertex[user.representative(v)];
  positions.shrink_to_fit();
  user_vertex.shrink_to_fit();
  mesh = mesh_in_metric_of(user, std::move(positions), std::move(corners), std::move(sides));

  const std::vector<Index> pieces = pieces_of_edges(user, partition);
  for (const Index edge : checked(mesh->edge_count())) {
    const Index h = mesh->edge_halfedge(edge);
    const Index count = pieces[user.edge_of(3 * user_face[Mesh::face_of(h)] + h % 3)];
    for (Index k = 1; k < count; ++k) {
      point.push_back({edge, mesh->edge_length(edge) * (static_cast<double>(k) / count)});
    }
  }
  point.shrink_to_fit();
}

bool InnerSurface::is_border(Index edge, std::span<const Index> label) const {
  const Index first = mesh->edge_halfedge(edge);
  for (Index h = mesh->next_around_edge(first); h != first; h = mesh->next_around_edge(h)) {
    if (label[Mesh::face_of(h)] != label[Mesh::face_of(first)]) return true;
  }
  return false;
}

std::array<Index, 2> InnerSurface::places_inside(Index edge) const {
  if (!is_border(edge, second_layer)) return {0, 0};
  const auto inside = std::ranges::equal_range(point, edge, {}, &EdgePoint::edge);
  const auto place = [&](auto at) { return vertex_count() + static_cast<Index>(at - point.begin()); };
  return {place(inside.begin()), place(inside.end())};
}

SurfacePoint InnerSurface::surface_point(Index place) const {
  if (is_vertex(place)) return SurfacePoint::at_vertex(place);
  const EdgePoint& at = point_at(place);
  const double length = mesh->edge_length(at.edge);
  return point_on_edge(*mesh, at.edge, length > 0.0 ? at.position / length : 0.0);
}

SurfacePath InnerSurface::user_path(SurfacePath path) const {
  // Each of the user's faces is a cache miss.
  for (const SurfacePoint& at : path.points) {
    prefetch_line(at.is_vertex() ? &user_vertex[at.vertex] : &user_face[at.face]);
  }
  for (SurfacePoint& at : path.points) at = user_point(at);
  return path;
}

std::size_t InnerSurface::memory_bytes() const {
  auto of = [](const auto& list) { return list.size() * sizeof(list[0]); };
  return mesh->memory_bytes() + of(vertex) + of(user_vertex) + of(face) + of(user_face) + of(second_layer) +
         of(point);
}

void PlaceTargets::add(const InnerSurface& surface, std::span<const Index> places) {
  for (const Index place : places) {
    if (surface.is_vertex(place)) {
      vertices.push_back(place);
    } else {
      points.push_back(surface.point_at(place));
    }
  }
}

// ---- Faces with places on their sides

namespace {

/// A place of a face and its barycentric weights there.
struct Corner {
  Index place;
  std::array<double, 3> weights;
};

using Triangle = std::array<Corner, 3>;

/// Weights (a, b, c) with a A + b B + c C = P, all of them weights in one face; negative where the three lie
/// on a line.
std::array<double, 3> weights_among(const Triangle& corner, const std::array<double, 3>& point) {
  auto area = [](const auto& a, const auto& b, const auto& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const auto& [a, b, c] = corner;
  const double whole = area(a.weights, b.weights, c.weights);
  if (whole == 0.0) return {-1.0, -1.0, -1.0};
  return {area(point, b.weights, c.weights) / whole, area(a.weights, point, c.weights) / whole,
          area(a.weights, b.weights, point) / whole};
}

/// Divides the triangle with a side from `begin` to `end` by a place on that side.
void split_triangle_at(Index begin, Index end, const Corner& corner, std::vector<Triangle>& triangles) {
  for (Triangle& triangle : triangles) {
    for (int j = 0; j < 3; ++j) {
      if (triangle[j].place != begin || triangle[(j + 1) % 3].place != end) continue;
      Triangle rest = triangle;
      rest[j] = triangle[(j + 1) % 3] = corner;
      triangles.push_back(rest);
      return;
    }
  }
}

/// The triangles into which a face is divided: those at each side are a fan round the corner opposite it.
std::vector<Triangle> divided(const InnerSurface& surface, Index face,
                              const std::array<std::array<Index, 2>, 3>& inside) {
  const Mesh& mesh = *surface.mesh;
  const auto& at = mesh.face_vertices(face);
  std::vector<Triangle> triangles{
      {Corner{at[0], {1.0, 0.0, 0.0}}, Corner{at[1], {0.0, 1.0, 0.0}}, Corner{at[2], {0.0, 0.0, 1.0}}}};
  for (int i = 0; i < 3; ++i) {
    const Index side = 3 * face + i;
    const Index edge = mesh.edge_of(side);
    const bool along = mesh.tail(side) == mesh.edge_vertices(edge)[0];
    const auto [first, last] = inside[i];
    Index begin = at[i];
    for (Index k = 0; k < last - first; ++k) {
      Corner corner{along ? first + k : last - 1 - k, {}};
      const double from_first = surface.point_at(corner.place).position / mesh.edge_length(edge);
      corner.weights[(i + 1) % 3] = along ? from_first : 1.0 - from_first;
      corner.weights[i] = 1.0 - corner.weights[(i + 1) % 3];
      split_triangle_at(begin, at[(i + 1) % 3], corner, triangles);
      begin = corner.place;
    }
  }
  return triangles;
}

}  // namespace

FacePiece::FacePiece(const InnerSurface& surface, Index face, const std::array<double, 3>& face_weights)
    : place(surface.mesh->face_vertices(face)), weights(face_weights) {
  const Mesh& mesh = *surface.mesh;
  std::array<std::array<Index, 2>, 3> inside{};
  bool is_divided = false;
  for (int i = 0; i < 3; ++i) {
    length[i] = mesh.side_length(3 * face + i);
    inside[i] = surface.places_inside(mesh.edge_of(3 * face + i));
    is_divided = is_divided || inside[i][0] < inside[i][1];
  }
  if (!is_divided) return;
  const auto corners = mesh.face_corners(face);
  double deepest = -unreachable;
  for (const Triangle& triangle : divided(surface, face, inside)) {
    const auto found = weights_among(triangle, face_weights);
    const double depth = *std::ranges::min_element(found);
    if (depth <= deepest) continue;
    deepest = depth;
    weights = found;
    for (int i = 0; i < 3; ++i) {
      place[i] = triangle[i].place;
      Point line{};
      for (int k = 0; k < 3; ++k) {
        const double w = triangle[(i + 1) % 3].weights[k] - triangle[i].weights[k];
        for (int axis = 0; axis < 3; ++axis) line[axis] += w * corners[k][axis];
      }
      length[i] = std::sqrt(line[0] * line[0] + line[1] * line[1] + line[2] * line[2]);
    }
  }
}

}  // namespace vorogeo
