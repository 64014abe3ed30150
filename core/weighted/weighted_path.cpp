// Paths back through the distances, edge by edge, and their refraction.
#include <algorithm>
#include <cmath>

#include "weighted/snell.h"
#include "weighted/weighted_solver.h"

namespace vorogeo {

namespace {

/// Times that a path may continue from a point at a greater distance than the last one.
constexpr int max_setbacks = 1000;

/// A crossing is a vertex if it is this near.
constexpr double at_vertex = 1e-9;

/// The point of an edge, in its first face.
SurfacePoint point_of_edge(const Mesh& mesh, Index edge, double fraction) {
  if (fraction <= at_vertex) return SurfacePoint::at_vertex(mesh.edge_vertices(edge)[0]);
  if (fraction >= 1.0 - at_vertex) return SurfacePoint::at_vertex(mesh.edge_vertices(edge)[1]);
  const Index h = mesh.edge_halfedge(edge);
  const bool along = mesh.tail(h) == mesh.edge_vertices(edge)[0];
  std::array<double, 3> weights{};
  weights[h % 3] = along ? 1.0 - fraction : fraction;
  weights[Mesh::next_in_face(h) % 3] = along ? fraction : 1.0 - fraction;
  return SurfacePoint::in_face(Mesh::face_of(h), weights);
}

/// An end of a piece: a fixed point, or one that may move along an edge.
struct Joint {
  SurfacePoint point;
  Index edge = no_index;
  double fraction = 0.0;
};

/// Where a joint lies as a function of its fraction, on the line of an edge or in the plane of a face.
void place_joint(const FaceNorms& norms, const Joint& joint, Index face, Index edge, PathPiece::Vector& at,
                 PathPiece::Vector& along) {
  const Mesh& mesh = norms.mesh();
  if (face == no_index) {
    if (joint.edge == edge) {
      along = {norms.edge_cost(edge), 0.0};
    } else if (joint.point.is_vertex()) {
      at = {joint.point.vertex == mesh.edge_vertices(edge)[0] ? 0.0 : norms.edge_cost(edge), 0.0};
    } else {
      std::array<double, 3> weights{};
      const Index h = mesh.edge_halfedge(edge);
      weights_in_face(mesh, joint.point, Mesh::face_of(h), weights);
      const bool forward = mesh.tail(h) == mesh.edge_vertices(edge)[0];
      at = {weights[forward ? Mesh::next_in_face(h) % 3 : h % 3] * norms.edge_cost(edge), 0.0};
    }
    return;
  }
  if (joint.edge == no_index) {
    std::array<double, 3> weights{};
    weights_in_face(mesh, joint.point, face, weights);
    at = norms.place(face, weights);
    return;
  }
  const auto corner = norms.corners(face);
  for (int i = 0; i < 3; ++i) {
    if (mesh.edge_of(3 * face + i) != joint.edge) continue;
    at = norms.on_edge(corner, 3 * face + i, 0.0);
    const auto end = norms.on_edge(corner, 3 * face + i, 1.0);
    along = {end[0] - at[0], end[1] - at[1]};
  }
}

}  // namespace

SurfacePath WeightedSolver::path_to_source(const SurfacePoint& target) const {
  SurfacePath path;
  path.length = unreachable;
  if (!(distance(target) < unreachable)) return path;
  std::vector<Joint> joints{{validated(mesh_, target)}};
  struct Passed {
    Index face, edge;
  };
  std::vector<Passed> passed;
  // This loop ends: all steps but a limited number lead to a point at a smaller distance.
  double limit = unreachable;
  int setbacks = 0;
  for (;;) {
    const SurfacePoint here = joints.back().point;
    if (here.is_vertex() && distance_[here.vertex] == 0.0) break;
    BackStep step = best_step(here, limit);
    if (!(step.distance < unreachable)) {
      // Between two points of an edge, distances are estimates, and all around may be greater: the path goes
      // on from one of the two.
      const Joint& joint = joints.back();
      if (joint.edge == no_index || ++setbacks > max_setbacks) return path;
      step = step_along(joint.edge, joint.fraction, unreachable);
    }
    limit = step.begin_distance;
    passed.push_back({step.face, step.edge});
    if (step.source != no_index) {
      joints.push_back({sources_[step.source]});
      break;
    }
    Joint joint{point_of_edge(mesh_, step.edge, step.fraction), step.edge, step.fraction};
    if (joint.point.is_vertex()) joint.edge = no_index;
    // Steps along one edge are one piece.
    if (step.face == no_index && passed.size() > 1 && passed[passed.size() - 2].face == no_index &&
        passed[passed.size() - 2].edge == step.edge && joints.back().edge == step.edge) {
      passed.pop_back();
      joints.back() = joint;
      continue;
    }
    joints.push_back(joint);
  }

  // Between vertices, which stay, each chain of crossings is refracted.
  path.length = 0.0;
  std::vector<PathPiece> pieces;
  std::vector<double> crossing;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < passed.size(); ++i) {
    PathPiece piece;
    const bool first = i == begin;
    place_joint(*norms_, joints[i], passed[i].face, passed[i].edge, piece.begin_at, piece.begin_along);
    place_joint(*norms_, joints[i + 1], passed[i].face, passed[i].edge, piece.end_at, piece.end_along);
    if (first) piece.begin_along = {};
    pieces.push_back(piece);
    if (joints[i + 1].edge != no_index) {
      crossing.push_back(joints[i + 1].fraction);
      continue;
    }
    path.length += refract(pieces, crossing);
    for (std::size_t k = 0; k < crossing.size(); ++k) {
      Joint& joint = joints[begin + 1 + k];
      joint.point = point_of_edge(mesh_, joint.edge, crossing[k]);
    }
    pieces.clear();
    crossing.clear();
    begin = i + 1;
  }
  for (const Joint& joint : joints) {
    const bool repeated = !path.points.empty() && path.points.back() == joint.point;
    if (!repeated) path.points.push_back(joint.point);
  }
  return path;
}

}  // namespace vorogeo
