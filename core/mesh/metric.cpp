// Integrals along edges, checks of costs and tensors, and the repair of triangles.
#include "mesh/metric.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>

#include "mesh/face_splits.h"
#include "mesh/sorted_sides.h"
#include "mesh/vectors.h"
#include "support/checkpoint.h"
#include "support/error.h"

namespace vorogeo {

namespace {

/// Relative to its largest entry: rounding of a symmetric product.
constexpr double tensor_rounding = 1e-9;

/// A triangle inequality that is broken by less is rounding.
constexpr double triangle_rounding = 1e-14;

void require_one_for_each(std::size_t values, const char* what, std::size_t elements, const char* names) {
  if (values == elements) return;
  throw InvalidInput("There are " + std::to_string(values) + " " + what + ", but the mesh has " +
                     std::to_string(elements) + " " + names + "; give one for each.");
}

/// `element`: "Vertex" or "Face".
void require_cost(double cost, const char* element, std::size_t number) {
  if (cost > 0.0 && std::isfinite(cost)) return;
  std::ostringstream text;
  text << element << " " << number << " has the cost " << cost
       << "; a cost is the length of a path for each unit of its length in space, above 0 and finite.";
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

/// Where lengths differ much between directions, most digits of the sum cancel in the cheap ones, and needles
/// get their angles from what is left: a double has too few.
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

/// Lengths of the sides of all faces that name three vertices. Lines are named by the smaller vertex first,
/// so that both faces of an edge compute the same.
MetricLengths lengths_of_sides(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               const LengthsAlongLines& lines) {
  MetricLengths result;
  result.sides.assign(faces.size(), {});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    if (!is_usable(faces[f])) continue;
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(faces[f][(i + 1) % 3], faces[f][(i + 2) % 3]);
      result.sides[f][i] = lines.length(a, b);
    }
  }
  result.splits = split_faces_for(positions, faces, result.sides, lines, result.split_faces);
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

MetricLengths lengths_by_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                              std::span<const double> cost) {
  require_one_for_each(cost.size(), "costs", positions.size(), "vertices");
  for (std::size_t v = 0; v < cost.size(); ++v) require_cost(cost[v], "Vertex", v);
  std::vector<Point> place(positions.begin(), positions.end());
  std::vector<double> there(cost.begin(), cost.end());
  LengthsAlongLines lines;
  lines.length = [&](Index a, Index b) {
    return distance_between(place[a], place[b]) * (0.5 * there[a] + 0.5 * there[b]);
  };
  lines.add_middle = [&](Index a, Index b) {
    place.push_back(moved(place[a], 0.5, minus(place[b], place[a])));
    there.push_back(0.5 * there[a] + 0.5 * there[b]);
  };
  return lengths_of_sides(positions, faces, lines);
}

MetricLengths lengths_by_tensor(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                                std::span<const Tensor> tensors) {
  require_one_for_each(tensors.size(), "tensors", positions.size(), "vertices");
  for (std::size_t v = 0; v < tensors.size(); ++v) require_symmetric(tensors[v], "vertex", v);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    if (!is_usable(faces[f])) continue;
    for (Index v : faces[f]) {
      require_positive(positions, faces[f], f, "vertex", static_cast<std::size_t>(v), tensors[v]);
    }
  }
  std::vector<Point> place(positions.begin(), positions.end());
  std::vector<Tensor> there(tensors.begin(), tensors.end());
  LengthsAlongLines lines;
  lines.length = [&](Index a, Index b) {
    const Step edge = edge_vector(place, a, b);
    const long double first = std::max(0.0L, form(there[a], edge, edge));
    const long double second = std::max(0.0L, form(there[b], edge, edge));
    const long double at_first = std::sqrt(first);
    const long double at_second = std::sqrt(second);
    if (!(at_first + at_second > 0.0L)) return 0.0;
    // The integral of the root of a linear function.
    return static_cast<double>(2.0L / 3.0L * (first + at_first * at_second + second) /
                               (at_first + at_second));
  };
  lines.add_middle = [&](Index a, Index b) {
    place.push_back(moved(place[a], 0.5, minus(place[b], place[a])));
    Tensor middle{};
    for (int i = 0; i < 9; ++i) middle[i] = 0.5 * there[a][i] + 0.5 * there[b][i];
    there.push_back(middle);
  };
  return lengths_of_sides(positions, faces, lines);
}

SideLengths sides_by_face_cost(std::span<const Point> positions, std::span<const std::array<Index, 3>> faces,
                               std::span<const double> cost) {
  require_one_for_each(cost.size(), "costs", faces.size(), "faces");
  SideLengths sides(faces.size(), {0.0, 0.0, 0.0});
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!is_usable(faces[f])) continue;
    require_cost(cost[f], "Face", f);
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

Index repair_triangles(std::span<const std::array<Index, 3>> faces, SideLengths& sides) {
  auto longest_of = [&](std::size_t f) {
    return static_cast<int>(std::ranges::max_element(sides[f]) - sides[f].begin());
  };
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
    const int k = longest_of(f);
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

}  // namespace vorogeo
