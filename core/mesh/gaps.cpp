// Gaps between borders that face each other: vertices that become one, and bridges of faces.
#include "mesh/gaps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <queue>
#include <string>
#include <unordered_map>

#include "mesh/mesh_check.h"
#include "mesh/surface_locator.h"
#include "mesh/vectors.h"
#include "support/disjoint_sets.h"
#include "support/error.h"
#include "support/lists.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Collects and sorts sides

std::vector<SideOfFace> sorted_sides(std::span<const std::array<Index, 3>> faces) {
  std::vector<SideOfFace> sides;
  sides.reserve(3 * faces.size());
  for (const std::size_t f : checked(faces.size())) {
    if (!is_usable(faces[f])) continue;
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(faces[f][(i + 1) % 3], faces[f][(i + 2) % 3]);
      sides.push_back({{a, b}, static_cast<Index>(f), i});
    }
  }
  std::ranges::sort(sides);
  return sides;
}

std::vector<SideOfFace> sides_in_mesh(std::span<const std::array<Index, 3>> faces) {
  std::vector<SideOfFace> sides = sorted_sides(faces);
  const auto opposite = [&](const SideOfFace& side) { return faces[side.face][side.corner]; };
  auto kept = sides.begin();
  for (auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end) {
    end = std::find_if(begin, sides.end(), [&](const SideOfFace& side) { return side.ends != begin->ends; });
    std::ranges::stable_sort(begin, end, {}, opposite);
    const auto repeated = std::ranges::unique(begin, end, {}, opposite).begin();
    std::sort(begin, repeated);
    kept = kept == begin ? repeated : std::move(begin, repeated, kept);
  }
  sides.erase(kept, sides.end());
  return sides;
}

// ---- The border edges of a mesh with what decides whether two of them are the sides of one gap

namespace {

/// Sides face each other if their directions out of the surface differ by at least 60 degrees.
constexpr double max_cosine = 0.5;
/// Faces may overlap by this part of their height, as rounding and noise make borders that meet overlap.
constexpr double max_overlap = 0.1;

/// An edge with one face.
struct BorderSide {
  Index halfedge;  ///< of the face
  Index tail, head;
  Point
      out;  ///< unit vector in the plane of the face, across the edge and away from the face; 0 without area
  double depth;  ///< height of the face over the edge
};

/// The part of two sides that runs beside each other.
struct SidePair {
  double apart;    ///< their distance in the middle of that part
  double nearest;  ///< the least distance in its middle and at its ends
  double overlap;  ///< its length
  Point across;    ///< from the first side to the second, in the middle
};

std::uint64_t key_of(Index a, Index b) {
  const auto [low, high] = std::minmax(a, b);
  return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high);
}

BorderSide side_of(const Mesh& mesh, Index h) {
  BorderSide side{h, mesh.tail(h), mesh.head(h), {}, 0.0};
  const Point& a = mesh.position(side.tail);
  const Point along = minus(mesh.position(side.head), a);
  const Point to_apex = minus(mesh.position(mesh.apex(h)), a);
  const double square = dot(along, along);
  const Point inwards = square > 0.0 ? moved(to_apex, -dot(to_apex, along) / square, along) : to_apex;
  side.depth = length_of(inwards);
  if (side.depth > 0.0) side.out = moved({}, -1.0 / side.depth, inwards);
  return side;
}

std::vector<BorderSide> sides_of(const Mesh& mesh) {
  std::vector<BorderSide> sides;
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.is_border_edge(e)) sides.push_back(side_of(mesh, mesh.edge_halfedge(e)));
  }
  return sides;
}

Box box_of(const Mesh& mesh, const BorderSide& side) {
  Box box{mesh.position(side.tail), mesh.position(side.tail)};
  box.add({mesh.position(side.head), mesh.position(side.head)});
  return box;
}

std::vector<Box> boxes_of(const Mesh& mesh, const std::vector<BorderSide>& sides) {
  std::vector<Box> boxes;
  boxes.reserve(sides.size());
  for (const BorderSide& side : sides) boxes.push_back(box_of(mesh, side));
  return boxes;
}

