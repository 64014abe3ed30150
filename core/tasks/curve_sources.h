// Curves as sources: evenly spaced points along them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "exact/exact_solver.h"

namespace vorogeo {

/// The edges of a curve, by their ends as given. \throw InvalidInput for two that no edge joins.
std::vector<Index> edges_of_curve(const Mesh& mesh, std::span<const std::array<int, 2>> ends);

/// Points along edges of the mesh, at most `spacing` apart, including the vertices, each once.
///
/// The distance from the nearest of them is never shorter than that from the edges themselves, and at most
/// half the spacing longer; at a distance d much larger than the spacing, at most about spacing^2 / (8 d).
/// \throw InvalidInput for a spacing that is not above 0, or if there would be more than ten million points.
/// Complexity: O(points).
std::vector<ExactSource> sources_along_edges(const Mesh& mesh, std::span<const Index> edges, double spacing);

/// The number of pieces of a line of this length, each at most `spacing` long. \throw as above.
int pieces_of(double length, double spacing);

/// Points along a straight line in space, at most `spacing` apart, without its ends. \throw as above.
std::vector<Point> points_between(const Point& a, const Point& b, double spacing);

}  // namespace vorogeo
