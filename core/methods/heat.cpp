// The heat method on the intrinsic Delaunay triangulation.
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include "mesh/orientation.h"
#include "mesh/vectors.h"
#include "methods/method.h"
#include "support/error.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Faces of one orientation, and the flips that make them Delaunay

namespace {

/// Needles thinner than this are taken to be this thick, so that their cotangents stay finite.
constexpr double least_area_part = 1e-14;
/// An edge whose opposite angles sum to pi up to rounding is not flipped.
constexpr double cotangent_slack = 1e-9;

/// Faces with vertices, edge lengths and neighbours; edge i of a face runs from corner i to corner i + 1.
/// The vertices are those of the mesh. Two faces at an edge run along it in opposite directions where the
/// surface allows that; edges where it does not (non-manifold or one-sided) have no neighbour.
struct IntrinsicMesh {
  struct Face {
    std::array<Index, 3> vertex;
    std::array<double, 3> length;
    /// 3 f + i for edge i of face f on the other side; no_index: none.
    std::array<Index, 3> across;
  };
  std::vector<Face> faces;

  explicit IntrinsicMesh(const Mesh& mesh);

  /// Flips edges until the angles opposite to each sum to at most pi (Bobenko, Springborn 2007). Distances on
  /// the surface stay what they are.
  void make_delaunay();

  /// Twice the area, at least `least_area_part` of the longest edge squared.
  static double double_area(const Face& face);
  /// Cotangent of the angle opposite to edge i.
  static double cotangent(const Face& face, int i);

 private:
  bool is_delaunay(Index f, int i) const;
  bool flip(Index f, int i);
};

double IntrinsicMesh::double_area(const Face& face) {
  const double longest = *std::max_element(face.length.begin(), face.length.end());
  return std::max(twice_area(face.length), least_area_part * longest * longest);
}

double IntrinsicMesh::cotangent(const Face& face, int i) {
  const double area = double_area(face);
  if (!(area > 0.0)) return 0.0;
  const double own = face.length[i];
  const double a = face.length[(i + 1) % 3];
  const double b = face.length[(i + 2) % 3];
  return (a * a + b * b - own * own) / (2.0 * area);
}

IntrinsicMesh::IntrinsicMesh(const Mesh& mesh) {
  faces.resize(mesh.face_count());
  // Faces turned over so that neighbours run along their common edge in opposite directions.
  const std::vector<bool> turned = turned_faces(mesh);
  // Edge i of a turned face is the edge 2 - i of the face as it was.
  const auto place = [&](Index h) {
    const Index f = Mesh::face_of(h);
    return turned[f] ? 3 * f + 2 - h % 3 : h;
  };
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index f = Mesh::face_of(h);
    const Index own = place(h);
    faces[f].vertex[own % 3] = turned[f] ? mesh.head(h) : mesh.tail(h);
    faces[f].length[own % 3] = mesh.edge_length(mesh.edge_of(h));
    const Index g = other_side(mesh, h);
    const bool opposite =
        g != no_index && ((mesh.tail(g) == mesh.tail(h)) == (turned[f] != turned[Mesh::face_of(g)]));
    faces[f].across[own % 3] = opposite ? place(g) : no_index;
  }
}

bool IntrinsicMesh::is_delaunay(Index f, int i) const {
  const Index g = faces[f].across[i];
  if (g == no_index) return true;
  return cotangent(faces[f], i) + cotangent(faces[g / 3], g % 3) >= -cotangent_slack;
}

bool IntrinsicMesh::flip(Index f, int i) {
  const Index other = faces[f].across[i];
  const Index g = other / 3;
  const int j = other % 3;
  if (g == f) return false;
  const Face one = faces[f];
  const Face two = faces[g];
  // The edge from a to b, with c on the side of f and d on that of g, laid along the x axis.
  const double length = one.length[i];
  const double to_b = one.length[(i + 1) % 3];
  const double to_a = one.length[(i + 2) % 3];
  const double from_a = two.length[(j + 1) % 3];
  const double from_b = two.length[(j + 2) % 3];
  const double cx = 0.5 * (length + (to_a - to_b) * (to_a + to_b) / length);
  const double dx = 0.5 * (length + (from_a - from_b) * (from_a + from_b) / length);
  const double new_length = std::hypot(cx - dx, (double_area(one) + double_area(two)) / length);
  if (!(length > 0.0 && new_length > 0.0) || !std::isfinite(new_length)) return false;
  faces[f] = {{one.vertex[(i + 2) % 3], one.vertex[i], two.vertex[(j + 2) % 3]},
              {to_a, from_a, new_length},
              {one.across[(i + 2) % 3], two.across[(j + 1) % 3], 3 * g + 2}};
  faces[g] = {{two.vertex[(j + 2) % 3], one.vertex[(i + 1) % 3], one.vertex[(i + 2) % 3]},
              {from_b, to_b, new_length},
              {two.across[(j + 2) % 3], one.across[(i + 1) % 3], 3 * f + 2}};
  // Other edges at which the two faces meet have moved with them.
  const auto moved = [&](Index edge) {
    if (edge == 3 * f + (i + 2) % 3) return 3 * f;
    if (edge == 3 * g + (j + 1) % 3) return 3 * f + 1;
    if (edge == 3 * g + (j + 2) % 3) return 3 * g;
    if (edge == 3 * f + (i + 1) % 3) return 3 * g + 1;
    return edge;
  };
  for (const Index face : {f, g}) {
    for (int k = 0; k < 2; ++k) {
      Index& across = faces[face].across[k];
      if (across == no_index) continue;
      across = across / 3 == f || across / 3 == g ? moved(across) : across;
      faces[across / 3].across[across % 3] = 3 * face + k;
    }
  }
  return true;
}

