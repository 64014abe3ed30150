// Newton's method for a chain of straight pieces, with bounds.
#include "weighted/snell.h"

#include <algorithm>
#include <cmath>

namespace vorogeo {

namespace {

constexpr int max_rounds = 100;
constexpr double least_decrease = 1e-15;

using Vector = PathPiece::Vector;

/// End minus begin of a piece.
Vector step_of(const PathPiece& piece, double begin, double end) {
  return {piece.end_at[0] + end * piece.end_along[0] - piece.begin_at[0] - begin * piece.begin_along[0],
          piece.end_at[1] + end * piece.end_along[1] - piece.begin_at[1] - begin * piece.begin_along[1]};
}

double length_of_chain(std::span<const PathPiece> pieces, const std::vector<double>& crossing) {
  double sum = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vector step =
        step_of(pieces[i], i > 0 ? crossing[i - 1] : 0.0, i < crossing.size() ? crossing[i] : 0.0);
    sum += std::hypot(step[0], step[1]);
  }
  return sum;
}

/// Gradient and second derivatives; off the diagonal, those with the next crossing.
struct Derivatives {
  std::vector<double> first, diagonal, off_diagonal;
};

Derivatives derivatives_of(std::span<const PathPiece> pieces, const std::vector<double>& crossing,
                           double scale) {
  const std::size_t count = crossing.size();
  Derivatives d{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count)};
  auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const PathPiece& piece = pieces[i];
    const Vector step = step_of(piece, i > 0 ? crossing[i - 1] : 0.0, i < count ? crossing[i] : 0.0);
    // A piece without length has no direction: it counts as a little longer.
    const double length = std::max(std::hypot(step[0], step[1]), 1e-12 * scale);
    const Vector unit{step[0] / length, step[1] / length};
    const Vector begin{-piece.begin_along[0], -piece.begin_along[1]};
    const Vector& end = piece.end_along;
    auto bend = [&](const Vector& a, const Vector& b) {
      return (dot(a, b) - dot(a, unit) * dot(b, unit)) / length;
    };
    if (i > 0) {
      d.first[i - 1] += dot(begin, unit);
      d.diagonal[i - 1] += bend(begin, begin);
    }
    if (i < count) {
      d.first[i] += dot(end, unit);
      d.diagonal[i] += bend(end, end);
    }
    if (i > 0 && i < count) d.off_diagonal[i - 1] += bend(begin, end);
  }
  return d;
}

}  // namespace

double refract(std::span<const PathPiece> pieces, std::vector<double>& crossing) {
  const std::size_t count = crossing.size();
  double length = length_of_chain(pieces, crossing);
  if (count == 0) return length;
  std::vector<double> step(count);
  std::vector<double> factor(count);
  std::vector<double> next(count);
  const double scale = length / static_cast<double>(pieces.size());
  for (int round = 0; round < max_rounds; ++round) {
    Derivatives d = derivatives_of(pieces, crossing, scale);
    // A crossing at an end of its edge stays there while the path would be shorter beyond the edge only.
    auto is_held = [&](std::size_t i) {
      return (crossing[i] <= 0.0 && d.first[i] >= 0.0) || (crossing[i] >= 1.0 && d.first[i] <= 0.0);
    };
    for (std::size_t i = 0; i < count; ++i) {
      d.diagonal[i] += 1e-9 * scale;  // straight chains along an edge have no curvature
      if (!is_held(i)) continue;
      d.first[i] = 0.0;
      d.diagonal[i] = 1.0;
      d.off_diagonal[i] = 0.0;
      if (i > 0) d.off_diagonal[i - 1] = 0.0;
    }
    // Elimination in a symmetric tridiagonal matrix.
    for (std::size_t i = 0; i < count; ++i) {
      factor[i] = d.diagonal[i];
      step[i] = -d.first[i];
      if (i == 0) continue;
      const double ratio = d.off_diagonal[i - 1] / factor[i - 1];
      factor[i] -= ratio * d.off_diagonal[i - 1];
      step[i] -= ratio * step[i - 1];
    }
    for (std::size_t i = count; i-- > 0;) {
      if (i + 1 < count) step[i] -= d.off_diagonal[i] * step[i + 1];
      step[i] /= factor[i];
    }
    double share = 1.0;
    double shorter = length;
    for (; share > 1e-10; share *= 0.5) {
      for (std::size_t i = 0; i < count; ++i) next[i] = std::clamp(crossing[i] + share * step[i], 0.0, 1.0);
      shorter = length_of_chain(pieces, next);
      if (shorter < length) break;
    }
    if (!(shorter < length * (1.0 - least_decrease))) break;
    length = shorter;
    crossing.swap(next);
  }
  return length;
}

}  // namespace vorogeo
