// Meshes with what real ones have: several components, stray vertices, repeated, degenerate and flipped
// faces.
#include <random>

#include "support/shapes.h"

namespace vorogeo::test {

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

}  // namespace vorogeo::test
