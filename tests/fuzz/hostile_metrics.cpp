// Fields in other metrics: where a metric scales lengths, stretches space or leaves faces out, they equal
// fields of another mesh; elsewhere they keep within bounds and agree with each other.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "fuzz/hostile_case.h"
#include "mesh/one_way.h"
#include "query/surface.h"
#include "support/hostile_parts.h"

namespace vorogeo::test {

namespace {

/// Above this number of faces, only one of the laws is checked on a mesh.
constexpr Index few_faces = 500;

/// Where a metric varies, distances are checked only if the height of every face is a greater part of its
/// longest side than this: beside flatter faces, waves between points are off by more. With costs at
/// vertices, exact runs may not end there, and with winds, points on edges are reached many times.
constexpr double flattest_face = 1e-3;

/// How far fields by points on edges may exceed the bounds given by costs, relative: their errors add up.
constexpr double greatest_excess = 0.02;

class Metrics {
 public:
  explicit Metrics(HostileCase& hostile)
      : hostile_(hostile),
        soup_(hostile.hostile.soup),
        source_(hostile.sources[0]),
        random_(hostile.seed + (3ULL << 40)) {}

  void check() {
    constexpr std::array laws{&Metrics::face_costs,     &Metrics::barriers,      &Metrics::vertex_costs,
                              &Metrics::vertex_tensors, &Metrics::face_tensors,  &Metrics::edge_lengths,
                              &Metrics::winds,          &Metrics::constant_winds};
    const std::size_t chosen = random_.below(laws.size());
    for (std::size_t i = 0; i < laws.size(); ++i) {
      if (hostile_.mesh->face_count() > few_faces && i != chosen) continue;
      random_ = HostileRandom(hostile_.seed + ((4ULL + i) << 40));
      hostile_.attempt([&] { (this->*laws[i])(); });
    }
  }

 private:
  using Field = std::vector<double>;

  void ask(const std::string& metric) {
    hostile_.ask("field of vertex " + std::to_string(source_) + " by " + metric);
  }

  bool has_flat_face() const {
    const Mesh& mesh = *hostile_.mesh;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const double longest = std::ranges::max(mesh.side_lengths(f));
      if (!(2.0 * mesh.face_area(f) > flattest_face * longest * longest)) return true;
    }
    return false;
  }

  /// The field as a user gets it. `to`: of distances to the source instead of from it.
  Field field(const Metric& metric, bool to = false) const {
    return field_of(soup_.positions, metric, source_, to);
  }
  Field field_of(std::vector<Point> positions, const Metric& metric, Index source, bool to = false) const {
    Surface surface(std::make_shared<const Mesh>(std::move(positions), soup_.faces, metric), {.threads = 1});
    Answered answered;
    Surface& asked = to ? surface.reversed() : surface;
    Field field = asked.field(sources_at(std::array{source}), unreachable, Answer::exact, answered).distance;
    field.resize(soup_.positions.size());
    return field;
  }

  /// Lengths determine needles less well than positions do.
  double rounding() const { return 1e-5 * hostile_.mesh->longest_edge_length(); }

  /// Where a metric multiplies all lengths by `scale`.
  void require_scaled(const std::string& law, const Field& actual, const Field& expected, double scale,
                      double more) {
    hostile_.require_same(
        law, [&](Index v) { return expected[v]; }, [&](Index v) { return actual[v] / scale; }, more);
  }

  /// Where a unit of length costs `least` to `greatest`.
  void require_between(const Field& actual, double least, double greatest) {
    if (has_flat_face()) return;
    for (std::size_t v = 0; v < actual.size(); ++v) {
      const double exact = hostile_.exact[0][v];
      const std::string numbers = "vertex " + std::to_string(v) + ": " + exactly(actual[v]) + ", length " +
                                  exactly(exact) + ", costs of " + exactly(least) + " to " +
                                  exactly(greatest);
      if ((actual[v] < unreachable) != (exact < unreachable)) {
        hostile_.fail("reached or not, against the components", numbers);
        continue;
      }
      if (exact == unreachable) continue;
      const double bounded = std::clamp(actual[v], least * exact, greatest * exact);
      hostile_.note_error(ErrorKind::face_cost, actual[v], bounded);
      if (std::abs(actual[v] - bounded) > greatest_excess * bounded + hostile_.slack(exact))
        hostile_.fail("a cost is not between the bounds of its faces", numbers);
    }
  }

