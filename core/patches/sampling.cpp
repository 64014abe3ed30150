// Well-spread samples, fronts that pass from edge to edge, and the Voronoi cells they leave.
#include "patches/sampling.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <vector>

#include "mesh/vectors.h"
#include "support/progress.h"

namespace vorogeo {

// ---- The front, in buckets of distance; a vertex that is relaxed after it was processed is processed again,
// a few times

namespace {

/// Bucket width in typical edge lengths, or in edges.
constexpr double bucket_width = 0.5;
/// Around faces without area, vertices may relax each other without end, by ever smaller amounts: a smaller
/// gain than this (relative) is ignored, and a vertex is relaxed at most `max_relaxed` times.
constexpr double least_gain = 1.0 - 1e-9;
constexpr std::uint8_t max_relaxed = 64;

}  // namespace

Front::Front(const Mesh& mesh, FrontMeasure measure)
    : mesh_(mesh),
      measure_(measure),
      distance_(mesh.vertex_count(), unreachable),
      source_(mesh.vertex_count(), no_index),
      relaxed_(mesh.vertex_count(), 0) {
  queue_.resize(mesh.vertex_count());
}

void Front::relax(Index vertex, double distance, Index source) {
  if (!(distance < least_gain * distance_[vertex]) || relaxed_[vertex] == max_relaxed) return;
  if (distance_[vertex] == unreachable) touched_.push_back(vertex);
  ++relaxed_[vertex];
  distance_[vertex] = distance;
  source_[vertex] = source;
  queue_.push(vertex, distance);
}

/// Relaxes the third vertex of a face, at the head of the half-edge that leaves `vertex` or at its tail.
void Front::pass(Index vertex, Index halfedge) {
  const Index edge = mesh_.edge_of(halfedge);
  const bool forth = mesh_.tail(halfedge) == vertex;
  const Index target = forth ? mesh_.head(halfedge) : mesh_.tail(halfedge);
  if (measure_ == FrontMeasure::edge_count) {
    relax(target, distance_[vertex] + 1.0, source_[vertex]);
    return;
  }
  const Index other = mesh_.apex(halfedge);
  const double length = mesh_.edge_length(edge);
  double distance = distance_[vertex] + length;
  if (source_[other] == source_[vertex]) {
    // The edge opposite to the target leads from the vertex to the other one.
    const Index across = forth ? Mesh::previous_in_face(halfedge) : Mesh::next_in_face(halfedge);
    const Index third = forth ? Mesh::next_in_face(halfedge) : Mesh::previous_in_face(halfedge);
    const double straight =
        unfolded_distance(mesh_.edge_length(mesh_.edge_of(across)), distance_[vertex], distance_[other],
                          length, mesh_.edge_length(mesh_.edge_of(third)));
    // A front only advances: values that rounding on needles makes smaller than at both ends are not used.
    if (straight >= std::fmin(distance_[vertex], distance_[other])) distance = std::fmin(distance, straight);
  }
  relax(target, distance, source_[vertex]);
}

void Front::grow(std::span<const Index> sources, std::span<const std::uint8_t> face_allowed) {
  for (Index v : touched_) {
    distance_[v] = unreachable;
    source_[v] = no_index;
    relaxed_[v] = 0;
  }
  touched_.clear();
  queue_.reset(bucket_width * (measure_ == FrontMeasure::distance ? mesh_.typical_edge_length() : 1.0));
  for (std::size_t i = 0; i < sources.size(); ++i) relax(sources[i], 0.0, static_cast<Index>(i));
  int taken = 0;
  for (Index v = queue_.pop(); v != no_index; v = queue_.pop()) {
    if (++taken % elements_per_checkpoint == 0) checkpoint();
    for (Index corner : mesh_.corners(v)) {
      if (!face_allowed.empty() && !face_allowed[Mesh::face_of(corner)]) continue;
      pass(v, corner);
      pass(v, Mesh::previous_in_face(corner));
    }
  }
}

// ---- Voronoi labels of vertices by a front from all samples at once, then of faces by their corners

namespace {

constexpr int smoothing_rounds = 8;

/// Largest group of outliers that is kept inside one patch: its faces are then about as many as those of half
/// a second-layer patch.
constexpr Index max_kept_inside = 200;

/// The label two corners share, otherwise that of the corner nearest to its sample.
Index face_label(const Front& front, const std::array<Index, 3>& vertices) {
  std::array<Index, 3> label{};
  for (int i = 0; i < 3; ++i) label[i] = front.source(vertices[i]);
  if (label[0] == label[1] || label[0] == label[2]) return label[0];
  if (label[1] == label[2]) return label[1];
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    if (front.distance(vertices[i]) < front.distance(vertices[nearest])) nearest = i;
  }
  return label[nearest];
}

/// Gives the faces at each group of outliers one label: the most frequent one among them.
void keep_outliers_inside(const Mesh& mesh, const Outliers& outliers, std::span<const Index> faces,
                          std::span<Index> label) {
  if (outliers.count == 0) return;
  // Outliers of one face share an edge, so they are in one group.
  auto group_of_face = [&](Index f) {
    for (Index v : mesh.face_vertices(f)) {
      const Index group = outliers.group_of(v);
      if (group != no_index) return outliers.group_size[group] <= max_kept_inside ? group : no_index;
    }
    return no_index;
  };
  std::map<Index, std::vector<Index>> star;
  for (Index f : faces) {
    const Index group = group_of_face(f);
    if (group != no_index) star[group].push_back(f);
  }
  for (const auto& [group, own_faces] : star) {
    std::map<Index, Index> uses;
    for (Index f : own_faces) ++uses[label[f]];
    const auto most_used = std::max_element(uses.begin(), uses.end(),
                                            [](const auto& a, const auto& b) { return a.second < b.second; });
    for (Index f : own_faces) label[f] = most_used->first;
  }
}

}  // namespace

