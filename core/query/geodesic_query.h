// Queries to an index: the distance of two points, and fields from one or many sources of every kind.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "mesh/surface_point.h"
#include "query/source_field.h"

namespace vorogeo {

/// Answers queries on an index. Cheap to create: each kind of query takes its scratch memory when it is first
/// asked, and resets it in O(1). One object belongs to one thread.
class GeodesicQuery {
 public:
  /// `threads`: used inside a field; 0 is one per core. No answer depends on it.
  explicit GeodesicQuery(std::shared_ptr<const GeodesicIndex> index, int threads = 0);
  ~GeodesicQuery();
  GeodesicQuery(GeodesicQuery&&) noexcept;
  GeodesicQuery& operator=(GeodesicQuery&&) noexcept;

  /// Geodesic distance of two vertices (SSSD), symmetric; `unreachable` between components.
  /// \throw InvalidInput for a vertex out of range.
  double distance(Index source, Index target);

  /// Distances from the nearest of the sources to every vertex (SSAD, MSAD), `unreachable` where there is
  /// none. Shape (n). Distances above max_distance are `unreachable`. Duplicate sources count once. \throw
  /// InvalidInput for a vertex out of range, a max_distance that is negative or NaN, or no source.
  std::vector<double> distance_field(std::span<const Index> sources, double max_distance = unreachable);

  /// The same from sources of every kind: see labelled_field, without its labels.
  std::vector<double> distance_field(std::span<const ExactSource> sources, double max_distance = unreachable);

  /// For every vertex the least sum of a source's offset and the distance from it, and which source that is.
  /// Sources are points anywhere on the surface. Without offsets, the distances are those of distance_field
  /// to the last bit. Sums above max_distance are `unreachable`. \throw InvalidInput for no source, a point
  /// that is not on the mesh, an offset that is negative or not finite, a max_distance that is negative or no
  /// number.
  LabelledField labelled_field(std::span<const ExactSource> sources, double max_distance = unreachable);

  /// The same sums at any points of the surface. At vertices they are those of labelled_field to the last
  /// bit; at a point in a face they are exact in the patches of the sources and around them, elsewhere
  /// computed from those at its corners (distance_in_face). \throw InvalidInput also for a target that is not
  /// on the mesh.
  std::vector<double> distances(std::span<const ExactSource> sources, const PointList& targets,
                                double max_distance = unreachable);

  /// Fields from this call on use so many threads, at most those of the constructor.
  void use_threads(int threads);

  const GeodesicIndex& index() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vorogeo
