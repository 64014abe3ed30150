// The window tree of Chen and Han, with the filter of Xin and Wang.
#include "methods/chen_han.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "methods/method.h"
#include "support/progress.h"

namespace vorogeo {

// ---- One angle, one split: of all windows that see the apex of a face through one edge, only the nearest
// has two children

namespace {

/// A window narrower than this part of its edge, and a gain smaller than this part of a distance, is
/// rounding.
constexpr double least_width = 1e-12;
constexpr double least_gain = 1e-13;
/// Rays that cross an edge this close to each other (in parts of the edge) cross it at one point.
constexpr double tied_entries = 1e-9;
/// Longer by more than rounding.
bool is_longer(double a, double b) { return a > b * (1.0 + 1e-12); }

bool has_more_than_two_faces(const Mesh& mesh, Index halfedge) {
  return mesh.next_around_edge(mesh.next_around_edge(halfedge)) != halfedge;
}

}  // namespace

WindowTree::WindowTree(std::shared_ptr<const ExactGeometry> geometry)
    : geometry_(std::move(geometry)), mesh_(*geometry_->mesh) {
  const auto vertices = static_cast<std::size_t>(mesh_.vertex_count());
  const auto halfedges = 3 * static_cast<std::size_t>(mesh_.face_count());
  distance_.assign(vertices, unreachable);
  is_source_.assign(vertices, 0);
  is_settled_.assign(vertices, 0);
  needed_.assign(vertices, 0);
  apex_distance_.assign(halfedges, unreachable);
  apex_entry_.assign(halfedges, 0.0);
}

std::size_t WindowTree::bytes() const {
  return bytes_of(distance_) + bytes_of(is_source_) + bytes_of(is_settled_) + bytes_of(needed_) +
         bytes_of(touched_) + bytes_of(apex_distance_) + bytes_of(apex_entry_) +
         bytes_of(touched_halfedges_) + bytes_of(settled_) + bytes_of(pool_) + bytes_of(free_) +
         bytes_of(ordered_) + geometry_->memory_bytes();
}

void WindowTree::reset() {
  for (Index v : touched_) {
    distance_[v] = unreachable;
    is_source_[v] = is_settled_[v] = needed_[v] = 0;
  }
  for (Index h : touched_halfedges_) apex_distance_[h] = unreachable;
  touched_.clear();
  touched_halfedges_.clear();
  settled_.clear();
  pool_.clear();
  free_.clear();
  ordered_.clear();
  arrived_.clear();
  made_ = 0;
}

void WindowTree::push(double key, Index item) {
  if (rules_.ordered) {
    ordered_.push_back({key, item});
    std::push_heap(ordered_.begin(), ordered_.end(), std::greater<>());
  } else {
    arrived_.push_back({key, item});
  }
}

void WindowTree::reach(Index vertex, double distance) {
  if (!(distance < distance_[vertex] * (1.0 - least_gain))) return;
  if (distance_[vertex] == unreachable) touched_.push_back(vertex);
  distance_[vertex] = distance;
  push(distance, ~vertex);
}

void WindowTree::run(std::span<const Index> sources, const TreeRules& rules) {
  reset();
  rules_ = rules;
  for (Index source : sources) {
    if (is_source_[source] != 0) continue;
    reach(source, 0.0);
    is_source_[source] = 1;
  }
  Index wanted = rules.max_vertices;
  Index taken = 0;
  while (!(rules.ordered ? ordered_.empty() : arrived_.empty())) {
    if (++taken % elements_per_checkpoint == 0) checkpoint();
    const Event event = rules.ordered ? ordered_.front() : arrived_.front();
    if (rules.ordered) {
      std::pop_heap(ordered_.begin(), ordered_.end(), std::greater<>());
      ordered_.pop_back();
    } else {
      arrived_.pop_front();
    }
    if (event.item < 0) {
      const Index vertex = ~event.item;
      if (event.key > distance_[vertex]) continue;
      if (is_settled_[vertex] == 0) {
        if (is_source_[vertex] == 0 && wanted-- == 0) break;
        is_settled_[vertex] = 1;
        settled_.push_back(vertex);
      }
      const bool bends = rules.bends && geometry_->can_bend[vertex] != ExactGeometry::never;
      if (bends || is_source_[vertex] != 0) emit(vertex);
    } else {
      const TreeWindow window = pool_[event.item];
      free_.push_back(event.item);
      // If its root was reached by a shorter path since, this has emitted other windows.
      if (is_longer(window.offset, distance_[window.root]) || is_trimmed(window)) continue;
      cross(window);
    }
  }
}

void WindowTree::emit(Index vertex) {
  for (Index corner : mesh_.corners(vertex)) {
    const Index previous = Mesh::previous_in_face(corner);
    const Index opposite = Mesh::next_in_face(corner);
    for (const auto& [other, side] :
         {std::pair{mesh_.head(corner), corner}, {mesh_.apex(corner), previous}}) {
      if (is_source_[vertex] != 0 && length(side) < distance_[other]) needed_[other] = 1;
      reach(other, distance_[vertex] + length(side));
    }
    TreeWindow window{};
    window.end = length(opposite);
    window.x = apex_x(opposite);
    window.y = geometry_->frame[opposite].apex_depth;
    window.offset = distance_[vertex];
    window.begin_critical = length(corner);
    window.end_critical = length(previous);
    window.greatest = unreachable;
    window.root = vertex;
    window.split_at = no_index;
    window.branched = has_more_than_two_faces(mesh_, opposite);
    add(window, opposite, mesh_.tail(opposite));
  }
}

/// Puts a window, with positions from the vertex `origin` of the half-edge `side`, on the other half-edges of
/// that edge.
void WindowTree::add(const TreeWindow& window, Index side, Index origin) {
  const double whole = length(side);
  if (!(window.end - window.begin > least_width * whole) || !(window.y > 0.0)) return;
  for (Index h = mesh_.next_around_edge(side); h != side; h = mesh_.next_around_edge(h)) {
    TreeWindow turned = window;
    turned.halfedge = h;
    if (mesh_.tail(h) != origin) {
      turned.begin = whole - window.end;
      turned.end = whole - window.begin;
      turned.x = whole - window.x;
      std::swap(turned.begin_critical, turned.end_critical);
    }
    const double least =
        turned.offset + std::hypot(std::clamp(turned.x, turned.begin, turned.end) - turned.x, turned.y);
    if (rules_.epsilon > 0.0) {
      turned.greatest = std::min(turned.greatest, greatest_distance(turned));
      if (least >= turned.greatest) continue;
    }
    Index place = static_cast<Index>(pool_.size());
    if (free_.empty()) {
      pool_.push_back(turned);
    } else {
      place = free_.back();
      free_.pop_back();
      pool_[place] = turned;
    }
    ++made_;
    push(least, place);
  }
}

void WindowTree::cross(const TreeWindow& window) {
  const Index h = window.halfedge;
  if (window.level > mesh_.face_count()) return;  // no shortest path enters a face twice
  const double ax = apex_x(h);
  const double ay = geometry_->frame[h].apex_depth;
  const double height = window.y + ay;
  const double entry = window.x + (ax - window.x) * (window.y / height);
  const double plane_distance = std::hypot(ax - window.x, height);
  const double total = window.offset + plane_distance;
  const double slack = least_width * length(h);
  if (entry >= window.begin - slack && entry <= window.end + slack) {
    const Index apex = mesh_.apex(h);
    if (rules_.epsilon > 0.0 && total < distance_[apex] * (1.0 - least_gain)) {
      needed_[apex] = has_detour(window, ax, ay, plane_distance) ? 0 : 1;
    }
    reach(apex, total);
  }
  if (entry >= window.end) {
    hand_on(window, true, entry, false, plane_distance);
  } else if (entry <= window.begin) {
    hand_on(window, false, entry, false, plane_distance);
  } else {
    const double known = apex_distance_[h];
    const bool wins = total < known * (1.0 - least_gain);
    if (wins) {
      if (known == unreachable) touched_halfedges_.push_back(h);
      apex_distance_[h] = total;
      apex_entry_[h] = entry;
    }
    // Beyond an edge of more than two faces, the nearer window may have come through another face, so that it
    // crosses no ray of this one.
    for (const bool left : {true, false}) {
      if (wins || window.branched || keeps_side(h, left, entry))
        hand_on(window, left, entry, true, plane_distance);
    }
  }
}

/// Whether a window that does not reach the apex first is handed on to this side of it.
bool WindowTree::keeps_side(Index halfedge, bool left, double entry) const {
  // Rays that enter at one place, as behind a vertex that the path passes, cross on neither side.
  const double tie = tied_entries * length(halfedge);
  const double nearest = apex_entry_[halfedge];
  return left ? entry < nearest + tie : entry > nearest - tie;
}

/// Whether a window belongs to a subtree that is cut off because another window reaches the apex first: one
/// on the side that is no longer kept. Checked when the window's turn comes, and for its last split only.
bool WindowTree::is_trimmed(const TreeWindow& window) const {
  const Index h = window.split_at;
  return h != no_index && is_longer(window.split_distance, apex_distance_[h]) &&
         !keeps_side(h, window.split_left, window.split_entry);
}

/// Hands a window on to the side at the tail (left) or at the head of its half-edge.
void WindowTree::hand_on(const TreeWindow& window, bool left, double entry, bool to_apex,
                         double apex_distance) {
  const Index h = window.halfedge;
  const double crossed = length(h);
  const Index side = left ? Mesh::previous_in_face(h) : Mesh::next_in_face(h);
  const Index origin = left ? mesh_.tail(h) : mesh_.head(h);
  const Index third = left ? mesh_.head(h) : mesh_.tail(h);
  const double whole = length(side);
  if (!(whole > 0.0)) return;
  // All positions along the crossed edge from the vertex that it shares with the side.
  const double ax = left ? apex_x(h) : crossed - apex_x(h);
  const double ay = geometry_->frame[h].apex_depth;
  const double x = left ? window.x : crossed - window.x;
  const double y = window.y;
  const double near = left ? window.begin : crossed - window.end;
  const double far = left ? std::min(window.end, entry) : crossed - std::max(window.begin, entry);
  // Where the ray through a point of the crossed edge meets the side.
  const auto meets = [&](double point) {
    const double along = y * ax - (point - x) * ay;
    return along > 0.0 ? std::clamp(whole * (y * point / along), 0.0, whole) : whole;
  };
  TreeWindow child = window;
  child.begin = meets(near);
  child.end = to_apex ? whole : meets(far);
  child.x = (x * ax - y * ay) / whole;
  child.y = (ax * y + ay * x) / whole;
  child.begin_critical = left ? window.begin_critical : window.end_critical;
  child.end_critical = to_apex ? apex_distance : (left ? window.end_critical : window.begin_critical);
  ++child.level;
  if (to_apex && !window.branched) {
    child.split_at = h;
    child.split_left = left;
    child.split_entry = entry;
    child.split_distance = window.offset + apex_distance;
  }
  // One angle, one split does not hold behind an edge of more than two faces, and windows have children in
  // all of them: without the filter, there would be one for each sequence of faces.
  child.branched = window.branched || has_more_than_two_faces(mesh_, side);
  if (rules_.filtered || child.branched) {
    // The third vertex lies at (crossed, 0), the window's beginning on the line from (0, 0) to the apex.
    const double part = child.begin / whole;
    const double to_third = std::hypot(crossed - part * ax, part * ay);
    if (is_overtaken(child, whole, {origin, mesh_.apex(h), third}, to_third)) return;
  }
  add(child, side, origin);
}

bool WindowTree::is_overtaken(const TreeWindow& window, double whole, const std::array<Index, 3>& corners,
                              double to_third) const {
  // Each ray of the window meets the straight line from one of these vertices to the window's opposite end,
  // so a shorter path over the vertex overtakes them all.
  const auto [origin, apex, third] = corners;
  const double at_begin = window.offset + std::hypot(window.begin - window.x, window.y);
  const double at_end = window.offset + std::hypot(window.end - window.x, window.y);
  return is_longer(at_end, distance_[origin] + window.end) ||
         is_longer(at_begin, distance_[apex] + (whole - window.begin)) ||
         is_longer(at_begin, distance_[third] + to_third);
}

// ---- The algorithms of Chen and Han, and of Xin and Wang, as methods

namespace {

/// Windows that take about a minute without order and filter, and about how many there are for each pair of
/// faces.
constexpr double windows_to_warn = 3e8;
constexpr double windows_per_pair = 5.0;

class ChenHan final : public GeodesicMethod {
 public:
  ChenHan(const std::shared_ptr<const Mesh>& mesh, const MethodOptions& options)
      : GeodesicMethod(mesh, "Windows as a tree"), tree_(std::make_shared<const ExactGeometry>(mesh)) {
    const auto is_on = [&](const char* option) {
      return options.contains(option) && options.at(option) != 0;
    };
    rules_ = {.ordered = is_on("order"), .filtered = is_on("filter")};
  }
  std::size_t bytes() const override { return tree_.bytes(); }

