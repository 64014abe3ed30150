// Laws of fields on every mesh: another description of the same surface gives the same distances, and no
// detour is shorter.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "fuzz/hostile_case.h"
#include "mesh/metric.h"
#include "support/disjoint_sets.h"
#include "support/hostile_parts.h"
#include "support/indexes.h"
#include "tasks/cut.h"

namespace vorogeo::test {

namespace {

/// The mesh with vertices, faces and corners in random order, so that some faces are turned over. `place`
/// receives the new number of each vertex.
Soup reordered(const Soup& soup, HostileRandom& random, std::vector<Index>& place) {
  place.resize(soup.positions.size());
  std::iota(place.begin(), place.end(), 0);
  shuffle(place, random);
  Soup result = renumbered(soup, place);
  for (auto& face : result.faces) shuffle(face, random);
  shuffle(result.faces, random);
  return result;
}

/// The mesh with axes permuted and flipped, and scaled by a power of two: all without rounding.
Soup moved_exactly(const Soup& soup, HostileRandom& random, double& scale) {
  std::array axis{0, 1, 2};
  std::swap(axis[0], axis[random.below(3)]);
  std::swap(axis[1], axis[1 + random.below(2)]);
  scale = std::ldexp(1.0, random.between(-20, 20));
  std::array<double, 3> factor{};
  for (double& f : factor) f = random.one_in(2) ? scale : -scale;
  Soup result = soup;
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    for (int i = 0; i < 3; ++i) result.positions[v][i] = factor[i] * soup.positions[v][axis[i]];
  }
  return result;
}

/// The mesh turned about a random axis by a random angle, and shifted by as much as it is far from the
/// origin.
Soup turned_and_shifted(const Soup& soup, HostileRandom& random, double farthest) {
  const Point axis = random.direction();
  const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const Point shift = random.direction();
  Soup result = soup;
  for (Point& p : result.positions) {
    const double along = (1.0 - cosine) * (axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2]);
    const Point across{axis[1] * p[2] - axis[2] * p[1], axis[2] * p[0] - axis[0] * p[2],
                       axis[0] * p[1] - axis[1] * p[0]};
    for (int i = 0; i < 3; ++i)
      p[i] = cosine * p[i] + sine * across[i] + along * axis[i] + farthest * shift[i];
  }
  return result;
}

/// A mesh torn open along a line, so that faces on both sides of it are no neighbours.
struct Torn {
  Soup soup;
  std::vector<Index> vertex_of;  ///< for each vertex, that of the cut mesh
};

/// At each inner vertex of the line, the faces fall into parts that are connected over edges not on the line.
/// Parts with faces at both edges of the line there are its sides, and all but the first get a vertex of
/// their own. Other parts, as beside a hole that the line touches, keep the vertex of the first side.
Torn torn_along(const CutMesh& cut, std::vector<Point> positions, const std::vector<Index>& line) {
  Torn torn{{std::move(positions), cut.faces}, {}};
  torn.vertex_of.resize(torn.soup.positions.size());
  std::iota(torn.vertex_of.begin(), torn.vertex_of.end(), 0);
  std::vector<std::vector<Index>> faces_at(torn.soup.positions.size());
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    for (const Index v : cut.faces[f]) faces_at[v].push_back(static_cast<Index>(f));
  }
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Index v = line[i];
    const std::vector<Index>& around = faces_at[v];
    DisjointSets parts(static_cast<Index>(around.size()));
    std::map<Index, Index> first_with;  // by the other vertex of an edge that is not on the line
    for (std::size_t k = 0; k < around.size(); ++k) {
      for (const Index w : cut.faces[around[k]]) {
        if (w == v || w == line[i - 1] || w == line[i + 1]) continue;
        const auto [known, added] = first_with.try_emplace(w, static_cast<Index>(k));
        if (!added) parts.join(known->second, static_cast<Index>(k));
      }
    }
    std::map<Index, std::array<bool, 2>> borders;
    for (std::size_t k = 0; k < around.size(); ++k) {
      auto& [before, after] = borders[parts.root(static_cast<Index>(k))];
      before |= std::ranges::count(cut.faces[around[k]], line[i - 1]) > 0;
      after |= std::ranges::count(cut.faces[around[k]], line[i + 1]) > 0;
    }
    bool is_first = true;
    for (const auto& [part, borders_on] : borders) {
      if (!borders_on[0] || !borders_on[1] || std::exchange(is_first, false)) continue;
      const auto own = static_cast<Index>(torn.soup.positions.size());
      const Point place = torn.soup.positions[v];
      torn.soup.positions.push_back(place);
      torn.vertex_of.push_back(v);
      for (std::size_t k = 0; k < around.size(); ++k) {
        if (parts.root(static_cast<Index>(k)) == part)
          std::ranges::replace(torn.soup.faces[around[k]], v, own);
      }
    }
  }
  return torn;
}

