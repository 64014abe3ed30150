// Directions at a point of the surface: the angles of the edges around it, and the frame they count in.
#include "exact/tangent_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mesh/vectors.h"
#include "support/error.h"

namespace vorogeo {

namespace {

using std::numbers::pi;

/// Angles around a vertex that sum to less are rounding: directions there would be a guess.
constexpr double least_total_angle = 1e-9;

[[noreturn]] void refuse(const std::string& where, const std::string& why) {
  throw InvalidInput("There are no directions at " + where + ": " + why + "; take another point.");
}

Point unit(const Point& vector) {
  const double length = length_of(vector);
  return {vector[0] / length, vector[1] / length, vector[2] / length};
}

}  // namespace

TangentFrame::TangentFrame(const ExactGeometry& geometry, const SurfacePoint& point)
    : geometry_(&geometry), point_(point), full_turn_(2.0 * pi) {
  point.is_vertex() ? view_from_vertex() : view_from_face();
  std::ranges::sort(views_, {}, &EdgeView::halfedge);
}

bool TangentFrame::exists_at(const Mesh& mesh, Index vertex) {
  const auto fan = mesh.fan(vertex);
  return (fan == Mesh::Fan::closed || fan == Mesh::Fan::open) && mesh.total_angle(vertex) > least_total_angle;
}

void TangentFrame::view_from_vertex() {
  const Mesh& mesh = *geometry_->mesh;
  const Index vertex = point_.vertex;
  const std::string name = "vertex " + std::to_string(vertex);
  const auto fan = mesh.fan(vertex);
  if (fan == Mesh::Fan::isolated) refuse(name, "no face has it");
  if (fan == Mesh::Fan::non_manifold) {
    refuse(name, "its faces are not one fan, or an edge there has no length, so that angles have no order");
  }
  const auto corners = mesh.corners(vertex);
  const double total = mesh.total_angle(vertex);
  if (!exists_at(mesh, vertex)) refuse(name, "the angles of its faces sum to " + std::to_string(total));
  full_turn_ = (fan == Mesh::Fan::open ? 2.0 : 1.0) * total;
  // The corners are listed in one direction or the other, from a border if there is one.
  const auto last = std::ranges::max_element(corners);
  is_clockwise_ = geometry_->begins_at_own_edge[*last] == 0;
  const std::size_t count = corners.size();
  const std::size_t border = is_clockwise_ ? count - 1 : 0;
  const std::size_t first =
      fan == Mesh::Fan::open ? border : static_cast<std::size_t>(last - corners.begin());
  double begin = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Index corner = corners[(first + (is_clockwise_ ? count - i : i)) % count];
    const bool begins_at_own = (geometry_->begins_at_own_edge[corner] != 0) != is_clockwise_;
    if (i == 0) first_halfedge_ = begins_at_own ? corner : Mesh::previous_in_face(corner);
    const double end = begin + mesh.corner_angle(corner);
    const Index opposite = Mesh::next_in_face(corner);
    const FaceFrame& frame = geometry_->frame[opposite];
    const int sign = frame.along == begins_at_own ? 1 : -1;
    const double across = (sign > 0 ? begin : end) - sign * std::atan2(-frame.apex_x, frame.apex_depth);
    views_.push_back({opposite, frame.apex_x, frame.apex_depth, across, sign});
    begin = end;
  }
}

void TangentFrame::view_from_face() {
  const Mesh& mesh = *geometry_->mesh;
  first_halfedge_ = 3 * point_.face;
  // Directions of the half-edges of the point's face.
  const double second = pi - mesh.corner_angle(3 * point_.face + 1);
  const std::array<double, 3> own{0.0, second, second + pi - mesh.corner_angle(3 * point_.face + 2)};
  for_each_face_at(mesh, point_, [&](Index face, const std::array<double, 3>& weights) {
    const std::string name =
        "a point of face " + std::to_string(mesh.is_bridge(face) ? face : mesh.input_face(face));
    if (!(mesh.face_area(face) > 0.0)) refuse(name, "it has no area");
    // A half-edge of this face, its direction, and whether angles grow from the face's edges inwards.
    Index known = 3 * face;
    double direction = 0.0;
    int orientation = 1;
    if (face != point_.face) {
      while (weights[(known + 2) % 3] > 0.0) ++known;
      const Index edge = mesh.edge_of(known);
      if (mesh.edge_face_count(edge) > 2) {
        refuse(name + " on its edge from vertex " + std::to_string(mesh.edge_vertices(edge)[0]) + " to " +
                   std::to_string(mesh.edge_vertices(edge)[1]),
               "three faces or more meet there");
      }
      const Index beside = mesh.next_around_edge(known);
      orientation = mesh.tail(beside) == mesh.tail(known) ? -1 : 1;
      direction = own[beside % 3] + (orientation > 0 ? pi : 0.0);
    }
    for (int i = 0; i < 3; ++i) {
      if (weights[(known + 2) % 3] > 0.0) {
        const FaceFrame& frame = geometry_->frame[known];
        const double at_apex = weights[(known + 2) % 3];
        const double at_second = weights[frame.along ? (known + 1) % 3 : known % 3];
        views_.push_back({known, at_second * mesh.side_length(known) + at_apex * frame.apex_x,
                          at_apex * frame.apex_depth, direction - orientation * 0.5 * pi,
                          frame.along ? orientation : -orientation});
      }
      known = Mesh::next_in_face(known);
      direction += orientation * (pi - mesh.corner_angle(known));
    }
  });
}

