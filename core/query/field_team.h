// Distance fields for many sources at a time: one query object per worker thread.
#pragma once

#include <memory>
#include <vector>

#include "index/geodesic_index.h"
#include "support/types.h"

namespace vorogeo {

/// Gives fields and distances to the workers of a parallel_for. What is built on many fields (matrices,
/// Voronoi regions, samplings) asks it and so runs on an index or on exact propagation alike.
class FieldTeam {
 public:
  /// Answers from an index. `threads`: workers; 0 is one per core.
  explicit FieldTeam(std::shared_ptr<const GeodesicIndex> index, int threads = 0);
  /// Answers by exact propagation on the mesh: slower, without an index and its errors.
  explicit FieldTeam(std::shared_ptr<const Mesh> mesh, int threads = 0);
  ~FieldTeam();
  FieldTeam(FieldTeam&&) noexcept;
  FieldTeam& operator=(FieldTeam&&) noexcept;

  const Mesh& mesh() const;
  int threads() const;
  bool is_exact() const;

  /// Distances from one vertex to all, `unreachable` above max_distance. Shape (n). On one thread;
  /// `worker` is in [0, threads()) and runs one call at a time.
  std::vector<double> field(Index source, double max_distance, int worker);
  /// The same from the nearest of several sources, on all threads; only one such call at a time.
  std::vector<double> field_on_all_threads(std::span<const Index> sources, double max_distance = unreachable);
  /// Distance of two vertices, symmetric. \throw InvalidInput without an index.
  double distance(Index source, Index target, int worker);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// \throw InvalidInput if a vertex does not exist; the message calls it by `role` and its place in the list.
void require_vertices(const Mesh& mesh, std::span<const Index> vertices, const char* role);

}  // namespace vorogeo
