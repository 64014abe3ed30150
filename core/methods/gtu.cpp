// Geodesic triangles between samples: distances of two points by unfolding, in constant time.
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "exact/exact_solver.h"
#include "mesh/vectors.h"
#include "methods/method.h"
#include "support/error.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

using Triple = std::array<Index, 3>;

/// The samples kept for each vertex until its triangle is found: corners of the triangle that holds it are
/// among the nearest.
constexpr int samples_kept = 16;

/// The nearest samples of a vertex, in order of distance.
struct Nearest {
  std::array<Index, samples_kept> sample;
  std::array<double, samples_kept> distance;

  Nearest() {
    sample.fill(no_index);
    distance.fill(unreachable);
  }
  void add(Index one, double away) {
    for (int k = 0; k < samples_kept && away < unreachable; ++k) {
      if (!(away < distance[k])) continue;
      std::swap(away, distance[k]);
      std::swap(one, sample[k]);
    }
  }
  double of(Index one) const {
    const auto found = std::ranges::find(sample, one);
    return found == sample.end() ? unreachable : distance[found - sample.begin()];
  }
};

/// Three samples, and the distances of a vertex from them.
struct Corners {
  Triple sample{no_index, no_index, no_index};
  std::array<double, 3> distance{unreachable, unreachable, unreachable};
};

struct UnfoldedPoint {
  double x, y;
};

class GeodesicTriangles final : public GeodesicMethod {
 public:
  GeodesicTriangles(const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options,
                    const Progress& progress)
      : GeodesicMethod(mesh, "Geodesic triangles"), most_(static_cast<Index>(options.at("m"))) {
    std::vector<Nearest> nearest(mesh->vertex_count());
    take_samples(mesh, nearest, progress);
    find_triangles(nearest);
  }

  std::size_t bytes() const override { return bytes_of(table_) + bytes_of(corners_); }

 private:
  double solve_pair(Index source, Index target) override {
    if (source == target) return 0.0;
    // Always in one order, so that the distance is symmetric.
    const Corners& from = corners_[std::min(source, target)];
    const Corners& to = corners_[std::max(source, target)];
    if (from.sample == to.sample && from.sample[2] != no_index) {
      const auto [p, q] = std::pair(laid(from), laid(to));
      double over_corner = unreachable;
      for (int k = 0; k < 3; ++k) over_corner = std::min(over_corner, from.distance[k] + to.distance[k]);
      return std::min(std::hypot(p.x - q.x, p.y - q.y), over_corner);
    }
    std::array<double, 3> to_corner{};
    for (int k = 0; k < 3; ++k) {
      const auto own = std::ranges::find(from.sample, to.sample[k]);
      if (own != from.sample.end()) {
        to_corner[k] = from.distance[own - from.sample.begin()];
        continue;
      }
      std::array<double, 3> apart{};
      for (int i = 0; i < 3; ++i) apart[i] = between(from.sample[i], to.sample[k]);
      to_corner[k] = across(from, apart);
    }
    return across(to, to_corner);
  }

  std::vector<double> solve(std::span<const Index> sources, const Progress&) override {
    std::vector<double> distances(mesh().vertex_count(), unreachable);
    for (const Index v : checked(mesh().vertex_count())) {
      for (const Index source : sources) distances[v] = std::min(distances[v], solve_pair(source, v));
    }
    return distances;
  }

  /// Distance of two samples, from the rows of the lower triangle of the table.
  double between(Index first, Index second) const {
    if (first == no_index || second == no_index) return unreachable;
    const auto row = static_cast<std::size_t>(std::max(first, second));
    const auto column = static_cast<std::size_t>(std::min(first, second));
    return table_[row * (row + 1) / 2 + column];
  }