/// No detour over the other source is shorter, by more than distances that are off by `error` allow. Nor does
/// one reach what the field of a source does not.
void check_detours(HostileCase& hostile, const std::string& kind,
                   const std::array<std::vector<double>, 2>& fields, double error) {
  const auto& [s, t] = hostile.sources;
  const double between = std::min(fields[0][t], fields[1][s]);
  hostile.ask(kind + " of vertices " + std::to_string(s) + " and " + std::to_string(t));
  const double allowed = (1.0 + error) / (1.0 - error);
  for (const int i : {0, 1}) {
    for (std::size_t v = 0; v < fields[i].size(); ++v) {
      const double detour = between + fields[1 - i][v];
      if (fields[i][v] <= allowed * detour + hostile.slack(detour)) continue;
      hostile.fail("a detour is shorter by " + kind, "vertex " + std::to_string(v) + ": " +
                                                         exactly(fields[i][v]) + ", " + exactly(between) +
                                                         " and " + exactly(fields[1 - i][v]));
    }
  }
}

class Laws {
 public:
  explicit Laws(HostileCase& hostile)
      : hostile_(hostile),
        random_(hostile.seed + (2ULL << 40)),
        turns_(hostile.seed + (7ULL << 40)),
        count_(hostile.mesh->vertex_count()) {}

  void check() {
    check_detours(hostile_, "exact fields", hostile_.exact, 0.0);
    check_sets();
    check_limit();
    std::vector<Index> place;
    const Soup& soup = hostile_.hostile.soup;
    const Soup other = reordered(soup, random_, place);
    check_same("renumbering changes a distance", other, place, 1.0, 0.0);
    std::iota(place.begin(), place.end(), 0);
    double scale = 1.0;
    const Soup moved = moved_exactly(soup, random_, scale);
    check_same("a motion changes a distance", moved, place, scale, 0.0);
    // Each vertex is rounded by some units in the last place of the greatest coordinate, and with it both
    // ends of the piece of a path in each face, of which a shortest path has at most one.
    if (!hostile_.has_outlier()) {
      const double rounding = 1e-14 * hostile_.farthest * static_cast<double>(soup.faces.size());
      check_same("a turn changes a distance", turned_and_shifted(soup, turns_, hostile_.farthest), place, 1.0,
                 rounding);
    }
    // Midpoints of edges are rounded, by some 1e-16 of their coordinates; a path may cross many.
    check_same("subdivision changes a distance", in_four(soup), place, 1.0, 1e-14 * hostile_.farthest);
    check_constant_cost();
    check_cut();
  }

