// What is unusual about a mesh, counted and said in sentences.
#include "mesh/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <sstream>
#include <vector>

#include "mesh/outliers.h"
#include "mesh/surface_locator.h"
#include "mesh/vectors.h"
#include "support/disjoint_sets.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Loops of border edges, and borders near each other

namespace {

/// Borders closer than this fraction of their edge lengths are near each other.
constexpr double near_share = 0.1;
/// They are connected, and not reported, if a path along edges joins them that is at most this many border
/// edges long. The path round the end of a slit whose sides are one edge each has length 2.
constexpr double joined_edges = 1.5;
/// Limits of the work for one vertex, so that dense clusters of border vertices and vertices with thousands
/// of edges cost time proportional to their number. A walk that is cut short is treated like a path found: no
/// warning without proof.
constexpr int max_neighbours = 1024;
constexpr int max_steps = 4096;

/// The vertices that paths along edges reach from a vertex within a length.
class Walk {
 public:
  explicit Walk(const Mesh& mesh) : mesh_(mesh), distance_(mesh.vertex_count(), unreachable) {}

  /// \return false if the walk was cut short.
  bool run(Index start, double length) {
    for (Index v : seen_) distance_[v] = unreachable;
    seen_.clear();
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    int steps = 0;
    auto reach = [&](Index vertex, double distance) {
      if (distance > length || distance >= distance_[vertex]) return;
      if (distance_[vertex] == unreachable) seen_.push_back(vertex);
      distance_[vertex] = distance;
      open.emplace(distance, vertex);
    };
    reach(start, 0.0);
    while (!open.empty()) {
      const auto [distance, vertex] = open.top();
      open.pop();
      if (distance > distance_[vertex]) continue;
      for (Index h : mesh_.corners(vertex)) {
        if (++steps > max_steps) return false;
        const Index previous = Mesh::previous_in_face(h);
        reach(mesh_.head(h), distance + mesh_.edge_length(mesh_.edge_of(h)));
        reach(mesh_.tail(previous), distance + mesh_.edge_length(mesh_.edge_of(previous)));
      }
    }
    return true;
  }
  bool reached(Index vertex) const { return distance_[vertex] != unreachable; }

 private:
  const Mesh& mesh_;
  std::vector<double> distance_;
  std::vector<Index> seen_;
};

/// Mean length of the border edges at each vertex; 0 where there is none.
std::vector<double> border_edge_lengths(const Mesh& mesh) {
  std::vector<double> sum(mesh.vertex_count(), 0.0);
  std::vector<Index> count(mesh.vertex_count(), 0);
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    if (!mesh.is_border_edge(edge)) continue;
    for (Index v : mesh.edge_vertices(edge)) {
      sum[v] += mesh.edge_length(edge);
      ++count[v];
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= std::max<Index>(count[v], 1);
  return sum;
}

}  // namespace

std::vector<Index> face_groups(const Mesh& mesh, Index vertex) {
  const auto corners = mesh.corners(vertex);
  std::vector<std::pair<Index, Index>> place;  // of each corner among them, by half-edge
  for (std::size_t i = 0; i < corners.size(); ++i) place.emplace_back(corners[i], static_cast<Index>(i));
  std::sort(place.begin(), place.end());
  auto place_of = [&](Index corner) {
    return std::lower_bound(place.begin(), place.end(), std::pair{corner, Index{0}})->second;
  };
  DisjointSets groups(static_cast<Index>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (Index side : {corners[i], Mesh::previous_in_face(corners[i])}) {
      const Index next = mesh.next_around_edge(side);
      groups.join(static_cast<Index>(i),
                  place_of(mesh.tail(next) == vertex ? next : Mesh::next_in_face(next)));
    }
  }
  std::vector<Index> result(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) result[i] = groups.root(static_cast<Index>(i));
  return result;
}

std::vector<Index> border_loops_of_edges(const Mesh& mesh) {
  DisjointSets loops(mesh.edge_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.is_border(v)) continue;
    const auto corners = mesh.corners(v);
    const std::vector<Index> group = face_groups(mesh, v);
    std::vector<Index> edge_of_group(corners.size(), no_index);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      for (Index side : {corners[i], Mesh::previous_in_face(corners[i])}) {
        const Index edge = mesh.edge_of(side);
        if (!mesh.is_border_edge(edge)) continue;
        Index& first = edge_of_group[group[i]];
        if (first == no_index) first = edge;
        loops.join(edge, first);
      }
    }
  }
  std::vector<Index> loop(mesh.edge_count(), no_index);
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    if (mesh.is_border_edge(edge)) loop[edge] = loops.root(edge);
  }
  return loop;
}

