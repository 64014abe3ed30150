// The heat method: diffuse, normalise the gradient, integrate; both matrices are factorised once.
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>
#include <tuple>

#include "methods/intrinsic_mesh.h"
#include "methods/method_table.h"
#include "support/checkpoint.h"
#include "support/error.h"

namespace vorogeo {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Solver = Eigen::SimplicialLDLT<Matrix>;
using Vector = Eigen::VectorXd;

/// Crane, Weischedel, Wardetzky 2013, algorithm 1 with section 3.2: L is the Laplacian of half cotangents, A
/// the lumped masses, a third of the area of each face for its vertices; step 1 solves (A + t L) u = 1 at the
/// sources (borders of the mesh free), step 3 solves L d = divergence of the unit field -grad u.
class Heat final : public GeodesicMethod {
 public:
  Heat(const std::shared_ptr<const Mesh>& mesh, double time_step, bool delaunay, const Progress& progress)
      : mesh_(mesh), surface_(*mesh) {
    const Watch watch(progress, "Heat method: factorising");
    require_lengths(*mesh, "The heat method takes", 1e-60, 1e60);
    if (delaunay) surface_.make_delaunay();
    const Index count = mesh->vertex_count();
    std::vector<Eigen::Triplet<double>> laplacian;
    std::vector<Eigen::Triplet<double>> diffusion;
    const double time = time_step * mesh->mean_edge_length() * mesh->mean_edge_length();
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
    // One vertex of each component is held, which makes the second matrix regular: its rows would sum to 0.
    // The fields are shifted afterwards anyway.
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

  std::vector<double> field(std::span<const Index> sources, const Progress& progress) override {
    const Watch watch(progress, "Heat method");
    const Index count = mesh_->vertex_count();
    Vector start = Vector::Zero(count);
    for (Index source : sources) start[source] = 1.0;
    const Vector heat = diffusion_.solve(start);
    checkpoint();
    const Vector integrated = poisson_.solve(divergence(heat));
    // The level at the sources becomes 0: their mean, in each component.
    std::vector<double> level(mesh_->component_count(), 0.0);
    std::vector<double> sources_in(mesh_->component_count(), 0.0);
    for (Index v = 0; v < count; ++v) {
      if (start[v] == 0.0) continue;
      level[mesh_->component(v)] += integrated[v];
      sources_in[mesh_->component(v)] += 1.0;
    }
    std::vector<double> distance(count, unreachable);
    for (Index v = 0; v < count; ++v) {
      const double sources_here = sources_in[mesh_->component(v)];
      if (sources_here > 0.0) distance[v] = integrated[v] - level[mesh_->component(v)] / sources_here;
    }
    return distance;
  }

  std::size_t bytes() const override {
    const auto of_solver = [](const Solver& solver) {
      const auto& factor = solver.matrixL().nestedExpression();
      return static_cast<std::size_t>(factor.nonZeros()) * (sizeof(double) + sizeof(int)) +
             static_cast<std::size_t>(factor.cols()) * (2 * sizeof(double) + 3 * sizeof(int));
    };
    return bytes_of(surface_.faces) + of_solver(diffusion_) + of_solver(poisson_);
  }

 private:
  void factorise(const std::vector<Eigen::Triplet<double>>& entries, Solver& solver) const {
    Matrix matrix(mesh_->vertex_count(), mesh_->vertex_count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver.compute(matrix);
    if (solver.info() != Eigen::Success) {
      throw InvalidInput(
          "The heat method cannot factorise its matrices on this mesh: faces are too thin. Set the option "
          "delaunay to "
          "1, or choose another method.");
    }
  }

  /// Of the unit field along the falling heat, summed over the corners at each vertex.
  Vector divergence(const Vector& heat) const {
    Vector sums = Vector::Zero(mesh_->vertex_count());
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
    for (Index v = 0; v < mesh_->vertex_count(); ++v) {
      if (held_[v] != 0) sums[v] = 0.0;
    }
    return sums;
  }

  std::shared_ptr<const Mesh> mesh_;
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
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress& progress) {
        return std::make_unique<Heat>(mesh, options.at("time_step"), options.at("delaunay") != 0.0, progress);
      },
      {}};
}

}  // namespace vorogeo
