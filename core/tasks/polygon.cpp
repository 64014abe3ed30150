// Polygons whose sides are shortest paths: their area, perimeter and angles, and what lies inside.
#include "tasks/polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "mesh/vectors.h"
#include "support/error.h"
#include "tasks/path_through.h"

namespace vorogeo {

namespace {

constexpr double pi = std::numbers::pi;

std::vector<ExactPath> legs_between(Surface& surface, const PointList& points, const TaskOptions& options) {
  std::vector<SurfacePoint> ends(points.begin(), points.end());
  std::ranges::rotate(ends, ends.begin() + 1);
  Answered answered;
  std::vector<ExactPath> legs;
  for (ExactPath& one : surface.paths({points, ends}, options.by, {.exact = true},
                                      options.answered ? *options.answered : answered, options.progress)) {
    const std::size_t i = legs.size();
    if (one.path.points.empty()) {
      refuse_leg(*surface.mesh(), i, points[i], (i + 1) % points.size(), ends[i]);
    }
    legs.push_back(std::move(one));
  }
  return legs;
}

/// \throw InvalidInput for a leg without length, and where two legs share more than their beginning.
void require_simple(const std::vector<std::vector<Index>>& legs) {
  const auto empty = std::ranges::find_if(legs, [](const auto& leg) { return leg.empty(); });
  if (empty != legs.end()) {
    const auto number = static_cast<std::size_t>(empty - legs.begin());
    throw InvalidInput("Points " + std::to_string(number) + " and " +
                       std::to_string((number + 1) % legs.size()) +
                       " of the polygon are the same; give each once.");
  }
  std::map<Index, std::vector<std::size_t>> legs_at;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    for (const Index point : legs[k]) legs_at[point].push_back(k);
  }
  std::set<std::pair<std::size_t, std::size_t>> meeting;
  for (const auto& [point, at] : legs_at) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t j = i + 1; j < at.size(); ++j) meeting.insert(std::minmax(at[i], at[j]));
    }
  }
  for (const auto& [i, j] : meeting) {
    if (i == j) continue;
    const std::set<Index> other(legs[j].begin(), legs[j].end());
    const auto shared = std::ranges::count_if(legs[i], [&](Index point) { return other.contains(point); });
    // The points from the common end on that both legs pass.
    std::ptrdiff_t together = 0;
    const auto count = [&](auto a, auto b, auto a_end, auto b_end) {
      together += std::mismatch(a, a_end, b, b_end).first - a;
    };
    if (j == i + 1) count(legs[i].rbegin(), legs[j].begin(), legs[i].rend(), legs[j].end());
    if (i == 0 && j + 1 == legs.size())
      count(legs[i].begin(), legs[j].rbegin(), legs[i].end(), legs[j].rend());
    if (shared == together) continue;
    throw InvalidInput(
        "Legs " + std::to_string(i) + " and " + std::to_string(j) +
        " of the polygon cross or touch; give its points in an order in which they do not (leg " +
        std::to_string(i) + " begins at point " + std::to_string(i) + ").");
  }
}

/// A cut mesh, its faces side by side, and measures in the metric of the mesh.
class CutSurface {
 public:
  CutSurface(const Mesh& mesh, const CutMesh& cut) : mesh_(mesh), cut_(cut), sides_(sorted_sides(cut)) {}

  /// By region 0 or 1, so that it changes at every line, from 0 at `start`; no_index where no other leads.
  /// Empty if there is no such numbering.
  std::vector<Index> sides(Index start) const {
    std::map<std::pair<Index, Index>, int> passes;
    for (const auto& line : cut_.lines) {
      for (std::size_t k = 0; k + 1 < line.size(); ++k) ++passes[std::minmax(line[k], line[k + 1])];
    }
    std::vector<std::vector<std::pair<Index, Index>>> beside(
        1 + static_cast<std::size_t>(std::ranges::max(cut_.region)));
    for (const auto& [ends, count] : passes) {
      const auto faces = std::ranges::equal_range(sides_, ends, {}, &FaceSide::ends);
      for (const FaceSide& f : faces) {
        for (const FaceSide& g : faces) {
          if (f.face != g.face) beside[cut_.region[f.face]].push_back({cut_.region[g.face], count % 2});
        }
      }
    }
    std::vector<Index> side(beside.size(), no_index);
    std::vector<Index> next{start};
    side[start] = 0;
    while (!next.empty()) {
      const Index region = next.back();
      next.pop_back();
      for (const auto& [other, changes] : beside[region]) {
        const Index wanted = side[region] ^ changes;
        if (side[other] == no_index) {
          side[other] = wanted;
          next.push_back(other);
        } else if (side[other] != wanted) {
          return {};
        }
      }
    }
    return side;
  }

  std::array<Point, 3> corners(Index face) const {
    const Index whole = cut_.face_of[face];
    const auto at = mesh_.face_corners(whole);
    std::array<Point, 3> places{};
    for (int i = 0; i < 3; ++i) {
      std::array<double, 3> weights{};
      weights_in_face(mesh_, cut_.points[cut_.faces[face][i]], whole, weights);
      for (int c = 0; c < 3; ++c) places[i] = moved(places[i], weights[c], at[c]);
    }
    return places;
  }

  /// Calls visit(ends, sides of faces) for each edge.
  template <class Visit>
  void for_each_edge(Visit&& visit) const {
    for (auto next = sides_.begin(); next != sides_.end();) {
      const auto first = next;
      while (next != sides_.end() && next->ends == first->ends) ++next;
      visit(first->ends, std::span(first, next));
    }
  }

 private:
  const Mesh& mesh_;
  const CutMesh& cut_;
  std::vector<FaceSide> sides_;
};

