// Points as weights of vertices; two share a face if one holds the vertices of both.
#include "support/surface_walk.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "support/hostile_parts.h"

namespace vorogeo::test {

SurfaceWalk::SurfaceWalk(const Soup& soup, const std::vector<std::array<Index, 3>>& faces)
    : soup_(soup), faces_(faces), faces_of_vertex_(soup.positions.size()) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (Index v : faces[f]) faces_of_vertex_[v].push_back(static_cast<Index>(f));
  }
}

SurfaceWalk::Place SurfaceWalk::place_of(const SurfacePoint& point) const {
  if (point.is_vertex()) return {{point.vertex, 1.0}};
  Place place;
  for (int i = 0; i < 3; ++i) {
    if (point.barycentric[i] != 0.0) place.push_back({faces_[point.face][i], point.barycentric[i]});
  }
  return place;
}

bool SurfaceWalk::share_face(const Place& a, const Place& b) const {
  return std::ranges::any_of(faces_of_vertex_[a.front().vertex], [&](Index f) {
    auto holds = [&](const Weight& weight) {
      return std::ranges::find(faces_[f], weight.vertex) != faces_[f].end();
    };
    return std::ranges::all_of(a, holds) && std::ranges::all_of(b, holds);
  });
}

double SurfaceWalk::step(const Place& a, const Place& b) const {
  // Each point relative to its nearest corner, whose own weight, close to 1, then does not matter.
  auto nearest = [](const Place& place) {
    return std::ranges::max_element(place, {}, &Weight::share)->vertex;
  };
  const Index origin = nearest(a);
  auto relative = [&](const Place& place) {
    const Index corner = nearest(place);
    Point sum{};
    for (const auto& [vertex, share] : place) {
      for (int k = 0; k < 3; ++k) sum[k] += share * (soup_.positions[vertex][k] - soup_.positions[corner][k]);
    }
    for (int k = 0; k < 3; ++k) sum[k] += soup_.positions[corner][k] - soup_.positions[origin][k];
    return sum;
  };
  const Point p = relative(a);
  const Point q = relative(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

std::string SurfaceWalk::fault(const SurfacePath& path, const SurfacePoint& first,
                               const SurfacePoint& last) const {
  if (path.points.empty()) return "it has no points";
  std::vector<Place> places;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const SurfacePoint& point = path.points[i];
    const std::string name = "its point " + std::to_string(i);
    if (point.is_vertex()) {
      if (point.vertex >= static_cast<Index>(soup_.positions.size()))
        return name + " is no vertex of the mesh";
    } else {
      if (point.face < 0 || point.face >= static_cast<Index>(faces_.size())) return name + " is in no face";
      double sum = 0.0;
      for (double w : point.barycentric) {
        if (!(w >= 0.0)) return name + " has a negative weight or none";
        sum += w;
      }
      if (!(std::abs(sum - 1.0) <= 1e-9)) return name + " has weights that do not sum to 1";
    }
    places.push_back(place_of(point));
    if (i > 0 && !share_face(places[i - 1], places[i])) {
      return name + " shares no face with the one before";
    }
  }
  auto is_at = [&](const Place& place, const SurfacePoint& asked) {
    const Place wanted = place_of(asked);
    if (!share_face(place, wanted)) return false;
    // The same weights up to rounding; positions are not enough, as vertices may coincide.
    auto share_in = [](const Place& in, Index vertex) {
      for (const Weight& weight : in) {
        if (weight.vertex == vertex) return weight.share;
      }
      return 0.0;
    };
    auto agree = [&](const Weight& weight) {
      return std::abs(share_in(place, weight.vertex) - share_in(wanted, weight.vertex)) <= 1e-9;
    };
    return std::ranges::all_of(place, agree) && std::ranges::all_of(wanted, agree);
  };
  if (!is_at(places.front(), first)) return "it begins elsewhere";
  if (!is_at(places.back(), last)) return "it ends elsewhere";
  return {};
}

double SurfaceWalk::length(const SurfacePath& path) const {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    sum += step(place_of(path.points[i - 1]), place_of(path.points[i]));
  }
  return sum;
}

std::string path_fault(const Mesh& mesh, const SurfacePath& path, const SurfacePoint& target,
                       const SurfacePoint& source) {
  Soup soup{{}, mesh.faces()};
  for (Index v = 0; v < mesh.vertex_count(); ++v) soup.positions.push_back(mesh.position(v));
  const SurfaceWalk walk(soup, soup.faces);
  SurfacePath checked = path;
  for (SurfacePoint& point : checked.points) point = validated(mesh, point);
  const std::string fault = walk.fault(checked, validated(mesh, target), validated(mesh, source));
  if (!fault.empty()) return fault;
  const double length = walk.length(checked);
  if (std::abs(length - path.length) <= 1e-9 * path.length + 1e-14 * mesh.longest_edge_length()) return {};
  std::ostringstream text;
  text.precision(17);
  text << "its steps sum to " << length << ", not " << path.length;
  return text.str();
}

}  // namespace vorogeo::test
