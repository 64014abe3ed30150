// Exact geodesic distances from one or many sources, by propagation of windows across the faces.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "exact/surface_path.h"
#include "mesh/mesh.h"
#include "mesh/surface_point.h"
#include "support/progress.h"

namespace vorogeo {

class ExactLandmarks;
class SharedRun;
class TangentFrame;
struct ExactGeometry;
struct Ridge;

/// Where the distance starts, and with which value.
struct ExactSource {
  SurfacePoint point;
  double offset = 0.0;
};

/// Sources as solvers take them. \throw InvalidInput for a bad point, or an offset that is negative or not
/// finite.
std::vector<ExactSource> validated(const Mesh& mesh, std::span<const ExactSource> sources);

/// Vertices as sources without offsets.
std::vector<ExactSource> sources_at(std::span<const Index> vertices);

/// \throw InvalidInput for a greatest distance that is negative or no number.
void require_limit(double max_distance);

/// A point inside an edge, by its distance from the edge's first vertex.
struct EdgePoint {
  Index edge;
  double position;
};

/// A straight segment in a face, by the weights of its ends there. All its points are sources.
struct SourceSegment {
  Index face;
  std::array<double, 3> from, to;
  Index source;  ///< what nearest_source() returns for its points
};

/// What a propagation need not compute, and how closely.
struct ExactLimits {
  /// Distances above this need not be found (they are reported as unreachable).
  double max_distance = unreachable;
  /// If not empty: stop as soon as the distances of these vertices are final; the others are then upper
  /// bounds.
  std::span<const Index> targets{};
  /// With targets: points of edges whose distances are to be final as well. Not with distances_only.
  std::span<const EdgePoint> edge_targets{};
  /// Neighbouring windows are merged if one window represents them with a deviation of up to this fraction of
  /// their edge's length, of a typical edge, of the height of the face behind it and of their distance;
  /// distances become too short by about as much. 0: exact.
  double merge_tolerance = 0.0;
  /// If set, with a max_distance that is known to be an upper bound of this point's distance: only what can
  /// lie on a path to it within that bound is followed, judged by the straight line in space. Only this
  /// point's distance is then meant to be read.
  const SurfacePoint* corridor_point = nullptr;
  /// With a corridor, if not empty: for each vertex a lower bound of its distance to the corridor's target
  /// (size: number of vertices); used where it is larger than the straight line in space.
  std::span<const double> least_remaining{};
  /// With a corridor, if set: exact distances on this mesh; the bounds that they prove are used where they
  /// are larger.
  const ExactLandmarks* landmarks = nullptr;
  /// If not empty: only faces f with face_allowed[f] != 0 are entered (size: number of faces).
  std::span<const std::uint8_t> face_allowed{};
  /// Only distance(vertex) and nearest_source(vertex) will be read: windows behind the front are dropped,
  /// which keeps memory to a multiple of the front's length instead of the mesh's size, and is faster.
  bool distances_only = false;
  /// With distances_only and none of targets, a corridor and face_allowed: this many threads share the run
  /// (see threads_for_field). Distances are equal up to rounding, and to the last bit for the same number.
  int threads = 1;
  /// If set: first_leg() will be read. The frame is that of the only source, whose offset is 0, and must
  /// outlive all reads of the run. Not with a merge_tolerance, as merged windows have no angle at the source.
  const TangentFrame* directions = nullptr;
  /// Sources besides those of the list, which must contain the ends of all segments. A segment on an edge is
  /// given in each of its faces. Distances are never too short, and at most 1.3e-6 of a typical edge too
  /// long; only those of vertices are then meant to be read. Not with directions.
  std::span<const SourceSegment> segments{};
  /// If set: receives the fraction of vertices reached, from the calling thread; may cancel the run.
  /// Otherwise the run has checkpoints.
  const Progress* progress = nullptr;
};

/// Reports to the progress of the limits; without one, it is a checkpoint. \throw Cancelled.
void report_run(const ExactLimits& limits, double fraction, const char* activity);

/// Exact solver on one mesh. Keeps its memory between runs; one object belongs to one thread.
///
/// Windows follow Mitchell, Mount, Papadimitriou (1987) and Surazhsky et al. (2005): on each edge, the lower
/// envelope of the distances seen through it. Wavefronts advance edge by edge in buckets of distance, after
/// Xu et al. (2015, FWP), and windows dominated by a vertex are cut (Xin, Wang 2009).
class ExactSolver {
 public:
  explicit ExactSolver(std::shared_ptr<const Mesh> mesh);
  /// A solver on geometry that several solvers (one per thread) share.
  explicit ExactSolver(std::shared_ptr<const ExactGeometry> geometry);
  ~ExactSolver();
  ExactSolver(ExactSolver&&) noexcept;
  ExactSolver& operator=(ExactSolver&&) noexcept;

