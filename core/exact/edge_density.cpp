// How densely the edges of a metric that jumps should have points.
#include "exact/edge_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "support/progress.h"

namespace vorogeo {

// ---- Features, and what of them is seen from the edges around

namespace {

/// What is seen over a face is kept where it is smaller than this part of what is known there.
constexpr double much_smaller = 0.7;

/// The distance of the apex of a face from a side, and where it is next to it: in the side's least cost.
FeatureSizes::Knot apex_of(const EdgeFrame& frame, double cost) {
  const double at = std::clamp(frame.apex_x, 0.0, frame.length);
  const double scale = frame.length > 0.0 ? cost / frame.length : 1.0;
  return {scale * at, scale * std::hypot(frame.apex_x - at, frame.apex_y)};
}

}  // namespace

FeatureSizes::FeatureSizes(const FaceNorms& norms)
    : norms_(norms),
      size_at_(norms.mesh().vertex_count(), std::numeric_limits<double>::infinity()),
      first_(norms.mesh().edge_count(), no_index) {
  const Mesh& mesh = norms.mesh();
  const Index halfedges = 3 * mesh.face_count();
  for (const Index h : checked(halfedges)) {
    const double away = apex_of(norms.frame(h), norms.edge_cost(mesh.edge_of(h))).size;
    double& size = size_at_[mesh.apex(h)];
    if (away > 0.0) size = std::min(size, away);
  }
  for (const Index h : checked(halfedges)) {
    Knot knot = apex_of(norms.frame(h), norms.edge_cost(mesh.edge_of(h)));
    knot.size += size_at_[mesh.apex(h)];
    spread(h, knot);
    // This ends: each time, what is known at some place of an edge becomes smaller by a part.
    while (!waiting_.empty()) {
      const Spread next = waiting_.back();
      waiting_.pop_back();
      cross(next);
    }
  }
}

void FeatureSizes::find_knots(Index edge, std::vector<Knot>& knots) const {
  const Mesh& mesh = norms_.mesh();
  const double cost = norms_.edge_cost(edge);
  const auto [a, b] = mesh.edge_vertices(edge);
  knots.assign({{0.0, std::min(size_at_[a], cost)}, {cost, std::min(size_at_[b], cost)}});
  mesh.for_each_halfedge(edge, [&](Index h) {
    const auto [at, away] = apex_of(norms_.frame(h), cost);
    knots.push_back({at, away + std::min(size_at_[mesh.apex(h)], cost)});
  });
  for (Index link = first_[edge]; link != no_index; link = links_[link].next)
    knots.push_back(links_[link].knot);
}

/// From a place of an edge into its faces but the one of this half-edge.
void FeatureSizes::spread(Index halfedge, const Knot& knot) {
  const Mesh& mesh = norms_.mesh();
  for (Index h = mesh.next_around_edge(halfedge); h != halfedge; h = mesh.next_around_edge(h))
    waiting_.push_back({h, knot});
}

void FeatureSizes::cross(const Spread& from) {
  const Mesh& mesh = norms_.mesh();
  const EdgeFrame frame = norms_.frame(from.halfedge);
  const double own_cost = norms_.edge_cost(mesh.edge_of(from.halfedge));
  const double x = own_cost > 0.0 ? from.knot.at / own_cost * frame.length : 0.0;
  for (const bool second : {false, true}) {
    const double base = second ? frame.length : 0.0;
    const Index side =
        second == frame.along ? Mesh::next_in_face(from.halfedge) : Mesh::previous_in_face(from.halfedge);
    const Index edge = mesh.edge_of(side);
    const double cost = norms_.edge_cost(edge);
    if (!(cost > 0.0)) continue;
    const std::array<double, 2> way{frame.apex_x - base, frame.apex_y};
    const double square = way[0] * way[0] + way[1] * way[1];
    const double t = square > 0.0 ? std::clamp((x - base) * way[0] / square, 0.0, 1.0) : 0.0;
    const double apart = std::hypot(base + t * way[0] - x, t * way[1]);
    const double scale = square > 0.0 ? cost / std::sqrt(square) : 1.0;
    const bool from_apex = mesh.edge_vertices(edge)[0] == mesh.apex(from.halfedge);
    offer(side, {(from_apex ? 1.0 - t : t) * cost, from.knot.size + scale * apart});
  }
}

/// Keeps what came over the face of a half-edge if it makes a difference.
void FeatureSizes::offer(Index halfedge, const Knot& knot) {
  const Index edge = norms_.mesh().edge_of(halfedge);
  const double cost = norms_.edge_cost(edge);
  auto is_known = [&](const Knot& known) {
    return !(knot.size < much_smaller * (known.size + std::abs(knot.at - known.at)));
  };
  const auto [a, b] = norms_.mesh().edge_vertices(edge);
  // True of nearly all where faces are about as wide as long.
  if (is_known({0.0, std::min(size_at_[a], cost)}) || is_known({cost, std::min(size_at_[b], cost)})) return;
  find_knots(edge, known_);
  if (std::ranges::any_of(known_, is_known)) return;
  links_.push_back({knot, first_[edge]});
  first_[edge] = static_cast<Index>(links_.size()) - 1;
  spread(halfedge, knot);
}

// ---- The integral of the density along an edge, and its inverse

namespace {

double integral(const FeatureSizes::Knot& from, double way) { return std::log1p(way / from.size); }

/// How far from a knot the integral is `sum`.
double reach(const FeatureSizes::Knot& from, double sum) { return from.size * std::expm1(sum); }

}  // namespace

void EdgeDensity::limit(Knot& knot, const Knot& beside) {
  knot.size = std::min(knot.size, beside.size + std::abs(knot.at - beside.at));
}

void EdgeDensity::set(std::span<const Knot> knots) {
  knots_.assign(knots.begin(), knots.end());
  std::ranges::stable_sort(knots_, {}, &Knot::at);
  for (std::size_t i = 1; i < knots_.size(); ++i) limit(knots_[i], knots_[i - 1]);
  for (std::size_t i = knots_.size() - 1; i-- > 0;) limit(knots_[i], knots_[i + 1]);
  until_.assign(1, 0.0);
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    const auto& [first, second] = std::tie(knots_[i - 1], knots_[i]);
    // Half-way, sizes as of either knot are the same.
    const double between = second.at - first.at;
    const double until = std::clamp(0.5 * (between + second.size - first.size), 0.0, between);
    until_.push_back(until_.back() + integral(first, until));
    until_.push_back(until_.back() + integral(second, between - until));
  }
}

double EdgeDensity::place(double share) const {
  const double sum = share * total();
  std::size_t i = 1;
  while (i + 1 < knots_.size() && sum > until_[2 * i]) ++i;
  return sum <= until_[2 * i - 1] ? knots_[i - 1].at + reach(knots_[i - 1], sum - until_[2 * i - 2])
                                  : knots_[i].at - reach(knots_[i], until_[2 * i] - sum);
}

}  // namespace vorogeo
