// What exact fields keep to on every mesh: the mesh told in other words has the same distances.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "fuzz/hostile_case.h"
#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

/// Vertices, faces and corners in random order, so that some faces are turned over. `place` receives the new
/// number of each vertex.
Soup reordered(const Soup& soup, HostileRandom& random, std::vector<Index>& place) {
  place.resize(soup.positions.size());
  std::iota(place.begin(), place.end(), 0);
  shuffle(place, random);
  Soup result = renumbered(soup, place);
  for (auto& face : result.faces) shuffle(face, random);
  shuffle(result.faces, random);
  return result;
}

/// Axes in another order and the other way round, and a size of another power of two: what rounds nothing.
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

class Laws {
 public:
  explicit Laws(HostileCase& hostile)
      : hostile_(hostile), random_(hostile.seed + (2ULL << 40)), count_(hostile.mesh->vertex_count()) {
    for (const Point& p : hostile.hostile.soup.positions) {
      for (double x : p) farthest_ = std::max(farthest_, std::abs(x));
    }
  }

  void check() {
    check_inequality();
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
    // A middle is rounded, by some 1e-16 of its place; a path may lead over many.
    check_same("subdivision changes a distance", in_four(soup), place, 1.0, 1e-14 * farthest_);
  }

 private:
  /// Complains where two fields differ by more than the slack and `more`.
  void compare(const std::string& law, const std::function<double(Index)>& expected,
               const std::function<double(Index)>& actual, double more = 0.0) {
    for (Index v = 0; v < count_; ++v) {
      const double a = expected(v);
      const double b = actual(v);
      if (a == b || std::abs(a - b) <= hostile_.slack(a) + more) continue;
      hostile_.fail(law, "vertex " + std::to_string(v) + ": " + exactly(b) + ", not " + exactly(a));
    }
  }

  /// On another mesh, whose vertices are at `place` and whose lengths are `scale` times as long.
  void check_same(const std::string& law, const Soup& soup, const std::vector<Index>& place, double scale,
                  double more) {
    hostile_.ask("exact field of vertex " + std::to_string(hostile_.sources[0]) + " on another mesh");
    hostile_.attempt([&] {
      const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces);
      const auto field = exact_distance_field(mesh, std::array{place[hostile_.sources[0]]});
      compare(
          law, [&](Index v) { return hostile_.exact[0][v]; },
          [&](Index v) { return field[place[v]] / scale; }, more);
    });
  }

  void check_inequality() {
    const auto& [first, second] = hostile_.exact;
    const double between = first[hostile_.sources[1]];
    hostile_.ask("exact fields of vertices " + std::to_string(hostile_.sources[0]) + " and " +
                 std::to_string(hostile_.sources[1]));
    for (Index v = 0; v < count_; ++v) {
      if (first[v] <= second[v] + between + hostile_.slack(first[v])) continue;
      hostile_.fail("a detour is shorter", "vertex " + std::to_string(v) + ": " + exactly(first[v]) + ", " +
                                               exactly(between) + " and " + exactly(second[v]));
    }
  }

  void check_sets() {
    hostile_.ask("exact field of both sources");
    const auto field = exact_distance_field(hostile_.mesh, hostile_.sources);
    compare(
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
    compare(
        "a limit changes a distance",
        [&](Index v) {
          const bool near = std::abs(exact[v] - limit) <= hostile_.slack(limit);
          return near ? solver.distance(v) : exact[v] > limit ? unreachable : exact[v];
        },
        [&](Index v) { return solver.distance(v); });
  }

  HostileCase& hostile_;
  HostileRandom random_;  ///< its own, so that what else is asked of a seed stays
  Index count_;
  double farthest_ = 0.0;  ///< largest coordinate
};

}  // namespace

void check_laws(HostileCase& hostile) {
  if (hostile.exact[1].empty()) return;
  hostile.attempt([&] { Laws(hostile).check(); });
}

}  // namespace vorogeo::test
