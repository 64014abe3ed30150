// Exact runs from point to point, within whatever bounds are known.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "exact/exact_landmarks.h"
#include "exact/exact_solver.h"
#include "exact/local_solver.h"
#include "index/local_tables.h"
#include "query/border_field.h"
#include "query/graph_route.h"
#include "query/path_chain.h"

namespace vorogeo {

// ---- Exact propagation from one point to another, within a bound of the length of the path

/// A path and what is known about it. It has no points and infinite length if none was found.
struct FoundPath {
  SurfacePath path{{}, unreachable};
  /// The distance by exact propagation, if only proven bounds limited it; otherwise unreachable.
  double distance = unreachable;
  bool is_refined = false;    ///< refined from the index's route: a shorter one may lie close to it
  bool on_user_mesh = false;  ///< with an index: whether the path runs over that, rather than the work mesh

  /// Keeps the shorter of both paths, and the distance that either of them knows.
  void join(FoundPath other);
  /// The same path, of which nothing is proven.
  FoundPath unproven() &&;
};

/// Makes a path begin and end with exactly these points where it does so up to rounding, and corrects a
/// length that its points do not have. \return the length measured along its points.
MeasuredLength set_ends(const Mesh& mesh, const SurfacePoint& first, const SurfacePoint& last,
                        SurfacePath& path);

/// Up to edges this many typical ones long, exact distances between the other vertices keep their digits.
inline constexpr double provable_edges = 1e13;
/// Whether a propagated distance is a proof on this mesh.
inline bool is_provable(const Mesh& mesh) {
  return mesh.longest_edge_length() <= provable_edges * mesh.typical_edge_length();
}

/// Runs of one exact solver from point to point. Each run ends: the solver passes a window on only where it
/// shortens a distance by more than rounding. One object belongs to one thread.
class CorridorSearch {
 public:
  explicit CorridorSearch(const std::shared_ptr<const LocalGeometry>& geometry) : solver_(geometry) {}

  /// The path and the propagated distance. limits.max_distance is an upper bound of the distance: what cannot
  /// lie on a path of that length is not followed.
  FoundPath run(const SurfacePoint& from, const SurfacePoint& to, ExactLimits limits);
  /// The same over the faces allowed (ExactLimits::face_allowed; empty: all). The distance is known only if
  /// no shorter path can have left them.
  FoundPath within(const SurfacePoint& from, const SurfacePoint& to, double max_distance,
                   std::span<const std::uint8_t> face_allowed = {});

 private:
  LocalSolver solver_;
};

// ---- Lower bounds of the distance to one point, from the index: they keep exact propagation in a corridor

/// The largest error assumed of the index: this fraction of the distance plus this fraction of the mean edge
/// (a single border crossing errs by a fraction of an edge, however long the distance). About twice the
/// largest error measured on shortest paths (docs/figures.md). It is not proven, so results that rely on it
/// are not certified.
inline constexpr double index_margin = 0.003;
inline constexpr double index_margin_in_edges = 0.5;

/// Lower bounds for the vertices on paths of at most a given length between two points.
///
/// The distances of the border nodes from the target come from the tables; each patch that neither they nor
/// the landmarks exclude is swept. In the patches around the target, where the index is least accurate, the
/// bound is 0: the straight line in space is used there. One object belongs to one thread.
class RemainingBounds {
 public:
  explicit RemainingBounds(const IndexData& data);

  /// For work vertices; infinity where no such path can pass. Valid until the next call. Complexity: that of
  /// the second-layer tables of the patches passed.
  std::span<const double> fill(const RouteEnd& source, const RouteEnd& target,
                               std::span<const Index> target_patches, double length);

 private:
  void allow_patches(const RouteEnd& source, const RouteEnd& target, double length);

  const IndexData& data_;
  BorderField borders_;
  std::vector<BorderField::Seed> seeds_;
  FieldSweep sweep_;
  std::vector<double> bound_;
  std::vector<std::uint8_t> allowed_;
  std::vector<std::uint8_t> is_near_;
  std::vector<Index> swept_;
};

// ---- Exact propagation from one end of a path to the other, within whatever bounds are known

/// Paths over the work mesh of an index, or over the user's mesh where exact runs take that
/// (IndexData::unsplit), each by one or two runs of the exact solver. Holds scratch memory: one
/// object belongs to one thread.
class ExactSearch {
 public:
  explicit ExactSearch(const IndexData& data);

  /// Paths shorter than `max_distance`, over the faces of the work mesh that are allowed (not 0; empty: all).
  FoundPath within(const PathEnd& from, const PathEnd& to, double max_distance,
                   std::span<const std::uint8_t> face_allowed = {});
  /// Over all faces, with the bounds of the landmarks, if there are any.
  FoundPath between_landmarks(const PathEnd& from, const PathEnd& to, double max_distance);
  /// The same with the bounds that the index gives, which are not proven.
  FoundPath by_index(const PathEnd& from, const PathEnd& to, double max_distance);
  /// Ends in one patch or in patches that touch: first in these patches and their halo; if a path could have
  /// left them, everywhere. `estimate`: an upper bound of the distance, if the tables are right.
  FoundPath nearby(const PathEnd& from, const PathEnd& to, double estimate);
  /// Without any bound: the last resort if a bound was wrong.
  FoundPath everywhere(const PathEnd& from, const PathEnd& to);

  void use_landmarks(std::shared_ptr<const ExactLandmarks> landmarks) { landmarks_ = std::move(landmarks); }

 private:
  FoundPath run(const PathEnd& from, const PathEnd& to, const ExactLimits& limits);
  /// `mask`: faces allowed of the mesh that runs take; empty: all.
  FoundPath within_mask(const PathEnd& from, const PathEnd& to, double max_distance,
                        std::span<const std::uint8_t> mask);

  const IndexData& data_;
  const UnsplitSurface* unsplit_;
  CorridorSearch corridor_;
  Halo halo_;
  RemainingBounds bounds_;
  std::vector<std::uint8_t> user_mask_;
  std::vector<double> user_bound_;
  std::shared_ptr<const ExactLandmarks> landmarks_;
};

}  // namespace vorogeo