/// All border edges, by numbers of their own. Holds the mesh by reference. Immutable.
class BorderSides {
 public:
  explicit BorderSides(const Mesh& mesh)
      : mesh_(mesh), sides_(sides_of(mesh)), tree_(boxes_of(mesh, sides_)) {
    side_between_.reserve(sides_.size());
    for (Index s = 0; s < count(); ++s) side_between_[key_of(sides_[s].tail, sides_[s].head)] = s;
  }

  Index count() const { return static_cast<Index>(sides_.size()); }
  const BorderSide& operator[](Index side) const { return sides_[side]; }
  const BoxTree& tree() const { return tree_; }
  Box box(Index side) const { return box_of(mesh_, sides_[side]); }
  /// Calls visit(other) for the sides near one; see BoxTree.
  template <class Visit, class Skip = BoxTree::SkipNone>
  void visit_near(Index side, double reach, int max_visits, Visit&& visit, const Skip& skip = {}) const {
    const auto box_of = [&](Index other) { return box(other); };
    tree_.visit_near(box(side), reach, max_visits, box_of, visit, skip);
  }
  const Point& position(Index vertex) const { return mesh_.position(vertex); }

  /// The side between two vertices; no_index if there is none.
  Index between(Index a, Index b) const {
    const auto found = side_between_.find(key_of(a, b));
    return found == side_between_.end() ? no_index : found->second;
  }
  Index other_end(Index side, Index vertex) const {
    return sides_[side].tail == vertex ? sides_[side].head : sides_[side].tail;
  }
  /// The side that follows at one of its ends, along the faces that it bounds; no_index at a non-manifold
  /// edge.
  Index next(Index side, Index vertex) const {
    Index h = sides_[side].halfedge;
    for (;;) {
      const Index other = mesh_.head(h) == vertex ? Mesh::next_in_face(h) : Mesh::previous_in_face(h);
      const Index twin = mesh_.next_around_edge(other);
      if (twin == other) return between(mesh_.tail(other), mesh_.head(other));
      if (mesh_.next_around_edge(twin) != other) return no_index;
      h = twin;
    }
  }

  Point nearest_on(Index side, const Point& position) const {
    const Point& a = mesh_.position(sides_[side].tail);
    const Point& b = mesh_.position(sides_[side].head);
    return moved(a, along_segment(position, a, b), minus(b, a));
  }
  double distance(Index side, Index vertex) const {
    return distance_between(mesh_.position(vertex), nearest_on(side, mesh_.position(vertex)));
  }
  SidePair beside(Index first, Index second) const {
    const Point& a = mesh_.position(sides_[first].tail);
    const Point& b = mesh_.position(sides_[first].head);
    const Point along = minus(b, a);
    const auto place = [&](Index vertex) { return along_segment(mesh_.position(vertex), a, b); };
    const auto [from, to] = std::minmax({place(sides_[second].tail), place(sides_[second].head)});
    SidePair pair{};
    pair.overlap = (to - from) * std::sqrt(dot(along, along));
    const Point middle = moved(a, 0.5 * (from + to), along);
    pair.across = minus(nearest_on(second, middle), middle);
    pair.apart = length_of(pair.across);
    pair.nearest = pair.apart;
    for (const double t : {from, to}) {
      const Point at = moved(a, t, along);
      pair.nearest = std::min(pair.nearest, distance_between(at, nearest_on(second, at)));
    }
    return pair;
  }

  /// Whether the surface goes on across a gap from one side to the other (docs/gaps.md): its direction turns
  /// by at most 120 degrees, and `across`, from the first side to the second, does not lead back over the
  /// face of either. `folds`: however much it turns.
  bool continues(Index first, Index second, const Point& across, bool folds) const {
    const BorderSide& a = sides_[first];
    const BorderSide& b = sides_[second];
    return (folds || dot(a.out, b.out) <= max_cosine) && dot(a.out, across) >= -max_overlap * a.depth &&
           -dot(b.out, across) >= -max_overlap * b.depth;
  }

 private:
  const Mesh& mesh_;
  std::vector<BorderSide> sides_;
  std::unordered_map<std::uint64_t, Index> side_between_;
  BoxTree tree_;
};

// ---- Closes gaps between borders like a zipper: rows of triangles along both of them, narrowest gaps first

/// Holes with more edges than this belong to the surface; smaller ones are left where gaps meet.
constexpr std::size_t max_hole_edges = 16;
/// A new row begins, instead of another one growing, where the gap is narrower by this factor.
constexpr double begin_early = 2.0;

