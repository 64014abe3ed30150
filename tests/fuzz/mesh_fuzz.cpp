// Nasty meshes through check, mesh, exact solver and index: refused with a message or sound distances, never
// a crash.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "exact/exact_solver.h"
#include "fuzz/fuzz.h"
#include "mesh/mesh_check.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace {

using namespace vorogeo;
using Random = std::mt19937;
using test::Soup;

double number(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Random faces over few vertices: non-manifold in every way.
Soup random_faces(Random& random) {
  Soup soup;
  const unsigned vertices = 1 + random() % 40;
  for (unsigned v = 0; v < vertices; ++v) {
    soup.positions.push_back({number(random, 0, 1), number(random, 0, 1), number(random, 0, 1)});
  }
  for (unsigned f = random() % 120; f > 0; --f) {
    soup.faces.push_back(
        {Index(random() % vertices), Index(random() % vertices), Index(random() % vertices)});
  }
  return soup;
}

/// Vertices on a coarse grid of positions: coincident vertices, zero-length edges, zero-area faces.
void round_positions(Soup& soup, double step) {
  for (Point& p : soup.positions) {
    for (double& x : p) x = std::round(x / step) * step;
  }
}

Soup nasty(Random& random) {
  Soup soup;
  switch (random() % 4) {
    case 0:
      soup = random_faces(random);
      break;
    case 1:
      soup = test::random_sphere(8 + int(random() % 150), random());
      break;
    case 2:
      soup = test::hills(3 + int(random() % 12), number(random, 0, 2));
      break;
    default:
      soup = test::two_components(test::icosphere(int(random() % 3)), random_faces(random));
  }
  for (int i = random() % 4; i > 0; --i) {
    switch (random() % 8) {
      case 0:
        round_positions(soup, number(random, 0.01, 0.5));
        break;
      case 1:  // needles
        for (Point& p : soup.positions) p[random() % 3] *= std::pow(10.0, number(random, -9, 0));
        break;
      case 2: {  // sizes at the limits of floating-point numbers
        const double scale = std::pow(10.0, number(random, -140, 140));
        for (Point& p : soup.positions) {
          for (double& x : p) x *= scale;
        }
        break;
      }
      case 3:  // one vertex far away
        soup.positions[random() % soup.positions.size()][random() % 3] =
            std::pow(10.0, number(random, -9, 9));
        break;
      case 4:  // faces turned over, repeated, left out
        for (auto& face : soup.faces) {
          if (random() % 4 == 0) std::swap(face[0], face[1]);
          if (random() % 16 == 0) face = soup.faces[random() % soup.faces.size()];
        }
        break;
      case 5:  // vertices joined
        for (auto& face : soup.faces) {
          if (random() % 8 == 0) face[random() % 3] = Index(random() % soup.positions.size());
        }
        break;
      case 6: {  // values that are refused
        const std::array bad{std::numeric_limits<double>::quiet_NaN(), unreachable, -unreachable};
        if (random() % 4 == 0) soup.positions[random() % soup.positions.size()][1] = bad[random() % 3];
        if (random() % 4 == 0 && !soup.faces.empty())
          soup.faces[random() % soup.faces.size()][2] = Index(random());
        break;
      }
      default:
        soup = test::with_isolated_vertex(soup, {number(random, 0, 1), 0, 0});
    }
  }
  return soup;
}

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

/// Distances are 0 at the source, never negative, infinite for other components, and differ by at most the
/// edge length along edges. `slack`: relative error allowed along edges.
void require_sound(const Mesh& mesh, Index source, const std::vector<double>& field, double slack) {
  require(field[source] == 0.0, "the source is not at distance 0");
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    require(field[v] >= 0.0, "a negative distance or none at vertex " + std::to_string(v));
    require((field[v] < unreachable) == (mesh.component(v) == mesh.component(source)),
            "vertex " + std::to_string(v) + " is reached or not as its component says otherwise");
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    if (field[a] == unreachable) continue;
    require(std::abs(field[a] - field[b]) <= mesh.edge_length(e) + slack * std::max(field[a], field[b]),
            "distances differ by more than edge " + std::to_string(e));
  }
}

void attempt(Random& random) {
  const Soup soup = nasty(random);
  const MeshReport report = check_mesh(soup.positions, soup.faces);
  for (const std::string& sentence : report.sentences()) require(!sentence.empty(), "an empty sentence");
  std::shared_ptr<const Mesh> mesh;
  try {
    mesh = test::make_mesh(soup);
  } catch (const InvalidInput&) {
    require(!report.usable() || !soup.faces.empty(), "refused what the report calls usable");
    return;
  }
  require(report.non_finite_vertices.count == 0 && report.faces_out_of_range.count == 0,
          "the report refuses what became a mesh");
  if (mesh->vertex_count() == 0) return;
  const auto source = static_cast<Index>(random() % mesh->vertex_count());
  std::vector<double> exact;
  try {
    exact = exact_distance_field(mesh, std::array{source});
  } catch (const InvalidInput&) {
    require(mesh->longest_edge_length() > 1e50 || mesh->longest_edge_length() < 1e-50,
            "exact distances were refused without reason");
    return;
  }
  require_sound(*mesh, source, exact, 1e-6);

  IndexOptions options;
  options.threads = 1;
  options.delta = random() % 2 ? 0.0 : 0.01;
  options.first_layer_patches = Index(random() % 5);
  options.second_layer_patches = Index(random() % 5);
  std::shared_ptr<const GeodesicIndex> index;
  try {
    index = GeodesicIndex::build(mesh, options);
  } catch (const InvalidInput&) {
    const Index most = std::max(options.first_layer_patches, options.second_layer_patches);
    const bool ordinary = mesh->longest_edge_length() <= 1e28 && mesh->mean_edge_length() >= 1e-28;
    require(mesh->face_count() < std::max<Index>(most, 1) || !ordinary,
            "an index was refused without reason");
    return;
  }
  test::IndexQuery query(index, 1);
  const auto field = query.distance_field(std::array{source});
  require_sound(*mesh, source, field, 2.0);
  for (int i = 0; i < 5; ++i) {
    const auto target = static_cast<Index>(random() % mesh->vertex_count());
    const double distance = query.distance(source, target);
    require(distance == query.distance(target, source), "not symmetric");
    require((distance < unreachable) == (exact[target] < unreachable), "a pair contradicts its component");
  }
}

}  // namespace

int main(int argc, char** argv) { return vorogeo::test::fuzz(argc, argv, attempt); }