 private:
  /// Compares with another mesh, whose vertex `place[v]` is v and whose lengths are `scale` times as long.
  void check_same(const std::string& law, const Soup& soup, const std::vector<Index>& place, double scale,
                  double more) {
    hostile_.ask("exact field of vertex " + std::to_string(hostile_.sources[0]) + " on another mesh");
    hostile_.attempt(
        [&] {
          const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces);
          const auto field = exact_distance_field(mesh, std::array{place[hostile_.sources[0]]});
          hostile_.require_same(
              law, [&](Index v) { return hostile_.exact[0][v]; },
              [&](Index v) { return field[place[v]] / scale; }, more);
        },
        may_leave_range(scale));
  }

  /// Whether lengths `scale` times as long, or half of that, may be outside the range that is accepted.
  bool may_leave_range(double scale) const {
    return !exact_lengths.allow(0.5 * scale * hostile_.mesh->mean_edge_length(),
                                scale * hostile_.mesh->longest_edge_length());
  }

  /// Lengths determine needles less well than positions do, and needles that lead to an outlier hardly at
  /// all: with an outlier, the field is only computed, not compared.
  void check_constant_cost() {
    const Soup& soup = hostile_.hostile.soup;
    // No power of two, so that lengths round.
    const double cost = random_.power(-3.0, 3.0);
    hostile_.ask("exact field of vertex " + std::to_string(hostile_.sources[0]) + " at the cost " +
                 exactly(cost));
    hostile_.attempt(
        [&] {
          const std::vector<double> costs(soup.positions.size(), cost);
          const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces,
                                                         lengths_by_cost(soup.positions, soup.faces, costs));
          const auto field = exact_distance_field(mesh, std::array{hostile_.sources[0]});
          if (hostile_.has_outlier()) return;
          hostile_.require_same(
              "a constant cost is not a scale", [&](Index v) { return hostile_.exact[0][v]; },
              [&](Index v) { return field[v] / cost; }, 1e-5 * hostile_.mesh->longest_edge_length());
        },
        may_leave_range(cost));
  }

  /// Shortest paths from a vertex do not cross: tearing the mesh along one keeps all distances from its ends.
  void check_cut() {
    const auto& [source, other] = hostile_.sources;
    const Index target =
        hostile_.exact[0][other] < unreachable ? other : static_cast<Index>(random_.below(count_));
    const double distance = hostile_.exact[0][target];
    if (!(distance < unreachable) || distance == 0.0) return;
    // Beside an outlier, rounded points of the line bend the needles that lead to it.
    if (hostile_.has_outlier()) return;
    hostile_.ask("mesh torn along the path from vertex " + std::to_string(source) + " to " +
                 std::to_string(target));
    hostile_.attempt([&] {
      ExactSolver solver(hostile_.mesh);
      solver.run_from_vertices(std::array{source});
      const CutMesh cut =
          cut_along(*hostile_.mesh, {solver.path_to_source(SurfacePoint::at_vertex(target)).points});
      const std::vector<Index>& line = cut.lines[0];
      // Among faces without width, rounding may end the line early.
      if (line.empty() || line.front() != target || line.back() != source) return;
      const Torn torn = torn_along(cut, positions_of(*hostile_.mesh, cut.points), line);
      const auto mesh = std::make_shared<const Mesh>(torn.soup.positions, torn.soup.faces);
      // Points of the line are rounded by units in the last place of the greatest coordinate, and points very
      // near a corner become that corner.
      const double rounding =
          std::max(1e-12 * hostile_.farthest, 1e-8 * hostile_.mesh->longest_edge_length());
      for (int i = 0; i < (target == other ? 2 : 1); ++i) {
        std::vector<Index> at_end;
        for (Index v = 0; v < mesh->vertex_count(); ++v) {
          if (torn.vertex_of[v] == hostile_.sources[i]) at_end.push_back(v);
        }
        const auto field = exact_distance_field(mesh, at_end);
        std::vector<double> least(cut.points.size(), unreachable);
        for (Index v = 0; v < mesh->vertex_count(); ++v) {
          double& known = least[torn.vertex_of[v]];
          known = std::min(known, field[v]);
        }
        hostile_.require_same(
            "a cut along a shortest path changes a distance", [&](Index v) { return hostile_.exact[i][v]; },
            [&](Index v) { return least[v]; }, rounding);
      }
    });
  }

  void check_sets() {
    hostile_.ask("exact field of both sources");
    const auto field = exact_distance_field(hostile_.mesh, hostile_.sources);
    hostile_.require_same(
        "the distance to both sources is not the lesser one",
        [&](Index v) { return std::min(hostile_.exact[0][v], hostile_.exact[1][v]); },
        [&](Index v) { return field[v]; });
  }

  void check_limit() {
    const auto& exact = hostile_.exact[0];
    const double limit = exact[random_.below(count_)];
    if (limit == unreachable) return;
    hostile_.ask("exact field of vertex " + std::to_string(hostile_.sources[0]) + " up to " + exactly(limit));
    ExactSolver solver(hostile_.mesh);
    solver.run_from_vertices(std::array{hostile_.sources[0]},
                             {.max_distance = limit, .distances_only = true});
    // At the limit itself, rounding decides.
    hostile_.require_same(
        "a limit changes a distance",
        [&](Index v) {
          const bool near = std::abs(exact[v] - limit) <= hostile_.slack(limit);
          return near ? solver.distance(v) : exact[v] > limit ? unreachable : exact[v];
        },
        [&](Index v) { return solver.distance(v); });
  }

  HostileCase& hostile_;
  HostileRandom random_;  ///< its own, so that the other questions of a seed stay the same
  HostileRandom turns_;
  Index count_;
};