void label_voronoi_faces(Front& front, const Mesh& mesh, const MeshPart& part, std::span<const Index> faces,
                         std::span<const Index> samples, const Outliers& outliers, std::span<Index> label) {
  front.grow(samples, part.face_allowed);
  for (Index f : faces) label[f] = face_label(front, mesh.face_vertices(f));

  auto allowed = [&](Index f) { return part.face_allowed.empty() || part.face_allowed[f] != 0; };
  for (int round = 0; round < smoothing_rounds; ++round) {
    bool changed = false;
    Index seen = 0;
    for (Index f : faces) {
      if (seen++ % elements_per_checkpoint == 0) checkpoint();
      std::array<Index, 3> other{no_index, no_index, no_index};
      for (int i = 0; i < 3; ++i) {
        const Index h = mesh.next_around_edge(3 * f + i);
        if (h != 3 * f + i && allowed(Mesh::face_of(h))) other[i] = label[Mesh::face_of(h)];
      }
      // Two neighbours that agree: joining them gives up two border edges for one, which is always shorter.
      for (int i = 0; i < 3; ++i) {
        const Index joined = other[i];
        if (joined == no_index || joined != other[(i + 1) % 3] || joined == label[f]) continue;
        label[f] = joined;
        changed = true;
        break;
      }
    }
    if (!changed) break;
  }
  keep_outliers_inside(mesh, outliers, faces, label);
}

// ---- Farthest-point sampling and Lloyd relaxation by breadth-first search

namespace {

constexpr int lloyd_rounds = 4;
constexpr Index far = std::numeric_limits<Index>::max();

constexpr auto anywhere = [](Index, Index) { return true; };

/// Vertices by distance, farthest first; entries whose distance has decreased are put back lower.
class FarthestFirst {
 public:
  void add(Index v, Index edge_count) {
    if (static_cast<std::size_t>(edge_count) >= at_.size()) at_.resize(edge_count + 1);
    at_[edge_count].push_back(v);
  }
  template <class EdgeCount>
  Index take(EdgeCount&& edge_count_of) {
    while (!at_.empty()) {
      if (at_.back().empty()) {
        at_.pop_back();
        continue;
      }
      const Index v = at_.back().back();
      at_.back().pop_back();
      const Index edge_count = edge_count_of(v);
      if (static_cast<std::size_t>(edge_count) + 1 == at_.size()) return v;
      at_[edge_count].push_back(v);
    }
    return no_index;
  }

