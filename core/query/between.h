// The one exact run from point to point: within bounds, and within wider ones until nothing can be shorter.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "exact/exact_landmarks.h"
#include "exact/local_solver.h"
#include "index/index_data.h"
#include "patches/halo.h"

namespace vorogeo {

/// A shortest path and what is known about it.
struct ExactPath {
  SurfacePath path{{}, unreachable};
  /// Whether it is proven that no path is shorter (up to rounding), and the path passes is_path() for the
  /// distance that was propagated: it runs between the points asked for, consecutive points share a face, and
  /// its steps sum to that distance. Otherwise the propagation was kept in a corridor by the index's
  /// distances less an error margin, or no path of that length was found among degenerate faces.
  bool certified = false;
};

/// What an upper bound is multiplied by, since rounding may have made it too small.
namespace slack {
/// The length of a path. A limit that is this much wider also keeps rounding from cutting its last window.
inline constexpr double of_path = 1.0 + path_tolerance;
/// A sum of two table entries; nearly always enough. A run within less is much narrower: a tenth fewer
/// windows than at 1.001.
inline constexpr double of_entries = 1.0003;
/// The length of a route through the tables.
inline constexpr double of_route = 1.001;
/// Either where the metric jumps, since there propagated distances have errors of their own; and any bound
/// within which nothing was found.
inline constexpr double widest = 1.01;
}  // namespace slack

/// What is known about the distance of two points before it is propagated.
struct PathBounds {
  double upper = unreachable;      ///< of the distance
  std::span<const double> rest{};  ///< lower ones of the distance from `to`, by vertex of the run's surface
  const ExactLandmarks* landmarks = nullptr;  ///< the same
  std::span<const std::uint8_t> mask{};       ///< faces of the run's surface in which the path probably lies
  bool is_proof = true;                       ///< `rest` is certain, and not an estimate less a margin
  bool is_fixed = false;                      ///< one run within these bounds is all, however it ends
};

/// Exact distances and paths of two points. A run follows only what can lie on a path within the bounds. If
/// what it found may not be the shortest, the next one goes over all faces within that length; if nothing was
/// found, within a wider bound; and the last one has no bounds. Each run ends: the solver passes a window on
/// only where it shortens a distance by more than rounding. One object belongs to one thread.
class ExactBetween {
 public:
  /// On a mesh that has no index.
  explicit ExactBetween(std::shared_ptr<const LocalGeometry> geometry);
  /// On the inner surface of an index, which must outlive the object.
  explicit ExactBetween(const IndexData& data);

  /// The shortest path between two points of the user's mesh. \pre The points are validated, different and in
  /// one component.
  ExactPath path(const SurfacePoint& from, const SurfacePoint& to, PathBounds bounds);
  /// The distance of two vertices of the run's surface. \pre As path().
  double distance(Index from, Index to, PathBounds bounds);
  /// A path of the user's mesh for which `distance` was propagated: made to join exactly these points where
  /// it does so up to rounding, measured along its points where its length is not theirs, and checked.
  ExactPath checked(SurfacePath path, double distance, const SurfacePoint& from,
                    const SurfacePoint& to) const;
  /// Whether it joins these points, however long it is.
  bool is_whole(const SurfacePath& path, const SurfacePoint& from, const SurfacePoint& to) const;
  /// Whether a distance propagated within certain bounds is a proof on this mesh.
  bool can_prove() const { return can_prove_; }

  /// Some second-layer patches of the index and a halo around them. A mask is valid until the next one.
  std::span<const std::uint8_t> mask_around(std::span<const Index> patches);
  /// Some faces of its inner surface and so many rings of faces around them.
  std::span<const std::uint8_t> mask_beside(std::span<const Index> faces, int rings);

 private:
  bool run(const SurfacePoint& from, const SurfacePoint& to, const PathBounds& bounds, bool for_path);
  Halo& halo();
  SurfacePath path_of_run(const SurfacePoint& to) const;
  SurfacePoint point_of_run(const SurfacePoint& user) const {
    return data_ != nullptr ? data_->surface.inner_point(user) : user;
  }

  const IndexData* data_ = nullptr;  ///< null without an index
  std::shared_ptr<const LocalGeometry> geometry_;
  const Mesh& mesh_;  ///< the user's
  bool can_prove_;
  std::optional<LocalSolver> solver_;  ///< when first needed
  std::optional<Halo> halo_;           ///< likewise
};

}  // namespace vorogeo
