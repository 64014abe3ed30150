// Well-spread samples, fronts that pass from edge to edge, and the Voronoi cells they leave.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/outliers.h"
#include "support/bucket_queue.h"

namespace vorogeo {

// ---- Approximate distances from many sources, in time proportional to the vertices reached

/// What makes a vertex near to a source. Counted in edges, a tunnel with long thin walls is short, and cells
/// have about as many vertices each even where edges differ much in length.
enum class FrontMeasure { distance, edge_count };

/// A front that passes from edge to edge: the third vertex of a face gets the straight distance over the
/// edge, unfolded, from the distances of its two ends (fast marching; Kimmel, Sethian 1998). Only ends that
/// the same source reached are unfolded. Distances err by about a percent.
///
/// Keeps its memory between runs, whose cost depends only on the vertices they reach; one object belongs to
/// one thread. The mesh must outlive it.
class Front {
 public:
  explicit Front(const Mesh& mesh, FrontMeasure measure = FrontMeasure::distance);

  /// Starts again, from vertices. `face_allowed`: the faces that may be entered; empty: all. A vertex is
  /// relaxed a bounded number of times, so every front ends.
  /// \throw Cancelled at a checkpoint. Complexity: O(n) for n vertices reached and faces at them.
  void grow(std::span<const Index> sources, std::span<const std::uint8_t> face_allowed);

  /// In lengths or edges; `unreachable` if the front did not reach the vertex.
  double distance(Index vertex) const { return distance_[vertex]; }
  /// Position in `sources` of the one that a vertex belongs to; no_index if there is none.
  Index source(Index vertex) const { return source_[vertex]; }

 private:
  void relax(Index vertex, double distance, Index source);
  void pass(Index vertex, Index halfedge);

  const Mesh& mesh_;
  FrontMeasure measure_;
  std::vector<double> distance_;
  std::vector<Index> source_;
  std::vector<std::uint8_t> relaxed_;  ///< how often, up to max_relaxed
  std::vector<Index> touched_;
  BucketQueue queue_;
};

// ---- Well-spread sample vertices, as seeds of Voronoi patches

/// The part of a mesh that one patch covers: vertices and whether a face belongs to it.
struct MeshPart {
  std::span<const Index> vertices;             ///< with at least one face of the part, ascending
  std::span<const std::uint8_t> face_allowed;  ///< empty: all faces
};

/// Places samples. Other farthest-point samplings (landmarks of the graph, tasks/spread_points.h) take a few
/// points by whole fields of distances; this one takes many by counts of edges, and a new sample visits only
/// what it is nearest to. Keeps its memory, of the size of the mesh, between calls, whose cost depends only
/// on the part; one object belongs to one thread. The mesh must outlive it.
class Sampler {
 public:
  explicit Sampler(const Mesh& mesh);

  /// Samples of the part, spread by farthest-point sampling in the number of edges and then moved to the
  /// centres of their cells (Lloyd); counting edges rather than length gives dense regions more samples, so
  /// that the cells have similar numbers of vertices.
  ///
  /// At least one sample for each connected piece of the part, otherwise `count`, at most one per vertex.
  /// Deterministic for a seed. \throw Cancelled at a checkpoint. Complexity: O((n + m) log count).
  std::vector<Index> spread(const MeshPart& part, Index count, std::uint64_t seed);

 private:
  void reset();
  template <class Visit>
  void for_each_neighbour(Index v, Visit&& visit) const;
  /// Breadth-first search over the edges of the part: lowers the edge counts to those from the front, whose
  /// vertices have 0; does not enter `to` from `from` where enters(from, to) is false.
  template <class Enters>
  void grow(std::vector<Index> front, Enters&& enters);

  const Mesh& mesh_;
  MeshPart part_;
  std::vector<Index> edge_counts_;
  std::vector<Index> cell_;
};

// ---- Geodesic Voronoi cells of sample vertices, as labels of faces

/// Label of each face of the part (in `faces`): the sample nearest to the face by the distances of the front,
/// with borders shortened by letting a face join two neighbours whose labels agree. Every label is a position
/// in `samples`; a label may own no face. Written to label[face]; other faces keep their labels.
///
/// All faces at a group of outliers get the same label, so that no outlier is on a patch border: tables
/// between borders then hold distances of one scale. Groups that are larger than a patch should be are left
/// as they are. Complexity: O(faces).
void label_voronoi_faces(Front& front, const Mesh& mesh, const MeshPart& part, std::span<const Index> faces,
                         std::span<const Index> samples, const Outliers& outliers, std::span<Index> label);

}  // namespace vorogeo
