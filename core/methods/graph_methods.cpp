// Methods on graphs of geodesics: Dijkstra, SVG, DGG and short-term vectors.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/exact_geometry.h"
#include "methods/chen_han.h"
#include "methods/method.h"
#include "support/parallel.h"
#include "support/progress.h"
#include "support/vertex_search.h"

namespace vorogeo {

// ---- A graph over the vertices of a mesh, and Dijkstra's search over it

namespace {

struct GraphArc {
  Index tail, target;
  double length;

  bool operator<(const GraphArc& other) const {
    return std::tie(tail, target, length) < std::tie(other.tail, other.target, other.length);
  }
};

/// Dijkstra's search over an undirected graph that was made once.
class GraphMethod final : public GeodesicMethod {
 public:
  /// Arcs may be given in either direction; of those between two vertices the shortest is kept, in both.
  GraphMethod(std::shared_ptr<const Mesh> mesh, std::vector<GraphArc> arcs)
      : GeodesicMethod(std::move(mesh), "Shortest paths in a graph"), arcs_(std::move(arcs)) {
    const std::size_t given = arcs_.size();
    arcs_.reserve(2 * given);
    for (std::size_t i = 0; i < given; ++i) {
      arcs_.push_back({arcs_[i].target, arcs_[i].tail, arcs_[i].length});
    }
    std::sort(arcs_.begin(), arcs_.end());
    const auto repeated = std::unique(arcs_.begin(), arcs_.end(), [](const GraphArc& a, const GraphArc& b) {
      return a.tail == b.tail && a.target == b.target;
    });
    arcs_.erase(repeated, arcs_.end());
    arcs_.shrink_to_fit();
    begin_.assign(static_cast<std::size_t>(this->mesh().vertex_count()) + 1, 0);
    for (const GraphArc& arc : arcs_) ++begin_[arc.tail + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  }
  std::size_t bytes() const override {
    return bytes_of(arcs_) + bytes_of(begin_) +
           static_cast<std::size_t>(mesh().vertex_count()) * VertexSearch::bytes_per_vertex;
  }

 private:
  std::vector<double> solve(std::span<const Index> sources, const Progress&) override {
    return search(sources, no_index);
  }
  double solve_pair(Index source, Index target) override { return search({&source, 1}, target)[target]; }

  /// With a target, it ends when the target's distance is final; other distances are then upper bounds.
  std::vector<double> search(std::span<const Index> sources, Index target) const {
    VertexSearch open(mesh().vertex_count(), sources);
    for (Index v = open.settle_next(); v != no_index && v != target; v = open.settle_next()) {
      for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) {
        open.lower(arcs_[i].target, open.distance(v) + arcs_[i].length);
      }
    }
    return open.distances();
  }

  std::vector<GraphArc> arcs_;  ///< by tail
  std::vector<std::size_t> begin_;
};

// ---- A graph of direct geodesics: a search around each vertex

/// Vertices per item of work.
constexpr Index vertices_per_item = 64;

/// Arcs from each vertex to those that a run of a WindowTree with these rules settles (and needs, with an
/// epsilon), on all threads.
std::unique_ptr<GeodesicMethod> direct_geodesics(const std::shared_ptr<const Mesh>& mesh,
                                                 const TreeRules& rules, const Progress& progress) {
  const auto geometry = std::make_shared<const ExactGeometry>(mesh);
  const Index count = mesh->vertex_count();
  std::vector<std::vector<GraphArc>> arcs(count);
  PerWorker<WindowTree> trees(0);
  const auto items = static_cast<std::size_t>((count + vertices_per_item - 1) / vertices_per_item);
  parallel_for(items, 0, progress, "Direct geodesics around each vertex", [&](std::size_t item, int worker) {
    WindowTree& tree = trees.of(worker, geometry);
    const Index begin = static_cast<Index>(item) * vertices_per_item;
    for (Index v = begin; v < std::min(count, begin + vertices_per_item); ++v) {
      tree.run({&v, 1}, rules);
      for (Index other : tree.settled()) {
        if (other == v || (rules.epsilon > 0.0 && !tree.is_needed(other))) continue;
        arcs[v].push_back({v, other, tree.distance(other)});
      }
    }
  });
  std::vector<GraphArc> all;
  for (auto& own : arcs) {
    all.insert(all.end(), own.begin(), own.end());
    std::vector<GraphArc>().swap(own);
  }
  return std::make_unique<GraphMethod>(mesh, std::move(all));
}

// ---- Shortest paths along the edges of the mesh

std::vector<GraphArc> edges_of(const Mesh& mesh) {
  std::vector<GraphArc> arcs;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge_vertices(e);
    arcs.push_back({a, b, mesh.edge_length(e)});
  }
  return arcs;
}

}  // namespace