/// The index of the mesh times a power of 16 gives the same fields, to the last bit, where single precision
/// holds the fourth powers of all lengths. (Graded tables hold fourth roots, which round otherwise at other
/// powers of two.)
void check_scaled_index(HostileCase& hostile, const std::array<std::vector<double>, 2>& fields) {
  HostileRandom random(hostile.seed + (8ULL << 40));
  // Not on every mesh, as a build takes longer than everything else.
  if (!random.one_in(4)) return;
  constexpr std::array scales{0x1p-8, 0x1p-4, 0x1p4, 0x1p8};
  const double scale = scales[random.below(scales.size())];
  for (Index e = 0; e < hostile.mesh->edge_count(); ++e) {
    const double length = hostile.mesh->edge_length(e);
    if (length > 1e4 || (length > 0.0 && length < 1e-4)) return;
  }
  hostile.ask(hostile.index_text() + "fields at the scale " + exactly(scale));
  hostile.attempt([&] {
    const Soup other = scaled(hostile.hostile.soup, scale);
    const auto mesh = std::make_shared<const Mesh>(other.positions, other.faces);
    IndexQuery query(GeodesicIndex::build(mesh, hostile.options), 1);
    for (int i = 0; i < 2; ++i) {
      const auto field = query.distance_field(std::array{hostile.sources[i]});
      for (std::size_t v = 0; v < field.size(); ++v) {
        if (field[v] / scale == fields[i][v]) continue;
        hostile.fail("a scale changes an index", "vertex " + std::to_string(v) + ": " +
                                                     exactly(field[v] / scale) + ", not " +
                                                     exactly(fields[i][v]));
      }
    }
  });
}

}  // namespace

void check_index_laws(HostileCase& hostile, const std::shared_ptr<const GeodesicIndex>& index) {
  hostile.ask("index fields and quick fields of both sources");
  hostile.attempt([&] {
    Surface surface(index, 1);
    const auto fields = [&](Answer by) {
      std::array<std::vector<double>, 2> found;
      for (int i = 0; i < 2; ++i) {
        Answered answered;
        const std::vector<ExactSource> source = sources_at(std::array{hostile.sources[i]});
        found[i] = surface.field(source, unreachable, by, answered).distance;
      }
      return found;
    };
    const auto by_index = fields(Answer::index);
    check_detours(hostile, "index fields", by_index, hostile.greatest_error);
    check_detours(hostile, "quick fields", fields(Answer::quick), hostile.greatest_error);
    check_scaled_index(hostile, by_index);
  });
}

void check_laws(HostileCase& hostile) {
  if (hostile.exact[1].empty()) return;
  hostile.attempt([&] { Laws(hostile).check(); });
}

}  // namespace vorogeo::test
