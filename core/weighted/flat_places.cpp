// A search over vertices and edges through faces that have no area.
#include "weighted/flat_places.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <unordered_set>
#include <utility>

namespace vorogeo {

namespace {

/// Places at which a search stops to look for more.
constexpr std::size_t most_places = 256;

class FlatSearch {
 public:
  FlatSearch(const FaceNorms& norms, const FlatPlace& here) : norms_(norms), mesh_(norms.mesh()) {
    add(here);
  }

  std::vector<FlatPlace> places() && {
    // This loop ends: each vertex and each edge is added once. Heights that are no more than rounding add up
    // over many faces, so it does not go on for long.
    for (std::size_t at = 0; at < places_.size() && places_.size() < most_places; ++at) {
      const SurfacePoint point = places_[at].point;
      for_each_face_at(mesh_, point, [&](Index face, const std::array<double, 3>& weights) {
        const double least = flat_height(norms_, face);
        if (least > 0.0) step_through(face, weights, at, least);
      });
    }
    return std::move(places_);
  }

 private:
  /// Adds a place unless its vertex or edge was added before.
  void add(const FlatPlace& place) {
    const auto key = place.point.is_vertex()  ? std::int64_t{place.point.vertex}
                     : place.edge != no_index ? static_cast<std::int64_t>(mesh_.vertex_count()) + place.edge
                                              : std::int64_t{-1};
    if (added_.insert(key).second) places_.push_back(place);
  }

  void step_through(Index face, const std::array<double, 3>& weights, std::size_t at, double least) {
    const double walked = places_[at].length;
    for (int i = 0; i < 3; ++i) {
      const Index h = 3 * face + i;
      const Index edge = mesh_.edge_of(h);
      if (weights[(i + 2) % 3] == 0.0) {
        const double length = norms_.edge_cost(edge);
        if (!(length <= least)) continue;
        for (const Index end : mesh_.edge_vertices(edge)) {
          add({SurfacePoint::at_vertex(end), no_index, 0.0, at, no_index, edge, walked + length});
        }
        continue;
      }
      const EdgeFrame frame = norms_.frame(h);
      if (!(frame.length > least)) continue;  // the sides beside it lead to its ends
      const double x =
          weights[frame.along ? (i + 1) % 3 : i] * frame.length + weights[(i + 2) % 3] * frame.apex_x;
      const double y = weights[(i + 2) % 3] * frame.apex_y;
      if (!(y <= least && x >= -least && x <= frame.length + least)) continue;
      const double fraction = std::clamp(x / frame.length, 0.0, 1.0);
      FlatPlace place{point_on_edge(mesh_, edge, fraction), edge, fraction, at, face, no_index, walked + y};
      if (place.point.is_vertex()) place.edge = no_index;
      add(place);
    }
  }

  const FaceNorms& norms_;
  const Mesh& mesh_;
  std::vector<FlatPlace> places_;
  std::unordered_set<std::int64_t> added_;
};

}  // namespace

double flat_height(const FaceNorms& norms, Index face) {
  if (!norms.is_flat(face)) return 0.0;
  const auto side = norms.mesh().side_lengths(face);
  const double longest = std::max({side[0], side[1], side[2]});
  return std::max(no_height * longest, std::numeric_limits<double>::min());
}

std::vector<FlatPlace> flat_places(const FaceNorms& norms, const FlatPlace& here) {
  return FlatSearch(norms, here).places();
}

}  // namespace vorogeo
