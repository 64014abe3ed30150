// The front, in buckets of distance; a vertex that is relaxed after it was processed is processed again, a
// few times.
#include "partition/front.h"

#include "mesh/unfolded_distance.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Bucket width in typical edge lengths, or in edges.
constexpr double bucket_width = 0.5;
/// Around faces without area, vertices may relax each other without end, by ever smaller amounts: a smaller
/// gain than this (relative) is ignored, and a vertex is relaxed at most `max_relaxed` times.
constexpr double least_gain = 1.0 - 1e-9;
constexpr std::uint8_t max_relaxed = 64;
constexpr int vertices_per_checkpoint = 4096;

}  // namespace

Front::Front(const Mesh& mesh, FrontMeasure measure)
    : mesh_(mesh),
      measure_(measure),
      distance_(mesh.vertex_count(), unreachable),
      source_(mesh.vertex_count(), no_index),
      relaxed_(mesh.vertex_count(), 0) {
  queue_.resize(mesh.vertex_count());
}

void Front::relax(Index vertex, double distance, Index source) {
  if (!(distance < least_gain * distance_[vertex]) || relaxed_[vertex] == max_relaxed) return;
  if (distance_[vertex] == unreachable) touched_.push_back(vertex);
  ++relaxed_[vertex];
  distance_[vertex] = distance;
  source_[vertex] = source;
  queue_.push(vertex, distance);
}

/// Relaxes the third vertex of a face, at the head of the half-edge that leaves `vertex` or at its tail.
void Front::pass(Index vertex, Index halfedge) {
  const Index edge = mesh_.edge_of(halfedge);
  const bool forth = mesh_.tail(halfedge) == vertex;
  const Index target = forth ? mesh_.head(halfedge) : mesh_.tail(halfedge);
  if (measure_ == FrontMeasure::edge_count) {
    relax(target, distance_[vertex] + 1.0, source_[vertex]);
    return;
  }
  const Index other = mesh_.apex(halfedge);
  const double length = mesh_.edge_length(edge);
  double distance = distance_[vertex] + length;
  if (source_[other] == source_[vertex]) {
    // The edge opposite to the target leads from the vertex to the other one.
    const Index across = forth ? Mesh::previous_in_face(halfedge) : Mesh::next_in_face(halfedge);
    const Index third = forth ? Mesh::next_in_face(halfedge) : Mesh::previous_in_face(halfedge);
    const double straight =
        unfolded_distance(mesh_.edge_length(mesh_.edge_of(across)), distance_[vertex], distance_[other],
                          length, mesh_.edge_length(mesh_.edge_of(third)));
    // A front only advances: values that rounding on needles makes smaller than at both ends are not used.
    if (straight >= std::fmin(distance_[vertex], distance_[other])) distance = std::fmin(distance, straight);
  }
  relax(target, distance, source_[vertex]);
}

void Front::grow(std::span<const Index> sources, std::span<const std::uint8_t> face_allowed) {
  for (Index v : touched_) {
    distance_[v] = unreachable;
    source_[v] = no_index;
    relaxed_[v] = 0;
  }
  touched_.clear();
  queue_.reset(bucket_width * (measure_ == FrontMeasure::distance ? mesh_.typical_edge_length() : 1.0));
  for (std::size_t i = 0; i < sources.size(); ++i) relax(sources[i], 0.0, static_cast<Index>(i));
  int taken = 0;
  for (Index v = queue_.pop(); v != no_index; v = queue_.pop()) {
    if (++taken % vertices_per_checkpoint == 0) checkpoint();
    for (Index corner : mesh_.corners(v)) {
      if (!face_allowed.empty() && !face_allowed[Mesh::face_of(corner)]) continue;
      pass(v, corner);
      pass(v, Mesh::previous_in_face(corner));
    }
  }
}

}  // namespace vorogeo
