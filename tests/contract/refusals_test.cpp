// Refusals: a question that has no answer gets a sentence that names the element and what would be accepted.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "contract/surfaces.h"
#include "support/gaps.h"

namespace vorogeo::contract {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A question, and the words that the sentence of its refusal must contain.
struct Refused {
  std::string name;
  std::function<void()> question;
  std::vector<std::string> names;
};

void expect_refused(const std::vector<Refused>& all) {
  for (const Refused& one : all) {
    const std::string sentence = refusal(one.question);
    for (const std::string& word : one.names) {
      EXPECT_TRUE(sentence.find(word) != std::string::npos)
          << one.name << ": no " << word << " in: " << sentence;
    }
    EXPECT_TRUE(sentence.ends_with('.')) << one.name << ": " << sentence;
  }
}

const test::Soup sphere = test::icosphere(1);  // 42 vertices, 80 faces

const Ask& surface() {
  static const Ask ask(sphere, {.patches = 2, .patches_in_each = 2});
  return ask;
}

/// Points that are not on the sphere, and what is wrong with them.
const std::vector<std::pair<SurfacePoint, std::vector<std::string>>>& bad_points() {
  static const std::vector<std::pair<SurfacePoint, std::vector<std::string>>> all{
      {vertex(42), {"42", "0 to 41"}},
      {vertex(-7), {"-7", "0 to 41"}},
      {SurfacePoint::in_face(80, {0.2, 0.3, 0.5}), {"80", "0 to 79"}},
      {SurfacePoint::in_face(3, {0.5, 0.6, 0.5}), {"3", "0.6"}},
      {SurfacePoint::in_face(3, {1.5, -0.5, 0.0}), {"3", "-0.5"}},
      {SurfacePoint::in_face(3, {0.5, no_number, 0.5}), {"3", "nan"}},
      {SurfacePoint{}, {}}};
  return all;
}

TEST(RefusalsContract, PointsThatAreNotOnTheMeshAreNamedInEveryQuestion) {
  const SurfacePoint good = vertex(3);
  for (const auto& bad : bad_points()) {
    const SurfacePoint& point = bad.first;
    std::vector<Refused> all;
    for (const By by : {By::exact, By::index, By::quick}) {
      const std::string how = std::string(", ") + to_string(by);
      all.push_back({"field" + how, [=] { surface().field({{good}, {point}}, by); }, bad.second});
      if (by == By::quick) continue;
      auto add = [&](const std::string& name, std::function<void()> question) {
        all.push_back({name + how, std::move(question), bad.second});
      };
      add("distance from", [=] { surface().distance(point, good, by); });
      add("distance to", [=] { surface().distance(good, point, by); });
      add("path from", [=] { surface().path(point, good, by); });
      add("path to", [=] { surface().exact_path(good, point, by); });
      add("matrix, rows", [=] { surface().matrix({good, point}, {good}, by); });
      add("matrix, columns", [=] { surface().matrix({good}, {good, point}, by); });
      add("pairs within", [=] { surface().pairs_within({good, point}, 1.0, by); });
      add("nearest of", [=] { surface().nearest({point}, {good}, 1, by); });
      add("nearest to", [=] { surface().nearest({good}, {point}, 1, by); });
      add("regions", [=] { surface().regions({good, point}, by); });
      add("farthest points", [=] { surface().farthest_points(5, 0.0, {point}, by); });
      add("relaxed points", [=] { surface().relaxed({good, point}, 1, by); });
      add("eccentricities", [=] { surface().eccentricities({point}, by); });
      add("disk", [=] { surface().disk({point}, 1.0, by); });
      add("band", [=] { surface().band({good, point}, 1.0, by); });
      add("sets", [=] { surface().set_distances({good}, {good, point}, by); });
      add("polygon", [=] { surface().polygon({good, vertex(9), point}, by); });
    }
    expect_refused(all);
  }
}

TEST(RefusalsContract, NumbersThatMakeNoSenseAreNamed) {
  std::vector<Refused> all;
  const SurfacePoint a = vertex(3);
  for (const By by : {By::exact, By::index, By::quick}) {
    const std::string how = std::string(", ") + to_string(by);
    all.push_back({"no source" + how, [=] { surface().field({}, by); }, {"no source"}});
    all.push_back({"offset" + how,
                   [=] {
                     surface().field({{a}, {a, -0.5}}, by);
                   },
                   {"Source 1", "offset -0.5"}});
    all.push_back({"offset" + how, [=] { surface().field({{a, no_number}}, by); }, {"offset nan"}});
    all.push_back({"offset" + how, [=] { surface().field({{a, unreachable}}, by); }, {"offset inf"}});
    all.push_back({"limit" + how, [=] { surface().field({{a}}, by, -1.5); }, {"-1.5"}});
    all.push_back({"limit" + how, [=] { surface().field({{a}}, by, no_number); }, {"nan"}});
  }
  for (const By by : {By::exact, By::index}) {
    all.push_back({"radius", [=] { surface().pairs_within({a}, -1.0, by); }, {"radius", "-1"}});
    all.push_back({"radius", [=] { surface().pairs_within({a}, no_number, by); }, {"radius", "nan"}});
    all.push_back({"radius", [=] { surface().disk({a}, -1.0, by); }, {"radius", "-1"}});
    all.push_back({"radius", [=] { surface().poisson_disk(0.0, by); }, {"radius", "0"}});
    all.push_back({"radius", [=] { surface().poisson_disk(unreachable, by); }, {"radius", "inf"}});
    all.push_back(
        {"no stop", [=] { surface().farthest_points(0, 0.0, {}, by); }, {"number of samples", "radius"}});
    all.push_back({"no site", [=] { surface().regions({}, by); }, {"no point"}});
    all.push_back({"no point", [=] { surface().relaxed({}, 3, by); }, {"no point"}});
    all.push_back({"no point", [=] { surface().disk({}, 1.0, by); }, {"no point"}});
    all.push_back({"rounds", [=] { surface().relaxed({a}, -1, by); }, {"rounds"}});
    all.push_back({"fields", [=] { surface().extent(3, 1, by); }, {"2 fields"}});
    all.push_back({"start", [=] { surface().extent(42, 9, by); }, {"42", "0 to 41"}});
  }
  all.push_back({"values", [] { surface().isolines({1.0, 2.0}, {0.5}); }, {"2 values", "42"}});
  all.push_back({"level",
                 [] {
                   surface().isolines(std::vector<double>(42, 1.0), {0.5, no_number});
                 },
                 {"Level 1", "nan"}});
  expect_refused(all);
}

TEST(RefusalsContract, QuickAnswersAreFieldsInMetricsThatDoNotJump) {
  std::vector<double> costs(80, 2.0);
  costs[3] = 1.0;
  const Ask jumping({sphere, FaceCost{costs}});
  expect_refused(
      {{"distance", [] { surface().distance(vertex(3), vertex(5), By::quick); }, {"quick", "fields"}},
       {"path", [] { surface().path(vertex(3), vertex(5), By::quick); }, {"quick", "fields"}},
       {"field", [&] { jumping.field({{vertex(3)}}, By::quick); }, {"jump"}}});
}

TEST(RefusalsContract, WhereTheMetricBarsEveryFaceThereIsNothingToSampleAndNothingIsReached) {
  const FaceCost bars{std::vector<double>(sphere.faces.size(), unreachable)};
  test::Soup halves = test::two_plates(6, 7, 0.01).soup;
  const FaceCost bars_halves{std::vector<double>(halves.faces.size(), unreachable)};
  for (const Ask& ask : {Ask({sphere, bars}), Ask({halves, bars_halves, 0.02})}) {
    expect_refused(
        {{"farthest points", [&] { ask.farthest_points(3, 0.0, {}, By::exact); }, {"nothing to sample"}},
         {"Poisson disk", [&] { ask.poisson_disk(0.3, By::exact); }, {"nothing to sample"}}});
    EXPECT_EQ(ask.distance(vertex(0), vertex(1), By::exact), unreachable);
    EXPECT_EQ(ask.disk({vertex(5)}, 1.0, By::exact).vertices, (std::vector<Index>{5}));
    EXPECT_EQ(ask.band({vertex(5)}, 1.0, By::exact).area, 0.0);
  }
}

TEST(RefusalsContract, MeshesThatAreNoneNameTheVertexOrFace) {
  auto with = [](const std::function<void(test::Soup&)>& change) {
    return [change] {
      test::Soup soup = sphere;
      change(soup);
      const Ask ask(soup);
    };
  };
  expect_refused(
      {{"face", with([](test::Soup& soup) { soup.faces[7][1] = 42; }), {"Face 7", "42", "0 to 41"}},
       {"face", with([](test::Soup& soup) { soup.faces[7][1] = -1; }), {"Face 7", "-1", "0 to 41"}},
       {"position", with([](test::Soup& soup) { soup.positions[9][2] = no_number; }), {"Vertex 9"}},
       {"position", with([](test::Soup& soup) { soup.positions[9][0] = unreachable; }), {"Vertex 9"}}});
}

TEST(RefusalsContract, MetricsThatAreNoneNameTheVertexOrFace) {
  const std::vector<double> ones(80, 1.0);
  const std::vector<Tensor> unit(80, Tensor{1, 0, 0, 0, 1, 0, 0, 0, 1});
  auto measured = [](Metric metric, double gap = 0.0) {
    return [input = Input{sphere, std::move(metric), gap}] { const Ask ask(input); };
  };
  auto costs = [&](std::size_t count, std::size_t at, double value) {
    std::vector<double> cost(ones.begin(), ones.begin() + static_cast<std::ptrdiff_t>(count));
    cost[at] = value;
    return cost;
  };
  auto tensors = [&](std::size_t count, std::size_t at, std::size_t entry, double value) {
    std::vector<Tensor> tensor(unit.begin(), unit.begin() + static_cast<std::ptrdiff_t>(count));
    tensor[at][entry] = value;
    return tensor;
  };
  auto lengths = [](double value) {
    SideLengths sides = sides_of(sphere, 1.0);
    sides[6][1] = value;
    return EdgeLengths{sides};
  };
  std::vector<Refused> all;
  for (const double bad : {0.0, -2.0, no_number}) {
    all.push_back({"cost", measured(VertexCost{costs(42, 17, bad)}), {"ertex 17"}});
    all.push_back({"cost", measured(FaceCost{costs(80, 17, bad)}), {"ace 17"}});
  }
  for (const double bad : {no_number, 3.0}) {  // not finite, not symmetric
    all.push_back({"tensor", measured(VertexTensor{tensors(42, 17, 1, bad)}), {"ertex 17"}});
    all.push_back({"tensor", measured(FaceTensor{tensors(80, 17, 1, bad)}), {"ace 17"}});
  }
  all.push_back({"count", measured(VertexCost{ones}), {"80", "42"}});
  all.push_back({"count", measured(FaceCost{costs(42, 0, 1.0)}), {"42", "80"}});
  all.push_back({"count", measured(VertexTensor{unit}), {"80", "42"}});
  for (const double bad : {-1.0, no_number, unreachable, 100.0}) {
    all.push_back({"length", measured(lengths(bad)), {"ace"}});
  }
  all.push_back({"gap", measured({}, -1.0), {"gap", "-1"}});
  all.push_back({"gap", measured({}, no_number), {"gap", "nan"}});
  test::Soup nowhere = sphere;
  std::ranges::fill(nowhere.positions, no_position);
  const Input unplaced{nowhere, EdgeLengths{sides_of(sphere, 1.0)}, 0.1};
  all.push_back({"gap", [=] { const Ask ask(unplaced); }, {"Gaps", "no positions"}});
  expect_refused(all);
}

TEST(RefusalsContract, AnIndexOfNothingOrOfImpossibleSettingsIsRefused) {
  auto built = [](const test::Soup& soup, const Build& build) {
    return [=] { Ask(soup, build).field({{vertex(0)}}, By::index); };
  };
  expect_refused({{"no face", built({{{0, 0, 0}, {1, 0, 0}}, {}}, {}), {"face"}},
                  {"patches", built(sphere, {.patches = -1}), {"patches"}},
                  {"patches", built(sphere, {.patches_in_each = -1}), {"patches"}},
                  {"delta", built(sphere, {.delta = 1.5}), {"1.5"}},
                  {"delta", built(sphere, {.delta = no_number}), {"nan"}}});
}

TEST(RefusalsContract, AfterARefusalTheNextQuestionIsAnswered) {
  for (const By by : {By::exact, By::index, By::quick}) {
    const Field before = surface().field({{vertex(3)}}, by);
    EXPECT_NE(refusal([&] { surface().field({{vertex(42)}}, by); }), "");
    EXPECT_EQ(surface().field({{vertex(3)}}, by).distance, before.distance) << to_string(by);
  }
}

}  // namespace
}  // namespace vorogeo::contract
