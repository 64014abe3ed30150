// What several views of a document show: one list, its changes, and which meshes were edited since.
#include "edit/document_measurements.h"

#include <gtest/gtest.h>

#include <string>

namespace vorogeo::plugin {
namespace {

VcgMeshArrays triangle(double width) {
  VcgMeshArrays arrays;
  arrays.positions = {{0.0, 0.0, 0.0}, {width, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  arrays.faces = {{0, 1, 2}};
  return arrays;
}

Measurement on_layer(int layer) {
  Measurement measurement;
  measurement.layer = layer;
  measurement.length = 1.0;
  measurement.to = {1.0, 0.0, 0.0};
  measurement.method = "exact";
  return measurement;
}

TEST(DocumentMeasurements, AllWhoWatchAreToldOfEveryChange) {
  DocumentMeasurements shared;
  std::size_t first = 99;
  std::size_t second = 99;
  shared.watch(&first, [&] { first = shared.list().all().size(); });
  EXPECT_EQ(first, 0U);
  EXPECT_EQ(shared.add(on_layer(0), triangle(1.0)), 1);
  shared.watch(&second, [&] { second = shared.list().all().size(); });
  EXPECT_EQ(second, 1U);
  EXPECT_EQ(shared.add(on_layer(0), triangle(1.0)), 2);
  EXPECT_EQ(first, 2U);
  EXPECT_EQ(second, 2U);
  shared.unwatch(&first);
  shared.remove({1, 7});
  EXPECT_EQ(first, 2U);
  EXPECT_EQ(second, 1U);
}

TEST(DocumentMeasurements, OnlyMeasurementsOfTheEditedLayerSaySo) {
  DocumentMeasurements shared;
  shared.add(on_layer(0), triangle(1.0));
  shared.add(on_layer(3), triangle(1.0));
  int told = 0;
  shared.watch(&told, [&] { ++told; });
  auto method = [&](std::size_t i) { return Measurements::row(shared.list().all()[i]).back(); };
  shared.compare(3, triangle(1.0));
  shared.compare(5, triangle(2.0));
  EXPECT_EQ(told, 1);
  EXPECT_EQ(method(1), "exact");
  shared.compare(3, triangle(2.0));
  EXPECT_EQ(told, 2);
  EXPECT_EQ(method(0), "exact");
  EXPECT_EQ(method(1), "exact, before an edit");
}

}  // namespace
}  // namespace vorogeo::plugin
