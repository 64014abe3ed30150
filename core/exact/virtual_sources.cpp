// Propagation of virtual sources in order of distance.
#include "exact/virtual_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/length_limits.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Width of a bucket of the queue, in typical edges.
constexpr double face_bucket_width = 0.5;

/// How far beside the ray through a vertex, in lengths of the edge that is crossed, a point is still reached
/// by passing that vertex on its other side: farther away, other vertices are likely to be in between.
constexpr double max_aside = 0.6;

using PlanePoint = std::array<double, 2>;

double between(const PlanePoint& a, const PlanePoint& b) {
  const double x = a[0] - b[0];
  const double y = a[1] - b[1];
  return std::sqrt(x * x + y * y);
}

/// Above 0 if c lies to the left of the ray from a through b.
double side(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Moves points from the frame of one half-edge into that of another one of the same face.
struct FrameChange {
  PlanePoint origin;     ///< the tail of the other half-edge
  PlanePoint direction;  ///< from there to its head, of length 1

  PlanePoint operator()(const PlanePoint& p) const {
    const double x = p[0] - origin[0];
    const double y = p[1] - origin[1];
    return {x * direction[0] + y * direction[1], y * direction[0] - x * direction[1]};
  }
};

}  // namespace

VirtualSources::VirtualSources(std::shared_ptr<const Mesh> mesh)
    : mesh_(std::move(mesh)), faces_(mesh_->face_count()) {
  require_agreeing_faces(*mesh_, "Quick distances");
  require_lengths(*mesh_, "quick distances take", exact_lengths.least_mean, exact_lengths.greatest);
  apexes_.resize(3 * faces_.size());
  for (Index f = 0; f < mesh_->face_count(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    const double area = 2.0 * mesh_->face_area(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const double edge = length(h);
      const double to_head = length(Mesh::next_in_face(h));
      const double to_tail = length(Mesh::previous_in_face(h));
      apexes_[h] = edge > 0.0
                       ? Apex{0.5 * (edge + (to_tail - to_head) * (to_tail + to_head) / edge), area / edge}
                       : Apex{0.0, to_tail};
    }
  }
  defect_.resize(mesh_->vertex_count());
  for (Index v = 0; v < mesh_->vertex_count(); ++v) {
    const double defect = 2.0 * std::numbers::pi - mesh_->total_angle(v);
    defect_[v] = mesh_->fan(v) == Mesh::Fan::closed ? PlanePoint{std::cos(defect), std::sin(defect)}
                                                    : PlanePoint{2.0, 0.0};
  }
  queue_.resize(faces_.size());
}

void VirtualSources::run(std::span<const ExactSource> sources, double max_distance) {
  const std::vector<ExactSource> checked = validated(*mesh_, sources);
  max_distance_ = max_distance;
  faces_.assign(faces_.size(), {});
  distance_.assign(mesh_->vertex_count(), unreachable);
  label_.assign(mesh_->vertex_count(), no_index);
  queue_.reset(face_bucket_width * mesh_->typical_edge_length());
  turning_.clear();
  for (std::size_t i = 0; i < checked.size(); ++i)
    start_at(checked[i].point, checked[i].offset, static_cast<Index>(i));
  Index taken = 0;
  // This loop ends: a face or a vertex is added only where its distance decreases by more than rounding.
  for (;;) {
    while (!turning_.empty()) {
      const Index vertex = turning_.back();
      turning_.pop_back();
      start_at(SurfacePoint::at_vertex(vertex), distance_[vertex], label_[vertex]);
    }
    const Index face = queue_.pop();
    if (face == no_index) return;
    if (++taken % elements_per_checkpoint == 0) checkpoint();
    hand_on(face);
  }
}

void VirtualSources::reach_vertex(Index vertex, double distance, Index source) {
  if (!(distance < distance_[vertex]) || distance > max_distance_) return;
  // Faces that meet in this vertex only are not reached across edges.
  if (mesh_->fan(vertex) == Mesh::Fan::non_manifold && distance < distance_[vertex] * (1.0 - 1e-12)) {
    turning_.push_back(vertex);
  }
  distance_[vertex] = distance;
  label_[vertex] = source;
}

void VirtualSources::take(const FaceSource& found) {
  const Index face = Mesh::face_of(found.base);
  FaceSource& old = faces_[face];
  // Without this threshold, negligible gains would circle a vertex forever.
  if (!(found.distance < old.distance * (1.0 - 1e-12))) return;
  old = found;
  // A face beyond the limit is not left again; one that the limit cuts is.
  const double reach = std::max(length(found.base), apexes_[found.base].y);
  if (found.distance - reach <= max_distance_) queue_.push(face, found.distance);
}

/// Starts in all faces that hold the point.
void VirtualSources::start_at(const SurfacePoint& point, double offset, Index id) {
  if (point.is_vertex()) reach_vertex(point.vertex, offset, id);
  for_each_face_at(*mesh_, point, [&](Index face, const std::array<double, 3>& weights) {
    const Index base = 3 * face;
    const double edge = length(base);
    const PlanePoint apex{apexes_[base].x, apexes_[base].y};
    FaceSource found;
    found.at = {weights[1] * edge + weights[2] * apex[0], weights[2] * apex[1]};
    found.sigma = offset;
    found.base = base;
    found.source = id;
    found.distance = offset + between(found.at, {(edge + apex[0]) / 3.0, apex[1] / 3.0});
    const PlanePoint corners[3] = {{0.0, 0.0}, {edge, 0.0}, apex};
    for (int i = 0; i < 3; ++i) {
      reach_vertex(mesh_->face_vertices(face)[i], offset + between(found.at, corners[i]), id);
    }
    take(found);
  });
}

/// Hands the source of a face to all faces around it, except through the edge by which it came.
void VirtualSources::hand_on(Index face) {
  const FaceSource own = faces_[face];
  const double edge = length(own.base);
  const PlanePoint head{edge, 0.0};
  const PlanePoint apex{apexes_[own.base].x, apexes_[own.base].y};
  const bool is_start = own.left.vertex == no_index && own.right.vertex == no_index;
  Index exit = own.base;
  for (const auto& [from, to] : {std::pair(PlanePoint{}, head), {head, apex}, {apex, PlanePoint{}}}) {
    const Index h = exit;
    exit = Mesh::next_in_face(exit);
    const double exit_length = between(from, to);
    if ((h == own.base && !is_start) || !(exit_length > 0.0)) continue;
    const FrameChange to_exit{from, {(to[0] - from[0]) / exit_length, (to[1] - from[1]) / exit_length}};
    FaceSource seen = own;
    seen.at = to_exit(own.at);
    seen.left.at = to_exit(own.left.at);
    seen.right.at = to_exit(own.right.at);
    for (Index g = mesh_->next_around_edge(h); g != h; g = mesh_->next_around_edge(g)) {
      if (own.distance >= faces_[Mesh::face_of(g)].distance) continue;
      // Half a turn, or a reflection where both faces run along the edge in one direction.
      const bool same = mesh_->tail(g) == mesh_->tail(h);
      auto moved = [&](const PlanePoint& p) { return PlanePoint{same ? p[0] : exit_length - p[0], -p[1]}; };
      FaceSource across = seen;
      across.at = moved(seen.at);
      across.left.at = moved(same ? seen.right.at : seen.left.at);
      across.left.vertex = same ? own.right.vertex : own.left.vertex;
      across.right.at = moved(same ? seen.left.at : seen.right.at);
      across.right.vertex = same ? own.left.vertex : own.right.vertex;
      enter(across, g);
    }
  }
}

/// Enters the face of the half-edge `base`, in whose frame the source and its bounds are given.
void VirtualSources::enter(const FaceSource& crossing, Index base) {
  const PlanePoint head{length(base), 0.0};
  const PlanePoint apex{apexes_[base].x, apexes_[base].y};
  FaceSource seen = crossing;
  seen.base = base;
  // The ends of the edge bound the sector where they lie inside it.
  if (crossing.left.vertex == no_index || side(seen.at, crossing.left.at, {}) <= 0.0) {
    seen.left = {{}, mesh_->tail(base)};
  }
  if (crossing.right.vertex == no_index || side(seen.at, crossing.right.at, head) >= 0.0) {
    seen.right = {head, mesh_->head(base)};
  }
  const FaceSource of_apex = source_of(seen, apex);
  reach_vertex(mesh_->apex(base), of_apex.sigma + between(of_apex.at, apex), of_apex.source);
  const PlanePoint centre{(head[0] + apex[0]) / 3.0, apex[1] / 3.0};
  FaceSource found = source_of(seen, centre);
  found.distance = found.sigma + between(found.at, centre);
  take(found);
}

/// The source from which a point of the face is reached.
VirtualSources::FaceSource VirtualSources::source_of(const FaceSource& seen, const PlanePoint& point) const {
  if (side(seen.at, seen.left.at, point) > 0.0) return beyond_bound(seen, true, point);
  if (side(seen.at, seen.right.at, point) < 0.0) return beyond_bound(seen, false, point);
  return seen;
}

VirtualSources::FaceSource VirtualSources::beyond_bound(const FaceSource& seen, bool left,
                                                        const PlanePoint& point) const {
  const Bound& bound = left ? seen.left : seen.right;
  const Bound tail{{}, mesh_->tail(seen.base)};
  const Bound head{{length(seen.base), 0.0}, mesh_->head(seen.base)};
  const bool at_end = bound.vertex == tail.vertex || bound.vertex == head.vertex;
  FaceSource found = seen;
  const auto [cosine, sine] = defect_[bound.vertex];
  if (cosine <= 1.0 && !at_end) {
    const double signed_sine = left ? -sine : sine;
    const double x = seen.at[0] - bound.at[0];
    const double y = seen.at[1] - bound.at[1];
    found.at = {bound.at[0] + cosine * x - signed_sine * y, bound.at[1] + signed_sine * x + cosine * y};
    const double aside = side(found.at, bound.at, point) * (left ? 1.0 : -1.0);
    const bool is_close = aside > 0.0 && aside <= max_aside * head.at[0] * between(found.at, bound.at);
    if (is_close && side(found.at, tail.at, point) <= 0.0 && side(found.at, head.at, point) >= 0.0) {
      found.left = left ? tail : bound;
      found.right = left ? bound : head;
      return found;
    }
  }
  found.at = bound.at;
  found.sigma = seen.sigma + between(seen.at, bound.at);
  // The vertex may have been reached by a shorter path.
  if (distance_[bound.vertex] < found.sigma) {
    found.sigma = distance_[bound.vertex];
    found.source = label_[bound.vertex];
  }
  found.left = at_end ? Bound{} : tail;
  found.right = at_end ? Bound{} : head;
  return found;
}

std::size_t VirtualSources::memory_bytes() const {
  return faces_.capacity() * (sizeof(FaceSource) + sizeof(std::int64_t)) + apexes_.capacity() * sizeof(Apex) +
         defect_.capacity() * sizeof(PlanePoint) + distance_.capacity() * sizeof(double) +
         (label_.capacity() + turning_.capacity()) * sizeof(Index);
}

}  // namespace vorogeo
