// Fast marching, with obtuse corners unfolded, and over raw meshes across gaps.
#include <cmath>
#include <vector>

#include "mesh/surface_locator.h"
#include "mesh/vectors.h"
#include "methods/method.h"
#include "support/error.h"
#include "support/progress.h"
#include "support/vertex_search.h"

namespace vorogeo {

// ---- Obtuse corners of a mesh, split by a vertex that unfolding finds inside them

namespace {

constexpr int max_unfolded = 64;

/// A triangle in the plane, as fast marching sees it from a corner: two vertices with known values, their
/// distances from the corner's vertex and the angle between them there.
struct MarchingTriangle {
  Index vertex;         ///< the corner's, which gets a value
  Index first, second;  ///< which have one
  double to_first, to_second;
  double cosine;  ///< of the angle at the corner; negative only where no split was found
};

struct Flat {
  double x, y;
};

/// The third vertex of a triangle over the directed line a-b, to its right, by its distances from both.
Flat beside(const Flat& a, const Flat& b, double to_a, double to_b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double length = std::hypot(dx, dy);
  const double along = 0.5 * (length + (to_a - to_b) * (to_a + to_b) / length);
  const double away = std::sqrt(std::fmax(0.0, (to_a - along) * (to_a + along)));
  return {a.x + (along * dx + away * dy) / length, a.y + (along * dy - away * dx) / length};
}

double side_length(const Mesh& mesh, Index halfedge) { return mesh.edge_length(mesh.edge_of(halfedge)); }

struct Split {
  Index vertex = no_index;
  double length = 0.0;
  double x = 0.0, y = 0.0;
};

/// The corner lies in the origin, its first side along the x axis, its second side above it.
Split split_of(const Mesh& mesh, Index corner, double to_first, double to_second, double cosine) {
  const double sine = std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine));
  Flat right{to_first, 0.0};
  Flat left{to_second * cosine, to_second * sine};
  Index crossed = Mesh::next_in_face(corner);
  bool from_right = true;  // whether the crossed half-edge begins at `right`
  for (int i = 0; i < max_unfolded; ++i) {
    const Index twin = mesh.next_around_edge(crossed);
    if (twin == crossed || mesh.next_around_edge(twin) != crossed) return {};
    const bool same = mesh.tail(twin) == mesh.tail(crossed);
    const bool begins_right = same == from_right;
    const Index next = Mesh::next_in_face(twin);
    const Index previous = Mesh::previous_in_face(twin);
    const double to_right = side_length(mesh, begins_right ? previous : next);
    const double to_left = side_length(mesh, begins_right ? next : previous);
    const Flat apex = beside(right, left, to_right, to_left);
    const double with_right = apex.x;  // its sign is that of the cosine
    const double with_left = apex.x * cosine + apex.y * sine;
    if (with_right > 0.0 && with_left > 0.0) {
      return {mesh.apex(twin), std::hypot(apex.x, apex.y), apex.x, apex.y};
    }
    // If the apex lies left of the sector, unfolding goes on through the right side, and vice versa.
    if (with_right <= 0.0) {
      left = apex;
      crossed = begins_right ? previous : next;
      from_right = !begins_right;
    } else {
      right = apex;
      crossed = begins_right ? next : previous;
      from_right = !begins_right;
    }
  }
  return {};
}

/// The triangles at all corners of the mesh. A corner of more than 90 degrees is split: the faces opposite to
/// it are unfolded one after the other until a vertex lies in the sector that leaves two acute angles
/// (Kimmel, Sethian 1998, section 4, "extending to non-acute triangulations"). Where the strip meets a border
/// of the mesh or a non-manifold edge first, or after `max_unfolded` faces, the obtuse triangle stays.
std::vector<MarchingTriangle> marching_triangles(const Mesh& mesh) {
  std::vector<MarchingTriangle> triangles;
  triangles.reserve(3 * static_cast<std::size_t>(mesh.face_count()));
  for (Index corner = 0; corner < 3 * mesh.face_count(); ++corner) {
    const Index vertex = mesh.tail(corner);
    const Index first = mesh.head(corner);
    const Index second = mesh.apex(corner);
    const double to_first = side_length(mesh, corner);
    const double to_second = side_length(mesh, Mesh::previous_in_face(corner));
    const double cosine = std::cos(mesh.corner_angle(corner));
    if (!(to_first > 0.0 && to_second > 0.0)) {
      triangles.push_back({vertex, first, second, to_first, to_second, -1.0});
      continue;
    }
    const Split split = cosine < 0.0 ? split_of(mesh, corner, to_first, to_second, cosine) : Split{};
    if (split.vertex == no_index || split.vertex == vertex || !(split.length > 0.0)) {
      triangles.push_back({vertex, first, second, to_first, to_second, cosine});
      continue;
    }
    const double sine = std::sqrt(std::fmax(0.0, 1.0 - cosine * cosine));
    triangles.push_back({vertex, first, split.vertex, to_first, split.length, split.x / split.length});
    triangles.push_back({vertex, split.vertex, second, split.length, to_second,
                         (split.x * cosine + split.y * sine) / split.length});
  }
  return triangles;
}

