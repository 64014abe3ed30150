// Where windows come from: sources, and vertices at which a shortest path may bend.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/solver_state.h"

namespace vorogeo {

namespace {

/// Widening of the sector into which a vertex emits, in radians.
constexpr double sector_tolerance = 1e-6;

}  // namespace

void ExactSolver::State::emit(Index vertex, Index corner, double width, double least_angle,
                              double greatest_angle) {
  const Index opposite = Mesh::next_in_face(corner);
  const FaceFrame& frame = geometry->frame[opposite];
  const Index edge = mesh.edge_of(opposite);
  const double length = mesh.edge_length(edge);
  const VertexState& state = vertices[vertex];
  Window window =
      Window::from_source(length, frame.apex_x, frame.apex_depth, state.distance, opposite, state.source);
  // A vertex that lies on the edge up to a negligible distance would see a sector through no part of the
  // edge.
  const bool is_on_edge = frame.apex_depth <= ExactGeometry::next_to_nothing * length;
  if (!is_on_edge && (least_angle > 0.0 || greatest_angle < width)) {
    // The corner's angle grows along the edge if it begins at the side of the edge's first vertex.
    const bool own = geometry->begins_at_own_edge[corner] != 0;
    const bool first_side_begins = (frame.first_side(opposite) == corner) == own;
    if (!first_side_begins) {
      std::swap(least_angle, greatest_angle);
      least_angle = width - least_angle;
      greatest_angle = width - greatest_angle;
    }
    const double first = std::atan2(-frame.apex_x, frame.apex_depth);
    auto at = [&](double angle) {
      const double direction = first + angle;
      if (direction >= 0.5 * std::numbers::pi - 1e-6) return length;
      return frame.apex_x + frame.apex_depth * std::tan(direction);
    };
    if (least_angle > 0.0) window.begin = std::max(0.0, at(least_angle));
    if (greatest_angle < width) window.end = std::min(length, at(greatest_angle));
  }
  add_window(edge, window);
  if (is_on_edge && length > 0.0 && lies_on_edge(window, length)) pass_through(window);
}

void ExactSolver::State::emit_fan(Index vertex, bool everywhere) {
  const auto corners = mesh.corners(vertex);
  const double arrival = vertices[vertex].arrival;
  const auto fan = mesh.fan(vertex);
  everywhere |= arrival < 0.0 || geometry->can_bend[vertex] == ExactGeometry::anywhere;
  const double total = mesh.total_angle(vertex);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Index corner = corners[i];
    if (!may_enter(Mesh::face_of(corner))) continue;
    if (everywhere) {
      emit(vertex, corner, 0.0, 0.0, 0.0);
      continue;
    }
    // A path bends only where the angles on both its sides are at least pi.
    const double begin = geometry->corner_begin[corner];
    const double width = (i + 1 < corners.size() ? geometry->corner_begin[corners[i + 1]] : total) - begin;
    auto emit_sector = [&](double from, double to) {
      const double least = std::max(0.0, from - sector_tolerance - begin);
      const double greatest = std::min(width, to + sector_tolerance - begin);
      if (least < greatest) emit(vertex, corner, width, least, greatest);
    };
    if (fan == Mesh::Fan::open) {
      emit_sector(arrival + std::numbers::pi, total);
      emit_sector(0.0, arrival - std::numbers::pi);
    } else {
      const double from = arrival + std::numbers::pi;
      const double to = arrival + total - std::numbers::pi;
      emit_sector(from, to);
      emit_sector(from - total, to - total);
    }
  }
}

void ExactSolver::State::take_vertex(Index vertex) {
  const VertexState state = vertices[vertex];
  if (state.distance > max_distance) return;
  // A face that may not be entered acts like a border of the mesh: paths may bend around it.
  bool beside_barrier = false;
  for (Index corner : mesh.corners(vertex)) {
    if (!may_enter(Mesh::face_of(corner))) {
      beside_barrier = true;
      continue;
    }
    for (Index side : {corner, Mesh::previous_in_face(corner)}) {
      const Index other = side == corner ? mesh.head(side) : mesh.tail(side);
      const double distance = state.distance + mesh.edge_length(mesh.edge_of(side));
      if (distance >= vertices[other].distance) continue;
      double arrival = -1.0;
      if (geometry->can_bend[other] == ExactGeometry::by_angle) {
        const Index there = side == corner ? Mesh::next_in_face(side) : side;
        const bool at_own_edge = there == side;
        arrival = geometry->corner_begin[there];
        if (at_own_edge != (geometry->begins_at_own_edge[there] != 0)) arrival += mesh.corner_angle(there);
      }
      reach_vertex(other, distance, state.source, arrival, vertex);
    }
  }
  if (beside_barrier) {
    barrier_distance = std::min(barrier_distance, length_at_vertex(state.distance, vertex));
  }
  const bool is_source = state.along_edge_from == no_index && sources[state.source].point.vertex == vertex;
  if (geometry->can_bend[vertex] || is_source || beside_barrier) emit_fan(vertex, beside_barrier);
}

void ExactSolver::State::emit_from(const ExactSource& source, Index id, Index halfedge) {
  // From a point of the face of `halfedge` onto the edge of `halfedge`.
  const Index face = Mesh::face_of(halfedge);
  const FaceFrame& frame = geometry->frame[halfedge];
  const Index edge = mesh.edge_of(halfedge);
  const bool along = mesh.tail(halfedge) == geometry->ends(edge)[0];
  const int tail = halfedge - 3 * face;
  const double at_apex = source.point.barycentric[(tail + 2) % 3];
  const double at_second = source.point.barycentric[along ? (tail + 1) % 3 : tail];
  const double length = mesh.edge_length(edge);
  add_window(edge, Window::from_source(length, at_second * length + at_apex * frame.apex_x,
                                       at_apex * frame.apex_depth, source.offset, halfedge, id));
}

void ExactSolver::State::start_at(const ExactSource& source, Index id) {
  if (source.point.is_vertex()) {
    if (source.offset < vertices[source.point.vertex].distance) {
      reach_vertex(source.point.vertex, source.offset, id, -1.0, no_index);
    }
    return;
  }
  // The face of the point and, for a point on an edge, all faces around that edge.
  auto start_in = [&](Index face, const std::array<double, 3>& barycentric) {
    ExactSource local = source;
    local.point = SurfacePoint::in_face(face, barycentric);
    face_sources.emplace(face, id);
    const FacePlane plane(*geometry, face);
    const auto at = plane.at(barycentric);
    for (int i = 0; i < 3; ++i) {
      const double distance =
          source.offset + std::hypot(at[0] - plane.corner[i][0], at[1] - plane.corner[i][1]);
      const Index v = mesh.face_vertices(face)[i];
      if (distance < vertices[v].distance) reach_vertex(v, distance, id, -1.0, no_index);
    }
    for (int i = 0; i < 3; ++i) {
      if (barycentric[(i + 2) % 3] > 0.0) emit_from(local, id, 3 * face + i);
    }
  };
  for_each_face_at(mesh, source.point, [&](Index face, const std::array<double, 3>& weights) {
    if (face == source.point.face || may_enter(face)) start_in(face, weights);
  });
}

}  // namespace vorogeo
