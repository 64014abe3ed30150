// Defects of hostile meshes that move vertices.
#include <algorithm>
#include <cmath>

#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

void add_outliers(HostileMesh& mesh, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  const double edges = random.power(1.0, 12.0);
  const double far = edges * typical_edge(mesh.soup);
  const std::size_t count = random.one_in(2) ? 1 : a_few(positions.size(), random);
  const bool level = random.one_in(2);
  for (std::size_t i = 0; i < count; ++i) {
    Point& p = positions[random.below(positions.size())];
    // Cells without data are all at one height.
    if (level) {
      p[2] = -far;
    } else {
      p = moved(p, random.direction(), far);
    }
  }
  mesh.defects.push_back(counted(count, "outlier") + " at " + short_number(edges) + " edges" +
                         (level ? " below" : ""));
}

void add_spikes(HostileMesh& mesh, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  const auto neighbours = neighbours_of(mesh.soup);
  const double edge = typical_edge(mesh.soup);
  const int count = random.between(1, 5);
  double longest = 0.0;
  for (int i = 0; i < count; ++i) {
    const auto tip = static_cast<Index>(random.below(positions.size()));
    const double edges = random.power(1.0, 4.0);
    const Point direction = random.direction();
    positions[tip] = moved(positions[tip], direction, edges * edge);
    for (Index v : neighbours[tip]) positions[v] = moved(positions[v], direction, 0.3 * edges * edge);
    longest = std::max(longest, edges);
  }
  mesh.defects.push_back(counted(count, "spike") + " up to " + short_number(longest) + " edges");
}

/// Twice the area of each face in the unrolled surface, with its sign.
std::vector<double> flat_areas(const HostileMesh& mesh) {
  std::vector<double> areas;
  for (const auto& [a, b, c] : mesh.soup.faces) {
    const auto &p = mesh.flat[a], &q = mesh.flat[b], &r = mesh.flat[c];
    areas.push_back((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
  return areas;
}

void shorten_edges(HostileMesh& mesh, double share, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  const auto edges = edge_sides(mesh.soup);
  const auto chosen = random_edges(edges, a_few(edges.size(), random), random);
  const bool in_plane =
      !mesh.flat.empty() && std::ranges::all_of(positions, [](const Point& p) { return p[2] == 0.0; });
  const auto before = in_plane ? flat_areas(mesh) : std::vector<double>{};
  for (const auto& [a, b] : chosen) {
    positions[b] = share == 0.0 ? positions[a] : mix(positions[a], positions[b], share);
  }
  if (in_plane) {
    // In the plane it still unrolls unless a face has turned over or an end on the outline has moved, which
    // cuts a corner off or leaves a hair.
    for (std::size_t v = 0; v < positions.size(); ++v) mesh.flat[v] = {positions[v][0], positions[v][1]};
    const auto after = flat_areas(mesh);
    bool unrolls = true;
    double lost = 0.0;
    double whole = 0.0;
    for (std::size_t f = 0; f < after.size(); ++f) {
      unrolls = unrolls && before[f] * after[f] >= 0.0;
      lost += std::abs(before[f]) - std::abs(after[f]);
      whole += std::abs(before[f]);
    }
    if (!unrolls || std::abs(lost) > 1e-12 * whole) mesh.flat.clear();
  } else {
    mesh.flat.clear();
  }
  mesh.defects.push_back(share == 0.0 ? counted(chosen.size(), "collapsed edge")
                                      : counted(chosen.size(), "edge") + " shrunk to " + short_number(share));
}

void squash(HostileMesh& mesh, HostileRandom& random) {
  const double share = random.power(-6.0, -1.0);
  const std::size_t axis = random.below(3);
  for (Point& p : mesh.soup.positions) p[axis] *= share;
  mesh.defects.push_back("axis " + std::to_string(axis) + " shrunk to " + short_number(share));
}

void grade(HostileMesh& mesh, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  const std::size_t axis = random.below(2);
  double low = positions[0][axis];
  double high = low;
  for (const Point& p : positions) {
    low = std::min(low, p[axis]);
    high = std::max(high, p[axis]);
  }
  const double orders = random.uniform(1.0, 6.0);
  for (Point& p : positions) {
    const double scale = high > low ? std::pow(10.0, -orders * (p[axis] - low) / (high - low)) : 1.0;
    for (double& x : p) x *= scale;
  }
  mesh.defects.push_back("edges graded by " + short_number(std::pow(10.0, orders)));
}

}  // namespace

void move_vertices(HostileMesh& mesh, HostileDefect defect, HostileRandom& random) {
  auto& positions = mesh.soup.positions;
  switch (defect) {
    case HostileDefect::outliers:
      add_outliers(mesh, random);
      break;
    case HostileDefect::spikes:
      add_spikes(mesh, random);
      break;
    case HostileDefect::collapsed_edges:
      return shorten_edges(mesh, 0.0, random);
    case HostileDefect::tiny_edges: {
      constexpr std::array shares{1e-3, 1e-9, 1e-15};
      return shorten_edges(mesh, shares[random.below(3)], random);
    }
    case HostileDefect::squashed:
      squash(mesh, random);
      break;
    case HostileDefect::noise: {
      const double edges = random.uniform(0.2, 2.0);
      const double edge = typical_edge(mesh.soup);
      for (Point& p : positions) p = moved(p, random.direction(), edges * edge);
      mesh.defects.push_back("noise of " + short_number(edges) + " edges");
      break;
    }
    case HostileDefect::snapped: {
      const double edges = random.uniform(0.3, 1.5);
      const double step = edges * typical_edge(mesh.soup);
      for (Point& p : positions) {
        for (double& x : p) x = std::round(x / step) * step;
      }
      mesh.defects.push_back("coordinates rounded to " + short_number(edges) + " edges");
      break;
    }
    case HostileDefect::graded:
      grade(mesh, random);
      break;
    case HostileDefect::rescaled: {
      const double scale = random.power(-20.0, 20.0);
      for (Point& p : positions) {
        for (double& x : p) x *= scale;
      }
      for (auto& p : mesh.flat) p = {p[0] * scale, p[1] * scale};
      mesh.defects.push_back("coordinates times " + short_number(scale));
      return;
    }
    default: {
      const double edges = random.power(3.0, 8.0);
      const Point direction = random.direction();
      const double far = edges * typical_edge(mesh.soup);
      for (Point& p : positions) p = moved(p, direction, far);
      mesh.defects.push_back("the origin " + short_number(edges) + " edges away");
    }
  }
  mesh.flat.clear();
}

}  // namespace vorogeo::test
