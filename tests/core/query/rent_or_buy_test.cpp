// The choice between exact answers and an index costs at most twice the better of both.
#include "query/rent_or_buy.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vorogeo {
namespace {

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
