// Fields from points anywhere, with offsets and labels, against the exact solver; and snapping to a surface.
#include "query/source_field.h"

#include <gtest/gtest.h>

#include <array>

#include "mesh/surface_locator.h"
#include "query/geodesic_query.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Points in a corner of a face, each standing for a vertex.
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

TEST(SourceField, OnePipelineWhateverIsAsked) {
  for (const test::Soup& soup : {test::icosphere(4), test::hills(34, 0.3), test::bow_tie(9).soup}) {
    for (const auto& index : {test::make_index(soup, 5, 4), test::make_graph_index(soup, 5, 4)}) {
      const Mesh& mesh = *index->mesh();
      GeodesicQuery query(index, 2);
      std::vector<SurfacePoint> targets;
      for (Index v = 0; v < mesh.vertex_count(); ++v) targets.push_back(SurfacePoint::at_vertex(v));
      for (const auto& vertices : {std::vector<Index>{7}, test::random_vertices(mesh.vertex_count(), 4, 3)}) {
        for (const double most : {unreachable, 0.6}) {
          const auto field = query.distance_field(vertices, most);
          const auto points = in_corners(mesh, vertices);
          EXPECT_EQ(query.distance_field(points, most), field) << "corners of faces";
          const LabelledField labelled = query.labelled_field(points, most);
          EXPECT_EQ(labelled.distance, field) << "labels and offsets of 0";
          EXPECT_EQ(query.distances(points, targets, most), field) << "at points that are vertices";
          auto mixed = targets;
          mixed.push_back(SurfacePoint::in_face(0, {0.2, 0.3, 0.5}));
          auto at_points = query.distances(points, mixed, most);
          at_points.pop_back();
          EXPECT_EQ(at_points, field) << "beside points in faces";
          for (Index v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_EQ(labelled.source[v] == no_index, field[v] == unreachable) << v;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo
