// Many crossings at once: against the formulas for one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "index/scans.h"
#include "index/unfolding.h"

namespace vorogeo {
namespace {

struct Point2 {
  double x, y;
};
double between(Point2 a, Point2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// A border of three vertices, a source below it and a target above it; the middle one is the crossing.
struct Scene {
  Scene(std::mt19937& random, double far) {
    auto uniform = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    border = {{{uniform(-1.2, -0.5), uniform(-0.2, 0.2)}, {0, 0}, {uniform(0.5, 1.2), uniform(-0.2, 0.2)}}};
    source = {uniform(-far, far), -uniform(0.1, far)};
    target = {uniform(-6, 6), uniform(0.05, 9)};
    for (int i : {0, 1, 2}) {
      from[i] = between(source, border[i]);
      to[i] = between(target, border[i]);
    }
    lengths = {between(border[0], border[1]), between(border[2], border[1])};
  }
  std::array<Point2, 3> border;
  Point2 source, target;
  std::array<double, 3> from, to;
  std::array<double, 2> lengths;
};

TEST(CrossingGains, AsUnfoldingAndParabola) {
  std::mt19937 random(4);
  for (double far : {2.0, 20.0, 500.0, 1e7}) {
    for (int round = 0; round < 50; ++round) {
      Crossings crossings{};
      std::array<double, Crossings::capacity> expected{};
      double lowest = 1e300;
      std::vector<Scene> scenes;
      for (Index k = 0; k < Crossings::capacity; ++k) {
        scenes.emplace_back(random, far);
        // The sources of one batch are at about the same distance.
        if (k > 0 && std::abs(scenes[k].from[1] - scenes[0].from[1]) > 30.0) scenes[k] = scenes[0];
        for (double distance : scenes[k].from) lowest = std::min(lowest, distance);
      }
      for (Index k = 0; k < Crossings::capacity; ++k) {
        const Scene& scene = scenes[k];
        crossings.source[k] = static_cast<float>(scene.from[1] - lowest);
        crossings.target[k] = static_cast<float>(scene.to[1]);
        std::array<BorderSample, 2> samples{};
        std::vector<BorderSample> known;
        for (int s : {0, 1}) {
          // Every fifth crossing lacks a neighbour.
          const bool used = k % 5 != 0 || s == k % 2;
          samples[s] = {scene.from[2 * s], scene.to[2 * s], scene.lengths[s]};
          crossings.side[s].source[k] = static_cast<float>(scene.from[2 * s] - lowest);
          crossings.side[s].target[k] = static_cast<float>(scene.to[2 * s]);
          crossings.side[s].length[k] = used ? static_cast<float>(scene.lengths[s]) : 0.0F;
          if (used) known.push_back(samples[s]);
        }
        const double best = crossing_distance(scene.from[1], scene.to[1], known);
        expected[k] = scene.from[1] + scene.to[1] - best;
      }
      float gain[Crossings::capacity];
      crossing_gains(crossings, static_cast<float>(lowest), gain);
      for (Index k = 0; k < Crossings::capacity; ++k) {
        EXPECT_NEAR(gain[k], expected[k], 2e-4 * (1.0 + scenes[k].to[1])) << far << ", " << k;
        EXPECT_GE(gain[k], 0.0F);
      }
    }
  }
}

TEST(CrossingGains, NothingWhereThePathWouldPassOnBothSides) {
  // The wave runs along the border, from the neighbour before to the vertex; the one at the neighbour behind
  // came by another path.
  Crossings crossings{};
  for (Index k = 0; k < Crossings::capacity; ++k) {
    crossings.source[k] = 0.5F;
    crossings.target[k] = 0.25F;
    crossings.side[0].source[k] = 0.3F;
    crossings.side[0].target[k] = 0.45F;
    crossings.side[0].length[k] = 0.2F;
    crossings.side[1].source[k] = 0.0F;
    crossings.side[1].target[k] = 0.77F;
    crossings.side[1].length[k] = 1.0F;
  }
  float gain[Crossings::capacity];
  crossing_gains(crossings, 6.7F, gain);
  for (float value : gain) EXPECT_EQ(value, 0.0F);
  for (Index k = 0; k < Crossings::capacity; ++k) crossings.side[0].length[k] = 0.0F;
  crossing_gains(crossings, 6.7F, gain);
  for (float value : gain) EXPECT_GT(value, 0.1F);
}

TEST(CrossingGains, NothingWithoutNeighboursOrWithoutDistances) {
  Crossings crossings{};
  float gain[Crossings::capacity];
  crossing_gains(crossings, 0.0F, gain);
  for (float value : gain) EXPECT_EQ(value, 0.0F);
  for (Index k = 0; k < Crossings::capacity; ++k) {
    crossings.source[k] = 1.0F;
    crossings.target[k] = 1.0F;
  }
  crossing_gains(crossings, 5.0F, gain);
  for (float value : gain) EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace vorogeo
