// The plugin's cache of layers: found by all that distances depend on; bounded in number and in memory.
#include <gtest/gtest.h>

#include <vector>

#include "layers/layer_surface.h"
#include "support/gaps.h"
#include "support/indexes.h"
#include "support/plain_mesh.h"
#include "support/shapes.h"

namespace vorogeo::plugin {
namespace {

/// A layer of a host.
using Layer = test::PlainMesh<double>;

/// A sphere that differs from others in position only, so that all take the same memory.
test::Soup sphere(int number) {
  test::Soup soup = test::icosphere(1);
  for (Point& p : soup.positions) p[0] += number;
  return soup;
}

std::shared_ptr<LayerSurface> read(const Layer& layer, const LayerMeasure& measure = {}) {
  const auto place = [&](const Point& at) { return measure.placement.to_scene(at); };
  auto surface = std::make_shared<LayerSurface>(arrays_from_vcg(layer, place), measure);
  surface->surface();
  return surface;
}

std::shared_ptr<LayerSurface> read_with_index(const Layer& layer) {
  auto surface = read(layer);
  IndexOptions options;
  options.first_layer_patches = 2;
  surface->use(GeodesicIndex::build(surface->mesh(), options));
  return surface;
}

/// Layers, of which `cache` is given surfaces in their order.
struct Layers {
  std::vector<Layer> all;
  std::vector<std::shared_ptr<LayerSurface>> surfaces;

