// Fields of geodesic methods, and how far they are from others.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "methods/method.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo::test {

/// The field of a method from vertices, with its standard options but for those given.
inline std::vector<double> method_field(const std::string& name, const std::shared_ptr<const Mesh>& mesh,
                                        const std::vector<Index>& sources,
                                        const MethodOptions& options = {}) {
  return prepare_method(name, mesh, options, {})->field(sources, {});
}

/// Of a field against another, where that is above 0 and finite.
inline ErrorStatistics errors_of(const std::vector<double>& field, const std::vector<double>& reference) {
  ErrorCollector errors;
  for (std::size_t v = 0; v < field.size(); ++v) errors.add(field[v], reference[v]);
  return errors.statistics();
}

inline ErrorStatistics errors_against_exact(const std::string& name, const std::shared_ptr<const Mesh>& mesh,
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
