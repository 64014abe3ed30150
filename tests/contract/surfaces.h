// The table of small surfaces whose distances are known from formulas, and the metrics they are measured in.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "contract/ask.h"
#include "support/indexes.h"
#include "support/near.h"
#include "support/shapes.h"

namespace vorogeo::contract {

/// A surface and the distance of any two of its points, from a formula, not from a solver.
struct KnownSurface {
  std::string name;
  test::Soup soup;
  std::function<double(const SurfacePoint&, const SurfacePoint&)> distance;
  bool has_needles = false;  ///< so thin that answers with errors of the size of a face are useless

  double distance_of(Index a, Index b) const {
    return distance(SurfacePoint::at_vertex(a), SurfacePoint::at_vertex(b));
  }
};

inline KnownSurface known(const std::string& name, const test::Shape& shape, bool has_needles = false) {
  return {name, shape.soup, shape.distance, has_needles};
}

inline SurfacePoint vertex(Index v) { return SurfacePoint::at_vertex(v); }
inline std::vector<SurfacePoint> vertices(const std::vector<Index>& numbers) {
  std::vector<SurfacePoint> points;
  for (const Index v : numbers) points.push_back(vertex(v));
  return points;
}
/// All vertices.
inline std::vector<SurfacePoint> vertices_of(const Ask& ask) {
  std::vector<SurfacePoint> points;
  for (Index v = 0; v < ask.vertex_count(); ++v) points.push_back(vertex(v));
  return points;
}

/// Whether the point is in a face, that is, no isolated vertex.
inline bool is_in_a_face(const test::Soup& soup, const SurfacePoint& point) {
  return !point.is_vertex() || std::ranges::any_of(soup.faces, [&](const std::array<Index, 3>& face) {
    return std::ranges::find(face, point.vertex) != face.end();
  });
}

inline Point position(const test::Soup& soup, const SurfacePoint& point) {
  if (point.is_vertex()) return soup.positions[point.vertex];
  Point sum{};
  for (int i = 0; i < 3; ++i) {
    const Point& corner = soup.positions[soup.faces[point.face][i]];
    for (int k = 0; k < 3; ++k) sum[k] += point.barycentric[i] * corner[k];
  }
  return sum;
}

/// A convex piece of a plane, however it is divided into faces: shortest paths are straight lines.
inline KnownSurface flat(const std::string& name, const test::Soup& soup, bool has_needles = false) {
  auto straight = [soup](const SurfacePoint& a, const SurfacePoint& b) {
    return distance_between(position(soup, a), position(soup, b));
  };
  return {name, soup, straight, has_needles};
}

/// A plane with faces that name a vertex twice, repeated, flipped and without area.
inline KnownSurface plane_of_bad_faces() {
  test::Soup soup = test::plane_grid(9, 8, 3.0, 2.0, 0.2, 4).soup;
  soup = test::with_zero_area_cap(soup, 70, 1);
  soup = test::with_repeated_vertex_face(soup, 20);
  soup = test::with_duplicate_face(soup, 50);
  return flat("plane of bad faces", test::with_flipped_faces(soup, 3));
}

/// A plane in which some vertices lie at the place of a neighbour: edges of length zero.
inline KnownSurface plane_with_collapsed_edges() {
  test::Soup soup = test::plane_grid(9, 8, 3.0, 2.0).soup;
  for (const Index v : {22, 45, 67}) soup.positions[v] = Point(soup.positions[v + 1]);
  return flat("plane with edges of length zero", soup);
}

/// [0, 4] x [0, 3] without [4/3, 8/3] x [1, 2]. The vertices in the hole remain, in no face.
inline KnownSurface plane_with_hole() {
  test::Soup soup = test::plane_grid(12, 9, 4.0, 3.0).soup;
  const Point low{4.0 / 3.0, 1.0, 0.0};
  const Point high{8.0 / 3.0, 2.0, 0.0};
  auto is_inside = [=](const Point& p) {
    return p[0] > low[0] + 1e-9 && p[0] < high[0] - 1e-9 && p[1] > low[1] + 1e-9 && p[1] < high[1] - 1e-9;
  };
  std::erase_if(soup.faces, [&](const std::array<Index, 3>& face) {
    Point middle{};
    for (const Index v : face) {
      for (int k = 0; k < 3; ++k) middle[k] += soup.positions[v][k] / 3.0;
    }
    return is_inside(middle);
  });
  auto is_open = [=](const Point& p, const Point& q) {
    double begin = 0.0;  // of the part of the segment that lies in the hole
    double end = 1.0;
    for (int k = 0; k < 2; ++k) {
      const double step = q[k] - p[k];
      if (std::abs(step) < 1e-9) {
        if (p[k] < low[k] + 1e-9 || p[k] > high[k] - 1e-9) return true;
        continue;
      }
      const auto [first, last] = std::minmax({(low[k] - p[k]) / step, (high[k] - p[k]) / step});
      begin = std::max(begin, first);
      end = std::min(end, last);
    }
    return end - begin < 1e-9;
  };
  auto distance = [=](const SurfacePoint& a, const SurfacePoint& b) {
    const Point from = position(soup, a);
    const Point to = position(soup, b);
    if (is_inside(from) || is_inside(to)) return a.vertex == b.vertex ? 0.0 : unreachable;
    // The shortest chain of free line segments over corners of the hole (Bellman-Ford).
    const std::array nodes{from, to, low, high, Point{low[0], high[1], 0.0}, Point{high[0], low[1], 0.0}};
    std::array<double, 6> shortest{0.0, unreachable, unreachable, unreachable, unreachable, unreachable};
    for (std::size_t round = 0; round < nodes.size(); ++round) {
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (std::size_t j = 0; j < nodes.size(); ++j) {
          if (!is_open(nodes[i], nodes[j])) continue;
          shortest[j] = std::min(shortest[j], shortest[i] + distance_between(nodes[i], nodes[j]));
        }
      }
    }
    return shortest[1];
  };
  return {"plane with a hole", soup, distance, false};
}

