// The table of methods and their comparison.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "methods/method.h"
#include "methods/method_comparison.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/methods.h"
#include "support/refusal.h"

namespace vorogeo {
namespace {

// The table of methods: every method on every kind of mesh, and what is refused.

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
  struct Refused {
    const char* method;
    MethodOptions options;
    const char* sentence;
  };
  for (const auto& [method, options, sentence] : std::vector<Refused>{
           {"walking", {}, "walking is not known; give one of vorogeo"},
           {"mmp", {{"eps", 1.0}}, "The method mmp has no option eps; it has none."},
           {"ammp", {{"K", 1.0}}, "The method ammp has no option K; it has eps."},
           {"ammp", {{"eps", -1.0}}, "The option eps of the method ammp is -1; give a number from 0 to 0.1."},
           {"heat", {{"delaunay", 0.5}}, "give a whole number"},
           {"heat", {{"time_step", std::nan("")}}, "is nan; give a number"}}) {
    const std::string refusal = test::refusal([&] { prepare_method(method, mesh, options, {}); });
    EXPECT_NE(refusal.find(sentence), std::string::npos) << refusal;
  }
}

// A sphere of radius 1 and a far one, an isolated vertex, repeated, flipped and zero-area faces.
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
  const auto mesh = test::make_mesh(test::icosphere(2));
  const auto large = test::make_mesh(test::scaled(test::icosphere(2), 1024.0));
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
    const auto field = prepared->field(source);
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

// The table of methods: what is read, what is measured, and how it is written.

TEST(MethodComparison, ReadsNamesAndOptions) {
  const auto requests = parse_methods(" mmp,svg( K = 20 ) , heat(delaunay=1,time_step=2.5)");
  ASSERT_EQ(requests.size(), 3u);
  EXPECT_EQ(requests[0].text(), "mmp");
  EXPECT_EQ(requests[1].text(), "svg(K=20)");
  EXPECT_EQ(requests[2].options, (MethodOptions{{"delaunay", 1.0}, {"time_step", 2.5}}));
  const auto all = parse_methods("all");
  EXPECT_EQ(all.size() + 1, all_methods().size());  // ch warns
}

TEST(MethodComparison, RefusesWhatCannotBeRead) {
  for (const char* text : {"", "mmp,", "svg(K)", "svg(K=)", "svg(K=5", "svg(K=5) mmp", "svg(K=many)",
                           "mmp;svg", "svg(K=1)", "walking", "mmp(eps=1)", ")("}) {
    EXPECT_THROW(parse_methods(text), InvalidInput) << text;
  }
}

TEST(MethodComparison, AMethodWithAGapOfItsOwnTakesThatOfTheMeshUnlessToldAnother) {
  EXPECT_EQ(with_gap({"campen_kobbelt", {}, false}, {0.5}).options, (MethodOptions{{"gap", 0.5}}));
  EXPECT_EQ(with_gap({"campen_kobbelt", {{"gap", 2.0}}, false}, {0.5}).options,
            (MethodOptions{{"gap", 2.0}}));
  EXPECT_TRUE(with_gap({"campen_kobbelt", {}, false}, {}).options.empty());
  EXPECT_TRUE(with_gap({"fast_marching", {}, false}, {0.5}).options.empty());
}

TEST(MethodComparison, MeasuresWhatTheMethodsDo) {
  const auto mesh = test::make_mesh(test::with_isolated_vertex(test::icosphere(3), {5, 5, 5}));
  const auto sources = spread_vertices(*mesh, 3);
  EXPECT_EQ(sources, (std::vector<Index>{0, 214, 428}));
  const auto measures = compare_methods(mesh, parse_methods("mmp, dijkstra, gsp"), sources, {});
  ASSERT_EQ(measures.size(), 3u);
  EXPECT_EQ(measures[0].compared, 3 * 641);
  EXPECT_EQ(measures[0].max_error, 0.0);
  EXPECT_GT(measures[0].pair_seconds, 0.0);
  EXPECT_TRUE(std::isnan(measures[2].pair_seconds));
  double mean = 0.0;
  for (Index source : sources) mean += test::errors_against_exact("dijkstra", mesh, source).mean / 3.0;
  EXPECT_NEAR(measures[1].mean_error, mean, 1e-12);
  EXPECT_LE(measures[1].mean_error, measures[1].p99_error);
  EXPECT_LE(measures[1].p99_error, measures[1].max_error);
}

TEST(MethodComparison, OfAllMethodsOnesThatRefuseTheMeshAreLeftOut) {
  // More components than GTU takes samples.
  test::Soup triangles;
  for (Index i = 0; i < 120; ++i) {
    triangles.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    for (const Point& corner : {Point{0, 0, 0}, Point{1, 0, 0}, Point{0, 1, 0}}) {
      triangles.positions.push_back({corner[0] + 2.0 * i, corner[1], corner[2]});
    }
  }
  const auto mesh = test::make_mesh(triangles);
  std::vector<std::string> warnings;
  const Progress progress({}, [&](const std::string& sentence) {
    warnings.push_back(sentence);
    return true;
  });
  auto all = parse_methods("all");
  std::erase_if(all, [](const MethodRequest& one) { return one.name != "gtu" && one.name != "dijkstra"; });
  const auto measures = compare_methods(mesh, all, {0}, progress);
  ASSERT_EQ(measures.size(), 1u);
  EXPECT_EQ(measures[0].request.name, "dijkstra");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("gtu"), std::string::npos);
  EXPECT_THROW(compare_methods(mesh, parse_methods("dijkstra, gtu"), {0}, progress), InvalidInput);
}

TEST(MethodComparison, IsWrittenAsTextAndAsCsv) {
  MethodMeasure measure;
  measure.request = {"svg", {{"K", 20.0}}, false};
  measure.setup_seconds = 1.5;
  measure.field_seconds = 0.0125;
  measure.pair_seconds = std::nan("");
  measure.bytes = 2500000;
  measure.mean_error = 0.0022;
  measure.p99_error = 0.01;
  measure.max_error = 0.025;
  const std::string text = comparison_text({measure});
  EXPECT_NE(text.find("1.5 s   12.5 ms  -     2.5 MB  0.22 %  1 %   2.5 %\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("method"), 0u);
  const std::string csv = comparison_csv({measure});
  EXPECT_NE(csv.find("\r\n\"svg(K=20)\",\"MSAD, SSSD\",\"graph of K n arcs\","), std::string::npos) << csv;
  EXPECT_NE(csv.find(",1.5,0.0125,,2500000,0.0022,0.01,0.025\r\n"), std::string::npos) << csv;
}

// The index as a method.

TEST(VorogeoMethod, IsTheIndex) {
  const test::Soup soup = test::icosphere(4);
  const auto mesh = test::make_mesh(soup);
  const auto errors = test::errors_against_exact("vorogeo", mesh, 100);
  EXPECT_LT(errors.mean, 5e-4);
  EXPECT_GT(errors.mean, 0.0);
  const auto method = prepare_method("vorogeo", mesh, {}, {});
  EXPECT_EQ(method->bytes(), static_cast<std::size_t>(test::make_index(soup)->statistics().bytes));
}

}  // namespace
}  // namespace vorogeo