/// Makes the triangles between borders. Each border edge becomes the side of one triangle at most.
class GapZipper {
 public:
  GapZipper(const Mesh& mesh, const BorderSides& sides, const GapLimit& limit)
      : mesh_(mesh), sides_(sides), limit_(limit), used_(sides.count(), 0) {}

  /// Two sides that run beside each other, `apart` from each other: rows of triangles may begin there.
  void add_start(double apart, Index first, Index second) { starts_.push_back({apart, first, second}); }
  /// Bridges the gaps: at every moment the row of triangles grows, or begins, where the gap is narrowest, so
  /// that where several gaps meet each border is joined to the one across and not to one round the corner.
  void close() {
    std::ranges::sort(starts_);
    auto next = starts_.begin();
    while (next != starts_.end() || !growing_.empty()) {
      if (growing_.empty() || (next != starts_.end() && begin_early * next->apart < growing_.top().apart)) {
        begin(*next++);
        continue;
      }
      const Growing row = growing_.top();
      growing_.pop();
      grow(row.front);
    }
  }
  /// Small holes that are left where several gaps meet.
  void fill_holes() {
    std::map<Index, std::vector<Index>> at;  // ordered, so that the bridges do not depend on a hash
    for (const auto& [p, q] : ends_) {
      if (distance_between(mesh_.position(p), mesh_.position(q)) > limit_.length) continue;
      at[p].push_back(q);
      at[q].push_back(p);
    }
    std::vector<Index> ring;
    for (auto& [first, neighbours] : at) {
      if (neighbours.size() != 2) continue;
      ring = {first};
      Index previous = neighbours[1];
      Index here = first;
      for (;;) {
        auto& adjacent = at[here];
        const Index next = adjacent[0] == previous ? adjacent[1] : adjacent[0];
        if (next == first || ring.size() > max_hole_edges || at[next].size() != 2) break;
        previous = here;
        here = next;
        ring.push_back(here);
      }
      const bool closed = ring.size() >= 3 && ring.size() <= max_hole_edges &&
                          (at[here][0] == first || at[here][1] == first) && at[here].size() == 2;
      if (!closed) continue;
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) faces_.push_back({first, ring[i], ring[i + 1]});
      for (const Index v : ring) at[v].clear();
    }
  }

  std::vector<std::array<Index, 3>> take_faces() { return std::move(faces_); }

 private:
  /// The end of a row of triangles: a vertex of each border and the sides that leave them.
  struct Front {
    Index p, q;
    Index from_p, from_q;  ///< no_index: that border ends
    Index last_p, last_q;  ///< the sides passed last, which give the directions where a border ends
  };

  /// A pair of sides to begin at.
  struct Start {
    double apart;
    Index first, second;
    auto operator<=>(const Start&) const = default;
  };
  /// A row that grows next where the gap is `apart` wide.
  struct Growing {
    double apart;
    std::size_t number;  ///< order of insertion; breaks ties
    Front front;
    bool operator>(const Growing& other) const {
      return apart != other.apart ? apart > other.apart : number > other.number;
    }
  };

  /// The ends of the two sides between which a row begins, moved back along their borders as long as each
  /// lies beside the other side: triangles from the middle of a long side to its far end would cover what
  /// lies between.
  Front front_between(Index first, Index second) const {
    const auto direction = [&](Index side) {
      return minus(mesh_.position(sides_[side].head), mesh_.position(sides_[side].tail));
    };
    const bool same = dot(direction(first), direction(second)) >= 0.0;
    Front front{
        sides_[first].tail, same ? sides_[second].tail : sides_[second].head, first, second, first, second};
    const auto lies_beside = [&](Index side, Index from, Index vertex) {
      const Point& a = mesh_.position(from);
      const Point along = minus(mesh_.position(sides_.other_end(side, from)), a);
      const Point to = minus(mesh_.position(vertex), a);
      return dot(to, along) > 0.0 && sides_.distance(side, vertex) <= limit_.length;
    };
    const auto slide = [&](Index& vertex, Index& side, Index opposite, Index opposite_side) {
      const Index began = vertex;
      for (;;) {
        const Index back = free_next(side, vertex);
        if (back == no_index || back == opposite_side) return;
        const Index previous = sides_.other_end(back, vertex);
        if (previous == opposite || previous == began || !lies_beside(opposite_side, opposite, previous))
          return;
        const Point across =
            minus(sides_.nearest_on(opposite_side, mesh_.position(previous)), mesh_.position(previous));
        if (!sides_.continues(back, opposite_side, across, limit_.folds)) return;
        vertex = previous;
        side = back;
      }
    };
    slide(front.p, front.from_p, front.q, front.from_q);
    slide(front.q, front.from_q, front.p, front.from_p);
    front.last_p = front.from_p;
    front.last_q = front.from_q;
    return front;
  }
  void begin(const Start& start) {
    if (!is_free(start.first) || !is_free(start.second)) return;
    const Front forward = front_between(start.first, start.second);
    if (forward.p == forward.q) return begin_at_corner(forward);
    const double width = std::min(next_width_p(forward), next_width_q(forward));
    if (width == unreachable) return;
    grow(forward);
    push({forward.p, forward.q, free_next(forward.from_p, forward.p), free_next(forward.from_q, forward.q),
          forward.from_p, forward.from_q});
  }
  /// The first triangle between two sides that meet: both of them and the edge between their other ends.
  void begin_at_corner(Front front) {
    if (front.from_p == front.from_q || !is_free(front.from_p) || !is_free(front.from_q)) return;
    const Index p = sides_.other_end(front.from_p, front.p);
    const Index q = sides_.other_end(front.from_q, front.q);
    const double apart = std::min(sides_.distance(front.from_q, p), sides_.distance(front.from_p, q));
    if (p == q || !(apart <= limit_.length)) return;
    faces_.push_back({front.p, p, q});
    used_[front.from_p] = used_[front.from_q] = 1;
    push({p, q, sides_.next(front.from_p, p), sides_.next(front.from_q, q), front.from_p, front.from_q});
  }
  /// Width of the gap at the next vertex of one border; `unreachable` if the row may not go on to it.
  double next_width(Index side, Index from, Index opposite, Index opposite_side, Index last,
                    Index last_own) const {
    if (!is_free(side)) return unreachable;
    const Index to = sides_.other_end(side, from);
    if (to == opposite) return unreachable;
    const Point& at = mesh_.position(to);
    const Point near =
        is_free(opposite_side) ? sides_.nearest_on(opposite_side, at) : mesh_.position(opposite);
    const Point across = minus(near, at);
    const double width = length_of(across);
    if (!(width <= limit_.length)) return unreachable;
    // Ragged borders turn from edge to edge: any two of the edges at both ends may face each other.
    for (const Index own : {side, last_own}) {
      if (is_free(opposite_side) && sides_.continues(own, opposite_side, across, limit_.folds)) return width;
      if (sides_.continues(own, last, across, limit_.folds)) return width;
    }
    return unreachable;
  }
  double next_width_p(const Front& front) const {
    return next_width(front.from_p, front.p, front.q, front.from_q, front.last_q, front.last_p);
  }
  double next_width_q(const Front& front) const {
    return next_width(front.from_q, front.q, front.p, front.from_p, front.last_p, front.last_q);
  }
  /// Notes where a row of triangles will grow, or that it ends.
  void push(const Front& front) {
    // Where the border itself joins the two vertices, the gap ends there.
    const Index end = sides_.between(front.p, front.q);
    if (is_free(end)) {
      used_[end] = 1;
      return;
    }
    const double width = std::min(next_width_p(front), next_width_q(front));
    if (width == unreachable) {
      ends_.push_back({front.p, front.q});
    } else {
      growing_.push({width, pushed_++, front});
    }
  }
  /// Adds a triangle, unless its side has been used since the row was noted.
  void grow(Front front) {
    const bool p = next_width_p(front) < unreachable;
    const bool q = next_width_q(front) < unreachable;
    bool take_p = p;
    if (p && q) {
      const Point& next_p = mesh_.position(sides_.other_end(front.from_p, front.p));
      const Point& next_q = mesh_.position(sides_.other_end(front.from_q, front.q));
      take_p = distance_between(next_p, mesh_.position(front.q)) <=
               distance_between(next_q, mesh_.position(front.p));
    }
    if (take_p) {
      advance(front.p, front.from_p, front.last_p, front.q);
    } else if (q) {
      advance(front.q, front.from_q, front.last_q, front.p);
    }
    push(front);
  }
  void advance(Index& vertex, Index& side, Index& last, Index opposite) {
    const Index to = sides_.other_end(side, vertex);
    faces_.push_back({vertex, to, opposite});
    used_[side] = 1;
    last = side;
    side = sides_.next(side, to);
    vertex = to;
  }
  bool is_free(Index side) const { return side != no_index && used_[side] == 0; }
  Index free_next(Index side, Index vertex) const {
    const Index next = sides_.next(side, vertex);
    return is_free(next) ? next : no_index;
  }

  const Mesh& mesh_;
  const BorderSides& sides_;
  GapLimit limit_;
  std::vector<std::uint8_t> used_;  ///< by side
  std::vector<Start> starts_;
  std::priority_queue<Growing, std::vector<Growing>, std::greater<>> growing_;
  std::size_t pushed_ = 0;
  std::vector<std::array<Index, 3>> faces_;
  std::vector<std::array<Index, 2>> ends_;  ///< edges at which rows of triangles end
};

