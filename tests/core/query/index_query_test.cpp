// Queries of an index: the same answers in every way of asking, and errors as documented.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "exact/exact_solver.h"
#include "support/error.h"
#include "support/heavy.h"
#include "support/hostile_meshes.h"
#include "support/indexes.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

std::vector<double> field(test::IndexQuery& query, std::vector<Index> sources) {
  return query.distance_field(sources);
}

TEST(IndexQuery, DuplicateSourcesCountOnceAndTheOrderDoesNotMatter) {
  test::IndexQuery query(test::make_index(test::icosphere(3), 3, 4));
  const auto once = field(query, {5, 300, 77});
  EXPECT_EQ(field(query, {5, 5, 300, 77, 300, 5}), once);
  EXPECT_EQ(field(query, {77, 300, 5}), once);
}

// Fields are the same in every way of asking.

/// The same vertices, each given as a point in the corner of a face.
std::vector<ExactSource> in_corners(const Mesh& mesh, const std::vector<Index>& vertices) {
  std::vector<ExactSource> sources;
  for (Index v : vertices) {
    const Index corner = *mesh.corners(v).begin();
    std::array<double, 3> weights{};
    weights[corner % 3] = 1.0;
    sources.push_back({SurfacePoint::in_face(Mesh::face_of(corner), weights), 0.0});
  }
  return sources;
}

TEST(IndexQuery, OnePipelineWhateverIsAsked) {
  for (const test::Soup& soup : {test::icosphere(4), test::hills(34, 0.3), test::bow_tie(9).soup}) {
    for (const auto& index :
         {test::make_index(soup, 5, 4), test::make_index(soup, 5, 4, test::lossless_delta)}) {
      const Mesh& mesh = *index->mesh();
      test::IndexQuery query(index, 2);
      std::vector<SurfacePoint> targets;
      for (Index v = 0; v < mesh.vertex_count(); ++v) targets.push_back(SurfacePoint::at_vertex(v));
      for (const auto& vertices : {std::vector<Index>{7}, test::random_vertices(mesh.vertex_count(), 4, 3)}) {
        for (const double most : {unreachable, 0.6}) {
          const auto field = query.distance_field(vertices, most);
          const auto points = in_corners(mesh, vertices);
          EXPECT_EQ(query.field(points, most), field) << "corners of faces";
          std::vector<Index> labels;
          EXPECT_EQ(query.field(points, most, &labels), field) << "labels and offsets of 0";
          EXPECT_EQ(query.distances(points, targets, most), field) << "at points that are vertices";
          auto mixed = targets;
          mixed.push_back(SurfacePoint::in_face(0, {0.2, 0.3, 0.5}));
          auto at_points = query.distances(points, mixed, most);
          at_points.pop_back();
          EXPECT_EQ(at_points, field) << "beside points in faces";
          for (Index v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_EQ(labels[v] == no_index, field[v] == unreachable) << v;
          }
        }
      }
    }
  }
}

// Queries against exact distances: near the source, on shapes like scans and like CAD, on real meshes, with
// defects.

using test::HostileBase;

/// Relative errors of a mesh, in percent as docs/figures.md gives them.
struct Documented {
  double mean, p99, greatest;
};

/// Fields and pairs with default settings, against twice the documented errors.
void expect_accurate(const Soup& soup, const Documented& documented, int sources) {
  VOROGEO_HEAVY_TEST();
  const auto index = test::make_index(soup);
  test::IndexQuery query(index);
  ExactSolver solver(index->mesh());
  test::ErrorCollector fields;
  test::ErrorCollector pairs;
  const Index n = index->mesh()->vertex_count();
  for (Index source : test::random_vertices(n, sources, 1)) {
    solver.run_from_vertices(std::array{source});
    const auto distances = field(query, {source});
    for (Index v = 0; v < n; ++v) fields.add(distances[v], solver.distance(v));
    for (Index v : test::random_vertices(n, 100, 100 + source))
      pairs.add(query.distance(source, v), solver.distance(v));
  }
  const double twice_percent = 2.0 / 100.0;
  for (const test::ErrorCollector& errors : {fields, pairs}) {
    EXPECT_EQ(errors.contradictions, 0U);
    const auto found = errors.statistics();
    EXPECT_LE(found.mean, twice_percent * documented.mean);
    EXPECT_LE(found.p99, twice_percent * documented.p99);
    EXPECT_LE(found.greatest, twice_percent * documented.greatest);
    EXPECT_GE(found.least, -twice_percent * documented.greatest);
  }
}

