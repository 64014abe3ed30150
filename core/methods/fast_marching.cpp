// Fast marching on triangles: a plane wave through each triangle, in order of arrival.
#include "methods/fast_marching.h"

#include <cmath>
#include <queue>
#include <utility>

#include "methods/method_table.h"
#include "support/checkpoint.h"

namespace vorogeo {

namespace {

/// Arrival at the corner of a plane wave of speed 1 with the values `low` <= `high` at the other two
/// vertices, which lie `to_low` and `to_high` away (Kimmel, Sethian 1998, section 4). A wave that does not
/// come through the triangle, or none, comes along an edge.
double arrival(double low, double high, double to_low, double to_high, double cosine) {
  const double along_edges = std::fmin(low + to_low, high + to_high);
  if (!(cosine > -1.0 && cosine < 1.0)) return along_edges;
  const double rise = high - low;
  // |gradient| = 1 of the linear function over the triangle, as an equation for t = arrival - low.
  const double a = to_high * to_high + to_low * to_low - 2.0 * to_high * to_low * cosine;
  const double b = 2.0 * to_low * rise * (to_high * cosine - to_low);
  const double c = to_low * to_low * (rise * rise - to_high * to_high * (1.0 - cosine * cosine));
  const double discriminant = b * b - 4.0 * a * c;
  if (!(a > 0.0 && discriminant >= 0.0)) return along_edges;
  const double t = (-b + std::sqrt(discriminant)) / (2.0 * a);
  if (!(t > rise)) return along_edges;
  // The path back along the gradient has to leave between the two vertices.
  const double foot = to_low * (t - rise) / t;
  if (!(foot > to_high * cosine && foot * cosine < to_high)) return along_edges;
  return std::fmin(low + t, along_edges);
}

/// The value that a triangle gives its corner, by the accepted ones of its other vertices.
double through(const MarchingTriangle& t, const std::vector<double>& value,
               const std::vector<std::uint8_t>& accepted) {
  if (accepted[t.first] == 0) return value[t.second] + t.to_second;
  if (accepted[t.second] == 0) return value[t.first] + t.to_first;
  if (value[t.first] <= value[t.second]) {
    return arrival(value[t.first], value[t.second], t.to_first, t.to_second, t.cosine);
  }
  return arrival(value[t.second], value[t.first], t.to_second, t.to_first, t.cosine);
}

}  // namespace

FastMarching::FastMarching(const std::shared_ptr<const Mesh>& mesh)
    : vertices_(mesh->vertex_count()), triangles_(marching_triangles(*mesh)) {
  // The triangles in which a vertex is one of those with a value.
  begin_.assign(static_cast<std::size_t>(vertices_) + 1, 0);
  for (const auto& t : triangles_) {
    ++begin_[t.first + 1];
    ++begin_[t.second + 1];
  }
  for (Index v = 0; v < vertices_; ++v) begin_[v + 1] += begin_[v];
  seen_from_.resize(begin_.back());
  std::vector<std::size_t> place(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    seen_from_[place[triangles_[i].first]++] = i;
    seen_from_[place[triangles_[i].second]++] = i;
  }
}

std::vector<double> FastMarching::field(std::span<const Index> sources, const Progress& progress) {
  const Watch watch(progress, "Fast marching");
  std::vector<double> value(vertices_, unreachable);
  std::vector<std::uint8_t> accepted(vertices_, 0);
  using Item = std::pair<double, Index>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  for (Index source : sources) {
    value[source] = 0.0;
    queue.push({0.0, source});
  }
  Index taken = 0;
  while (!queue.empty()) {
    const Index vertex = queue.top().second;
    queue.pop();
    if (accepted[vertex] != 0) continue;
    accepted[vertex] = 1;
    if (++taken % elements_per_checkpoint == 0) checkpoint();
    for (std::size_t i = begin_[vertex]; i < begin_[vertex + 1]; ++i) {
      const MarchingTriangle& t = triangles_[seen_from_[i]];
      if (accepted[t.vertex] != 0) continue;
      const double found = through(t, value, accepted);
      if (found < value[t.vertex]) {
        value[t.vertex] = found;
        queue.push({found, t.vertex});
      }
    }
  }
  return value;
}

std::size_t FastMarching::bytes() const {
  return bytes_of(triangles_) + bytes_of(begin_) + bytes_of(seen_from_) +
         static_cast<std::size_t>(vertices_) * (sizeof(double) + 1);
}

MethodEntry fast_marching_entry() {
  return {{"fast_marching",
           "Fast marching, obtuse triangles unfolded",
           "R. Kimmel, J. A. Sethian: Computing geodesic paths on manifolds. PNAS 95, 1998",
           {},
           {"MSAD", "adjacency", "first order in the edge length", "speeds on vertices", "field n log n"},
           false,
           false},
          [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress&) {
            return std::make_unique<FastMarching>(mesh);
          },
          {}};
}

}  // namespace vorogeo