MethodEntry dijkstra_entry() {
  return {{"dijkstra",
           "Shortest edge path (Dijkstra)",
           "E. W. Dijkstra: A note on two problems in connexion with graphs. Numerische Mathematik 1, 1959",
           {},
           {"MSAD, SSSD", "none", "never too short; no refinement helps", "any on edges", "field n log n"},
           false,
           true},
          [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions&, const Progress&) {
            return std::make_unique<GraphMethod>(mesh, edges_of(*mesh));
          }};
}

// ---- Which direct geodesics a graph needs: those without a good enough detour over a vertex beside them

namespace {

/// Only the worst direction between two vertices has the excess that is allowed. A path of the graph bends at
/// many vertices, and its mean excess is smaller by this factor.
constexpr double worst_to_mean = 2.25;

}  // namespace

// Adikusuma, Fang, He 2020, section 4, restated: a target at distance D in a direction that differs by the
// small angle t from that of a vertex at distance d is reached over that vertex by a path longer than D by d
// D t^2 / (2 (D - d)). That is at most e D from D = d + d t^2 / (2 e) on. A window lies between the rays to
// two vertices; in the direction where both do worst, the better one of them gives the distance beyond which
// the window need not go.
double WindowTree::greatest_distance(const TreeWindow& window) const {
  const double begin_x = window.begin - window.x;
  const double end_x = window.end - window.x;
  const double angle = std::atan2(end_x, window.y) - std::atan2(begin_x, window.y);
  if (!(angle < 1.57)) return unreachable;
  const double first = window.begin_critical;
  const double second = window.end_critical;
  const double allowed = 2.0 * worst_to_mean * rules_.epsilon;
  const double first_rate = first / allowed;
  const double second_rate = second / allowed;
  // first + first_rate t^2 = second + second_rate (angle - t)^2
  const double b = second_rate * angle;
  const double c = second + second_rate * angle * angle - first;
  double t = angle;
  if (c <= 0.0) {
    t = 0.0;
  } else {
    const double square = b * b + (first_rate - second_rate) * c;
    if (square >= 0.0) t = std::min(angle, c / (b + std::sqrt(square)));
  }
  const double by_first = first + first_rate * t * t;
  const double by_second = second + second_rate * (angle - t) * (angle - t);
  return window.offset + std::max({std::min(by_first, by_second), first, second});
}

bool WindowTree::has_detour(const TreeWindow& window, double apex_x, double apex_y, double direct) const {
  const auto over = [&](double towards, double critical) {
    const double ray_x = towards - window.x;
    const double ray = std::hypot(ray_x, window.y);
    if (!(ray > 0.0)) return unreachable;
    const double vertex_x = window.x + ray_x * (critical / ray);
    const double vertex_y = window.y * (critical / ray - 1.0);
    return critical + std::hypot(apex_x - vertex_x, apex_y - vertex_y);
  };
  const double longest = (1.0 + rules_.epsilon) * direct;
  return over(window.begin, window.begin_critical) <= longest ||
         over(window.end, window.end_critical) <= longest;
}

// ---- The saddle vertex graph: arcs to the nearest vertices that a geodesic reaches without passing a vertex