  Layers(LayerCache& cache, int count, int with_index) {
    for (int i = 0; i < count; ++i) all.emplace_back(sphere(i));
    for (int i = 0; i < count; ++i) {
      surfaces.push_back(i < with_index ? read_with_index(all[i]) : read(all[i]));
      cache.put(surfaces.back());
    }
  }
  /// Which surfaces the cache still has, looked up in their order.
  std::vector<bool> kept(LayerCache& cache) const {
    std::vector<bool> found;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto surface = cache.find(all[i], {});
      EXPECT_TRUE(!surface || surface == surfaces[i]);
      found.push_back(surface != nullptr);
    }
    return found;
  }
};

TEST(LayerCache, KeepsTheFourWithoutAnIndexUsedLast) {
  LayerCache cache;
  Layers layers(cache, 4, 0);
  EXPECT_TRUE(cache.find(layers.all[0], {}));  // now 1 is the one used longest ago
  const Layer another(sphere(4));
  cache.put(read(another));
  EXPECT_TRUE(cache.find(another, {}));
  EXPECT_EQ(layers.kept(cache), (std::vector<bool>{true, false, true, true}));
}

TEST(LayerCache, SurfacesWithoutAnIndexDisplaceNoneThatHasOne) {
  LayerCache cache;
  const Layers layers(cache, 12, 5);
  EXPECT_EQ(layers.kept(cache), (std::vector<bool>{false, true, true, true, true,  // with an index
                                                   false, false, false, true, true, true, true}));
}

TEST(LayerCache, DropsTheOldestWhileTheyTakeTooMuchMemory) {
  const std::int64_t size = read(Layer(sphere(0)))->memory_bytes();
  ASSERT_GT(size, 0);
  LayerCache cache(2 * size + size / 2);
  EXPECT_EQ(Layers(cache, 4, 0).kept(cache), (std::vector<bool>{false, false, true, true}));
  const std::int64_t with_index = read_with_index(Layer(sphere(0)))->memory_bytes();
  EXPECT_GT(with_index, size);
  LayerCache mixed(with_index + size + size / 2);
  EXPECT_EQ(Layers(mixed, 4, 1).kept(mixed), (std::vector<bool>{true, false, false, true}));
}

TEST(LayerCache, KeepsTheNewestHoweverLarge) {
  LayerCache cache(1);
  EXPECT_EQ(Layers(cache, 3, 0).kept(cache), (std::vector<bool>{false, false, true}));
  LayerCache of_indexes(1);
  EXPECT_EQ(Layers(of_indexes, 3, 3).kept(of_indexes), (std::vector<bool>{false, false, true}));
}

TEST(LayerCache, AnEditedLayerHasNoneUntilTheEditIsUndone) {
  LayerCache cache;
  Layer layer(sphere(0));
  const auto surface = read(layer);
  cache.put(surface);
  layer.vert[3].position[2] += 1e-9;
  EXPECT_EQ(cache.find(layer, {}), nullptr);
  layer.vert[3].position[2] = surface->arrays().positions[3][2];
  EXPECT_EQ(cache.find(layer, {}), surface);
  const auto last = layer.face.back();
  layer.face.pop_back();
  EXPECT_EQ(cache.find(layer, {}), nullptr);
  layer.face.push_back(last);
  EXPECT_EQ(cache.find(layer, {}), surface);
}

TEST(LayerCache, MetricsCostsGapsAndMatricesAreNotMixedUp) {
  const Layer layer(sphere(0));
  std::vector<LayerMeasure> measures(8);
  measures[1].metric = LayerMetric::slope;
  measures[1].weight = 1.0;
  measures[2].metric = LayerMetric::curvature;
  measures[2].weight = 1.0;
  measures[3].metric = LayerMetric::vertex_quality;
  measures[3].cost.assign(layer.vert.size(), 2.0);
  measures[4].gap = {0.01, false};
  measures[5].gap = {0.01, true};
  measures[6].placement = Placement({{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 1}}}, "the layer");
  measures[7].placement =
      Placement({{{1, 0, 0, 1e-9}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}, "the layer");
  for (const LayerMeasure& one : measures) {
    LayerCache cache;
    const auto surface = read(layer, one);
    cache.put(surface);
    for (const LayerMeasure& other : measures) EXPECT_EQ(cache.find(layer, other) == surface, &one == &other);
    LayerMeasure changed = one;
    changed.weight += 1e-9;
    EXPECT_EQ(cache.find(layer, changed), nullptr);
    changed = one;
    changed.cost.push_back(2.0);
    EXPECT_EQ(cache.find(layer, changed), nullptr);
  }
}

TEST(LayerCache, FreesSurfacesWithTheLastDocumentThatUsedThem) {
  const int first = 0;
  const int second = 0;
  LayerCache cache;
  const Layer layer(sphere(0));
  cache.put(read(layer), &first);
  EXPECT_TRUE(cache.find(layer, {}, &second));
  cache.forget(&first);
  EXPECT_TRUE(cache.find(layer, {}, &second));
  cache.forget(&second);
  EXPECT_FALSE(cache.find(layer, {}));
}

TEST(LayerCache, AnswersAreTheSameAfterAnotherLayerWasUsed) {
  LayerCache cache;
  const Layers layers(cache, 2, 0);
  const std::vector<ExactSource> sources{{SurfacePoint::at_vertex(0)}};
  const auto ask = [&](int i) {
    Answered answered;
    const auto surface = cache.find(layers.all[i], {})->surface();
    return std::pair(surface->geometry(),
                     surface->field(sources, unreachable, Answer::exact, answered).distance);
  };
  const auto [geometry, distances] = ask(0);
  ask(1);
  EXPECT_EQ(ask(0), std::pair(geometry, distances));
}

TEST(LayerSurface, AnIndexTakesThePlaceOfAnother) {
  const Layer layer(sphere(0));
  const auto surface = read_with_index(layer);
  const auto first = surface->index();
  const auto mesh = surface->mesh();
  surface->use(GeodesicIndex::build(mesh));
  EXPECT_NE(surface->index(), first);
  EXPECT_EQ(surface->mesh(), mesh);
  surface->rest();
  EXPECT_TRUE(surface->index());
}

TEST(LayerSurface, RemembersWhatExactAnswersTookWhateverIsFreed) {
  const auto surface = read(Layer(sphere(0)));
  const std::vector<ExactSource> sources{{SurfacePoint::at_vertex(0)}};
  Answered answered;
  surface->surface()->field(sources, unreachable, Answer::exact, answered);
  const double rent = surface->surface()->spent().rent();
  EXPECT_GT(rent, 0.0);
  surface->rest();
  EXPECT_EQ(surface->surface()->spent().rent(), rent);
}

TEST(LayerSurface, WarnsOfDefectsWithEveryGapOfItsOwn) {
  const Layer plates(test::two_plates(4, 5, 0.01).soup);
  LayerMeasure bridged;
  bridged.gap = {0.02};
  const auto apart = read(plates);
  const auto joined = read(plates, bridged);
  EXPECT_FALSE(apart->warnings().empty());
  EXPECT_NE(apart->warnings(), joined->warnings());
  EXPECT_EQ(apart->mesh()->component_count(), 2);
  EXPECT_EQ(joined->mesh()->component_count(), 1);
}

}  // namespace
}  // namespace vorogeo::plugin
