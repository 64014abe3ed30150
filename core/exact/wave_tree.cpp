// Which wave reaches which part of an edge, and through what it came there: all paths of a run as one tree.
#include "exact/wave_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "exact/path_tracing.h"
#include "support/progress.h"

namespace vorogeo {

namespace {

/// Distances that differ by less, relative to them and to the length of the edge, are equal.
constexpr double as_near = 1e-10;
/// Parts narrower than this, relative to their edge, come from rounding.
constexpr double narrow = 1e-11;
/// By how much, relative to the distance, a path by way of a corner must be shorter than one across a side.
constexpr double by_corner = 1e-12;
/// A path of another wave counts as longer by this part of how far apart the sources of the two waves are.
constexpr double by_other_wave = 1e-6;

}  // namespace

WaveTree::WaveTree(const ExactSolver::State& state)
    : state_(state), mesh_(state.mesh), geometry_(*state.geometry) {
  for (Index s = 0; s < static_cast<Index>(state_.sources.size()); ++s) {
    const SurfacePoint& point = state_.sources[s].point;
    if (point.is_vertex()) continue;
    for (int i = 0; i < 3; ++i) {
      if (point.barycentric[(i + 2) % 3] == 0.0)
        sources_on_edges_.emplace_back(mesh_.edge_of(3 * point.face + i), s);
    }
  }
  std::ranges::sort(sources_on_edges_);
  first_part_.reserve(mesh_.edge_count() + 1);
  for (const Index e : checked(mesh_.edge_count())) {
    first_part_.push_back(static_cast<Index>(parts_.size()));
    divide(e);
  }
  first_part_.push_back(static_cast<Index>(parts_.size()));
  for (const Index f : checked(mesh_.face_count())) find_origins(f);
  find_arrivals();
  for (const Index f : checked(mesh_.face_count())) lay_side_by_side(f);
}

// ---- The parts of an edge: its windows, and between them paths along the edge

/// A place on an edge from which paths go along it, and its distance.
struct WaveTree::Cone {
  double at, distance;
  Origin from;

