// Meshes with what real ones have: several components, stray vertices, repeated, degenerate and flipped
// faces, edges without length, parts of very different sizes.
#include <algorithm>
#include <map>
#include <random>

#include "support/shapes.h"

namespace vorogeo::test {

namespace {

using Edge = std::array<Index, 2>;

/// All edges with the faces at them, in random order.
std::vector<std::pair<Edge, std::vector<Index>>> shuffled_edges(const Soup& soup, std::mt19937& random) {
  std::map<Edge, std::vector<Index>> faces_at;
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const Index a = soup.faces[f][i];
      const Index b = soup.faces[f][(i + 1) % 3];
      faces_at[{std::min(a, b), std::max(a, b)}].push_back(static_cast<Index>(f));
    }
  }
  std::vector<std::pair<Edge, std::vector<Index>>> edges(faces_at.begin(), faces_at.end());
  std::ranges::shuffle(edges, random);
  return edges;
}

}  // namespace

Soup two_components(const Soup& first, const Soup& second) {
  Soup result = first;
  const auto offset = static_cast<Index>(first.positions.size());
  result.positions.insert(result.positions.end(), second.positions.begin(), second.positions.end());
  for (auto face : second.faces) {
    for (Index& v : face) v += offset;
    result.faces.push_back(face);
  }
  return result;
}

Soup with_isolated_vertex(const Soup& soup, const Point& position) {
  Soup result = soup;
  result.positions.push_back(position);
  return result;
}

Soup with_duplicate_face(const Soup& soup, Index face) {
  Soup result = soup;
  const auto [a, b, c] = soup.faces[face];
  result.faces.push_back({b, a, c});
  return result;
}

Soup with_repeated_vertex_face(const Soup& soup, Index face) {
  Soup result = soup;
  const auto [a, b, c] = soup.faces[face];
  result.faces.push_back({a, b, a});
  return result;
}

Soup with_flipped_faces(const Soup& soup, unsigned seed) {
  Soup result = soup;
  std::mt19937 random(seed);
  for (auto& face : result.faces) {
    if (random() % 2 == 0) std::swap(face[1], face[2]);
  }
  return result;
}

Soup with_zero_area_cap(const Soup& soup, Index face, int corner) {
  Soup result = soup;
  const Index a = soup.faces[face][corner];
  const Index b = soup.faces[face][(corner + 1) % 3];
  const Index c = soup.faces[face][(corner + 2) % 3];
  const auto middle = static_cast<Index>(soup.positions.size());
  Point position{};
  for (int k = 0; k < 3; ++k) position[k] = 0.5 * (soup.positions[a][k] + soup.positions[b][k]);
  result.positions.push_back(position);
  result.faces[face] = {a, middle, c};
  result.faces.push_back({middle, b, c});
  result.faces.push_back({a, b, middle});
  return result;
}

Soup with_scaled_edges(const Soup& soup, double part, double factor, unsigned seed) {
  std::mt19937 random(seed);
  Soup result = soup;
  const auto edges = shuffled_edges(soup, random);
  auto wanted = static_cast<std::size_t>(part * static_cast<double>(edges.size()) + 0.5);
  std::vector<bool> moved(soup.positions.size(), false);
  for (const auto& [edge, faces] : edges) {
    if (wanted == 0) break;
    const auto [a, b] = edge;
    if (moved[a] || moved[b]) continue;
    moved[a] = moved[b] = true;
    --wanted;
    for (int k = 0; k < 3; ++k) {
      const double from = soup.positions[a][k];
      result.positions[b][k] = from + factor * (soup.positions[b][k] - from);
    }
  }
  return result;
}

Soup with_slit_edges(const Soup& soup, double part, unsigned seed) {
  std::mt19937 random(seed);
  Soup result = soup;
  const auto edges = shuffled_edges(soup, random);
  auto wanted = static_cast<std::size_t>(part * static_cast<double>(edges.size()) + 0.5);
  std::vector<bool> cut(soup.faces.size(), false);
  for (const auto& [edge, faces] : edges) {
    if (wanted == 0) break;
    if (faces.size() != 2 || cut[faces[0]] || cut[faces[1]]) continue;
    --wanted;
    const auto [a, b] = edge;
    Point middle{};
    for (int k = 0; k < 3; ++k) middle[k] = 0.5 * (soup.positions[a][k] + soup.positions[b][k]);
    for (const Index f : faces) {
      cut[f] = true;
      const auto own = static_cast<Index>(result.positions.size());
      result.positions.push_back(middle);
      auto second = result.faces[f];
      std::ranges::replace(result.faces[f], a, own);
      std::ranges::replace(second, b, own);
      result.faces.push_back(second);
    }
  }
  return result;
}

Soup with_small_copy(const Soup& soup, double ratio) {
  Soup result = soup;
  std::vector<Index> name;
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    if (v % 110 == 50) {
      name.push_back(static_cast<Index>(v));
      continue;
    }
    name.push_back(static_cast<Index>(result.positions.size()));
    Point small = soup.positions[v];
    for (double& coordinate : small) coordinate *= ratio;
    small[2] += 0.5;
    result.positions.push_back(small);
  }
  for (const auto& [a, b, c] : soup.faces) result.faces.push_back({name[a], name[b], name[c]});
  return result;
}

}  // namespace vorogeo::test
