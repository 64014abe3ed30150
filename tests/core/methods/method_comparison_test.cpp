// The table of methods: what is read, what is measured, and how it is written.
#include "methods/method_comparison.h"

#include <gtest/gtest.h>

#include "support/error.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

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

}  // namespace
}  // namespace vorogeo
