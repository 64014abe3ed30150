// A surface chooses what answers, says what did, and builds an index once exact answers have taken as long.
#include "query/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <latch>
#include <numbers>
#include <string>
#include <thread>

#include "query/rent_or_buy.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

std::vector<ExactSource> from_vertices(const std::vector<Index>& vertices) {
  std::vector<ExactSource> sources;
  for (Index v : vertices) sources.push_back({SurfacePoint::at_vertex(v)});
  return sources;
}

TEST(Surface, AFieldThatReachesASmallPartIsExactAlthoughThereIsAnIndex) {
  const test::Shape plane = test::plane_grid(24, 24, 3.0, 3.0, 0.2);
  Surface surface(test::make_index(plane.soup, 3, 3), 1);
  Answered answered;
  // A disk of radius 0.3 covers a thirtieth of the area of 9, a disk of radius 1.0 a third.
  const LabelledField small = surface.field(from_vertices({300}), 0.3, Answer::automatic, answered);
  EXPECT_EQ(answered.by, Answer::exact);
  for (Index v = 0; v < static_cast<Index>(plane.soup.positions.size()); ++v) {
    const double straight = plane.vertex_distance(300, v);
    if (straight <= 0.3) {
      EXPECT_NEAR(small.distance[v], straight, 1e-12);
    } else {
      EXPECT_EQ(small.distance[v], unreachable);
    }
  }
  EXPECT_NEAR(surface.reach_of(0.3), 0.01 * std::numbers::pi, 1e-12);
  EXPECT_EQ(surface.reach_of(unreachable), 1.0);
  EXPECT_EQ(surface.spent().rent(), 0.0) << "an index would not have been faster";
  surface.field(from_vertices({300}), 1.0, Answer::automatic, answered);
  EXPECT_EQ(answered.by, Answer::index);
}

TEST(Surface, BuildsAnIndexWhenExactAnswersTookAsLong) {
  const auto mesh = test::make_mesh(test::icosphere(5));
  RentOrBuy spent(mesh->vertex_count());
  Surface surface(mesh, nullptr, spent);
  const auto sources = from_vertices({5});
  Answered answered;
  surface.field(sources, unreachable, Answer::automatic, answered);
  EXPECT_EQ(answered.by, Answer::exact);
  EXPECT_EQ(answered.remark, "");
  EXPECT_GT(surface.spent().rent(), 0.0);

  for (int i = 0; i < 10; ++i) spent.pay(360.0);  // more than any such index costs
  Surface later(mesh, nullptr, spent);
  later.field(sources, unreachable, Answer::automatic, answered);
  EXPECT_EQ(answered.by, Answer::index);
  EXPECT_GT(answered.index_seconds, 0.0);
  EXPECT_NE(answered.remark, "");
  EXPECT_TRUE(later.index());
}

TEST(Surface, BuildsNoIndexForFieldsThatItWouldNotGiveSooner) {
  // One patch without a border: its fields are exact runs over all of the mesh.
  const auto mesh = test::make_mesh(test::icosphere(1));
  RentOrBuy spent(mesh->vertex_count());
  for (int i = 0; i < 10; ++i) spent.pay(360.0);
  Surface surface(mesh, nullptr, spent, {.first_layer_patches = 1, .second_layer_patches = 1});
  Answered answered;
  for (int i = 0; i < 3; ++i) {
    surface.field(from_vertices({5}), unreachable, Answer::automatic, answered);
    EXPECT_EQ(answered.by, Answer::exact);
  }
  EXPECT_EQ(surface.spent().rent(), 3600.0) << "an index would not have been faster";
  EXPECT_FALSE(surface.index());
  const SurfacePoint one = SurfacePoint::at_vertex(0);
  surface.distance(one, SurfacePoint::at_vertex(7), Answer::automatic, answered);
  EXPECT_EQ(answered.by, Answer::index) << "a pair is read from a table";
  surface.field(from_vertices({5}), unreachable, Answer::automatic, answered);
  EXPECT_EQ(answered.by, Answer::exact) << "a field takes as long with the index";
}

TEST(Surface, StaysExactWhereNoIndexCanBeHad) {
  const auto mesh = test::make_mesh(test::icosphere(5));
  RentOrBuy spent(mesh->vertex_count());
  for (int i = 0; i < 10; ++i) spent.pay(360.0);
  IndexOptions options;
  options.memory_budget = 1;
  Surface surface(mesh, nullptr, spent, options);
  const auto sources = from_vertices({5});
  Answered answered;
  std::vector<double> fractions;
  const Progress progress([&](double fraction, const std::string&) {
    fractions.push_back(fraction);
    return true;
  });
  surface.field(sources, unreachable, Answer::automatic, answered, progress);
  EXPECT_EQ(answered.by, Answer::exact);
  EXPECT_NE(answered.remark.find("memory budget"), std::string::npos);
  EXPECT_TRUE(std::ranges::is_sorted(fractions)) << "the exact answer goes on where the build ended";
  surface.field(sources, unreachable, Answer::automatic, answered);
  EXPECT_EQ(answered.remark, "");
  EXPECT_THROW(surface.field(sources, unreachable, Answer::index, answered), InvalidInput);
}

