// A mesh whose edges have other lengths than in space: checks of the lengths, and what replaces positions.
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>

#include "mesh/mesh.h"
#include "mesh/triangle_area.h"
#include "support/checkpoint.h"
#include "support/error.h"

namespace vorogeo {

namespace {

/// Lengths of one edge in two faces, and the sums in the triangle inequality, may differ by rounding.
constexpr double length_rounding = 1e-9;

/// The bound of straight lines must hold after rounding.
constexpr double straight_slack = 1.0 - 1e-6;

std::string listed(const std::array<double, 3>& sides) {
  std::ostringstream text;
  text.precision(9);
  text << sides[0] << ", " << sides[1] << ", " << sides[2];
  return text.str();
}

/// Squares and product of two sides of a face, from its first corner.
struct Gram {
  explicit Gram(const std::array<Point, 3>& corner) {
    for (int k = 0; k < 3; ++k) {
      const double a = corner[1][k] - corner[0][k];
      const double b = corner[2][k] - corner[0][k];
      aa += a * a;
      ab += a * b;
      bb += b * b;
    }
  }
  double determinant() const { return std::max(0.0, aa * bb - ab * ab); }
  double aa = 0.0;
  double ab = 0.0;
  double bb = 0.0;
};

}  // namespace

Mesh::Mesh(std::vector<Point> positions, const std::vector<std::array<Index, 3>>& faces,
           const FaceSides& sides)
    : Mesh(std::move(positions), faces, &sides.sides, sides.points_per_edge) {
  constexpr Index max_points = 1000;
  if (points_per_edge_ < 1 || points_per_edge_ > max_points) {
    throw InvalidInput("The number of points on each edge is " + std::to_string(points_per_edge_) +
                       "; give 1 to 1000.");
  }
}

std::shared_ptr<const Mesh> mesh_in_metric_of(const Mesh& mesh, std::vector<Point> positions,
                                              const std::vector<std::array<Index, 3>>& faces,
                                              SideLengths sides) {
  if (mesh.metric_jumps()) {
    return std::make_shared<const Mesh>(std::move(positions), faces,
                                        FaceSides{std::move(sides), mesh.points_per_edge()});
  }
  return mesh.has_metric() ? std::make_shared<const Mesh>(std::move(positions), faces, sides)
                           : std::make_shared<const Mesh>(std::move(positions), faces);
}

void require_agreeing_faces(const Mesh& mesh, const std::string& what) {
  if (!mesh.metric_jumps()) return;
  throw InvalidInput(what +
                     " need edges on whose length both faces agree, and this metric jumps at edges: take the "
                     "index or exact distances, or values at vertices.");
}

void Mesh::take_sides(const SideLengths& sides) {
  const auto rows = sides.size();
  for (Index f = 0; f < face_count(); ++f) {
    const Index row = input_face(f);
    const std::string number = std::to_string(row);
    if (static_cast<std::size_t>(row) >= rows) {
      throw InvalidInput("Face " + number + " has no side lengths: there are " + std::to_string(rows) +
                         " rows of lengths; give one row of three for each face.");
    }
    const auto& side = sides[row];
    for (double length : side) {
      if (length >= 0.0 && std::isfinite(length)) continue;
      throw InvalidInput("Face " + number + " has the side lengths " + listed(side) +
                         "; lengths must be finite and not negative.");
    }
    const double longest = *std::ranges::max_element(side);
    const double others = side[0] + side[1] + side[2] - longest;
    if (longest > others + length_rounding * longest) {
      throw InvalidInput("Face " + number + " has the side lengths " + listed(side) +
                         ", which break the triangle inequality: no side may be longer than the other two "
                         "together.");
    }
  }
  face_sides_.resize(metric_jumps() ? face_count() : 0);
  for (std::size_t f = 0; f < face_sides_.size(); ++f)
    face_sides_[f] = sides[input_face(static_cast<Index>(f))];
  for (Index e = 0; e < edge_count(); ++e) {
    if (e % elements_per_checkpoint == 0) checkpoint();
    // Side k is opposite corner k, so half-edge 3 f + i is side i + 2.
    auto length_at = [&](Index h) { return sides[input_face(face_of(h))][(h + 2) % 3]; };
    const Index first = edge_halfedge_[e];
    edge_length_[e] = length_at(first);
    if (!metric_jumps()) require_agreement(e, sides);
    for (Index h = next_around_edge_[first]; metric_jumps() && h != first; h = next_around_edge_[h]) {
      edge_length_[e] = std::min(edge_length_[e], length_at(h));
    }
  }
}

void Mesh::require_agreement(Index edge, const SideLengths& sides) const {
  const Index first = edge_halfedge_[edge];
  const double length = edge_length_[edge];
  for (Index h = next_around_edge_[first]; h != first; h = next_around_edge_[h]) {
    const Index one = input_face(face_of(first));
    const Index other = input_face(face_of(h));
    if (std::abs(sides[other][(h + 2) % 3] - length) <= length_rounding * length) continue;
    throw InvalidInput("Faces " + std::to_string(one) + " and " + std::to_string(other) +
                       " disagree on the length of their edge from vertex " +
                       std::to_string(edge_vertices_[edge][0]) + " to " +
                       std::to_string(edge_vertices_[edge][1]) + ": their side lengths are " +
                       listed(sides[one]) + " and " + listed(sides[other]) +
                       "; give the same length in both (each side stands opposite its corner).");
  }
}

std::array<double, 3> Mesh::side_lengths(Index face) const {
  std::array<double, 3> side{};
  for (int i = 0; i < 3; ++i) side[(i + 2) % 3] = side_length(3 * face + i);
  return side;
}

/// The corners of a face, laid into the plane by the lengths of its sides.
std::array<Point, 3> Mesh::corners_by_lengths(Index face) const {
  // The longest side lies on the x axis and begins where the shorter of the other two ends, so differences
  // are taken of numbers that have all their digits.
  const auto side = side_lengths(face);
  const auto apex = static_cast<int>(std::ranges::max_element(side) - side.begin());
  int origin = (apex + 1) % 3;
  int end = (apex + 2) % 3;
  if (side[origin] < side[end]) std::swap(origin, end);
  const double longest = side[apex];
  const double to_origin = side[end];
  const double to_end = side[origin];
  std::array<Point, 3> corner{};
  if (!(longest > 0.0)) return corner;
  corner[end][0] = longest;
  const double more = longest - to_end;
  corner[apex][0] = (to_origin * to_origin + more * (longest + to_end)) / (2.0 * longest);
  corner[apex][1] = twice_area(side) / longest;
  return corner;
}

/// The least singular value of the maps from the faces in space to the faces in the metric.
void Mesh::bound_straight_lines() {
  straight_scale_ = 0.0;
  if (!has_positions_) return;
  double least = unreachable;
  for (Index f = 0; f < face_count(); ++f) {
    if (f % elements_per_checkpoint == 0) checkpoint();
    const auto& v = face_vertices_[f];
    const Gram space({positions_[v[0]], positions_[v[1]], positions_[v[2]]});
    const Gram metric(face_corners(f));
    const double area = space.determinant();
    if (!(area > 0.0)) return;
    const double sum = (space.bb * metric.aa - 2.0 * space.ab * metric.ab + space.aa * metric.bb) / area;
    const double product = metric.determinant() / area;
    const double root = std::sqrt(std::max(0.0, sum * sum - 4.0 * product));
    if (!(sum + root > 0.0)) return;
    least = std::min(least, 2.0 * product / (sum + root));
  }
  if (least < unreachable) straight_scale_ = straight_slack * std::sqrt(least);
}

}  // namespace vorogeo
