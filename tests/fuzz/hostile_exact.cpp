// The exact field against references that share no code with it.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "exact/exact_geometry.h"
#include "fuzz/hostile_case.h"
#include "support/hostile_parts.h"
#include "support/subdivided_graph.h"

namespace vorogeo::test {

namespace {

constexpr int points_per_edge = 3;
constexpr int targets = 4;
constexpr std::array thread_counts{2, 3, 8};

/// Compares with closed forms where the surface unrolls, with the graph's upper bounds everywhere.
void check_against_reference(HostileCase& hostile, Index source, const std::vector<double>& field,
                             const SubdividedGraph& graph) {
  const auto& flat = hostile.hostile.flat;
  for (Index v = 0; v < hostile.mesh->vertex_count(); ++v) {
    if (field[v] == unreachable) continue;
    const double upper = graph.upper_bound(v);
    if (field[v] > upper + hostile.slack(upper)) {
      hostile.fail("the exact field is longer than a path",
                   "vertex " + std::to_string(v) + ": " + exactly(field[v]) + ", path over points on edges " +
                       exactly(upper));
    }
    if (flat.empty() || std::isnan(flat[source][0]) || std::isnan(flat[v][0])) continue;
    const double straight = std::hypot(flat[v][0] - flat[source][0], flat[v][1] - flat[source][1]);
    if (std::abs(field[v] - straight) > hostile.slack(straight)) {
      hostile.fail("the exact field is not the closed form",
                   "vertex " + std::to_string(v) + ": " + exactly(field[v]) + ", straight line unrolled " +
                       exactly(straight));
    }
  }
}

/// The solver's own path proves that its distance is not too short, the graph's tightened path that it is not
/// too long.
void check_path(HostileCase& hostile, const ExactSolver& solver, const SubdividedGraph& graph, Index source,
                Index target) {
  hostile.ask("exact path from vertex " + std::to_string(source) + " to " + std::to_string(target));
  const double distance = solver.distance(target);
  if (distance == unreachable || target == source) return;
  const double tight = graph.tightened(target);
  if (distance > tight + hostile.slack(tight)) {
    hostile.fail("the exact field is longer than a path",
                 exactly(distance) + ", tightened path " + exactly(tight));
  }
  hostile.note_error(ErrorKind::reference, tight, distance);
  hostile.attempt([&] {
    const SurfacePath path = solver.path_to_source(SurfacePoint::at_vertex(target));
    const std::string fault =
        hostile.walk->fault(path, SurfacePoint::at_vertex(target), SurfacePoint::at_vertex(source));
    if (!fault.empty()) return hostile.fail("a traced path is none", fault);
    const double length = hostile.walk->length(path);
    if (std::abs(length - distance) > hostile.slack(distance)) {
      hostile.fail("a traced path has another length than the exact field",
                   "field " + exactly(distance) + ", path " + exactly(length));
    }
    if (std::abs(path.length - length) > hostile.slack(length)) {
      hostile.fail("a traced path states another length than its steps",
                   "stated " + exactly(path.length) + ", steps " + exactly(length));
    }
  });
}

/// The same distances from several threads, and the same bits each time, whatever the solver was used for
/// before.
void check_threads(HostileCase& hostile, ExactSolver& solver, Index source,
                   const std::vector<double>& alone) {
  const Index count = hostile.mesh->vertex_count();
  for (int threads : thread_counts) {
    const ExactLimits limits{.distances_only = true, .threads = threads};
    solver.run_from_vertices(std::array{source}, limits);
    std::vector<double> shared(count);
    for (Index v = 0; v < count; ++v) shared[v] = solver.distance(v);
    solver.run_from_vertices(std::array{source}, limits);
    for (Index v = 0; v < count; ++v) {
      const std::string numbers = std::to_string(threads) + " threads, vertex " + std::to_string(v) + ": " +
                                  exactly(shared[v]) + " and ";
      if (solver.distance(v) != shared[v]) {
        hostile.fail("several threads give other bits the second time",
                     numbers + exactly(solver.distance(v)));
      }
      if (shared[v] == alone[v] || std::abs(shared[v] - alone[v]) <= hostile.slack(alone[v])) continue;
      hostile.fail("several threads give another exact field", numbers + exactly(alone[v]) + " from one");
    }
  }
}

/// The same distances if every vertex emits windows in every direction, not only vertices where a path can
/// bend: no window that is left out would make a distance shorter.
void check_bends(HostileCase& hostile, Index source, const std::vector<double>& field) {
  const auto everywhere = std::make_shared<ExactGeometry>(hostile.mesh);
  std::ranges::fill(everywhere->can_bend, ExactGeometry::anywhere);
  ExactSolver solver{std::shared_ptr<const ExactGeometry>(everywhere)};
  solver.run_from_vertices(std::array{source}, {.distances_only = true});
  for (Index v = 0; v < hostile.mesh->vertex_count(); ++v) {
    if (field[v] == solver.distance(v) || std::abs(field[v] - solver.distance(v)) <= hostile.slack(field[v]))
      continue;
    hostile.fail(
        "windows from every vertex give another exact field",
        "vertex " + std::to_string(v) + ": " + exactly(field[v]) + " and " + exactly(solver.distance(v)));
  }
}

}  // namespace

void check_exact(HostileCase& hostile) {
  const Mesh& mesh = *hostile.mesh;
  const bool extreme = mesh.longest_edge_length() > 1e50 || mesh.mean_edge_length() < 1e-50;
  hostile.ask("exact solver");
  if (!hostile.attempt([&] { const ExactSolver refused(hostile.mesh); }, extreme)) return;
  ExactSolver solver(hostile.mesh);
  ExactSolver several(hostile.mesh);
  for (int i = 0; i < 2; ++i) {
    const Index source = hostile.sources[i];
    hostile.ask("exact field of vertex " + std::to_string(source));
    if (!hostile.attempt([&] { solver.run_from_vertices(std::array{source}); }, extreme)) return;
    auto& field = hostile.exact[i];
    for (Index v = 0; v < mesh.vertex_count(); ++v) field.push_back(solver.distance(v));
    hostile.require_sound(field, source, 0.0);
    std::vector<double> lean;
    hostile.costs[static_cast<int>(Step::exact_field)] =
        cost_of([&] { lean = exact_distance_field(hostile.mesh, std::array{source}); });
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (field[v] == lean[v] || std::abs(field[v] - lean[v]) <= hostile.slack(field[v])) continue;
      hostile.fail("distances_only gives another exact field",
                   "vertex " + std::to_string(v) + ": " + exactly(field[v]) + " and " + exactly(lean[v]));
    }
    check_threads(hostile, several, source, lean);
    check_bends(hostile, source, lean);
    const SubdividedGraph graph(hostile.hostile.soup, source, points_per_edge);
    check_against_reference(hostile, source, field, graph);
    for (int t = 0; t < targets; ++t) {
      check_path(hostile, solver, graph, source,
                 static_cast<Index>(hostile.random.below(mesh.vertex_count())));
    }
  }
  const auto [a, b] = hostile.sources;
  const double there = hostile.exact[0][b];
  const double back = hostile.exact[1][a];
  if (there != back && std::abs(there - back) > hostile.slack(there)) {
    hostile.ask("exact distance of vertices " + std::to_string(a) + " and " + std::to_string(b));
    hostile.fail("exact distances are not symmetric", exactly(there) + " and " + exactly(back));
  }
}

}  // namespace vorogeo::test
