// The near field on a plane, where distances are straight lines: what it reaches, how far it is certain, and
// where it replaces other distances.
#include "query/near_field.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "query/geodesic_query.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

constexpr double precise = 1e-9;

/// A near field that was run from one vertex of a plane.
struct OnPlane {
  explicit OnPlane(Index vertex, double max_distance = unreachable)
      : index(test::make_index(test::plane_grid(40, 40, 1.0, 1.0, 0.2).soup, 4, 4)),
        data(index->data()),
        source(data.work.work_vertex[vertex]),
        near(data) {
    const ExactSource one{SurfacePoint::at_vertex(source)};
    near.add_at(one.point);
    near.run(std::span(&one, 1), max_distance, true);
  }
  double straight(Index v) const {
    const Point& a = data.work.mesh->position(source);
    const Point& b = data.work.mesh->position(v);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }
  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  Index source;
  NearField near;
};

TEST(NearField, ReachesAllVerticesOfThePatchesExactly) {
  for (Index vertex : {0, 300, 840, 1200}) {
    const OnPlane on(vertex);
    std::size_t inside = 0;
    for (Index f = 0; f < on.data.work.mesh->face_count(); ++f) {
      if (!on.near.inside(f)) continue;
      for (Index v : on.data.work.mesh->face_vertices(f)) {
        ++inside;
        const double found = on.near.solver().distance(v);
        // A path in the plane is straight; one that leaves the halo comes out slightly too long.
        EXPECT_GE(found, on.straight(v) - precise);
        EXPECT_LE(found, 1.01 * on.straight(v) + precise);
      }
    }
    EXPECT_GT(inside, 0U);
  }
}

TEST(NearField, HoldsWhereItIsCertainAndWhereItIsShorter) {
  const OnPlane on(840);
  std::set<Index> held;
  // Against other distances that are never shorter, all that were reached hold.
  on.near.for_each_held([](Index) { return unreachable; },
                        [&](Index v, double exact) {
                          held.insert(v);
                          EXPECT_EQ(exact, on.near.solver().distance(v));
                        });
  for (Index f : on.near.halo().faces()) {
    for (Index v : on.data.work.mesh->face_vertices(f)) {
      EXPECT_EQ(held.contains(v), on.near.solver().distance(v) < unreachable);
    }
  }
  // Against 0, only those up to where no path has left the halo: they are straight.
  std::size_t certain = 0;
  on.near.for_each_held([](Index) { return 0.0; },
                        [&](Index v, double exact) {
                          ++certain;
                          EXPECT_NEAR(exact, on.straight(v), precise);
                        });
  EXPECT_GT(certain, 0U);
  EXPECT_TRUE(on.near.holds(0.0, 0.0, false)) << "the source itself";
  EXPECT_FALSE(on.near.holds(unreachable, 1.0, true));
  EXPECT_FALSE(on.near.holds(1e6, 0.9e6, true)) << "a path outside is much shorter";
  EXPECT_TRUE(on.near.holds(1e6, 0.999e6, true)) << "by no more than repaired crossings err";
  EXPECT_FALSE(on.near.holds(1e6, 0.999e6, false));
}

TEST(NearField, StopsAtTheGreatestDistance) {
  const OnPlane on(840, 0.06);
  std::size_t reached = 0;
  for (Index v = 0; v < on.data.work.mesh->vertex_count(); ++v) {
    const double found = on.near.solver().distance(v);
    EXPECT_EQ(found < unreachable, on.straight(v) <= 0.06) << v;
    reached += found < unreachable ? 1 : 0;
  }
  EXPECT_GT(reached, 1U);
}

TEST(NearField, ForgetsItsPatches) {
  OnPlane on(840);
  on.near.clear();
  for (Index f = 0; f < on.data.work.mesh->face_count(); ++f) EXPECT_FALSE(on.near.inside(f));
}

TEST(NearField, IsWidenedWhereManyFacesLieWithinATinyDistance) {
  // A disc squashed to an ellipse 100,000 times longer than wide: flat and convex, so that distances are
  // straight lines. From side to side they cross tens of needles, most of them outside the halo.
  test::Soup soup = test::needle_disc(90);
  for (Point& p : soup.positions) p[1] *= 1e-5;
  const auto index = test::make_index(soup, 6, 2);
  GeodesicQuery query(index);
  for (Index source = 1; source <= 90; source += 7) {
    const std::vector<double> field = query.distance_field(std::array{source});
    for (Index v = 0; v <= 90; ++v) {
      const double straight = std::hypot(soup.positions[v][0] - soup.positions[source][0],
                                         soup.positions[v][1] - soup.positions[source][1]);
      EXPECT_NEAR(field[v], straight, 0.02 * straight) << source << " to " << v;
    }
  }
}

TEST(NearField, TakesThePatchesOfAllPagesAtTheSource) {
  const auto index = test::make_index(test::book_of_three_pages(12, 1.0, 1.0).soup, 3, 4);
  const IndexData& data = index->data();
  const Mesh& mesh = *data.work.mesh;
  int spine_edges = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index next = mesh.next_around_edge(h);
    if (next == h || mesh.next_around_edge(next) == h) continue;
    ++spine_edges;
    std::array<double, 3> middle{};
    middle[h % 3] = middle[Mesh::next_in_face(h) % 3] = 0.5;
    for (const auto& point :
         {SurfacePoint::in_face(Mesh::face_of(h), middle), SurfacePoint::at_vertex(mesh.tail(h))}) {
      NearField near(data);
      near.add_at(point);
      for_each_face_at(mesh, point, [&](Index face, const std::array<double, 3>&) {
        EXPECT_TRUE(near.inside(face)) << face;
      });
    }
  }
  EXPECT_GE(spine_edges, 3 * 12);
}

TEST(NearField, TakesThePatchBehindABorderCloseToTheSource) {
  const auto index = test::make_index(test::plane_grid(40, 40, 1.0, 1.0, 0.2).soup, 4, 4);
  const IndexData& data = index->data();
  const Mesh& mesh = *data.work.mesh;
  const auto& label = data.work.second_layer;
  int borders = 0;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h) {
    const Index face = Mesh::face_of(h);
    const Index other = Mesh::face_of(mesh.next_around_edge(h));
    if (label[other] == label[face]) continue;
    ++borders;
    NearField near(data);
    std::array<double, 3> weights{};
    weights[h % 3] = weights[Mesh::next_in_face(h) % 3] = 0.49;
    weights[Mesh::previous_in_face(h) % 3] = 0.02;
    near.add_at(SurfacePoint::in_face(face, weights));
    EXPECT_TRUE(near.inside(face));
    EXPECT_TRUE(near.inside(other)) << "behind edge " << mesh.edge_of(h);
  }
  EXPECT_GT(borders, 0);
  // Nothing is added for the middle of a face inside a patch.
  for (Index face = 0; face < mesh.face_count(); ++face) {
    NearField near(data);
    near.add_at(SurfacePoint::in_face(face, {1.0 / 3, 1.0 / 3, 1.0 / 3}));
    std::set<Index> around{label[face]};
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      around.insert(label[Mesh::face_of(mesh.next_around_edge(h))]);
    for (Index f = 0; f < mesh.face_count(); ++f) {
      if (near.inside(f)) {
        EXPECT_TRUE(around.contains(label[f]));
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
