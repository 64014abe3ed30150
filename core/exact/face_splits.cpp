// A mesh whose faces are split at sources inside them.
#include "exact/face_splits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "exact/edge_axes.h"

namespace vorogeo {

// ---- Points in a triangle

namespace {

class Triangulation {
 public:
  explicit Triangulation(std::span<const PlanePoint> points) : points_(points), triangles_{{0, 1, 2}} {
    for (Index p = 3; p < static_cast<Index>(points.size()); ++p) add(p);
  }
  std::vector<std::array<Index, 3>> triangles() && { return std::move(triangles_); }

 private:
  double twice_area(Index a, Index b, Index c) const {
    return cross_in_plane(minus_in_plane(points_[b], points_[a]), minus_in_plane(points_[c], points_[a]));
  }
  /// Twice the least area of the triangles that a point makes with the sides of a triangle.
  double depth(const std::array<Index, 3>& triangle, Index point) const {
    const auto& [a, b, c] = triangle;
    return std::min({twice_area(a, b, point), twice_area(b, c, point), twice_area(c, a, point)});
  }
  /// Above 0 where d is inside the circle through a, b and c.
  double in_circle(Index a, Index b, Index c, Index d) const {
    const PlanePoint u = minus_in_plane(points_[a], points_[d]), v = minus_in_plane(points_[b], points_[d]),
                     w = minus_in_plane(points_[c], points_[d]);
    return dot_in_plane(u, u) * cross_in_plane(v, w) + dot_in_plane(v, v) * cross_in_plane(w, u) +
           dot_in_plane(w, w) * cross_in_plane(u, v);
  }

  /// Wherever rounding places the point, it divides one triangle into three.
  void add(Index point) {
    const auto around = std::ranges::max_element(
        triangles_, {}, [&](const std::array<Index, 3>& triangle) { return depth(triangle, point); });
    const auto [a, b, c] = *around;
    *around = {point, a, b};
    triangles_.push_back({point, b, c});
    triangles_.push_back({point, c, a});
    std::vector<std::array<Index, 2>> sides{{a, b}, {b, c}, {c, a}};
    while (!sides.empty()) {
      const auto [from, to] = sides.back();
      sides.pop_back();
      turn(point, from, to, sides);
    }
  }

  /// Flips the side opposite a new point, if the circle of side and point contains the point behind the side.
  void turn(Index point, Index from, Index to, std::vector<std::array<Index, 2>>& sides) {
    std::array<Index, 3>*own = nullptr, *beside = nullptr;
    Index behind = no_index;
    for (auto& triangle : triangles_) {
      for (int i = 0; i < 3; ++i) {
        const Index a = triangle[i], b = triangle[(i + 1) % 3], c = triangle[(i + 2) % 3];
        if (a == from && b == to && c == point) own = &triangle;
        if (a != to || b != from) continue;
        beside = &triangle;
        behind = c;
      }
    }
    if (own == nullptr || beside == nullptr || !(in_circle(point, from, to, behind) > 0.0) ||
        !(twice_area(point, from, behind) > 0.0) || !(twice_area(point, behind, to) > 0.0))
      return;
    *own = {point, from, behind};
    *beside = {point, behind, to};
    sides.push_back({from, behind});
    sides.push_back({behind, to});
  }

