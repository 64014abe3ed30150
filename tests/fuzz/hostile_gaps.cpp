// Gaps: bridges join borders and nothing else; no distance gets longer, or shorter than the straight line,
// and the mesh torn into loose triangles gives the same distances.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "fuzz/hostile_case.h"
#include "mesh/gaps.h"
#include "support/gaps.h"

namespace vorogeo::test {

namespace {

/// Above this number of faces, the mesh is not torn into loose triangles.
constexpr std::size_t few_faces = 1000;

/// The exact field of a mesh with its gaps up to a limit bridged.
std::vector<double> bridged_field(const Soup& soup, const GapLimit& limit, Index source) {
  const Mesh open(soup.positions, soup.faces);
  const auto mesh = std::make_shared<const Mesh>(soup.positions, soup.faces, find_gap_bridges(open, limit));
  return exact_distance_field(mesh, std::array{source});
}

void check_bridges(HostileCase& hostile, HostileRandom& random) {
  const Mesh& mesh = *hostile.mesh;
  const Index source = hostile.sources[0];
  const GapLimit limit{hostile.typical * random.power(-4.0, 0.5), random.one_in(4)};
  hostile.ask("gaps up to " + exactly(limit.length) + (limit.folds ? ", also at folds" : ""));
  const GapBridges bridges = find_gap_bridges(mesh, limit);
  if (!find_gap_bridges(mesh, {}).empty()) hostile.fail("bridges without a limit", "");
  bool has_border = false;
  for (Index e = 0; e < mesh.edge_count(); ++e) has_border = has_border || mesh.is_border_edge(e);
  if (!has_border && !bridges.empty())
    hostile.fail("bridges on a surface without a border", std::to_string(bridges.faces.size()) + " faces");
  const std::vector<double> field = bridged_field(hostile.hostile.soup, limit, source);
  const Point& origin = hostile.hostile.soup.positions[source];
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const double open = hostile.exact[0][v];
    const double straight = distance_between(hostile.hostile.soup.positions[v], origin);
    const std::string numbers = "vertex " + std::to_string(v) + ": " + exactly(field[v]) +
                                ", without bridges " + exactly(open) + ", straight " + exactly(straight);
    if (!(field[v] <= open + hostile.slack(open))) hostile.fail("a bridge makes a distance longer", numbers);
    if (!(field[v] >= straight - hostile.slack(straight)))
      hostile.fail("over a bridge shorter than the straight line", numbers);
  }
}

/// Every face gets vertices of its own, at the same places: bridging gaps of next to no width restores the
/// surface. Not for meshes with two vertices at one place, which bridging would join as well.
void check_loose(HostileCase& hostile) {
  const Soup& soup = hostile.hostile.soup;
  if (soup.faces.size() > few_faces) return;
  const std::set<Point> places(soup.positions.begin(), soup.positions.end());
  if (places.size() < soup.positions.size()) return;
  hostile.ask("loose triangles");
  // A face that names a vertex twice would become a connection.
  const Cut loose = exploded({soup.positions, hostile.mesh->faces()});
  const auto of_source = std::ranges::find(loose.origin, hostile.sources[0]) - loose.origin.begin();
  constexpr double next_to_nothing = 1e-300;
  // T-junctions are gaps of no width, and how they are bridged depends on the order of faces.
  if (!find_gap_bridges(*hostile.mesh, {next_to_nothing}).empty()) return;
  const auto field = bridged_field(loose.soup, {next_to_nothing}, static_cast<Index>(of_source));
  for (std::size_t v = 0; v < loose.origin.size(); ++v) {
    const double exact = hostile.exact[0][loose.origin[v]];
    if (field[v] == exact || std::abs(field[v] - exact) <= hostile.slack(exact)) continue;
    hostile.fail("loose triangles are not the surface", "vertex " + std::to_string(loose.origin[v]) + ": " +
                                                            exactly(field[v]) + ", not " + exactly(exact));
  }
}

}  // namespace

void check_gaps(HostileCase& hostile) {
  if (hostile.exact[1].empty()) return;
  HostileRandom random(hostile.seed + (20ULL << 40));
  hostile.attempt([&] { check_bridges(hostile, random); });
  hostile.attempt([&] { check_loose(hostile); });
}

}  // namespace vorogeo::test
