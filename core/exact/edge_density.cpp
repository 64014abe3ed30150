// How densely the edges of a metric that jumps should have points.
#include "exact/edge_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "support/progress.h"

namespace vorogeo {

// ---- Sizes of features, and how edges around see them

namespace {

/// A feature seen over a face is kept where it is smaller than this fraction of the size known there.
constexpr double much_smaller = 0.7;
/// An edge keeps at most this many knots: among needles, features may far outnumber its points.
constexpr std::size_t most_knots = 32;

/// The distance of the apex of a face from a side, and the place of the side nearest to it, both in the
/// side's cost.
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
  }
  // The smallest first: no later knot is smaller, so those that are kept stay needed.
  for (Index looked_at = 0; !offers_.empty(); ++looked_at) {
    if (looked_at % elements_per_checkpoint == 0) checkpoint();
    const Offer next = offers_.top();
    offers_.pop();
    const Index edge = mesh.edge_of(next.halfedge);
    if (is_known(edge, next.knot)) continue;
    links_.push_back({next.knot, first_[edge]});
    first_[edge] = static_cast<Index>(links_.size()) - 1;
    spread(next.halfedge, next.knot);
  }
}

std::array<FeatureSizes::Knot, 2> FeatureSizes::knots_at_ends(Index edge) const {
  const double cost = norms_.edge_cost(edge);
  const auto [a, b] = norms_.mesh().edge_vertices(edge);
  return {Knot{0.0, std::min(size_at_[a], cost)}, Knot{cost, std::min(size_at_[b], cost)}};
}

void FeatureSizes::find_knots(Index edge, std::vector<Knot>& knots) const {
  const Mesh& mesh = norms_.mesh();
  const double cost = norms_.edge_cost(edge);
  const auto ends = knots_at_ends(edge);
  knots.assign(ends.begin(), ends.end());
  mesh.for_each_halfedge(edge, [&](Index h) {
    const auto [at, away] = apex_of(norms_.frame(h), cost);
    knots.push_back({at, away + std::min(size_at_[mesh.apex(h)], cost)});
  });
  for (Index link = first_[edge]; link != no_index; link = links_[link].next)
    knots.push_back(links_[link].knot);
}

bool FeatureSizes::is_known(Index edge, const Knot& knot) {
  const auto makes_no_difference = [&](const Knot& known) {
    return !(knot.size < much_smaller * known.size_at(knot.at));
  };
  // True of nearly all knots where faces are about as wide as long.
  if (std::ranges::any_of(knots_at_ends(edge), makes_no_difference)) return true;
  find_knots(edge, known_);
  return known_.size() >= most_knots || std::ranges::any_of(known_, makes_no_difference);
}

/// Passes a knot of an edge over all its faces except that of the half-edge, to their other sides.
void FeatureSizes::spread(Index halfedge, const Knot& knot) {
  const Mesh& mesh = norms_.mesh();
  for (Index h = mesh.next_around_edge(halfedge); h != halfedge; h = mesh.next_around_edge(h)) cross(h, knot);
}

void FeatureSizes::cross(Index halfedge, const Knot& knot) {
  const Mesh& mesh = norms_.mesh();
  const EdgeFrame frame = norms_.frame(halfedge);
  const double own_cost = norms_.edge_cost(mesh.edge_of(halfedge));
  const double x = own_cost > 0.0 ? knot.at / own_cost * frame.length : 0.0;
  for (const bool second : {false, true}) {
    const double base = second ? frame.length : 0.0;
    const Index side =
        second == frame.along ? Mesh::next_in_face(halfedge) : Mesh::previous_in_face(halfedge);
    const Index edge = mesh.edge_of(side);
    const double cost = norms_.edge_cost(edge);
    if (!(cost > 0.0)) continue;
    const std::array<double, 2> way{frame.apex_x - base, frame.apex_y};
    const double square = way[0] * way[0] + way[1] * way[1];
    const double t = square > 0.0 ? std::clamp((x - base) * way[0] / square, 0.0, 1.0) : 0.0;
    const double apart = std::hypot(base + t * way[0] - x, t * way[1]);
    const double scale = square > 0.0 ? cost / std::sqrt(square) : 1.0;
    const bool from_apex = mesh.edge_vertices(edge)[0] == mesh.apex(halfedge);
    const Knot seen{(from_apex ? 1.0 - t : t) * cost, knot.size + scale * apart};
    if (!is_known(edge, seen)) offers_.push({side, seen});
  }
}

// ---- The integral of the density along an edge, and its inverse

namespace {

double integral(const FeatureSizes::Knot& from, double way) { return std::log1p(way / from.size); }

/// The distance from a knot at which the integral is `sum`.
double reach(const FeatureSizes::Knot& from, double sum) { return from.size * std::expm1(sum); }

}  // namespace

void EdgeDensity::set(std::span<const Knot> knots) {
  knots_.assign(knots.begin(), knots.end());
  std::ranges::stable_sort(knots_, {}, &Knot::at);
  const auto limit = [](Knot& knot, const Knot& beside) {
    knot.size = std::min(knot.size, beside.size_at(knot.at));
  };
  for (std::size_t i = 1; i < knots_.size(); ++i) limit(knots_[i], knots_[i - 1]);
  for (std::size_t i = knots_.size() - 1; i-- > 0;) limit(knots_[i], knots_[i + 1]);
  until_.assign(1, 0.0);
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    const auto& [first, second] = std::tie(knots_[i - 1], knots_[i]);
    // The place at which both knots give the same size.
    const double between = second.at - first.at;
    const double until = std::clamp(0.5 * (between + second.size - first.size), 0.0, between);
    until_.push_back(until_.back() + integral(first, until));
    until_.push_back(until_.back() + integral(second, between - until));
  }
}

double EdgeDensity::place(double share) const {
  const double sum = share * total();
  // Up to the place between two knots, the integral counts from the first knot; behind it, from the second.
  const auto until = std::ranges::lower_bound(until_.begin() + 1, until_.end() - 1, sum);
  const auto half = static_cast<std::size_t>(until - until_.begin()) - 1;
  const Knot& knot = knots_[(half + 1) / 2];
  return half % 2 == 0 ? knot.at + reach(knot, sum - until_[half]) : knot.at - reach(knot, *until - sum);
}

}  // namespace vorogeo
