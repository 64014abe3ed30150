// Boxes split at the median of their longest side; nearest point of a triangle after Ericson (2004),
// section 5.1.5.
#include "mesh/surface_locator.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>

#include "mesh/mesh.h"
#include "mesh/vectors.h"
#include "support/error.h"

namespace vorogeo {

namespace {

constexpr Index max_in_leaf = 8;
/// Weights below this are rounding: the point lies on the edge or at the vertex.
constexpr double least_weight = 1e-12;

/// Weights of the point of a segment a-b nearest to p.
double along_segment(const Point& p, const Point& a, const Point& b) {
  const Point ab = minus(b, a);
  const double square = dot(ab, ab);
  return square > 0.0 ? std::clamp(dot(minus(p, a), ab) / square, 0.0, 1.0) : 0.0;
}

}  // namespace

std::array<double, 3> nearest_weights(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point ab = minus(b, a);
  const Point ac = minus(c, a);
  const Point ap = minus(p, a);
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  const Point bp = minus(p, b);
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  const Point cp = minus(p, c);
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  const double va = d3 * d6 - d5 * d4;
  const double vb = d5 * d2 - d1 * d6;
  const double vc = d1 * d4 - d3 * d2;
  if (va > 0.0 && vb > 0.0 && vc > 0.0) {
    const double sum = va + vb + vc;
    return {va / sum, vb / sum, vc / sum};
  }
  // Outside the face, or a face without area: the nearest point is on one of the edges.
  std::array<double, 3> best{};
  double least = unreachable;
  const Point* corner[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double t = along_segment(p, *corner[i], *corner[j]);
    Point at{};
    for (int k = 0; k < 3; ++k) at[k] = (1.0 - t) * (*corner[i])[k] + t * (*corner[j])[k];
    const Point away = minus(p, at);
    if (dot(away, away) < least) {
      least = dot(away, away);
      best = {};
      best[i] = 1.0 - t;
      best[j] = t;
    }
  }
  return best;
}

namespace {

double square_to_box(const Point& p, const Point& low, const Point& high) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double outside = std::max({0.0, low[k] - p[k], p[k] - high[k]});
    sum += outside * outside;
  }
  return sum;
}

/// A point farther away than this many diagonals of the mesh is replaced by one at this distance in the same
/// direction from the middle of the mesh's box. That changes which point of the surface is nearest by at most
/// the diagonal divided by this number, which is what a double can hold of such distances.
constexpr double far_in_diagonals = 1e8;
/// Beyond it the length of a vector may overflow.
constexpr double greatest_coordinate = 1e307;

std::string in_words(const Point& point) {
  std::ostringstream text;
  text << "The point (" << point[0] << ", " << point[1] << ", " << point[2] << ")";
  return text.str();
}

}  // namespace

SurfaceLocator::SurfaceLocator(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {
  if (mesh_->face_count() == 0) throw InvalidInput("The mesh has no face to which a point could be moved.");
  if (!mesh_->has_positions()) {
    throw InvalidInput(
        "Points in space cannot be moved to a surface that has edge lengths and no positions; name faces and "
        "barycentric weights, or give positions as well.");
  }
  require_lengths(*mesh_, "moving points to the surface takes", exact_lengths.least_mean,
                  exact_lengths.greatest);
  order_.resize(mesh_->first_bridge());
  std::iota(order_.begin(), order_.end(), 0);
  build(0, mesh_->first_bridge());
}

Index SurfaceLocator::build(Index begin, Index end) {
  const auto id = static_cast<Index>(boxes_.size());
  Box box{{unreachable, unreachable, unreachable}, {-unreachable, -unreachable, -unreachable}, begin, end};
  for (Index i = begin; i < end; ++i) {
    for (Index v : mesh_->face_vertices(order_[i])) {
      for (int k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], mesh_->position(v)[k]);
        box.high[k] = std::max(box.high[k], mesh_->position(v)[k]);
      }
    }
  }
  boxes_.push_back(box);
  if (end - begin <= max_in_leaf) return id;
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
  }
  auto middle_of = [&](Index face) {
    double sum = 0.0;
    for (Index v : mesh_->face_vertices(face)) sum += mesh_->position(v)[axis];
    return sum;
  };
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index f, Index g) { return middle_of(f) < middle_of(g); });
  build(begin, middle);
  const Index second = build(middle, end);
  boxes_[id].second = second;
  return id;
}

Point SurfaceLocator::drawn_near(const Point& point) const {
  const Box& all = boxes_.front();
  Point middle;
  for (int k = 0; k < 3; ++k) middle[k] = 0.5 * all.low[k] + 0.5 * all.high[k];
  const double diagonal = length_of(minus(all.high, all.low));
  const Point offset = minus(point, middle);
  const double distance = length_of(offset);
  if (distance <= far_in_diagonals * diagonal) return point;
  Point result = middle;
  for (int k = 0; k < 3; ++k) result[k] += offset[k] / distance * (far_in_diagonals * diagonal);
  return result;
}

SnappedPoint SurfaceLocator::nearest(const Point& given) const {
  for (double coordinate : given) {
    if (!std::isfinite(coordinate)) {
      throw InvalidInput(in_words(given) +
                         " has a coordinate that is not a finite number; give three finite coordinates.");
    }
    if (std::abs(coordinate) > greatest_coordinate) {
      throw InvalidInput(in_words(given) +
                         " is too far away for its distance to be a number; give coordinates of at "
                         "most 1e307.");
    }
  }
  const Point point = drawn_near(given);
  double least = unreachable;
  SurfacePoint best;
  std::vector<std::pair<double, Index>> open{{0.0, 0}};
  while (!open.empty()) {
    const auto [square, id] = open.back();
    open.pop_back();
    if (square > least) continue;
    const Box& box = boxes_[id];
    if (box.second == no_index) {
      for (Index i = box.begin; i < box.end; ++i) {
        const Index face = order_[i];
        const auto& corners = mesh_->face_vertices(face);
        const auto weights = nearest_weights(point, mesh_->position(corners[0]), mesh_->position(corners[1]),
                                             mesh_->position(corners[2]));
        const SurfacePoint found = SurfacePoint::in_face(face, weights);
        const Point away = minus(position_of(*mesh_, found), point);
        const double found_square = dot(away, away);
        if (found_square < least || (found_square == least && face < best.face)) {
          least = found_square;
          best = found;
        }
      }
      continue;
    }
    const double first = square_to_box(point, boxes_[id + 1].low, boxes_[id + 1].high);
    const double second = square_to_box(point, boxes_[box.second].low, boxes_[box.second].high);
    // The nearer half is searched first.
    if (first <= second) {
      open.emplace_back(second, box.second);
      open.emplace_back(first, id + 1);
    } else {
      open.emplace_back(first, id + 1);
      open.emplace_back(second, box.second);
    }
  }
  double sum = 0.0;
  for (double& weight : best.barycentric) {
    if (weight < least_weight) weight = 0.0;
    sum += weight;
  }
  for (double& weight : best.barycentric) weight /= sum;
  return {validated(*mesh_, best), length_of(minus(position_of(*mesh_, best), given))};
}

}  // namespace vorogeo
