// Fields of geodesic methods, and how far they are from others.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "methods/method.h"
#include "support/shapes.h"

namespace vorogeo::test {

/// The field of a method from vertices, with its standard options but for those given.
inline std::vector<double> method_field(const std::string& name, const std::shared_ptr<const Mesh>& mesh,
                                        const std::vector<Index>& sources,
                                        const MethodOptions& options = {}) {
  return prepare_method(name, mesh, options, {})->field(sources, {});
}

/// Mean and largest relative difference where the reference is above 0 and finite.
struct Errors {
  double mean = 0.0;
  double greatest = 0.0;
  double least = 0.0;  ///< signed: the greatest that is too short
};

inline Errors errors_of(const std::vector<double>& field, const std::vector<double>& reference) {
  Errors errors;
  double count = 0.0;
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (!(reference[v] > 0.0 && std::isfinite(reference[v]))) continue;
    const double error = field[v] / reference[v] - 1.0;
    errors.mean += std::abs(error);
    errors.greatest = std::max(errors.greatest, std::abs(error));
    errors.least = std::min(errors.least, error);
    count += 1.0;
  }
  errors.mean /= count;
  return errors;
}

inline Errors errors_against_exact(const std::string& name, const std::shared_ptr<const Mesh>& mesh,
                                   Index source, const MethodOptions& options = {}) {
  return errors_of(method_field(name, mesh, {source}, options),
                   exact_distance_field(mesh, std::vector<Index>{source}));
}

/// A rectangle of unequal triangles around the origin: rows of equilateral ones, stretched along x. Vertex
/// (i, j) has index j (2 half + 1) + i; the middle one is at the origin.
inline Soup stretched_triangles(int half, double stretch) {
  Soup soup;
  const int side = 2 * half + 1;
  for (int j = -half; j <= half; ++j) {
    for (int i = -half; i <= half; ++i) {
      soup.positions.push_back({stretch * (i + 0.5 * j) / half, std::sqrt(0.75) * j / half, 0.0});
    }
  }
  for (Index j = 0; j + 1 < side; ++j) {
    for (Index i = 0; i + 1 < side; ++i) {
      const Index a = j * side + i;
      soup.faces.push_back({a, a + 1, a + side});
      soup.faces.push_back({a + 1, a + side + 1, a + side});
    }
  }
  return soup;
}

/// Straight distances from a vertex of a flat soup.
inline std::vector<double> straight_distances(const Soup& soup, Index from) {
  std::vector<double> distances;
  for (const Point& point : soup.positions)
    distances.push_back(distance_between(point, soup.positions[from]));
  return distances;
}

}  // namespace vorogeo::test
