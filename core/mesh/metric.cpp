// Metrics: sides of faces by costs, tensors and slopes, faces split where one triangle is too coarse, and the
// points on edges that a metric of face tensors needs.
#include "mesh/metric.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <functional>
#include <queue>
#include <sstream>
#include <string>
#include <utility>

#include "mesh/gaps.h"
#include "mesh/vectors.h"
#include "support/error.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Faces over which a metric varies: bisected; sides longer than the two others together: shortened

namespace {

/// A metric on the edges of a mesh to which vertices can be added.
struct LengthsAlongLines {
  std::vector<Point> place;  ///< by vertex
  /// The length of the line between two vertices, the smaller number first.
  std::function<double(Index, Index)> length;
  /// Adds the value of the metric in the middle of a line, interpolated.
  std::function<void(Index, Index)> add_value;
  /// The squared relative change of the metric over the length of the side between the first two corners of a
  /// face: across the side, which bends shortest paths, plus along it.
  std::function<double(Index, Index, Index)> squared_change;

  void add_middle(Index a, Index b) {
    place.push_back(moved(place[a], 0.5, minus(place[b], place[a])));
    add_value(a, b);
  }
  /// 0 between a vertex and itself.
  std::array<double, 3> sides_of(const std::array<Index, 3>& face) const {
    std::array<double, 3> sides{};
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(face[(i + 1) % 3], face[(i + 2) % 3]);
      if (low != high) sides[i] = length(low, high);
    }
    return sides;
  }
};

int longest_of(const std::array<double, 3>& sides) {
  return static_cast<int>(std::ranges::max_element(sides) - sides.begin());
}

/// Whether the longest side of a face is longer than the two others together by more than `slack`, a
/// fraction.
bool breaks_triangle(const std::array<double, 3>& sides, double slack) {
  const int k = longest_of(sides);
  return sides[k] > (sides[(k + 1) % 3] + sides[(k + 2) % 3]) * (1.0 + slack);
}

/// A triangle inequality broken by less than this is broken by rounding.
constexpr double triangle_rounding = 1e-14;

/// A face that breaks the triangle inequality by less is not split; its longest side is shortened.
constexpr double split_slack = 1e-9;

/// A face is split if the relative change of the metric over the length of its longest side is greater. With
/// a change d across it, the side is longer than a shortest path by the fraction d^2 / 24.
constexpr double most_change = 0.1;

/// Squared changes far above this all count the same: paths avoid faces that are so much dearer.
constexpr double large_squared_change = 3.0;

/// Factor by which faces that break the triangle inequality weigh more, so that they are split sooner.
constexpr double broken_weight = 30.0;

/// Splitting ends at this many times the given number of faces; on small meshes, where time does not matter,
/// at the second number.
constexpr double most_growth = 2.5;
constexpr double faces_of_small = 3000.0;

/// Bisects faces in the middle of their longest side, those first that add most to errors.
class Splitter {
 public:
  Splitter(std::span<const std::array<Index, 3>> faces, LengthsAlongLines& lines)
      : given_(faces), lines_(lines) {}

  FaceSplits split(const SideLengths& sides) {
    for (const std::size_t f : checked(given_.size())) push(static_cast<Index>(f), 0, given_[f], sides[f]);
    if (queue_.empty()) return {};
    link_all();
    const double most = std::max(most_growth * static_cast<double>(given_.size()), faces_of_small);
    while (!queue_.empty() && static_cast<double>(parts_.size()) < most) {
      checkpoint();
      const Candidate next = queue_.top();
      queue_.pop();
      if (parts_[next.part].bisections == next.bisections) bisect_at(next.part);
    }
    return in_order();
  }

 private:
  struct Part {
    std::array<Index, 3> corners;
    Index given_face;
    Index bisections;  ///< number that led to this part
  };
  struct Candidate {
    double weight;
    Index part;
    Index bisections;  ///< of the part when pushed; outdated if it has more by now
    friend auto operator<=>(const Candidate&, const Candidate&) = default;
  };

  /// Makes a part a candidate if the metric varies over it. Its weight is the fraction of their length by
  /// which paths may err there, times its area, which tells how many paths cross it.
  void push(Index part, Index bisections, const std::array<Index, 3>& corners,
            const std::array<double, 3>& sides) {
    if (!is_usable(corners)) return;
    const int apex = longest_of(sides);
    const auto [low, high] = std::minmax(corners[(apex + 1) % 3], corners[(apex + 2) % 3]);
    const double area = area_of_wide(corners);
    if (!(area > 0.0)) return;
    const double squared = lines_.squared_change(low, high, corners[apex]);
    const bool is_broken = breaks_triangle(sides, split_slack);
    if (!is_broken && !(squared > most_change * most_change)) return;
    const double share = squared / (squared + large_squared_change);
    const double weight = (is_broken ? broken_weight : 1.0) * share * area;
    if (weight > 0.0) queue_.push({weight, part, bisections});
  }

