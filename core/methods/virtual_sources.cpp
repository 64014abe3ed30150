// Propagation of virtual sources in order of distance.
#include "methods/virtual_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/mesh.h"
#include "support/parallel.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// Width of a bucket of the queue, in typical edges.
constexpr double face_bucket_width = 0.5;

/// How far beside the ray through a vertex, in lengths of the edge that is crossed, a point is still reached
/// by passing that vertex on its other side: farther away, other vertices are likely to be in between.
constexpr double max_aside = 0.6;

/// Edges shorter than this part of the longest one of their two faces are passed at an end, not crossed: an
/// apex is placed with so much rounding that their direction is unknown.
constexpr double least_length = 1e-12;

}  // namespace

VirtualSources::VirtualSources(std::shared_ptr<const Mesh> mesh)
    : mesh_(std::move(mesh)), faces_(mesh_->face_count()) {
  require_lengths(*mesh_, "virtual sources take", exact_lengths);
  records_.resize(faces_.size());
  parallel_ranges(mesh_->face_count(), [&](Index begin, Index end) {
    for (Index f = begin; f < end; ++f) {
      FaceRecord& record = records_[f];
      for (int i = 0; i < 3; ++i) {
        record.length[i] = mesh_->edge_length(mesh_->edge_of(3 * f + i));
        record.next[i] = mesh_->next_around_edge(3 * f + i);
      }
      record.vertex = mesh_->face_vertices(f);
      record.twice_area = 2.0 * mesh_->face_area(f);
    }
  });
  vertices_.resize(mesh_->vertex_count());
  parallel_ranges(mesh_->vertex_count(), [&](Index begin, Index end) {
    for (Index v = begin; v < end; ++v) {
      const double defect = 2.0 * std::numbers::pi - mesh_->total_angle(v);
      vertices_[v].defect = mesh_->fan(v) == Mesh::Fan::closed
                                ? PlanePoint{std::cos(defect), std::sin(defect)}
                                : PlanePoint{2.0, 0.0};
    }
  });
  queue_.resize(faces_.size());
}

inline VirtualSources::FaceOver VirtualSources::over(const FaceRecord& face, int side) {
  const int next = side == 2 ? 0 : side + 1;
  const int previous = side == 0 ? 2 : side - 1;
  const double edge = face.length[side];
  const double to_head = face.length[next];
  const double to_tail = face.length[previous];
  PlanePoint apex{0.0, to_tail};
  if (edge > 0.0) {
    const double per_edge = 1.0 / edge;
    apex = {0.5 * (edge + (to_tail - to_head) * (to_tail + to_head) * per_edge), face.twice_area * per_edge};
  }
  return {edge, apex, face.vertex[side], face.vertex[next], face.vertex[previous]};
}

void VirtualSources::run(std::span<const Index> sources) {
  for (FaceRecord& face : records_) face.distance = unreachable;
  for (VertexRecord& vertex : vertices_) vertex.distance = unreachable;
  queue_.reset(face_bucket_width * mesh_->typical_edge_length());
  turning_.clear();
  for (const Index source : sources) {
    const Index vertex = mesh_->representative(source);
    vertices_[vertex].distance = 0.0;
    start_at(vertex);
  }
  Index taken = 0;
  // This loop ends: a face or a vertex is added only where its distance decreases by more than rounding.
  for (;;) {
    while (!turning_.empty()) {
      const Index vertex = turning_.back();
      turning_.pop_back();
      start_at(vertex);
    }
    const Index face = queue_.pop();
    if (face == no_index) return;
    if (++taken % elements_per_checkpoint == 0) checkpoint();
    hand_on(face);
  }
}

void VirtualSources::reach_vertex(Index vertex, double distance) {
  VertexRecord& record = vertices_[vertex];
  if (!(distance < record.distance)) return;
  // Faces that meet in this vertex only are not reached across edges. The cosine is tested first, as reading
  // the fan is a cache miss.
  if (record.defect[0] > 1.0 && mesh_->fan(vertex) == Mesh::Fan::non_manifold &&
      distance < record.distance * (1.0 - 1e-12)) {
    turning_.push_back(vertex);
  }
  record.distance = distance;
}

