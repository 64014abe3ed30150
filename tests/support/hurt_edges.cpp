// Random edges, apart from one another.
#include "support/hurt_edges.h"

#include <algorithm>
#include <map>
#include <random>

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

}  // namespace vorogeo::test