  /// Samples, each the vertex farthest from those before it, and an exact field from each.
  void take_samples(const std::shared_ptr<const Mesh>& mesh, std::vector<Nearest>& nearest,
                    const Progress& progress) {
    ExactSolver solver(mesh);
    std::vector<Index> samples;
    const auto farthest = [&] {
      std::pair<double, Index> best{0.0, no_index};
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        if (!mesh->corners(v).empty() && nearest[v].distance[0] > best.first) {
          best = {nearest[v].distance[0], v};
        }
      }
      return best;
    };
    for (auto [away, at] = farthest(); at != no_index; std::tie(away, at) = farthest()) {
      const auto number = static_cast<Index>(samples.size());
      if (number == most_ && away == unreachable) {
        throw InvalidInput("The method gtu takes a sample in every component, and there are more than " +
                           std::to_string(most_) + "; give a larger m.");
      }
      if (number == most_) return;
      const double share = 1.0 / most_;
      const Progress part = progress.part(share * number, share * (number + 1));
      ExactLimits limits;
      limits.distances_only = true;
      limits.progress = &part;
      solver.run_from_vertices({&at, 1}, limits);
      samples.push_back(at);
      for (const Index sample : samples) table_.push_back(solver.distance(sample));
      for (Index v = 0; v < mesh->vertex_count(); ++v) nearest[v].add(number, solver.distance(v));
    }
  }

  /// Finds the triangles between samples whose Voronoi regions meet in a face, and for each vertex the
  /// triangle that holds it, or comes closest to that; if there is none, its nearest samples.
  void find_triangles(const std::vector<Nearest>& nearest) {
    Index samples = 0;
    for (const Nearest& n : nearest) samples = std::max(samples, n.sample[0] + 1);
    std::vector<std::set<Triple>> at(samples);
    for (const auto& face : mesh().faces()) {
      Triple triple{nearest[face[0]].sample[0], nearest[face[1]].sample[0], nearest[face[2]].sample[0]};
      std::ranges::sort(triple);
      if (triple[0] == no_index || triple[0] == triple[1] || triple[1] == triple[2]) continue;
      for (const Index s : triple) at[s].insert(triple);
    }
    corners_.resize(nearest.size());
    for (std::size_t v = 0; v < nearest.size(); ++v) {
      Corners& best = corners_[v];
      for (int k = 0; k < 3; ++k) best = with(best, k, nearest[v].sample[k], nearest[v].distance[k]);
      double inside = -unreachable;
      for (const Index s : nearest[v].sample) {
        if (s == no_index) break;
        for (const Triple& triple : at[s]) {
          Corners candidate;
          for (int k = 0; k < 3; ++k) candidate = with(candidate, k, triple[k], nearest[v].of(triple[k]));
          const double depth = least_weight(candidate);
          if (depth > inside) {
            inside = depth;
            best = candidate;
          }
        }
      }
    }
  }

  static Corners with(Corners corners, int k, Index sample, double distance) {
    corners.sample[k] = sample;
    corners.distance[k] = distance;
    return corners;
  }

  /// The third corner of a triangle whose first one is at (0, 0) and whose second one lies on the x axis.
  UnfoldedPoint apex_of(const Triple& sample) const {
    const double length = between(sample[0], sample[1]);
    const double to_first = between(sample[0], sample[2]);
    const double to_second = between(sample[1], sample[2]);
    const double x = (to_first * to_first - to_second * to_second + length * length) / (2.0 * length);
    return {x, std::sqrt(std::max(0.0, to_first * to_first - x * x))};
  }

  /// The vertex in that plane, by differences of its squared distances; exact if the triangle is flat.
  UnfoldedPoint laid(const Corners& corners) const {
    const double length = between(corners.sample[0], corners.sample[1]);
    const UnfoldedPoint apex = apex_of(corners.sample);
    const auto square = [&](int k) { return corners.distance[k] * corners.distance[k]; };
    const double x = (square(0) - square(1) + length * length) / (2.0 * length);
    const double right = square(0) - square(2) + apex.x * apex.x + apex.y * apex.y - 2.0 * apex.x * x;
    return {x, right / (2.0 * apex.y)};
  }

  /// The least of a vertex's barycentric weights in a triangle, below 0 outside it.
  double least_weight(const Corners& corners) const {
    if (std::ranges::max(corners.distance) == unreachable) return -unreachable;
    const double length = between(corners.sample[0], corners.sample[1]);
    const UnfoldedPoint apex = apex_of(corners.sample);
    if (!(length > 0.0 && apex.y > 0.0)) return -unreachable;
    const UnfoldedPoint p = laid(corners);
    const double third = p.y / apex.y;
    const double second = (p.x - apex.x * third) / length;
    return std::min({third, second, 1.0 - third - second});
  }

  /// Distance of a vertex from a point outside its triangle, whose distances from the corners are `apart`:
  /// over an edge, with the triangle and the point laid into the plane on either side of it, or over a
  /// corner.
  double across(const Corners& from, const std::array<double, 3>& apart) const {
    double over_corner = unreachable;
    double straight = unreachable;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      over_corner = std::min(over_corner, from.distance[i] + apart[i]);
      const double length = between(from.sample[i], from.sample[j]);
      if (!(length > 0.0 && length < unreachable)) continue;
      straight = std::min(straight,
                          unfolded_distance(length, from.distance[i], from.distance[j], apart[i], apart[j]));
    }
    return std::min(straight, over_corner);
  }

  Index most_;
  std::vector<double> table_;
  std::vector<Corners> corners_;
};

}  // namespace

// As in the paper: m samples, the geodesic Delaunay triangulation of their Voronoi regions, distances of all
// pairs of samples and of each vertex from the corners of its triangle. A query lays the two triangles into
// the plane and measures there; here it unfolds one corner after the other, each over the edge that a
// straight line crosses.
MethodEntry gtu_entry() {
  return {
      {"gtu",
       "Geodesic triangle unfolding (GTU)",
       "S.-Q. Xin, X. Ying, Y. He: Constant-time all-pairs geodesic distance query on triangle meshes. I3D "
       "2012",
       {{"m", 100.0, 3.0, 10000.0, true, "samples, which the triangles have as corners"}},
       {"SSSD", "table of m^2 distances, 3 a vertex", "none; near points fail", "any with exact fields",
        "set-up m n^2 log n at most, pair constant"},
       false,
       true},
      prepared<GeodesicTriangles>};
}

}  // namespace vorogeo