  /// Twice the area in space; 0 where there is no width.
  double area_of_wide(const std::array<Index, 3>& v) const {
    constexpr double least_square = 1e-12;  // of the sine; rounding of the difference is 1e-15
    const Point u = minus(lines_.place[v[1]], lines_.place[v[0]]);
    const Point w = minus(lines_.place[v[2]], lines_.place[v[0]]);
    const double lengths = dot(u, u) * dot(w, w);
    const double square = lengths - dot(u, w) * dot(u, w);
    return square > least_square * lengths ? std::sqrt(square) : 0.0;
  }

  /// Makes each given face a part, and links the sides of each edge in a ring.
  void link_all() {
    parts_.reserve(2 * given_.size());
    for (const std::size_t f : checked(given_.size())) {
      parts_.push_back({given_[f], static_cast<Index>(f), 0});
    }
    next_.resize(3 * parts_.size());
    const std::vector<SideOfFace> sorted = sorted_sides(given_);
    std::vector<Index> around;
    for (auto begin = sorted.begin(), end = begin; begin != sorted.end(); begin = end) {
      end = std::find_if(begin, sorted.end(), [&](const SideOfFace& s) { return s.ends != begin->ends; });
      around.clear();
      for (const SideOfFace& side : std::ranges::subrange(begin, end)) {
        around.push_back(3 * side.face + side.corner);
      }
      link(around);
    }
  }

  void link(std::span<const Index> ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) next_[ring[i]] = ring[(i + 1) % ring.size()];
  }

  /// Splits the longest side of a part, and with it all parts at that edge.
  void bisect_at(Index part) {
    const auto& corners = parts_[part].corners;
    const Index first = 3 * part + longest_of(lines_.sides_of(corners));
    const Index a = corners[(first + 1) % 3];
    const Index b = corners[(first + 2) % 3];
    const auto [low, high] = std::minmax(a, b);
    const auto middle = static_cast<Index>(lines_.place.size());
    splits_.middle_of.push_back({low, high});
    lines_.add_middle(low, high);
    std::vector<Index> around;
    Index side = first;
    do around.push_back(side);
    while ((side = next_[side]) != first);
    std::vector<Index> at_low, at_high;
    for (const Index each : around) {
      const bool begins_low = parts_[each / 3].corners[(each + 1) % 3] == low;
      const Index rest = bisect(each, middle);
      at_low.push_back(begins_low ? each : rest);
      at_high.push_back(begins_low ? rest : each);
    }
    link(at_low);
    link(at_high);
    for (const auto* half : {&at_low, &at_high}) {
      for (const Index each : *half) {
        const Part& at = parts_[each / 3];
        push(each / 3, at.bisections, at.corners, lines_.sides_of(at.corners));
      }
    }
  }

  /// Cuts a part in two, from the middle of a side to its apex. The part keeps the beginning of the side.
  /// \return the rest of the side, in a new part.
  Index bisect(Index side, Index middle) {
    const Index part = side / 3;
    const int apex = side % 3, begin = (apex + 1) % 3, end = (apex + 2) % 3;
    const auto rest = static_cast<Index>(parts_.size());
    ++parts_[part].bisections;
    parts_.push_back(parts_[part]);
    parts_[part].corners[end] = middle;
    parts_[rest].corners[begin] = middle;
    next_.resize(next_.size() + 3);
    // The side from the end to the apex, opposite the beginning, belongs to the new part from now on.
    const Index before = 3 * part + begin, now = 3 * rest + begin;
    Index previous = before;
    while (next_[previous] != before) previous = next_[previous];
    next_[previous] = now;
    next_[now] = previous == before ? now : next_[before];
    link(std::array{before, 3 * rest + end});
    return 3 * rest + apex;
  }

  FaceSplits in_order() {
    std::ranges::stable_sort(parts_, {}, &Part::given_face);
    for (const Part& part : parts_) {
      splits_.faces.push_back(part.corners);
      splits_.given_face.push_back(part.given_face);
      splits_.sides.push_back(lines_.sides_of(part.corners));
    }
    return std::move(splits_);
  }

  std::span<const std::array<Index, 3>> given_;
  LengthsAlongLines& lines_;
  std::vector<Part> parts_;
  std::vector<Index> next_;  ///< next side in the ring, by 3 * part + opposite corner
  std::priority_queue<Candidate> queue_;
  FaceSplits splits_;
};