bool TangentFrame::is_on_border() const {
  if (point_.is_vertex()) return geometry_->mesh->fan(point_.vertex) == Mesh::Fan::open;
  return views_.size() == 2;  // one face, on whose third edge the point lies
}

const EdgeView& TangentFrame::view(Index halfedge) const {
  return *std::ranges::lower_bound(views_, halfedge, {}, &EdgeView::halfedge);
}

double TangentFrame::angle_in_face(Index face, const std::array<double, 3>& weights) const {
  // By the nearest edge: where the point is its end, the position has all its digits.
  const auto at_apex = [&](const EdgeView& seen) { return weights[(seen.halfedge + 2) % 3]; };
  const auto begin = std::ranges::lower_bound(views_, 3 * face, {}, &EdgeView::halfedge);
  const auto end = std::ranges::lower_bound(begin, views_.end(), 3 * face + 3, {}, &EdgeView::halfedge);
  const EdgeView& seen = *std::ranges::min_element(begin, end, {}, at_apex);
  const Index h = seen.halfedge;
  const FaceFrame& frame = geometry_->frame[h];
  const double at_second = weights[frame.along ? (h + 1) % 3 : h % 3];
  return seen.angle_to(at_second * geometry_->mesh->side_length(h) + at_apex(seen) * frame.apex_x,
                       -at_apex(seen) * frame.apex_depth);
}

int TangentFrame::orientation(Index face) const {
  const EdgeView& seen = *std::ranges::lower_bound(views_, 3 * face, {}, &EdgeView::halfedge);
  return geometry_->frame[seen.halfedge].along ? seen.sign : -seen.sign;
}

double TangentFrame::angle_to(Index face, Index vertex) const {
  const auto& corners = geometry_->mesh->face_vertices(face);
  std::array<double, 3> weights{};
  weights[std::ranges::find(corners, vertex) - corners.begin()] = 1.0;
  return angle_in_face(face, weights);
}

Tangent TangentFrame::vector(double angle, double length) const {
  return {length * std::cos(scaled(angle)), length * std::sin(scaled(angle))};
}

double TangentFrame::angle_of(const Tangent& vector) const {
  const double angle = std::atan2(vector[1], vector[0]);
  return (angle < 0.0 ? angle + 2.0 * pi : angle) * (full_turn_ / (2.0 * pi));
}

std::array<Point, 3> TangentFrame::axes() const {
  const Mesh& mesh = *geometry_->mesh;
  const auto between = [&](Index a, Index b) { return minus(mesh.position(b), mesh.position(a)); };
  const auto normal_of = [&](Index face) {
    const auto& [a, b, c] = mesh.face_vertices(face);
    return unit(cross(between(a, b), between(a, c)));
  };
  if (!point_.is_vertex()) {
    const Point x = unit(between(mesh.tail(first_halfedge_), mesh.head(first_halfedge_)));
    const Point normal = normal_of(point_.face);
    return {x, cross(normal, x), normal};
  }
  Point normal{};
  for (const Index corner : mesh.corners(point_.vertex)) {
    const Index face = Mesh::face_of(corner);
    if (!(mesh.face_area(face) > 0.0)) continue;
    const bool is_own = (geometry_->begins_at_own_edge[corner] != 0) != is_clockwise_;
    normal = moved(normal, (is_own ? 1.0 : -1.0) * mesh.corner_angle(corner), normal_of(face));
  }
  normal = unit(normal);
  // The edges, each turned back by its angle.
  Point x{};
  for (const EdgeView& seen : views_) {
    const FaceFrame& frame = geometry_->frame[seen.halfedge];
    const Index edge = mesh.edge_of(seen.halfedge);
    for (const int k : {0, 1}) {
      const Index side = k == 0 ? frame.first_side(seen.halfedge) : frame.second_side(seen.halfedge);
      const Point out = between(point_.vertex, geometry_->ends(edge)[k]);
      const Point flat = moved(out, -dot(out, normal), normal);
      const auto [along, aside] = vector(-seen.angle_to(k * mesh.edge_length(edge)),
                                         mesh.is_border_edge(mesh.edge_of(side)) ? 1.0 : 0.5);
      x = moved(moved(x, along, flat), aside, cross(normal, flat));
    }
  }
  x = unit(x);
  return {x, cross(normal, x), normal};
}

}  // namespace vorogeo