// ---- Equal positions, then rows of triangles from the closest sides on, then single triangles

/// Sides that run beside each other for less than this part of the shorter one only meet at a corner.
constexpr double least_overlap = 0.1;
/// How many of the nearest partners are kept for each side, and how many sides are examined for them: so many
/// borders at one place cost time proportional to their number.
constexpr std::size_t max_partners = 8;
constexpr int max_looked_at = 256;
/// Where gaps meet, holes are left between their bridges, which the next round closes like gaps.
constexpr int max_rounds = 4;

bool same_place(const Point& a, const Point& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }

/// By vertex, the first of the border vertices at its position that it is merged with; empty if none are
/// merged. Two vertices of one face are not: an edge of length 0 joins them, and merging them would drop the
/// face, which may be all that connects its third vertex.
std::vector<Index> equal_vertices(const Mesh& mesh) {
  struct Keyed {
    std::uint64_t key;
    Index vertex;
  };
  std::vector<Keyed> keyed;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (!mesh.is_border(v)) continue;
    std::uint64_t key = 0;
    for (const double x : mesh.position(v)) {
      const double positive = x + 0.0;  // there are two zeros
      std::uint64_t bits;
      std::memcpy(&bits, &positive, sizeof(bits));
      key = (std::rotl(key, 29) ^ bits) * 0x9e3779b97f4a7c15;
    }
    keyed.push_back({key, v});
  }
  std::ranges::sort(keyed, [&](const Keyed& a, const Keyed& b) {
    if (a.key != b.key) return a.key < b.key;
    const Point& p = mesh.position(a.vertex);
    const Point& q = mesh.position(b.vertex);
    return same_place(p, q) ? a.vertex < b.vertex : p < q;
  });
  std::vector<Index> same_as;
  auto share_a_face = [&](Index vertex, Index first) {
    return std::ranges::any_of(mesh.corners(vertex), [&](Index corner) {
      return std::ranges::any_of(mesh.face_vertices(Mesh::face_of(corner)),
                                 [&](Index v) { return v != vertex && same_as[v] == first; });
    });
  };
  std::vector<Index> firsts;  // at the place of the last vertex
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    const Index vertex = keyed[i].vertex;
    if (i == 0 || !same_place(mesh.position(keyed[i - 1].vertex), mesh.position(vertex))) {
      firsts = {vertex};
      continue;
    }
    if (same_as.empty()) {
      same_as.resize(mesh.vertex_count());
      for (Index v = 0; v < mesh.vertex_count(); ++v) same_as[v] = v;
    }
    const auto first = std::ranges::find_if(firsts, [&](Index v) { return !share_a_face(vertex, v); });
    if (first != firsts.end()) {
      same_as[vertex] = *first;
    } else {
      firsts.push_back(vertex);
    }
  }
  return same_as;
}