/// Shortens every side that is longer than the two others together to their sum, in all faces of its edge,
/// until the triangle inequality holds everywhere. \return the number of edges concerned.
Index repair_triangles(std::span<const std::array<Index, 3>> faces, SideLengths& sides) {
  auto is_broken = [&](std::size_t f) {
    return is_usable(faces[f]) && breaks_triangle(sides[f], triangle_rounding);
  };
  std::vector<std::size_t> open;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (is_broken(f)) open.push_back(f);
  }
  if (open.empty()) return 0;
  const std::vector<SideOfFace> sorted = sorted_sides(faces);
  std::vector<std::uint8_t> changed(sorted.size(), 0);  // at the first side of each edge
  // This loop ends: lengths only decrease, and each is that of a path along the edges as they were given.
  Index count = 0;
  while (!open.empty()) {
    const std::size_t f = open.back();
    open.pop_back();
    if (!is_broken(f)) continue;
    const int k = longest_of(sides[f]);
    const double length = sides[f][(k + 1) % 3] + sides[f][(k + 2) % 3];
    const auto [a, b] = std::minmax(faces[f][(k + 1) % 3], faces[f][(k + 2) % 3]);
    const auto edge = std::ranges::equal_range(sorted, std::array<Index, 2>{a, b}, {}, &SideOfFace::ends);
    std::uint8_t& counted = changed[edge.begin() - sorted.begin()];
    count += counted == 0;
    counted = 1;
    for (const SideOfFace& side : edge) {
      sides[side.face][side.corner] = length;
      open.push_back(side.face);
    }
  }
  return count;
}

}  // namespace

// ---- Integrals along edges, and checks of costs and tensors

namespace {

/// A tensor whose asymmetry is at most this part of its largest entry is symmetric up to rounding.
constexpr double tensor_rounding = 1e-9;

void require_one_for_each(std::size_t values, const char* what, std::size_t elements, const char* names) {
  if (values == elements) return;
  throw InvalidInput("There are " + std::to_string(values) + " " + what + ", but the mesh has " +
                     std::to_string(elements) + " " + names + "; give one for each.");
}

/// `element`: "Vertex" or "Face".
void require_cost(double cost, const char* element, std::size_t number) {
  if (cost > 0.0) return;
  std::ostringstream text;
  text << element << " " << number << " has the cost " << cost
       << "; a cost is the length of a path for each unit of its length in space, above 0; infinite where "
          "none may lead.";
  throw InvalidInput(text.str());
}

/// `element`: "vertex" or "face".
void require_symmetric(const Tensor& g, const char* element, std::size_t number) {
  double largest = 0.0;
  double skew = 0.0;
  for (int i = 0; i < 9; ++i) {
    largest = std::max(largest, std::abs(g[i]));
    skew = std::max(skew, std::abs(g[i] - g[3 * (i % 3) + i / 3]));
  }
  const bool finite = std::ranges::all_of(g, [](double entry) { return std::isfinite(entry); });
  if (finite && skew <= tensor_rounding * largest) return;
  throw InvalidInput(
      "The tensor of " + std::string(element) + " " + std::to_string(number) + " is " +
      (finite ? "not symmetric; give G with G[i][k] = G[k][i]." : "not finite; give nine finite numbers."));
}

/// Where lengths differ much between directions, most digits of v' G v cancel in the cheap ones, and the
/// angles of needles follow from the digits left: a double has too few.
using Step = std::array<long double, 3>;

Step edge_vector(std::span<const Point> positions, Index a, Index b) {
  Step v{};
  for (int k = 0; k < 3; ++k) v[k] = static_cast<long double>(positions[b][k]) - positions[a][k];
  return v;
}

long double form(const Tensor& g, const Step& u, const Step& v) {
  long double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) sum += u[i] * g[3 * i + k] * v[k];
  }
  return sum;
}

/// Lengths of the sides of all faces that name three vertices. Lines are measured from the smaller vertex, so
/// that both faces of an edge get the same length.
Metric lengths_of_sides(std::span<const std::array<Index, 3>> faces, LengthsAlongLines& lines) {
  Metric result;
  result.sides.assign(faces.size(), {});
  for (const std::size_t f : checked(faces.size())) {
    if (is_usable(faces[f])) result.sides[f] = lines.sides_of(faces[f]);
  }
  result.splits = Splitter(faces, lines).split(result.sides);
  for (std::size_t f = 0; f + 1 < result.splits.given_face.size(); ++f) {
    const Index given = result.splits.given_face[f];
    result.split_faces +=
        given == result.splits.given_face[f + 1] && (f == 0 || given != result.splits.given_face[f - 1]);
  }
  result.shortened_edges = repair_triangles(faces, result.sides);
  if (!result.splits.empty()) {
    result.shortened_edges = repair_triangles(result.splits.faces, result.splits.sides);
  }
  return result;
}

