// The stretch of faces whose sides disagree with those of their neighbours.
#include "mesh/edge_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <vector>

#include "mesh/gaps.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// Sides of one edge that are this many times apart turn paths.
constexpr double side_jump = 1.5;

/// Of the edges between two faces. If fewer jump, errors are those of few crossings.
constexpr double jumping_share = 0.1;

/// For a mean error of about half a percent.
constexpr double points_per_stretch = 2.5;

/// Twice the area of a face, in parts of the square of its longest side: less is rounding.
constexpr double no_area = 1e-7;

double least_area(const std::array<double, 3>& sides) {
  const double longest = std::ranges::max(sides);
  return no_area * longest * longest;
}

}  // namespace

double stretch_of(const std::array<double, 3>& sides, const std::array<double, 3>& in_space) {
  const double area_in_space = twice_area(in_space);
  if (!(area_in_space > least_area(in_space))) return 1.0;
  // Where stretches leave rounding of the area, they are at least those that this one gives.
  const double area = std::max(twice_area(sides), least_area(sides));
  // The squared lengths of two sides and their product, in either metric: the ratio of the eigenvalues of one
  // in the other follows from trace and determinant.
  auto form = [](const std::array<double, 3>& s) {
    const double first = s[1] * s[1];
    const double second = s[2] * s[2];
    return std::array{first, 0.5 * (first + second - s[0] * s[0]), second};
  };
  const auto [a, b, c] = form(in_space);
  const auto [x, y, z] = form(sides);
  const double root = area / area_in_space;  // of the determinant
  const double half_trace = 0.5 * (c * x - 2.0 * b * y + a * z) / (area_in_space * area_in_space);
  const double ratio = std::max(1.0, half_trace / root);
  return ratio + std::sqrt((ratio - 1.0) * (ratio + 1.0));
}

Index edge_points_for(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                      const SideLengths& sides) {
  std::vector<double> stretch(faces.size(), 1.0);
  double greatest = 1.0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    if (!is_usable(faces[f])) continue;
    std::array<double, 3> in_space{};
    for (int i = 0; i < 3; ++i) {
      in_space[i] = distance_between(positions[faces[f][(i + 1) % 3]], positions[faces[f][(i + 2) % 3]]);
    }
    stretch[f] = stretch_of(sides[f], in_space);
    greatest = std::max(greatest, stretch[f]);
  }
  const Index fewest = FaceSides{}.points_per_edge;
  if (points_per_stretch * greatest <= fewest) return fewest;

  struct Jump {
    double stretch = 1.0;
    Index face = 0;
  };
  std::vector<Jump> jumps;  // of edges between faces
  std::size_t between = 0;
  const std::vector<SideOfFace> sorted = sides_in_mesh(faces);
  for (auto begin = sorted.begin(), end = begin; begin != sorted.end(); begin = end) {
    end = std::find_if(begin, sorted.end(), [&](const SideOfFace& s) { return s.ends != begin->ends; });
    if (end - begin < 2) continue;
    ++between;
    const std::ranges::subrange edge(begin, end);
    const auto [least, most] =
        std::ranges::minmax(edge, {}, [&](const SideOfFace& s) { return sides[s.face][s.corner]; });
    if (!(sides[most.face][most.corner] > side_jump * sides[least.face][least.corner])) continue;
    const Index face = std::ranges::max(edge, {}, [&](const SideOfFace& s) { return stretch[s.face]; }).face;
    jumps.push_back({stretch[face], face});
  }
  const auto rank = static_cast<std::size_t>(jumping_share * static_cast<double>(between));
  if (rank >= jumps.size()) return fewest;
  // A tenth of all edges lie at faces of at least this stretch.
  std::ranges::nth_element(jumps, jumps.begin() + static_cast<std::ptrdiff_t>(rank), std::greater{},
                           &Jump::stretch);
  const double needed = std::ceil(points_per_stretch * jumps[rank].stretch);
  if (needed <= most_edge_points) return std::max(fewest, static_cast<Index>(needed));
  const auto& [stretched, face] = jumps[rank];
  std::ostringstream text;
  text << "The tensor of face " << face << " makes its sides " << sides[face][0] << ", " << sides[face][1]
       << " and " << sides[face][2] << " long and stretches lengths " << stretched
       << " times as much in one direction as in another, and a tenth of all edges lie between tensors of at "
          "least "
          "this stretch that disagree: distances would need some "
       << needed
       << " points on each edge. Give smoother or less stretched tensors, or `points` for a coarser answer.";
  throw InvalidInput(text.str());
}

}  // namespace vorogeo
