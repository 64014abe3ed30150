// Exact paths and distances of two points: a run within bounds, then wider ones until no path can be shorter.
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
/// For the length of a path. A limit this much larger also keeps rounding from cutting its last window.
inline constexpr double of_path = 1.0 + path_tolerance;
/// For a sum of two table entries: nearly always enough, and a run has a tenth fewer windows than with 1.001.
inline constexpr double of_entries = 1.0003;
/// For the length of a route through the tables.
inline constexpr double of_route = 1.001;
/// For entries in any metric, for routes where it jumps, as propagated distances have errors of their own
/// there, and for a bound within which no path was found.
inline constexpr double widest = 1.01;
}  // namespace slack

/// What is known about the distance of two points before it is propagated.
struct PathBounds {
  double upper = unreachable;      ///< upper bound of the distance
  std::span<const double> rest{};  ///< lower bounds of the distance from `to`, by vertex of the run's surface
  const ExactLandmarks* landmarks = nullptr;  ///< give lower bounds, too
  std::span<const std::uint8_t> mask{};       ///< faces of the run's surface in which the path probably lies
  bool is_proof = true;                       ///< `rest` is certain, and not an estimate less a margin
  bool is_fixed = false;                      ///< there is only one run, within these bounds
};

/// Exact distances and paths of two points. A run follows only windows that can be part of a path within the
/// bounds. If a path outside the mask may be shorter, the next run enters all faces within the length of the
/// path found; if none was found, the next has a wider bound; the last has no bounds. Each run ends: the
/// solver passes a window on only where it shortens a distance by more than rounding. One object belongs to
/// one thread.
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
  /// Checks a path of the user's mesh for which `distance` was propagated. Ends that equal the two points up
  /// to rounding are replaced by them; a length that its points do not have is replaced by the measured one.
  ExactPath checked(SurfacePath path, double distance, const SurfacePoint& from,
                    const SurfacePoint& to) const;
  /// Whether a path joins these points and has the length that it states.
  bool is_whole(const SurfacePath& path, const SurfacePoint& from, const SurfacePoint& to) const;
  /// Whether a distance propagated within certain bounds is a proof on this mesh.
  bool can_prove() const { return can_prove_; }

  /// Mask of some second-layer patches of the index and a halo around them, valid until the next mask.
  std::span<const std::uint8_t> mask_around(std::span<const Index> patches);
  /// Mask of some faces of its inner surface and so many rings of faces around them.
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
  std::optional<LocalSolver> solver_;  ///< made when first needed
  std::optional<Halo> halo_;           ///< made when first needed
};

}  // namespace vorogeo