/// Refuses a tensor under which some direction in the plane of a face has no positive length.
void require_positive(std::span<const Point> positions, const std::array<Index, 3>& face, std::size_t number,
                      const char* element, std::size_t owner, const Tensor& g) {
  const Step u = edge_vector(positions, face[0], face[1]);
  const Step v = edge_vector(positions, face[0], face[2]);
  const Tensor unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
  const long double area = form(unit, u, u) * form(unit, v, v) - std::pow(form(unit, u, v), 2);
  const long double uu = form(g, u, u);
  const long double vv = form(g, v, v);
  const long double uv = form(g, u, v);
  const long double side =
      form(g, edge_vector(positions, face[1], face[2]), edge_vector(positions, face[1], face[2]));
  const bool has_width = area > 1e-17 * form(unit, u, u) * form(unit, v, v);
  if (uu >= 0.0 && vv >= 0.0 && side >= 0.0 && (!has_width || (uu > 0.0 && uu * vv > uv * uv))) return;
  std::ostringstream text;
  text << "The tensor of " << element << " " << owner << " is not positive on the plane of face " << number
       << ": the squared lengths of its sides would be " << uu << ", " << side << ", " << vv
       << "; squared lengths v' G v must be above 0 in all directions of the face.";
  throw InvalidInput(text.str());
}

}  // namespace

Metric lengths_by_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                       std::span<const double> cost) {
  require_one_for_each(cost.size(), "costs", positions.size(), "vertices");
  std::vector<std::array<Index, 3>> passable(faces.begin(), faces.end());
  std::vector<std::size_t> barred;
  for (const std::size_t f : checked(faces.size())) {
    if (!is_usable(faces[f])) continue;
    for (const Index v : faces[f]) require_cost(cost[v], "Vertex", static_cast<std::size_t>(v));
    if (std::ranges::none_of(faces[f], [&](Index v) { return cost[v] == unreachable; })) continue;
    passable[f] = {};
    barred.push_back(f);
  }
  std::vector<double> there(cost.begin(), cost.end());
  LengthsAlongLines lines{{positions.begin(), positions.end()}, {}, {}, {}};
  lines.length = [&](Index a, Index b) {
    return distance_between(lines.place[a], lines.place[b]) * (0.5 * there[a] + 0.5 * there[b]);
  };
  lines.squared_change = [&](Index a, Index b, Index apex) {
    const Point u = minus(lines.place[b], lines.place[a]);
    const Point w = minus(lines.place[apex], lines.place[a]);
    const double uu = dot(u, u), uw = dot(u, w), ww = dot(w, w);
    const double mean = (there[a] + there[b] + there[apex]) / 3.0;
    const double along = (there[b] - there[a]) / mean;
    const double to_apex = (there[apex] - there[a]) / mean - uw / uu * along;
    return to_apex * to_apex * uu * uu / (uu * ww - uw * uw) + along * along;
  };
  lines.add_value = [&](Index a, Index b) { there.push_back(0.5 * there[a] + 0.5 * there[b]); };
  Metric metric = lengths_of_sides(passable, lines);
  for (const std::size_t f : barred) metric.sides[f].fill(unreachable);
  return metric;
}