/// Tells the zipper the nearest sides that run beside a side.
void add_starts(const BorderSides& sides, Index side, const GapLimit& limit, GapZipper& zipper) {
  std::vector<std::pair<double, Index>> nearest;
  const double length = distance_between(sides.box(side).low, sides.box(side).high);
  const auto look_at = [&](Index other) {
    const double reach = nearest.size() < max_partners ? limit.length : nearest.back().first;
    if (other == side) return reach;
    const SidePair pair = sides.beside(side, other);
    const double other_length = distance_between(sides.box(other).low, sides.box(other).high);
    if (!(pair.nearest <= limit.length) ||
        !(pair.overlap >= least_overlap * std::min(length, other_length)) ||
        !sides.continues(side, other, pair.across, limit.folds)) {
      return reach;
    }
    const std::pair found{pair.apart, other};
    nearest.insert(std::ranges::upper_bound(nearest, found), found);
    if (nearest.size() > max_partners) nearest.pop_back();
    return nearest.size() < max_partners ? limit.length : std::min(limit.length, nearest.back().first);
  };
  sides.visit_near(side, limit.length, max_looked_at, look_at);
  for (const auto& [apart, other] : nearest) zipper.add_start(apart, side, other);
}

/// The shortest bridge between two components: a vertex and the side that it is joined to.
struct Link {
  double apart = unreachable;
  Index vertex = no_index;
  Index side = no_index;
};