// ---- Fast marching on triangles: a plane wave through each triangle, in order of arrival

/// Arrival at the corner of a plane wave of speed 1 with the values `low` <= `high` at the other two
/// vertices, which lie `to_low` and `to_high` away (Kimmel, Sethian 1998, section 4). If no wave comes
/// through the triangle, the value comes along an edge.
double arrival(double low, double high, double to_low, double to_high, double cosine) {
  const double along_edges = std::fmin(low + to_low, high + to_high);
  if (!(cosine > -1.0 && cosine < 1.0)) return along_edges;
  const double rise = high - low;
  // |gradient| = 1 of the linear function over the triangle, as an equation for t = arrival - low.
  const double a = to_high * to_high + to_low * to_low - 2.0 * to_high * to_low * cosine;
  const double b = 2.0 * to_low * rise * (to_high * cosine - to_low);
  const double c = to_low * to_low * (rise * rise - to_high * to_high * (1.0 - cosine * cosine));
  const double discriminant = b * b - 4.0 * a * c;
  if (!(a > 0.0 && discriminant >= 0.0)) return along_edges;
  const double t = (-b + std::sqrt(discriminant)) / (2.0 * a);
  if (!(t > rise)) return along_edges;
  // The path back along the gradient has to leave between the two vertices.
  const double foot = to_low * (t - rise) / t;
  if (!(foot > to_high * cosine && foot * cosine < to_high)) return along_edges;
  return std::fmin(low + t, along_edges);
}

/// The value that a triangle gives its corner, from its other vertices as far as they are settled.
double through(const MarchingTriangle& t, const VertexSearch& search) {
  const double first = search.distance(t.first);
  const double second = search.distance(t.second);
  if (!search.is_settled(t.first)) return second + t.to_second;
  if (!search.is_settled(t.second)) return first + t.to_first;
  if (first <= second) return arrival(first, second, t.to_first, t.to_second, t.cosine);
  return arrival(second, first, t.to_second, t.to_first, t.cosine);
}

/// Plane waves through the triangles of a mesh, in order of arrival.
class FastMarching final : public GeodesicMethod {
 public:
  explicit FastMarching(const std::shared_ptr<const Mesh>& mesh) : FastMarching(mesh, *mesh) {}
  /// Over a surface with the vertices of the mesh and other faces.
  FastMarching(const std::shared_ptr<const Mesh>& mesh, const Mesh& surface);
  std::size_t bytes() const override;

 private:
  std::vector<double> solve(std::span<const Index> sources, const Progress& progress) override;

  std::vector<MarchingTriangle> triangles_;
  std::vector<std::size_t> begin_;
  std::vector<std::size_t> seen_from_;
};

FastMarching::FastMarching(const std::shared_ptr<const Mesh>& mesh, const Mesh& surface)
    : GeodesicMethod(mesh, "Fast marching"), triangles_(marching_triangles(surface)) {
  // For each vertex, the triangles in which it is one of the two with a value.
  const Index vertices = mesh->vertex_count();
  begin_.assign(static_cast<std::size_t>(vertices) + 1, 0);
  for (const auto& t : triangles_) {
    ++begin_[t.first + 1];
    ++begin_[t.second + 1];
  }
  for (Index v = 0; v < vertices; ++v) begin_[v + 1] += begin_[v];
  seen_from_.resize(begin_.back());
  std::vector<std::size_t> place(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    seen_from_[place[triangles_[i].first]++] = i;
    seen_from_[place[triangles_[i].second]++] = i;
  }
}

std::vector<double> FastMarching::solve(std::span<const Index> sources, const Progress&) {
  VertexSearch search(mesh().vertex_count(), sources);
  for (Index v = search.settle_next(); v != no_index; v = search.settle_next()) {
    for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) {
      const MarchingTriangle& t = triangles_[seen_from_[i]];
      if (!search.is_settled(t.vertex)) search.lower(t.vertex, through(t, search));
    }
  }
  return search.distances();
}

