// Lines drawn on the surface, and isolines of fields.
#include "tasks/surface_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "mesh/mesh_input.h"
#include "support/error.h"
#include "support/lists.h"
#include "support/memory.h"

namespace vorogeo {

// ---- Points of lines, looked up by the element of the mesh on which they lie

double total_length(const SurfaceLines& lines) {
  double sum = 0.0;
  for (const auto& [a, b] : lines.segments) sum += distance_between(lines.points[b], lines.points[a]);
  return sum;
}

std::vector<std::vector<Index>> lines_in_order(std::vector<std::array<Index, 2>> segments,
                                               const std::function<std::string(Index)>& name) {
  for (auto& [a, b] : segments) {
    if (a > b) std::swap(a, b);
  }
  std::erase_if(segments, [](const auto& ends) { return ends[0] == ends[1]; });
  sort_once(segments);
  std::map<Index, std::vector<Index>> beside;
  for (const auto& [a, b] : segments) {
    beside[a].push_back(b);
    beside[b].push_back(a);
  }
  for (const auto& [number, neighbours] : beside) {
    if (neighbours.size() > 2) {
      throw InvalidInput("The curve branches: " + name(number) + " has " + std::to_string(neighbours.size()) +
                         " of its edges. Leave two of them.");
    }
  }
  std::set<Index> passed;
  std::vector<std::vector<Index>> lines;
  for (const bool from_end : {true, false}) {
    for (const auto& [first, others] : beside) {
      if ((from_end && others.size() > 1) || passed.contains(first)) continue;
      std::vector<Index> line{first};
      for (Index from = no_index, next = others[0]; next != no_index && next != first;) {
        from = line.back();
        line.push_back(next);
        const auto& neighbours = beside.at(next);
        next = neighbours[0] != from ? neighbours[0] : neighbours.size() > 1 ? neighbours[1] : no_index;
      }
      passed.insert(line.begin(), line.end());
      if (others.size() > 1) line.push_back(first);
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

Index LineBuilder::point(const Key& key, const Point& position) {
  const auto [place, is_new] = point_of_.try_emplace(key, static_cast<Index>(lines_.points.size()));
  if (is_new) lines_.points.push_back(position);
  return place->second;
}

Index LineBuilder::at_vertex(Index vertex, std::uint64_t line) {
  return point({vertex, line}, mesh_.position(vertex));
}

Index LineBuilder::on_edge(Index edge, double t, std::uint64_t line) {
  const auto [a, b] = mesh_.edge_vertices(edge);
  if (!(t > 0.0)) return at_vertex(a, line);
  if (t >= 1.0) return at_vertex(b, line);
  const Point& p = mesh_.position(a);
  const Point& q = mesh_.position(b);
  Point position{};
  for (int i = 0; i < 3; ++i) position[i] = (1.0 - t) * p[i] + t * q[i];
  return point({std::int64_t{mesh_.vertex_count()} + edge, line}, position);
}

Index LineBuilder::in_face(Index face, const std::array<double, 3>& barycentric, std::uint64_t corner) {
  Point position{};
  for (int c = 0; c < 3; ++c) {
    const Point& p = mesh_.position(mesh_.face_vertices(face)[c]);
    for (int i = 0; i < 3; ++i) position[i] += barycentric[c] * p[i];
  }
  return point({-1 - std::int64_t{face}, corner}, position);
}

bool LineBuilder::add_segment(Index a, Index b) {
  if (a == b) return false;
  if (a > b) std::swap(a, b);
  const auto number = static_cast<Index>(lines_.segments.size());
  if (!segment_of_.try_emplace({a, static_cast<std::uint64_t>(b)}, number).second) return false;
  lines_.segments.push_back({a, b});
  return true;
}

// ---- Marching triangles; crossings of edges are interpolated linearly or as for distances in the plane

double crossing(double at_first, double at_second, double length, double level, Interpolation interpolation) {
  const double linear = (level - at_first) / (at_second - at_first);
  if (interpolation == Interpolation::linear || length <= 0.0 ||
      std::abs(at_second - at_first) > length * (1.0 + 1e-6)) {
    return std::clamp(linear, 0.0, 1.0);
  }
  // With the source at (foot, y), y^2 = at_first^2 - foot^2: the roots of x^2 - 2 foot x + product = 0.
  const double foot = 0.5 * (length + (at_first - at_second) * (at_first + at_second) / length);
  const double product = (at_first - level) * (at_first + level);
  const double root = std::sqrt(std::max(0.0, foot * foot - product));
  const double far = foot + std::copysign(root, foot);
  const double near = far == 0.0 ? 0.0 : product / far;
  const bool rising = at_second > at_first;
  const double x = rising == (foot >= 0.0) ? far : near;
  const double t = x / length;
  return t >= -1e-9 && t <= 1.0 + 1e-9 ? std::clamp(t, 0.0, 1.0) : std::clamp(linear, 0.0, 1.0);
}

void require_field_and_levels(const Mesh& mesh, std::span<const double> field,
                              std::span<const double> levels) {
  if (field.size() != static_cast<std::size_t>(mesh.given_vertex_count())) {
    throw InvalidInput("The field has " + std::to_string(field.size()) + " values, but the mesh has " +
                       std::to_string(mesh.given_vertex_count()) + " vertices; give one value for each.");
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (!std::isfinite(levels[i])) {
      throw InvalidInput("Level " + std::to_string(i) + " is " + std::to_string(levels[i]) +
                         "; levels must be finite numbers.");
    }
  }
}

void require_memory_for_levels(const Mesh& mesh, std::span<const double> values, std::vector<double> levels,
                               double bytes) {
  std::ranges::sort(levels);
  const auto up_to = [&](double value) {
    return static_cast<double>(std::ranges::upper_bound(levels, value) - levels.begin());
  };
  double crossings = 0.0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& corners = mesh.face_vertices(f);
    const std::array<double, 3> at{values[corners[0]], values[corners[1]], values[corners[2]]};
    if (!std::isfinite(at[0] + at[1] + at[2])) continue;
    crossings += up_to(std::max({at[0], at[1], at[2]})) - up_to(std::min({at[0], at[1], at[2]}));
  }
  require_memory(bytes * crossings, 0, "Finding the lines of " + std::to_string(levels.size()) + " levels",
                 "Give fewer levels.");
}

Isolines isolines(const Mesh& mesh, std::span<const double> given, std::span<const double> levels,
                  Interpolation interpolation, const Progress& progress) {
  require_field_and_levels(mesh, given, levels);
  const std::vector<double> values = InputMap(mesh).on_vertices(given);
  constexpr double bytes_per_segment = 165.0;  // measured; most is for finding points and segments again
  require_memory_for_levels(mesh, values, {levels.begin(), levels.end()}, bytes_per_segment);
  std::vector<Index> order(levels.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return levels[a] < levels[b]; });

  const Watch watch(progress, "Isolines");
  Isolines result;
  LineBuilder builder(mesh);
  for (const Index f : checked(mesh.face_count())) {
    const auto& corners = mesh.face_vertices(f);
    const std::array<double, 3> at{values[corners[0]], values[corners[1]], values[corners[2]]};
    if (!std::isfinite(at[0] + at[1] + at[2])) continue;
    const auto [low, high] = std::minmax({at[0], at[1], at[2]});
    auto next = std::upper_bound(order.begin(), order.end(), low,
                                 [&](double value, Index level) { return value < levels[level]; });
    for (; next != order.end() && levels[*next] <= high; ++next) {
      Index end[2];
      int ends = 0;
      for_each_crossing(mesh, values, f, levels[*next], interpolation, [&](Index edge, double t, bool) {
        end[ends++] = builder.on_edge(edge, t, static_cast<std::uint64_t>(*next));
        if (static_cast<std::size_t>(end[ends - 1]) == result.level_of_point.size()) {
          result.level_of_point.push_back(*next);
        }
      });
      if (ends != 2 || !builder.add_segment(end[0], end[1])) continue;
      result.level_of_segment.push_back(*next);
      if (result.level_of_segment.size() % elements_per_checkpoint == 0) checkpoint();
    }
  }
  result.lines = builder.take();
  return result;
}

}  // namespace vorogeo
