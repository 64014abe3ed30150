// Short borders between patches, by minimum cuts.
#include "patches/border_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "support/lists.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Dinic's algorithm: breadth-first levels from the sink, then paths along them until none is left

void MinCut::reset(Index nodes) {
  first_.assign(nodes, no_index);
  arcs_.clear();
}

void MinCut::join(Index a, Index b, std::int64_t capacity) {
  arcs_.push_back({b, first_[a], capacity});
  first_[a] = static_cast<Index>(arcs_.size()) - 1;
  arcs_.push_back({a, first_[b], capacity});
  first_[b] = static_cast<Index>(arcs_.size()) - 1;
}

/// Sets the levels of nodes nearer to the sink than the source: how many arcs with residual capacity lead
/// from each to the sink. \return whether the source reaches it.
bool MinCut::find_levels() {
  level_.assign(first_.size(), -1);
  queue_.assign(1, sink);
  level_[sink] = 0;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    const Index node = queue_[i];
    for (Index a = first_[node]; a != no_index; a = arcs_[a].next) {
      const Index from = arcs_[a].to;
      if (arcs_[a ^ 1].residual == 0 || level_[from] >= 0) continue;
      level_[from] = level_[node] + 1;
      if (from == source) return true;
      queue_.push_back(from);
    }
  }
  return false;
}

/// Sends as much as paths along falling levels can take.
std::int64_t MinCut::send() {
  std::int64_t total = 0;
  next_arc_ = first_;
  path_.clear();
  for (Index at = source;;) {
    Index& a = next_arc_[at];
    while (a != no_index && (arcs_[a].residual == 0 || level_[arcs_[a].to] != level_[at] - 1))
      a = arcs_[a].next;
    if (a == no_index) {
      if (path_.empty()) return total;
      // A dead end: the arc that led here is passed over from now on.
      at = arcs_[path_.back() ^ 1].to;
      next_arc_[at] = arcs_[next_arc_[at]].next;
      path_.pop_back();
      continue;
    }
    path_.push_back(a);
    at = arcs_[a].to;
    if (at != sink) continue;
    std::int64_t sent = std::numeric_limits<std::int64_t>::max();
    for (Index arc : path_) sent = std::min(sent, arcs_[arc].residual);
    for (Index arc : path_) {
      arcs_[arc].residual -= sent;
      arcs_[arc ^ 1].residual += sent;
    }
    total += sent;
    // The next path leaves this one where it is full.
    const auto full = std::ranges::find_if(path_, [&](Index arc) { return arcs_[arc].residual == 0; });
    at = arcs_[*full ^ 1].to;
    path_.erase(full, path_.end());
  }
}

std::int64_t MinCut::run() {
  std::int64_t total = 0;
  while (find_levels()) total += send();
  find_reached();
  return total;
}

void MinCut::find_reached() {
  beside_source_.assign(first_.size(), 0);
  queue_.assign(1, source);
  beside_source_[source] = 1;
  for (std::size_t i = 0; i < queue_.size(); ++i) {
    for (Index a = first_[queue_[i]]; a != no_index; a = arcs_[a].next) {
      if (arcs_[a].residual == 0 || beside_source_[arcs_[a].to] != 0) continue;
      beside_source_[arcs_[a].to] = 1;
      queue_.push_back(arcs_[a].to);
    }
  }
}

// ---- A cut through a band of faces on both sides of each border

namespace {

/// Every border is cut this many times, since cuts of its neighbours change it.
constexpr int cut_rounds = 2;
/// Share of a patch's faces that one of its borders may give away, and their greatest number: the time of a
/// cut grows faster than its band.
constexpr double band_share = 0.25;
constexpr std::size_t max_band = 2000;
/// Costs are whole numbers of this part of a piece.
constexpr double cost_unit = 1.0 / 16.0;
/// Greatest cost of an edge: enough to keep borders off it, and sums far below the greatest integer.
constexpr double greatest_cost = 1e6;
/// Length of a piece, in roots of a patch's area: between the finest and the longest border edges.
constexpr double cost_piece = 0.065;
/// Around an edge with more faces, each looks at the next one only.
constexpr std::size_t most_around = 64;

/// Calls visit(face, sees) for other faces at the edge of a half-edge; `sees`: whether they visit it, too.
template <class Visit>
void for_faces_around(const Mesh& mesh, Index h, Visit&& visit) {
  std::array<Index, most_around> around;
  std::size_t count = 0;
  for (Index g = mesh.next_around_edge(h); g != h; g = mesh.next_around_edge(g)) {
    if (count == most_around) return visit(around[0], false);
    around[count++] = Mesh::face_of(g);
  }
  for (std::size_t i = 0; i < count; ++i) visit(around[i], true);
}

}  // namespace

