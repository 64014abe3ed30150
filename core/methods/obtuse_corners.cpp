// Unfolds the faces opposite to an obtuse corner.
#include "methods/obtuse_corners.h"

#include <cmath>

namespace vorogeo {

namespace {

struct Flat {
  double x, y;
};

/// The third vertex of a triangle over the directed line a-b, to its right, by its distances from both.
Flat beside(const Flat& a, const Flat& b, double to_a, double to_b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = std::hypot(dx, dy);
  const double along = 0.5 * (length + (to_a - to_b) * (to_a + to_b) / length);
  const double away = std::sqrt(std::fmax(0.0, (to_a - along) * (to_a + along)));
  return {a.x + (along * dx + away * dy) / length, a.y + (along * dy - away * dx) / length};
}

double length_of(const Mesh& mesh, Index halfedge) { return mesh.edge_length(mesh.edge_of(halfedge)); }

struct Split {
  Index vertex = no_index;
  double length = 0.0;
  double x = 0.0, y = 0.0;
};

/// The corner lies in the origin, its first side along the x axis, its second side above it.
Split split_of(const Mesh& mesh, Index corner, double to_first, double to_second, double cosine) {
  const double sine = std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine));
  Flat right{to_first, 0.0};
  Flat left{to_second * cosine, to_second * sine};
  Index crossed = Mesh::next_in_face(corner);
  bool from_right = true;  // whether the crossed half-edge begins at `right`
  for (int i = 0; i < max_unfolded; ++i) {
    const Index twin = mesh.next_around_edge(crossed);
    if (twin == crossed || mesh.next_around_edge(twin) != crossed) return {};
    const bool same = mesh.tail(twin) == mesh.tail(crossed);
    const bool begins_right = same == from_right;
    const Index next = Mesh::next_in_face(twin);
    const Index previous = Mesh::previous_in_face(twin);
    const double to_right = length_of(mesh, begins_right ? previous : next);
    const double to_left = length_of(mesh, begins_right ? next : previous);
    const Flat apex = beside(right, left, to_right, to_left);
    const double with_right = apex.x;  // its sign is that of the cosine
    const double with_left = apex.x * cosine + apex.y * sine;
    if (with_right > 0.0 && with_left > 0.0) {
      return {mesh.apex(twin), std::hypot(apex.x, apex.y), apex.x, apex.y};
    }
    // Beyond the sector on the left: it goes on through the side at the right, and the other way round.
    if (with_right <= 0.0) {
      left = apex;
      crossed = begins_right ? previous : next;
      from_right = !begins_right;
    } else {
      right = apex;
      crossed = begins_right ? next : previous;
      from_right = !begins_right;
    }
  }
  return {};
}

}  // namespace

std::vector<MarchingTriangle> marching_triangles(const Mesh& mesh) {
  std::vector<MarchingTriangle> triangles;
  triangles.reserve(3 * static_cast<std::size_t>(mesh.face_count()));
  for (Index corner = 0; corner < 3 * mesh.face_count(); ++corner) {
    const Index vertex = mesh.tail(corner);
    const Index first = mesh.head(corner);
    const Index second = mesh.apex(corner);
    const double to_first = length_of(mesh, corner);
    const double to_second = length_of(mesh, Mesh::previous_in_face(corner));
    const double cosine = std::cos(mesh.corner_angle(corner));
    if (!(to_first > 0.0 && to_second > 0.0)) {
      triangles.push_back({vertex, first, second, to_first, to_second, -1.0});
      continue;
    }
    const Split split = cosine < 0.0 ? split_of(mesh, corner, to_first, to_second, cosine) : Split{};
    if (split.vertex == no_index || split.vertex == vertex || !(split.length > 0.0)) {
      triangles.push_back({vertex, first, second, to_first, to_second, cosine});
      continue;
    }
    const double sine = std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine));
    triangles.push_back({vertex, first, split.vertex, to_first, split.length, split.x / split.length});
    triangles.push_back({vertex, split.vertex, second, split.length, to_second,
                         (split.x * cosine + split.y * sine) / split.length});
  }
  return triangles;
}

}  // namespace vorogeo
