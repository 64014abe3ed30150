// For each border vertex, the border edges near it, by a tree of their boxes.
#include "mesh/t_junctions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/box_tree.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// How far a vertex inside an edge may lie from it: this fraction of the edge's length, and of the largest
/// coordinate, which files often hold in single precision (6e-8 for each coordinate).
constexpr double off_share = 1e-6;
constexpr double off_coordinate = 2e-7;
/// But no farther than this fraction of the edge: small edges far from the origin have lost their directions.
constexpr double max_off = 1e-2;
/// Border edges examined for one vertex, so that a heap of edges at one place costs time proportional to
/// their number.
constexpr int max_edges = 1024;

double tolerance(const Mesh& mesh, Index edge) {
  double greatest = 0.0;
  for (Index v : mesh.edge_vertices(edge)) {
    for (double x : mesh.position(v)) greatest = std::max(greatest, std::abs(x));
  }
  const double length = mesh.edge_length(edge);
  return std::min(max_off * length, off_share * length + off_coordinate * greatest);
}

/// Whether a point lies on the edge, away from its ends.
bool is_inside(const Mesh& mesh, Index edge, const Point& point) {
  const double length = mesh.edge_length(edge);
  if (!(length > 0.0)) return false;
  const auto [a, b] = mesh.edge_vertices(edge);
  const Point& from = mesh.position(a);
  const Point& to = mesh.position(b);
  const double off = tolerance(mesh, edge);
  double along = 0.0;
  for (int k = 0; k < 3; ++k) along += (point[k] - from[k]) * ((to[k] - from[k]) / length);
  if (!(along > off && along < length - off)) return false;
  Point foot{};
  for (int k = 0; k < 3; ++k) foot[k] = std::lerp(from[k], to[k], along / length);
  return distance_between(point, foot) <= off && distance_between(point, from) > off &&
         distance_between(point, to) > off;
}

}  // namespace

TJunctions find_t_junctions(const Mesh& mesh) {
  TJunctions result;
  std::vector<Index> edges;
  std::vector<Box> boxes;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!mesh.is_border_edge(e)) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    const double off = tolerance(mesh, e);
    Box box{mesh.position(a), mesh.position(a)};
    box.add({mesh.position(b), mesh.position(b)});
    for (int k = 0; k < 3; ++k) {
      box.low[k] -= off;
      box.high[k] += off;
    }
    edges.push_back(e);
    boxes.push_back(box);
  }
  if (edges.empty()) return result;
  const BoxTree tree(std::move(boxes));
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (v % elements_per_checkpoint == 0) checkpoint();
    if (!mesh.is_border(v)) continue;
    Index found = no_index;
    // Once an edge is found, nothing is near enough any more.
    auto look_at = [&](Index place) {
      const Index edge = edges[place];
      const auto& own = mesh.face_vertices(Mesh::face_of(mesh.edge_halfedge(edge)));
      const bool is_corner = std::ranges::find(own, v) != own.end();
      if (found == no_index && !is_corner && is_inside(mesh, edge, mesh.position(v))) found = edge;
      return found == no_index ? 0.0 : -1.0;
    };
    tree.visit_near({mesh.position(v), mesh.position(v)}, 0.0, max_edges, look_at,
                    [](Index) { return false; });
    if (found == no_index) continue;
    if (result.count++ == 0) {
      result.first = v;
      result.first_edge = mesh.edge_vertices(found);
    }
  }
  return result;
}

}  // namespace vorogeo
