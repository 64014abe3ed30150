// One hostile mesh under examination: the mesh, the queries, and what was found wrong.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "exact/exact_solver.h"
#include "fuzz/hostile_cost.h"
#include "fuzz/hostile_tally.h"
#include "index/geodesic_index.h"
#include "support/hostile_meshes.h"
#include "support/surface_walk.h"

namespace vorogeo::test {

/// Stands for the scans that costs are compared with.
inline constexpr unsigned scan_seed = 0;

class HostileCase {
 public:
  HostileCase(unsigned seed, HostileMesh hostile, HostileTally& tally);

  /// Checks the soup and makes the mesh from it; false if the mesh has no face.
  bool make_mesh();
  /// "index of 2 x 2 patches (0: chosen), delta 0: "
  std::string index_text() const;
  /// Notes the query, for findings and in case no answer comes.
  void ask(const std::string& question);
  /// Counts a finding and prints it: the last question, `kind` (a few fixed words, for counting) and the
  /// numbers. For each mesh, only the first few of a kind are printed.
  void fail(const std::string& kind, const std::string& numbers);
  /// Runs `answer`; every exception is a finding, but for an Error with a sentence if `may_refuse`. \return
  /// whether `answer` ran to its end.
  bool attempt(const std::function<void()>& answer, bool may_refuse = false);
  void note_error(ErrorKind kind, double actual, double exact);

  /// How far two exact results may be apart: 1e-9 of the distance, and the rounding of a position on the
  /// longest edge of the mesh. 0 where no path leads.
  double slack(double distance) const {
    return distance < unreachable ? 1e-9 * distance + 1e-15 * longest_ : 0.0;
  }
  /// Whether two vertices are connected through faces, found from the soup alone.
  bool connected(Index a, Index b) const { return component_[a] == component_[b]; }
  /// A finding if two distances of a vertex differ by more than the slack plus `more`.
  void require_same(const std::string& law, Index v, double expected, double actual, double more = 0.0);
  /// The same for each vertex of two fields.
  void require_same(const std::string& law, const std::function<double(Index)>& expected,
                    const std::function<double(Index)>& actual, double more = 0.0);
  /// Whether a vertex lies so far away that rounding of positions or lengths bends the edges that lead to it.
  bool has_outlier() const { return farthest > 1e6 * mesh->typical_edge_length(); }
  /// Checks distances from one vertex without a reference: signs, NaN, which vertices are reached,
  /// differences along edges (with a relative slack of `along_edges`), the straight line in space.
  void require_sound(const std::vector<double>& field, Index source, double along_edges);

  unsigned seed;
  HostileMesh hostile;
  HostileRandom random;  ///< for the questions
  IndexOptions options;  ///< of the index
  Costs costs{};         ///< of the steps asked for
  Index patches = 0;     ///< of the second layer of the index
  std::shared_ptr<const Mesh> mesh;
  std::unique_ptr<SurfaceWalk> walk;
  HostileTally& tally;
  /// Two vertices of faces, and their exact fields; empty where exact distances are refused.
  std::array<Index, 2> sources{};
  std::array<std::vector<double>, 2> exact;
  double typical = 1.0;   ///< median edge
  double farthest = 0.0;  ///< largest coordinate
  /// Relative errors of an index and of quick fields above this are findings. Documented errors
  /// (docs/figures.md) are those of usual meshes; here patches have a handful of faces of any shape.
  double greatest_error = 0.01;
  double dearest = 0.0;  ///< greatest cost of a step, as a part of what it may cost
  unsigned findings = 0;

 private:
  void find_components();

  std::string question_;
  double longest_ = 0.0;
  std::vector<Index> component_;
  std::vector<std::pair<std::string, int>> kinds_;
};

/// "1.25e-07" with all digits that a comparison needs.
std::string exactly(double value);

/// Checks two exact fields against the reference, closed forms and their own paths. After make_mesh().
void check_exact(HostileCase& hostile);
/// Checks the exact fields against those of the same mesh renumbered, moved, turned and subdivided, and
/// against each other. After check_exact().
void check_laws(HostileCase& hostile);
/// Checks fields of an index, and quick ones, against each other, and those of an index of the same mesh at
/// another scale.
void check_index_laws(HostileCase& hostile, const std::shared_ptr<const GeodesicIndex>& index);
/// Checks fields in other metrics, against exact fields of lengths where these follow. After check_exact().
void check_metrics(HostileCase& hostile);
/// Checks fields of the mesh with its gaps bridged. After check_exact().
void check_gaps(HostileCase& hostile);
/// Checks tasks that are answered exactly. After check_exact().
void check_tasks(HostileCase& hostile);
/// Builds an index and checks it against the exact fields.
void check_index(HostileCase& hostile);
/// Checks refined, exact and uncertified paths from the first source to the targets, and from a point inside
/// a face to the first target. Part of check_index().
void check_paths(HostileCase& hostile, const std::shared_ptr<const GeodesicIndex>& index,
                 const std::vector<Index>& targets, const SurfacePoint& inside);
/// Checks that no step costs too many times what it costs on a scan. After check_index().
void check_costs(HostileCase& hostile, ScanCosts& scans);

}  // namespace vorogeo::test
