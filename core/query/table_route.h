// Routes through the transit table, from the access distances of both ends.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/scans.h"
#include "query/route.h"

namespace vorogeo {

// ---- Access distances: those of one point from the border of its first-layer patch

/// One end of a route and one of its first-layer patches: lower bounds for the groups of border nodes at
/// once, the distances of a group when it is asked for. One object belongs to one thread.
class AccessDistances {
 public:
  explicit AccessDistances(const IndexData& data) : data_(data) {}

  /// Computes bounds for all groups; does nothing if the end is that of the last call. Complexity: O(seeds x
  /// groups), 32 at a time.
  void reset(const RouteEnd& end, Index parent);

  Index parent() const { return parent_; }
  std::span<const GroupRows> groups() const { return data_.access_bounds.groups[parent_]; }
  /// By group: a lower bound of its least distance; after refine(), that distance, or the limit if that is
  /// less.
  std::span<const float> least() const { return least_; }
  /// By group, padded to AccessBounds::width: bounds before refine(), in units of the bounds between borders,
  /// rounded down.
  std::span<const std::int16_t> bounds_to_border() const { return to_border_; }
  /// Prefetches what refine() will read.
  void prefetch(std::size_t group, float limit);
  /// Finds the distances of the rows of a group that are below `limit`, unless that was done before.
  void refine(std::size_t group, float limit);
  /// After refine(): distances of the rows of a group.
  const float* distances(std::size_t group) const { return distance_.data() + groups()[group].row; }
  /// The seed through which the distance of a row leads; the row's group must be refined.
  Index seed_of(std::size_t group, Index row);

 private:
  /// The seeds on the border of one second-layer patch, as lanes.
  struct Part {
    Index patch;
    Index begin;  ///< first lane
    Index rows;
  };
  std::uint8_t in_bounds(float distance) const;
  std::vector<Part>::iterator add_part(Index patch);
  void add_seed(Index lane, double distance, std::size_t place);
  std::span<const Index> lanes_within(std::size_t group, std::uint8_t limit);
  Index lanes_of(const Part& part) const { return (part.rows + byte_lanes - 1) / byte_lanes * byte_lanes; }
  const std::uint8_t* bounds_of(const Part& part, std::size_t group) const {
    return data_.access_bounds.of_patch(part.patch) + group * part.rows;
  }
  const std::uint16_t* piece(Index lane, std::size_t group) const {
    return table_ + column_[lane] * static_cast<std::size_t>(table_rows_) + groups()[group].row;
  }

  const IndexData& data_;
  Index vertex_ = no_index;  ///< of the end
  Index parent_ = no_index;
  TableScale scale_;
  float bound_unit_ = 0.0f;
  const std::uint16_t* table_ = nullptr;  ///< of the first-layer patch
  Index table_rows_ = 0;
  std::vector<Part> parts_;
  // By lane: the distance of its seed, the same as a bound, the seed's column in the table, and its position
  // among the seeds of the end. Lanes without a seed are infinitely far.
  std::vector<float> seed_distance_;
  std::vector<std::uint8_t> seed_bound_;
  std::vector<Index> column_;
  std::vector<Index> place_;
  // By group.
  std::vector<std::uint8_t> least_bound_;
  std::vector<std::int16_t> to_border_;
  std::vector<float> least_;
  std::vector<float> refined_;   ///< limit below which the distances are known
  std::vector<float> distance_;  ///< by row
  std::vector<std::uint8_t> flags_;
  std::vector<Index> lanes_;
};

// ---- Routes between far points, read from the tables

/// Reads routes of an index that has a transit table. One object belongs to one thread.
class TableRouter {
 public:
  explicit TableRouter(const IndexData& data) : data_(data), from_(data), to_(data) {}

  /// Replaces a route by the shortest one that leaves a first-layer patch of the source and enters one of the
  /// target, if that is shorter. For ends in different first-layer patches it is the shortest of all. Lower
  /// bounds for all pairs of groups of border nodes come first; of the tables at the ends and the cells of
  /// the transit table, only those are examined that could give a shorter route than the best so far.
  /// Complexity: O(k + (b / 8)^2) for k seeds and b border nodes of such a patch, and 64 for each cell
  /// examined.
  void route(const RouteEnd& source, const RouteEnd& target, GraphRoute& result);

 private:
  /// The best connection of two ends: group and row on the side of the first-layer patch with the smaller
  /// number, then on the other side.
  struct Joint {
    float length;
    std::size_t group[2] = {0, 0};
    Index row[2] = {no_index, no_index};
  };
  struct Candidate {
    std::int16_t bound;
    std::int16_t group[2];
  };

  Joint join(AccessDistances& low, AccessDistances& high, float length);
  void look_into(AccessDistances& low, AccessDistances& high, const Candidate& candidate, Joint& best);
  void find_rows(const AccessDistances& low, const AccessDistances& high, Joint& best) const;
  std::int16_t in_bounds(float length) const;
  float rest(const AccessDistances& end, std::size_t group, std::int16_t least) const;

  const IndexData& data_;
  AccessDistances from_;
  AccessDistances to_;
  // Least sum of bounds, by group, on either side.
  std::vector<std::int16_t> low_least_;
  std::vector<std::int16_t> high_least_;
  std::vector<std::uint8_t> within_;
  std::vector<Candidate> candidates_;
};

}  // namespace vorogeo
