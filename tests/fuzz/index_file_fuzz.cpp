// Damaged index files: loading gives IndexFileError or an index that answers, never a crash.
#include <array>
#include <stdexcept>
#include <string>

#include "fuzz/fuzz.h"
#include "support/error.h"
#include "support/index_blocks.h"
#include "support/indexes.h"
#include "support/shapes.h"
#include "support/temporary.h"

namespace {

using namespace vorogeo;
using Random = std::mt19937;

std::size_t below(Random& random, std::size_t count) { return count == 0 ? 0 : random() % count; }

/// The file with bits flipped, bytes overwritten, cut off or with parts repeated: checksums do not fit.
std::string damaged(std::string bytes, Random& random) {
  switch (random() % 5) {
    case 0:
      bytes.resize(below(random, bytes.size()));
      break;
    case 1:
      for (std::size_t i = 1 + random() % 8; i > 0; --i)
        bytes[below(random, bytes.size())] ^= char(1 << random() % 8);
      break;
    case 2:
      for (std::size_t i = 1 + random() % 64; i > 0; --i) bytes[below(random, bytes.size())] = char(random());
      break;
    case 3: {
      const std::size_t at = below(random, bytes.size());
      bytes.insert(at, bytes.substr(below(random, bytes.size()), random() % 100));
      break;
    }
    default: {
      const auto boundaries = test::block_boundaries(bytes);
      const std::size_t at = boundaries[below(random, boundaries.size() - 1)];
      for (int i = 0; i < 4; ++i) bytes[at + random() % 24] = char(random());
    }
  }
  return bytes;
}

/// The file with elements of blocks changed, blocks cut, extended or swapped, with checksums that fit.
std::string contradicting(const std::string& bytes, Random& random) {
  auto blocks = test::index_blocks(bytes);
  for (std::size_t i = 1 + random() % 3; i > 0; --i) {
    // The first block, the fingerprint, stays: otherwise loading ends there and checks nothing else.
    auto& block = blocks[1 + below(random, blocks.size() - 1)];
    switch (random() % 8) {
      case 0:
        block.contents.resize(block.element_size * below(random, block.count() + 1));
        break;
      case 1:
        block.contents += block.contents.substr(0, block.element_size * below(random, block.count() + 1));
        break;
      case 2:
        std::swap(block, blocks[1 + below(random, blocks.size() - 1)]);
        break;
      default:
        if (block.count() == 0) break;
        for (std::size_t k = 1 + random() % 4; k > 0; --k) {
          // Small numbers are plausible ids, the others violate ranges and signs.
          const Index value = random() % 2 ? Index(random() % 16) : Index(random());
          block.set<Index>(below(random, block.contents.size() / sizeof(Index)), value);
        }
    }
  }
  return test::with_blocks(bytes, blocks);
}

/// An index and its file.
struct Sample {
  explicit Sample(const test::Soup& soup)
      : mesh(test::make_mesh(soup)), index(test::make_index(soup, 3, 3, 0.01)) {
    index->save(folder / "index");
    bytes = test::read_bytes(folder / "index");
  }
  test::TemporaryFolder folder;
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const GeodesicIndex> index;
  std::string bytes;
};

void attempt(const Sample& sample, Random& random) {
  const bool checksums_fit = random() % 2 == 0;
  const std::string changed =
      checksums_fit ? contradicting(sample.bytes, random) : damaged(sample.bytes, random);
  const auto file = sample.folder / "changed";
  test::write_bytes(file, changed);
  std::shared_ptr<const GeodesicIndex> loaded;
  try {
    loaded = GeodesicIndex::load(file, sample.mesh);
  } catch (const IndexFileError&) {
    return;
  }
  test::IndexQuery query(loaded, 1);
  test::IndexQuery original(sample.index, 1);
  const auto vertices = static_cast<unsigned>(sample.mesh->vertex_count());
  for (int i = 0; i < 4; ++i) {
    const auto a = static_cast<Index>(random() % vertices);
    const auto b = static_cast<Index>(random() % vertices);
    const double distance = query.distance(a, b);
    const auto field = query.distance_field(std::array{a, b});
    // A damaged file that loads all the same must hold the same index.
    if (checksums_fit) continue;
    if (distance != original.distance(a, b) || field != original.distance_field(std::array{a, b})) {
      throw std::runtime_error("a damaged file was loaded and answers differently");
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Sample sphere(test::icosphere(3));
  const Sample several(test::with_isolated_vertex(
      test::two_components(test::hills(12, 0.2), test::book_of_three_pages(4, 2.0, 1.0).soup), {9, 9, 9}));
  return test::fuzz(argc, argv, [&](Random& random) { attempt(random() % 2 ? sphere : several, random); });
}