BorderLoops find_border_loops(const Mesh& mesh) {
  const std::vector<Index> loop_of = border_loops_of_edges(mesh);
  std::vector<double> length(mesh.edge_count(), 0.0);
  std::vector<Index> edges(mesh.edge_count(), 0);
  BorderLoops result;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const Index loop = loop_of[edge];
    if (loop == no_index) continue;
    length[loop] += mesh.edge_length(edge);
    result.count += edges[loop]++ == 0;
  }
  Index longest = no_index;
  for (Index loop = 0; loop < mesh.edge_count(); ++loop) {
    if (edges[loop] > 0 && (longest == no_index || length[loop] > length[longest])) longest = loop;
  }
  if (longest == no_index) return result;
  result.longest_length = length[longest];
  result.longest_edges = edges[longest];
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    if (loop_of[edge] != longest) continue;
    const Index v = mesh.edge_vertices(edge)[0];
    if (result.longest_vertex == no_index || v < result.longest_vertex) result.longest_vertex = v;
  }
  return result;
}

NearBorders find_near_borders(const Mesh& mesh) {
  const std::vector<double> edge = border_edge_lengths(mesh);
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (edge[v] > 0.0) vertices.push_back(v);
  }
  NearBorders result;
  if (vertices.empty()) return result;
  std::vector<Box> boxes;
  boxes.reserve(vertices.size());
  for (const Index v : vertices) boxes.push_back({mesh.position(v), mesh.position(v)});
  const BoxTree tree(boxes);
  Walk walk(mesh);
  for (const Index u : vertices) {
    double least = near_share * edge[u];
    Index nearest = no_index;
    bool walked = false;
    bool ended = false;
    const auto look_at = [&](Index place) {
      const Index v = vertices[place];
      const double distance = distance_between(mesh.position(u), mesh.position(v));
      if (v == u || distance > near_share * edge[v] || (nearest != no_index && distance >= least))
        return least;
      if (mesh.component(u) == mesh.component(v)) {
        if (!walked) ended = walk.run(u, joined_edges * edge[u]);
        walked = true;
        if (!ended || walk.reached(v)) return least;
      }
      nearest = v;
      least = distance;
      return least;
    };
    const auto box_of = [&](Index place) -> const Box& { return boxes[place]; };
    tree.visit_near({mesh.position(u), mesh.position(u)}, least, max_neighbours, box_of, look_at);
    if (nearest == no_index) continue;
    if (result.count++ == 0) result.first = u;
    if (result.closest[0] == no_index || least < result.least) {
      result.least = least;
      result.closest = {u, nearest};
    }
    result.greatest = std::max(result.greatest, least);
  }
  return result;
}

// ---- For each border vertex, the border edges near it, by a tree of their boxes