double area_of(const std::array<Point, 3>& corners) {
  return 0.5 * length_of(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])));
}

double angle_at(const std::array<Point, 3>& corners, int i) {
  const Point u = minus(corners[(i + 1) % 3], corners[i]);
  const Point v = minus(corners[(i + 2) % 3], corners[i]);
  return std::atan2(length_of(cross(u, v)), dot(u, v));
}

}  // namespace

GeodesicPolygon geodesic_polygon(Surface& surface, const PointList& given, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  const PointList points = points_on(mesh, given, "Point");
  if (points.size() < 3) {
    throw InvalidInput("A polygon has three points or more; there are " + std::to_string(points.size()) +
                       ".");
  }
  GeodesicPolygon polygon;
  require_both_ways_alike(mesh, "Polygons");
  polygon.legs = legs_between(surface, points, options);
  std::vector<std::vector<SurfacePoint>> lines;
  for (const ExactPath& leg : polygon.legs) {
    polygon.perimeter += leg.path.length;
    lines.push_back(leg.path.points);
  }
  const Watch watch(options.progress, "Polygon");
  polygon.cut = cut_along(mesh, lines);
  const CutMesh& cut = polygon.cut;
  require_simple(cut.lines);
  const CutSurface parts(mesh, cut);

  // The two sides, and their areas.
  const auto at_first = std::ranges::find_if(cut.faces, [&](const std::array<Index, 3>& face) {
    return std::ranges::find(face, cut.lines[0][0]) != face.end() &&
           std::ranges::find(face, cut.lines[0][1]) != face.end();
  });
  const std::vector<Index> side = parts.sides(cut.region[at_first - cut.faces.begin()]);
  std::array<double, 2> area{};
  std::array<bool, 2> is_there{};
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    const Index own = side.empty() ? no_index : side[cut.region[f]];
    if (own == no_index) continue;
    is_there[own] = true;
    area[own] += area_of(parts.corners(static_cast<Index>(f)));
  }
  std::set<std::pair<Index, Index>> along;
  for (const auto& [a, b] : cut.edges) along.insert(std::minmax(a, b));
  std::array<bool, 2> has_border{};
  bool lines_are_border = true;
  parts.for_each_edge([&](const std::pair<Index, Index>& ends, std::span<const FaceSide> faces) {
    const Index own = side.empty() ? no_index : side[cut.region[faces[0].face]];
    if (along.contains(ends)) {
      lines_are_border = lines_are_border && faces.size() == 1;
    } else if (faces.size() == 1 && own != no_index) {
      has_border[own] = true;
    }
  });
  const bool is_all = is_there[0] && !is_there[1] && lines_are_border;
  if (!is_there[0] || (!is_there[1] && !is_all)) {
    throw InvalidInput(
        "The legs of the polygon have the same side left and right, as around a handle or a tube or from "
        "border to border, so it has no inside; give points around a part that they can separate.");
  }
  const bool is_second = has_border[0] != has_border[1] ? has_border[0] : area[1] < area[0];
  const Index inside = !is_all && is_second ? 1 : 0;
  polygon.area = area[inside];

  // Angles, and the borders and Euler characteristic of the inside.
  const auto is_inside = [&](Index f) { return side[cut.region[f]] == inside; };
  std::map<Index, double> angle;  // by point of the cut that is in the inside or on its border
  std::vector<bool> is_whole(mesh.face_count(), false), is_cut(mesh.face_count(), false);
  Index euler = 0;
  for (std::size_t f = 0; f < cut.faces.size(); ++f) {
    if (!is_inside(static_cast<Index>(f))) {
      is_cut[cut.face_of[f]] = true;
      continue;
    }
    ++euler;
    polygon.cut_faces.push_back(static_cast<Index>(f));
    is_whole[cut.face_of[f]] = true;
    const auto corners = parts.corners(static_cast<Index>(f));
    for (int i = 0; i < 3; ++i) angle[cut.faces[f][i]] += angle_at(corners, i);
  }
  std::map<Index, int> border_edges;  // by point
  parts.for_each_edge([&](const std::pair<Index, Index>& ends, std::span<const FaceSide> faces) {
    const auto count = std::ranges::count_if(faces, is_inside, &FaceSide::face);
    if (count > 0) --euler;
    if (count != 1) return;
    ++border_edges[ends.first];
    ++border_edges[ends.second];
  });
  euler += static_cast<Index>(angle.size());
  std::set<Index> ends_of_legs;
  for (const auto& leg : cut.lines) {
    ends_of_legs.insert(leg.front());
    const auto found = angle.find(leg.front());
    polygon.angles.push_back(found == angle.end() ? 0.0 : found->second);
  }
  polygon.gauss_bonnet = 2.0 * pi * euler;
  for (const auto& [point, sum] : angle) {
    const auto found = border_edges.find(point);
    if (point >= mesh.vertex_count() && !ends_of_legs.contains(point)) continue;
    if (found != border_edges.end()) {
      polygon.gauss_bonnet -= 0.5 * pi * found->second - sum;
      continue;
    }
    polygon.curvature += 2.0 * pi - sum;
    if (point < mesh.given_vertex_count()) polygon.vertices.push_back(point);
  }
  polygon.gauss_bonnet -= polygon.curvature;
  for (Index f = 0; f < mesh.first_bridge();) {
    const Index given_face = mesh.input_face(f);
    bool is_in = true;
    for (; f < mesh.first_bridge() && mesh.input_face(f) == given_face; ++f) {
      is_in = is_in && is_whole[f] && !is_cut[f];
    }
    if (is_in) polygon.faces.push_back(given_face);
  }
  return polygon;
}

}  // namespace vorogeo
