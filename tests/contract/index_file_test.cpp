// Index files: a loaded index answers like the saved one, to the last bit; any other file is refused.
#include <gtest/gtest.h>

#include <random>

#include "contract/surfaces.h"
#include "support/temporary.h"

namespace vorogeo::contract {
namespace {

constexpr Build several_patches{.patches = 3, .patches_in_each = 3};

/// The sentence with which a file is refused; empty if it is loaded.
std::string loading(const std::filesystem::path& file, const Input& input) {
  return refusal([&] { Ask::loaded(file, input); });
}

void expect_same_answers(const Ask& built, const Ask& loaded, const std::string& name) {
  const auto points = test::spread_points(built.soup());
  const std::vector<Source> sources{{points[1]}, {points[5], 0.1}};
  EXPECT_EQ(loaded.field(sources, By::index).distance, built.field(sources, By::index).distance) << name;
  EXPECT_EQ(loaded.field(sources, By::index).source, built.field(sources, By::index).source) << name;
  EXPECT_EQ(loaded.matrix(points, By::index), built.matrix(points, By::index)) << name;
  for (const SurfacePoint& point : points) {
    EXPECT_EQ(loaded.distance(points[2], point, By::index), built.distance(points[2], point, By::index))
        << name;
    EXPECT_EQ(loaded.path(points[2], point, By::index).length(),
              built.path(points[2], point, By::index).length())
        << name;
  }
}

TEST(IndexFileContract, ALoadedIndexAnswersToTheLastBitLikeTheBuiltOneInEveryMetric) {
  const test::TemporaryFolder folder;
  for (const Case& one : cases_in_turn()) {
    one.ask.save(folder / "index.vgi");
    expect_same_answers(one.ask, Ask::loaded(folder / "index.vgi", one.ask.input()), one.name);
  }
}

TEST(IndexFileContract, SoDoesOneInTheSmallForm) {
  const test::TemporaryFolder folder;
  for (const double delta : {0.0, 0.01}) {
    const Ask built(test::hills(24, 0.2),
                    {.patches = 3, .patches_in_each = 3, .small = true, .delta = delta});
    built.save(folder / "small.vgi");
    expect_same_answers(built, Ask::loaded(folder / "small.vgi", built.input()), "small");
  }
}

/// A surface in each kind of metric, whose values differ from place to place.
std::vector<Input> inputs_in_every_metric(const test::Soup& soup) {
  auto spread = [](std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(1.0 + 0.01 * static_cast<double>(i * 37 % 100));
    return values;
  };
  auto tensors = [&](std::size_t count) {
    std::vector<Tensor> result;
    for (const double x : spread(count)) result.push_back({x, 0, 0, 0, 1, 0, 0, 0, 1});
    return result;
  };
  const std::size_t vertices = soup.positions.size();
  const std::size_t faces = soup.faces.size();
  return {Input{soup},
          Input{soup, EdgeLengths{sides_of(soup, 2.0)}},
          Input{soup, VertexCost{spread(vertices)}},
          Input{soup, VertexTensor{tensors(vertices)}},
          Input{soup, FaceCost{spread(faces)}},
          Input{soup, FaceTensor{tensors(faces)}}};
}

TEST(IndexFileContract, TheFileDependsOnNeitherTheNumberOfThreadsNorTheSavingInAnyMetric) {
  const test::TemporaryFolder folder;
  for (const Input& input : inputs_in_every_metric(test::hills(18, 0.2))) {
    for (const bool small : {false, true}) {
      SCOPED_TRACE("metric " + std::to_string(input.metric.index()) + (small ? ", small" : ""));
      Build build{.patches = 3, .patches_in_each = 3, .threads = 1, .small = small};
      Ask(input, build).save(folder / "one.vgi");
      for (const int threads : {2, 3, 8}) {
        build.threads = threads;
        Ask(input, build).save(folder / "several.vgi");
        EXPECT_EQ(test::read_bytes(folder / "several.vgi"), test::read_bytes(folder / "one.vgi")) << threads;
      }
      Ask::loaded(folder / "one.vgi", input).save(folder / "again.vgi");
      EXPECT_EQ(test::read_bytes(folder / "again.vgi"), test::read_bytes(folder / "one.vgi"));
    }
  }
  EXPECT_EQ(folder.files(), (std::set<std::string>{"again.vgi", "one.vgi", "several.vgi"}));
}

TEST(IndexFileContract, AnotherMeshOrMetricIsRefused) {
  const test::TemporaryFolder folder;
  const test::Soup soup = test::hills(12, 0.2);
  const auto faces = soup.faces.size();
  Ask(soup, several_patches).save(folder / "index.vgi");
  test::Soup moved = soup;
  moved.positions[20][2] += 1e-9;
  test::Soup turned = soup;
  std::swap(turned.faces[3][0], turned.faces[3][1]);
  test::Soup shorter = soup;
  shorter.faces.pop_back();
  EXPECT_EQ(loading(folder / "index.vgi", {soup}), "");
  for (const Input& other :
       {Input{moved}, Input{turned}, Input{shorter}, Input{test::with_isolated_vertex(soup, {0, 0, 9})},
        Input{soup, EdgeLengths{sides_of(soup, 2.0)}},
        Input{soup, FaceCost{std::vector<double>(faces, 1.0)}}}) {
    EXPECT_NE(loading(folder / "index.vgi", other).find("another mesh"), std::string::npos)
        << loading(folder / "index.vgi", other);
  }
}

TEST(IndexFileContract, ATruncatedFileIsRefusedWhereverItEnds) {
  const test::TemporaryFolder folder;
  const Input input{test::hills(10, 0.2)};
  Ask(input, several_patches).save(folder / "index.vgi");
  const std::string bytes = test::read_bytes(folder / "index.vgi");
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 60) {
    test::write_bytes(folder / "cut.vgi", bytes.substr(0, size));
    EXPECT_NE(loading(folder / "cut.vgi", input), "") << size << " of " << bytes.size() << " bytes";
  }
  test::write_bytes(folder / "cut.vgi", bytes + "x");
  EXPECT_NE(loading(folder / "cut.vgi", input), "");
}

TEST(IndexFileContract, ADamagedFileIsRefusedOrAnswersTheSame) {
  const unsigned seed = fresh_seed();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const test::TemporaryFolder folder;
  const Input input{test::hills(10, 0.2)};
  const Ask built(input, several_patches);
  built.save(folder / "index.vgi");
  const std::string bytes = test::read_bytes(folder / "index.vgi");
  for (int round = 0; round < 60; ++round) {
    std::string damaged = bytes;
    const std::size_t at = random() % bytes.size();
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
    test::write_bytes(folder / "damaged.vgi", damaged);
    // Damage in some bytes between blocks has no effect.
    if (loading(folder / "damaged.vgi", input).empty()) {
      expect_same_answers(built, Ask::loaded(folder / "damaged.vgi", input), "byte " + std::to_string(at));
    }
  }
}

TEST(IndexFileContract, RefusalsNameTheFile) {
  const test::TemporaryFolder folder;
  const Input input{test::icosphere(1)};
  test::write_bytes(folder / "text.vgi", "no index at all, but long enough for the head of one");
  for (const auto& file : {folder / "missing.vgi", folder / "text.vgi", folder / ""}) {
    EXPECT_NE(loading(file, input).find(file.string()), std::string::npos) << loading(file, input);
  }
  const Ask ask(input);
  EXPECT_NE(refusal([&] { ask.save(folder / "no folder" / "index.vgi"); }).find("no folder"),
            std::string::npos);
}

}  // namespace
}  // namespace vorogeo::contract