namespace {

/// How far a vertex inside an edge may lie from it: this fraction of the edge's length, and of the largest
/// coordinate, which files often hold in single precision (6e-8 for each coordinate).
constexpr double off_share = 1e-6;
constexpr double off_coordinate = 2e-7;
/// But no farther than this fraction of the edge: small edges far from the origin have lost their directions.
constexpr double max_off = 1e-2;
/// Border edges examined for one vertex, so that a heap of edges at one place costs time proportional to
/// their number.
constexpr int max_edges = 1024;

double tolerance(const Mesh& mesh, Index edge) {
  double greatest = 0.0;
  for (Index v : mesh.edge_vertices(edge)) {
    for (double x : mesh.position(v)) greatest = std::max(greatest, std::abs(x));
  }
  const double length = mesh.edge_length(edge);
  return std::min(max_off * length, off_share * length + off_coordinate * greatest);
}

/// Whether a point lies on the edge, away from its ends.
bool is_inside(const Mesh& mesh, Index edge, const Point& point) {
  const double length = mesh.edge_length(edge);
  if (!(length > 0.0)) return false;
  const auto [a, b] = mesh.edge_vertices(edge);
  const Point& from = mesh.position(a);
  const Point& to = mesh.position(b);
  const double off = tolerance(mesh, edge);
  double along = 0.0;
  for (int k = 0; k < 3; ++k) along += (point[k] - from[k]) * ((to[k] - from[k]) / length);
  if (!(along > off && along < length - off)) return false;
  Point foot{};
  for (int k = 0; k < 3; ++k) foot[k] = std::lerp(from[k], to[k], along / length);
  return distance_between(point, foot) <= off && distance_between(point, from) > off &&
         distance_between(point, to) > off;
}

}  // namespace

TJunctions find_t_junctions(const Mesh& mesh) {
  TJunctions result;
  std::vector<Index> edges;
  std::vector<Box> boxes;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (!mesh.is_border_edge(e)) continue;
    const auto [a, b] = mesh.edge_vertices(e);
    const double off = tolerance(mesh, e);
    Box box{mesh.position(a), mesh.position(a)};
    box.add({mesh.position(b), mesh.position(b)});
    for (int k = 0; k < 3; ++k) {
      box.low[k] -= off;
      box.high[k] += off;
    }
    edges.push_back(e);
    boxes.push_back(box);
  }
  if (edges.empty()) return result;
  const BoxTree tree(boxes);
  for (const Index v : checked(mesh.vertex_count())) {
    if (!mesh.is_border(v)) continue;
    Index found = no_index;
    // Once an edge is found, nothing is near enough any more.
    auto look_at = [&](Index place) {
      const Index edge = edges[place];
      const auto& own = mesh.face_vertices(Mesh::face_of(mesh.edge_halfedge(edge)));
      const bool is_corner = std::ranges::find(own, v) != own.end();
      if (found == no_index && !is_corner && is_inside(mesh, edge, mesh.position(v))) found = edge;
      return found == no_index ? 0.0 : -1.0;
    };
    const auto box_of = [&](Index place) -> const Box& { return boxes[place]; };
    tree.visit_near({mesh.position(v), mesh.position(v)}, 0.0, max_edges, box_of, look_at);
    if (found == no_index) continue;
    if (result.count++ == 0) {
      result.first = v;
      result.first_edge = mesh.edge_vertices(found);
    }
  }
  return result;
}

// ---- The report on a triangle soup: the raw arrays first, then how the faces are connected