  double at_place(double x) const { return distance + std::abs(x - at); }
};

std::vector<WaveTree::Cone> WaveTree::cones_on(Index edge) const {
  const double length = mesh_.edge_length(edge);
  const auto [a, b] = geometry_.ends(edge);
  std::vector<Cone> cones;
  cones.push_back({0.0, state_.vertices[a].distance, {Origin::vertex, a}});
  for (auto it = std::ranges::lower_bound(sources_on_edges_, std::pair{edge, Index{0}});
       it != sources_on_edges_.end() && it->first == edge; ++it) {
    const auto& [vertex, face, weights] = state_.sources[it->second].point;
    for (int i = 0; i < 3; ++i) {
      if (mesh_.edge_of(3 * face + i) != edge) continue;
      const double at = length * weights[mesh_.tail(3 * face + i) == a ? (i + 1) % 3 : i];
      cones.push_back({at, state_.sources[it->second].offset, {Origin::source, it->second}});
    }
  }
  cones.push_back({length, state_.vertices[b].distance, {Origin::vertex, b}});
  std::erase_if(cones, [](const Cone& cone) { return cone.distance == unreachable; });
  std::ranges::stable_sort(cones, {}, &Cone::at);
  return cones;
}

/// The windows of an edge, each without the part where a path along the edge is shorter.
std::vector<EdgePart> WaveTree::shortest_windows(Index edge, const std::vector<Cone>& cones) const {
  const double length = mesh_.edge_length(edge);
  std::vector<EdgePart> shortest;
  const auto add = [&](Window window) {
    const double rounding = as_near * (window.distance(window.begin) + length);
    for (const auto& [at, distance, from] : cones) {
      const double side = window.begin >= at ? 1.0 : -1.0;  // the window lies behind the place, or before it
      const double near = side > 0.0 ? window.begin : window.end,
                   far = side > 0.0 ? window.end : window.begin;
      if (!(window.distance(near) > distance + side * (near - at) + rounding)) continue;
      if (window.distance(far) >= distance + side * (far - at)) return;
      const double taken =
          vertex_takeover(distance, window.offset, side * (window.source_x - at), window.source_y);
      (side > 0.0 ? window.begin : window.end) = std::clamp(at + side * taken, window.begin, window.end);
    }
    if (!(window.end - window.begin > narrow * length)) return;
    // Left out: a wave of an end of the edge, or of a source on it, that came through a face without width.
    const auto is_from = [&](const Cone& cone) {
      return std::abs(window.source_x - cone.at) + window.source_y <= as_near * length &&
             cone.distance <= window.offset;
    };
    if (std::ranges::any_of(cones, is_from)) return;
    shortest.push_back({window.begin,
                        window.end,
                        window.source_x,
                        window.source_y,
                        window.offset,
                        Mesh::face_of(window.entry()),
                        {}});
  };
  for (Window window : state_.envelope.windows(edge)) {
    // A source inside a window divides it, as the source is nearer there.
    for (const Cone& cone : cones) {
      if (!(window.begin < cone.at && cone.at < window.end)) continue;
      Window before = window;
      before.end = window.begin = cone.at;
      add(before);
    }
    add(window);
  }
  return shortest;
}

void WaveTree::divide(Index edge) {
  const double length = mesh_.edge_length(edge);
  const auto first = static_cast<std::ptrdiff_t>(parts_.size());
  double free_from = 0.0;
  const std::vector<Cone> cones = cones_on(edge);
  for (const EdgePart& window : shortest_windows(edge, cones)) {
    fill(edge, cones, free_from, window.begin);
    parts_.push_back(window);
    free_from = window.end;
  }
  fill(edge, cones, free_from, length);
  // A gap that rounding has left between two parts is halved; one at an end goes to the part there.
  if (parts_.begin() + first == parts_.end())
    parts_.push_back({0.0, length, 0.0, 0.0, unreachable, no_index, {}});
  parts_[first].begin = 0.0;
  parts_.back().end = length;
  for (auto it = parts_.begin() + first + 1; it != parts_.end(); ++it)
    it->begin = (it - 1)->end = 0.5 * ((it - 1)->end + it->begin);
}

/// Fills an interval that no window reaches, by paths along the edge from its ends and from sources on it.
void WaveTree::fill(Index edge, const std::vector<Cone>& cones, double begin, double end) {
  const double length = mesh_.edge_length(edge);
  if (!(end - begin > narrow * length || (length == 0.0 && begin == 0.0))) return;
  // Whether others reach a cone's place first; of equal ones the first stays, and a source before a vertex.
  const auto is_later = [&](const Cone& one, const Cone& other) {
    const double gain = one.distance - other.at_place(one.at);
    const double rounding = by_corner * (one.distance + length);
    if (gain > rounding) return true;
    if (gain < -rounding) return false;
    if (one.from.kind != other.from.kind) return one.from.kind < other.from.kind;
    return std::pair(one.distance, one.from.id) > std::pair(other.distance, other.from.id);
  };
  std::vector<Cone> nearest;
  for (const Cone& cone : cones) {
    if (!(cone.at >= begin && cone.at <= end)) continue;
    if (std::ranges::none_of(
            cones, [&](const Cone& other) { return other.from != cone.from && is_later(cone, other); }))
      nearest.push_back(cone);
  }
  double from = begin;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const Cone& cone = nearest[i];
    double to = end;
    if (i + 1 < nearest.size()) {
      const Cone& next = nearest[i + 1];
      to = std::clamp(0.5 * (cone.at + next.at + next.distance - cone.distance), from, end);
    }
    if (length > 0.0 && !(to - from > narrow * length)) continue;
    parts_.push_back({from, to, cone.at, 0.0, cone.distance, no_index, cone.from});
    from = to;
  }
}

// ---- Where each part and each vertex was reached from

/// Finds what points of a face are reached from: across its sides, or from a corner or a source in it.
class WaveTree::OriginFinder {
 public:
  OriginFinder(const WaveTree& tree, Index face)
      : tree_(tree), mesh_(tree.mesh_), geometry_(tree.geometry_), face_(face), plane_(geometry_, face) {}

  /// The origin of a part of side i that came through the face, for its middle: of paths that are equally
  /// short up to rounding, the one that carries the part's wave.
  Origin of(const EdgePart& part, int i) {
    const Index edge = mesh_.edge_of(3 * face_ + i);
    const double share = 0.5 * (part.begin + part.end) / mesh_.edge_length(edge);
    const bool is_forth = mesh_.tail(3 * face_ + i) == geometry_.ends(edge)[0];
    std::array<double, 3> weights{};
    weights[i] = is_forth ? 1.0 - share : share;
    weights[(i + 1) % 3] = is_forth ? share : 1.0 - share;
    const Wave wave{in_plane(axes_of(i), part.x, part.y), part.offset};
    look(weights, wave, i);
    return best_.origin;
  }

 private:
  struct Wave {
    PlanePoint source;
    double offset;