Metric lengths_by_tensor(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                         std::span<const Tensor> tensors) {
  require_one_for_each(tensors.size(), "tensors", positions.size(), "vertices");
  for (std::size_t v = 0; v < tensors.size(); ++v) require_symmetric(tensors[v], "vertex", v);
  for (const std::size_t f : checked(faces.size())) {
    if (!is_usable(faces[f])) continue;
    for (Index v : faces[f]) {
      require_positive(positions, faces[f], f, "vertex", static_cast<std::size_t>(v), tensors[v]);
    }
  }
  std::vector<Tensor> there(tensors.begin(), tensors.end());
  LengthsAlongLines lines{{positions.begin(), positions.end()}, {}, {}, {}};
  lines.length = [&](Index a, Index b) {
    const Step edge = edge_vector(lines.place, a, b);
    const long double first = std::max(0.0L, form(there[a], edge, edge));
    const long double second = std::max(0.0L, form(there[b], edge, edge));
    const long double at_first = std::sqrt(first);
    const long double at_second = std::sqrt(second);
    if (!(at_first + at_second > 0.0L)) return 0.0;
    // The integral of the root of a linear function.
    return static_cast<double>(2.0L / 3.0L * (first + at_first * at_second + second) /
                               (at_first + at_second));
  };
  lines.squared_change = [&](Index a, Index b, Index apex) {
    const Step u = edge_vector(lines.place, a, b);
    const Step w = edge_vector(lines.place, a, apex);
    const Tensor &at_a = there[a], &at_b = there[b], &at_apex = there[apex];
    auto mean = [&](const Step& x, const Step& y) {
      return (form(at_a, x, y) + form(at_b, x, y) + form(at_apex, x, y)) / 3.0L;
    };
    const long double uu = mean(u, u), uw = mean(u, w), ww = mean(w, w);
    if (!(uu > 0.0L)) return 0.0;
    // How much the line from a to b deviates from a geodesic follows from the Christoffel symbols of the
    // first kind, along u and w, of the metric that is linear over the face.
    const long double along = 0.5L * (form(at_b, u, u) - form(at_a, u, u));
    const long double aside =
        form(at_b, u, w) - form(at_a, u, w) - 0.5L * (form(at_apex, u, u) - form(at_a, u, u));
    const long double across = aside - uw / uu * along;
    const long double squared_area = std::max(uu * ww - uw * uw, 1e-30L * uu * ww);
    return static_cast<double>(across * across / squared_area + along * along / (uu * uu));
  };
  lines.add_value = [&](Index a, Index b) {
    Tensor middle{};
    for (int i = 0; i < 9; ++i) middle[i] = 0.5 * there[a][i] + 0.5 * there[b][i];
    there.push_back(middle);
  };
  return lengths_of_sides(faces, lines);
}

SideLengths sides_by_face_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               std::span<const double> cost) {
  require_one_for_each(cost.size(), "costs", faces.size(), "faces");
  SideLengths sides(faces.size(), {0.0, 0.0, 0.0});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!is_usable(faces[f])) continue;
    require_cost(cost[f], "Face", f);
    if (cost[f] == unreachable) {
      sides[f].fill(unreachable);
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      sides[f][i] =
          cost[f] * distance_between(positions[faces[f][(i + 1) % 3]], positions[faces[f][(i + 2) % 3]]);
    }
  }
  return sides;
}

SideLengths sides_by_face_tensor(std::span<const Point> positions,
                                 std::span<const std::array<Index, 3>> faces,
                                 std::span<const Tensor> tensors) {
  require_one_for_each(tensors.size(), "tensors", faces.size(), "faces");
  SideLengths sides(faces.size(), {0.0, 0.0, 0.0});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!is_usable(faces[f])) continue;
    require_symmetric(tensors[f], "face", f);
    require_positive(positions, faces[f], f, "face", f, tensors[f]);
    for (int i = 0; i < 3; ++i) {
      const Step side = edge_vector(positions, faces[f][(i + 1) % 3], faces[f][(i + 2) % 3]);
      sides[f][i] = static_cast<double>(std::sqrt(std::max(0.0L, form(tensors[f], side, side))));
    }
  }
  return sides;
}

