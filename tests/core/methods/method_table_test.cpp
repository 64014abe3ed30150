// The table of methods: every method on every kind of mesh, and what is refused.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "methods/method.h"
#include "support/error.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(MethodTable, NamesAreDifferentAndEveryMethodSaysWhatItClaims) {
  std::set<std::string> names;
  for (const MethodEntry& entry : all_methods()) {
    const MethodInfo& info = entry.info;
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    for (const std::string& text : {info.title, info.paper, info.claims.sources, info.claims.reuse,
                                    info.claims.bound, info.claims.metrics, info.claims.growth}) {
      EXPECT_FALSE(text.empty()) << info.name;
    }
    for (const MethodOption& option : info.options) {
      EXPECT_LE(option.least, option.standard) << info.name << " " << option.name;
      EXPECT_LE(option.standard, option.greatest) << info.name << " " << option.name;
    }
  }
}

TEST(MethodTable, RefusesUnknownNamesOptionsAndValues) {
  const auto mesh = test::make_mesh(test::icosphere(1));
  EXPECT_NE(refusal([&] {
              prepare_method("walking", mesh, {}, {});
            }).find("walking is not known; give one of vorogeo"),
            std::string::npos);
  EXPECT_EQ(refusal([&] {
              prepare_method("mmp", mesh, {{"eps", 1.0}}, {});
            }),
            "The method mmp has no option eps; it has none.");
  EXPECT_EQ(refusal([&] {
              prepare_method("ammp", mesh, {{"K", 1.0}}, {});
            }),
            "The method ammp has no option K; it has eps.");
  EXPECT_EQ(refusal([&] {
              prepare_method("ammp", mesh, {{"eps", -1.0}}, {});
            }),
            "The option eps of the method ammp is -1; give a number from 0 to 0.1.");
  EXPECT_NE(refusal([&] {
              prepare_method("heat", mesh, {{"delaunay", 0.5}}, {});
            }).find("give a whole number"),
            std::string::npos);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal([&] {
              prepare_method("heat", mesh, {{"time_step", nan}}, {});
            }).find("is nan; give a number"),
            std::string::npos);
}

// A sphere of radius 1 and a far one, a stray vertex, faces that come twice or lie on their side.
test::Soup hurt_spheres() {
  test::Soup far = test::icosphere(2);
  for (Point& point : far.positions) point[0] += 10.0;
  test::Soup soup = test::two_components(test::icosphere(2), far);
  soup = test::with_isolated_vertex(soup, {5.0, 5.0, 5.0});
  soup = test::with_duplicate_face(soup, 7);
  soup = test::with_zero_area_cap(soup, 30, 1);
  return test::with_flipped_faces(soup, 5);
}

TEST(MethodTable, EveryMethodTakesComponentsAndDefects) {
  const test::Soup soup = hurt_spheres();
  const auto mesh = test::make_mesh(soup);
  const auto exact = exact_distance_field(mesh, std::vector<Index>{3, 50});
  for (const MethodEntry& entry : all_methods()) {
    const auto field = test::method_field(entry.info.name, mesh, {3, 50, 3});
    ASSERT_EQ(field.size(), exact.size());
    double mean = 0.0;
    for (std::size_t v = 0; v < exact.size(); ++v) {
      EXPECT_EQ(std::isfinite(field[v]), std::isfinite(exact[v])) << entry.info.name << " " << v;
      if (std::isfinite(exact[v])) mean += std::abs(field[v] - exact[v]) / 162.0;
    }
    EXPECT_LT(mean, 0.15) << entry.info.name;  // of distances up to pi
  }
}

TEST(MethodTable, EveryMethodScalesWithTheMesh) {
  test::Soup soup = test::icosphere(2);
  const auto mesh = test::make_mesh(soup);
  for (Point& point : soup.positions) {
    for (double& coordinate : point) coordinate *= 1024.0;
  }
  const auto large = test::make_mesh(soup);
  for (const MethodEntry& entry : all_methods()) {
    const auto small_field = test::method_field(entry.info.name, mesh, {9});
    const auto large_field = test::method_field(entry.info.name, large, {9});
    for (std::size_t v = 0; v < small_field.size(); ++v) {
      ASSERT_NEAR(large_field[v], 1024.0 * small_field[v], 1e-6) << entry.info.name << " " << v;
    }
  }
}

TEST(MethodTable, PairsAreThoseOfTheFieldsAndCountedBytesAreNotNone) {
  const auto mesh = test::make_mesh(test::icosphere(2));
  for (const MethodEntry& entry : all_methods()) {
    const auto method = entry.info.name;
    const auto prepared = prepare_method(method, mesh, {}, {});
    const std::vector<Index> source{17};
    const auto field = prepared->field(source, {});
    for (Index target : {17, 100, 161}) {
      EXPECT_NEAR(prepared->pair(17, target), field[target], 2e-3 * field[target] + 1e-12) << method;
    }
    EXPECT_GT(prepared->bytes(), 1000u) << method;
  }
}

TEST(MethodTable, EveryMethodCanBeCancelled) {
  const auto mesh = test::make_mesh(test::icosphere(4));
  const Progress cancels([](double, const std::string&) { return false; });
  for (const MethodEntry& entry : all_methods()) {
    EXPECT_THROW(
        {
          const auto method = prepare_method(entry.info.name, mesh, {}, cancels);
          for (int i = 0; i < 3; ++i) method->field(std::vector<Index>{0}, cancels);
        },
        Cancelled)
        << entry.info.name;
  }
}

}  // namespace
}  // namespace vorogeo