void expect_accurate(const char* name, const Documented& documented) {
  VOROGEO_READ_OR_SKIP(soup, name);
  expect_accurate(soup, documented, 10);
}

/// One of the shapes that the generator of hostile meshes starts from, without its defects.
void expect_accurate(HostileBase base, const Documented& documented) {
  test::HostileRandom random(5);
  const test::HostileMesh mesh = test::hostile_base(base, 3000, random);
  SCOPED_TRACE(mesh.sentence());
  expect_accurate(mesh.soup, documented, 6);
}

// Meshes that are generated, so that a clone has them: CAD parts, needles, a city, a coarse sphere, and bases
// of hostile meshes, rough, with long thin faces, of high genus (docs/figures.md).
TEST(IndexQueryAccuracy, DrilledPlate) {
  expect_accurate(test::drilled_plate(6, 6, 0.6, 1), {0.0069, 0.055, 0.18}, 6);
}
TEST(IndexQueryAccuracy, PlateWithDeepHoles) {
  expect_accurate(test::drilled_plate(8, 8, 3.0, 2), {0.0165, 0.122, 0.51}, 4);
}
TEST(IndexQueryAccuracy, Gear) { expect_accurate(test::gear(40, 16, 8.0), {1e-7, 1e-7, 1e-7}, 6); }
TEST(IndexQueryAccuracy, CoarseSphere) {
  expect_accurate(test::random_sphere(1500, 2), {0.0160, 0.069, 0.19}, 6);
}
TEST(IndexQueryAccuracy, BlockCity) {
  expect_accurate(test::block_city(20, 20, 1), {0.0037, 0.039, 0.14}, 6);
}
TEST(IndexQueryAccuracy, RoughScan) { expect_accurate(HostileBase::scan, {0.0061, 0.050, 0.19}); }
TEST(IndexQueryAccuracy, CoarseExtrusion) { expect_accurate(HostileBase::extrusion, {0.0053, 0.126, 0.33}); }
TEST(IndexQueryAccuracy, PlateOfHighGenus) { expect_accurate(HostileBase::plate, {0.0054, 0.056, 0.16}); }
TEST(IndexQueryAccuracy, FanOfNeedles) { expect_accurate(HostileBase::fan, {0.0022, 0.054, 0.13}); }

// Real meshes, if they are next to the repository: docs/figures.md.
TEST(IndexQueryAccuracy, Spot) { expect_accurate("spot", {0.0091, 0.095, 0.27}); }
TEST(IndexQueryAccuracy, Fandisk) { expect_accurate("fandisk", {0.0084, 0.071, 0.81}); }
TEST(IndexQueryAccuracy, RockerArm) { expect_accurate("rocker_arm", {0.0080, 0.056, 0.28}); }
TEST(IndexQueryAccuracy, Casting) { expect_accurate("casting", {0.0097, 0.122, 1.21}); }
TEST(IndexQueryAccuracy, Gears) { expect_accurate("gears", {0.0021, 0.025, 0.11}); }

TEST(IndexQueryAccuracy, PairsInTouchingPatchesAreExact) {
  for (const Soup& soup : {test::icosphere(4), test::hills(40, 0.15), test::torus(60, 30, 2.0, 0.8)}) {
    const auto index = test::make_index(soup, 3, 6);
    test::IndexQuery query(index);
    const Mesh& mesh = *index->mesh();
    ExactSolver solver(index->mesh());
    const auto label = index->face_patches(2);
    for (Index source : test::random_vertices(mesh.vertex_count(), 4, 5)) {
      // The patches of the source and all that share a vertex with one of them.
      const auto own = test::patches_at(mesh, label, source);
      auto near = own;
      for (Index v = 0; v < mesh.vertex_count(); ++v) {
        const auto there = test::patches_at(mesh, label, v);
        if (std::ranges::any_of(there, [&](Index p) { return own.contains(p); }))
          near.insert(there.begin(), there.end());
      }
      solver.run_from_vertices(std::array{source});
      for (Index v : test::random_vertices(mesh.vertex_count(), 200, 6)) {
        const auto there = test::patches_at(mesh, label, v);
        if (std::ranges::none_of(there, [&](Index p) { return near.contains(p); })) continue;
        const double exact = solver.distance(v);
        ASSERT_NEAR(query.distance(source, v), exact, 1e-9 * exact) << source << " to " << v;
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