  /// A random matrix that stretches no direction more than twice as much as another.
  std::array<Point, 3> stretch() {
    std::array<Point, 3> rows{};
    for (int i = 0; i < 3; ++i) {
      for (double& x : rows[i]) x = random_.uniform(-0.15, 0.15);
      rows[i][i] += 1.0;
    }
    return rows;
  }
  static Point image(const std::array<Point, 3>& rows, const Point& p) {
    Point result{};
    for (int i = 0; i < 3; ++i) result[i] = rows[i][0] * p[0] + rows[i][1] * p[1] + rows[i][2] * p[2];
    return result;
  }
  static Tensor tensor_of(const std::array<Point, 3>& rows) {
    Tensor tensor{};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) tensor[3 * i + j] += rows[k][i] * rows[k][j];
      }
    }
    return tensor;
  }
  /// The exact field of the mesh whose positions are transformed by a matrix.
  Field stretched_field(const std::array<Point, 3>& rows) const {
    std::vector<Point> positions;
    for (const Point& p : soup_.positions) positions.push_back(image(rows, p));
    return exact_distance_field(std::make_shared<const Mesh>(std::move(positions), soup_.faces),
                                std::array{source_});
  }

  void face_costs() {
    ask("costs of faces, 0.5 to 2");
    std::vector<double> cost;
    for (std::size_t f = 0; f < soup_.faces.size(); ++f) cost.push_back(random_.power(-0.301, 0.301));
    const SideLengths sides = sides_by_face_cost(soup_.positions, soup_.faces, cost);
    const Field once = field({sides, usual_edge_points});
    require_between(once, 0.5, 2.0);
    const double scale = std::ldexp(1.0, random_.between(-20, 20));
    SideLengths longer = sides;
    for (auto& of_face : longer) {
      for (double& side : of_face) side *= scale;
    }
    require_scaled("the scale of face costs changes a field", field({longer, usual_edge_points}), once, scale,
                   0.0);
  }

  /// Faces of infinite cost are holes; the others cost the same everywhere.
  void barriers() {
    const double price = random_.power(-3.0, 3.0);
    ask("the cost " + exactly(price) + " with barriers");
    // The draw depends only on the corners, so that repeated faces have one cost wherever they stand.
    const std::size_t salt = random_.below(1U << 20);
    std::vector<double> cost;
    Soup open = soup_;
    std::erase_if(open.faces, [&](std::array<Index, 3> face) {
      const bool at_source = std::ranges::count(face, source_) > 0;
      std::ranges::sort(face);
      HostileRandom draw(salt + (static_cast<std::size_t>(face[0]) * 1000003 + face[1]) * 1000003 + face[2]);
      const bool closed = !at_source && draw.one_in(8);
      cost.push_back(closed ? unreachable : price);
      return closed;
    });
    const auto mesh = std::make_shared<const Mesh>(open.positions, open.faces);
    if (mesh->face_count() == 0) return;
    const Field holes = exact_distance_field(mesh, std::array{source_});
    require_scaled("barriers are not holes",
                   field({sides_by_face_cost(soup_.positions, soup_.faces, cost), usual_edge_points}), holes,
                   price, rounding());
  }

  void vertex_costs() {
    if (has_flat_face()) return;
    ask("costs of vertices, 0.5 to 1.5");
    const Point wave = moved({}, random_.direction(), random_.uniform(0.05, 0.5) / hostile_.typical);
    std::vector<double> cost;
    for (const Point& p : soup_.positions) cost.push_back(1.0 + 0.5 * std::sin(height_over(wave, p)));
    const Metric metric = lengths_by_cost(soup_.positions, soup_.faces, cost);
    const Field there = field(metric);
    const Field back = field_of(soup_.positions, metric, hostile_.sources[1]);
    const double between = there[hostile_.sources[1]];
    if (between != back[source_] && std::abs(between - back[source_]) > hostile_.slack(between))
      hostile_.fail("costs of vertices are not symmetric",
                    exactly(between) + " and " + exactly(back[source_]));
    for (std::size_t v = 0; v < there.size(); ++v) {
      if (there[v] <= back[v] + between + hostile_.slack(there[v])) continue;
      hostile_.fail("a detour is shorter", "vertex " + std::to_string(v) + ": " + exactly(there[v]) + ", " +
                                               exactly(between) + " and " + exactly(back[v]));
    }
    const double scale = std::ldexp(1.0, random_.between(-20, 20));
    for (double& c : cost) c *= scale;
    require_scaled("the scale of vertex costs changes a field",
                   field(lengths_by_cost(soup_.positions, soup_.faces, cost)), there, scale, 0.0);
  }

  void vertex_tensors() {
    ask("the same tensor at each vertex");
    const std::array<Point, 3> rows = stretch();
    const std::vector<Tensor> tensors(soup_.positions.size(), tensor_of(rows));
    require_scaled("tensors of vertices do not stretch the mesh",
                   field(lengths_by_tensor(soup_.positions, soup_.faces, tensors)), stretched_field(rows),
                   1.0, rounding());
  }

  void face_tensors() {
    ask("the same tensor in each face");
    const std::array<Point, 3> rows = stretch();
    const std::vector<Tensor> tensors(soup_.faces.size(), tensor_of(rows));
    const SideLengths sides = sides_by_face_tensor(soup_.positions, soup_.faces, tensors);
    require_scaled("tensors of faces do not stretch the mesh",
                   field({sides, edge_points_for(soup_.positions, soup_.faces, sides)}),
                   stretched_field(rows), 1.0, rounding());
  }

  void edge_lengths() {
    ask("the lengths of edges, without positions");
    const std::vector<double> ones(soup_.faces.size(), 1.0);
    require_scaled("lengths of edges without positions give another field",
                   field_of(std::vector<Point>(soup_.positions.size(), no_position),
                            {sides_by_face_cost(soup_.positions, soup_.faces, ones)}, source_),
                   hostile_.exact[0], 1.0, rounding());
  }

  /// No wind in any face, a wind in each, and the same reversed, with distances to the source.
  void winds() {
    if (has_flat_face()) return;
    const std::vector<Tensor> lengths(soup_.faces.size(), Tensor{1, 0, 0, 0, 1, 0, 0, 0, 1});
    auto by = [&](const std::vector<Point>& drifts) {
      return metric_of(soup_.positions, soup_.faces, Randers{lengths, drifts});
    };
    ask("no drift");
    const std::vector<Point> none(soup_.faces.size(), Point{});
    const SideLengths sides = sides_by_face_tensor(soup_.positions, soup_.faces, lengths);
    const Field plain = field({sides, edge_points_for(soup_.positions, soup_.faces, sides)});
    if (field(by(none)) != plain) hostile_.fail("no drift is not the metric of tensors", "");
    ask("drifts of at most 0.5");
    std::vector<Point> drifts;
    std::vector<Point> against;
    for (std::size_t f = 0; f < soup_.faces.size(); ++f) {
      const Point direction = random_.direction();
      const double speed = random_.uniform(0.0, 0.5);
      drifts.push_back(moved({}, direction, speed));
      against.push_back(moved({}, direction, -speed));
    }
    const Field there = field(by(drifts));
    require_between(there, 0.5, 1.5);
    require_scaled("the ways to a vertex are not those from it against the drifts", field(by(against), true),
                   there, 1.0, 0.0);
  }

  /// One wind everywhere changes no path: it adds a difference between the ends, the same for all paths.
  void constant_winds() {
    ask("the same drift in each face");
    const Point drift = moved({}, random_.direction(), random_.uniform(0.0, 0.5));
    const std::vector<Tensor> lengths(soup_.faces.size(), Tensor{1, 0, 0, 0, 1, 0, 0, 0, 1});
    const std::vector<Point> drifts(soup_.faces.size(), drift);
    const Field actual = field(metric_of(soup_.positions, soup_.faces, Randers{lengths, drifts}));
    const double from = height_over(drift, soup_.positions[source_]);
    hostile_.require_same(
        "one drift everywhere changes a path",
        [&](Index v) {
          return hostile_.exact[0][v] == unreachable
                     ? unreachable
                     : hostile_.exact[0][v] + height_over(drift, soup_.positions[v]) - from;
        },
        [&](Index v) { return actual[v]; }, rounding() + 1e-12 * hostile_.farthest);
  }

  HostileCase& hostile_;
  const Soup& soup_;
  const Index source_;
  HostileRandom random_;  ///< its own for each law, so that other questions of a seed stay the same
};

}  // namespace

void check_metrics(HostileCase& hostile) {
  if (hostile.exact[1].empty() || hostile.has_outlier()) return;
  // Sides and tensors are squared, which leaves the range of numbers sooner.
  if (hostile.mesh->longest_edge_length() > 1e28 || hostile.mesh->mean_edge_length() < 1e-28) return;
  Metrics(hostile).check();
}

}  // namespace vorogeo::test
