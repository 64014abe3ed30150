// Crossings of edges moved along their edges to where a path is shortest.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace vorogeo {

/// A straight piece of a path in the plane of its face (or on the line of its edge): where it begins and ends
/// as functions of the crossings there, `at + t * along`.
struct PathPiece {
  using Vector = std::array<double, 2>;
  Vector begin_at{};
  Vector begin_along{};
  Vector end_at{};
  Vector end_along{};
};

/// The crossings t in [0, 1] of k edges between k + 1 pieces that make the sum of their lengths least. The
/// sum is convex, so the optimum of the sequence is found: Newton's method with a tridiagonal matrix.
/// `crossing` holds the start and the result. \return the length.
double refract(std::span<const PathPiece> pieces, std::vector<double>& crossing);

}  // namespace vorogeo
