// The plane geometry of a mesh that the exact solver needs: computed once, shared by all solvers of a mesh.
#include "exact/exact_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/outliers.h"
#include "mesh/vectors.h"
#include "support/disjoint_sets.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Unfolds each face next to each of its edges and lays out the corners around each vertex

namespace {

/// Angle deficits below this are treated as flat: a path may then pass through the vertex as through a
/// saddle.
constexpr double flat_tolerance = 1e-7;

FaceFrame frame_of(const ExactGeometry& geometry, Index halfedge) {
  const Mesh& mesh = *geometry.mesh;
  const Index edge = mesh.edge_of(halfedge);
  FaceFrame frame{};
  frame.apex = mesh.apex(halfedge);
  frame.along = mesh.tail(halfedge) == geometry.ends(edge)[0];
  const Index first_edge = mesh.edge_of(frame.first_side(halfedge));
  const Index second_edge = mesh.edge_of(frame.second_side(halfedge));
  frame.first_side_reversed = geometry.ends(first_edge)[0] == frame.apex;
  frame.second_side_reversed = geometry.ends(second_edge)[0] == frame.apex;
  const double length = mesh.edge_length(edge);
  if (!(length > 0.0)) return frame;
  // Computed from positions where edges have their lengths in space: the lengths of a needle or of a nearly
  // flat face, each rounded, tell next to nothing about its angles. Measured from the nearer end of the edge,
  // as the difference of two large numbers loses digits.
  const auto corners = mesh.face_corners(Mesh::face_of(halfedge));
  const int tail = halfedge % 3;
  const Point& p = corners[frame.along ? tail : (tail + 1) % 3];
  const Point& q = corners[frame.along ? (tail + 1) % 3 : tail];
  const Point& r = corners[(tail + 2) % 3];
  const bool nearer_first = mesh.edge_length(first_edge) <= mesh.edge_length(second_edge);
  const Point side = minus(r, nearer_first ? p : q);
  // The unit vector has length 1 to the last digit. The edge's own length would not give that where the sides
  // of a face without width contradict each other: a long side beside a short edge would miss its end.
  Point along = minus(q, p);
  const double laid_length = length_of(along);
  for (double& part : along) part /= laid_length > 0.0 ? laid_length : length;
  const double x = dot(side, along);
  frame.apex_x = nearer_first ? x : length + x;
  frame.apex_depth =
      std::hypot(side[1] * along[2] - side[2] * along[1], side[2] * along[0] - side[0] * along[2],
                 side[0] * along[1] - side[1] * along[0]);
  return frame;
}

}  // namespace

ExactGeometry::ExactGeometry(std::shared_ptr<const Mesh> shared_mesh) : mesh(std::move(shared_mesh)) {
  if (!mesh->metric_agrees_somewhere()) require_agreeing_faces(*mesh, "Windows");
  require_lengths(*mesh, "exact distances take", exact_lengths);
  find_long_edges();
  const Index halfedges = 3 * mesh->face_count();
  frame.resize(halfedges);
  parallel_ranges(halfedges, [&](Index begin, Index end) {
    for (Index h = begin; h < end; ++h) frame[h] = frame_of(*this, h);
  });

  can_bend.assign(mesh->vertex_count(), never);
  std::vector<double> longest(mesh->vertex_count(), 0.0);
  for (const Index e : checked(mesh->edge_count())) {
    for (Index v : mesh->edge_vertices(e)) longest[v] = std::max(longest[v], mesh->edge_length(e));
  }
  for (const Index e : checked(mesh->edge_count())) {
    for (Index v : mesh->edge_vertices(e)) {
      if (mesh->edge_length(e) <= next_to_nothing * longest[v]) can_bend[v] = anywhere;
    }
  }
  flat_height.assign(mesh->vertex_count(), 0.0f);
  corner_begin.assign(halfedges, 0.0);
  begins_at_own_edge.assign(halfedges, 1);
  parallel_ranges(mesh->vertex_count(), [&](Index begin, Index end) {
    for (Index v = begin; v < end; ++v) lay_out_corners(v);
  });
}

/// The angles at which the corners around a vertex begin, and whether paths can bend there.
void ExactGeometry::lay_out_corners(Index vertex) {
  const auto fan = mesh->fan(vertex);
  if (fan == Mesh::Fan::non_manifold) can_bend[vertex] = anywhere;
  const bool is_saddle =
      fan == Mesh::Fan::closed && mesh->total_angle(vertex) > 2.0 * std::numbers::pi - flat_tolerance;
  if (can_bend[vertex] == never && (fan == Mesh::Fan::open || is_saddle)) can_bend[vertex] = by_angle;
  if (fan != Mesh::Fan::open && fan != Mesh::Fan::closed) return;
  const double of_plane = (fan == Mesh::Fan::open ? 1.0 : 2.0) * std::numbers::pi;
  if (can_bend[vertex] == by_angle && std::abs(mesh->total_angle(vertex) - of_plane) <= flat_tolerance) {
    double least = unreachable;
    for (Index corner : mesh->corners(vertex)) {
      least = std::min(least, frame[Mesh::next_in_face(corner)].apex_depth);
    }
    flat_height[vertex] = static_cast<float>(least);
  }
  const auto corners = mesh->corners(vertex);
  // The first corner begins at its edge on a border of the mesh, if there is one; each of the others where
  // the previous one ended.
  Index entered = corners[0];
  if (fan == Mesh::Fan::open && mesh->next_around_edge(entered) != entered) {
    entered = Mesh::previous_in_face(entered);
  }
  double angle = 0.0;
  for (Index corner : corners) {
    begins_at_own_edge[corner] = entered == corner;
    if (can_bend[vertex] == by_angle) {
      corner_begin[corner] = angle;
      angle += mesh->corner_angle(corner);
    }
    entered = mesh->next_around_edge(entered == corner ? Mesh::previous_in_face(corner) : corner);
  }
}