BorderCut::BorderCut(const Mesh& mesh) : mesh_(mesh), place_(mesh.face_count(), no_index) {}

/// Adds the faces of a patch that are nearest to its border with the other one, ring by ring.
void BorderCut::take_band(Index patch, Index other, std::span<const Index> label) {
  const auto begin = band_.size();
  auto take = [&](Index f) {
    place_[f] = static_cast<Index>(band_.size()) + 2;
    band_.push_back(f);
  };
  auto for_neighbours = [&](Index f, auto&& visit) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      for_faces_around(mesh_, h, [&](Index g, bool) {
        if (place_[g] != no_index) visit(g);
      });
    }
  };
  const auto& faces = patches_[patch].faces;
  const std::size_t most =
      std::min(max_band, static_cast<std::size_t>(band_share * static_cast<double>(faces.size())));
  for (Index f : faces) {
    bool beside = false;
    for_neighbours(f, [&](Index g) { beside |= label[g] == other; });
    if (beside && band_.size() - begin < most) take(f);
  }
  for (std::size_t i = begin; i < band_.size() && band_.size() - begin < most; ++i) {
    for_neighbours(band_[i], [&](Index g) {
      if (label[g] == patch && place_[g] == no_place && band_.size() - begin < most) take(g);
    });
  }
}

void BorderCut::cut(Index p, Index q, double faces_per_patch, std::span<Index> label) {
  band_.clear();
  take_band(p, q, label);
  take_band(q, p, label);
  const double counted = patches_[p].counted + patches_[q].counted;
  const double area = patches_[p].area + patches_[q].area;
  const double piece = counted > 0.0 ? cost_piece * std::sqrt(area / counted * faces_per_patch) : 0.0;
  flow_.reset(static_cast<Index>(band_.size()) + 2);
  for (Index f : band_) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const double length = piece > 0.0 ? mesh_.edge_length(mesh_.edge_of(h)) / piece : 0.0;
      const double cost = std::min(std::max(1.0, length) + length, greatest_cost);
      const auto capacity = static_cast<std::int64_t>(cost / cost_unit);
      for_faces_around(mesh_, h, [&](Index other, bool sees) {
        if (place_[other] >= 0) {
          if (f < other || !sees) flow_.join(place_[f], place_[other], capacity);
        } else if (place_[other] == no_place && (label[other] == p || label[other] == q)) {
          flow_.join(place_[f], label[other] == p ? MinCut::source : MinCut::sink, capacity);
        }
      });
    }
  }
  flow_.run();
  bool changed = false;
  for (Index f : band_) {
    const Index side = flow_.beside_source(place_[f]) ? p : q;
    changed |= label[f] != side;
    label[f] = side;
    place_[f] = no_place;
  }
  if (!changed) return;
  auto& of_p = patches_[p].faces;
  auto& of_q = patches_[q].faces;
  of_p.insert(of_p.end(), of_q.begin(), of_q.end());
  const auto middle = std::stable_partition(of_p.begin(), of_p.end(), [&](Index f) { return label[f] == p; });
  of_q.assign(middle, of_p.end());
  of_p.erase(middle, of_p.end());
}

void BorderCut::shorten(std::span<const Index> faces, Index labels, double faces_per_patch,
                        const Outliers& outliers, std::span<Index> label) {
  patches_.assign(labels, {});
  Index seen = 0;
  auto checkpoint_if_due = [&] {
    if (++seen % elements_per_checkpoint == 0) checkpoint();
  };
  for (Index f : faces) {
    checkpoint_if_due();
    Patch& patch = patches_[label[f]];
    patch.faces.push_back(f);
    const bool far =
        std::ranges::any_of(mesh_.face_vertices(f), [&](Index v) { return outliers.is_outlier(v); });
    if (far) continue;
    patch.area += mesh_.face_area(f);
    patch.counted += 1.0;
  }
  for (Index f : faces) place_[f] = no_place;
  std::vector<std::pair<Index, Index>> pairs;
  for (Index f : faces) {
    checkpoint_if_due();
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      for_faces_around(mesh_, h, [&](Index other, bool) {
        if (place_[other] != no_place || label[f] == label[other]) return;
        pairs.push_back(std::minmax(label[f], label[other]));
      });
    }
  }
  sort_once(pairs);
  for (int round = 0; round < cut_rounds; ++round) {
    for (const auto& [p, q] : pairs) {
      checkpoint();
      cut(p, q, faces_per_patch, label);
    }
  }
  for (Index f : faces) place_[f] = no_index;
}

}  // namespace vorogeo
