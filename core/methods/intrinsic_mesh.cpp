// Faces of one orientation, and the flips that make them Delaunay.
#include "methods/intrinsic_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "mesh/triangle_area.h"

namespace vorogeo {

namespace {

/// Needles thinner than this are taken to be this thick, so that their cotangents stay finite.
constexpr double least_area_part = 1e-14;
/// An edge whose angles sum to pi but for rounding stays.
constexpr double cotangent_slack = 1e-9;

}  // namespace

double IntrinsicMesh::double_area(const Face& face) {
  const double longest = *std::max_element(face.length.begin(), face.length.end());
  return std::max(twice_area(face.length), least_area_part * longest * longest);
}

double IntrinsicMesh::cotangent(const Face& face, int i) {
  const double area = double_area(face);
  if (!(area > 0.0)) return 0.0;
  const double own = face.length[i];
  const double a = face.length[(i + 1) % 3];
  const double b = face.length[(i + 2) % 3];
  return (a * a + b * b - own * own) / (2.0 * area);
}

IntrinsicMesh::IntrinsicMesh(const Mesh& mesh) {
  faces.resize(mesh.face_count());
  // Faces turned over so that neighbours run along their common edge in opposite directions.
  std::vector<std::uint8_t> turned(mesh.face_count(), 0);
  std::vector<std::uint8_t> visited(mesh.face_count(), 0);
  std::vector<Index> stack;
  const auto other_side = [&](Index h) {
    const Index g = mesh.next_around_edge(h);
    return g != h && mesh.next_around_edge(g) == h ? g : no_index;
  };
  for (Index first = 0; first < mesh.face_count(); ++first) {
    if (visited[first] != 0) continue;
    visited[first] = 1;
    stack.push_back(first);
    while (!stack.empty()) {
      const Index f = stack.back();
      stack.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        const Index g = other_side(h);
        if (g == no_index || visited[Mesh::face_of(g)] != 0) continue;
        visited[Mesh::face_of(g)] = 1;
        turned[Mesh::face_of(g)] = turned[f] ^ std::uint8_t(mesh.tail(g) == mesh.tail(h) ? 1 : 0);
        stack.push_back(Mesh::face_of(g));
      }
    }
  }
  // Edge i of a turned face is the edge 2 - i of the face as it was.
  const auto place = [&](Index h) {
    const Index f = Mesh::face_of(h);
    return turned[f] != 0 ? 3 * f + 2 - h % 3 : h;
  };
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index f = Mesh::face_of(h);
    const Index own = place(h);
    faces[f].vertex[own % 3] = turned[f] != 0 ? mesh.head(h) : mesh.tail(h);
    faces[f].length[own % 3] = mesh.edge_length(mesh.edge_of(h));
    const Index g = other_side(h);
    const bool opposite =
        g != no_index && ((mesh.tail(g) == mesh.tail(h)) == (turned[f] != turned[Mesh::face_of(g)]));
    faces[f].across[own % 3] = opposite ? place(g) : no_index;
  }
}

bool IntrinsicMesh::is_delaunay(Index f, int i) const {
  const Index g = faces[f].across[i];
  if (g == no_index) return true;
  return cotangent(faces[f], i) + cotangent(faces[g / 3], g % 3) >= -cotangent_slack;
}

bool IntrinsicMesh::flip(Index f, int i) {
  const Index other = faces[f].across[i];
  const Index g = other / 3;
  const int j = other % 3;
  if (g == f) return false;
  const Face one = faces[f];
  const Face two = faces[g];
  // The edge from a to b, with c on the side of f and d on that of g, laid along the x axis.
  const double length = one.length[i];
  const double to_b = one.length[(i + 1) % 3];
  const double to_a = one.length[(i + 2) % 3];
  const double from_a = two.length[(j + 1) % 3];
  const double from_b = two.length[(j + 2) % 3];
  const double cx = 0.5 * (length + (to_a - to_b) * (to_a + to_b) / length);
  const double dx = 0.5 * (length + (from_a - from_b) * (from_a + from_b) / length);
  const double new_length = std::hypot(cx - dx, (double_area(one) + double_area(two)) / length);
  if (!(length > 0.0 && new_length > 0.0) || !std::isfinite(new_length)) return false;
  faces[f] = {{one.vertex[(i + 2) % 3], one.vertex[i], two.vertex[(j + 2) % 3]},
              {to_a, from_a, new_length},
              {one.across[(i + 2) % 3], two.across[(j + 1) % 3], 3 * g + 2}};
  faces[g] = {{two.vertex[(j + 2) % 3], one.vertex[(i + 1) % 3], one.vertex[(i + 2) % 3]},
              {from_b, to_b, new_length},
              {two.across[(j + 2) % 3], one.across[(i + 1) % 3], 3 * f + 2}};
  // Edges of the two that met each other have moved with their faces.
  const auto moved = [&](Index edge) {
    if (edge == 3 * f + (i + 2) % 3) return 3 * f;
    if (edge == 3 * g + (j + 1) % 3) return 3 * f + 1;
    if (edge == 3 * g + (j + 2) % 3) return 3 * g;
    if (edge == 3 * f + (i + 1) % 3) return 3 * g + 1;
    return edge;
  };
  for (const Index face : {f, g}) {
    for (int k = 0; k < 2; ++k) {
      Index& across = faces[face].across[k];
      if (across == no_index) continue;
      across = across / 3 == f || across / 3 == g ? moved(across) : across;
      faces[across / 3].across[across % 3] = 3 * face + k;
    }
  }
  return true;
}

std::size_t IntrinsicMesh::make_delaunay() {
  std::vector<Index> stack;
  for (Index edge = static_cast<Index>(3 * faces.size()) - 1; edge >= 0; --edge) stack.push_back(edge);
  // Each flip makes the triangulation "more Delaunay", but rounding on needles might not: the count is
  // bounded.
  const std::size_t max_flips = 100 * faces.size();
  std::size_t flips = 0;
  while (!stack.empty() && flips < max_flips) {
    const Index edge = stack.back();
    stack.pop_back();
    const Index f = edge / 3;
    const int i = edge % 3;
    if (is_delaunay(f, i)) continue;
    const Index g = faces[f].across[i] / 3;
    if (!flip(f, i)) continue;
    ++flips;
    for (const Index face : {f, g}) {
      for (int k = 0; k < 2; ++k) stack.push_back(3 * face + k);
    }
  }
  return flips;
}

}  // namespace vorogeo
