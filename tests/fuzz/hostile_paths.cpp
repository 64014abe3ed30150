// Paths of an index: their ends, faces and summed length, and their excess over the exact distance.
#include <cmath>
#include <optional>

#include "fuzz/hostile_case.h"
#include "query/path_query.h"

namespace vorogeo::test {

namespace {

void check_one_path(HostileCase& hostile, PathQuery& query, const SurfacePoint& source,
                    const SurfacePoint& target, double exact, const std::string& between) {
  const Mesh& mesh = *hostile.mesh;
  auto check = [&](const SurfacePath& path, bool certified, const std::string& name) {
    const std::string numbers = "length " + exactly(path.length) + ", exact " + exactly(exact);
    if ((path.length < unreachable) != (exact < unreachable)) {
      return hostile.fail(name + " path: reached or not, against the components", numbers);
    }
    if (exact == unreachable) return;
    const std::string fault = hostile.walk->fault(path, source, target);
    if (!fault.empty()) return hostile.fail(name + " path is none", fault + ", " + numbers);
    const double length = hostile.walk->length(path);
    if (!(std::abs(length - path.length) <= hostile.slack(length))) {
      hostile.fail(name + " path states another length than its steps",
                   numbers + ", steps " + exactly(length));
    }
    if (!(path.length >= exact - hostile.slack(exact))) {
      hostile.fail(name + " path is shorter than the exact distance", numbers);
    }
    // A path over a hundred edges of length 0 is rounded at each of its points.
    const double rounding = 1e-16 * static_cast<double>(path.points.size()) * mesh.longest_edge_length();
    if (certified && !(path.length <= exact + hostile.slack(exact) + rounding)) {
      hostile.fail("certified path is too long", numbers);
    }
  };
  hostile.ask(hostile.index_text() + "path " + between);
  hostile.attempt([&] {
    const SurfacePath path = query.path(source, target);
    check(path, false, "refined");
    hostile.note_error(ErrorKind::refined_path, path.length, exact);
  });
  for (const bool certify : {true, false}) {
    hostile.ask(hostile.index_text() + (certify ? "exact_path " : "exact_path, certify = false, ") + between);
    hostile.attempt([&] {
      const ExactPath found = query.exact_path(source, target, certify);
      check(found.path, found.certified, found.certified ? "certified" : "uncertified");
      if (!found.certified) hostile.note_error(ErrorKind::uncertified_path, found.path.length, exact);
    });
  }
}

}  // namespace

void check_paths(HostileCase& hostile, const std::shared_ptr<const GeodesicIndex>& index,
                 const std::vector<Index>& targets, const SurfacePoint& inside) {
  std::optional<PathQuery> query;
  if (!hostile.attempt([&] { query.emplace(index); })) return;
  hostile.costs[static_cast<int>(Step::paths)] = cost_of([&] {
    for (Index target : targets) {
      const Index source = hostile.sources[0];
      check_one_path(hostile, *query, SurfacePoint::at_vertex(source), SurfacePoint::at_vertex(target),
                     hostile.exact[0][target],
                     "from vertex " + std::to_string(source) + " to " + std::to_string(target));
    }
  });
  const Index target = targets.front();
  const std::string place = "from (" + exactly(inside.barycentric[0]) + ", " +
                            exactly(inside.barycentric[1]) + ", ..) in face " + std::to_string(inside.face) +
                            " to vertex " + std::to_string(target);
  hostile.ask(hostile.index_text() + "exact distance " + place);
  double exact = 0.0;
  const bool known = hostile.attempt([&] {
    ExactSolver solver(hostile.mesh);
    const ExactSource source{inside};
    solver.run(std::span(&source, 1));
    exact = solver.distance(target);
  });
  if (known) check_one_path(hostile, *query, inside, SurfacePoint::at_vertex(target), exact, place);
}

}  // namespace vorogeo::test