 private:
  std::vector<std::vector<Index>> at_;
};

}  // namespace

Sampler::Sampler(const Mesh& mesh)
    : mesh_(mesh), edge_counts_(mesh.vertex_count(), far), cell_(mesh.vertex_count(), no_index) {}

void Sampler::reset() {
  for (Index v : part_.vertices) {
    edge_counts_[v] = far;
    cell_[v] = no_index;
  }
}

template <class Visit>
void Sampler::for_each_neighbour(Index v, Visit&& visit) const {
  for (Index corner : mesh_.corners(v)) {
    if (!part_.face_allowed.empty() && !part_.face_allowed[Mesh::face_of(corner)]) continue;
    visit(mesh_.head(corner));
    visit(mesh_.apex(corner));
  }
}

template <class Enters>
void Sampler::grow(std::vector<Index> front, Enters&& enters) {
  for (Index v : front) edge_counts_[v] = 0;
  std::vector<Index> next;
  for (Index edge_count = 1; !front.empty(); ++edge_count) {
    next.clear();
    checkpoint();
    Index seen = 0;
    for (Index v : front) {
      if (++seen % elements_per_checkpoint == 0) checkpoint();
      for_each_neighbour(v, [&](Index u) {
        if (edge_counts_[u] <= edge_count || !enters(v, u)) return;
        edge_counts_[u] = edge_count;
        cell_[u] = cell_[v];
        next.push_back(u);
      });
    }
    front.swap(next);
  }
}

std::vector<Index> Sampler::spread(const MeshPart& part, Index count, std::uint64_t seed) {
  std::vector<Index> samples;
  if (part.vertices.empty()) return samples;
  // Vertices outside the part keep values of earlier parts, but its faces do not lead to them.
  part_ = part;
  reset();
  // One sample in each piece, the first at random.
  std::mt19937_64 random(seed);
  samples.push_back(part.vertices[random() % part.vertices.size()]);
  grow({samples.back()}, anywhere);
  for (Index v : part.vertices) {
    if (edge_counts_[v] != far) continue;
    samples.push_back(v);
    grow({v}, anywhere);
  }
  FarthestFirst queue;
  for (Index v : part.vertices) queue.add(v, edge_counts_[v]);
  while (static_cast<Index>(samples.size()) < count) {
    const Index v = queue.take([&](Index u) { return edge_counts_[u]; });
    if (v == no_index || edge_counts_[v] == 0) break;
    samples.push_back(v);
    grow({v}, anywhere);
  }

  std::vector<Index> front;
  for (int round = 0; round < lloyd_rounds && samples.size() > 1; ++round) {
    reset();
    for (std::size_t i = 0; i < samples.size(); ++i) cell_[samples[i]] = static_cast<Index>(i);
    grow(samples, anywhere);
    std::vector<Index> cell_of(part.vertices.size());
    for (std::size_t i = 0; i < part.vertices.size(); ++i) cell_of[i] = cell_[part.vertices[i]];
    front.clear();
    Index seen = 0;
    for (Index v : part.vertices) {
      if (++seen % elements_per_checkpoint == 0) checkpoint();
      bool border = false;
      for_each_neighbour(v, [&](Index u) { border |= cell_[u] != cell_[v]; });
      if (border) front.push_back(v);
    }
    if (front.empty()) break;
    reset();
    for (std::size_t i = 0; i < part.vertices.size(); ++i) cell_[part.vertices[i]] = cell_of[i];
    grow(front, [&](Index from, Index to) { return cell_[from] == cell_[to]; });
    // The vertex deepest inside a cell; the current sample stays if no other vertex is deeper.
    std::vector<Index> deepest(samples);
    for (Index v : part.vertices) {
      if (++seen % elements_per_checkpoint == 0) checkpoint();
      if (edge_counts_[v] == far) continue;
      Index& best = deepest[cell_[v]];
      if (edge_counts_[best] == far || edge_counts_[v] > edge_counts_[best]) best = v;
    }
    samples = deepest;
  }
  return samples;
}

}  // namespace vorogeo
