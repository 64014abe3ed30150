// How densely the edges of a metric that jumps should have points.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <span>
#include <tuple>
#include <vector>

#include "exact/refraction.h"
#include "support/types.h"

namespace vorogeo {

/// Waves have details of the size of what they came past, and past many narrow faces side by side these are
/// no larger: how small features near each place of an edge are. Lengths along an edge are in its cost.
///
/// A feature is a vertex, as large as the distance from there to the nearest side opposite. Seen from
/// elsewhere it is larger by the way there: over faces, straight to the nearest point of each next side. A
/// side keeps it while that makes some difference there, so it goes far only over needles.
class FeatureSizes {
 public:
  struct Knot {
    double at;
    double size;
    /// At another place.
    double size_at(double place) const { return size + std::abs(place - at); }
  };

  explicit FeatureSizes(const FaceNorms& norms);

  /// Places of an edge at which features are known, its ends first; elsewhere they are larger than at a knot
  /// by the way from there.
  void find_knots(Index edge, std::vector<Knot>& knots) const;

 private:
  struct Offer {
    Index halfedge;  ///< of the edge, in the face it came over
    Knot knot;
    /// Of equal sizes, each has its place, whatever the queue.
    bool operator>(const Offer& other) const {
      return std::tie(knot.size, halfedge, knot.at) >
             std::tie(other.knot.size, other.halfedge, other.knot.at);
    }
  };
  struct Link {
    Knot knot;
    Index next;
  };

  std::array<Knot, 2> knots_at_ends(Index edge) const;
  /// Whether a knot would make no difference, or the edge has many, counting its ends and the apexes of its
  /// faces.
  bool is_known(Index edge, const Knot& knot);
  void spread(Index halfedge, const Knot& knot);
  void cross(Index halfedge, const Knot& knot);

  const FaceNorms& norms_;
  std::vector<double> size_at_;  ///< by vertex
  std::vector<Index> first_;     ///< by edge: the first link of what came over other faces
  std::vector<Link> links_;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers_;
  std::vector<Knot> known_;
};

/// Points of an edge as dense as features there are small.
class EdgeDensity {
 public:
  using Knot = FeatureSizes::Knot;

  /// At least the two ends of the edge.
  void set(std::span<const Knot> knots);
  /// The integral of the density.
  double total() const { return until_.back(); }
  /// Up to where a share of the total lies.
  double place(double share) const;

 private:
  std::vector<Knot> knots_;
  std::vector<double> until_;  ///< up to each knot, and between them
};

}  // namespace vorogeo