SideLengths drifts_by_face(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                           const SideLengths& sides, std::span<const Point> drifts) {
  // If twice the area is a smaller part of the product of two sides, they hardly determine a needle's height.
  constexpr double thin = 1e-5;
  require_one_for_each(drifts.size(), "drifts", faces.size(), "faces");
  SideLengths along(faces.size(), {0.0, 0.0, 0.0});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!is_usable(faces[f]) || is_impassable(sides[f])) continue;
    const Point& w = drifts[f];
    auto refuse = [&](const std::string& what) {
      throw InvalidInput("The drift of face " + std::to_string(f) + " " + what);
    };
    if (!std::isfinite(w[0] + w[1] + w[2])) {
      refuse("is not finite; give three finite numbers, or a finite wind and own speed that make it.");
    }
    std::array<long double, 3> gain{};
    for (int i = 0; i < 3; ++i) {
      const Step side = edge_vector(positions, faces[f][(i + 1) % 3], faces[f][(i + 2) % 3]);
      gain[i] = w[0] * side[0] + w[1] * side[1] + w[2] * side[2];
      along[f][i] = static_cast<double>(gain[i]);
    }
    // The norm is computed from the shortest side and another at the same corner: with both long sides of a
    // needle, the difference aa bb - ab^2 would be rounding.
    const auto first = std::ranges::min_element(sides[f]) - sides[f].begin();
    const auto second = (first + 2) % 3;
    const std::array<long double, 3> side{sides[f][first], sides[f][(first + 1) % 3], sides[f][second]};
    const long double aa = side[0] * side[0];
    const long double bb = side[2] * side[2];
    const long double ab = 0.5L * (aa + (side[2] - side[1]) * (side[2] + side[1]));
    const long double squared = (bb * gain[first] * gain[first] + 2.0L * ab * gain[first] * gain[second] +
                                 aa * gain[second] * gain[second]) /
                                (aa * bb - ab * ab);
    if (!is_flat_triangle(sides[f]) && squared < 1.0L) continue;
    if (!(twice_area(sides[f]) <= thin * side[1] * std::max(side[0], side[2]))) {
      refuse("has the norm " + std::to_string(static_cast<double>(std::sqrt(squared))) +
             " in the lengths of the face: some step would cost nothing or less; give one below 1.");
    }
    const auto longest = std::ranges::max_element(sides[f]) - sides[f].begin();
    const auto next = (longest + 1) % 3;
    const auto before = (longest + 2) % 3;
    const double whole = sides[f][longest];
    if (!(whole > 0.0)) continue;
    const double difference = (sides[f][before] - sides[f][next]) * (sides[f][before] + sides[f][next]);
    const double foot = std::clamp(0.5 + 0.5 * difference / (whole * whole), 0.0, 1.0);
    const double at_foot = -foot * along[f][longest];
    // A drift of norm below 1 adds less across the longest side than the height of the face. More comes from
    // rounding; then the apex gets what the drift along the longest side adds up to the apex's foot.
    if (std::abs(along[f][before] - at_foot) <= no_height * std::sqrt(sides[f][first] * whole)) continue;
    along[f][before] = at_foot;
    along[f][next] = -along[f][longest] - along[f][before];
  }
  return along;
}

// ---- Normals of vertices, bends of edges, and the principal directions of their sums

namespace {

/// Bends below this, in radians, come from rounding: single precision has 1e-7.
constexpr double flat_bend = 1e-6;

/// The vector with length 1; zero stays zero.
Point unit_of(const Point& a) {
  const double length = length_of(a);
  return length > 0.0 ? Point{a[0] / length, a[1] / length, a[2] / length} : Point{};
}

/// Normal of a face, as long as twice its area.
Point face_normal(std::span<const Point> positions, const std::array<Index, 3>& face) {
  return cross(minus(positions[face[1]], positions[face[0]]), minus(positions[face[2]], positions[face[0]]));
}

/// Sums of the normals of the faces at each vertex, scaled to length 1. Flipped faces would cancel out, so
/// each normal is turned to the side of those before it.
std::vector<Point> vertex_normals(std::span<const Point> positions,
                                  std::span<const std::array<Index, 3>> faces) {
  std::vector<Point> normals(positions.size());
  for (const auto& face : faces) {
    const Point normal = face_normal(positions, face);
    for (Index v : face) {
      const double sign = dot(normals[v], normal) < 0.0 ? -1.0 : 1.0;
      for (int k = 0; k < 3; ++k) normals[v][k] += sign * normal[k];
    }
  }
  for (Point& normal : normals) normal = unit_of(normal);
  return normals;
}

/// A symmetric matrix for each vertex: the sum over its inner edges of bend times length, in the direction
/// across the edge.
std::vector<Tensor> bend_tensors(std::span<const Point> positions,
                                 std::span<const std::array<Index, 3>> faces) {
  const std::vector<SideOfFace> sides = sides_in_mesh(faces);
  std::vector<Tensor> sum(positions.size(), Tensor{});
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const auto& [ends, face, corner] = sides[i];
    const auto& [next_ends, next_face, next_corner] = sides[i + 1];
    if (next_ends != ends) continue;
    const auto [a, b] = ends;
    const Point along = minus(positions[b], positions[a]);
    const Point edge = unit_of(along);
    // Directions away from the edge in both faces: opposite to each other if these lie in one plane.
    auto away = [&](Index v) {
      const Point aside = minus(positions[v], positions[a]);
      return unit_of(moved(aside, -dot(aside, edge), edge));
    };
    const Point left = away(faces[face][corner]);
    const Point right = away(faces[next_face][next_corner]);
    const Point bisector{left[0] + right[0], left[1] + right[1], left[2] + right[2]};
    const Point across = unit_of(minus(left, right));
    // The sign tells ridges from valleys; which is which does not matter.
    const Point normal = face_normal(positions, faces[face]);
    const double sign = dot(bisector, normal) < 0.0 ? -1.0 : 1.0;
    const double bend = sign * 2.0 * std::asin(std::min(1.0, 0.5 * length_of(bisector)));
    if (std::abs(bend) < flat_bend) continue;
    const double weight = bend * length_of(along);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) {
        sum[a][3 * r + c] += weight * across[r] * across[c];
        sum[b][3 * r + c] += weight * across[r] * across[c];
      }
    }
  }
  return sum;
}