/// Gives a face a source that is nearer to its centroid.
void VirtualSources::take(const FaceSource& found, double distance) {
  const Index face = Mesh::face_of(found.base);
  records_[face].distance = distance;
  faces_[face] = found;
  queue_.push(face, distance);
}

/// Starts at a corner of a face whose vertex has been reached.
void VirtualSources::start_in(Index corner) {
  const Index face = Mesh::face_of(corner);
  // Over its longest side: over one of next to no length, the place of the apex would be rounding.
  const FaceRecord& record = records_[face];
  const auto side = static_cast<int>(std::ranges::max_element(record.length) - record.length.begin());
  const auto [edge, apex, tail, head, opposite] = over(record, side);
  const int own = corner % 3;
  const double offset = vertices_[record.vertex[own]].distance;
  FaceSource found;
  found.at = own == side ? PlanePoint{} : own == (side + 1) % 3 ? PlanePoint{edge, 0.0} : apex;
  found.sigma = offset;
  found.base = 3 * face + side;
  reach_vertex(tail, offset + straight_in_plane(found.at, {0.0, 0.0}));
  reach_vertex(head, offset + straight_in_plane(found.at, {edge, 0.0}));
  reach_vertex(opposite, offset + straight_in_plane(found.at, apex));
  const double distance = offset + straight_in_plane(found.at, {(edge + apex[0]) / 3.0, apex[1] / 3.0});
  if (is_nearer(face, distance)) take(found, distance);
}

/// Starts in all faces at a vertex that has been reached.
void VirtualSources::start_at(Index vertex) {
  for (const Index corner : mesh_->corners(vertex)) start_in(corner);
}

/// Hands the source of a face to all faces around it that are farther away, except through the edge by which
/// it came.
void VirtualSources::hand_on(Index face) {
  const FaceRecord& record = records_[face];
  const FaceSource& own = faces_[face];
  int side = own.base - 3 * face;
  const auto [edge, apex, tail, head, opposite] = over(record, side);
  const bool is_start = own.left.vertex == no_index && own.right.vertex == no_index;
  const std::array<PlanePoint, 4> corner{PlanePoint{}, PlanePoint{edge, 0.0}, apex, PlanePoint{}};
  for (int i = 0; i < 3; ++i, side = side == 2 ? 0 : side + 1) {
    if (i == 0 && !is_start) continue;
    const Index h = 3 * face + side;
    for (Index g = record.next[side]; g != h; g = records_[Mesh::face_of(g)].next[g % 3]) {
      const FaceRecord& other = records_[Mesh::face_of(g)];
      if (record.distance >= other.distance) continue;
      const PlanePoint& from = corner[i];
      const PlanePoint& to = corner[i + 1];
      const double length = record.length[side];
      const double longest = std::max(std::ranges::max(record.length), std::ranges::max(other.length));
      if (!(length > least_length * longest)) {
        // Both its ends are one place, from which the face behind may be reached alone.
        if (vertices_[other.vertex[g % 3]].distance < unreachable) start_in(g);
        continue;
      }
      const double scale = 1.0 / length;
      const PlanePoint direction{(to[0] - from[0]) * scale, (to[1] - from[1]) * scale};
      // Half a turn, or a reflection where both faces run along the edge in one direction.
      const bool same = other.vertex[g % 3] == record.vertex[side];
      auto moved = [&](const PlanePoint& p) {
        const double x = p[0] - from[0];
        const double y = p[1] - from[1];
        const double along = x * direction[0] + y * direction[1];
        return PlanePoint{same ? along : length - along, x * direction[1] - y * direction[0]};
      };
      const Bound& left = same ? own.right : own.left;
      const Bound& right = same ? own.left : own.right;
      FaceSource crossing;
      crossing.at = moved(own.at);
      crossing.sigma = own.sigma;
      crossing.left = {moved(left.at), left.vertex};
      crossing.right = {moved(right.at), right.vertex};
      crossing.base = g;
      enter(crossing);
    }
  }
}

