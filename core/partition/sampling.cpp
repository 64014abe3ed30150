// Farthest-point sampling and Lloyd relaxation by breadth-first search.
#include "partition/sampling.h"

#include <algorithm>
#include <random>

#include "support/checkpoint.h"

namespace vorogeo {

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

/// Breadth-first distances over the edges of a part, from growing sets of vertices.
class Sampler::EdgeCountField {
 public:
  explicit EdgeCountField(const Mesh& mesh)
      : mesh_(mesh), edge_counts_(mesh.vertex_count(), far), cell_(mesh.vertex_count(), no_index) {}

  /// Vertices outside the part keep values of earlier parts, but the part's faces do not lead to them.
  void enter(const MeshPart& part) {
    part_ = part;
    reset();
  }

  void reset() {
    for (Index v : part_.vertices) {
      edge_counts_[v] = far;
      cell_[v] = no_index;
    }
  }

  /// Lowers the distances to those from the front, whose vertices have distance 0; vertices for which
  /// `enters(from, to)` is false are not entered from there.
  template <class Enters>
  void grow(std::vector<Index> front, Enters&& enters) {
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

  template <class Visit>
  void for_each_neighbour(Index v, Visit&& visit) const {
    for (Index corner : mesh_.corners(v)) {
      if (!part_.face_allowed.empty() && !part_.face_allowed[Mesh::face_of(corner)]) continue;
      visit(mesh_.head(corner));
      visit(mesh_.apex(corner));
    }
  }

  Index edge_count(Index v) const { return edge_counts_[v]; }
  Index cell(Index v) const { return cell_[v]; }
  void set_cell(Index v, Index cell) { cell_[v] = cell; }

 private:
  const Mesh& mesh_;
  MeshPart part_;
  std::vector<Index> edge_counts_;
  std::vector<Index> cell_;
};

Sampler::Sampler(const Mesh& mesh) : field_(std::make_unique<EdgeCountField>(mesh)) {}
Sampler::~Sampler() = default;

std::vector<Index> Sampler::spread(const MeshPart& part, Index count, std::uint64_t seed) {
  std::vector<Index> samples;
  if (part.vertices.empty()) return samples;
  EdgeCountField& field = *field_;
  field.enter(part);
  // One sample in each piece, the first at random.
  std::mt19937_64 random(seed);
  samples.push_back(part.vertices[random() % part.vertices.size()]);
  field.grow({samples.back()}, anywhere);
  for (Index v : part.vertices) {
    if (field.edge_count(v) != far) continue;
    samples.push_back(v);
    field.grow({v}, anywhere);
  }
  FarthestFirst queue;
  for (Index v : part.vertices) queue.add(v, field.edge_count(v));
  while (static_cast<Index>(samples.size()) < count) {
    const Index v = queue.take([&](Index u) { return field.edge_count(u); });
    if (v == no_index || field.edge_count(v) == 0) break;
    samples.push_back(v);
    field.grow({v}, anywhere);
  }

  std::vector<Index> front;
  for (int round = 0; round < lloyd_rounds && samples.size() > 1; ++round) {
    field.reset();
    for (std::size_t i = 0; i < samples.size(); ++i) field.set_cell(samples[i], static_cast<Index>(i));
    field.grow(samples, anywhere);
    std::vector<Index> cell_of(part.vertices.size());
    for (std::size_t i = 0; i < part.vertices.size(); ++i) cell_of[i] = field.cell(part.vertices[i]);
    front.clear();
    Index seen = 0;
    for (Index v : part.vertices) {
      if (++seen % elements_per_checkpoint == 0) checkpoint();
      bool border = false;
      field.for_each_neighbour(v, [&](Index u) { border |= field.cell(u) != field.cell(v); });
      if (border) front.push_back(v);
    }
    if (front.empty()) break;
    field.reset();
    for (std::size_t i = 0; i < part.vertices.size(); ++i) field.set_cell(part.vertices[i], cell_of[i]);
    field.grow(front, [&](Index from, Index to) { return field.cell(from) == field.cell(to); });
    // The vertex deepest inside a cell; the current sample stays if no other vertex is deeper.
    std::vector<Index> deepest(samples);
    for (Index v : part.vertices) {
      if (++seen % elements_per_checkpoint == 0) checkpoint();
      if (field.edge_count(v) == far) continue;
      Index& best = deepest[field.cell(v)];
      if (field.edge_count(best) == far || field.edge_count(v) > field.edge_count(best)) best = v;
    }
    samples = deepest;
  }
  return samples;
}

}  // namespace vorogeo