    double off(const Wave& other) const {
      return length_of(minus_in_plane(source, other.source)) + std::abs(offset - other.offset);
    }
  };

  /// Faster than std::hypot, which takes a tenth of the time of a whole ridge.
  static double length_of(const PlanePoint& way) { return std::sqrt(dot_in_plane(way, way)); }
  const EdgeAxes& axes_of(int i) {
    if (!axes_[i]) axes_[i].emplace(geometry_, plane_, face_, mesh_.edge_of(3 * face_ + i));
    return *axes_[i];
  }
  static PlanePoint in_plane(const EdgeAxes& axes, double x, double inwards) {
    return {axes.origin[0] + x * axes.along[0] + inwards * axes.inwards[0],
            axes.origin[1] + x * axes.along[1] + inwards * axes.inwards[1]};
  }

  void look(const std::array<double, 3>& weights, const Wave& wave, int side) {
    best_ = {};
    wave_ = wave;
    target_ = plane_.at(weights);
    for (const Index source : tree_.state_.sources_in(face_)) {
      const Wave from{plane_.at(source_in_face(tree_.state_, source, face_)),
                      tree_.state_.sources[source].offset};
      take(from.offset + length_from(from.source), from, {Origin::source, source});
    }
    for (int i = 0; i < 3; ++i) {
      if (i != side && weights[(i + 2) % 3] > 0.0) look_across(i, weights);
    }
    look_at_corners(weights, false);
    if (best_.origin.kind == Origin::none) look_at_corners(weights, true);
  }

  void take(double distance, const Wave& from, const Origin& origin) {
    distance += by_other_wave * wave_.off(from);
    if (distance < best_.distance) best_ = {distance, origin};
  }
  double length_from(const PlanePoint& place) const { return length_of(minus_in_plane(place, target_)); }

  void look_across(int i, const std::array<double, 3>& weights) {
    const Index h = 3 * face_ + i, edge = mesh_.edge_of(h);
    const FaceFrame& frame = geometry_.frame[h];
    const bool is_forth = mesh_.tail(h) == geometry_.ends(edge)[0];
    const double depth = weights[(i + 2) % 3] * frame.apex_depth;
    const double x =
        weights[is_forth ? (i + 1) % 3 : i] * mesh_.edge_length(edge) + weights[(i + 2) % 3] * frame.apex_x;
    const auto parts = tree_.parts(edge);
    std::size_t begin = 0, end = parts.size();
    if (parts.size() > few) {
      // Only parts where the ray crosses the side.
      const PlanePoint off = minus_in_plane(wave_.source, axes_of(i).origin);
      const double height = -dot_in_plane(off, axes_of(i).inwards),
                   source_x = dot_in_plane(off, axes_of(i).along);
      const double at =
          height + depth > 0.0 && height >= 0.0 ? source_x + (x - source_x) * (height / (height + depth)) : x;
      const auto behind = std::ranges::lower_bound(parts, at, {}, &EdgePart::end) - parts.begin();
      begin = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, behind - few / 2));
      end = std::min(parts.size(), static_cast<std::size_t>(behind) + few / 2 + 1);
    }
    for (std::size_t k = begin; k < end; ++k) {
      const EdgePart& part = parts[k];
      if (part.through == face_ || part.through == no_index) continue;
      const double height = part.y + depth;
      const double straight = height > 0.0 ? part.x + (x - part.x) * (part.y / height) : x;
      const double at = std::clamp(straight, part.begin, part.end);
      const double distance = part.distance(at) + length_of({x - at, depth});
      if (!(distance < best_.distance)) continue;
      take(distance, {in_plane(axes_of(i), part.x, -part.y), part.offset},
           {Origin::part, tree_.first_part(edge) + static_cast<Index>(k)});
    }
  }

  void look_at_corners(const std::array<double, 3>& weights, bool at_all) {
    for (int i = 0; i < 3; ++i) {
      const Index v = mesh_.face_vertices(face_)[i];
      if (weights[i] == 1.0) continue;
      if (!at_all && geometry_.can_bend[v] == ExactGeometry::never && !tree_.is_source(v)) continue;
      const Wave from{plane_.corner[i], tree_.state_.vertices[v].distance};
      take((from.offset + length_from(from.source)) * (1.0 + by_corner), from, {Origin::vertex, v});
    }
  }

  static constexpr int few = 8;

  const WaveTree& tree_;
  const Mesh& mesh_;
  const ExactGeometry& geometry_;
  Index face_;
  FacePlane plane_;
  std::array<std::optional<EdgeAxes>, 3> axes_;
  PlanePoint target_{};
  Wave wave_{};
  struct {
    double distance = unreachable;
    Origin origin;
  } best_;
};