/// The sum of each matrix and the matrices of its neighbours: a single ring of edges has too few directions.
std::vector<Tensor> over_neighbours(const std::vector<Tensor>& of,
                                    std::span<const std::array<Index, 3>> faces) {
  std::vector<Tensor> sum(of);
  for (const auto& face : faces) {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 9; ++k) {
        // In a closed fan every neighbour comes twice.
        sum[face[i]][k] += 0.5 * (of[face[(i + 1) % 3]][k] + of[face[(i + 2) % 3]][k]);
      }
    }
  }
  return sum;
}

}  // namespace

Point upwards_of(const Point& up) {
  const Point upwards = unit_of(up);
  if (dot(upwards, upwards) > 0.5) return upwards;
  throw InvalidInput("The direction upwards has no length; give a vector such as (0, 0, 1).");
}

Point along_face(std::span<const Point> positions, const std::array<Index, 3>& face, const Point& vector) {
  const Point normal = unit_of(face_normal(positions, face));
  if (dot(normal, normal) > 0.5) return moved(vector, -dot(vector, normal), normal);
  Point longest{};
  for (int i = 0; i < 3; ++i) {
    const Point side = minus(positions[face[(i + 1) % 3]], positions[face[i]]);
    if (length_of(side) > length_of(longest)) longest = side;
  }
  const Point direction = unit_of(longest);
  return moved(Point{}, dot(vector, direction), direction);
}

std::vector<double> grades_of(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                              const Point& up) {
  const Point upwards = upwards_of(up);
  std::vector<double> grades;
  grades.reserve(faces.size());
  for (const auto& face : faces) {
    const Point rise = along_face(positions, face, upwards);
    grades.push_back(length_of(rise) / length_of(minus(upwards, rise)));
  }
  return grades;
}

std::vector<double> slope_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               const Point& up, double penalty) {
  if (!(penalty >= 0.0 && std::isfinite(penalty))) {
    throw InvalidInput("The slope penalty is " + std::to_string(penalty) + "; give a number of at least 0.");
  }
  const Point upwards = upwards_of(up);
  std::vector<double> cost;
  cost.reserve(positions.size());
  for (const Point& normal : vertex_normals(positions, faces)) {
    const Point tilt = cross(normal, upwards);
    cost.push_back(1.0 + penalty * std::min(1.0, length_of(tilt)));
  }
  return cost;
}

std::vector<Tensor> curvature_tensors(std::span<const Point> positions,
                                      std::span<const std::array<Index, 3>> faces, double weight) {
  if (!std::isfinite(weight)) throw InvalidInput("The weight of the curvature is not finite; give a number.");
  const auto normals = vertex_normals(positions, faces);
  const auto bends = over_neighbours(bend_tensors(positions, faces), faces);
  std::vector<Tensor> tensors(positions.size(), Tensor{1, 0, 0, 0, 1, 0, 0, 0, 1});
  for (std::size_t v = 0; v < tensors.size(); ++v) {
    // u and w span the tangent plane of the vertex.
    const Point& n = normals[v];
    const Point axis = std::abs(n[0]) < 0.6 ? Point{1, 0, 0} : Point{0, 1, 0};
    const Point u = unit_of(cross(n, axis));
    const Point w = cross(n, u);
    auto entry = [&](const Point& a, const Point& b) {
      double value = 0.0;
      for (int i = 0; i < 9; ++i) value += a[i / 3] * bends[v][i] * b[i % 3];
      return value;
    };
    const double uu = entry(u, u);
    const double ww = entry(w, w);
    const double uw = entry(u, w);
    const double mean = 0.5 * (uu + ww);
    const double spread = std::hypot(0.5 * (uu - ww), uw);
    const double one = std::abs(mean + spread);
    const double two = std::abs(mean - spread);
    if (!(one + two > 0.0)) continue;
    // Direction of the eigenvalue mean + spread; the other one is perpendicular to it.
    double angle = 0.5 * std::atan2(2.0 * uw, uu - ww);
    if ((one < two) != (weight < 0.0)) angle += std::acos(0.0);
    const double strength = std::abs(weight) * std::abs(one - two) / (one + two);
    Point d{};
    for (int k = 0; k < 3; ++k) d[k] = std::cos(angle) * u[k] + std::sin(angle) * w[k];
    for (int i = 0; i < 9; ++i) tensors[v][i] += strength * d[i / 3] * d[i % 3];
  }
  return tensors;
}

// ---- The stretch of faces that disagree with a neighbour on an edge

