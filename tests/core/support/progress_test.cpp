// Progress: spans within spans, cancelling.
#include "support/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vorogeo {
namespace {

TEST(Progress, WithoutFunctionNothingHappens) {
  const Progress none;
  EXPECT_NO_THROW(none.report(0.5, "work"));
  EXPECT_NO_THROW(none.part(0.0, 0.5).report(1.0, "work"));
}

TEST(Progress, PartsMapIntoTheWhole) {
  std::vector<double> seen;
  std::string activity;
  const Progress whole([&](double fraction, const std::string& what) {
    seen.push_back(fraction);
    activity = what;
    return true;
  });
  whole.report(0.125, "begin");
  EXPECT_EQ(activity, "begin");
  const Progress second_half = whole.part(0.5, 1.0);
  second_half.report(0.0, "middle");
  second_half.report(0.5, "middle");
  const Progress last_eighth = second_half.part(0.75, 1.0);
  last_eighth.report(0.0, "late");
  last_eighth.report(1.0, "end");
  EXPECT_EQ(seen, (std::vector<double>{0.125, 0.5, 0.75, 0.875, 1.0}));
  EXPECT_EQ(activity, "end");
}

TEST(Progress, FalseCancels) {
  const Progress refusing([](double fraction, const std::string&) { return fraction < 0.5; });
  EXPECT_NO_THROW(refusing.report(0.25, "work"));
  EXPECT_THROW(refusing.report(0.5, "work"), Cancelled);
  EXPECT_THROW(refusing.part(0.9, 1.0).report(0.0, "work"), Cancelled);
  try {
    refusing.report(1.0, "work");
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "Cancelled: nothing was changed.");
  }
}

TEST(Progress, WarningsPassThroughPartsAndMayCancel) {
  std::vector<std::string> seen;
  const Progress whole({}, [&](const std::string& sentence) {
    seen.push_back(sentence);
    return sentence != "stop";
  });
  whole.warn("first");
  whole.part(0.25, 0.5).part(0.0, 0.1).warn("second");
  EXPECT_THROW(whole.part(0.5, 1.0).warn("stop"), Cancelled);
  EXPECT_EQ(seen, (std::vector<std::string>{"first", "second", "stop"}));
  EXPECT_NO_THROW(Progress().warn("to nobody"));
}

}  // namespace
}  // namespace vorogeo