namespace {

/// A face has zero area if its area is below this fraction of its longest edge squared. Rounding of double
/// coordinates alone leaves about 1e-16; the thinnest needles of real CAD meshes keep more than 1e-7.
constexpr double zero_area_share = 1e-14;

void note(MeshFinding& finding, std::size_t element) {
  if (finding.count++ == 0) finding.first = static_cast<Index>(element);
}

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// Computed from coordinates: from edge lengths, half of the digits of a small area would be lost.
bool has_no_area(const Point& a, const Point& b, const Point& c) {
  Point u = minus(b, a);
  Point v = minus(c, a);
  // Scaled, so that squares of very small or large coordinates neither vanish nor overflow.
  double scale = 0.0;
  for (int k = 0; k < 3; ++k) scale = std::max({scale, std::abs(u[k]), std::abs(v[k])});
  if (scale == 0.0) return true;
  for (int k = 0; k < 3; ++k) {
    u[k] /= scale;
    v[k] /= scale;
  }
  const Point normal = cross(u, v);
  const Point third = minus(u, v);
  const double longest = std::max({dot(u, u), dot(v, v), dot(third, third)});
  return 0.5 * std::sqrt(dot(normal, normal)) < zero_area_share * longest;
}

void check_vertices(const std::vector<Point>& positions, MeshReport& report) {
  std::vector<Index> order;
  order.reserve(positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (is_finite(positions[v])) {
      order.push_back(static_cast<Index>(v));
    } else {
      note(report.non_finite_vertices, v);
    }
  }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return positions[a] != positions[b] ? positions[a] < positions[b] : a < b;
  });
  Index first = no_index;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (positions[order[i]] != positions[order[i - 1]]) continue;
    ++report.duplicate_vertices.count;
    if (first == no_index || order[i] < first) first = order[i];
  }
  report.duplicate_vertices.first = first;
}

/// Faces that can be connected: indices in range, three different vertices. Fills `origin` with their input
/// indices.
std::vector<std::array<Index, 3>> check_faces(const std::vector<Point>& positions,
                                              const std::vector<std::array<Index, 3>>& faces,
                                              MeshReport& report, std::vector<Index>& origin) {
  std::vector<std::array<Index, 3>> usable;
  usable.reserve(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [a, b, c] = faces[f];
    if (std::min({a, b, c}) < 0 || std::max({a, b, c}) >= report.vertices) {
      note(report.faces_out_of_range, f);
    } else if (a == b || b == c || c == a) {
      note(report.faces_with_repeated_vertex, f);
    } else {
      usable.push_back(faces[f]);
      origin.push_back(static_cast<Index>(f));
      const bool finite = is_finite(positions[a]) && is_finite(positions[b]) && is_finite(positions[c]);
      if (finite && has_no_area(positions[a], positions[b], positions[c])) note(report.zero_area_faces, f);
    }
  }
  return usable;
}

void check_edges(const Mesh& mesh, const std::vector<Index>& origin, MeshReport& report) {
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const Index h = mesh.edge_halfedge(edge);
    const Index other = mesh.next_around_edge(h);
    const Index face = origin[mesh.input_face(Mesh::face_of(h))];
    if (other == h) {
      ++report.border_edges;
    } else if (mesh.next_around_edge(other) != h) {
      if (report.non_manifold_edges.count == 0) report.first_non_manifold_edge = mesh.edge_vertices(edge);
      note(report.non_manifold_edges, face);
    } else if (mesh.tail(h) == mesh.tail(other)) {
      note(report.inconsistent_edges, face);
    }
  }
}

void check_fans(const Mesh& mesh, MeshReport& report) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.corners(v).empty()) note(report.isolated_vertices, v);
    if (mesh.fan(v) != Mesh::Fan::non_manifold) continue;
    const std::vector<Index> group = face_groups(mesh, v);
    if (std::ranges::adjacent_find(group, std::not_equal_to<>()) != group.end())
      note(report.non_manifold_vertices, v);
  }
}

/// Components that have a face, the one with most vertices first.
void check_components(const Mesh& mesh, MeshReport& report) {
  std::vector<MeshComponent> component(mesh.component_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    MeshComponent& of = component[mesh.component(v)];
    if (of.vertices++ == 0) of.first_vertex = v;
  }
  for (const auto& face : mesh.faces()) ++component[mesh.component(face[0])].faces;
  std::erase_if(component, [](const MeshComponent& of) { return of.faces == 0; });
  std::ranges::stable_sort(component, std::greater<>(), &MeshComponent::vertices);
  report.components = static_cast<Index>(component.size());
  report.component_sizes = std::move(component);
}