namespace {

/// Paths turn at an edge if its lengths in two faces differ by more than this factor.
constexpr double side_jump = 1.5;

/// Fraction of the edges between faces. If fewer jump, few crossings have errors.
constexpr double jumping_share = 0.1;

/// Points on an edge for each unit of stretch, for a mean error of about half a percent.
constexpr double points_per_stretch = 2.5;

/// If twice the area of a face is a smaller part of the square of its longest side, it is rounding.
constexpr double no_area = 1e-7;

double least_area(const std::array<double, 3>& sides) {
  const double longest = std::ranges::max(sides);
  return no_area * longest * longest;
}

}  // namespace

double stretch_of(const std::array<double, 3>& sides, const std::array<double, 3>& in_space) {
  const double area_in_space = twice_area(in_space);
  if (!(area_in_space > least_area(in_space))) return 1.0;
  // Where a stretch leaves nothing of the area but rounding, the least area gives a lower bound of it.
  const double area = std::max(twice_area(sides), least_area(sides));
  // The squared lengths of two sides and their product, in either metric: the ratio of the eigenvalues of one
  // relative to the other follows from trace and determinant.
  auto form = [](const std::array<double, 3>& s) {
    const double first = s[1] * s[1];
    const double second = s[2] * s[2];
    return std::array{first, 0.5 * (first + second - s[0] * s[0]), second};
  };
  const auto [a, b, c] = form(in_space);
  const auto [x, y, z] = form(sides);
  const double root = area / area_in_space;  // of the determinant
  const double half_trace = 0.5 * (c * x - 2.0 * b * y + a * z) / (area_in_space * area_in_space);
  const double ratio = std::max(1.0, half_trace / root);
  return ratio + std::sqrt((ratio - 1.0) * (ratio + 1.0));
}

Index edge_points_for(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                      const SideLengths& sides) {
  std::vector<double> stretch(faces.size(), 1.0);
  double greatest = 1.0;
  for (const std::size_t f : checked(faces.size())) {
    if (!is_usable(faces[f]) || is_impassable(sides[f])) continue;
    std::array<double, 3> in_space{};
    for (int i = 0; i < 3; ++i) {
      in_space[i] = distance_between(positions[faces[f][(i + 1) % 3]], positions[faces[f][(i + 2) % 3]]);
    }
    stretch[f] = stretch_of(sides[f], in_space);
    greatest = std::max(greatest, stretch[f]);
  }
  const Index fewest = usual_edge_points;
  if (points_per_stretch * greatest <= fewest) return fewest;

  struct Jump {
    double stretch = 1.0;
    Index face = 0;
  };
  std::vector<Jump> jumps;  // of edges between faces
  std::size_t between = 0;
  const std::vector<SideOfFace> sorted = sides_in_mesh(faces);
  for (auto begin = sorted.begin(), end = begin; begin != sorted.end(); begin = end) {
    end = std::find_if(begin, sorted.end(), [&](const SideOfFace& s) { return s.ends != begin->ends; });
    if (end - begin < 2) continue;
    ++between;
    const std::ranges::subrange edge(begin, end);
    const auto [least, most] =
        std::ranges::minmax(edge, {}, [&](const SideOfFace& s) { return sides[s.face][s.corner]; });
    if (!(sides[most.face][most.corner] > side_jump * sides[least.face][least.corner])) continue;
    const Index face = std::ranges::max(edge, {}, [&](const SideOfFace& s) { return stretch[s.face]; }).face;
    jumps.push_back({stretch[face], face});
  }
  const auto rank = static_cast<std::size_t>(jumping_share * static_cast<double>(between));
  if (rank >= jumps.size()) return fewest;
  // A tenth of all edges lie at faces of at least this stretch.
  std::ranges::nth_element(jumps, jumps.begin() + static_cast<std::ptrdiff_t>(rank), std::greater{},
                           &Jump::stretch);
  const double needed = std::ceil(points_per_stretch * jumps[rank].stretch);
  if (needed <= most_edge_points) return std::max(fewest, static_cast<Index>(needed));
  const auto& [stretched, face] = jumps[rank];
  std::ostringstream text;
  text << "The tensor of face " << face << " makes its sides " << sides[face][0] << ", " << sides[face][1]
       << " and " << sides[face][2] << " long and stretches lengths " << stretched
       << " times as much in one direction as in another, and a tenth of all edges lie between tensors of at "
          "least "
          "this stretch that disagree: distances would need some "
       << needed
       << " points on each edge. Give smoother or less stretched tensors, or `points` for a coarser answer.";
  throw InvalidInput(text.str());
}

}  // namespace vorogeo
