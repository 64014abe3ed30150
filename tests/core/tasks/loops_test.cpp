// Closed curves pulled tight, loops through a point and girths, on closed surfaces and on bad ones.
#include "tasks/loops.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "exact/surface_path.h"
#include "mesh/vectors.h"
#include "support/refusal.h"
#include "support/shapes.h"
#include "tasks/girth.h"
#include "tasks/profile.h"

namespace vorogeo {
namespace {

constexpr double pi = std::numbers::pi;

Surface surface_on(const test::Soup& soup) {
  return Surface(std::make_shared<const Mesh>(soup.positions, soup.faces));
}

/// Expects a loop that is closed, runs over faces, and is as long as its steps.
void expect_closed(const Surface& surface, const SurfacePath& loop) {
  EXPECT_TRUE(is_same_point(*surface.mesh(), loop.points.front(), loop.points.back()));
  EXPECT_NEAR(measured_length(*surface.mesh(), loop.points).length, loop.length, 1e-12 * loop.length);
}

TEST(Loops, OfABoxAreItsGirthsHoweverItsFacesAreTurned) {
  const test::Soup box = test::box({1.0, 2.0, 3.0}, 5).soup;
  for (const test::Soup& soup : {box, test::with_flipped_faces(box, 3), test::with_zero_area_cap(box, 70, 1),
                                 test::with_duplicate_face(box, 50)}) {
    Surface surface = surface_on(soup);
    for (Index face = 0; face < static_cast<Index>(box.faces.size()); face += 7) {
      const SurfacePoint point = SurfacePoint::in_face(face, {0.2, 0.3, 0.5});
      for (int axis = 0; axis < 3; ++axis) {
        Point normal{0.01, 0.02, -0.01};
        normal[axis] = 1.0;
        const double around = 2.0 * (6.0 - (axis + 1.0));
        const double place = position_of(*surface.mesh(), point)[axis] / (axis + 1.0);
        if (place < 0.15 || place > 0.85) continue;  // there, the plane cuts off corners of the box
        const Girth found = girth(surface, point, normal);
        EXPECT_GE(found.section.length, around);
        EXPECT_NEAR(found.tape_length, found.section.length, 1e-12);
        EXPECT_NEAR(found.loop.length, around, 1e-11) << face << " " << axis;
        expect_closed(surface, found.loop);
        EXPECT_NEAR(tighten(surface, PointList(found.section.points)).path.length, around, 1e-11);
      }
    }
  }
}

TEST(Loops, ThroughAPointOfATorusAreAsShortAsItsTube) {
  Surface surface = surface_on(test::torus(48, 24, 2.0, 0.8));
  const double tube = 2.0 * 24.0 * 0.8 * std::sin(pi / 24.0);
  for (const SurfacePoint& point :
       {SurfacePoint::at_vertex(5), SurfacePoint::at_vertex(700), SurfacePoint::in_face(99, {0.2, 0.3, 0.5}),
        SurfacePoint::in_face(1000, {0.5, 0.5, 0.0})}) {
    const ExactPath loop = shortest_loop(surface, point, {});
    EXPECT_LE(loop.path.length, tube * 1.001);  // through a point in a face, between rings of vertices
    EXPECT_GE(loop.path.length, tube * std::cos(pi / 48.0));
    EXPECT_TRUE(is_same_point(*surface.mesh(), loop.path.points.front(), point));
    expect_closed(surface, loop.path);
  }
}

TEST(Loops, OfAPlateGoThroughItsHoles) {
  constexpr double thickness = 0.3;
  Surface surface = surface_on(test::drilled_plate(3, 2, thickness, 4));
  const Mesh& mesh = *surface.mesh();
  for (Index v = 0; v < mesh.vertex_count(); v += 17) {
    const SurfacePath loop = shortest_loop(surface, SurfacePoint::at_vertex(v), {}).path;
    // Up one wall and down another: at least twice as long as the plate is thick.
    EXPECT_GT(loop.length, 2.0 * thickness);
    expect_closed(surface, loop);
    EXPECT_LE(tighten(surface, PointList(loop.points)).path.length, loop.length * (1.0 + 1e-12));
  }
}

TEST(Loops, OfASphereSlipOff) {
  Surface surface = surface_on(test::icosphere(3));
  for (const Index v : {0, 100, 333}) {
    const Girth found = girth(surface, SurfacePoint::at_vertex(v), std::nullopt);
    EXPECT_LT(found.section.length, 2.0 * pi);
    EXPECT_GT(found.section.length, 0.98 * 2.0 * pi);  // a plane through the normal halves the sphere
    EXPECT_EQ(found.loop.length, 0.0);
    EXPECT_EQ(found.loop.points.size(), 1U);
    EXPECT_NE(test::refusal([&] { tighten(surface, PointList(found.section.points)); }).find("slips off"),
              std::string::npos);
    EXPECT_NE(test::refusal([&] {
                shortest_loop(surface, SurfacePoint::at_vertex(v), {});
              }).find("Every loop through vertex " + std::to_string(v) + " contracts"),
              std::string::npos);
  }
}

TEST(Loops, SayThatTheyWereStillBecomingShorter) {
  const test::Soup box = test::box({1.0, 2.0, 3.0}, 5).soup;
  Surface surface = surface_on(box);
  Index face = 0;  // half-way up
  while (std::abs(position_of(*surface.mesh(), SurfacePoint::in_face(face, {0.2, 0.3, 0.5}))[2] - 1.5) > 0.3)
    ++face;
  const Girth found = girth(surface, SurfacePoint::in_face(face, {0.2, 0.3, 0.5}), Point{0.1, 0.2, 1.0});
  const TightLoop one = tightened(*surface.geometry()->windows, found.section.points, 1);
  EXPECT_NE(one.remark.find("still becoming shorter after 1 rounds"), std::string::npos) << one.remark;
  EXPECT_LT(one.path.length, found.section.length);
  EXPECT_EQ(tightened(*surface.geometry()->windows, one.path.points).remark, "");
}

TEST(Loops, AreRefusedWhereThreeFacesMeet) {
  const test::Soup soup = test::book_of_three_pages(3, 2.0, 1.0).soup;
  Surface surface = surface_on(soup);
  const auto corner = static_cast<Index>(soup.positions.size()) - 1;
  const std::string sentence =
      test::refusal([&] { shortest_loop(surface, SurfacePoint::at_vertex(corner), {}); });
  EXPECT_NE(sentence.find(" has 3 faces"), std::string::npos) << sentence;
}

TEST(Profile, NormalsOfASphereLeadFromItsCentre) {
  const test::Soup soup = test::icosphere(4);
  const Mesh mesh(soup.positions, soup.faces);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_GT(std::abs(dot(normal_at(mesh, SurfacePoint::at_vertex(v)), mesh.position(v))), 0.999);
  }
}

}  // namespace
}  // namespace vorogeo