/// A plane, a box and an isolated vertex. No path leads from one to another.
inline KnownSurface several_components() {
  const test::Shape plane = test::plane_grid(7, 5, 3.0, 2.0, 0.2, 2);
  test::Shape box = test::box({1.0, 1.5, 2.0}, 3);
  for (Point& p : box.soup.positions) p[0] += 9.0;
  const auto vertices = static_cast<Index>(plane.soup.positions.size());
  const auto faces = static_cast<Index>(plane.soup.faces.size());
  test::Soup soup = test::two_components(plane.soup, box.soup);
  soup = test::with_isolated_vertex(soup, {5.0, 5.0, 5.0});
  auto distance = [=, isolated = static_cast<Index>(soup.positions.size()) - 1](SurfacePoint a,
                                                                                SurfacePoint b) {
    auto part = [&](const SurfacePoint& p) {
      if (p.vertex == isolated) return 2;
      return p.is_vertex() ? (p.vertex < vertices ? 0 : 1) : (p.face < faces ? 0 : 1);
    };
    if (part(a) != part(b)) return unreachable;
    if (part(a) == 2) return 0.0;
    if (part(a) == 0) return plane.distance(a, b);
    for (SurfacePoint* p : {&a, &b})
      (p->is_vertex() ? p->vertex : p->face) -= p->is_vertex() ? vertices : faces;
    return box.distance(a, b);
  };
  return {"plane, box and isolated vertex", soup, distance, false};
}

/// All surfaces of the contract with a formula.
inline const std::vector<KnownSurface>& known_surfaces() {
  constexpr double pi = std::numbers::pi;
  static const std::vector<KnownSurface> all{
      known("plane", test::plane_grid(11, 9, 4.0, 3.0, 0.24, 7)),
      known("long thin faces", test::plane_grid(24, 3, 1.0, 3.0, 0.2), true),
      known("prism", test::prism(7, 2, 6, 1.0, 4.0, 0.45)),
      known("sharp cone", test::cone(9, 5, 0.6 * pi, 2.0)),
      known("cone", test::cone(12, 5, 1.9 * pi, 2.0)),
      known("nearly flat cone", test::cone(12, 5, 1.99 * pi, 2.0)),
      known("nearly flat saddle", test::cone(12, 5, 2.01 * pi, 2.0)),
      known("saddle", test::cone(12, 5, 2.6 * pi, 2.0)),
      known("deep saddle", test::cone(20, 5, 4.5 * pi, 2.0)),
      known("box", test::box({1.0, 1.7, 3.1}, 4)),
      known("book of three pages", test::book_of_three_pages(5, 2.0, 1.0)),
      known("bow tie", test::bow_tie(5)),
      known("slit", test::plane_with_slit(2)),
      flat("disc of needles", test::needle_disc(90), true),
      plane_of_bad_faces(),
      plane_with_collapsed_edges(),
      plane_with_hole(),
      several_components()};
  return all;
}

/// Lengths of the sides of all faces, times `scale`.
inline SideLengths sides_of(const test::Soup& soup, double scale) {
  SideLengths sides;
  for (const auto& face : soup.faces) {
    auto side = [&](int i) {
      return scale * distance_between(soup.positions[face[(i + 1) % 3]], soup.positions[face[(i + 2) % 3]]);
    };
    sides.push_back({side(0), side(1), side(2)});
  }
  return sides;
}