void IntrinsicMesh::make_delaunay() {
  std::vector<Index> stack;
  for (Index edge = static_cast<Index>(3 * faces.size()) - 1; edge >= 0; --edge) stack.push_back(edge);
  // Each flip makes the triangulation "more Delaunay", but with rounding, one on needles might not: their
  // number is bounded.
  const std::size_t max_flips = 100 * faces.size();
  std::size_t flips = 0;
  while (!stack.empty() && flips < max_flips) {
    const Index edge = stack.back();
    stack.pop_back();
    const Index f = edge / 3;
    const int i = edge % 3;
    if (is_delaunay(f, i)) continue;
    const Index g = faces[f].across[i] / 3;
    if (!flip(f, i)) continue;
    ++flips;
    for (const Index face : {f, g}) {
      for (int k = 0; k < 2; ++k) stack.push_back(3 * face + k);
    }
  }
}

// ---- The heat method: diffuse, normalise the gradient, integrate; both matrices are factorised once

using Matrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<Matrix>;
using Vector = Eigen::VectorXd;

/// Crane, Weischedel, Wardetzky 2013, algorithm 1 with section 3.2: L is the Laplacian of half cotangents, A
/// the lumped masses, a third of the area of each face for its vertices; step 1 solves (A + t L) u = 1 at the
/// sources (borders of the mesh free), step 3 solves L d = divergence of the unit field -grad u.
class Heat final : public GeodesicMethod {
 public:
  Heat(const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress& progress)
      : GeodesicMethod(mesh, "Heat method"), surface_(*mesh) {
    const Watch watch(progress, "Heat method: factorising");
    require_lengths(*mesh, "The heat method takes", exact_lengths);
    if (options.at("delaunay") != 0.0) surface_.make_delaunay();
    const Index count = mesh->vertex_count();
    std::vector<Eigen::Triplet<double>> laplacian;
    std::vector<Eigen::Triplet<double>> diffusion;
    const double time = options.at("time_step") * mesh->mean_edge_length() * mesh->mean_edge_length();
    for (const auto& face : surface_.faces) {
      for (int i = 0; i < 3; ++i) {
        const Index a = face.vertex[i];
        const Index b = face.vertex[(i + 1) % 3];
        const double weight = 0.5 * IntrinsicMesh::cotangent(face, i);
        for (const auto& [row, column, sign] :
             {std::tuple{a, a, 1.0}, {b, b, 1.0}, {a, b, -1.0}, {b, a, -1.0}}) {
          laplacian.emplace_back(row, column, sign * weight);
          diffusion.emplace_back(row, column, sign * weight * time);
        }
        diffusion.emplace_back(a, a, IntrinsicMesh::double_area(face) / 6.0);
      }
    }
    // One vertex of each component is held at 0, which makes the second matrix regular: otherwise its rows
    // would sum to 0. The fields are shifted afterwards anyway.
    held_.assign(count, 0);
    std::vector<std::uint8_t> has_held(mesh->component_count(), 0);
    for (Index v = 0; v < count; ++v) {
      if (has_held[mesh->component(v)] == 0 || mesh->corners(v).empty()) held_[v] = 1;
      has_held[mesh->component(v)] = 1;
      if (mesh->corners(v).empty()) diffusion.emplace_back(v, v, 1.0);
    }
    std::erase_if(laplacian,
                  [&](const auto& entry) { return held_[entry.row()] != 0 || held_[entry.col()] != 0; });
    for (Index v = 0; v < count; ++v) {
      if (held_[v] != 0) laplacian.emplace_back(v, v, 1.0);
    }
    factorise(diffusion, diffusion_);
    checkpoint();
    factorise(laplacian, poisson_);
  }

