// Exact distances around sources: where the tables would be least accurate.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/local_solver.h"
#include "index/index_data.h"
#include "patches/halo.h"

namespace vorogeo {

/// Propagation inside the second-layer patches of the sources and a halo around patches and sources. Keeps
/// its memory from run to run; one object belongs to one thread.
class NearField {
 public:
  /// Growth of the halo around the patches, for paths that leave them; on needles these stray farther than
  /// elsewhere.
  static constexpr double growth = 2.5;
  /// Rings of faces around the sources, relative to the square root of the members of a patch: where a border
  /// is close to a source, the largest errors would lie in the patch beyond it.
  static constexpr double reach = 0.7;
  /// No further ring is added beyond this many faces per source, relative to the members of a patch: rings of
  /// regular faces have about three, those at fans of needles any number.
  static constexpr double max_faces = 8.0;
  /// Inside the patches the solver's distance holds, unless a path outside the halo is shorter by more than
  /// unfolded crossings can err: then the distance by the tables is below this fraction of it.
  static constexpr double shorter_outside = 0.99;

  /// A source nearer to a border edge than this part of the edge has the patch behind it solved, too: right
  /// behind the edge, sums over its ends are so much too long that paths through other patches look shorter.
  static constexpr double near_border_edge = 0.5;
  /// The halo is widened until no path leaves it within the longest piece of the near patches' borders: by
  /// the tables, a distance that is shorter than the space between border points is mostly error. Around an
  /// ordinary patch the edge of the halo is ten or more such lengths away; across needles, hundreds of faces
  /// may be nearer. Limits the time this takes: a halo that has this many times its first faces is not
  /// widened again.
  static constexpr double most_widened = 16.0;
  /// Growth of the halo with directions. The patches that touch those of the sources are then near as well:
  /// the farther from a source a path is known exactly, the less its direction depends on where it goes on.
  static constexpr double growth_with_directions = 1.2;

  explicit NearField(const IndexData& data);

  /// Solves from the sources (on the inner surface) until all places of the near patches are reached: those
  /// of the sources, and those just behind a border close to a source. `directions`: as in ExactLimits; with
  /// them, the patches that touch these are near as well.
  void run(std::span<const ExactSource> sources, double max_distance,
           const TangentFrame* directions = nullptr);

  /// Whether a face is in a near patch.
  bool inside(Index face) const { return is_near_[data_.surface.second_layer[face]] != 0; }
  /// Whether a border node lies between a near patch and another: paths leave near patches only there.
  bool on_rim(Index node) const {
    const auto patches = data_.second.patches_of(node);
    const auto is_near = [&](const PatchRow& at) { return is_near_[at.patch] != 0; };
    return std::ranges::any_of(patches, is_near) && !std::ranges::all_of(patches, is_near);
  }
  /// After run(): whether an exact distance replaces the one by the tables. It does up to the distance at
  /// which a path could have left the halo; beyond, if it is no longer, and in near patches unless the one by
  /// the tables is much shorter.
  bool holds(double exact, double by_tables, bool is_inside) const {
    return exact < unreachable &&
           (exact <= certain_ || exact <= by_tables || (is_inside && by_tables >= shorter_outside * exact));
  }
  /// Calls visit(vertex, distance) for the vertices in near patches and halo where holds() says so.
  /// `by_tables(vertex)` gives the distance by the tables. A vertex may be visited more than once.
  template <class ByTables, class Visit>
  void for_each_held(ByTables&& by_tables, Visit&& visit) const {
    for (Index face : halo_.faces()) {
      const bool is_inside = inside(face);
      for (Index v : data_.surface.mesh->face_vertices(face)) {
        const double exact = solver_.distance(v);
        if (holds(exact, by_tables(v), is_inside)) visit(v, exact);
      }
    }
  }

  /// After run(): calls visit(node, distance, source) once for every border node that was reached.
  template <class Visit>
  void for_each_reached_node(Visit&& visit) const {
    auto is_entered = [&](const PatchRow& at) { return is_entered_[at.patch] != 0; };
    for (Index patch : entered_) {
      for (Index node : data_.second.nodes(patch)) {
        // A node belongs to several patches.
        if (std::ranges::find_if(data_.second.patches_of(node), is_entered)->patch != patch) continue;
        data_.surface.at_place(data_.second.node_place[node], [&](const auto& at) {
          const double distance = solver_.distance(at);
          if (distance < unreachable) visit(node, distance, solver_.nearest_source(at));
        });
      }
    }
  }

  /// After run().
  const LocalSolver& solver() const { return solver_; }
  const Halo& halo() const { return halo_; }

 private:
  void add(Index patch);
  void add_at(const SurfacePoint& point);
  void solve(std::span<const ExactSource> sources, double max_distance, const TangentFrame* directions);

  const IndexData& data_;
  LocalSolver solver_;
  Halo halo_;
  std::vector<std::uint8_t> is_near_;  ///< by second-layer patch
  std::vector<Index> patches_;
  std::vector<std::uint8_t> is_entered_;  ///< by patch: whether the halo has a face of it
  std::vector<Index> entered_;
  PlaceTargets targets_;
  std::vector<Index> around_;  ///< faces at the sources
  double certain_ = 0.0;
};

}  // namespace vorogeo
