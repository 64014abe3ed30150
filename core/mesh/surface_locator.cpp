// Boxes split at the median of their longest side; nearest point of a triangle after Ericson (2004),
// section 5.1.5.
#include "mesh/surface_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>

#include "mesh/mesh.h"
#include "mesh/vectors.h"
#include "support/error.h"

namespace vorogeo {

// ---- The tree of boxes

namespace {

constexpr Index max_in_leaf = 8;

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& items) : order_(items.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) build(items, 0, static_cast<Index>(order_.size()));
}

Index BoxTree::build(const std::vector<Box>& items, Index begin, Index end) {
  const auto id = static_cast<Index>(nodes_.size());
  Box bounds = items[order_[begin]];
  for (Index i = begin; i < end; ++i) bounds.add(items[order_[i]]);
  nodes_.push_back({bounds, begin, end});
  if (end - begin <= max_in_leaf) return id;
  const auto& [low, high] = bounds;
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
  }
  const Index middle = begin + (end - begin) / 2;
  const auto place = [&](Index item) { return items[item].low[axis] + items[item].high[axis]; };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index u, Index v) { return place(u) < place(v); });
  build(items, begin, middle);
  const Index second = build(items, middle, end);
  nodes_[id].second = second;
  return id;
}

void BoxTree::common_labels(const std::vector<Index>& label_of_item, std::vector<Index>& label) const {
  label.resize(nodes_.size());
  for (auto id = static_cast<Index>(nodes_.size()) - 1; id >= 0; --id) {
    const Node& node = nodes_[id];
    if (node.second != no_index) {
      label[id] = label[id + 1] == label[node.second] ? label[id + 1] : no_index;
      continue;
    }
    label[id] = label_of_item[order_[node.begin]];
    for (Index i = node.begin; i < node.end; ++i) {
      if (label_of_item[order_[i]] != label[id]) label[id] = no_index;
    }
  }
}

// ---- The point of a triangle nearest to a point in space

namespace {

/// Weights below this are rounding: the point lies on the edge or at the vertex.
constexpr double least_weight = 1e-12;

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

double square_to_box(const Point& p, const Box& box) {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double outside = std::max({0.0, box.low[k] - p[k], p[k] - box.high[k]});
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

/// Boxes of all faces but bridges. \throw InvalidInput for a mesh that has no points in space.
std::vector<Box> boxes_of_faces(const Mesh& mesh) {
  if (mesh.face_count() == 0) throw InvalidInput("The mesh has no face to which a point could be moved.");
  if (!mesh.has_positions()) {
    throw InvalidInput(
        "Points in space cannot be moved to a surface that has edge lengths and no positions; name faces and "
        "barycentric weights, or give positions as well.");
  }
  require_lengths(mesh, "moving points to the surface takes", exact_lengths);
  std::vector<Box> boxes;
  boxes.reserve(mesh.first_bridge());
  for (Index f = 0; f < mesh.first_bridge(); ++f) {
    const auto& [a, b, c] = mesh.face_vertices(f);
    boxes.push_back({mesh.position(a), mesh.position(a)});
    for (Index v : {b, c}) boxes.back().add({mesh.position(v), mesh.position(v)});
  }
  return boxes;
}

}  // namespace

SurfaceLocator::SurfaceLocator(std::shared_ptr<const Mesh> mesh)
    : mesh_(std::move(mesh)), tree_(boxes_of_faces(*mesh_)) {}

Point SurfaceLocator::drawn_near(const Point& point) const {
  const Box& all = tree_.bounds();
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
  auto look_at = [&](Index face) {
    const auto& [a, b, c] = mesh_->face_vertices(face);
    const SurfacePoint found = SurfacePoint::in_face(
        face, nearest_weights(point, mesh_->position(a), mesh_->position(b), mesh_->position(c)));
    const Point away = minus(position_of(*mesh_, found), point);
    const double square = dot(away, away);
    if (square < least || (square == least && face < best.face)) {
      least = square;
      best = found;
    }
    return least;
  };
  tree_.search(
      unreachable, [&](const Box& box) { return square_to_box(point, box); }, look_at);
  double sum = 0.0;
  for (double& weight : best.barycentric) {
    if (weight < least_weight) weight = 0.0;
    sum += weight;
  }
  for (double& weight : best.barycentric) weight /= sum;
  return {validated(*mesh_, best), length_of(minus(position_of(*mesh_, best), given))};
}

double SurfaceLocator::ray_length(const SurfacePoint& from, const Point& direction) const {
  constexpr double rounding = 1e-9;  // of weights, and of the sides of the faces that the ray leaves
  const Point origin = position_of(*mesh_, from);
  std::vector<Index> own;
  double least = 0.0;
  for_each_face_at(*mesh_, from, [&](Index face, const std::array<double, 3>&) {
    own.push_back(face);
    for (const Index v : mesh_->face_vertices(face)) {
      least = std::max(least, rounding * distance_between(mesh_->position(v), origin));
    }
  });
  // Boxes of faces perpendicular to an axis have no thickness, hence the slack. NaN: the ray misses the box.
  const double slack = 1e-12 * length_of(minus(tree_.bounds().high, tree_.bounds().low));
  const auto entry = [&](const Box& box) {
    double first = 0.0, last = unreachable;
    for (int k = 0; k < 3; ++k) {
      const double low = box.low[k] - slack - origin[k], high = box.high[k] + slack - origin[k];
      if (direction[k] == 0.0 && (low > 0.0 || high < 0.0)) last = -1.0;
      if (direction[k] == 0.0) continue;
      const auto [enters, leaves] = std::minmax({low / direction[k], high / direction[k]});
      first = std::max(first, enters);
      last = std::min(last, leaves);
    }
    return first <= last ? first : std::numeric_limits<double>::quiet_NaN();
  };
  double nearest = unreachable;
  const auto look_at = [&](Index face) {
    const auto& [a, b, c] = mesh_->face_vertices(face);
    const Point ab = minus(mesh_->position(b), mesh_->position(a));
    const Point ac = minus(mesh_->position(c), mesh_->position(a));
    const Point normal = cross(ab, ac), ao = minus(origin, mesh_->position(a));
    const double falls = -dot(direction, normal);
    if (std::abs(falls) <= 1e-14 * length_of(normal)) return nearest;
    const Point turned = cross(ao, direction);
    const double at = dot(ao, normal) / falls, second = dot(ac, turned) / falls,
                 third = -dot(ab, turned) / falls;
    const bool is_hit = second >= -rounding && third >= -rounding && second + third <= 1.0 + rounding;
    if (is_hit && at > least && at < nearest && std::ranges::find(own, face) == own.end()) nearest = at;
    return nearest;
  };
  tree_.search(unreachable, entry, look_at);
  return nearest;
}

}  // namespace vorogeo
