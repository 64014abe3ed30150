// Answers depend neither on the number of threads nor on what was asked before, to the last bit.
#include <gtest/gtest.h>

#include <functional>

#include "contract/surfaces.h"

namespace vorogeo::contract {
namespace {

using Numbers = std::vector<double>;

/// Concatenates lists of any kind of number.
template <class... Lists>
Numbers all_of(const Lists&... lists) {
  Numbers numbers;
  (numbers.insert(numbers.end(), lists.begin(), lists.end()), ...);
  return numbers;
}

Numbers coordinates(const std::vector<Point>& points) {
  Numbers numbers;
  for (const Point& p : points) numbers.insert(numbers.end(), p.begin(), p.end());
  return numbers;
}

struct Question {
  const char* name;
  std::function<Numbers(const Ask&, By)> answer;
};

const std::vector<Question>& questions() {
  static const std::vector<SurfacePoint> points = test::spread_points(test::hills(24, 0.2));
  static const std::vector<Question> all{
      {"field",
       [](const Ask& ask, By by) {
         const Field field = ask.field({{points[3]}, {points[5], 0.1}}, by);
         return all_of(field.distance, field.source);
       }},
      {"distances",
       [](const Ask& ask, By by) {
         Numbers distances;
         for (const SurfacePoint& p : points) distances.push_back(ask.distance(points[2], p, by));
         return distances;
       }},
      {"matrix", [](const Ask& ask, By by) { return ask.matrix(points, by); }},
      {"pairs within",
       [](const Ask& ask, By by) {
         const Sparse pairs = ask.pairs_within(vertices_of(ask), 0.1, by);
         return all_of(pairs.column, pairs.distance);
       }},
      {"nearest",
       [](const Ask& ask, By by) {
         const Nearest nearest = ask.nearest(points, vertices_of(ask), 3, by);
         return all_of(nearest.position, nearest.distance);
       }},
      {"regions",
       [](const Ask& ask, By by) {
         const Regions found = ask.regions(points, by);
         return all_of(found.vertex_region, found.area, coordinates(found.borders.points));
       }},
      {"farthest points",
       [](const Ask& ask, By by) {
         return all_of(PointList(ask.farthest_points(30, 0.0, {}, by, 5).points).vertices());
       }},
      {"Poisson disks", [](const Ask& ask, By by) { return all_of(ask.poisson_disk(0.2, by, 5)); }},
      {"relaxed points", [](const Ask& ask, By by) {
         return all_of(PointList(ask.relaxed(vertices({0, 1, 2}), 4, by).points).vertices());
       }}};
  return all;
}

TEST(ThreadsContract, AnswersDependOnNeitherThreadsNorEarlierQuestions) {
  const test::Soup soup = test::hills(24, 0.2);
  const Ask one(soup, {.patches = 3, .patches_in_each = 3, .threads = 1});
  const Ask three(soup, {.patches = 3, .patches_in_each = 3, .threads = 3});
  for (const By by : {By::exact, By::index}) {
    std::vector<Numbers> before;
    for (const Question& question : questions()) before.push_back(question.answer(one, by));
    for (std::size_t i = questions().size(); i-- > 0;) {
      SCOPED_TRACE(questions()[i].name + std::string(", ") + to_string(by));
      EXPECT_EQ(questions()[i].answer(one, by), before[i]);
      EXPECT_EQ(questions()[i].answer(three, by), before[i]);
    }
  }
  const Question& field = questions().front();
  EXPECT_EQ(field.answer(one, By::quick), field.answer(three, By::quick));
}

}  // namespace
}  // namespace vorogeo::contract