 private:
  std::vector<double> solve(std::span<const Index> sources, const Progress&) override {
    tree_.run(sources, rules_);
    return vertex_distances(mesh(), tree_);
  }

  WindowTree tree_;
  TreeRules rules_;
};

}  // namespace

MethodEntry ch_entry() {
  return {{"ch",
           "Window tree (CH)",
           "J. Chen, Y. Han: Shortest paths on a polyhedron. Symposium on Computational Geometry 1990",
           {},
           {"MSAD", "none", "exact", "none", "field n^2"},
           true,
           false},
          prepared<ChenHan>,
          [](const Mesh& mesh) -> std::string {
            const double faces = mesh.face_count();
            const double windows = windows_per_pair * faces * faces;
            if (windows < windows_to_warn) return "";
            std::ostringstream text;
            text.precision(2);
            text << "The method ch makes some " << windows << " windows on this mesh of " << mesh.face_count()
                 << " faces, for minutes to days. The methods ich and mmp give the same distances sooner.";
            return text.str();
          }};
}

MethodEntry ich_entry() {
  return {
      {"ich",
       "Window tree, ordered and filtered (ICH)",
       "S.-Q. Xin, G.-J. Wang: Improving Chen and Han's algorithm on the discrete geodesic problem. ACM "
       "Transactions on Graphics 28(4), 2009",
       {{"order", 1.0, 0.0, 1.0, true, "1: the nearest window is handed on first; 0: in order of arrival"},
        {"filter", 1.0, 0.0, 1.0, true, "1: windows that a vertex overtakes are dropped"}},
       {"MSAD", "none", "exact", "none", "field n^2 log n at most"},
       true,
       false},
      prepared<ChenHan>};
}

}  // namespace vorogeo