namespace {

/// What is connected by short edges, with the number of its vertices and its shortest edge.
class Pieces {
 public:
  /// Each vertex alone. `shortest`: the length of its shortest edge.
  explicit Pieces(std::vector<double> shortest)
      : sets_(static_cast<Index>(shortest.size())), size_(shortest.size(), 1), finest_(std::move(shortest)) {}

  void join(std::array<Index, 2> ends) {
    const auto [kept, other] = std::minmax({sets_.root(ends[0]), sets_.root(ends[1])});
    if (kept == other) return;
    sets_.join_at_least(kept, other);
    size_[kept] += size_[other];
    finest_[kept] = std::min(finest_[kept], finest_[other]);
  }
  bool are_apart(Index a, Index b) { return sets_.root(a) != sets_.root(b); }
  /// Whether the piece of a has more vertices than that of b, or as many and a shorter edge.
  bool is_larger(Index a, Index b) {
    a = sets_.root(a);
    b = sets_.root(b);
    return std::tuple(size_[a], finest_[b], a) > std::tuple(size_[b], finest_[a], b);
  }

 private:
  DisjointSets sets_;
  std::vector<Index> size_;
  std::vector<double> finest_;
};

}  // namespace

void ExactGeometry::find_long_edges() {
  std::vector<double> shortest(mesh->vertex_count(), unreachable);
  for (const Index e : checked(mesh->edge_count())) {
    const double length = mesh->edge_length(e);
    if (!(length > 0.0)) continue;
    for (Index v : mesh->edge_vertices(e)) shortest[v] = std::min(shortest[v], length);
  }
  const double typical = mesh->typical_edge_length();
  const auto count_from_second = [&](Index e, bool second) {
    turned.resize(mesh->edge_count(), 0);
    fineness.resize(mesh->edge_count(), 0.0);
    turned[e] = second;
    fineness[e] = std::min(shortest[mesh->edge_vertices(e)[second ? 1 : 0]], typical);
  };
  std::vector<Index> far_longer;  // than the typical edge
  for (const Index e : checked(mesh->edge_count())) {
    const auto [a, b] = mesh->edge_vertices(e);
    const double length = mesh->edge_length(e);
    if (length > outlier_edges * typical) far_longer.push_back(e);
    const double small = std::min(shortest[a], shortest[b]);
    if (!(length > long_edge * typical || length > long_beside_small * small)) continue;
    count_from_second(e, shortest[b] < shortest[a]);
  }
  if (far_longer.empty()) return;
  // Outliers may be close to each other, too, so short edges do not tell where the mesh is: positions count
  // from the end at which most of the mesh is, and on edges of about one length between two pieces from the
  // same side, or windows would come back changed by rounding. A piece is what edges far shorter than the one
  // between two connect: where a tiny part makes all others long, these still tell what an outlier is far
  // away from.
  Pieces pieces(shortest);
  for (const Index e : checked(mesh->edge_count())) {
    if (!(mesh->edge_length(e) > outlier_edges * typical)) pieces.join(mesh->edge_vertices(e));
  }
  std::ranges::sort(far_longer, {}, [&](Index e) { return mesh->edge_length(e); });
  auto next = far_longer.begin();
  for (const Index e : far_longer) {
    const double far_shorter = mesh->edge_length(e) / outlier_edges;
    for (; mesh->edge_length(*next) <= far_shorter; ++next) pieces.join(mesh->edge_vertices(*next));
    const auto [a, b] = mesh->edge_vertices(e);
    if (is_long(e) && pieces.are_apart(a, b)) count_from_second(e, pieces.is_larger(b, a));
  }
}

// ---- Corners of a face in its plane, from the frame of its first half-edge

FacePlane::FacePlane(const ExactGeometry& geometry, Index face) {
  const Mesh& mesh = *geometry.mesh;
  const FaceFrame& frame = geometry.frame[3 * face];
  const Index edge = mesh.edge_of(3 * face);
  const double length = mesh.edge_length(edge);
  // The origin is where positions on the edge count from: at the other end, digits may be lost.
  const bool along = geometry.ends(edge)[0] == mesh.face_vertices(face)[0];
  corner[0] = {along ? 0.0 : -length, 0.0};
  corner[1] = {along ? length : 0.0, 0.0};
  corner[2] = {along ? frame.apex_x : -frame.apex_x, frame.apex_depth};
  // Where two corners coincide, the third is equally far from both, in any direction.
  if (!(length > 0.0)) corner[2] = {mesh.edge_length(mesh.edge_of(3 * face + 1)), 0.0};
}

std::array<double, 2> FacePlane::at(const std::array<double, 3>& barycentric) const {
  std::array<double, 2> point{};
  for (int i = 0; i < 3; ++i) {
    point[0] += barycentric[i] * corner[i][0];
    point[1] += barycentric[i] * corner[i][1];
  }
  return point;
}

}  // namespace vorogeo
