// Angles and areas of faces, by the cross product of two sides, and the mean angle defect.
#include <cmath>
#include <numbers>

#include "mesh/length_limits.h"
#include "mesh/mesh.h"

namespace vorogeo {

namespace {

Point from_to(const Point& a, const Point& b) { return {b[0] - a[0], b[1] - a[1], b[2] - a[2]}; }

double scalar_product(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double cross_length(const Point& a, const Point& b) {
  const Point cross{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const double square = scalar_product(cross, cross);
  // Only there do squares keep all their digits.
  const bool in_range = square > 1e-270 && square < 1e270;
  return in_range ? std::sqrt(square) : std::hypot(cross[0], cross[1], cross[2]);
}

}  // namespace

double Mesh::corner_angle(Index halfedge) const {
  const auto corners = face_corners(face_of(halfedge));
  const Point& corner = corners[halfedge % 3];
  const Point to_next = from_to(corner, corners[next_in_face(halfedge) % 3]);
  const Point to_previous = from_to(corner, corners[previous_in_face(halfedge) % 3]);
  return std::atan2(cross_length(to_next, to_previous), scalar_product(to_next, to_previous));
}

/// The sum of the angles of the corners at a vertex. Angles add up where complex numbers are multiplied, so
/// one arctangent serves them all; half turns are counted.
double Mesh::angle_around(Index vertex) const {
  double cosine = 1.0, sine = 0.0;  // times a positive number; of an angle in [0, pi)
  double others = 0.0;
  int half_turns = 0;
  for (Index h : corners(vertex)) {
    Point to_next, to_previous;
    if (has_metric_) {
      const auto corner = face_corners(face_of(h));
      to_next = from_to(corner[h % 3], corner[next_in_face(h) % 3]);
      to_previous = from_to(corner[h % 3], corner[previous_in_face(h) % 3]);
    } else {
      to_next = from_to(positions_[vertex], positions_[head(h)]);
      to_previous = from_to(positions_[vertex], positions_[apex(h)]);
    }
    double along = scalar_product(to_next, to_previous);
    double across = cross_length(to_next, to_previous);
    const double size = std::abs(along) + across;
    if (!(size > 0.0 && size < unreachable)) {
      others += std::atan2(across, along);
      continue;
    }
    along /= size;
    across /= size;
    const bool beyond_half = cosine < 0.0 && along < 0.0;
    const double turned = cosine * along - sine * across;
    sine = sine * along + cosine * across;
    cosine = turned;
    if (beyond_half || sine < 0.0 || (sine == 0.0 && cosine < 0.0)) {
      cosine = -cosine;
      sine = -sine;
      ++half_turns;
    }
    if (std::abs(cosine) + std::abs(sine) < 1e-100) {
      cosine *= 1e100;
      sine *= 1e100;
    }
  }
  return half_turns * std::numbers::pi + std::atan2(sine, cosine) + others;
}

double Mesh::face_area(Index face) const {
  // Cross product of the two shorter sides: relative to them, the rounding of a product is small even in
  // needles.
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (edge_length_[halfedge_edge_[3 * face + i]] > edge_length_[halfedge_edge_[3 * face + longest]])
      longest = i;
  }
  const Index opposite = 3 * face + longest;
  const auto corners = face_corners(face);
  const Point& corner = corners[previous_in_face(opposite) % 3];
  return 0.5 * cross_length(from_to(corner, corners[opposite % 3]),
                            from_to(corner, corners[next_in_face(opposite) % 3]));
}

double Mesh::mean_angle_defect() const {
  double sum = 0.0;
  Index count = 0;
  for (Index v = 0; v < vertex_count(); ++v) {
    if (fan_[v] != Fan::closed) continue;
    sum += std::abs(total_angle_[v] - 2.0 * std::numbers::pi);
    ++count;
  }
  return count == 0 ? 0.0 : sum / count;
}

void require_lengths(const Mesh& mesh, const std::string& what, double least_mean, double greatest) {
  require_lengths(mesh.mean_edge_length(), mesh.longest_edge_length(), what, {least_mean, greatest});
}

}  // namespace vorogeo