  std::size_t bytes() const override {
    const auto of_solver = [](const Solver& solver) {
      const auto& factor = solver.matrixL().nestedExpression();
      return static_cast<std::size_t>(factor.nonZeros()) * (sizeof(double) + sizeof(int)) +
             static_cast<std::size_t>(factor.cols()) * (2 * sizeof(double) + 3 * sizeof(int));
    };
    return bytes_of(surface_.faces) + bytes_of(held_) + of_solver(diffusion_) + of_solver(poisson_);
  }

 private:
  std::vector<double> solve(std::span<const Index> sources, const Progress&) override {
    const Index count = mesh().vertex_count();
    Vector start = Vector::Zero(count);
    for (Index source : sources) start[source] = 1.0;
    const Vector heat = diffusion_.solve(start);
    checkpoint();
    const Vector integrated = poisson_.solve(divergence(heat));
    // In each component, the mean level of the sources becomes 0.
    std::vector<double> level(mesh().component_count(), 0.0);
    std::vector<double> sources_in(mesh().component_count(), 0.0);
    for (Index v = 0; v < count; ++v) {
      if (start[v] == 0.0) continue;
      level[mesh().component(v)] += integrated[v];
      sources_in[mesh().component(v)] += 1.0;
    }
    std::vector<double> distance(count, unreachable);
    for (Index v = 0; v < count; ++v) {
      const double sources_here = sources_in[mesh().component(v)];
      if (sources_here > 0.0) distance[v] = integrated[v] - level[mesh().component(v)] / sources_here;
    }
    return distance;
  }

  void factorise(const std::vector<Eigen::Triplet<double>>& entries, Solver& solver) const {
    Matrix matrix(mesh().vertex_count(), mesh().vertex_count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver.compute(matrix);
    if (solver.info() != Eigen::Success) {
      throw InvalidInput(
          "The heat method cannot factorise its matrices on this mesh: faces are too thin. Set the option "
          "delaunay to "
          "1, or choose another method.");
    }
  }

  /// The divergence of the unit field along the falling heat, summed over the corners at each vertex.
  Vector divergence(const Vector& heat) const {
    Vector sums = Vector::Zero(mesh().vertex_count());
    for (const auto& face : surface_.faces) {
      // Corner 0 in the origin, corner 1 on the x axis.
      const auto [a, b, c] = face.length;
      if (!(a > 0.0)) continue;
      const double height = IntrinsicMesh::double_area(face) / a;
      const double foot = 0.5 * (a + (c - b) * (c + b) / a);
      const double dx = (heat[face.vertex[1]] - heat[face.vertex[0]]) / a;
      const double dy = (heat[face.vertex[2]] - heat[face.vertex[0]] - dx * foot) / height;
      const double size = std::hypot(dx, dy);
      if (!(size > 0.0 && std::isfinite(size))) continue;
      const double x = -dx / size;
      const double y = -dy / size;
      const std::array along{a * x, (foot - a) * x + height * y, -foot * x - height * y};
      for (int i = 0; i < 3; ++i) {
        const double part = 0.5 * IntrinsicMesh::cotangent(face, i) * along[i];
        sums[face.vertex[i]] -= part;
        sums[face.vertex[(i + 1) % 3]] += part;
      }
    }
    for (Index v = 0; v < mesh().vertex_count(); ++v) {
      if (held_[v] != 0) sums[v] = 0.0;
    }
    return sums;
  }

  IntrinsicMesh surface_;
  std::vector<std::uint8_t> held_;
  Solver diffusion_;
  Solver poisson_;
};

}  // namespace

MethodEntry heat_entry() {
  return {
      {"heat",
       "Heat method",
       "K. Crane, C. Weischedel, M. Wardetzky: Geodesics in heat. ACM Transactions on Graphics 32(5), 2013; "
       "on "
       "an intrinsic Delaunay triangulation: N. Sharp, K. Crane: A Laplacian for nonmanifold triangle "
       "meshes. "
       "Computer Graphics Forum 39(5), 2020",
       {{"time_step", 1.0, 1e-3, 1e6, false, "time of the heat flow, in squares of the mean edge length"},
        {"delaunay", 0.0, 0.0, 1.0, true, "1: on the intrinsic Delaunay triangulation of the surface"}},
       {"MSAD", "two factorised matrices", "none", "any with a Laplacian",
        "set-up about n^1.5, field n log n"},
       false,
       false},
      prepared<Heat>};
}

}  // namespace vorogeo