void WaveTree::find_origins(Index face) {
  OriginFinder finder(*this, face);
  for (int i = 0; i < 3; ++i) {
    const Index edge = mesh_.edge_of(3 * face + i);
    for (Index p = first_part_[edge]; p < first_part_[edge + 1]; ++p) {
      if (parts_[p].through == face) parts_[p].from = finder.of(parts_[p], i);
    }
  }
}

/// The vertices at which the paths of parts turned last, or the sources that they came from.
class WaveTree::LastTurns {
 public:
  explicit LastTurns(const std::vector<EdgePart>& parts) : parts_(parts), turn_(parts.size()) {}

  Origin of(Index part) {
    passed_.clear();
    Origin at{Origin::part, part};
    while (at.kind == Origin::part && passed_.size() < parts_.size()) {
      passed_.push_back(at.id);
      at = turn_[at.id].kind == Origin::none ? parts_[at.id].from : turn_[at.id];
    }
    for (const Index p : passed_) turn_[p] = at;
    return at;
  }

 private:
  const std::vector<EdgePart>& parts_;
  std::vector<Origin> turn_;  ///< by part; none: not known yet
  std::vector<Index> passed_;
};

/// Finds arrivals in the order of distances, each from a vertex that has its own already. Otherwise, where
/// rounding lets a wave that grazes a vertex come from it as well as past it, the vertex would be reached
/// from itself.
void WaveTree::find_arrivals() {
  arrivals_.assign(mesh_.vertex_count(), no_index);
  std::vector<Index> waiting, still_waiting;
  std::vector<bool> is_reached(mesh_.vertex_count(), false);
  for (Index v = 0; v < mesh_.vertex_count(); ++v) {
    if (state_.vertices[v].distance == unreachable) continue;
    is_reached[v] = is_source(v);
    if (!is_source(v)) waiting.push_back(v);
  }
  std::ranges::stable_sort(waiting, {}, [&](Index v) { return state_.vertices[v].distance; });
  LastTurns turns(parts_);
  const auto comes_from_reached = [&](Index part) {
    const Origin turn = turns.of(part);
    return turn.kind == Origin::source || (turn.kind == Origin::vertex && is_reached[turn.id]);
  };
  bool takes_any = false;  // no waiting vertex was reached: the next takes any arrival
  for (Index done = 0; !waiting.empty(); waiting.swap(still_waiting)) {
    still_waiting.clear();
    for (const Index v : waiting) {
      if (++done % elements_per_checkpoint == 0) checkpoint();
      arrivals_[v] = arrival_from(v, comes_from_reached);
      if (arrivals_[v] == no_index && takes_any) arrivals_[v] = arrival_from(v, [](Index) { return true; });
      is_reached[v] = arrivals_[v] != no_index || takes_any;
      takes_any = takes_any && !is_reached[v];
      if (!is_reached[v]) still_waiting.push_back(v);
    }
    takes_any = still_waiting.size() == waiting.size();
  }
}

/// The edge by which a vertex is reached first, from parts that `may_be` accepts; no_index if none of these
/// is as near as the nearest of all.
template <class MayBe>
Index WaveTree::arrival_from(Index vertex, const MayBe& may_be) {
  double least = unreachable, nearest = unreachable;
  Index arrival = no_index;
  mesh_.for_each_side_at(vertex, [&](Index side, Index) {
    const Index edge = mesh_.edge_of(side);
    const bool is_first = geometry_.ends(edge)[0] == vertex;
    const Index number = is_first ? first_part_[edge] : first_part_[edge + 1] - 1;
    const EdgePart& part = parts_[number];
    const double distance = part.distance(is_first ? 0.0 : mesh_.edge_length(edge));
    if (part.from == Origin{Origin::vertex, vertex}) return;
    nearest = std::min(nearest, distance);
    if (!(distance < least) || !may_be(number)) return;
    least = distance;
    arrival = edge;
  });
  return least <= nearest * (1.0 + as_near) ? arrival : no_index;
}

// ---- The areas of a face

Origin WaveTree::area_in(Index face, Index number) const {
  const EdgePart& part = parts_[number];
  const bool begins_here =
      part.through != face && (part.through != no_index || part.from.kind == Origin::none);
  return begins_here ? Origin{Origin::part, number} : part.from;
}