std::size_t FastMarching::bytes() const {
  return bytes_of(triangles_) + bytes_of(begin_) + bytes_of(seen_from_) +
         static_cast<std::size_t>(mesh().vertex_count()) * VertexSearch::bytes_per_vertex;
}

}  // namespace

MethodEntry fast_marching_entry() {
  return {{"fast_marching",
           "Fast marching, obtuse triangles unfolded",
           "R. Kimmel, J. A. Sethian: Computing geodesic paths on manifolds. PNAS 95, 1998",
           {},
           {"MSAD", "adjacency", "first order in the edge length", "speeds on vertices", "field n log n"},
           false,
           false},
          prepared<FastMarching>};
}

// ---- Waves over raw meshes that cross gaps wherever faces are nearer in space than a tolerance

namespace {

/// A gap with more triangles across it per vertex, in the mean, is refused: it is many edges wide, and would
/// join everything to everything around it.
constexpr std::size_t max_triangles_per_vertex = 500;

double distance_to_face(const Mesh& mesh, Index vertex, const std::array<Index, 3>& face) {
  const Point& p = mesh.position(vertex);
  const auto weights =
      nearest_weights(p, mesh.position(face[0]), mesh.position(face[1]), mesh.position(face[2]));
  Point away{};
  for (int i = 0; i < 3; ++i) away = moved(away, weights[i], minus(mesh.position(face[i]), p));
  return length_of(away);
}

/// The faces of the mesh without its bridges, and for each vertex and each face that is no farther from it
/// than the gap and does not have it as a corner, the triangles from the vertex to the sides of the face.
Mesh joined_wherever_near(const Mesh& mesh, double gap) {
  if (mesh.has_metric() || !mesh.has_positions()) {
    throw InvalidInput(
        "The method campen_kobbelt crosses gaps by their width in space, so not in a metric; set its gap to "
        "0 or leave out the metric.");
  }
  std::vector<std::array<Index, 3>> faces(mesh.faces().begin(), mesh.faces().begin() + mesh.first_bridge());
  std::vector<Box> boxes;
  for (const auto& face : faces) {
    Box box{mesh.position(face[0]), mesh.position(face[0])};
    for (const Index v : face) box.add({mesh.position(v), mesh.position(v)});
    boxes.push_back(box);
  }
  const BoxTree tree(boxes);
  const std::size_t most = faces.size() + max_triangles_per_vertex * mesh.vertex_count();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (v % 1024 == 0) checkpoint();
    if (mesh.corners(v).empty()) continue;
    const auto join = [&](Index f) {
      const std::array<Index, 3> face = faces[f];
      if (std::ranges::find(face, v) != face.end() || distance_to_face(mesh, v, face) > gap) return gap;
      for (int i = 0; i < 3; ++i) faces.push_back({v, face[i], face[(i + 1) % 3]});
      return gap;
    };
    const auto box_of = [&](Index f) -> const Box& { return boxes[f]; };
    tree.visit_near({mesh.position(v), mesh.position(v)}, gap, mesh.face_count(), box_of, join);
    if (faces.size() > most) {
      throw InvalidInput(
          "The gap of the method campen_kobbelt is " + std::to_string(gap / mesh.typical_edge_length()) +
          " typical edges wide, and joins each vertex to hundreds of faces; give a smaller one.");
    }
  }
  return {mesh.positions(), faces};
}

}  // namespace

// After the abstract of the paper: distances on raw meshes without a repair, holes and gaps bridged up to a
// tolerance, whatever lies on their sides. The front is that of fast marching, not of the paper's cells.
MethodEntry campen_kobbelt_entry() {
  return {
      {"campen_kobbelt",
       "Waves across gaps (Campen, Kobbelt)",
       "M. Campen, L. Kobbelt: Walking on broken mesh: defect-tolerant geodesic distances and "
       "parameterizations. Computer Graphics Forum 30(2), 2011",
       {{"gap", 0.0, 0.0, 1e60, false, "width in space that waves cross anywhere, in the unit of the mesh"}},
       {"MSAD", "adjacency", "none; short cuts between what is near in space", "none", "field n log n"},
       false,
       false},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress& progress) {
        const Watch watch(progress, "Gaps");
        const double gap = options.at("gap");
        return gap > 0.0 ? std::make_unique<FastMarching>(mesh, joined_wherever_near(*mesh, gap))
                         : std::make_unique<FastMarching>(mesh);
      }};
}

}  // namespace vorogeo
