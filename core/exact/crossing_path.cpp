// A path from edge to edge over faces of different norms, moved to where it is shortest.
#include "exact/crossing_path.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "support/progress.h"

namespace vorogeo {

// ---- From joint to joint, and the refraction of the pieces between

namespace {

/// Crossings this close to an end of their edge, as a fraction of it, lie at its vertex.
constexpr double at_vertex = 1e-9;

/// The drift from a face's first corner, or an edge's first vertex, to a joint at `fraction` of its edge.
double drift_to(const FaceNorms& norms, const PathJoint& joint, double fraction, Index face, Index edge) {
  const Mesh& mesh = norms.mesh();
  if (!mesh.has_drifts()) return 0.0;
  const bool moves = joint.edge != no_index && (face != no_index || joint.edge == edge);
  const SurfacePoint point = moves ? point_on_edge(mesh, joint.edge, fraction) : joint.point;
  std::array<double, 3> weights{};
  const Index h = face == no_index ? mesh.edge_halfedge(edge) : 3 * face;
  weights_in_face(mesh, point, Mesh::face_of(h), weights);
  if (face != no_index) return norms.drift_to(face, weights);
  const bool forward = mesh.tail(h) == mesh.edge_vertices(edge)[0];
  return weights[(forward ? Mesh::next_in_face(h) : h) % 3] * mesh.edge_drift(edge);
}

/// The position of a joint as a function of its fraction, `at + fraction * along`, on the line of an edge or
/// in the plane of a face.
void place_joint(const FaceNorms& norms, const PathJoint& joint, Index face, Index edge,
                 PathPiece::Vector& at, PathPiece::Vector& along) {
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

/// Fixes an end of a piece at the current position of its joint.
void fix(const PathJoint& joint, PathPiece::Vector& at, PathPiece::Vector& along, double& drift_at,
         double& drift_along) {
  at = {at[0] + joint.fraction * along[0], at[1] + joint.fraction * along[1]};
  along = {};
  drift_at += joint.fraction * drift_along;
  drift_along = 0.0;
}

}  // namespace

PathJoint joint_on(const Mesh& mesh, Index edge, double fraction) {
  const double snapped = fraction <= at_vertex ? 0.0 : fraction >= 1.0 - at_vertex ? 1.0 : fraction;
  return {point_on_edge(mesh, edge, snapped), edge, snapped};
}

void CrossingPath::go_to(const PathJoint& joint, Index face, Index edge) {
  // Steps along one edge are one piece.
  if (face == no_index && !passed_.empty() && passed_.back().face == no_index &&
      passed_.back().edge == edge) {
    passed_.pop_back();
    joints_.pop_back();
  }
  passed_.push_back({face, edge});
  joints_.push_back(joint);
  if (joint.point.is_vertex()) joints_.back().edge = no_index;
}

PathPiece CrossingPath::piece(std::size_t number) const {
  PathPiece piece;
  const auto& [face, edge] = passed_[number];
  place_joint(norms_, joints_[number], face, edge, piece.begin_at, piece.begin_along);
  place_joint(norms_, joints_[number + 1], face, edge, piece.end_at, piece.end_along);
  // Drifts are those from the end to the beginning, as the wave came the other way.
  const PathJoint& begin = joints_[number];
  const PathJoint& end = joints_[number + 1];
  const double at_begin = drift_to(norms_, begin, 0.0, face, edge);
  const double at_end = drift_to(norms_, end, 0.0, face, edge);
  piece.drift_at = at_begin - at_end;
  piece.drift_begin = drift_to(norms_, begin, 1.0, face, edge) - at_begin;
  piece.drift_end = at_end - drift_to(norms_, end, 1.0, face, edge);
  return piece;
}

/// Moves the joints between two fixed ones to where the pieces are shortest. \return their length.
double CrossingPath::refract_between(std::size_t begin, std::size_t end) {
  std::vector<PathPiece> pieces;
  std::vector<double> crossing;
  for (std::size_t i = begin; i < end; ++i) {
    pieces.push_back(piece(i));
    if (i > begin) crossing.push_back(joints_[i].fraction);
  }
  PathPiece& first = pieces.front();
  PathPiece& last = pieces.back();
  fix(joints_[begin], first.begin_at, first.begin_along, first.drift_at, first.drift_begin);
  fix(joints_[end], last.end_at, last.end_along, last.drift_at, last.drift_end);
  const double length = refract(pieces, crossing);
  for (std::size_t i = begin + 1; i < end; ++i) {
    joints_[i] = joint_on(norms_.mesh(), joints_[i].edge, crossing[i - begin - 1]);
  }
  return length;
}

/// Refracts each chain between joints that cannot move.
double CrossingPath::refract_all() {
  double length = 0.0;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < joints_.size(); ++i) {
    if (joints_[i].edge != no_index && i + 1 < joints_.size()) continue;
    length += refract_between(begin, i);
    begin = i;
  }
  return length;
}

// ---- Past vertices

namespace {

/// Where on an edge, as a fraction of it from the vertex that is passed, the search for the crossing begins.
constexpr double near_vertex = 0.1;

/// Lengths that differ by no more than this fraction are equal up to rounding.
constexpr double same_length = 1e-12;

/// The edge that two faces share at a vertex; `corner` and `next` are their half-edges that leave the vertex.
Index shared_edge(const Mesh& mesh, Index corner, Index next) {
  for (const Index a : {corner, Mesh::previous_in_face(corner)}) {
    for (const Index b : {next, Mesh::previous_in_face(next)}) {
      if (mesh.edge_of(a) == mesh.edge_of(b)) return mesh.edge_of(a);
    }
  }
  return no_index;
}

}  // namespace

/// Tries all paths past the vertex at which the joints between `begin` and `end` lie: on both sides of it,
/// from each face before it to each one behind it.
void CrossingPath::take_other_ways(std::size_t begin, std::size_t end, CrossingPath& best,
                                   double& least) const {
  const Mesh& mesh = norms_.mesh();
  const Index vertex = joints_[begin + 1].point.vertex;
  const auto corners = mesh.corners(vertex);
  const auto count = static_cast<std::ptrdiff_t>(corners.size());
  const bool is_cycle = mesh.fan(vertex) == Mesh::Fan::closed;
  auto touches = [&](const Passed& passed, Index corner) {
    if (passed.face != no_index) return Mesh::face_of(corner) == passed.face;
    return mesh.edge_of(corner) == passed.edge || mesh.edge_of(Mesh::previous_in_face(corner)) == passed.edge;
  };
  for (std::ptrdiff_t first = 0; first < count; ++first) {
    if (!touches(passed_[begin], corners[first])) continue;
    for (const std::ptrdiff_t turn : {1, -1}) {
      CrossingPath way(norms_, joints_[begin].point);
      way.joints_.front() = joints_[begin];
      std::ptrdiff_t at = first;
      for (std::ptrdiff_t steps = 0; steps < count; ++steps) {
        if (touches(passed_[end - 1], corners[at])) {
          CrossingPath whole = way;
          whole.passed_.push_back({Mesh::face_of(corners[at]), no_index});
          whole.joints_.push_back(joints_[end]);
          const double length = whole.refract_between(0, whole.joints_.size() - 1);
          if (length < least * (1.0 - same_length)) {
            least = length;
            best.joints_ = std::move(whole.joints_);
            best.passed_ = std::move(whole.passed_);
          }
        }
        std::ptrdiff_t next = at + turn;
        if (is_cycle) next = (next + count) % count;
        if (next < 0 || next >= count) break;
        const Index edge = shared_edge(mesh, corners[at], corners[next]);
        if (edge == no_index) break;
        way.passed_.push_back({Mesh::face_of(corners[at]), no_index});
        way.joints_.push_back(
            joint_on(mesh, edge, mesh.edge_vertices(edge)[0] == vertex ? near_vertex : 1.0 - near_vertex));
        at = next;
      }
    }
  }
}

/// \return whether the path became shorter.
bool CrossingPath::pass_vertices() {
  bool has_changed = false;
  for (std::size_t i = 1; i + 1 < joints_.size(); ++i) {
    const Index vertex = joints_[i].point.vertex;
    if (vertex == no_index || norms_.mesh().fan(vertex) == Mesh::Fan::non_manifold) continue;
    std::size_t end = i + 1;
    while (end + 1 < joints_.size() && joints_[end].point.vertex == vertex) ++end;
    if (joints_[i - 1].point.vertex == vertex || joints_[end].point.vertex == vertex) continue;
    const std::size_t begin = i - 1;
    checkpoint();
    CrossingPath now(norms_, joints_[begin].point);
    now.joints_.assign(joints_.begin() + static_cast<std::ptrdiff_t>(begin),
                       joints_.begin() + static_cast<std::ptrdiff_t>(end) + 1);
    now.passed_.assign(passed_.begin() + static_cast<std::ptrdiff_t>(begin),
                       passed_.begin() + static_cast<std::ptrdiff_t>(end));
    double least = now.refract_all();
    const double before = least;
    take_other_ways(begin, end, now, least);
    if (!(least < before)) continue;
    auto replace = [](auto& list, auto from, auto to, const auto& by, std::size_t skipped) {
      const auto place = list.erase(list.begin() + static_cast<std::ptrdiff_t>(from),
                                    list.begin() + static_cast<std::ptrdiff_t>(to));
      list.insert(place, by.begin() + static_cast<std::ptrdiff_t>(skipped),
                  by.end() - static_cast<std::ptrdiff_t>(skipped));
    };
    replace(joints_, begin + 1, end, now.joints_, 1);
    replace(passed_, begin, end, now.passed_, 0);
    i = begin + now.joints_.size() - 2;
    has_changed = true;
  }
  return has_changed;
}

double CrossingPath::straighten() {
  double length = refract_all();
  // This loop ends: the path becomes shorter each time.
  while (pass_vertices()) {
    const double shorter = refract_all();
    if (!(shorter < length * (1.0 - same_length))) return std::min(shorter, length);
    length = shorter;
  }
  return length;
}

std::vector<SurfacePoint> CrossingPath::points() const {
  std::vector<SurfacePoint> points;
  for (const PathJoint& joint : joints_) {
    if (points.empty() || !(points.back() == joint.point)) points.push_back(joint.point);
  }
  return points;
}

}  // namespace vorogeo
