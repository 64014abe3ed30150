// The copy, with the vertices that it shares.
#include "support/small_copy.h"

#include <vector>

namespace vorogeo::test {

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