/// Enters the face of the half-edge `crossing.base`, in whose frame the source and its bounds are given.
void VirtualSources::enter(const FaceSource& crossing) {
  const FaceRecord& record = records_[Mesh::face_of(crossing.base)];
  const FaceOver face = over(record, crossing.base % 3);
  const PlanePoint& apex = face.apex;
  const PlanePoint head{face.edge, 0.0};
  FaceSource seen = crossing;
  // The ends of the edge bound the sector where they lie inside it.
  if (crossing.left.vertex == no_index || turn_in_plane(seen.at, crossing.left.at, {}) <= 0.0) {
    seen.left = {{}, face.tail};
  }
  if (crossing.right.vertex == no_index || turn_in_plane(seen.at, crossing.right.at, head) >= 0.0) {
    seen.right = {head, face.head};
  }
  const Reached at_apex = reached(seen, face, apex);
  reach_vertex(face.opposite, at_apex.sigma + straight_in_plane(at_apex.at, apex));
  const PlanePoint centre{(face.edge + apex[0]) * (1.0 / 3.0), apex[1] * (1.0 / 3.0)};
  const Reached at_centre = reached(seen, face, centre);
  const double distance = at_centre.sigma + straight_in_plane(at_centre.at, centre);
  if (!is_nearer(Mesh::face_of(crossing.base), distance)) return;
  seen.at = at_centre.at;
  seen.sigma = at_centre.sigma;
  const Bound tail_bound{{}, face.tail};
  const Bound head_bound{head, face.head};
  switch (at_centre.how) {
    case Reached::directly:
      break;
    case Reached::past_left:
      seen.right = seen.left;
      seen.left = tail_bound;
      break;
    case Reached::past_right:
      seen.left = seen.right;
      seen.right = head_bound;
      break;
    case Reached::round_bound:
      seen.left = tail_bound;
      seen.right = head_bound;
      break;
    case Reached::round_end:
      seen.left = seen.right = {};
      break;
  }
  take(seen, distance);
}

inline VirtualSources::Reached VirtualSources::reached(const FaceSource& seen, const FaceOver& face,
                                                       const PlanePoint& point) const {
  if (turn_in_plane(seen.at, seen.left.at, point) > 0.0) return beyond_bound(seen, face, true, point);
  if (turn_in_plane(seen.at, seen.right.at, point) < 0.0) return beyond_bound(seen, face, false, point);
  return {seen.at, seen.sigma, Reached::directly};
}

VirtualSources::Reached VirtualSources::beyond_bound(const FaceSource& seen, const FaceOver& face, bool left,
                                                     const PlanePoint& point) const {
  const Bound& bound = left ? seen.left : seen.right;
  const VertexRecord& vertex = vertices_[bound.vertex];
  const bool at_end = bound.vertex == face.tail || bound.vertex == face.head;
  const double x = seen.at[0] - bound.at[0];
  const double y = seen.at[1] - bound.at[1];
  const double beyond = std::sqrt(x * x + y * y);
  if (!at_end) {
    const auto [cosine, sine] = vertex.defect;
    if (cosine <= 1.0) {
      const double signed_sine = left ? -sine : sine;
      const PlanePoint at{bound.at[0] + cosine * x - signed_sine * y,
                          bound.at[1] + signed_sine * x + cosine * y};
      const double aside = turn_in_plane(at, bound.at, point) * (left ? 1.0 : -1.0);
      const bool is_close = aside > 0.0 && aside <= max_aside * face.edge * beyond;
      if (is_close && turn_in_plane(at, {}, point) <= 0.0 &&
          turn_in_plane(at, {face.edge, 0.0}, point) >= 0.0) {
        return {at, seen.sigma, left ? Reached::past_left : Reached::past_right};
      }
    }
  }
  const Reached::How how = at_end ? Reached::round_end : Reached::round_bound;
  const double sigma = seen.sigma + beyond;
  // The vertex may have been reached by a shorter path.
  return {bound.at, std::min(vertex.distance, sigma), how};
}

std::size_t VirtualSources::memory_bytes() const {
  return faces_.capacity() * sizeof(FaceSource) + queue_.memory_bytes() +
         records_.capacity() * sizeof(FaceRecord) + vertices_.capacity() * sizeof(VertexRecord) +
         turning_.capacity() * sizeof(Index);
}

}  // namespace vorogeo