/// A surface in a metric, which makes every distance `scale` times as long.
struct Case {
  std::string name;
  const KnownSurface* surface;
  double scale;
  Ask ask;

  double distance(const SurfacePoint& a, const SurfacePoint& b) const {
    return scale * surface->distance(a, b);
  }
  std::vector<SurfacePoint> points() const { return test::spread_points(surface->soup); }
  /// Relative error allowed to the distance of two points. From points that are not vertices, an index uses
  /// the corners of their faces, which are large here.
  double tolerance(By by, const SurfacePoint& a, const SurfacePoint& b) const {
    return by == By::index && !(a.is_vertex() && b.is_vertex()) ? 0.06 : tolerance(by);
  }
  /// The same for a vertex in a field.
  double tolerance(By by) const { return by == By::quick ? 0.01 : by == By::index ? 0.03 : 1e-11; }
  /// The same for the mean of many distances.
  double mean_tolerance(By by) const { return by == By::quick ? 1e-3 : by == By::index ? 2e-3 : 1e-11; }
};

/// Every known surface in every metric that multiplies all lengths; the index has several patches.
inline const std::vector<Case>& cases() {
  static const std::vector<Case> all = [] {
    constexpr double scale = 2.5;
    constexpr double square = scale * scale;
    constexpr Build several_patches{.patches = 3, .patches_in_each = 3};
    std::vector<Case> result;
    for (const KnownSurface& surface : known_surfaces()) {
      const test::Soup& soup = surface.soup;
      const Tensor tensor{square, 0, 0, 0, square, 0, 0, 0, square};
      auto add = [&](const std::string& metric, double factor, Metric values) {
        result.push_back({surface.name + " by " + metric, &surface, factor,
                          Ask({soup, std::move(values)}, several_patches)});
      };
      add("length", 1.0, {});
      add("edge lengths", scale, EdgeLengths{sides_of(soup, scale)});
      add("cost of vertices", scale, VertexCost{std::vector<double>(soup.positions.size(), scale)});
      add("tensors of vertices", scale, VertexTensor{std::vector<Tensor>(soup.positions.size(), tensor)});
      // These two take the same code: one of them for each surface.
      if (result.size() % 2 == 0) {
        add("cost of faces", scale, FaceCost{std::vector<double>(soup.faces.size(), scale)});
      } else {
        add("tensors of faces", scale, FaceTensor{std::vector<Tensor>(soup.faces.size(), tensor)});
      }
    }
    return result;
  }();
  return all;
}

using Cases = std::vector<std::reference_wrapper<const Case>>;

/// Every known surface in space.
inline Cases cases_by_length() {
  Cases result;
  for (const Case& one : cases()) {
    if (one.scale == 1.0) result.push_back(one);
  }
  return result;
}

/// Every known surface in space and in one of the other metrics, which take turns: for questions that are
/// made of many others.
inline Cases cases_in_turn() {
  Cases result = cases_by_length();
  const std::size_t metrics = cases().size() / result.size();
  for (std::size_t i = 0; i < known_surfaces().size(); ++i) {
    result.push_back(cases()[metrics * i + 1 + i % (metrics - 1)]);
  }
  return result;
}

/// `actual` is `expected` up to a relative `tolerance`; for small distances, relative to the longest edge.
inline void expect_close(double actual, double expected, double tolerance, const Ask& ask,
                         const std::string& where) {
  if (expected == unreachable || actual == unreachable) {
    EXPECT_EQ(actual, expected) << where;
    return;
  }
  EXPECT_NEAR(actual, expected, tolerance * std::max(expected, 0.01 * ask.longest_edge())) << where;
}

/// Asks a question of each case in each way of answering.
template <class Range, class Question>
void ask_each(const Range& cases, Question&& question,
              std::initializer_list<By> ways = {By::exact, By::index}) {
  for (const Case& one : cases) {
    for (const By by : ways) {
      SCOPED_TRACE(one.name + ", " + to_string(by));
      question(one, by);
    }
  }
}

/// The value of each vertex is `expected` of it up to `tolerance`.
template <class Expected>
void expect_all_close(const std::vector<double>& values, Expected&& expected, double tolerance,
                      const Ask& ask) {
  for (Index v = 0; v < ask.vertex_count(); ++v) {
    expect_close(values[v], expected(v), tolerance, ask, "vertex " + std::to_string(v));
  }
}

/// Calls `question` once for every two of the points, with a text that names them.
template <class Question>
void for_each_pair(const std::vector<SurfacePoint>& points, Question&& question) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      question(points[i], points[j], std::to_string(i) + " to " + std::to_string(j));
    }
  }
}

/// A seed for a random test, to be named with SCOPED_TRACE so that a failure can be repeated.
inline unsigned fresh_seed() { return std::random_device{}(); }

}  // namespace vorogeo::contract