// Section 3 of the paper: a shortest path is a chain of direct geodesics between saddle vertices. Section 5:
// each vertex keeps the K nearest of its direct geodesics, which bounds the graph and makes long ones
// polylines over vertices.
MethodEntry svg_entry() {
  return {
      {"svg",
       "Saddle vertex graph (SVG)",
       "X. Ying, X. Wang, Y. He: Saddle vertex graph (SVG): a novel solution to the discrete geodesic "
       "problem. ACM "
       "Transactions on Graphics 32(6), 2013",
       {{"K", 50.0, 3.0, 10000.0, true, "direct geodesics that each vertex keeps"}},
       {"MSAD, SSSD", "graph of K n arcs", "never too short; falls with K", "any on arcs",
        "set-up K^2 log K n, field K n log n"},
       false,
       true},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress& progress) {
        const auto most = static_cast<Index>(options.at("K"));
        return direct_geodesics(mesh, {.bends = false, .max_vertices = most}, progress);
      }};
}

// ---- The discrete geodesic graph: arcs along direct geodesics, as few as an expected error allows

// Windows end, and vertices get no arc, where a detour over a vertex beside them is good enough:
// graph_methods.cpp.
MethodEntry dgg_entry() {
  return {
      {"dgg",
       "Discrete geodesic graph (fast DGG)",
       "Y. Y. Adikusuma, Z. Fang, Y. He: Fast construction of discrete geodesic graphs. ACM Transactions on "
       "Graphics "
       "39(2), 2020",
       {{"epsilon", 0.001, 1e-6, 0.1, false, "expected relative error"}},
       {"MSAD, SSSD", "graph of n / sqrt(epsilon) arcs", "expected error epsilon", "any on arcs",
        "set-up n / epsilon^0.75, field n / sqrt(epsilon)"},
       false,
       true},
      [](const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options, const Progress& progress) {
        return direct_geodesics(mesh, {.bends = false, .epsilon = options.at("epsilon")}, progress);
      }};
}

// ---- Short-term vector Dijkstra: edge paths measured by the vectors that a few edges add up to

namespace {

/// An edge seen from one of its ends.
struct Spoke {
  Index target;
  double length;
  double angle;  ///< around the vertex, scaled to 2 pi in all
  bool turned;   ///< whether angles there grow against the orientation of the edge's first face
};

/// Campen, Heistermann, Kobbelt 2013, section 4: the step from v to w is charged not by its own length but by
/// the least over i <= k of the distance of the i-th vertex back from w, plus the length of the sum of the
/// last i edges, unfolded into the plane at the vertices between. At a border of the mesh and at vertices
/// that are no disk the sum ends, as the straight line might leave the surface.
class ShortTermVectors final : public GeodesicMethod {
 public:
  ShortTermVectors(const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options)
      : GeodesicMethod(mesh, "Short-term vector Dijkstra"), memory_(static_cast<int>(options.at("k"))) {
    const ExactGeometry geometry(mesh);
    begin_.push_back(0);
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      const bool disk = mesh->fan(v) == Mesh::Fan::closed && mesh->total_angle(v) > 0.0;
      is_disk_.push_back(disk ? 1 : 0);
      const double scale = disk ? 2.0 * std::numbers::pi / mesh->total_angle(v) : 0.0;
      double angle = 0.0;
      for (Index corner : mesh->corners(v)) {
        const bool own = geometry.begins_at_own_edge[corner] != 0;
        const Index side = own ? corner : Mesh::previous_in_face(corner);
        add_spoke(v, side, angle * scale, own);
        angle += mesh->corner_angle(corner);
        if (!disk) add_spoke(v, own ? Mesh::previous_in_face(corner) : corner, 0.0, own);
      }
      begin_.push_back(spokes_.size());
    }
  }

  std::size_t bytes() const override {
    return bytes_of(spokes_) + bytes_of(begin_) + bytes_of(is_disk_) +
           is_disk_.size() * (VertexSearch::bytes_per_vertex + sizeof(std::size_t) + sizeof(Index));
  }

