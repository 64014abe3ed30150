// Answers depend neither on the number of threads, nor on what was asked before, nor on what other threads
// ask of the same surface meanwhile, to the last bit.
#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "contract/surfaces.h"
#include "support/hostile_meshes.h"

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

Numbers numbers_of(const std::vector<SurfacePoint>& points) {
  Numbers numbers;
  for (const SurfacePoint& p : points) {
    numbers.insert(numbers.end(), {double(p.vertex), double(p.face)});
    numbers.insert(numbers.end(), p.barycentric.begin(), p.barycentric.end());
  }
  return numbers;
}

struct Question {
  const char* name;
  std::function<Numbers(const Ask&, By)> answer;
};

/// Every kind of question and task, about some points of a surface and distances of the order of `reach`.
std::vector<Question> questions_about(const std::vector<SurfacePoint>& points, double reach) {
  const std::vector<SurfacePoint> few(points.begin(), points.begin() + 3);
  return {{"field",
           [=](const Ask& ask, By by) {
             const Field field = ask.field({{points[3]}, {points[5], 0.5 * reach}}, by);
             return all_of(field.distance, field.source);
           }},
          {"field with a limit",
           [=](const Ask& ask, By by) { return ask.field({{points[1]}}, by, reach).distance; }},
          {"distances",
           [=](const Ask& ask, By by) {
             Numbers distances;
             for (const SurfacePoint& p : points) distances.push_back(ask.distance(points[2], p, by));
             return distances;
           }},
          {"path",
           [=](const Ask& ask, By by) {
             const Path path = ask.path(points[0], points[4], by);
             return all_of(Numbers{path.length()}, numbers_of(path.line.points));
           }},
          {"exact path",
           [=](const Ask& ask, By by) {
             const Path path = ask.exact_path(points[1], points[6], by);
             return all_of(Numbers{path.length(), double(path.certified)}, numbers_of(path.line.points));
           }},
          {"matrix", [=](const Ask& ask, By by) { return ask.matrix(points, by); }},
          {"pairs within",
           [=](const Ask& ask, By by) {
             const Sparse pairs = ask.pairs_within(vertices_of(ask), 0.5 * reach, by);
             return all_of(pairs.column, pairs.distance);
           }},
          {"nearest",
           [=](const Ask& ask, By by) {
             const Nearest nearest = ask.nearest(points, vertices_of(ask), 3, by);
             return all_of(nearest.position, nearest.distance);
           }},
          {"regions",
           [=](const Ask& ask, By by) {
             const Regions found = ask.regions(points, by);
             return all_of(found.vertex_region, found.area, coordinates(found.borders.points));
           }},
          {"isolines",
           [=](const Ask& ask, By by) {
             const Isolines lines = ask.isolines(ask.field({{points[2]}}, by).distance, {0.3 * reach, reach});
             return all_of(coordinates(lines.lines.points), lines.level_of_segment);
           }},
          {"disk",
           [=](const Ask& ask, By by) {
             const Disk disk = ask.disk(few, reach, by);
             return all_of(disk.vertices, disk.distance, disk.faces);
           }},
          {"distances of two sets",
           [=](const Ask& ask, By by) {
             const SetDistances found = ask.set_distances(few, points, by);
             return Numbers{found.nearest, found.mean, found.hausdorff};
           }},
          {"extent",
           [=](const Ask& ask, By by) {
             const Extent extent = ask.extent(points[3].vertex, 8, by);
             return Numbers{extent.diameter.lower, extent.diameter.upper, extent.radius.lower,
                            extent.radius.upper, double(extent.centre)};
           }},
          {"farthest points",
           [](const Ask& ask, By by) {
             return all_of(PointList(ask.farthest_points(30, 0.0, {}, by, 5).points).vertices());
           }},
          {"Poisson disks", [=](const Ask& ask, By by) { return all_of(ask.poisson_disk(reach, by, 5)); }},
          {"relaxed points", [](const Ask& ask, By by) {
             return all_of(PointList(ask.relaxed(vertices({0, 1, 2}), 4, by).points).vertices());
           }}};
}