void WaveTree::border_of(Index face, std::vector<Piece>& border) const {
  border.clear();
  const auto& corners = mesh_.face_vertices(face);
  std::array<bool, 3> is_origin{};
  for (int i = 0; i < 3; ++i) {
    const Index h = 3 * face + i, edge = mesh_.edge_of(h);
    const Index begin = first_part_[edge], count = first_part_[edge + 1] - begin;
    const bool is_forth = mesh_.tail(h) == geometry_.ends(edge)[0];
    border.push_back({i, no_index, {}});
    for (Index k = 0; k < count; ++k) {
      const Index number = begin + (is_forth ? k : count - 1 - k);
      const Origin area = area_in(face, number);
      border.push_back({i, number, area});
      if (area.kind != Origin::vertex) continue;
      for (int c = 0; c < 3; ++c) is_origin[c] = is_origin[c] || corners[c] == area.id;
    }
  }
  for (Piece& piece : border) {
    if (piece.part == no_index && is_origin[piece.side]) piece.area = {Origin::vertex, corners[piece.side]};
  }
  std::erase_if(border, [](const Piece& piece) { return piece.area.kind == Origin::none; });
}

void WaveTree::gaps_before(const std::vector<Piece>& border, std::vector<Index>& before) {
  const auto count = static_cast<Index>(border.size());
  // For each piece, the one of the same area before it, going round the border.
  std::vector<Index> order(border.size()), previous(border.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](Index i) { return std::pair(border[i].area, i); });
  for (Index begin = 0; begin < count;) {
    Index end = begin + 1;
    while (end < count && border[order[end]].area == border[order[begin]].area) ++end;
    for (Index k = begin; k < end; ++k) previous[order[k]] = order[k == begin ? end - 1 : k - 1];
    begin = end;
  }
  // From a gap along the border to the next piece, then along its area back to the piece before.
  before.resize(border.size());
  for (Index i = 0; i < count; ++i) before[i] = previous[(i + 1) % count];
}

/// Whether the areas of the pieces of a border, in order, lie side by side without crossing.
static bool are_side_by_side(const std::vector<Origin>& areas, std::vector<std::pair<Origin, Index>>& count) {
  count.clear();
  for (const Origin& area : areas) count.emplace_back(area, 0);
  std::ranges::sort(count);
  count.erase(std::ranges::unique(count).begin(), count.end());
  const auto left = [&](const Origin& area) -> Index& {
    return std::ranges::lower_bound(count, area, {}, &std::pair<Origin, Index>::first)->second;
  };
  for (const Origin& area : areas) ++left(area);
  // Areas that have begun and go on, each inside the one before.
  std::vector<Origin> open;
  for (const Origin& area : areas) {
    if (open.empty() || open.back() != area) {
      if (std::ranges::find(open, area) != open.end()) return false;
      open.push_back(area);
    }
    if (--left(area) == 0) open.pop_back();
  }
  return true;
}

void WaveTree::lay_side_by_side(Index face) {
  std::vector<Piece> border;
  std::vector<std::pair<Origin, Index>> count;
  border_of(face, border);
  std::vector<Origin> areas;
  for (const Piece& piece : border) areas.push_back(piece.area);
  if (are_side_by_side(areas, count)) return;
  // Where paths enter the face is certain. Parts by which they leave it, wide ones first, keep their area
  // unless it would cross others, and otherwise take that of the piece beside them.
  const auto leaves = [&](const Piece& piece) {
    return piece.part != no_index && parts_[piece.part].through == face;
  };
  const auto width = [&](std::size_t i) { return parts_[border[i].part].end - parts_[border[i].part].begin; };
  std::vector<std::size_t> order;
  std::vector<bool> is_laid(border.size());
  for (std::size_t i = 0; i < border.size(); ++i) {
    is_laid[i] = !leaves(border[i]);
    if (!is_laid[i]) order.push_back(i);
  }
  std::ranges::sort(order, [&](std::size_t i, std::size_t k) { return width(i) > width(k); });
  for (const std::size_t i : order) {
    is_laid[i] = true;
    areas.clear();
    for (std::size_t k = 0; k < border.size(); ++k) {
      if (is_laid[k]) areas.push_back(border[k].area);
    }
    if (are_side_by_side(areas, count)) continue;
    std::size_t beside = i;
    do {
      beside = (beside + border.size() - 1) % border.size();
    } while (!is_laid[beside]);
    parts_[border[i].part].from = border[i].area = border[beside].area;
  }
}

}  // namespace vorogeo