TEST(Surface, StaysExactOnLengthsThatAnIndexDoesNotTake) {
  const auto mesh = test::make_mesh(test::scaled(test::icosphere(3), 1e-40));
  RentOrBuy spent(mesh->vertex_count());
  for (int i = 0; i < 10; ++i) spent.pay(360.0);
  Surface surface(mesh, nullptr, spent);
  Answered answered;
  const LabelledField field = surface.field(from_vertices({5}), unreachable, Answer::automatic, answered);
  EXPECT_EQ(answered.by, Answer::exact);
  EXPECT_NE(answered.remark.find("an index takes lengths between"), std::string::npos);
  EXPECT_EQ(field.distance, exact_distance_field(mesh, std::vector<Index>{5}));
}

TEST(Surface, FieldsErrNoMoreInTheMeanThanIsExpectedOfThem) {
  const test::Shape plane = test::plane_grid(60, 50, 3.0, 2.5, 0.3);
  const auto mesh = test::make_mesh(plane.soup);
  Surface surface(mesh);
  for (const Answer by : {Answer::exact, Answer::index, Answer::quick}) {
    Answered answered;
    const LabelledField field = surface.field(from_vertices({1234}), unreachable, by, answered);
    double sum = 0.0;
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const double straight = plane.vertex_distance(1234, v);
      if (straight > 0.0) sum += std::abs(field.distance[v] / straight - 1.0);
    }
    EXPECT_LE(sum / mesh->vertex_count(), answered.expected_error + 1e-13);
  }
}

TEST(Surface, NamesWhatAnswersAtOnce) {
  Surface small(test::make_mesh(test::icosphere(2)));
  EXPECT_EQ(small.at_once(true), Answer::exact);
  EXPECT_EQ(small.at_once(false), Answer::exact);
  small.build_index();
  EXPECT_EQ(small.at_once(true), Answer::index);
  EXPECT_EQ(small.at_once(false), Answer::index);
  const test::Soup plate = test::plane_grid(230, 220, 2.3, 2.2).soup;
  ASSERT_GT(static_cast<Index>(plate.positions.size()), max_vertices_at_once);
  const Surface large(test::make_mesh(plate));
  EXPECT_EQ(large.at_once(true), Answer::quick);
  EXPECT_EQ(large.at_once(false), Answer::exact);
}

TEST(Surface, AQuestionThatWaitsForABuildOfAnotherThreadCanBeCancelled) {
  const auto mesh = test::make_mesh(test::icosphere(2));
  Surface surface(mesh);
  std::latch is_building(1);
  std::latch is_cancelled(1);
  std::thread builder([&] {
    surface.build_index(
        [&](const Progress& progress) {
          is_building.count_down();
          is_cancelled.wait();
          return GeodesicIndex::build(mesh, {}, progress);
        },
        {});
  });
  is_building.wait();
  int reports = 0;
  const Progress impatient([&](double, const std::string&) { return ++reports < 3; });
  Answered answered;
  EXPECT_THROW(surface.field(from_vertices({3}), unreachable, Answer::index, answered, impatient), Cancelled);
  is_cancelled.count_down();
  builder.join();
  EXPECT_EQ(reports, 3);
  EXPECT_TRUE(surface.index());
}

// The choice between exact answers and an index costs at most twice the better of both.

TEST(RentOrBuy, CostsAtMostTwiceTheBetterChoiceForAnyNumberOfAnswers) {
  for (const double price : {4.0, 11.3, 40.0}) {
    for (int answers = 1; answers <= 200; ++answers) {
      constexpr double exact = 0.5;
      constexpr double by_index = 0.001;
      RentOrBuy choice(1000);
      double cost = 0.0;
      bool bought = false;
      for (int i = 0; i < answers; ++i) {
        if (choice.wants_price()) choice.set_price(price);
        if (!bought && choice.should_buy()) {
          bought = true;
          cost += price;
        }
        if (!bought) choice.pay(exact);
        cost += bought ? by_index : exact;
      }
      const double best = std::min(answers * exact, price + answers * by_index);
      EXPECT_LE(cost, 2.0 * best + 1e-12) << answers << " answers, price " << price;
    }
  }
}

TEST(RentOrBuy, AsksForThePriceOnceAndNotBeforeItMayBeReached) {
  RentOrBuy choice(1000000);
  for (int i = 0; i < 8; ++i) {
    EXPECT_FALSE(choice.wants_price());
    EXPECT_FALSE(choice.should_buy());
    choice.pay(2.0);
  }
  EXPECT_FALSE(
      choice.wants_price());  // 18 s with the next one, and no index of a million vertices takes 20 s
  choice.pay(2.0);
  EXPECT_TRUE(choice.wants_price());
  choice.set_price(19.0);
  EXPECT_FALSE(choice.wants_price());
  EXPECT_TRUE(choice.should_buy());  // 18 s and one more of 2 s
  EXPECT_EQ(choice.rent(), 18.0);
  RentOrBuy slow(10);
  slow.pay(100.0);
  EXPECT_FALSE(slow.wants_price());  // one slow answer
}

TEST(RentOrBuy, AsksSoonerWhereFewAnswersTakeAsLongAsAnIndexOftenDoes) {
  RentOrBuy choice(1000000);
  choice.pay(30.0);
  EXPECT_FALSE(choice.wants_price());  // one may be slow by chance
  choice.pay(30.0);
  EXPECT_TRUE(choice.wants_price());  // 90 s with the next one
}

TEST(RentOrBuy, NeverBuysWhatCannotBeHad) {
  RentOrBuy choice(10);
  for (int i = 0; i < 10; ++i) choice.pay(1e6);
  EXPECT_TRUE(choice.wants_price());
  choice.give_up();
  EXPECT_FALSE(choice.wants_price());
  choice.pay(1e6);
  EXPECT_FALSE(choice.should_buy());
}

}  // namespace
}  // namespace vorogeo
