// Fingerprint: equal for equal meshes, different after every kind of edit.
#include "mesh/fingerprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

Fingerprint of(const Soup& soup) { return fingerprint_of(*test::make_mesh(soup)); }

TEST(Fingerprint, EqualMeshesAgree) {
  EXPECT_EQ(of(test::icosphere(2)), of(test::icosphere(2)));
  EXPECT_EQ(of({}), of({}));
}

TEST(Fingerprint, NegativeZeroIsZero) {
  Soup soup = test::plane_grid(2, 2, 1.0, 1.0).soup;
  const Fingerprint before = of(soup);
  for (Point& p : soup.positions) p[2] = -0.0;
  EXPECT_EQ(of(soup), before);
}

TEST(Fingerprint, FacesLeftOutDoNotCount) {
  const Soup soup = test::icosphere(0);
  EXPECT_EQ(of(test::with_duplicate_face(soup, 4)), of(soup));
  EXPECT_EQ(of(test::with_repeated_vertex_face(soup, 4)), of(soup));
}

TEST(Fingerprint, EveryEditShows) {
  const Soup soup = test::icosphere(1);
  std::set<std::array<std::uint64_t, 2>> seen{of(soup).words};
  auto differs = [&](const Soup& edited) { return seen.insert(of(edited).words).second; };
  // The smallest change of any coordinate of any vertex.
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    for (int k = 0; k < 3; ++k) {
      Soup moved = soup;
      moved.positions[v][k] = std::nextafter(moved.positions[v][k], 2.0);
      EXPECT_TRUE(differs(moved)) << "vertex " << v << ", coordinate " << k;
    }
  }
  for (std::size_t f = 0; f < soup.faces.size(); ++f) {
    Soup turned = soup;
    std::swap(turned.faces[f][1], turned.faces[f][2]);
    EXPECT_TRUE(differs(turned)) << "face " << f << " turned over";
    Soup rotated = soup;
    rotated.faces[f] = {soup.faces[f][1], soup.faces[f][2], soup.faces[f][0]};
    EXPECT_TRUE(differs(rotated)) << "face " << f << " rotated";
    Soup fewer = soup;
    fewer.faces.erase(fewer.faces.begin() + static_cast<std::ptrdiff_t>(f));
    EXPECT_TRUE(differs(fewer)) << "face " << f << " removed";
  }
  EXPECT_TRUE(differs(test::with_isolated_vertex(soup, {0, 0, 0})));
  Soup swapped = soup;
  std::swap(swapped.positions[3], swapped.positions[4]);
  EXPECT_TRUE(differs(swapped));
  Soup coordinates = soup;
  std::swap(coordinates.positions[0][0], coordinates.positions[0][1]);
  EXPECT_TRUE(differs(coordinates));
}

TEST(Fingerprint, EveryBitDependsOnEveryCoordinate) {
  // Avalanche: one flipped low bit changes each output bit in about half of the cases.
  const Soup soup = test::icosphere(2);
  const Fingerprint before = of(soup);
  std::array<int, 128> changes{};
  int trials = 0;
  for (std::size_t v = 0; v < soup.positions.size(); ++v) {
    for (int k = 0; k < 3; ++k, ++trials) {
      Soup moved = soup;
      moved.positions[v][k] = std::nextafter(moved.positions[v][k], 2.0);
      const Fingerprint after = of(moved);
      for (int bit = 0; bit < 128; ++bit) {
        changes[bit] += static_cast<int>((before.words[bit / 64] ^ after.words[bit / 64]) >> (bit % 64) & 1);
      }
    }
  }
  // Five standard deviations of a fair coin.
  const double allowed = 5.0 * 0.5 * std::sqrt(static_cast<double>(trials));
  for (int bit = 0; bit < 128; ++bit) EXPECT_NEAR(changes[bit], 0.5 * trials, allowed) << "bit " << bit;
}

}  // namespace
}  // namespace vorogeo