TEST(ThreadsContract, AnswersDependOnNeitherThreadsNorEarlierQuestions) {
  const test::Soup soup = test::hills(24, 0.2);
  const std::vector<Question> questions = questions_about(test::spread_points(soup), 0.2);
  const Ask one(soup, {.patches = 3, .patches_in_each = 3, .threads = 1});
  const Ask three(soup, {.patches = 3, .patches_in_each = 3, .threads = 3});
  for (const By by : {By::exact, By::index}) {
    std::vector<Numbers> before;
    for (const Question& question : questions) before.push_back(question.answer(one, by));
    for (std::size_t i = questions.size(); i-- > 0;) {
      SCOPED_TRACE(questions[i].name + std::string(", ") + to_string(by));
      EXPECT_EQ(questions[i].answer(one, by), before[i]);
      EXPECT_EQ(questions[i].answer(three, by), before[i]);
    }
  }
  const Question& field = questions.front();
  EXPECT_EQ(field.answer(one, By::quick), field.answer(three, By::quick));
}

/// An answer, or the sentence with which it is refused.
struct Outcome {
  Numbers numbers;
  std::string refused;
  bool operator==(const Outcome&) const = default;
};

Outcome outcome_of(const Question& question, const Ask& ask, By by) {
  Outcome outcome;
  outcome.refused = refusal([&] { outcome.numbers = question.answer(ask, by); });
  return outcome;
}

TEST(ThreadsContract, SeveralThreadsMayAskOneSurfaceEverythingAtATime) {
  // Defects may add many vertices, and needles make a build of these take seconds.
  constexpr std::size_t most_vertices = 60;
  unsigned seed = test::first_edited_seed + fresh_seed() % 294'000'000;
  test::Soup soup;
  do {
    soup = test::hostile_mesh(++seed, 25).soup;
  } while (soup.positions.size() > most_vertices || soup.faces.empty());
  SCOPED_TRACE("hostile_mesh(" + std::to_string(seed) + ", 25)");
  // Vertices of faces, since of some meshes few are, and a middle.
  std::vector<SurfacePoint> points{SurfacePoint::in_face(0, {0.25, 0.25, 0.5})};
  for (std::size_t i = 0; i < 7; ++i) points.push_back(vertex(soup.faces[i * soup.faces.size() / 7][0]));
  std::vector<double> straight;
  for (const Point& p : soup.positions) straight.push_back(distance_between(p, position(soup, points[1])));
  std::ranges::sort(straight);
  const std::vector<Question> questions = questions_about(points, 0.5 * straight[straight.size() / 2]);

  struct Asked {
    const Question* question;
    By by;
    Outcome expected;
  };
  const Build build{.patches = 2, .patches_in_each = 2, .threads = 2};
  std::vector<Asked> list;
  {
    const Ask alone(soup, build);
    for (const By by : {By::exact, By::quick, By::index}) {
      for (const Question& question : questions)
        list.push_back({&question, by, outcome_of(question, alone, by)});
    }
  }
  // Each thread begins elsewhere in the list; whoever first needs the index builds it.
  const Ask shared(soup, build);
  constexpr std::size_t thread_count = 3;
  std::vector<std::vector<Outcome>> outcomes(thread_count, std::vector<Outcome>(list.size()));
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < thread_count; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = 0; i < list.size(); ++i) {
        const std::size_t at = (i * 5 + t * list.size() / thread_count) % list.size();
        outcomes[t][at] = outcome_of(*list[at].question, shared, list[at].by);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < list.size(); ++i) {
    for (std::size_t t = 0; t < thread_count; ++t) {
      EXPECT_TRUE(outcomes[t][i] == list[i].expected)
          << list[i].question->name << ", " << to_string(list[i].by) << ", thread " << t << ": "
          << outcomes[t][i].refused << " instead of " << list[i].expected.refused;
    }
  }
}

}  // namespace
}  // namespace vorogeo::contract