/// Links that make the sets of vertices one where the limit allows it, each the shortest between two of them
/// (Boruvka's algorithm).
std::vector<Link> join_components(const BorderSides& sides, DisjointSets& sets, const GapLimit& limit) {
  std::vector<Link> links;
  std::vector<Index> root(sides.count());
  std::vector<Index> common;
  std::vector<Link> best;
  std::vector<Index> roots;
  for (bool joined = true; joined;) {
    joined = false;
    for (Index s = 0; s < sides.count(); ++s) root[s] = sets.root(sides[s].tail);
    roots = root;
    sort_once(roots);
    if (roots.size() < 2) break;
    best.assign(roots.size(), {});
    sides.tree().common_labels(root, common);
    for (const Index s : checked(sides.count())) {
      Link& own = best[std::ranges::lower_bound(roots, root[s]) - roots.begin()];
      const auto look_at = [&](Index other) {
        const double reach = std::min(limit.length, own.apart);
        if (root[other] == root[s]) return reach;
        const auto attempt = [&](Index vertex, Index side, Index of_vertex) {
          const double apart = sides.distance(side, vertex);
          if (!(apart <= limit.length) || !(apart < own.apart)) return;
          const Point at = sides.position(vertex);
          const Point across = minus(sides.nearest_on(side, at), at);
          if (sides.continues(of_vertex, side, across, limit.folds)) own = {apart, vertex, side};
        };
        for (const Index v : {sides[s].tail, sides[s].head}) attempt(v, other, s);
        for (const Index v : {sides[other].tail, sides[other].head}) attempt(v, s, other);
        return std::min(limit.length, own.apart);
      };
      sides.visit_near(s, std::min(limit.length, own.apart), max_looked_at, look_at,
                       [&](Index node) { return common[node] == root[s]; });
    }
    for (const Link& link : best) {
      if (link.side == no_index || sets.root(link.vertex) == sets.root(sides[link.side].tail)) continue;
      sets.join(link.vertex, sides[link.side].tail);
      links.push_back(link);
      joined = true;
    }
  }
  return links;
}

std::vector<std::array<Index, 3>> rows_between_borders(const Mesh& mesh, const GapLimit& limit) {
  const BorderSides sides(mesh);
  GapZipper zipper(mesh, sides, limit);
  for (const Index s : checked(sides.count())) {
    add_starts(sides, s, limit, zipper);
  }
  zipper.close();
  zipper.fill_holes();
  return zipper.take_faces();
}

Mesh with_faces(const Mesh& mesh, const std::vector<std::array<Index, 3>>& faces) {
  auto all = mesh.faces();
  all.insert(all.end(), faces.begin(), faces.end());
  return Mesh(mesh.positions(), all);
}

DisjointSets sets_of(const Mesh& mesh) {
  DisjointSets sets(mesh.vertex_count());
  for (const auto& [a, b, c] : mesh.faces()) {
    sets.join(a, b);
    sets.join(b, c);
  }
  return sets;
}

}  // namespace

void require_gap(const GapLimit& limit) {
  if (!(limit.length >= 0.0 && std::isfinite(limit.length))) {
    throw InvalidInput("The widest gap to bridge is " + std::to_string(limit.length) +
                       "; give a length of 0 or more.");
  }
}