void check_duplicates(const Mesh& mesh, const std::vector<Index>& origin, MeshReport& report) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < origin.size(); ++i) {
    if (kept < static_cast<std::size_t>(mesh.face_count()) &&
        mesh.input_face(static_cast<Index>(kept)) == static_cast<Index>(i)) {
      ++kept;
    } else {
      note(report.duplicate_faces, origin[i]);
    }
  }
}

/// What bridges would join. Edge lengths are within exact_lengths.
void check_gaps(const Mesh& mesh, MeshReport& report) {
  if (report.components > 1) report.gap_to_join_all = gap_to_join_all(mesh, report.gap.folds);
  report.components_after_bridging = report.components;
  if (report.gap.length == 0.0) return;
  const GapBridges bridges = find_gap_bridges(mesh, report.gap);
  const Mesh bridged(mesh.positions(), mesh.faces(), bridges);
  report.joined_borders = count_joined_borders(mesh, bridged);
  report.components_after_bridging = components_with_faces(bridged);
}

/// Edges longer than 0, but so short that the coordinates hold few digits of their length.
void check_rounding(const Mesh& mesh, MeshReport& report) {
  constexpr double least_units = 1e4;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    double greatest = 0.0;
    for (const Index v : mesh.edge_vertices(edge)) {
      for (const double coordinate : mesh.position(v)) greatest = std::max(greatest, std::abs(coordinate));
    }
    const double length = mesh.edge_length(edge);
    if (length > 0.0 && length < least_units * std::numeric_limits<double>::epsilon() * greatest) {
      note(report.rounded_edges, mesh.edge_vertices(edge)[0]);
    }
  }
}

}  // namespace

MeshReport check_mesh(const std::vector<Point>& positions, const std::vector<std::array<Index, 3>>& faces,
                      const GapLimit& gap) {
  MeshReport report;
  report.vertices = static_cast<Index>(positions.size());
  report.faces = static_cast<Index>(faces.size());
  report.gap = gap;
  require_gap(gap);
  check_vertices(positions, report);
  std::vector<Index> origin;
  const auto usable = check_faces(positions, faces, report, origin);
  // The connectivity does not depend on positions, so vertices that Mesh would refuse are set to the origin.
  std::vector<Point> finite = positions;
  for (Point& p : finite) {
    if (!is_finite(p)) p = {};
  }
  const Mesh mesh(std::move(finite), usable);
  check_duplicates(mesh, origin, report);
  check_edges(mesh, origin, report);
  check_fans(mesh, report);
  check_components(mesh, report);
  if (report.non_finite_vertices.count > 0) return report;
  report.mean_edge_length = mesh.mean_edge_length();
  report.longest_edge_length = mesh.longest_edge_length();
  const Outliers outliers = find_outliers(mesh);
  report.outliers = {outliers.count, outliers.first};
  report.outlier_ratio = outliers.least_ratio;
  check_rounding(mesh, report);
  report.border_loops = find_border_loops(mesh);
  if (!report.fits(exact_lengths)) return report;
  report.near_borders = find_near_borders(mesh);
  const TJunctions t_junctions = find_t_junctions(mesh);
  report.t_junctions = {t_junctions.count, t_junctions.first};
  report.first_t_junction_edge = t_junctions.first_edge;
  check_gaps(mesh, report);
  return report;
}

// ---- What the report on a mesh says: one sentence for each finding, and a summary

namespace {

/// "1 face has" or "3 faces have", from "face has|faces have".
std::string counted(Index count, const std::string& forms) {
  const auto bar = forms.find('|');
  return std::to_string(count) + " " + (count == 1 ? forms.substr(0, bar) : forms.substr(bar + 1));
}

/// "10,000".
std::string grouped(double power_of_ten) {
  std::ostringstream text;
  text.precision(0);
  text << std::fixed << power_of_ten;
  std::string digits = text.str();
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3) digits.insert(at, 1, ',');
  return digits;
}

