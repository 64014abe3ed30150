// The generator of hostile meshes: repeatable, says what it made, and makes what it says.
#include "support/hostile_meshes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "exact/exact_solver.h"
#include "mesh/mesh_check.h"

namespace vorogeo::test {
namespace {

TEST(HostileMeshes, SameSeedSameMesh) {
  for (unsigned seed = 1; seed < 50; ++seed) {
    const HostileMesh first = hostile_mesh(seed, 100);
    const HostileMesh second = hostile_mesh(seed, 100);
    ASSERT_EQ(first.soup.positions, second.soup.positions) << seed;
    ASSERT_EQ(first.soup.faces, second.soup.faces) << seed;
    ASSERT_EQ(first.sentence(), second.sentence()) << seed;
  }
}

TEST(HostileMeshes, EachBaseWithEachDefectIsAMesh) {
  for (int base = 0; base < hostile_base_count; ++base) {
    for (int defect = 0; defect < hostile_defect_count; ++defect) {
      HostileRandom random(100 * base + defect);
      HostileMesh mesh = hostile_base(static_cast<HostileBase>(base), 60, random);
      add_defect(mesh, static_cast<HostileDefect>(defect), random);
      const auto report = check_mesh(mesh.soup.positions, mesh.soup.faces);
      ASSERT_TRUE(report.usable()) << mesh.sentence();
      ASSERT_NO_THROW(make_mesh(mesh.soup)) << mesh.sentence();
      ASSERT_TRUE(mesh.flat.empty() || mesh.flat.size() == mesh.soup.positions.size()) << mesh.sentence();
    }
  }
}

TEST(HostileMeshes, DefectsAreFoundByTheCheck) {
  auto report_of = [](HostileDefect defect) {
    HostileRandom random(7);
    HostileMesh mesh = hostile_base(HostileBase::scan, 200, random);
    add_defect(mesh, defect, random);
    EXPECT_EQ(mesh.defects.size(), 1u);
    return check_mesh(mesh.soup.positions, mesh.soup.faces);
  };
  EXPECT_GT(report_of(HostileDefect::collapsed_edges).zero_area_faces.count, 0);
  EXPECT_GT(report_of(HostileDefect::collapsed_edges).duplicate_vertices.count, 0);
  EXPECT_GT(report_of(HostileDefect::slit).border_edges, 0);
  EXPECT_GT(report_of(HostileDefect::slit).duplicate_vertices.count, 0);
  EXPECT_GT(report_of(HostileDefect::t_junctions).border_edges, 0);
  EXPECT_GT(report_of(HostileDefect::flat_caps).zero_area_faces.count, 0);
  EXPECT_GT(report_of(HostileDefect::fins).non_manifold_edges.count, 0);
  EXPECT_GT(report_of(HostileDefect::flipped_faces).inconsistent_edges.count, 0);
  EXPECT_GT(report_of(HostileDefect::components).components, 1);
  EXPECT_GT(report_of(HostileDefect::isolated_vertices).isolated_vertices.count, 0);
  EXPECT_GT(report_of(HostileDefect::repeated_faces).duplicate_faces.count, 0);
}

TEST(HostileMeshes, UnrolledSurfacesHaveStraightDistances) {
  int checked = 0;
  for (unsigned seed = 1; seed < 600; ++seed) {
    const HostileMesh hostile = hostile_mesh(seed, 80);
    if (hostile.flat.empty()) continue;
    const auto mesh = make_mesh(hostile.soup);
    const Index source = mesh->face_vertices(mesh->face_count() / 2)[0];
    const auto& from = hostile.flat[source];
    if (std::isnan(from[0])) continue;
    const auto distances = exact_distance_field(mesh, std::array{source});
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const auto& to = hostile.flat[v];
      if (std::isnan(to[0])) continue;
      const double straight = std::hypot(to[0] - from[0], to[1] - from[1]);
      ASSERT_NEAR(distances[v], straight, 1e-9 * (straight + mesh->longest_edge_length()))
          << "seed " << seed << ", " << hostile.sentence() << ", vertices " << source << " and " << v;
    }
    ++checked;
  }
  EXPECT_GT(checked, 20);
}

}  // namespace
}  // namespace vorogeo::test
