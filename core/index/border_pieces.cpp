// The patches of an index, chosen by the size of their tables, and how finely their borders are split.
#include "index/border_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "mesh/outliers.h"
#include "mesh/vectors.h"
#include "support/progress.h"

namespace vorogeo {

// ---- A tree of the vertices with enough angle, searched around each edge

namespace {

/// Saddle vertices nearer to a border edge than this, in square roots of the area of a patch, make its pieces
/// shorter: by the square root of their distance over this.
constexpr double saddle_reach = 0.06;
/// No piece becomes shorter than this part of its length elsewhere.
constexpr double finest_part = 1.0 / 3.0;
/// Most saddle vertices looked at around an edge: where thousands crowd, so many tell how near they are.
constexpr int max_saddles = 1000;

/// Angle at a vertex beyond that of a straight path on both sides.
double angle_beyond(const Mesh& mesh, Index vertex) {
  return mesh.total_angle(vertex) - (mesh.is_border(vertex) ? 1.0 : 2.0) * std::numbers::pi;
}

double distance_from_segment(const Point& point, const Point& a, const Point& b) {
  const double t = along_segment(point, a, b);
  return distance_between(point,
                          {std::lerp(a[0], b[0], t), std::lerp(a[1], b[1], t), std::lerp(a[2], b[2], t)});
}

std::vector<Box> boxes_of(const Mesh& mesh, const std::vector<Index>& vertices) {
  std::vector<Box> boxes;
  for (Index v : vertices) boxes.push_back({mesh.position(v), mesh.position(v)});
  return boxes;
}

std::vector<Index> saddles_of(const Mesh& mesh, double least_angle) {
  std::vector<Index> found;
  for (const Index v : checked(mesh.vertex_count())) {
    const bool has_place = std::isfinite(mesh.position(v)[0]) && !mesh.corners(v).empty();
    if (has_place && angle_beyond(mesh, v) > least_angle) found.push_back(v);
  }
  return found;
}

}  // namespace

NearSaddles::NearSaddles(const Mesh& mesh, double longest)
    : mesh_(mesh), vertex_(saddles_of(mesh, longest / saddle_reach)), tree_(boxes_of(mesh, vertex_)) {
  for (Index v : vertex_) least_.push_back(longest / saddle_reach / angle_beyond(mesh, v));
}

double NearSaddles::piece_factor(Index edge, double size) const {
  const auto [first, second] = mesh_.edge_vertices(edge);
  const Point a = mesh_.position(first);
  const Point b = mesh_.position(second);
  const double straight = distance_between(a, b);
  if (!(straight > 0.0) || vertex_.empty()) return 1.0;
  // In a metric, lengths near the edge are as many times those in space as the edge's own.
  const double reach = saddle_reach * size * straight / mesh_.edge_length(edge);
  double factor = 1.0;
  auto look_at = [&](Index item) {
    const Index v = vertex_[item];
    // Copies of the ends, on the other lip of a slit say, are no more in the way than the ends.
    if (mesh_.position(v) != a && mesh_.position(v) != b) {
      const double apart = distance_from_segment(mesh_.position(v), a, b);
      factor = std::min(factor, std::max({std::sqrt(apart / reach), least_[item], finest_part}));
    }
    return reach * factor * factor;
  };
  Box around{a, a};
  around.add({b, b});
  const auto box_of = [&](Index item) {
    const Point& p = mesh_.position(vertex_[item]);
    return Box{p, p};
  };
  tree_.visit_near(around, reach, max_saddles, box_of, look_at);
  return factor;
}

// ---- The finest pieces for which the tables have room

namespace {

/// Longest border edge as a fraction of the square root of the area of the smaller adjacent patch. A round
/// patch of a regular mesh with 150 vertices has 0.09.
constexpr double longest_border_edge = 0.15;
/// The limit on the length of border edges is never shorter than this.
constexpr double finest_border_edge = 0.03;
/// Between these two, the limit is this over the square root of the mesh's mean angle defect.
constexpr double edge_by_defect = 0.013;
/// Edges may be longer where the tables would have more entries than this for each vertex of the mesh:
/// memory, and the work to fill them, grow with that number.
constexpr double entries_per_vertex = 250.0;
/// So many more for the first-layer tables and the transit table, on a mesh of ordinary size.
constexpr double first_entries_per_vertex = 110.0;
/// By how much longer edges get in a step, and in how many steps at most: beside a border edge far longer
/// than that, single vertices would be off by tens of percent.
constexpr double longer_per_step = 1.1;
constexpr int max_steps = 8;
constexpr Index max_pieces = 32;
/// Tables with so many times the entries that they should have at most are hopeless: on a mesh of needles,
/// which borders cross everywhere, filling them takes longer than thousands of exact fields. So edges get
/// fewer points, and an automatic partition is one patch.
constexpr double hopeless_entries = 8.0;

/// A border edge, and its length in square roots of the area of the smallest adjacent patch.
struct BorderEdge {
  Index edge;
  double length;
  double piece_factor;  ///< see NearSaddles
};

/// How long pieces may be, in the unit of BorderEdge::length, away from saddle vertices if tables have room.
double wanted_length(const Mesh& mesh) {
  const double defect = mesh.mean_angle_defect();
  return defect > 0.0
             ? std::clamp(edge_by_defect / std::sqrt(defect), finest_border_edge, longest_border_edge)
             : longest_border_edge;
}

/// How long pieces of border edges may be, and how many.
struct PieceLength {
  double longest;           ///< in the unit of BorderEdge::length
  bool near_saddles;        ///< whether pieces near saddle vertices are shorter
  Index most = max_pieces;  ///< how many an edge may have
};

Index pieces_of(const BorderEdge& border, const PieceLength& lengths) {
  const double longest = lengths.longest * (lengths.near_saddles ? border.piece_factor : 1.0);
  return static_cast<Index>(
      std::clamp(std::ceil(border.length / longest), 1.0, static_cast<double>(lengths.most)));
}

/// The border edges between patches that have an area.
std::vector<BorderEdge> border_edges(const Mesh& mesh, const Partition& partition) {
  // Faces at outliers say nothing about the size of a patch: they may have more area than all others.
  const Outliers outliers = find_outliers(mesh);
  std::vector<double> area(partition.second_layer_count, 0.0);
  for (const Index f : checked(mesh.face_count())) {
    const bool far =
        std::ranges::any_of(mesh.face_vertices(f), [&](Index v) { return outliers.is_outlier(v); });
    if (!far) area[partition.second_layer[f]] += mesh.face_area(f);
  }
  const NearSaddles saddles(mesh, wanted_length(mesh));
  std::vector<BorderEdge> result;
  for (const Index e : checked(mesh.edge_count())) {
    const Index first = mesh.edge_halfedge(e);
    double least = area[partition.second_layer[Mesh::face_of(first)]];
    bool border = false;
    for (Index h = mesh.next_around_edge(first); h != first; h = mesh.next_around_edge(h)) {
      const Index patch = partition.second_layer[Mesh::face_of(h)];
      border |= patch != partition.second_layer[Mesh::face_of(first)];
      least = std::min(least, area[patch]);
    }
    if (!border || !(least > 0.0)) continue;
    const double size = std::sqrt(least);
    result.push_back({e, mesh.edge_length(e) / size, saddles.piece_factor(e, size)});
  }
  return result;
}

/// Faces, border edges and points added to these, of a patch.
struct PatchCounts {
  double faces = 0.0;
  double border = 0.0;
  double added = 0.0;
};

/// How many entries tables should have at most.
double most_entries(const Mesh& mesh) {
  const auto vertices = static_cast<double>(mesh.vertex_count());
  return (entries_per_vertex + first_entries_per_vertex * first_layer_growth(vertices)) * vertices;
}

/// About how many entries all tables have with such pieces, as a multiple of the most they should have.
double expected_entries(const Mesh& mesh, const Partition& partition, std::span<const BorderEdge> borders,
                        const PieceLength& lengths) {
  std::vector<PatchCounts> patches(partition.second_layer_count);
  for (Index patch : partition.second_layer) patches[patch].faces += 1.0;
  // Nodes of both layers, by first-layer patch.
  std::vector<double> members(partition.first_layer_count, 0.0);
  std::vector<double> nodes(partition.first_layer_count, 0.0);
  double all_nodes = 0.0;
  for (const BorderEdge& border : borders) {
    const Index pieces = pieces_of(border, lengths);
    const Index parent = partition.first_layer[Mesh::face_of(mesh.edge_halfedge(border.edge))];
    bool between_parents = false;
    mesh.for_each_halfedge(border.edge, [&](Index h) {
      PatchCounts& patch = patches[partition.second_layer[Mesh::face_of(h)]];
      patch.border += 1.0;
      patch.added += pieces - 1;
      between_parents |= partition.first_layer[Mesh::face_of(h)] != parent;
    });
    members[parent] += pieces;
    if (!between_parents) continue;
    all_nodes += pieces;
    nodes[parent] += pieces;
    mesh.for_each_halfedge(border.edge, [&](Index h) {
      const Index other = partition.first_layer[Mesh::face_of(h)];
      if (other == parent) return;
      members[other] += pieces;
      nodes[other] += pieces;
    });
  }
  double entries = all_nodes * all_nodes;
  for (std::size_t p = 0; p < nodes.size(); ++p) entries += nodes[p] * members[p];
  // A disc has half as many vertices as faces and border edges together, and as many on its border as it has
  // border edges.
  for (const PatchCounts& patch : patches) {
    entries += (patch.border + patch.added) * (0.5 * (patch.faces + patch.border) + patch.added);
  }
  return entries / most_entries(mesh);
}

/// The longest pieces that are allowed.
PieceLength longest_pieces(const Mesh& mesh) {
  return {wanted_length(mesh) * std::pow(longer_per_step, max_steps), false};
}

/// The finest pieces for which tables keep to their share; if there are none, the same without shorter pieces
/// near saddle vertices. Otherwise the longest that are allowed, and fewer of an edge if tables would be
/// hopeless even so.
PieceLength choose_pieces(const Mesh& mesh, const Partition& partition, std::span<const BorderEdge> borders) {
  for (const bool near_saddles : {true, false}) {
    PieceLength lengths{wanted_length(mesh), near_saddles};
    for (int step = 0; step <= max_steps; ++step, lengths.longest *= longer_per_step) {
      if (expected_entries(mesh, partition, borders, lengths) <= 1.0) return lengths;
    }
  }
  PieceLength lengths = longest_pieces(mesh);
  while (lengths.most > 1 && expected_entries(mesh, partition, borders, lengths) > hopeless_entries)
    --lengths.most;
  return lengths;
}

}  // namespace

std::vector<Index> pieces_of_edges(const Mesh& mesh, const Partition& partition) {
  const std::vector<BorderEdge> borders = border_edges(mesh, partition);
  const PieceLength lengths = choose_pieces(mesh, partition, borders);
  std::vector<Index> pieces(mesh.edge_count(), 1);
  for (const BorderEdge& border : borders) pieces[border.edge] = pieces_of(border, lengths);
  return pieces;
}

double wanted_entries(const Mesh& mesh, const Partition& partition) {
  return expected_entries(mesh, partition, border_edges(mesh, partition), {wanted_length(mesh), true});
}

// ---- The patches

namespace {

/// Over more vertices than this, an exact run takes long beside tables: a tenth of a second on needles.
constexpr Index few_vertices = 10000;
/// Another partition has to have fewer than this part of the entries of the usual one.
constexpr double worth_changing = 0.9;

}  // namespace

Partition partition_for_index(const Mesh& mesh, const PartitionOptions& options, const Progress& progress) {
  const bool is_automatic = options.first_layer_patches == 0 && options.second_layer_patches == 0;
  if (!is_automatic) return make_partition(mesh, options, progress);
  Partition usual = make_partition(mesh, options, progress.part(0.0, 0.5));
  const std::vector<BorderEdge> borders = border_edges(mesh, usual);
  const double most = mesh.vertex_count() <= few_vertices ? 1.0 : hopeless_entries;
  // Where the metric jumps, runs over whole components take too long for pairs.
  if (!mesh.metric_jumps() && expected_entries(mesh, usual, borders, longest_pieces(mesh)) > most) {
    return make_partition(mesh, {1, 1, options.seed, options.threads}, progress.part(0.5, 1.0));
  }
  const double entries = expected_entries(mesh, usual, borders, {wanted_length(mesh), true});
  if (entries <= 1.0) return usual;
  PartitionOptions by_edges = options;
  by_edges.cells = FrontMeasure::edge_count;
  Partition other = make_partition(mesh, by_edges, progress.part(0.5, 1.0));
  return wanted_entries(mesh, other) < worth_changing * entries ? other : usual;
}

}  // namespace vorogeo
