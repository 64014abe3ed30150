// The report on a triangle soup: findings on the raw arrays first, then on the connectivity of the usable
// faces.
#include "mesh/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vorogeo {

namespace {

/// A face counts as having no area below this share of its longest edge squared. Rounding of double
/// coordinates alone leaves about 1e-16; the thinnest needles of real CAD meshes keep more than 1e-7.
constexpr double zero_area_share = 1e-14;

void note(MeshFinding& finding, std::size_t element) {
  if (finding.count++ == 0) finding.first = static_cast<Index>(element);
}

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

double squared_length(const Point& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; }

/// From coordinates, not from edge lengths: those lose half of the digits of a small area.
bool has_no_area(const Point& a, const Point& b, const Point& c) {
  Point u = difference(b, a);
  Point v = difference(c, a);
  // Scaled, so that squares of very small or large coordinates neither vanish nor overflow.
  double scale = 0.0;
  for (int k = 0; k < 3; ++k) scale = std::max({scale, std::abs(u[k]), std::abs(v[k])});
  if (scale == 0.0) return true;
  for (int k = 0; k < 3; ++k) {
    u[k] /= scale;
    v[k] /= scale;
  }
  const Point normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double longest = std::max({squared_length(u), squared_length(v), squared_length(difference(u, v))});
  return 0.5 * std::sqrt(squared_length(normal)) < zero_area_share * longest;
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

/// Counts the groups of faces around each vertex that edges at the vertex hold together.
void check_fans(const Mesh& mesh, MeshReport& report) {
  std::vector<Index> parent(3 * static_cast<std::size_t>(mesh.face_count()));
  std::iota(parent.begin(), parent.end(), 0);
  auto root = [&](Index h) {
    while (parent[h] != h) h = parent[h] = parent[parent[h]];
    return h;
  };
  std::vector<std::uint8_t> component_seen(mesh.component_count(), 0);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const auto corners = mesh.corners(v);
    if (corners.empty()) {
      note(report.isolated_vertices, v);
      continue;
    }
    if (!component_seen[mesh.component(v)]) {
      component_seen[mesh.component(v)] = 1;
      ++report.components;
    }
    if (mesh.fan(v) != Mesh::Fan::non_manifold) continue;
    auto groups = static_cast<Index>(corners.size());
    for (Index corner : corners) {
      for (Index side : {corner, Mesh::previous_in_face(corner)}) {
        const Index next = mesh.next_around_edge(side);
        const Index a = root(corner);
        const Index b = root(mesh.tail(next) == v ? next : Mesh::next_in_face(next));
        if (a != b) {
          parent[a] = b;
          --groups;
        }
      }
    }
    if (groups > 1) note(report.non_manifold_vertices, v);
  }
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

/// "1 face has" or "3 faces have", from "face has|faces have".
std::string counted(Index count, const std::string& forms) {
  const auto bar = forms.find('|');
  return std::to_string(count) + " " + (count == 1 ? forms.substr(0, bar) : forms.substr(bar + 1));
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
      "such a mesh is refused: it has " +
          (vertices == 0 ? std::string("no vertices") : "vertices 0 to " + std::to_string(vertices - 1)) +
          "; repair it or remove its bad faces.");
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
  return result;
}

MeshReport check_mesh(const std::vector<Point>& positions, const std::vector<std::array<Index, 3>>& faces) {
  MeshReport report;
  report.vertices = static_cast<Index>(positions.size());
  report.faces = static_cast<Index>(faces.size());
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
  return report;
}

}  // namespace vorogeo
