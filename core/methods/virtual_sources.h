// Virtual sources handed from face to face: errors of some tenths of a percent on scans.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "exact/exact_solver.h"
#include "mesh/vectors.h"
#include "support/bucket_queue.h"

namespace vorogeo {

/// Virtual source propagation (Trettner, Bommes, Kobbelt, "Geodesic distance computation via virtual source
/// propagation", Computer Graphics Forum 40(5), 2021): each face keeps one source, unfolded into its plane,
/// and hands it to the next face. Unlike in the paper, the source comes with the sector in which it is seen
/// through all edges that were crossed. Outside the sector, the source is rotated about the vertex that
/// bounds it by the vertex's angle defect, to where it is seen past the other side; only in the shadow of
/// both sides does the path bend at the vertex. There is no bound of the error.
///
/// Keeps its memory between runs; one object belongs to one thread.
class VirtualSources {
 public:
  explicit VirtualSources(std::shared_ptr<const Mesh> mesh);

  const Mesh& mesh() const { return *mesh_; }

  /// Propagates from some vertices. \throw Cancelled at a checkpoint.
  void run(std::span<const Index> sources);

  double distance(Index vertex) const { return vertices_[mesh_->representative(vertex)].distance; }
  std::size_t memory_bytes() const;

 private:
  /// A vertex that bounds the sector in which a source is seen.
  struct Bound {
    PlanePoint at{};
    Index vertex = no_index;  ///< no_index: not bounded on this side
  };
  /// What a face knows. The edge of the half-edge `base` lies on the x axis, its tail at 0; the face above
  /// it, and what is below unfolded into the same plane.
  struct FaceSource {
    PlanePoint at{};             ///< the virtual source
    double sigma = unreachable;  ///< how far it is from the real one
    Bound left, right;           ///< as seen from the source: on the side of the tail, and of the head
    Index base = no_index;
  };
  /// What a run reads of a face, in one cache line.
  struct alignas(64) FaceRecord {
    std::array<double, 3> length;  ///< of the edges of its half-edges
    double twice_area;
    double distance;            ///< of the centroid, by which the sources of a face are compared
    std::array<Index, 3> next;  ///< around the edges of its half-edges
    std::array<Index, 3> vertex;
  };
  /// What a run reads of a vertex.
  struct alignas(32) VertexRecord {
    /// Cosine and sine of its angle defect; a cosine above 1 where there is no other side.
    PlanePoint defect;
    double distance;
  };
  /// A face over one of its edges, which lies on the x axis from its half-edge's tail.
  struct FaceOver {
    double edge;      ///< its length
    PlanePoint apex;  ///< the third vertex
    Index tail, head, opposite;
  };
  static FaceOver over(const FaceRecord& face, int side);

  /// From where a point of a face is reached: the face's source, that source rotated about the bound on its
  /// left or right, or a bend round that bound, which may be an end of the edge that was crossed.
  struct Reached {
    enum How : std::uint8_t { directly, past_left, past_right, round_end, round_bound };
    PlanePoint at;
    double sigma;
    How how;
  };

  void start_in(Index corner);
  void start_at(Index vertex);
  void reach_vertex(Index vertex, double distance);
  void hand_on(Index face);
  void enter(const FaceSource& crossing);
  Reached reached(const FaceSource& seen, const FaceOver& face, const PlanePoint& point) const;
  Reached beyond_bound(const FaceSource& seen, const FaceOver& face, bool left,
                       const PlanePoint& point) const;
  bool is_nearer(Index face, double distance) const {
    // Without this threshold, negligible gains would circle a vertex forever.
    return distance < records_[face].distance * (1.0 - 1e-12);
  }
  void take(const FaceSource& found, double distance);

  std::shared_ptr<const Mesh> mesh_;
  std::vector<FaceRecord> records_;
  std::vector<VertexRecord> vertices_;
  std::vector<FaceSource> faces_;
  std::vector<Index> turning_;  ///< non-manifold vertices that were reached and have to emit
  BucketQueue queue_;
};

}  // namespace vorogeo