  const Mesh& mesh() const;

  /// Propagates from the sources. \throw Cancelled, InvalidInput for a bad source (no source at all is
  /// allowed: then every distance is infinite).
  void run(std::span<const ExactSource> sources, const ExactLimits& limits = {});
  /// The same from vertices.
  void run_from_vertices(std::span<const Index> source_vertices, const ExactLimits& limits = {}) {
    run(sources_at(source_vertices), limits);
  }

  /// Distance of a vertex, in the mesh's length unit; `unreachable` if no path was found.
  double distance(Index vertex) const;
  /// Distance of any point of the surface. \throw std::logic_error after a run with distances_only.
  double distance(const SurfacePoint& point) const;
  /// Distance of a point of an edge. Complexity: O(sources + log windows of the edge). \throw
  /// std::logic_error after a run with distances_only.
  double distance(const EdgePoint& point) const;
  /// Which source (index into the list given to run) a vertex belongs to; no_index if unreachable.
  Index nearest_source(Index vertex) const;
  /// The same for a point of an edge; complexity and errors are those of distance().
  Index nearest_source(const EdgePoint& point) const;
  /// The angle around the source, in the frame that the run was given, at which the shortest path to a vertex
  /// or point begins; NaN if unreachable. \throw std::logic_error where distance() does.
  double first_leg(Index vertex) const;
  double first_leg(const SurfacePoint& point) const;
  /// The angle, in the frame of a point, at which the shortest path from it to its nearest source begins; NaN
  /// at a source and where none can be reached. \throw std::logic_error after a run with distances_only.
  double last_leg(const TangentFrame& frame) const;
  /// Where several shortest paths arrive. Complexity: O(windows) where few of them are on one face. \throw
  /// std::logic_error after a run with distances_only.
  Ridge ridge() const;
  /// The shortest path from `target` back to its nearest source, target first. Empty if unreachable.
  /// `only_leg`: only as far as the first vertex that it passes. \throw std::logic_error after a run with
  /// distances_only.
  SurfacePath path_to_source(const SurfacePoint& target, bool only_leg = false) const;

  /// Distances up to this one are final (all of them after a run that no targets ended).
  double settled_distance() const;
  /// Least distance at which a path met a face that it may not enter; `unreachable` if none did. Final
  /// distances up to this one are those of the whole mesh.
  /// With a corridor: least length of a path to its target that met such a face.
  double barrier_distance() const;

  /// Windows made in the last run, for measurements.
  std::size_t window_count() const;
  std::size_t memory_bytes() const;

  struct State;

 private:
  /// How many solvers share a run within these limits.
  int solvers_for(const ExactLimits& limits) const;

  std::unique_ptr<State> state_;
  std::unique_ptr<SharedRun> shared_;
};

/// How many threads should share a field on this mesh: `requested` ones (0: one per core), or one on small
/// meshes, where threads would wait for each other longer than they work, and where the metric jumps.
int threads_for_field(const Mesh& mesh, int requested);

/// Exact distances from the sources to all vertices, on one thread. Shape (n).
std::vector<double> exact_distance_field(std::shared_ptr<const Mesh> mesh,
                                         std::span<const Index> source_vertices);

}  // namespace vorogeo