  std::span<const PlanePoint> points_;
  std::vector<std::array<Index, 3>> triangles_;
};

}  // namespace

std::vector<std::array<Index, 3>> triangulated(std::span<const std::array<double, 2>> points) {
  return Triangulation(points).triangles();
}

// ---- The mesh

SplitAtSources::SplitAtSources(const ExactGeometry& geometry, std::span<const ExactSource> sources,
                               std::span<const Index> inside)
    : given_(*geometry.mesh) {
  // By face, the points in it; those in one place are one vertex.
  std::map<Index, std::vector<Weights>> points_in;
  for (const Index source : inside)
    points_in[sources[source].point.face].push_back(sources[source].point.barycentric);
  std::vector<Point> positions = given_.positions();
  std::vector<std::array<Index, 3>> faces;
  SideLengths sides;
  std::map<std::pair<Index, Weights>, Index> vertex_at;
  for (Index f = 0; f < given_.face_count(); ++f) {
    const auto first = static_cast<Index>(faces.size());
    const auto& corners = given_.face_vertices(f);
    if (const auto found = points_in.find(f); found == points_in.end()) {
      faces.push_back(corners);
      if (given_.has_metric()) sides.push_back(given_.side_lengths(f));
    } else {
      auto& points = found->second;
      std::ranges::sort(points);
      points.erase(std::ranges::unique(points).begin(), points.end());
      const FacePlane plane(geometry, f);
      std::vector<PlanePoint> places(plane.corner.begin(), plane.corner.end());
      std::vector<Index> vertices(corners.begin(), corners.end());
      for (const Weights& weights : points) {
        places.push_back(plane.at(weights));
        vertices.push_back(static_cast<Index>(positions.size()));
        vertex_at[{f, weights}] = vertices.back();
        added_.push_back(SurfacePoint::in_face(f, weights));
        positions.push_back(given_.has_positions() ? position_of(given_, added_.back()) : no_position);
      }
      for (const auto& part : triangulated(places)) {
        faces.push_back({vertices[part[0]], vertices[part[1]], vertices[part[2]]});
        if (!given_.has_metric()) continue;
        auto& lengths = sides.emplace_back();
        for (int i = 0; i < 3; ++i) {
          const Index a = part[(i + 1) % 3], b = part[(i + 2) % 3];
          const PlanePoint way = minus_in_plane(places[a], places[b]);
          lengths[i] = a < 3 && b < 3 ? given_.side_lengths(f)[3 - a - b] : std::hypot(way[0], way[1]);
        }
      }
    }
    parts_of_.push_back({first, static_cast<Index>(faces.size())});
    given_face_.resize(faces.size(), f);
  }
  mesh_ = mesh_in_metric_of(given_, std::move(positions), std::move(faces), std::move(sides));
  for (const ExactSource& source : sources) {
    const auto vertex = vertex_at.find({source.point.face, source.point.barycentric});
    sources_.push_back(
        {vertex == vertex_at.end() ? point_in_parts(source.point) : SurfacePoint::at_vertex(vertex->second),
         source.offset});
  }
}

/// \pre The point is a vertex or on a side of its face, or the face is not split.
SurfacePoint SplitAtSources::point_in_parts(const SurfacePoint& point) const {
  if (point.is_vertex()) return point;
  const auto [first, end] = parts_of_[point.face];
  if (end - first == 1) return SurfacePoint::in_face(first, point.barycentric);
  for (Index part = first; part < end; ++part) {
    const auto &corners = mesh_->face_vertices(part), &given = given_.face_vertices(point.face);
    Weights weights{};
    bool is_there = true;
    for (int k = 0; k < 3; ++k) {
      const auto corner = std::ranges::find(corners, given[k]);
      if (corner != corners.end()) weights[corner - corners.begin()] = point.barycentric[k];
      is_there = is_there && (corner != corners.end() || point.barycentric[k] == 0.0);
    }
    if (is_there) return SurfacePoint::in_face(part, weights);
  }
  return point;
}

/// Where the corner of a part is in the face given.
SplitAtSources::Weights SplitAtSources::weights_of(Index part, int corner) const {
  const Index vertex = mesh_->face_vertices(part)[corner], count = given_.vertex_count();
  if (vertex >= count) return added_[vertex - count].barycentric;
  Weights weights{};
  for (int k = 0; k < 3; ++k) weights[k] = given_.face_vertices(given_face_[part])[k] == vertex ? 1.0 : 0.0;
  return weights;
}

SurfacePoint SplitAtSources::given_point(const SurfacePoint& point) const {
  if (point.is_vertex()) {
    const Index count = given_.vertex_count();
    return point.vertex < count ? point : added_[point.vertex - count];
  }
  const Index face = given_face_[point.face];
  if (parts_of_[face][1] - parts_of_[face][0] == 1) return SurfacePoint::in_face(face, point.barycentric);
  Weights weights{};
  for (int i = 0; i < 3; ++i) {
    const Weights corner = weights_of(point.face, i);
    for (int k = 0; k < 3; ++k) weights[k] += point.barycentric[i] * corner[k];
  }
  return canonical(given_, SurfacePoint::in_face(face, weights));
}

}  // namespace vorogeo