std::string number(double value) {
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
}

/// Four digits of a value, not below it.
std::string number_above(double value) {
  const double unit = value > 0.0 ? std::pow(10.0, std::floor(std::log10(value)) - 3.0) : 1.0;
  return number(std::ceil(value / unit * (1.0 - 1e-12)) * unit);
}

/// "2000, 40 and 3 vertices (the first: 0, 2000 and 2040)".
std::string sizes_of(const std::vector<MeshComponent>& components) {
  constexpr std::size_t max_named = 5;
  const std::size_t named = std::min(components.size(), max_named);
  std::string sizes;
  std::string vertices;
  for (std::size_t i = 0; i < named; ++i) {
    const std::string comma = i == 0 ? "" : i + 1 == components.size() ? " and " : ", ";
    sizes += comma + std::to_string(components[i].vertices);
    vertices += comma + std::to_string(components[i].first_vertex);
  }
  const std::size_t rest = components.size() - named;
  const std::string more = rest == 0 ? "" : " and " + std::to_string(rest) + " more";
  return sizes + more + " vertices (the first of each: " + vertices + more + ")";
}

}  // namespace

std::vector<std::string> MeshReport::sentences() const {
  std::vector<std::string> result;
  auto say = [&](const MeshFinding& finding, const std::string& forms, const std::string& where,
                 const std::string& meaning) {
    if (finding.count == 0) return;
    const std::string first = finding.count == 1 ? " (" : " (the first: ";
    result.push_back(counted(finding.count, forms) + first + where + "); " + meaning);
  };
  auto vertex = [](const MeshFinding& finding) { return "vertex " + std::to_string(finding.first); };
  auto face = [](const MeshFinding& finding) { return "face " + std::to_string(finding.first); };

  if (faces == 0) result.emplace_back("The mesh has no face; distances over a surface need at least one.");
  say(non_finite_vertices,
      "vertex has a coordinate that is not a finite number|vertices have a coordinate that is not a finite "
      "number",
      vertex(non_finite_vertices), "such a mesh is refused: repair it or remove its bad vertices.");
  say(faces_out_of_range, "face names a vertex that does not exist|faces name a vertex that does not exist",
      face(faces_out_of_range),
      "such a mesh is refused: it has " + vertex_range(vertices) + "; repair it or remove its bad faces.");
  say(faces_with_repeated_vertex, "face names a vertex twice|faces name a vertex twice",
      face(faces_with_repeated_vertex), "left out.");
  say(duplicate_faces,
      "face has the three vertices of an earlier face|faces have the three vertices of an earlier face",
      face(duplicate_faces), "left out.");
  say(zero_area_faces, "face has no area|faces have no area", face(zero_area_faces),
      "kept as a connection without width, which paths cross at no cost.");
  say(duplicate_vertices,
      "vertex lies at the position of an earlier vertex|vertices lie at the position of an earlier vertex",
      vertex(duplicate_vertices),
      "not joined to it, so paths pass only where faces connect; merge close vertices first if they should "
      "be one.");
  say(isolated_vertices, "vertex belongs to no face|vertices belong to no face", vertex(isolated_vertices),
      "not reached by any path.");
  say(non_manifold_edges, "edge has three or more faces|edges have three or more faces",
      "between vertices " + std::to_string(first_non_manifold_edge[0]) + " and " +
          std::to_string(first_non_manifold_edge[1]) + ", at face " +
          std::to_string(non_manifold_edges.first),
      "paths may turn from each of the faces into any other.");
  say(non_manifold_vertices,
      "vertex joins faces that share no edge there|vertices join faces that share no edge there",
      vertex(non_manifold_vertices), "paths may pass through the vertex from any of the faces to any other.");
  say(inconsistent_edges,
      "edge lies between faces of opposite orientation|edges lie between faces of opposite orientation",
      "at face " + std::to_string(inconsistent_edges.first), "this does not change distances.");
  say(t_junctions,
      "vertex lies inside a border edge of another face|vertices lie inside a border edge of another face",
      vertex(t_junctions) + ", on the edge between vertices " + std::to_string(first_t_junction_edge[0]) +
          " and " + std::to_string(first_t_junction_edge[1]),
      "no path crosses such a T-junction: split the edge at the vertex if the surface should be joined.");
  say(rounded_edges,
      "edge is hardly longer than its coordinates are rounded|edges are hardly longer than their coordinates "
      "are rounded",
      "at " + vertex(rounded_edges),
      "distances are those of the coordinates as they are given, which hold fewer than four digits of such a "
      "length: "
      "move the mesh to the origin before it is rounded.");
  // 17234 typical edges are given as 10,000: the order of magnitude is enough.
  const std::string ratio =
      outliers.count == 0 ? "" : grouped(std::pow(10.0, std::floor(std::log10(outlier_ratio) + 1e-9)));
  say(outliers,
      "vertex lies " + ratio + " times farther out than the rest|vertices lie " + ratio +
          " times farther out than the rest",
      vertex(outliers),
      "distances between the others are not affected (up to 1e13 times); remove them if they are errors of "
      "measurement or no-data values.");
  if (components > 1) {
    result.push_back(std::to_string(components) + " components, of " + sizes_of(component_sizes) +
                     "; no path leads from one to another.");
    if (gap_to_join_all < unreachable) {
      result.push_back("Bridging gaps of " +
                       (gap_to_join_all > 0.0 ? "up to " + number_above(gap_to_join_all)
                                              : std::string("any width, as borders touch,")) +
                       " would make the components one.");
    }
  }
  if (gap.length > 0.0) {
    result.push_back("Bridging gaps of up to " + number(gap.length) + " joins " +
                     counted(joined_borders, "border|borders") + " of " + std::to_string(border_loops.count) +
                     " and leaves " + counted(components_after_bridging, "component|components") + ".");
  }
  if (near_borders.count > 0) {
    result.push_back(counted(near_borders.count, "border vertex lies|border vertices lie") + " close to " +
                     (near_borders.count == 1 ? "another" : "others") +
                     " that no short path leads to (the closest: " + "vertices " +
                     std::to_string(near_borders.closest[0]) + " and " +
                     std::to_string(near_borders.closest[1]) + ", " + number(near_borders.least) +
                     " apart; the farthest: " + number(near_borders.greatest) +
                     "); paths cross such gaps only if they are bridged, or the vertices merged.");
  }
  const double factor = factor_to_unit(mean_edge_length, longest_edge_length);
  auto say_scale = [&](const std::string& who, const LengthLimits& limits) {
    result.push_back("Edges are " + number(mean_edge_length) + " long on average and up to " +
                     number(longest_edge_length) + ", but " + who + " mean lengths of at least " +
                     number(limits.least_mean) + " and edges of at most " + number(limits.greatest) +
                     ": multiply the coordinates, for example by " + number(factor) +
                     ", and divide the distances by it.");
  };
  if (!fits(exact_lengths)) {
    say_scale("distances take", exact_lengths);
  } else if (!fits(index_lengths)) {
    say_scale("an index takes", index_lengths);
  }
  return result;
}

std::string MeshReport::summary() const {
  std::string result = counted(vertices, "vertex|vertices") + ", " + counted(faces, "face|faces") + ", " +
                       counted(components, "component|components") + ", " +
                       counted(border_loops.count, "border loop|border loops");
  if (border_loops.count > 0) {
    result += std::string(border_loops.count == 1 ? " (" : " (the longest: ") +
              counted(border_loops.longest_edges, "edge|edges") + ", " + number(border_loops.longest_length) +
              " long, at vertex " + std::to_string(border_loops.longest_vertex) + ")";
  }
  return result + ".";
}

}  // namespace vorogeo