 private:
  static constexpr std::size_t no_spoke = static_cast<std::size_t>(-1);

  std::vector<double> solve(std::span<const Index> sources, const Progress&) override {
    VertexSearch search(mesh().vertex_count(), sources);
    // The spoke by which a vertex is reached from its predecessor: no_spoke at sources.
    std::vector<std::size_t> reached_by(is_disk_.size(), no_spoke);
    std::vector<Index> predecessor(is_disk_.size(), no_index);
    for (Index v = search.settle_next(); v != no_index; v = search.settle_next()) {
      for (std::size_t s = begin_[v]; s < begin_[v + 1]; ++s) {
        const Index w = spokes_[s].target;
        if (search.is_settled(w)) continue;
        const double found = over(v, spokes_[s], search.distances(), predecessor, reached_by);
        // Of paths equal up to rounding, the first is kept: it has the fewest edges, so the longest memory.
        if (found < search.distance(w) * (1.0 - 1e-12)) {
          search.lower(w, found);
          predecessor[w] = v;
          reached_by[w] = s;
        }
      }
    }
    return search.distances();
  }

  void add_spoke(Index v, Index side, double angle, bool own) {
    const Index edge = mesh().edge_of(side);
    const auto [a, b] = mesh().edge_vertices(edge);
    // Angles grow from the corner's own edge to the other one along the orientation of the corner's face; the
    // first face of the edge may be oriented the other way, which shows if both run along the edge one way.
    const Index first = mesh().edge_halfedge(edge);
    const bool alike = first == side || mesh().tail(first) != mesh().tail(side);
    spokes_.push_back({a == v ? b : a, mesh().edge_length(edge), angle, own != alike});
  }

  const Spoke* back(Index from, Index to) const {
    for (std::size_t s = begin_[from]; s < begin_[from + 1]; ++s) {
      if (spokes_[s].target == to) return &spokes_[s];
    }
    return nullptr;
  }

  double over(Index v, const Spoke& last, const std::vector<double>& distance,
              const std::vector<Index>& predecessor, const std::vector<std::size_t>& reached_by) const {
    double least = distance[v] + last.length;
    // v in the origin, w on the x axis; the chain is laid backwards from there.
    double x = 0.0;
    double y = 0.0;
    double direction = 0.0;  // of the edge that leaves the vertex looked at, towards w
    double sense = 1.0;      // in which angles at that vertex grow
    Index at = v;
    const Spoke* out = &last;
    for (int i = 1; i < memory_ && is_disk_[at] != 0 && predecessor[at] != no_index; ++i) {
      const Index previous = predecessor[at];
      const Spoke* in = back(at, previous);
      if (in == nullptr) break;
      direction += sense * (in->angle - out->angle);
      x += in->length * std::cos(direction);
      y += in->length * std::sin(direction);
      least = std::fmin(least, distance[previous] + std::hypot(last.length - x, y));
      const Spoke& forth = spokes_[reached_by[at]];
      if (forth.turned != in->turned) sense = -sense;
      direction += std::numbers::pi;
      out = &forth;
      at = previous;
    }
    return least;
  }

  int memory_;
  std::vector<Spoke> spokes_;
  std::vector<std::size_t> begin_;
  std::vector<std::uint8_t> is_disk_;
};

}  // namespace

MethodEntry stvd_entry() {
  return {{"stvd",
           "Short-term vector Dijkstra",
           "M. Campen, M. Heistermann, L. Kobbelt: Practical anisotropic geodesy. Computer Graphics Forum "
           "32(5), 2013",
           {{"k", 4.0, 1.0, 64.0, true, "edges whose vectors are added up; 1: edge paths"}},
           {"MSAD", "angles", "none", "any on vectors", "field k n log n"},
           false,
           false},
          prepared<ShortTermVectors>};
}

}  // namespace vorogeo
