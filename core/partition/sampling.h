// Well-spread sample vertices, as seeds of Voronoi patches.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace vorogeo {

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
  ~Sampler();

  /// Samples of the part, spread by farthest-point sampling in the number of edges and then moved to the
  /// centres of their cells (Lloyd); counting edges rather than length gives dense regions more samples, so
  /// that the cells have similar numbers of vertices.
  ///
  /// At least one sample for each connected piece of the part, otherwise `count`, at most one per vertex.
  /// Deterministic for a seed. \throw Cancelled at a checkpoint. Complexity: O((n + m) log count).
  std::vector<Index> spread(const MeshPart& part, Index count, std::uint64_t seed);

 private:
  class EdgeCountField;
  std::unique_ptr<EdgeCountField> field_;
};

}  // namespace vorogeo
