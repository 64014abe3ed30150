// Indexes, error statistics and reference searches for the tests of the index and the queries.
#include "support/indexes.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>
#include <numeric>
#include <tuple>

#include "support/error.h"

namespace vorogeo::test {

namespace {

/// An index that was built in this process, and what it was made of.
struct Made {
  Soup soup;
  IndexOptions options;
  std::shared_ptr<const GeodesicIndex> index;

  bool is_of(const Soup& other, const IndexOptions& with) const {
    auto choices = [](const IndexOptions& of) {
      return std::tuple(of.first_layer_patches, of.second_layer_patches, of.delta, of.threads);
    };
    return choices(options) == choices(with) && soup.faces == other.faces &&
           soup.positions == other.positions;
  }
};

}  // namespace

std::shared_ptr<const GeodesicIndex> make_index(const Soup& soup, Index first_layer_patches,
                                                Index second_layer_patches, double delta, int threads) {
  constexpr std::size_t kept = 48;
  // The newest first: tests of one question ask for the same indexes, and from one thread at a time.
  static std::deque<Made> made;
  IndexOptions options;
  options.first_layer_patches = first_layer_patches;
  options.second_layer_patches = second_layer_patches;
  options.delta = delta;
  options.threads = threads;
  const auto before = std::ranges::find_if(made, [&](const Made& one) { return one.is_of(soup, options); });
  if (before != made.end()) return before->index;
  made.push_front({soup, options, GeodesicIndex::build(make_mesh(soup), options)});
  if (made.size() > kept) made.pop_back();
  return made.front().index;
}

std::string loading(const std::filesystem::path& file, const std::shared_ptr<const Mesh>& mesh) {
  try {
    GeodesicIndex::load(file, mesh);
  } catch (const IndexFileError& error) {
    return error.what();
  }
  return "loaded";
}

Soup book_of_pages(int pages) {
  Soup book;
  book.positions = {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}};
  for (int i = 0; i < pages; ++i) {
    const double angle = 6.0 * i / pages;
    book.positions.push_back({std::cos(angle), std::sin(angle), 0.5});
    book.faces.push_back({0, 1, i + 2});
  }
  return book;
}

Soup needle_disc(int needles) {
  Soup soup;
  soup.positions.push_back({0.0, 0.0, 0.0});
  for (Index i = 0; i < needles; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / needles;
    soup.positions.push_back({std::cos(angle), std::sin(angle), 0.0});
    soup.faces.push_back({0, 1 + i, 1 + (i + 1) % needles});
  }
  return soup;
}

Soup hills(int cells, double height) {
  Soup soup = plane_grid(cells, cells, 1.0, 1.0, 0.2, 5).soup;
  for (Point& p : soup.positions) p[2] = height * std::sin(9.0 * p[0]) * std::cos(7.0 * p[1] + p[0]);
  return soup;
}

void ErrorCollector::add(double actual, double exact) {
  if ((actual == unreachable) != (exact == unreachable)) ++contradictions;
  if (exact == unreachable || !(exact > 0.0)) return;
  errors_.push_back(actual / exact - 1.0);
}

ErrorStatistics ErrorCollector::statistics() const {
  ErrorStatistics result;
  result.count = errors_.size();
  if (errors_.empty()) return result;
  std::vector<double> sizes;
  for (double error : errors_) {
    sizes.push_back(std::abs(error));
    result.mean += std::abs(error);
    result.greatest = std::max(result.greatest, error);
    result.least = std::min(result.least, error);
  }
  result.mean /= static_cast<double>(errors_.size());
  const auto at = sizes.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  result.p99 = *at;
  return result;
}

std::vector<Index> random_vertices(Index count, int wanted, unsigned seed) {
  std::mt19937 random(seed);
  std::set<Index> chosen;
  while (static_cast<int>(chosen.size()) < std::min<int>(wanted, count)) {
    chosen.insert(static_cast<Index>(random() % static_cast<unsigned>(count)));
  }
  std::vector<Index> result(chosen.begin(), chosen.end());
  std::shuffle(result.begin(), result.end(), random);
  return result;
}

std::vector<Index> all_faces(const Mesh& mesh) {
  std::vector<Index> faces(mesh.face_count());
  std::iota(faces.begin(), faces.end(), 0);
  return faces;
}

std::set<Index> patches_at(const Mesh& mesh, std::span<const Index> face_label, Index vertex) {
  std::set<Index> patches;
  for (Index corner : mesh.corners(vertex)) patches.insert(face_label[Mesh::face_of(corner)]);
  return patches;
}

std::vector<std::vector<double>> graph_distances(const TransitGraph& graph) {
  const auto nodes = static_cast<Index>(graph.arc_begin.size()) - 1;
  std::vector<std::vector<double>> all;
  for (Index start = 0; start < nodes; ++start) {
    std::vector<double>& distance = all.emplace_back(nodes, unreachable);
    std::set<std::pair<double, Index>> queue{{0.0, start}};
    distance[start] = 0.0;
    while (!queue.empty()) {
      const auto [value, node] = *queue.begin();
      queue.erase(queue.begin());
      for (const Arc& arc : graph.arcs(node)) {
        if (value + arc.length >= distance[arc.target]) continue;
        queue.erase({distance[arc.target], arc.target});
        distance[arc.target] = value + arc.length;
        queue.insert({distance[arc.target], arc.target});
      }
    }
  }
  return all;
}

}  // namespace vorogeo::test
