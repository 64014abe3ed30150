// Box: exact distances by the straight lines over all unfoldings of its six sides.
#include <algorithm>
#include <cmath>
#include <map>

#include "support/shapes.h"
#include "support/unrolled.h"

namespace vorogeo::test {

namespace {

/// Corner c of the box lies at ((c & 1), (c >> 1 & 1), (c >> 2 & 1)) times the size. A side lists its corners
/// in cyclic order, counter-clockwise seen from outside.
constexpr std::array<std::array<int, 4>, 6> side_corners{
    {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};

using Sides = std::array<Flat, 4>;

double cross(const Flat& origin, const Flat& a, const Flat& b) {
  return (a[0] - origin[0]) * (b[1] - origin[1]) - (a[1] - origin[1]) * (b[0] - origin[0]);
}

/// Searches every sequence of sides, each used once: a shortest path on a convex body enters no side twice.
class BoxUnfolding {
 public:
  explicit BoxUnfolding(const std::array<double, 3>& size) : size_(size) {}

  double distance(int side_p, const Point& p, int side_q, const Point& q) {
    target_side_ = side_q;
    target_ = q;
    best_ = unreachable;
    used_ = {};
    gates_.clear();
    const auto& corners = side_corners[side_p];
    const double u = length(corners[0], corners[1]);
    const double v = length(corners[0], corners[3]);
    const Sides flat{{{0.0, 0.0}, {u, 0.0}, {u, v}, {0.0, v}}};
    source_ = placed(side_p, flat, p);
    visit(side_p, flat);
    return best_;
  }

 private:
  Point corner_position(int corner) const {
    return {(corner & 1) * size_[0], (corner >> 1 & 1) * size_[1], (corner >> 2 & 1) * size_[2]};
  }

  double length(int a, int b) const {
    const Point p = corner_position(a);
    const Point q = corner_position(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  /// Where a point of a side comes to lie, given where the side's corners lie.
  Flat placed(int side, const Sides& flat, const Point& point) const {
    const Point origin = corner_position(side_corners[side][0]);
    Flat result = flat[0];
    for (int axis : {1, 3}) {
      const Point end = corner_position(side_corners[side][axis]);
      double along = 0.0;
      double squared = 0.0;
      for (int k = 0; k < 3; ++k) {
        along += (point[k] - origin[k]) * (end[k] - origin[k]);
        squared += (end[k] - origin[k]) * (end[k] - origin[k]);
      }
      for (int k = 0; k < 2; ++k) result[k] += along / squared * (flat[axis][k] - flat[0][k]);
    }
    return result;
  }

  /// The straight line from the source to `target` crosses every edge that was unfolded over.
  bool open(const Flat& target) const {
    return std::all_of(gates_.begin(), gates_.end(), [&](const std::array<Flat, 2>& gate) {
      const double tolerance = 1e-12 * (1.0 + length_between(source_, target));
      return cross(source_, target, gate[0]) * cross(source_, target, gate[1]) <= tolerance;
    });
  }

  void visit(int side, const Sides& flat) {
    used_[side] = true;
    if (side == target_side_) {
      const Flat target = placed(side, flat, target_);
      if (open(target)) best_ = std::min(best_, length_between(source_, target));
    }
    for (int i = 0; i < 4; ++i) {
      const int from = side_corners[side][i];
      const int to = side_corners[side][(i + 1) % 4];
      for (int next = 0; next < 6; ++next) {
        if (used_[next]) continue;
        const auto& corners = side_corners[next];
        for (int k = 0; k < 4; ++k) {
          if (corners[k] != to || corners[(k + 1) % 4] != from) continue;
          // The neighbour lies on the other side of the edge; both run counter-clockwise.
          const double depth = length(corners[(k + 1) % 4], corners[(k + 2) % 4]);
          const double edge = length(from, to);
          const Flat& a = flat[i];
          const Flat& b = flat[(i + 1) % 4];
          const Flat outward{(b[1] - a[1]) / edge * depth, -(b[0] - a[0]) / edge * depth};
          Sides unfolded{};
          unfolded[k] = b;
          unfolded[(k + 1) % 4] = a;
          unfolded[(k + 2) % 4] = {a[0] + outward[0], a[1] + outward[1]};
          unfolded[(k + 3) % 4] = {b[0] + outward[0], b[1] + outward[1]};
          gates_.push_back({a, b});
          visit(next, unfolded);
          gates_.pop_back();
        }
      }
    }
    used_[side] = false;
  }

  std::array<double, 3> size_;
  int target_side_ = 0;
  Point target_{};
  double best_ = unreachable;
  Flat source_{};
  std::array<bool, 6> used_{};
  std::vector<std::array<Flat, 2>> gates_;
};

}  // namespace

Shape box(const std::array<double, 3>& size, int cells) {
  Soup soup;
  std::map<std::array<int, 3>, Index> vertex_at;  // by grid coordinates
  std::vector<int> side_of_face;
  auto vertex = [&](const std::array<int, 3>& grid) {
    const auto [found, added] = vertex_at.try_emplace(grid, static_cast<Index>(soup.positions.size()));
    if (added) {
      soup.positions.push_back(
          {size[0] * grid[0] / cells, size[1] * grid[1] / cells, size[2] * grid[2] / cells});
    }
    return found->second;
  };
  for (int side = 0; side < 6; ++side) {
    const auto& corners = side_corners[side];
    auto grid = [&](int i, int j) {
      std::array<int, 3> g{};
      for (int k = 0; k < 3; ++k) {
        const int origin = corners[0] >> k & 1;
        const int u = (corners[1] >> k & 1) - origin;
        const int v = (corners[3] >> k & 1) - origin;
        g[k] = cells * origin + i * u + j * v;
      }
      return g;
    };
    for (int i = 0; i < cells; ++i) {
      for (int j = 0; j < cells; ++j) {
        add_cell(soup, vertex(grid(i, j)), vertex(grid(i + 1, j)), vertex(grid(i, j + 1)),
                 vertex(grid(i + 1, j + 1)), (i + j) % 2 == 0);
        side_of_face.insert(side_of_face.end(), 2, side);
      }
    }
  }
  Shape shape{std::move(soup), {}};
  shape.distance = [soup = shape.soup, at_vertex = vertices_in_faces(shape.soup), side_of_face, size](
                       const SurfacePoint& p, const SurfacePoint& q) {
    auto located = [&](const SurfacePoint& point) {
      const SurfacePoint& in_face = point.is_vertex() ? at_vertex[point.vertex] : point;
      Point position{};
      for (int i = 0; i < 3; ++i) {
        const Point& corner = soup.positions[soup.faces[in_face.face][i]];
        for (int k = 0; k < 3; ++k) position[k] += in_face.barycentric[i] * corner[k];
      }
      return std::pair{side_of_face[in_face.face], position};
    };
    const auto [side_p, position_p] = located(p);
    const auto [side_q, position_q] = located(q);
    return BoxUnfolding(size).distance(side_p, position_p, side_q, position_q);
  };
  return shape;
}

}  // namespace vorogeo::test
