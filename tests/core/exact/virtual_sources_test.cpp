// Virtual sources: exact on a plane up to bends, good on curved surfaces, with sources of every kind.
#include "exact/virtual_sources.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/gaps.h"
#include "support/error.h"
#include "support/gaps.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

test::ErrorStatistics errors_of(VirtualSources& runs, const std::vector<ExactSource>& sources) {
  runs.run(sources);
  ExactSolver exact(std::make_shared<const Mesh>(runs.mesh()));
  exact.run(sources, {});
  test::ErrorCollector collector;
  for (Index v = 0; v < runs.mesh().vertex_count(); ++v) collector.add(runs.distance(v), exact.distance(v));
  EXPECT_EQ(collector.contradictions, 0U);
  return collector.statistics();
}

TEST(VirtualSources, AreExactOnAPlane) {
  // Seen past a vertex without angle defect, a source is where it is.
  const test::Shape shape = test::plane_grid(20, 16, 1.0, 0.8, 0.2, 3);
  VirtualSources runs(test::make_mesh(shape.soup));
  const ExactSource source{SurfacePoint::at_vertex(175)};
  runs.run({&source, 1});
  int exact = 0;
  for (Index v = 0; v < runs.mesh().vertex_count(); ++v) {
    const double straight = shape.vertex_distance(175, v);
    EXPECT_GE(runs.distance(v), straight - 1e-12);
    EXPECT_LE(runs.distance(v), 1.01 * straight);
    exact += runs.distance(v) <= straight * (1.0 + 1e-12) ? 1 : 0;
  }
  EXPECT_GT(exact, 250);  // of 357
}

TEST(VirtualSources, GoRoundTheEndsOfASlit) {
  VirtualSources runs(test::make_mesh(test::plane_with_slit(8).soup));
  EXPECT_LT(errors_of(runs, {{SurfacePoint::at_vertex(3)}}).mean, 0.003);
}

TEST(VirtualSources, AreWithinThreeTenthsOfAPercentOnSmoothSurfaces) {
  VirtualSources sphere(test::make_mesh(test::icosphere(5)));
  EXPECT_LT(errors_of(sphere, {{SurfacePoint::at_vertex(7)}}).mean, 0.003);
  VirtualSources hills(test::make_mesh(test::hills(40, 0.4)));
  EXPECT_LT(errors_of(hills, {{SurfacePoint::at_vertex(7)}}).mean, 0.005);
}

TEST(VirtualSources, StartAnywhereWithOffsetsAndSayWhichIsNearest) {
  const test::Shape shape = test::plane_grid(12, 12, 1.0, 1.0);
  const auto mesh = test::make_mesh(shape.soup);
  VirtualSources runs(mesh);
  const std::vector<ExactSource> sources{{SurfacePoint::in_face(20, {0.2, 0.3, 0.5}), 0.1},
                                         {SurfacePoint::in_face(200, {0.0, 0.4, 0.6}), 0.0},
                                         {SurfacePoint::at_vertex(90), 0.05}};
  runs.run(sources);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    double least = unreachable;
    double of_label = 0.0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const double sum = sources[i].offset + shape.distance(sources[i].point, SurfacePoint::at_vertex(v));
      least = std::min(least, sum);
      if (static_cast<Index>(i) == runs.nearest_source(v)) of_label = sum;
    }
    EXPECT_NEAR(runs.distance(v), least, 0.01 * least + 1e-12);
    EXPECT_NEAR(of_label, least, 0.02 * least);
  }
}

TEST(VirtualSources, StopAtALimit) {
  const auto mesh = test::make_mesh(test::icosphere(3));
  VirtualSources whole(mesh);
  VirtualSources limited(mesh);
  const ExactSource source{SurfacePoint::at_vertex(7)};
  whole.run({&source, 1});
  limited.run({&source, 1}, 0.8);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    if (whole.distance(v) > 0.8) {
      EXPECT_EQ(limited.distance(v), unreachable);
      EXPECT_EQ(limited.nearest_source(v), no_index);
    } else {
      EXPECT_NEAR(limited.distance(v), whole.distance(v), 1e-3);
    }
  }
}

TEST(VirtualSources, PassVerticesInWhichFacesMeetAndLeaveOtherComponentsOut) {
  const test::Shape bow = test::bow_tie(4);
  VirtualSources runs(test::make_mesh(bow.soup));
  const ExactSource source{SurfacePoint::at_vertex(3)};
  runs.run({&source, 1});
  for (Index v = 0; v < runs.mesh().vertex_count(); ++v) {
    EXPECT_NEAR(runs.distance(v), bow.vertex_distance(3, v), 0.02 * bow.vertex_distance(3, v) + 1e-12);
  }
  const auto two = test::make_mesh(test::two_components(test::icosphere(1), test::icosphere(1)));
  VirtualSources apart(two);
  const ExactSource first{SurfacePoint::at_vertex(0)};
  apart.run({&first, 1});
  EXPECT_LT(apart.distance(1), unreachable);
  EXPECT_EQ(apart.distance(two->vertex_count() - 1), unreachable);
}

TEST(VirtualSources, CrossASpineIntoEachOfThreePages) {
  const test::Shape book = test::book_of_three_pages(8, 1.0, 0.7);
  VirtualSources runs(test::make_mesh(book.soup));
  const Index middle = runs.mesh().vertex_count() / 2;
  const ExactSource source{SurfacePoint::at_vertex(middle)};
  runs.run({&source, 1});
  for (Index v = 0; v < runs.mesh().vertex_count(); ++v) {
    const double straight = book.vertex_distance(middle, v);
    EXPECT_GE(runs.distance(v), straight - 1e-12);
    EXPECT_LE(runs.distance(v), 1.02 * straight + 1e-12);
  }
}

TEST(VirtualSources, GiveVerticesThatAGapMadeOneTheSameDistance) {
  const test::Shape shape = test::plane_grid(6, 5, 1.0, 0.8);
  const test::Cut loose = test::exploded(shape.soup);
  VirtualSources runs(measured_mesh(loose.soup.positions, loose.soup.faces, {}, {1e-9}));
  const ExactSource source{SurfacePoint::at_vertex(0)};
  runs.run({&source, 1});
  for (Index v = 0; v < runs.mesh().vertex_count(); ++v) {
    const double straight = distance_between(loose.soup.positions[0], loose.soup.positions[v]);
    EXPECT_NEAR(runs.distance(v), straight, 0.01 * straight);
    EXPECT_EQ(runs.nearest_source(v), 0);
  }
}

TEST(VirtualSources, RefuseWhatIsNoSource) {
  const test::Soup vast = test::plane_grid(2, 2, 1e150, 1e150).soup;
  EXPECT_THROW(VirtualSources(test::make_mesh(vast)), InvalidInput) << "products would overflow";
  VirtualSources runs(test::make_mesh(test::icosphere(1)));
  const ExactSource negative{SurfacePoint::at_vertex(0), -1.0};
  EXPECT_THROW(runs.run({&negative, 1}), InvalidInput);
  const ExactSource missing{SurfacePoint::at_vertex(4000)};
  EXPECT_THROW(runs.run({&missing, 1}), InvalidInput);
  EXPECT_GT(runs.memory_bytes(), 0U);
}

}  // namespace
}  // namespace vorogeo