GapBridges find_gap_bridges(const Mesh& mesh, const GapLimit& limit) {
  require_gap(limit);
  GapBridges bridges;
  if (limit.length == 0.0) return bridges;
  bridges.same_as = equal_vertices(mesh);
  std::shared_ptr<const Mesh> merged;
  if (!bridges.same_as.empty())
    merged = std::make_shared<const Mesh>(mesh.positions(), mesh.faces(), bridges);
  const Mesh& base = merged ? *merged : mesh;
  for (int round = 0; round < max_rounds; ++round) {
    const auto more = bridges.faces.empty() ? rows_between_borders(base, limit)
                                            : rows_between_borders(with_faces(base, bridges.faces), limit);
    if (more.empty()) break;
    bridges.faces.insert(bridges.faces.end(), more.begin(), more.end());
  }
  const BorderSides sides(base);
  DisjointSets sets = sets_of(base);
  for (const auto& [a, b, c] : bridges.faces) {
    sets.join(a, b);
    sets.join(b, c);
  }
  for (const Link& link : join_components(sides, sets, limit)) {
    bridges.faces.push_back({sides[link.side].tail, sides[link.side].head, link.vertex});
  }
  return bridges;
}

Metric with_bridges(const Mesh& mesh, const GapBridges& bridges, Metric metric) {
  auto same = [&](Index v) { return bridges.same_as.empty() ? v : bridges.same_as[v]; };
  std::vector<double> cost(mesh.positions().size(), 0.0);
  for (const Index e : checked(mesh.edge_count())) {
    if (!mesh.is_border_edge(e)) continue;
    const Index face = Mesh::face_of(mesh.edge_halfedge(e));
    const auto in_space = mesh.side_lengths(face);
    const auto& sides = metric.sides[mesh.input_face(face)];
    for (int i = 0; i < 3; ++i) {
      if (!(in_space[i] > 0.0)) continue;
      for (const Index v : mesh.edge_vertices(e))
        cost[same(v)] = std::max(cost[same(v)], sides[i] / in_space[i]);
    }
  }
  for (const auto& [a, b, c] : bridges.faces) {
    const double dearest = std::max({cost[same(a)], cost[same(b)], cost[same(c)]});
    auto length = [&](Index from, Index to) {
      return dearest < unreachable ? dearest * distance_between(mesh.position(from), mesh.position(to))
                                   : dearest;
    };
    metric.sides.push_back({length(b, c), length(c, a), length(a, b)});
    if (!metric.drifts.empty()) metric.drifts.push_back({});
  }
  metric.points_per_edge = std::max(metric.points_per_edge, usual_edge_points);
  metric.splits = {};
  return metric;
}

double gap_to_join_all(const Mesh& mesh, bool folds) {
  const GapLimit limit{std::numeric_limits<double>::max(), folds};
  GapBridges equal;
  equal.same_as = equal_vertices(mesh);
  const Mesh merged(mesh.positions(), mesh.faces(), equal);
  DisjointSets sets = sets_of(merged);
  double widest = 0.0;
  for (const Link& link : join_components(BorderSides(merged), sets, limit)) {
    widest = std::max(widest, link.apart);
  }
  Index root = no_index;
  for (const auto& face : merged.faces()) {
    if (root != no_index && sets.root(face[0]) != root) return unreachable;
    root = sets.root(face[0]);
  }
  return widest;
}

Index count_joined_borders(const Mesh& mesh, const Mesh& bridged) {
  const std::vector<Index> loop = border_loops_of_edges(mesh);
  std::vector<std::uint8_t> joined(mesh.edge_count(), 0);
  Index count = 0;
  Index g = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    while (g < bridged.first_bridge() && bridged.input_face(g) < mesh.input_face(f)) ++g;
    const bool kept = g < bridged.first_bridge() && bridged.input_face(g) == mesh.input_face(f);
    for (int i = 0; i < 3; ++i) {
      const Index own = loop[mesh.edge_of(3 * f + i)];
      if (own == no_index || joined[own] != 0) continue;
      if (kept && bridged.is_border_edge(bridged.edge_of(3 * g + i))) continue;
      joined[own] = 1;
      ++count;
    }
  }
  return count;
}

}  // namespace vorogeo
