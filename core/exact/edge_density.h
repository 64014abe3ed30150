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

/// How small the features near each place of an edge are: waves have details of the size of the features they
/// passed, and many narrow faces side by side do not enlarge these. Lengths along an edge are in its cost.
///
/// A feature is a vertex, as large as the distance to its nearest opposite side. Seen from elsewhere, its
/// size grows by the length of the path there: over faces, straight to the nearest point of each next side. A
/// side keeps only features clearly smaller than those known there, so they go far only over needles.
class FeatureSizes {
 public:
  struct Knot {
    double at;
    double size;
    /// The size of the feature as seen from another place of the edge.
    double size_at(double place) const { return size + std::abs(place - at); }
  };

  explicit FeatureSizes(const FaceNorms& norms);

  /// The places of an edge at which sizes of features are known, its ends first. Elsewhere, the size is the
  /// least that a knot has there (Knot::size_at).
  void find_knots(Index edge, std::vector<Knot>& knots) const;

 private:
  struct Offer {
    Index halfedge;  ///< of the edge, in the face over which the feature was seen
    Knot knot;
    /// Breaks ties between equal sizes, so that the order does not depend on the queue.
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
  /// Whether a knot would make no difference, or the edge has enough knots already, counting those of its
  /// ends and of the apexes of its faces.
  bool is_known(Index edge, const Knot& knot);
  void spread(Index halfedge, const Knot& knot);
  void cross(Index halfedge, const Knot& knot);

  const FaceNorms& norms_;
  std::vector<double> size_at_;  ///< by vertex
  std::vector<Index> first_;     ///< by edge: the first link of the knots that came over other faces
  std::vector<Link> links_;
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers_;
  std::vector<Knot> known_;
};

/// The density of points along an edge: the smaller the features there, the denser.
class EdgeDensity {
 public:
  using Knot = FeatureSizes::Knot;

  /// \pre `knots` contains at least the two ends of the edge.
  void set(std::span<const Knot> knots);
  /// The integral of the density.
  double total() const { return until_.back(); }
  /// The place up to which the integral is this share of the total.
  double place(double share) const;

 private:
  std::vector<Knot> knots_;
  std::vector<double> until_;  ///< the integral up to each knot, and up to a place between it and the next
};

}  // namespace vorogeo
